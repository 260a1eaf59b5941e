#include "gui/click/other_programs_view.h"

#include "gui/text/map_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/whole_table.h"

#include <QHeaderView>
#include <QLabel>
#include <QVBoxLayout>

#include <tuple>
#include <vector>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

enum Column { OffBy, Reason, ColumnCount };
constexpr int kReasonRole = Qt::UserRole, kNumbersRole = Qt::UserRole + 1;

} // namespace

OtherProgramsView::OtherProgramsView(QWidget *parent)
    : QWidget(parent), m_table(new WholeTable(static_cast<int>(std::tuple_size_v<OtherAnswers>), ColumnCount)),
      m_reason(new QLabel)
{
    m_table->setAccessibleName(tr("Other programs"));
    m_table->setHorizontalHeaderLabels({tr("Distance"), tr("Because it")});
    m_table->horizontalHeaderItem(OffBy)->setToolTip(tr("Distance from the formula's point; world units"));
    m_table->horizontalHeader()->setStretchLastSection(true);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_reason->setWordWrap(true);
    m_reason->setTextFormat(Qt::PlainText);
    m_reason->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_reason->setAccessibleName(tr("Its point and its reason"));
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_table);
    layout->addWidget(m_reason);
    connect(m_table, &QTableWidget::currentCellChanged, this, [this](int row) { showReason(row); });
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_table, &QTableWidget::customContextMenuRequested, this, &OtherProgramsView::showMenu);
    setAnswers(std::nullopt, std::nullopt, {});
}

void OtherProgramsView::setAnswers(const std::optional<OtherAnswers> &answers, const std::optional<WorldPoint> &formula,
                                   const WorldVector &uncertainty, const QString &notAnswered)
{
    m_plain.clear();
    const bool isThere = answers && formula;
    m_table->setVisible(isThere);
    if (!isThere) {
        m_reason->setText(notAnswered.isEmpty() ? tr("Click a surface to see them.") : notAnswered);
        return;
    }
    int row = 0;
    for (const OtherAnswer &answer : *answers) {
        const QString name = programName(answer.program), reason = programReason(answer.program);
        QString off = tr("not known"), toolTip = tr("The depth that it reads is not known.");
        QList<double> numbers;
        m_plain += name;
        if (answer.point) {
            const double distanceToFormula = distance(*answer.point, *formula);
            off = significantText(distanceToFormula, 3);
            toolTip = tr("It gets %1.").arg(pointText(*answer.point, uncertainty));
            numbers = {answer.point->x, answer.point->y, answer.point->z};
            for (const double number : {distanceToFormula, answer.point->x, answer.point->y, answer.point->z})
                m_plain += QLatin1Char('\t') + shortestText(number);
        }
        m_plain += QLatin1Char('\t') + reason + QLatin1Char('\n');
        m_table->setVerticalHeaderItem(row, new QTableWidgetItem(name));
        m_table->item(row, OffBy)->setText(off);
        m_table->item(row, OffBy)->setToolTip(toolTip);
        m_table->item(row, OffBy)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        m_table->item(row, Reason)->setText(programReasonInShort(answer.program));
        m_table->item(row, Reason)->setToolTip(reason);
        m_table->item(row, Reason)->setData(kReasonRole, QStringLiteral("%1: %2\n%3.").arg(name, toolTip, reason));
        m_table->item(row, Reason)->setData(kNumbersRole, QVariant::fromValue(numbers));
        ++row;
    }
    m_table->fit();
    showReason(m_table->currentRow());
}

void OtherProgramsView::showReason(int row)
{
    const QTableWidgetItem *item = row < 0 ? nullptr : m_table->item(row, Reason);
    m_reason->setText(item ? item->data(kReasonRole).toString() : tr("Select a row to read its point and its reason."));
}

void OtherProgramsView::showMenu(const QPoint &position)
{
    const QTableWidgetItem *item = m_table->itemAt(position);
    if (!item)
        return;
    const QList<double> numbers = m_table->item(item->row(), Reason)->data(kNumbersRole).value<QList<double>>();
    showCopyMenu(*m_table, m_table->viewport()->mapToGlobal(position), {},
                 {QStringLiteral("world"), std::vector<double>(numbers.begin(), numbers.end())});
}

} // namespace unprojector::gui
