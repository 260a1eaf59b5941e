#pragma once

#include "core/scene_code/code_scene.h"

#include <string>

namespace unprojector::scene_code {

// One file each: glu_code.cpp and so on.

std::string gluCode(const CodeScene &scene);
std::string glmCode(const CodeScene &scene);
std::string qtCode(const CodeScene &scene);
std::string threeCode(const CodeScene &scene);

} // namespace unprojector::scene_code
