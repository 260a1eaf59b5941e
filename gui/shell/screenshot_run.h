#pragma once

#include "gui/shell/main_window.h"

#include <QObject>
#include <QSize>
#include <QString>

#include <vector>

namespace unprojector::gui {

/// The program without a user: opens what it was given, presses the left button at each position, saves a picture of
/// the whole window, prints the clicks as JSON, and quits.
class ScreenshotRun : public QObject {
    Q_OBJECT
public:
    struct Request {
        QString picture;                    ///< the file to write; none of `files`
        QSize windowSize{1280, 800};        ///< logical pixels
        std::optional<QSize> viewSize = {}; ///< logical pixels; instead of the window's
        QString place = {};                 ///< id of the work place; empty: the first
        bool hasPanels = true;
        QString lesson = {};                      ///< its name, and its step behind a colon, from 1 on; empty: none
        std::vector<WidgetPoint> clicks;          ///< logical pixels of the view
        std::vector<std::filesystem::path> files; ///< none: the bundled scene
        std::optional<bool> smoothEdges = {};     ///< nothing: smooth
    };
    explicit ScreenshotRun(Request request);
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

    Request m_request;
    std::unique_ptr<MainWindow> m_window;
    bool m_isSized = false; ///< the view has the size that was asked for
    bool m_hasEnded = false;
};

} // namespace unprojector::gui
