#include "gui/landmarks/repeats_dialog.h"

#include "gui/text/number_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/number_delegate.h"

#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>

namespace unprojector::gui {
namespace {

enum Column { Name, Scans, Placings, Error, Icc1, Icc2, FirstOfPlacings };
constexpr int kPerPlacing = 2; // error and bias
constexpr int kDigits = 4;

/// A row that sorts numbers by value; the row of all landmarks stays in front.
class Row : public QTreeWidgetItem {
public:
    using QTreeWidgetItem::QTreeWidgetItem;

    void setNumber(int column, const std::optional<double> &number)
    {
        setText(column, number ? writtenText(*number, kDigits) : QStringLiteral("–"));
        QStringList texts;
        for (int digits = kDigits; number && digits > 0; --digits)
            texts << writtenText(*number, digits);
        setData(column, NumberDelegate::kTextsRole, texts);
        setData(column, Qt::UserRole, number ? QVariant(*number) : QVariant());
        setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        if (number)
            setToolTip(column, shortestText(*number));
    }
    bool operator<(const QTreeWidgetItem &other) const override
    {
        const QTreeWidget *tree = treeWidget();
        const int column = tree ? tree->sortColumn() : 0;
        const bool isDescending = tree && tree->header()->sortIndicatorOrder() == Qt::DescendingOrder;
        const bool isAll = data(Name, Qt::UserRole).toBool(), isOtherAll = other.data(Name, Qt::UserRole).toBool();
        if (isAll != isOtherAll)
            return isAll != isDescending;
        const QVariant a = data(column, Qt::UserRole), b = other.data(column, Qt::UserRole);
        if (column == Name)
            return text(Name).localeAwareCompare(other.text(Name)) < 0;
        if (a.isValid() != b.isValid()) // landmarks without a number come last
            return a.isValid() != isDescending;
        return a.toDouble() < b.toDouble();
    }
};

void fill(Row &row, const landmarks::LandmarkError &error)
{
    row.setNumber(Scans, static_cast<double>(error.specimens));
    row.setNumber(Placings, static_cast<double>(error.placings));
    row.setNumber(Error, error.error);
    row.setNumber(Icc1, error.icc1);
    row.setNumber(Icc2, error.icc2);
    int column = FirstOfPlacings;
    for (const landmarks::PlacingError &placing : error.byPlacing) {
        row.setNumber(column++, placing.error);
        row.setNumber(column++, placing.bias);
    }
}

} // namespace

RepeatsDialog::RepeatsDialog(const landmarks::MeasurementError &error, const QString &unit, const QStringList &remarks,
                             QWidget *parent)
    : QDialog(parent), m_table(new QTreeWidget)
{
    setWindowTitle(tr("Repeats: Error of Measurement"));
    const auto withUnit = [&unit](const QString &text) {
        return unit.isEmpty() ? text : QStringLiteral("%1 [%2]").arg(text, unit);
    };
    QStringList titles{tr("Landmark"),          tr("Scans"),  tr("Placings"),
                       withUnit(tr("Error ±")), tr("ICC(1)"), tr("ICC(2,1)")};
    for (const int placing : error.placings)
        titles << withUnit(tr("Error of %1").arg(placing)) << withUnit(tr("Bias of %1").arg(placing));
    m_table->setHeaderLabels(titles);
    m_table->setRootIsDecorated(false);
    m_table->setUniformRowHeights(true);
    m_table->setAlternatingRowColors(true);
    m_table->setAccessibleName(tr("Error of measurement of each landmark"));
    m_table->setItemDelegate(new NumberDelegate(m_table));
    QTreeWidgetItem *header = m_table->headerItem();
    header->setToolTip(Scans, tr("Scans on which the landmark was placed more than once"));
    header->setToolTip(Placings, tr("All placings on these scans"));
    header->setToolTip(Error, tr("Standard deviation of one placing, pooled over the scans: the technical error of "
                                 "measurement; for two placings Dahlberg's error"));
    header->setToolTip(Icc1, tr("Intraclass correlation of one placing: the share of the variance that is between "
                                "scans, after Procrustes superimposition"));
    header->setToolTip(Icc2, tr("The same for scans with all placings, each by another observer; the observers' "
                                "differences count as error"));
    for (int column = FirstOfPlacings; column < titles.size(); column += kPerPlacing) {
        header->setToolTip(column, tr("Standard deviation of this placing; of two placings, both have the same"));
        header->setToolTip(column + 1, tr("Distance of this placing's mean from the mean of all placings"));
    }
    auto *all = new Row(m_table, QStringList{tr("All landmarks")});
    all->setData(Name, Qt::UserRole, true);
    fill(*all, error.all);
    QFont bold = all->font(Name);
    bold.setBold(true);
    for (int column = 0; column < titles.size(); ++column)
        all->setFont(column, bold);
    for (const landmarks::LandmarkError &landmark : error.landmarks)
        fill(*new Row(m_table, QStringList{QString::fromStdString(landmark.name)}), landmark);
    m_table->header()->setSortIndicator(-1, Qt::AscendingOrder); // the list's order
    m_table->setSortingEnabled(true);
    for (int column = 0; column < titles.size(); ++column)
        m_table->resizeColumnToContents(column);

    auto *text = new QLabel(remarks.join(u'\n'));
    text->setWordWrap(true);
    text->setTextFormat(Qt::PlainText);
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QPushButton *copy = buttons->addButton(tr("&Copy"), QDialogButtonBox::ActionRole);
    QPushButton *errors = buttons->addButton(tr("&Export…"), QDialogButtonBox::ActionRole);
    QPushButton *means = buttons->addButton(tr("Export &Means…"), QDialogButtonBox::ActionRole);
    copy->setToolTip(tr("Copy the table to the clipboard"));
    errors->setToolTip(tr("Write this table to a file, with all digits"));
    means->setToolTip(tr("Write the mean and the scatter of each landmark on each scan to a file"));
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(errors, &QPushButton::clicked, this, &RepeatsDialog::errorsRequested);
    connect(means, &QPushButton::clicked, this, &RepeatsDialog::meansRequested);
    connect(copy, &QPushButton::clicked, this, [this, titles] {
        QStringList lines{titles.join(u'\t')};
        for (int row = 0; row < m_table->topLevelItemCount(); ++row) {
            const QTreeWidgetItem &item = *m_table->topLevelItem(row);
            QStringList cells{item.text(Name)};
            for (int column = Scans; column < titles.size(); ++column) {
                const QVariant number = item.data(column, Qt::UserRole);
                cells << (number.isValid() ? shortestText(number.toDouble()) : QStringLiteral("NA"));
            }
            lines << cells.join(u'\t');
        }
        copyToClipboard(lines.join(u'\n'));
    });
    auto *layout = new QVBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(m_table, 1);
    layout->addWidget(buttons);
    const int digit = fontMetrics().horizontalAdvance(u'0');
    constexpr int kWidth = 100, kLines = 26;
    resize(kWidth * digit, kLines * fontMetrics().lineSpacing());
}

} // namespace unprojector::gui
