#pragma once

#include "core/scene_code/code_scene.h"

#include <string>

namespace unprojector::scene_code {

// One file each: glu_code.cpp and so on.

std::string gluCode(const SceneFile &scene);
std::string glmCode(const SceneFile &scene);
std::string qtCode(const SceneFile &scene);
std::string threeCode(const SceneFile &scene);

} // namespace unprojector::scene_code
