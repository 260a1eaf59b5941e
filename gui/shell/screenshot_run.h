#pragma once

#include "gui/shell/main_window.h"
#include "gui/shell/start_options.h"

#include <QObject>
#include <QString>

#include <memory>

namespace unprojector::gui {

/// The program without a user: opens what it was given, presses the left button at each position, saves a picture of
/// the whole window, prints the clicks as JSON, and quits.
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
    /// Once the window has settled.
    void pressAndSave();
    /// @return what is wrong, or nothing
    QString savePicture();
    void fail(const QString &reason);

    StartOptions m_options;
    std::unique_ptr<MainWindow> m_window;
    bool m_isSized = false; ///< the view has the size that was asked for
    bool m_hasEnded = false;
};

} // namespace unprojector::gui
