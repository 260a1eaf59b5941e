#include "gui/doctor/candidates_table.h"

#include "core/doctor/report_text.h"
#include "gui/text/doctor_text.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/digits_font.h"

#include <QEvent>
#include <QHeaderView>
#include <QScrollBar>
#include <QSignalBlocker>

namespace unprojector::gui {
using namespace doctor;
namespace {

enum Column { Name, Answer, Digits, Off, ColumnCount };

} // namespace

CandidatesTable::CandidatesTable(QWidget *parent) : QTableWidget(0, ColumnCount, parent)
{
    setHorizontalHeaderLabels({tr("Mistake"), tr("Its answer"), tr("Digits"), tr("Off by")});
    horizontalHeaderItem(Off)->setToolTip(tr("Greatest difference of a coordinate, in units of the last given digit"));
    horizontalHeaderItem(Digits)->setToolTip(tr("Number of given digits that the mistake explains"));
    horizontalHeader()->setSectionResizeMode(Name, QHeaderView::Stretch);
    for (const int column : {Answer, Digits, Off})
        horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
    verticalHeader()->hide();
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setAccessibleName(tr("Candidates"));
    setToolTip(tr("Mistakes that explain the point, the best first. The code to change belongs to the selected one"));
    // The names' column changes with the panel and with the other columns, whose final widths the
    // view knows only after the event.
    const auto fitLater = [this](int column) {
        if (column == Name)
            fitRows();
    };
    connect(horizontalHeader(), &QHeaderView::sectionResized, this, fitLater, Qt::QueuedConnection);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int current) {
        if (current >= 0)
            emit chosen(current);
    });
}

void CandidatesTable::setDiagnosis(const Diagnosis &diagnosis, const WrongPoint &first)
{
    const QSignalBlocker blocker(this);
    const int count = static_cast<int>(diagnosis.candidates.size());
    setRowCount(count);
    for (int row = 0; row < count; ++row) {
        const Candidate &candidate = diagnosis.candidates[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString &text, Qt::Alignment alignment) {
            auto *item = new QTableWidgetItem(text);
            item->setTextAlignment(alignment | Qt::AlignVCenter);
            if (column == Answer)
                item->setFont(digitsFont(font()));
            item->setToolTip(plainToolTip(text));
            setItem(row, column, item);
        };
        put(Name, QString::fromStdString(candidateName(candidate)), Qt::AlignLeft);
        put(Answer, pointText(candidate.point, first.lastDigit), Qt::AlignRight);
        put(Digits, QString::number(candidate.digits), Qt::AlignRight);
        put(Off, significantText(candidate.distance, 3), Qt::AlignRight);
    }
    setCurrentCell(diagnosis.namesMistake() ? 0 : -1, 0);
    fitRows();
}

void CandidatesTable::fitRows()
{
    resizeRowsToContents();
    // Many digits can need more room than a narrow panel has.
    const int bar = horizontalHeader()->length() > viewport()->width() ? horizontalScrollBar()->sizeHint().height() : 0;
    setFixedHeight(verticalHeader()->length() + horizontalHeader()->sizeHint().height() + bar + 2 * frameWidth());
}

void CandidatesTable::changeEvent(QEvent *event)
{
    QTableWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        fitRows();
}

} // namespace unprojector::gui
