#pragma once

#include <QString>

namespace unprojector::gui {

class MainWindow;
struct StartOptions;

/// Opens what the options say in a new window and shows it, for a user or for a picture.
/// @return the mistake in a sentence where there is no such lesson
QString startWindow(MainWindow &window, const StartOptions &options);

} // namespace unprojector::gui
