#pragma once

#include "gui/document/point_files.h"
#include "gui/document/session.h"

#include <QCoreApplication>

class QWidget;

namespace unprojector::gui {

/// Warns in a message box and waits until it is closed. Names in the text may look like markup: it is shown as it is.
void warn(QWidget &window, const QString &title, const QString &text);

/// Asks the questions of the session and of files of points in message boxes over a window.
class WindowQuestions : public SessionQuestions, public PointFileQuestions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::WindowQuestions)
public:
    explicit WindowQuestions(QWidget &window) : m_window(window) {}

    SaveAnswer askSave(const QString &name, bool hasFile) override;
    std::filesystem::path askFileName(const std::filesystem::path &proposal) override;
    bool askOverwrite(const std::filesystem::path &file) override;
    bool askOverwriteChanged(const std::filesystem::path &file) override;
    bool askDeleteKept(const QString &name) override;
    Join askJoin(const Counts &counts) override;
    Stray askStray(const QString &text) override;
    Order askOrder(const QString &text) override;

private:
    QWidget &m_window;
};

} // namespace unprojector::gui
