#pragma once

#include "gui/shell/main_window.h"
#include "gui/shell/start_options.h"

#include <QObject>
#include <QString>

#include <memory>

namespace unprojector::gui {

/// Runs the program without a user: opens the given files, presses the left button at each
/// position, saves an image of the whole window, prints the clicks as JSON, and quits.
class ScreenshotRun : public QObject {
    Q_OBJECT
public:
    /// @param options  of a screenshot run
    explicit ScreenshotRun(StartOptions options);
    ~ScreenshotRun() override;

    /// Starts; `ended` follows with the exit code: 0, or 2 after a message on stderr.
    void start();

signals:
    void ended(int exitCode);

private:
    /// Called once the window has settled.
    void pressAndSave();
    /// @return the error, or empty
    QString savePicture();
    void fail(const QString &reason);

    StartOptions m_options;
    std::unique_ptr<MainWindow> m_window;
    bool m_isSized = false; ///< the view has the requested size
    bool m_hasEnded = false;
};

} // namespace unprojector::gui
