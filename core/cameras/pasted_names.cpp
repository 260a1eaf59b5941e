#include "core/cameras/pasted_names.h"

#include "core/base/letters.h"
#include "core/base/text_scanner.h"
#include "core/cameras/scan.h"

#include <algorithm>
#include <string>
#include <vector>

namespace unprojector::cameras {
namespace {

/// The names of a part, letters in lower case: whole names, and with a * what they contain; a + joins two.
struct Rule {
    std::string_view names;
    NamedPart named;
};

using enum PastedPart;
/// The first that fits counts.
constexpr Rule kRules[]{
    {"near far znear zfar nearplane farplane fov fovy fovx fieldofview aspect aspectratio cx cy fx fy focal "
     "focallength depth time frame fps zoom dpr pixelratio mouse cursor click mousepos mouseposition pixel length "
     "bytelength byteoffset modifiedtime referencecount cuda shape torchsize dtype ndim rows cols columns channels mps "
     "devicepixelratio winz winx winy *shape",
     {.isAside = true}},
    {"width", {.isWidth = true}},
    {"height", {.isHeight = true}},
    {"screen size resolution screensize windowsize imagesize canvas canvassize framebuffer framebuffersize",
     {.isWidth = true, .isHeight = true}},
    // Without an object's name, or with a camera's, matrixWorld is the pose of three.js and Blender.
    {"matrixworld *matrixworld+camera *worldfromeye *worldfromcam *worldfromview *cameratoworld *viewtoworld "
     "*eyetoworld *camtoworld",
     {View, true}},
    {"*camworldtocam *camworldtoview", {View}},
    {"*camworldto", {}},
    {"*camworld", {View, true}},
    {"*eyefromclip *viewfromclip *cliptoeye *cliptoview *cliptocamera", {Projection, true}},
    {"*worldfromclip *cliptoworld", {Product, true}},
    {"*viewport windowfromndc qrect qrectf", {Viewport}},
    {"windowmatrix", {Projection}}, // Blender's; its perspective matrix is projection * view
    {"perspectivematrix", {Product}},
    {"*window *mvpw", {ToWindow}},
    {"*clipfrom+fromworld *toclip+worldto", {Product}},
    {"*clipfromeye *clipfromview *clipfromcamera *eyetoclip *viewtoclip *cameratoclip", {Projection}},
    {"*mvp *product *fullproj *projection+view *projmat+view vp pv viewproj clipfromworld", {Product}},
    {"*projection *projmat proj p", {Projection}},
    {"*modelview mv", {ModelView}},
    {"*view *worldtocam *camerafromworld *camfromworld *extrinsic v eyefromworld", {View}},
    {"*model *matrixworld", {Model}},
};

/// What a name in lower-case letters tells: "glmodelviewmatrix", "pv", "mvp".
NamedPart namedByLetters(std::string_view letters)
{
    for (const Rule &rule : kRules) {
        for (std::size_t at = 0, end = 0; at < rule.names.size(); at = end + 1) {
            end = std::min(rule.names.find(' ', at), rule.names.size());
            const auto name = rule.names.substr(at, end - at);
            bool fits = name.front() == '*' || name == letters;
            for (auto i = name.find('*'); fits && i < name.size(); i = name.find('+', i + 1))
                fits = letters.find(name.substr(i + 1, name.find('+', i + 1) - i - 1)) != letters.npos;
            if (fits)
                return rule.named;
        }
    }
    return {};
}

/// What whole names tell, with the names of their objects: "camera.matrixWorld".
NamedPart namedByAll(std::string_view names)
{
    std::string letters;
    bool isInverse = false, isAxis = false;
    for (std::string word : wordsOf(names)) {
        if (base::isDigit(word[0]))
            continue;
        for (const std::string_view inverse : {"inverse", "inverted", "inv"}) {
            const auto at = word.find(inverse);
            const std::string rest = at == word.npos ? word : std::string(word).erase(at, inverse.size());
            // The inv of "viewinv", not of "involved".
            if (at == word.npos || (inverse == "inv" && !rest.empty() && !namedByLetters(rest).part))
                continue;
            isInverse = true;
            word = rest;
        }
        isAxis = isAxis || word == "depth" || word == "z" || word == "y"; // reversed depths, y down
        letters += word;
    }
    isInverse = isInverse && !isAxis;
    if (isInverse && letters.find("matrixworld") != letters.npos) // three.js's camera
        return {View};
    NamedPart named = namedByLetters(letters);
    named.isInverse = named.isInverse != isInverse;
    return named;
}

} // namespace

NamedPart namedBy(std::string_view names)
{
    constexpr std::size_t kShort = 2; // the p of "ray.p" is no projection
    const std::string_view last = lastPart(names);
    if (last.size() < names.size() && names.find(' ') == names.npos && last.size() > kShort
        && !base::lowerCase(last).starts_with("matrix")) {
        const NamedPart named = namedByAll(last);
        if (named.part || named.isAside || named.isWidth || named.isHeight)
            return named;
    }
    return namedByAll(names);
}

} // namespace unprojector::cameras
