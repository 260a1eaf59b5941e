#include "core/base/identifier.h"
#include "core/base/translation.h"
#include "core/cli/commands/command.h"
#include "core/cli/rows/scene_input.h"
#include "core/cli/terminal/refusal.h"
#include "core/geometry/api_conventions.h"
#include "core/pipeline/matrix_format.h"

#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace pipeline;
using namespace scene_file;
using namespace base;
namespace {

enum class MatricesFormat { Text, Json, C, NumPy, Latex };

struct MatricesOptions {
    std::string scene;
    std::optional<Api> conventions;     ///< empty: the scene's
    std::optional<MatrixLayout> layout; ///< empty: the conventions' own
    MatricesFormat format = MatricesFormat::Text;
};

struct NamedMatrix {
    std::string name; ///< an identifier of C and Python
    std::string what;
    glm::dmat4 matrix;
};

glm::dmat4 windowMatrix(const Setup &g)
{
    glm::dmat4 m = windowFromNdc(g.viewport, g.depthRange);
    if (ndcDepthOf(g) == NdcDepth::ZeroToOne) {
        m[2][2] = g.depthRange.atFar - g.depthRange.atNear;
        m[3][2] = g.depthRange.atNear;
    }
    return m;
}

/// The content to write, in an API's conventions.
struct Written {
    const ApiConventions *api;
    MatrixLayout layout;
    ApiCamera camera;
    glm::dmat4 apiFromWorld{1.0}; ///< from the scene's world to the API's
    bool hasClip = true;
};

std::vector<NamedMatrix> matricesOf(const SceneFile &scene, const Written &written)
{
    const glm::dmat4 &view = written.camera.eyeFromWorld, &projection = written.camera.clipFromEye,
                     &viewport = written.camera.windowFromNdc;
    std::vector<NamedMatrix> matrices{{"view", "eye from world", view}};
    if (written.hasClip) {
        matrices.push_back({"projection", "clip from eye", projection});
        matrices.push_back({"viewport", "window from NDC", viewport});
        matrices.push_back({"view_projection", "clip from world", projection * view});
        matrices.push_back(
            {"world_to_window", "window from world, before the division by w", viewport * projection * view});
    }
    DistinctIdentifiers names;
    for (const SceneFileObject &object : scene.objects) {
        const std::string name = names.next(object.name);
        const glm::dmat4 model = written.apiFromWorld * worldFromObject(object.transform), modelview = view * model;
        const std::string of = " of \"" + onOneLine(object.name) + '"';
        matrices.push_back({"model_" + name, "world from object" + of, model});
        matrices.push_back({"modelview_" + name, "eye from object" + of, modelview});
        if (!written.hasClip)
            continue;
        matrices.push_back({"mvp_" + name, "clip from object" + of, projection * modelview});
        matrices.push_back({"mvpw_" + name, "window from object" + of + ", before the division by w",
                            viewport * projection * modelview});
    }
    return matrices;
}

/// Rows of numbers, each in brackets, for matrices that are not four by four.
struct NamedRows {
    std::string name, what;
    std::vector<std::vector<double>> rows;
};

/// R, t and K.
std::vector<NamedRows> openCvRows(const ApiCamera &camera)
{
    const auto rowsOf = [](const auto &matrix) {
        std::vector<std::vector<double>> rows(3);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                rows[static_cast<std::size_t>(row)].push_back(matrix[column][row]);
        }
        return rows;
    };
    const glm::dvec4 &t = camera.eyeFromWorld[3];
    std::vector<NamedRows> all{{"R", "eye from world, turned", rowsOf(camera.eyeFromWorld)},
                               {"t", "the world's origin in the eye's axes", {{t.x}, {t.y}, {t.z}}}};
    if (camera.intrinsics)
        all.push_back(
            {"K", "pixels from eye; the centre of the first pixel is 0, 0; no distortion", rowsOf(*camera.intrinsics)});
    return all;
}

std::string nested(const std::vector<std::vector<double>> &rows)
{
    std::string text;
    for (const std::vector<double> &row : rows) {
        text += text.empty() ? "[" : ", [";
        for (std::size_t i = 0; i < row.size(); ++i)
            text += (i > 0 ? ", " : "") + numberText(row[i], Digits::Double);
        text += ']';
    }
    return '[' + text + ']';
}

std::string formattedRows(const NamedRows &m, MatricesFormat format)
{
    std::string text;
    for (const std::vector<double> &row : m.rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            const char *separator = format == MatricesFormat::Latex ? " & " : format == MatricesFormat::C ? ", " : "  ";
            text += (i > 0 ? separator : "") + numberText(row[i], Digits::Double);
        }
        text += format == MatricesFormat::Latex ? " \\\\\n" : format == MatricesFormat::C ? ",\n" : "\n";
    }
    switch (format) {
    case MatricesFormat::Json:
    case MatricesFormat::Text: return text;
    case MatricesFormat::NumPy: return m.name + " = np.array(" + nested(m.rows) + ")\n";
    case MatricesFormat::C:
        return "const double " + m.name + '[' + std::to_string(m.rows.size() * m.rows[0].size()) + "] = {\n" + text
               + "};\n";
    case MatricesFormat::Latex: return "\\mathrm{" + m.name + "} =\n\\begin{bmatrix}\n" + text + "\\end{bmatrix}\n";
    }
    return text;
}

std::string json(const std::vector<NamedMatrix> &matrices, const std::vector<NamedRows> &others, const Written &written)
{
    std::string text = "{\n  \"layout\": ";
    text += written.layout == MatrixLayout::Column ? "\"column\"" : "\"row\"";
    if (written.api)
        text += ",\n  \"conventions\": \"" + std::string(written.api->key) + '"';
    for (const NamedMatrix &m : matrices) {
        std::vector<std::vector<double>> rows(4);
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column)
                rows[static_cast<std::size_t>(row)].push_back(entryAt(m.matrix, written.layout, row, column));
        }
        text += ",\n  \"" + m.name + "\": " + nested(rows);
    }
    for (const NamedRows &m : others)
        text += ",\n  \"" + m.name + "\": " + nested(m.rows);
    return text + "\n}\n";
}

/// The differences between an API's conventions and OpenGL's.
std::string differencesText(const ApiConventions &api)
{
    std::string text = api.name;
    const auto add = [&text](bool is, const char *what) { text += is ? std::string(", ") + what : ""; };
    add(api.isWorldMirrored, "world z negated (left-handed)");
    add(api.looksAlongPlusZ && !api.isEyeYDown, "eye left-handed, z forward: the view mirrors z");
    add(api.isEyeYDown, "eye x right, y down, z forward");
    add(api.isNdcYDown, "NDC y down");
    add(api.ndcDepth == NdcDepth::ZeroToOne, "NDC z from 0 to 1");
    add(api.isOriginTop, "window from the top left, y down");
    add(api.areLogicalPixels, "in logical pixels");
    add(api.pixelCentre == 0.0, "pixel centres at whole numbers");
    add(api.isDepthReversed, "depth 1 at near, 0 at far");
    return text;
}

std::string written(const std::vector<NamedMatrix> &matrices, const std::vector<NamedRows> &others,
                    const MatricesOptions &options, const Written &written)
{
    MatrixFormat format{MatrixSyntax::Text, written.layout, Digits::Double};
    std::string comment = "# ";
    switch (options.format) {
    case MatricesFormat::Json: return json(matrices, others, written);
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
    std::string text = written.api ? comment + differencesText(*written.api)
                                         + (written.layout == MatrixLayout::Row ? ", row vectors\n\n" : "\n\n")
                                   : "";
    text += options.format == MatricesFormat::NumPy ? "import numpy as np\n\n" : "";
    const bool isNameShown = format.syntax == MatrixSyntax::Text;
    for (const NamedMatrix &m : matrices) {
        text += comment + (isNameShown ? m.name + ": " : "") + m.what + '\n';
        text += formatted(m.matrix, format, m.name) + '\n';
    }
    for (const NamedRows &m : others) {
        text += comment + (isNameShown ? m.name + ": " : "") + m.what + '\n';
        text += formattedRows(m, options.format) + '\n';
    }
    text.pop_back();
    return text;
}

/// The camera in the requested conventions. Without the option, a scene in OpenGL's conventions
/// keeps its own camera, with any NDC depth.
Result<Written> writtenCamera(const MatricesOptions &options, const SceneFile &scene)
{
    const Api api = options.conventions.value_or(scene.conventions.value_or(Api::OpenGl));
    const ApiConventions &conventions = conventionsOf(api);
    const MatrixLayout usual = conventions.areVectorsRows ? MatrixLayout::Row : MatrixLayout::Column;
    const Setup setup = setupOf(scene);
    Written result{&conventions, options.layout.value_or(usual), {}};
    if (!options.conventions && api == Api::OpenGl) {
        const Result<glm::dmat4> view = eyeFromWorld(setup), projection = clipFromEye(setup);
        if (!view || !projection)
            return view ? projection.error() : view.error();
        result.api = nullptr;
        result.camera = {*view, *projection, windowMatrix(setup), {}};
        return result;
    }
    const Result<ApiCamera> camera = apiCamera(setup, api);
    if (!camera)
        return camera.error();
    result.camera = *camera;
    result.apiFromWorld = apiSpaces(setup, api).world.matrix();
    result.hasClip = api != Api::OpenCv;
    return result;
}

ExitCode runMatrices(const MatricesOptions &options)
{
    const SceneFile scene = readScene(options.scene);
    const Written camera = needed(writtenCamera(options, scene), options.scene);
    const std::vector<NamedMatrix> matrices = matricesOf(scene, camera);
    for (const NamedMatrix &m : matrices) {
        for (const double entry : memoryOrder(m.matrix)) {
            if (!std::isfinite(entry))
                refuse(tr("%1: %2: its numbers leave the range of double precision", options.scene, m.name));
        }
    }
    const std::vector<NamedRows> others = camera.hasClip ? std::vector<NamedRows>() : openCvRows(camera.camera);
    if (!camera.hasClip && !camera.camera.intrinsics)
        complain(tr("%1: no camera matrix K: OpenCV's camera is a perspective, this projection is not", options.scene));
    ByteSink sink("-", filesOf(scene, options.scene));
    sink.write(written(matrices, others, options, camera));
    return sink.finish();
}

} // namespace

void addMatrices(const Command &command)
{
    const auto options = std::make_shared<MatricesOptions>();
    command.file("SCENE", options->scene)->required();
    command.conventions(options->conventions);
    command.choice("--layout", options->layout, {{"column", MatrixLayout::Column}, {"row", MatrixLayout::Row}});
    command.choice("--format", options->format,
                   {{"text", MatricesFormat::Text},
                    {"json", MatricesFormat::Json},
                    {"c", MatricesFormat::C},
                    {"numpy", MatricesFormat::NumPy},
                    {"latex", MatricesFormat::Latex}});
    command.runs(options, runMatrices);
}

} // namespace unprojector::cli
