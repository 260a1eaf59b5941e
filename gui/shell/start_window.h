#pragma once

#include <QString>

namespace unprojector::gui {

class MainWindow;
struct StartOptions;

/// Opens the files of the options in a new window and shows it, for a user or for an image.
/// @return the error in a sentence if there is no such lesson
QString startWindow(MainWindow &window, const StartOptions &options);

} // namespace unprojector::gui
