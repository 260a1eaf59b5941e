#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The doctor: finds the mistake behind a wrong coordinate of another program.
/// @return owned by the window
Feature *makeDoctorFeature(Window &window);

} // namespace unprojector::gui
