#pragma once

#include <string>
#include <string_view>

namespace unprojector::cameras {

/// The text of a program with its constants' values where it computes with them, and with names before the arguments
/// of known calls: "f = 500; K = [[f, 0, W/2], …" has "[[500, 0, 320], …", and "set_intrinsics(640, 480, …" has
/// "set_intrinsics(width=640, height=480, …", and "camera->SetPosition(1, 2, 3)" is "camera->Position=(1, 2, 3)". A
/// constant is a name that the text sets once, to a number. Lines stay where they are; a text without constants and
/// such calls is unchanged.
std::string withValues(std::string text);

} // namespace unprojector::cameras
