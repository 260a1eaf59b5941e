#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace unprojector::scene_file {

struct SceneFile;

/// Unknown keys of a scene file that a window which opens it cannot keep, by their paths: "objects[0].transform[1].comment".
struct LostKeys {
    std::vector<std::string> ofSteps; ///< lost when the scene is saved
    std::vector<std::string>
        ofPlanes; ///< of a plane that does not cut: lost once it cuts, since it is four numbers then
};

/// @param text   of a scene file
/// @param scene  what parseScene has read from it
LostKeys lostKeys(std::string_view text, const SceneFile &scene);

} // namespace unprojector::scene_file
