#pragma once

#include <QFrame>

class QProgressBar;
class QTimer;

namespace unprojector::gui {

/// The progress of computing the curvature, over the view, with a cancel button. It appears after a
/// moment, so that small models don't flash.
class CurvatureBar : public QFrame {
    Q_OBJECT
public:
    explicit CurvatureBar(QWidget *parent = nullptr);
    void start();
    /// @param share  done, in [0, 1]
    void setProgress(double share);
    void finish();

signals:
    void cancelRequested();

private:
    QProgressBar *m_progress;
    QTimer *m_delay;
};

} // namespace unprojector::gui
