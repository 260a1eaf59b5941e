#pragma once

#include <QWidget>

#include <cstddef>

class QLabel;
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

    /// Asks for the folder of a series.
    /// @return whether another series was opened
    bool chooseFolder();
    /// Asks for a file and exports the repeats of all placings.
    void exportRepeats();

    QSize minimumSizeHint() const override;

signals:
    /// Emitted when the user chooses a landmark of a scan.
    void landmarkWanted(std::size_t scan, const QString &name);

private:
    void exportTable();
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
};

} // namespace unprojector::gui
