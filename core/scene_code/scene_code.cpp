#include "core/scene_code/scene_code.h"

#include "core/scene_code/dialects.h"

namespace unprojector::scene_code {

std::string sceneCode(const SceneFile &scene, CodeDialect dialect)
{
    const CodeScene code = codeScene(scene);
    switch (dialect) {
    case CodeDialect::Glu: return gluCode(code);
    case CodeDialect::Glm: return glmCode(code);
    case CodeDialect::Qt: return qtCode(code);
    case CodeDialect::ThreeJs: return threeCode(code);
    }
    return {};
}

const char *fileSuffix(CodeDialect dialect)
{
    return dialect == CodeDialect::ThreeJs ? ".js" : ".cpp";
}

} // namespace unprojector::scene_code
