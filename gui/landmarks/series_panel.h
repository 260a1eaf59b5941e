#pragma once

#include "gui/landmarks/scan.h"

#include <QWidget>

#include <cstddef>
#include <memory>

class QLabel;
class QProgressDialog;
class QSpinBox;
class QStackedWidget;
class QToolButton;
class QTreeView;

namespace unprojector::gui {

class ElidedLabel;
class ScanSeries;
class SeriesModel;

/// A series of scans: the landmarks of each, buttons to go from one to the next, and export of a
/// table of all of them.
class SeriesPanel : public QWidget {
    Q_OBJECT
public:
    explicit SeriesPanel(ScanSeries &series, QWidget *parent = nullptr);
    ~SeriesPanel() override;

    /// Asks for the folder of a series.
    /// @return whether another series was opened
    bool chooseFolder();
    /// Shows the error of measurement of all placings, and exports it on request.
    void showRepeats();

    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the user chooses a landmark of a scan.
    void landmarkWanted(std::size_t scan, const unprojector::gui::NamedLandmark &landmark);

private:
    void exportTable();
    /// The name of the series' folder, with an end.
    QString proposedName(const QString &end) const;
    /// Shows the progress of a long export.
    /// @return false to cancel
    bool goesOn(std::size_t done, std::size_t count);
    void refresh();

    ScanSeries &m_series;
    SeriesModel *m_model;
    QTreeView *m_scans;
    ElidedLabel *m_folder;
    QToolButton *m_open;
    QToolButton *m_previous;
    QToolButton *m_next;
    QToolButton *m_export;
    QToolButton *m_repeats;
    QToolButton *m_deviations;
    QStackedWidget *m_pages;
    QSpinBox *m_placing;
    std::unique_ptr<QProgressDialog> m_progress; ///< while a table is exported
};

} // namespace unprojector::gui
