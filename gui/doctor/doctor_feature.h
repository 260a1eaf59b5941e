#pragma once

namespace unprojector::gui {

class Feature;
class Window;

/// The doctor: the mistake by which another program gets a wrong coordinate.
/// @return owned by the window
Feature *makeDoctorFeature(Window &window);

} // namespace unprojector::gui
