#include "core/cli/matrices_command.h"

#include "core/cli/byte_stream.h"
#include "core/cli/scene_input.h"
#include "core/text/error_text.h"
#include "core/text/identifier.h"

#include <cmath>
#include <vector>

namespace unprojector::cli {
using namespace text;
namespace {

struct NamedMatrix {
    std::string name; ///< an identifier of C and Python
    std::string what;
    glm::dmat4 matrix;
};

glm::dmat4 windowMatrix(const Picture &g)
{
    glm::dmat4 m = windowFromNdc(g.viewport, g.depthRange);
    if (ndcDepthOf(g) == NdcDepth::ZeroToOne) {
        m[2][2] = g.depthRange.atFar - g.depthRange.atNear;
        m[3][2] = g.depthRange.atNear;
    }
    return m;
}

std::vector<NamedMatrix> matricesOf(const SceneInput &scene, const glm::dmat4 &view, const glm::dmat4 &projection)
{
    const glm::dmat4 viewport = windowMatrix(scene.geometry);
    std::vector<NamedMatrix> matrices{
        {"view", "eye from world", view},
        {"projection", "clip from eye", projection},
        {"viewport", "window from NDC", viewport},
        {"view_projection", "clip from world", projection * view},
        {"world_to_window", "window from world, before the division by w", viewport * projection * view},
    };
    std::vector<std::string> taken;
    for (const PlacedObject &object : scene.objects) {
        const std::string name = newIdentifier(object.name, taken);
        const glm::dmat4 modelview = view * object.worldFromObject;
        const std::string of = " of \"" + onOneLine(object.name) + '"';
        matrices.push_back({"model_" + name, "world from object" + of, object.worldFromObject});
        matrices.push_back({"modelview_" + name, "eye from object" + of, modelview});
        matrices.push_back({"mvp_" + name, "clip from object" + of, projection * modelview});
        matrices.push_back({"mvpw_" + name, "window from object" + of + ", before the division by w",
                            viewport * projection * modelview});
    }
    return matrices;
}

std::string json(const std::vector<NamedMatrix> &matrices, MatrixLayout layout)
{
    std::string text = "{\n  \"layout\": ";
    text += layout == MatrixLayout::Column ? "\"column\"" : "\"row\"";
    for (const NamedMatrix &m : matrices) {
        text += ",\n  \"" + m.name + "\": [";
        for (int row = 0; row < 4; ++row) {
            text += row == 0 ? "[" : ", [";
            for (int column = 0; column < 4; ++column) {
                if (column > 0)
                    text += ", ";
                text += numberText(entryAt(m.matrix, layout, row, column), Digits::Double);
            }
            text += ']';
        }
        text += ']';
    }
    return text + "\n}\n";
}

std::string written(const std::vector<NamedMatrix> &matrices, const MatricesOptions &options)
{
    MatrixFormat format{MatrixSyntax::Text, options.layout, Digits::Double};
    std::string comment = "# ";
    switch (options.format) {
    case MatricesFormat::Json: return json(matrices, options.layout);
    case MatricesFormat::Text: break;
    case MatricesFormat::C:
        format.syntax = MatrixSyntax::CArray;
        comment = "// ";
        break;
    case MatricesFormat::NumPy: format.syntax = MatrixSyntax::NumPy; break;
    case MatricesFormat::Latex:
        format.syntax = MatrixSyntax::Latex;
        comment = "% ";
        break;
    }
    std::string text = options.format == MatricesFormat::NumPy ? "import numpy as np\n\n" : "";
    for (const NamedMatrix &m : matrices) {
        const bool isNameShown = format.syntax == MatrixSyntax::Text;
        text += comment + (isNameShown ? m.name + ": " : "") + m.what + '\n';
        text += formatted(m.matrix, format, m.name) + '\n';
    }
    text.pop_back();
    return text;
}

} // namespace

ExitCode runMatrices(const MatricesOptions &options)
{
    const std::optional<SceneInput> scene = sceneInput(options.scene);
    if (!scene)
        return ExitCode::UnusableInput;
    const Result<glm::dmat4> view = eyeFromWorld(scene->geometry), projection = clipFromEye(scene->geometry);
    for (const auto *matrix : {&view, &projection}) {
        if (!*matrix) {
            complain(options.scene + ": " + errorText(matrix->error()));
            return ExitCode::UnusableInput;
        }
    }
    const std::vector<NamedMatrix> matrices = matricesOf(*scene, *view, *projection);
    for (const NamedMatrix &m : matrices) {
        for (const double entry : memoryOrder(m.matrix)) {
            if (!std::isfinite(entry)) {
                complain(options.scene + ": " + m.name + ": its numbers leave the range of double precision");
                return ExitCode::UnusableInput;
            }
        }
    }
    ByteSink sink;
    sink.write(written(matrices, options));
    return sink.finish();
}

} // namespace unprojector::cli
