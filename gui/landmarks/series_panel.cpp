#include "gui/landmarks/series_panel.h"

#include "core/landmark_files/repeats_table.h"
#include "gui/landmarks/deviations_view.h"
#include "gui/landmarks/repeats_dialog.h"
#include "gui/landmarks/scan_series.h"
#include "gui/landmarks/series_model.h"
#include "gui/text/error_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/elided_label.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/save_name.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressDialog>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QStackedWidget>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>

#include <array>
#include <utility>

namespace unprojector::gui {

SeriesPanel::SeriesPanel(ScanSeries &series, QWidget *parent)
    : QWidget(parent), m_series(series), m_model(new SeriesModel(series, this)), m_scans(new QTreeView),
      m_folder(new ElidedLabel), m_open(new QToolButton), m_previous(new QToolButton), m_next(new QToolButton),
      m_export(new QToolButton), m_repeats(new QToolButton), m_deviations(new QToolButton), m_pages(new QStackedWidget),
      m_placing(new QSpinBox)
{
    m_scans->setModel(m_model);
    m_scans->setAccessibleName(tr("Scans of the series"));
    m_scans->setRootIsDecorated(false);
    m_scans->setUniformRowHeights(true);
    m_scans->setTextElideMode(Qt::ElideMiddle);
    m_scans->header()->setStretchLastSection(false);
    connect(m_scans, &QTreeView::activated, this, [this](const QModelIndex &index) {
        if (index.isValid())
            m_series.show(static_cast<std::size_t>(index.row()));
    });
    const auto set = [](QToolButton *button, const QString &text, const QString &tip) {
        button->setText(text);
        button->setToolTip(tip);
        button->setFocusPolicy(Qt::StrongFocus);
    };
    set(m_open, tr("Folder…"), tr("Open a folder of scans and place the same landmarks on each"));
    set(m_previous, tr("Previous"), tr("Keep the landmarks and show the previous scan (Ctrl+PgUp)"));
    set(m_next, tr("Next"), tr("Keep the landmarks and show the next scan (Ctrl+PgDown)"));
    set(m_export, tr("Export…"), tr("Write the landmarks of all scans to one table"));
    set(m_repeats, tr("Repeats…"),
        tr("Show how well each landmark is repeated: its error of measurement over all placings"));
    set(m_deviations, tr("Out of Place"),
        tr("Show how far each landmark is from where the other scans put it, the worst first"));
    m_deviations->setCheckable(true);
    auto *deviations = new DeviationsView(m_series);
    m_pages->addWidget(m_scans);
    m_pages->addWidget(deviations);
    connect(m_deviations, &QToolButton::toggled, m_pages, &QStackedWidget::setCurrentIndex);
    connect(deviations, &DeviationsView::wanted, this, &SeriesPanel::landmarkWanted);
    connect(m_repeats, &QToolButton::clicked, this, &SeriesPanel::showRepeats);
    connect(m_open, &QToolButton::clicked, this, &SeriesPanel::chooseFolder);
    connect(m_previous, &QToolButton::clicked, &m_series, &ScanSeries::previous);
    connect(m_next, &QToolButton::clicked, &m_series, &ScanSeries::next);
    connect(m_export, &QToolButton::clicked, this, &SeriesPanel::exportTable);
    m_placing->setRange(1, kMostPlacings);
    m_placing->setKeyboardTracking(false); // typing 12 must not switch to 1
    m_placing->setAccessibleName(tr("Placing"));
    m_placing->setToolTip(tr("Number of the pass through the series, or of the observer. Each placing has its own "
                             "landmarks; Repeats shows their scatter"));
    connect(m_placing, &QSpinBox::valueChanged, &m_series, &ScanSeries::setPlacing);
    connect(&m_series, &ScanSeries::changed, this, &SeriesPanel::refresh);

    auto *first = new QHBoxLayout;
    first->addWidget(m_open);
    first->addWidget(m_folder, 1);
    auto *placing = new QLabel(tr("Placing:"));
    placing->setBuddy(m_placing);
    first->addWidget(placing);
    first->addWidget(m_placing);
    auto *buttons = new QHBoxLayout;
    for (QToolButton *button : {m_previous, m_next, m_export, m_repeats, m_deviations})
        buttons->addWidget(button);
    buttons->addStretch();
    auto *layout = new QVBoxLayout(this);
    layout->addLayout(first);
    layout->addWidget(m_pages, 1);
    layout->addLayout(buttons);
    const int digit = fontMetrics().horizontalAdvance(u'0');
    m_scans->header()->resizeSection(SeriesModel::Scan, 20 * digit);
    m_scans->header()->setSectionResizeMode(SeriesModel::Placed, QHeaderView::ResizeToContents);
    m_series.setWaiting([this](std::size_t done, std::size_t count) { return goesOn(done, count); });
    refresh();
}

SeriesPanel::~SeriesPanel()
{
    m_series.setWaiting({});
}

QSize SeriesPanel::minimumSizeHint() const
{
    constexpr int kDigits = 24, kLines = 8;
    return {kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing()};
}

void SeriesPanel::refresh()
{
    const bool isOpen = m_series.isOpen();
    m_folder->setFullText(isOpen ? pathText(m_series.folder()) : tr("No series is open"));
    const std::optional<std::size_t> current = m_series.current();
    m_previous->setEnabled(m_series.hasPrevious());
    m_next->setEnabled(m_series.hasNext());
    m_export->setEnabled(isOpen);
    m_repeats->setEnabled(isOpen);
    m_deviations->setEnabled(isOpen);
    if (!isOpen)
        m_deviations->setChecked(false);
    m_placing->setEnabled(isOpen);
    const QSignalBlocker blocker(m_placing);
    m_placing->setValue(m_series.placing());
    if (current) {
        const QModelIndex row = m_model->index(static_cast<int>(*current), SeriesModel::Scan);
        m_scans->setCurrentIndex(row);
        m_scans->scrollTo(row);
    }
}

bool SeriesPanel::chooseFolder()
{
    const std::filesystem::path folder = askFolder(*this, FileKind::Series, tr("Open a Series of Scans"));
    return !folder.empty() && m_series.open(folder);
}

QString SeriesPanel::proposedName(const QString &end) const
{
    const std::filesystem::path &folder = m_series.folder();
    return pathText(folder.has_filename() ? folder.filename() : folder.parent_path().filename()) + end; // "scans/"
}

void SeriesPanel::exportTable()
{
    using Table = ScanSeries::Table;
    const std::array<std::pair<Table, QString>, 4> kinds{
        {{Table::Wide, tr("One row per scan (%1)").arg(QStringLiteral("*.csv"))},
         {Table::Long, tr("One row per landmark (%1)").arg(QStringLiteral("*.csv"))},
         {Table::Tps, tr("TPS of geomorph and tpsDig (%1)").arg(QStringLiteral("*.tps"))},
         {Table::Nts, tr("NTSYS (%1)").arg(QStringLiteral("*.nts"))}}};
    QStringList filters;
    for (const auto &[table, filter] : kinds)
        filters << filter;
    const SaveName named =
        askSaveName(*this, tr("Export Landmarks of All Scans"), filters, proposedName(QStringLiteral(".csv")));
    if (!named.file.empty())
        m_series.exportTable(named.file, kinds[static_cast<std::size_t>(named.filter)].first);
    m_progress.reset();
}

bool SeriesPanel::goesOn(std::size_t done, std::size_t count)
{
    if (!m_progress) {
        m_progress = std::make_unique<QProgressDialog>(tr("Measuring along the surfaces…"), tr("Cancel"), 0,
                                                       static_cast<int>(count), this);
        m_progress->setWindowTitle(tr("Export"));
        m_progress->setWindowModality(Qt::ApplicationModal);
        m_progress->setAutoReset(false);
    }
    m_progress->setValue(static_cast<int>(done)); // processes events
    return !m_progress->wasCanceled();
}

void SeriesPanel::showRepeats()
{
    const std::optional<SeriesRepeats> repeats = m_series.repeats();
    if (!repeats)
        return;
    const landmarks::MeasurementError error = landmark_files::measurementErrorOf(repeats->specimens);
    QStringList remarks{repeats->summary};
    for (const std::string &remark : landmark_files::errorRemarks(error))
        remarks << sentence(remark);
    remarks << repeats->problems;
    QString unit;
    for (const auto &specimen : repeats->specimens) {
        for (const landmarks::LandmarkSet &placing : specimen.placings) {
            if (unit.isEmpty())
                unit = QString::fromStdString(placing.unit);
        }
    }
    auto *dialog = new RepeatsDialog(error, unit, remarks, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    const auto save = [this](ScanSeries::Table table, const QString &title) {
        const QString proposed = proposedName(table == ScanSeries::Table::Errors ? QStringLiteral("-errors.csv")
                                                                                 : QStringLiteral("-repeats.csv"));
        const SaveName named = askSaveName(*this, title, {tr("Table (%1)").arg(QStringLiteral("*.csv"))}, proposed);
        if (!named.file.empty())
            m_series.exportTable(named.file, table);
    };
    connect(dialog, &RepeatsDialog::errorsRequested, this,
            [save] { save(ScanSeries::Table::Errors, tr("Repeats: Error of Each Landmark")); });
    connect(dialog, &RepeatsDialog::meansRequested, this,
            [save] { save(ScanSeries::Table::Repeats, tr("Repeats: Mean and Error of All Placings")); });
    dialog->open();
}

} // namespace unprojector::gui
