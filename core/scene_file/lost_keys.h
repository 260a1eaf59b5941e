#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unprojector::scene_file {

struct SceneFile;

/// Unknown keys of a scene file that are lost in a window that opens it, by path:
/// "objects[0].transform[1].comment".
struct LostKeys {
    std::vector<std::string> ofSteps; ///< lost when the scene is saved
    std::vector<std::string>
        ofPlanes; ///< of planes that don't cut: lost once the plane cuts, since it is then only four numbers
};

/// @param text   of a scene file
/// @param scene  the result of parseScene for it
LostKeys lostKeys(std::string_view text, const SceneFile &scene);

} // namespace unprojector::scene_file
