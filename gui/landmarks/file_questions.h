#pragma once

#include "gui/document/landmark_files.h"

#include <QCoreApplication>

class QWidget;

namespace unprojector::gui {

/// Asks the questions about landmark files in message boxes over a window.
class FileQuestions : public LandmarkFileQuestions {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::FileQuestions)
public:
    explicit FileQuestions(QWidget &window) : m_window(window) {}

    Join askJoin(const Counts &counts) override;
    Stray askStray(const QString &text) override;
    Order askOrder(const QString &text) override;

private:
    QWidget &m_window;
};

} // namespace unprojector::gui
