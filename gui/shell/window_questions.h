#pragma once

#include "gui/document/session.h"

#include <QCoreApplication>

class QWidget;

namespace unprojector::gui {

/// Shows a warning in a message box and waits until it is closed. Names in the text may look like
/// markup: the text is shown literally.
void warn(QWidget &window, const QString &title, const QString &text);

/// Asks the questions of the session in message boxes over a window.
class WindowQuestions : public SessionQuestions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::WindowQuestions)
public:
    explicit WindowQuestions(QWidget &window) : m_window(window) {}

    SaveAnswer askSave(const QString &name, bool hasFile) override;
    std::filesystem::path askFileName(const std::filesystem::path &proposal) override;
    bool askOverwrite(const std::filesystem::path &file) override;
    bool askOverwriteChanged(const std::filesystem::path &file) override;
    FewerAnswer askFewerLandmarks(const std::filesystem::path &file, int saved, int now) override;
    bool askDeleteKept(const QString &lost) override;

private:
    QWidget &m_window;
};

} // namespace unprojector::gui
