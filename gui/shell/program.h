#pragma once

#include "core/base/standard_streams.h"
#include "gui/shell/start_options.h"

#include <QApplication>

#include <optional>

namespace unprojector::gui {

/// The program from its command line to its exit code: a window for a user, or a screenshot run.
class Program {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::Program)
public:
    Program(int &argc, char **argv) : m_argc(argc), m_argv(argv) {}
    /// @return the exit code; 2 after a message on standard error, or in a box
    int run();

private:
    /// Reads the options before there is a window: --help and errors need no display.
    /// @return the exit code if the program ends now
    std::optional<int> readOptions();
    /// Creates the application, in its language and fonts; ends the program with a message if no
    /// window can be opened.
    void createApplication();
    int runForUser();
    int runForPicture();

    int &m_argc;
    char **m_argv;
    std::optional<base::ParentConsole> m_console{std::in_place};
    StartOptions m_options;
    QString m_noWindow; ///< sentence with %1 for Qt's reason
    std::optional<QApplication> m_application;
    std::optional<Translation> m_translation;
};

} // namespace unprojector::gui
