#pragma once

#include "core/scene_code/code_scene.h"

#include <string>

namespace unprojector::scene_code {

// One file each: glu_code.cpp and so on.

std::string gluCode(const scene_file::SceneFile &scene);
std::string glmCode(const scene_file::SceneFile &scene);
std::string qtCode(const scene_file::SceneFile &scene);
std::string threeCode(const scene_file::SceneFile &scene);
std::string numpyCode(const scene_file::SceneFile &scene);

} // namespace unprojector::scene_code
