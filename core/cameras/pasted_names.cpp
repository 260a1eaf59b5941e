#include "core/cameras/pasted_names.h"

#include "core/base/text_scanner.h"

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <initializer_list>
#include <vector>

namespace unprojector::cameras {
namespace {

/// The part that lower-case letters name: "glmodelviewmatrix", "modelview", "pv", "mvp".
std::optional<PastedPart> partOf(const std::string &letters)
{
    const auto has = [&letters](const char *name) { return letters.find(name) != std::string::npos; };
    if (has("viewport") || letters == "windowfromndc" || letters == "qrect" || letters == "qrectf")
        return PastedPart::Viewport;
    if (letters == "windowmatrix") // Blender
        return PastedPart::Projection;
    if (has("window") || has("mvpw"))
        return PastedPart::ToWindow;
    for (const char *name :
         {"clipfromeye", "clipfromview", "clipfromcamera", "eyetoclip", "viewtoclip", "cameratoclip"}) {
        if (has(name))
            return has("fromworld") || has("worldto") ? PastedPart::Product : PastedPart::Projection;
    }
    const bool isProjection = has("projection") || letters == "proj" || letters == "p" || has("projmat");
    if (letters == "perspectivematrix") // Blender: projection * view
        return PastedPart::Product;
    if (has("mvp") || has("product") || has("fullproj") || (isProjection && has("view")) || letters == "vp"
        || letters == "pv" || letters == "clipfromworld" || letters == "viewproj")
        return PastedPart::Product;
    if (isProjection)
        return PastedPart::Projection;
    if (has("modelview") || letters == "mv")
        return PastedPart::ModelView;
    if (has("view") || letters == "v" || letters == "eyefromworld" || has("worldtocamera") || has("worldtocam")
        || has("camerafromworld") || has("camfromworld") || letters.starts_with("extrinsic"))
        return PastedPart::View;
    // matrixWorld of a three.js object, matrix_world of Blender; without an object's name it is the
    // camera's, see namedBy
    if (has("model") || has("matrixworld"))
        return PastedPart::Model;
    return std::nullopt;
}

/// The words of names in lower case: "inv_viewMatrix" has "inv", "view" and "matrix". The 2 of
/// "world2cam" is the word "to".
std::vector<std::string> wordsOf(std::string_view names)
{
    std::vector<std::string> words;
    char before = ' ';
    for (std::size_t i = 0; i < names.size(); ++i) {
        const char c = names[i];
        const auto is = [](int (*kind)(int), char one) { return kind(static_cast<unsigned char>(one)) != 0; };
        if (c == '2' && is(std::isalpha, before) && i + 1 < names.size() && is(std::isalpha, names[i + 1]))
            words.emplace_back("to");
        if (is(std::isalpha, c)) {
            if (!is(std::isalpha, before) || (is(std::islower, before) && is(std::isupper, c)))
                words.emplace_back();
            words.back() += base::lowerCase({&c, 1});
        }
        before = c;
    }
    return words;
}

/// The word without "inverse": "view" for "viewinverse" and "invview", empty for "inv". Nothing for
/// a word without that meaning, such as "involved".
std::optional<std::string> withoutInverse(std::string word)
{
    for (const std::string_view whole : {"inverse", "inverted"}) {
        if (const std::size_t at = word.find(whole); at != word.npos)
            return word.erase(at, whole.size());
    }
    constexpr std::string_view kShort = "inv";
    if (word.ends_with(kShort)) {
        const std::string name = word.substr(0, word.size() - kShort.size());
        return name.empty() || partOf(name) ? std::optional(name) : std::nullopt;
    }
    if (!word.starts_with(kShort))
        return std::nullopt;
    const std::string name = word.substr(kShort.size());
    const bool beginsWithName = name.starts_with("view") || name.starts_with("proj") || name.starts_with("model")
                                || name.starts_with("mvp") || name.size() <= 2;
    return beginsWithName && partOf(name) ? std::optional(name) : std::nullopt;
}

/// Returns whether a word names an inverted property rather than an inverse matrix: reversed
/// depths, y down.
bool isAxis(const std::string &word)
{
    return word == "depth" || word == "z" || word == "y";
}

/// The part that whole names tell, with the names of their objects: "camera.matrixWorld".
std::optional<NamedPart> namedByAll(std::string_view names)
{
    const std::vector<std::string> words = wordsOf(names);
    std::string letters;
    bool isInverse = false;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const std::optional<std::string> rest = withoutInverse(words[i]);
        const bool isOfAxis =
            rest
            && (isAxis(*rest) || (i > 0 && isAxis(words[i - 1])) || (i + 1 < words.size() && isAxis(words[i + 1])));
        isInverse = isInverse || (rest && !isOfAxis);
        letters += rest.value_or(words[i]);
    }
    const auto hasAny = [&letters](std::initializer_list<std::string_view> some) {
        return std::any_of(some.begin(), some.end(),
                           [&](std::string_view name) { return letters.find(name) != std::string::npos; });
    };
    if (hasAny({"matrixworld"}) && isInverse) // three.js's camera
        return NamedPart{PastedPart::View};
    // The name refers to a camera or to no object: worldFromEye, the inverse of the view.
    if (letters == "matrixworld" || (hasAny({"matrixworld"}) && hasAny({"camera"}))
        || hasAny({"worldfromeye", "worldfromcam", "worldfromview", "cameratoworld", "viewtoworld", "eyetoworld",
                   "camtoworld"}))
        return NamedPart{PastedPart::View, !isInverse};
    // "cam_world" is the camera's pose, "cam_worldToCamera" is not.
    if (hasAny({"camworld"}) && !hasAny({"worldto"}))
        return NamedPart{PastedPart::View, !isInverse};
    if (hasAny({"eyefromclip", "viewfromclip", "cliptoeye", "cliptoview", "cliptocamera"}))
        return NamedPart{PastedPart::Projection, !isInverse};
    if (hasAny({"worldfromclip", "cliptoworld"}))
        return NamedPart{PastedPart::Product, !isInverse};
    const std::optional<PastedPart> part = partOf(letters);
    return part ? std::optional(NamedPart{*part, isInverse}) : std::nullopt;
}

/// @param words  between blanks
bool isAnyOf(const std::string &word, std::string_view words)
{
    return words.find(' ' + word + ' ') != words.npos;
}

} // namespace

std::optional<NamedPart> namedBy(std::string_view names)
{
    constexpr std::size_t kShort = 2; // the p of "ray.p" is no projection
    const std::string_view last = names.substr(names.find_last_of('.') + 1);
    if (names.find(' ') == names.npos && last.size() > kShort && !base::lowerCase(last).starts_with("matrix")) {
        if (const auto named = namedByAll(last))
            return named;
    }
    return namedByAll(names);
}

std::string lettersOf(std::string_view names)
{
    std::string letters;
    for (const std::string &word : wordsOf(names))
        letters += word;
    return letters;
}

bool isAside(const std::string &letters)
{
    if (letters.ends_with("shape")) // view.shape (4, 4)
        return true;
    return isAnyOf(letters, " near far znear zfar nearplane farplane fov fovy fovx fieldofview aspect "
                            "aspectratio cx cy fx fy focal focallength depth time frame fps zoom dpr "
                            "pixelratio mouse cursor click mousepos mouseposition pixel length bytelength "
                            "byteoffset modifiedtime referencecount cuda shape torchsize dtype ndim rows cols "
                            "columns channels mps devicepixelratio winz winx winy ");
}

bool isSize(const std::string &letters)
{
    return isAnyOf(letters, " screen size resolution screensize windowsize imagesize canvas canvassize "
                            "framebuffer framebuffersize ");
}

} // namespace unprojector::cameras
