#include "core/scene_code/scene_code.h"

#include "core/scene_code/dialects.h"

namespace unprojector::scene_code {
using namespace scene_file;

std::string sceneCode(const SceneFile &scene, CodeDialect dialect)
{
    switch (dialect) {
    case CodeDialect::Glu: return gluCode(scene);
    case CodeDialect::Glm: return glmCode(scene);
    case CodeDialect::Qt: return qtCode(scene);
    case CodeDialect::ThreeJs: return threeCode(scene);
    case CodeDialect::NumPy: return numpyCode(scene);
    }
    return {};
}

} // namespace unprojector::scene_code
