#pragma once

#include "core/landmarks/out_of_place.h"
#include "gui/document/background.h"
#include "gui/landmarks/scan.h"
#include "gui/landmarks/series_shapes.h"

#include <QTimer>
#include <QWidget>

#include <cstddef>

class QLabel;
class QModelIndex;
class QTreeView;

namespace unprojector::gui {

class DeviationsModel;
class ScanSeries;

/// The list of a series' landmarks by their distance from where the other scans put them. It compares
/// in the background, while it is visible, a moment after the last change.
class DeviationsView : public QWidget {
    Q_OBJECT
public:
    explicit DeviationsView(ScanSeries &series, QWidget *parent = nullptr);

signals:
    /// Emitted when a row is clicked.
    void wanted(std::size_t scan, const unprojector::gui::NamedLandmark &landmark);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void want(const QModelIndex &row);
    void compare();
    void showResult(landmarks::Deviations deviations, const SeriesShapes &shapes);
    QString summaryOf(const landmarks::Deviations &deviations, const SeriesShapes &shapes) const;

    ScanSeries &m_series;
    DeviationsModel *m_model;
    QTreeView *m_rows;
    QLabel *m_summary;
    QTimer m_pause;
    bool m_isStale = true;
    SeriesShapes m_compared; ///< that the rows belong to
    Background m_background; ///< the last member: its jobs use the others
};

} // namespace unprojector::gui
