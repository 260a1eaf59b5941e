#include "gui/landmarks/deviations_view.h"

#include "gui/landmarks/deviations_model.h"
#include "gui/landmarks/scan_series.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/number_delegate.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <chrono>
#include <utility>

namespace unprojector::gui {
using namespace landmarks;

namespace {

constexpr std::chrono::milliseconds kPause(300);

} // namespace

DeviationsView::DeviationsView(ScanSeries &series, QWidget *parent)
    : QWidget(parent), m_series(series), m_model(new DeviationsModel(this)), m_rows(new QTreeView),
      m_summary(new QLabel)
{
    m_rows->setModel(m_model);
    m_rows->setAccessibleName(tr("Landmarks by their distance from where the other scans put them"));
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setTextElideMode(Qt::ElideMiddle);
    m_rows->setItemDelegate(new NumberDelegate(m_rows));
    m_summary->setWordWrap(true);
    m_summary->setTextFormat(Qt::PlainText);
    m_pause.setSingleShot(true);
    m_pause.setInterval(kPause);
    connect(&m_pause, &QTimer::timeout, this, &DeviationsView::compare);
    connect(&m_series, &ScanSeries::changed, this, [this] {
        m_isStale = true;
        if (isVisible())
            m_pause.start();
    });
    connect(m_rows, &QTreeView::clicked, this, &DeviationsView::want);
    connect(m_rows, &QTreeView::activated, this, &DeviationsView::want);
    // In a low panel, summary and list scroll together: the list keeps a few rows.
    constexpr int kFewestLines = 6;
    m_rows->setMinimumHeight(kFewestLines * fontMetrics().lineSpacing());
    auto *page = new QWidget;
    auto *lines = new QVBoxLayout(page);
    lines->setContentsMargins({});
    lines->addWidget(m_summary);
    lines->addWidget(m_rows, 1);
    auto *scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(page);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins({});
    layout->addWidget(scroll);
    const int digit = fontMetrics().horizontalAdvance(u'0');
    m_rows->header()->resizeSection(DeviationsModel::Scan, 20 * digit);
    m_rows->header()->resizeSection(DeviationsModel::Landmark, 24 * digit);
    m_rows->header()->resizeSection(DeviationsModel::Distance, 10 * digit);
    m_rows->header()->resizeSection(DeviationsModel::Spreads, 10 * digit);
}

void DeviationsView::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    m_series.readAgain();
    if (m_isStale)
        m_pause.start();
}

void DeviationsView::want(const QModelIndex &row)
{
    if (!row.isValid())
        return;
    const Deviation &deviation = m_model->at(row.row());
    if (deviation.specimen >= std::min(m_series.scans().size(), m_compared.places.size()))
        return;
    const std::vector<Landmark> &landmarks = m_series.scans()[deviation.specimen].points.landmarks;
    const std::vector<std::size_t> &places = m_compared.places[deviation.specimen];
    const auto place = std::find(places.begin(), places.end(), deviation.landmark);
    if (const auto index = static_cast<std::size_t>(place - places.begin()); index < landmarks.size())
        emit wanted(deviation.specimen, namedLandmark(landmarks, index));
}

void DeviationsView::compare()
{
    if (!m_isStale)
        return;
    m_isStale = false;
    std::vector<const std::vector<Landmark> *> scans;
    for (const Scan &scan : m_series.scans())
        scans.push_back(&scan.points.landmarks);
    SeriesShapes shapes = shapesOf(scans);
    m_background.cancel();
    m_background.start(
        [shapes](Job &job) { return deviationsOf(shapes.scans, shapes.pairs(), [&job] { return job.isCancelled(); }); },
        [this, shapes](const JobResult<Deviations> &found) {
            if (found)
                showResult(*found, shapes);
            else
                m_summary->setText(tr("The scans could not be compared: %1.").arg(failureText(found.error())));
        });
}

void DeviationsView::showResult(Deviations deviations, const SeriesShapes &shapes)
{
    m_summary->setText(summaryOf(deviations, shapes));
    if (m_compared.scans == shapes.scans && m_compared.names == shapes.names
        && m_model->rowCount() == static_cast<int>(deviations.worstFirst.size()))
        return; // another change: the selected row stays
    m_compared = shapes;
    QStringList scans;
    for (const Scan &scan : m_series.scans())
        scans << pathText(scan.file.filename());
    m_model->show(std::move(deviations), shapes.names, scans, shapes.pairs());
}

QString DeviationsView::summaryOf(const Deviations &deviations, const SeriesShapes &shapes) const
{
    const auto namesOf = [this](const std::vector<std::size_t> &scans) {
        QStringList names;
        for (const std::size_t scan : scans) {
            if (scan < m_series.scans().size())
                names << pathText(m_series.scans()[scan].file.filename());
        }
        return names;
    };
    const QStringList notAligned = namesOf(deviations.notAligned), undecided = namesOf(deviations.undecidedSpecimens);
    QStringList tooRare;
    for (const std::size_t landmark : deviations.tooRare)
        tooRare << shapes.names.value(static_cast<qsizetype>(landmark));
    std::vector<std::size_t> compared;
    for (const Deviation &one : deviations.worstFirst)
        compared.push_back(one.specimen);
    std::sort(compared.begin(), compared.end());
    const auto scanCount = std::unique(compared.begin(), compared.end()) - compared.begin();
    const auto off = std::count_if(deviations.worstFirst.begin(), deviations.worstFirst.end(),
                                   [](const Deviation &one) { return one.isOutOfPlace; });
    QStringList sentences;
    if (scanCount == 0)
        sentences << tr("The comparison needs at least %1 scans with the same %2 landmarks.")
                         .arg(kFewestSpecimens)
                         .arg(kFewestToAlign);
    else
        sentences << tr("Compared scans: %1. Landmarks more than %2 spreads off: %3.")
                         .arg(scanCount)
                         .arg(shortestText(kSpreadsOutOfPlace))
                         .arg(off);
    if (!undecided.isEmpty())
        sentences << tr("Left and right seem to be swapped on %1; %2 scans cannot tell for which pairs. Look there.")
                         .arg(undecided.join(QStringLiteral(", ")), QString::number(scanCount));
    if (!notAligned.isEmpty())
        sentences << tr("Not compared, with fewer than %1 landmarks that others have: %2.")
                         .arg(kFewestToAlign)
                         .arg(notAligned.join(QStringLiteral(", ")));
    if (!tooRare.isEmpty() && scanCount > 0)
        sentences << tr("On fewer than %1 scans: %2.").arg(kFewestSpecimens).arg(tooRare.join(QStringLiteral(", ")));
    return joinSentences(sentences);
}

} // namespace unprojector::gui
