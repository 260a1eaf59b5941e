#include "gui/click/then_and_now_view.h"

#include "gui/click/then_and_now.h"
#include "gui/text/number_text.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/whole_table.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

namespace unprojector::gui {

namespace {

enum Column { Then, Now, ColumnCount };

QString wordsOf(const SceneDocument &document)
{
    QStringList words = setupChanges(document);
    if (const QString place = placeNowText(document); !place.isEmpty())
        words.prepend(place);
    return words.join(u'\n');
}

} // namespace

ThenAndNowView::ThenAndNowView(const SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_table(new WholeTable(0, ColumnCount)), m_changes(new QLabel)
{
    m_table->setAccessibleName(tr("The picked point at the click and now"));
    m_table->setToolTip(tr("Where a coordinate differs, its row is bold and has a “≠” behind its name"));
    m_table->setHorizontalHeaderLabels({tr("At the click"), tr("Now")});
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->verticalHeader()->setMinimumSectionSize(1);
    m_changes->setAccessibleName(tr("Changes of the setup since the click"));
    m_changes->setTextFormat(Qt::PlainText);
    m_changes->setWordWrap(true);
    m_changes->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_table);
    layout->addWidget(m_changes);
}

void ThenAndNowView::refresh()
{
    if (!isVisible())
        return;
    const std::vector<ThenAndNow> rows = thenAndNow(m_document);
    m_table->setRowCount(static_cast<int>(rows.size()));
    for (int index = 0; index < m_table->rowCount(); ++index) {
        const ThenAndNow &row = rows[static_cast<std::size_t>(index)];
        QFont font = digitsFont(this->font());
        font.setBold(row.differs);
        const auto show = [&](int column, const QString &text) {
            if (!m_table->item(index, column))
                m_table->setItem(index, column, new QTableWidgetItem);
            QTableWidgetItem &item = *m_table->item(index, column);
            item.setText(text);
            item.setFont(font);
        };
        show(Then, row.then);
        show(Now, row.now);
        m_table->setVerticalHeaderItem(
            index, new QTableWidgetItem(row.differs ? QStringLiteral("%1 ≠").arg(row.name) : row.name));
    }
    m_table->setVisible(!rows.empty());
    m_table->fit();
    const QString words = wordsOf(m_document);
    m_changes->setText(words);
    m_changes->setVisible(!words.isEmpty());
}

QString ThenAndNowView::text() const
{
    QString text;
    for (const ThenAndNow &row : thenAndNow(m_document))
        text += QStringLiteral("%1\t%2\t%3\n")
                    .arg(row.name, shortestText(row.exactThen), row.exactNow ? shortestText(*row.exactNow) : row.now);
    if (!text.isEmpty())
        text.prepend(QStringLiteral("\t%1\t%2\n").arg(tr("At the click"), tr("Now")));
    const QString words = wordsOf(m_document);
    return words.isEmpty() ? text : text + words + u'\n';
}

void ThenAndNowView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
}

} // namespace unprojector::gui
