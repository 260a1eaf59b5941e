#include "core/cameras/known_calls.h"

#include "core/base/letters.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/pasted_matrix.h"

#include <algorithm>
#include <initializer_list>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using namespace base;

using enum CallKind;
using enum NdcDepth;
namespace {

/// The keywords of a parameter in any library, between blanks, as base::plainName. The shapes use the
/// first one. A parameter that is not listed here is a number and has one keyword.
struct Parameter {
    std::string_view names;
    bool isVector = false;
};
constexpr Parameter kParameters[] = {
    {" fov fovy fieldofview verticalfov yfov "},
    {" aspect aspectratio "},
    {" near nearval znear nearplane znearplane nearplanedistance nearz depthnear neardist n "},
    {" far farval zfar farplane zfarplane farplanedistance farz depthfar fardist f "},
    {" width viewwidth w "},
    {" height viewheight h "},
    {" left viewleft l "},
    {" right viewright r "},
    {" bottom viewbottom b "},
    {" top viewtop t "},
    {" eye eyeposition position cameraposition cameraeyeposition ", true},
    {" center centre at target focusposition cameratarget cameratargetposition ", true},
    {" direction dir eyedirection cameradirection ", true},
    {" up upvector updirection cameraup cameraupvector ", true}};

constexpr CallShape kFieldOfView{Perspective, "fov, aspect, near, far"};
constexpr CallShape kFieldOfViewOfSize{Perspective, "fov, width, height, near, far"};
constexpr CallShape kFrustum{Perspective, "left, right, bottom, top, near, far"};
constexpr CallShape kFrustumOfSize{Perspective, "width, height, near, far"};
constexpr CallShape kBox{Orthographic, "left, right, bottom, top, near, far"};
constexpr CallShape kBoxOfSize{Orthographic, "width, height, near, far"};
constexpr CallShape kFlatBox{Orthographic, "left, right, bottom, top"};
constexpr CallShape kLookAt{View, "eye, center, up"};
constexpr CallShape kLookTo{View, "eye, direction, up"};
constexpr CallShape kLookAtNumbers{View, "eyex, eyey, eyez, centerx, centery, centerz, upx, upy, upz"};
constexpr CallShape kViewport{Viewport, "x, y, width, height"};
constexpr CallShape kWindow{Window, "width, height"};
constexpr CallShape kThreePerspective{Perspective, "fov=50, aspect=1, near=0.1, far=2000"};
constexpr CallShape kThreeBox{Orthographic, "left=-1, right=1, top=1, bottom=-1, near=0.1, far=2000"};

/// The libraries of a family have calls of the same names, apart from a prefix.
enum class Family { OpenGl, Three, PyBullet, Android, Glam, DirectX, Glm };
using enum Family;

struct Row {
    std::string_view names; ///< between blanks, without the ending for a hand or NDC depths
    Family family;
    CallShape shape;
};
constexpr Row kCalls[] = {{" gluPerspective ", OpenGl, kFieldOfView},
                          {" glFrustum glFrustumf ", OpenGl, kFrustum},
                          {" glOrtho glOrthof ", OpenGl, kBox},
                          {" gluOrtho2D ", OpenGl, kFlatBox},
                          {" gluLookAt ", OpenGl, kLookAtNumbers},
                          {" glViewport ", OpenGl, kViewport},
                          {" glutInitWindowSize ", OpenGl, kWindow},
                          {" glfwCreateWindow ", OpenGl, kWindow},
                          {" PerspectiveCamera ", Three, kThreePerspective},
                          {" setSize ", Three, kWindow},
                          {" OrthographicCamera ", Three, kThreeBox},
                          {" computeViewMatrix ", PyBullet, kLookAt},
                          {" computeProjectionMatrixFOV ", PyBullet, kFieldOfView},
                          {" computeProjectionMatrix ", PyBullet, kFrustum},
                          {" setLookAtM ", Android, kLookAtNumbers},
                          {" perspectiveM ", Android, kFieldOfView},
                          {" frustumM ", Android, kFrustum},
                          {" orthoM ", Android, kBox},
                          {" perspective_ ", Glam, kFieldOfView},
                          {" frustum_ ", Glam, kFrustum},
                          {" orthographic_ ", Glam, kBox},
                          {" look_at_ ", Glam, kLookAt},
                          {" look_to_ ", Glam, kLookTo},
                          {" PerspectiveFov PerspectiveFieldOfView ", DirectX, kFieldOfView},
                          {" Perspective ", DirectX, kFrustumOfSize},
                          {" PerspectiveOffCenter ", DirectX, kFrustum},
                          {" Orthographic Ortho ", DirectX, kBoxOfSize},
                          {" OrthographicOffCenter OrthoOffCenter ", DirectX, kBox},
                          {" LookAt ", DirectX, kLookAt},
                          {" LookTo ", DirectX, kLookTo},
                          {" perspective ", Glm, kFieldOfView},
                          {" perspectiveFov ", Glm, kFieldOfViewOfSize},
                          {" frustum ", Glm, kFrustum},
                          {" ortho ", Glm, kBox},
                          {" ortho ", Glm, kFlatBox}, // of four arguments
                          {" lookAt ", Glm, kLookAt}};

/// Where a program says that the eye is left-handed.
enum class Hand {
    InNameIfLeft, ///< in the name of the call; without it, the eye is right-handed
    InName,       ///< in the name of the call, which has one of both hands
    InProgram     ///< in the name of the call, or for all calls by GLM's macro
};
using enum Hand;

struct Library {
    Family family;
    Hand hand;
    std::string_view prefix;
    std::string_view objects; ///< the last name before the call's, between blanks, - for no name; empty: any
    std::string_view word;    ///< in the program's text
    CallConventions conventions;
};
constexpr CallConventions kOpenGl{}, kInDegrees{.areDegrees = true}, kZeroToOne{.ndcDepth = ZeroToOne};
constexpr Library kLibraries[] = {
    {OpenGl, InNameIfLeft, "", "", "", kInDegrees},
    {Three, InNameIfLeft, "", "", "", {.areDegrees = true, .dropsRest = false}},
    {PyBullet, InNameIfLeft, "", "", "", {.areDegrees = true, .dropsRest = false}},
    {Android, InNameIfLeft, "", "", "", {.areDegrees = true, .skipped = 2}},
    {Glam, InName, "", "", "", kZeroToOne},
    {DirectX, InName, "XMMatrix", "", "", kZeroToOne},
    {DirectX, InName, "D3DXMatrix", "", "", {.ndcDepth = ZeroToOne, .skipped = 1}},
    {DirectX, InName, "", " Matrix ", "", kZeroToOne},                    // SharpDX
    {DirectX, InNameIfLeft, "Create", " Matrix4 Matrix4d ", "", kOpenGl}, // OpenTK
    {DirectX, InNameIfLeft, "Create", "", "", kZeroToOne},                // System.Numerics
    {Glm, InProgram, "", " glm ", "", kOpenGl},
    {Glm, InProgram, "", " - ", "glm", kOpenGl},
    {Glm, InNameIfLeft, "", " mat4 ", "", {.dropsRest = false, .skipped = 1}}, // gl-matrix
    {Glm, InNameIfLeft, "", "", "QMatrix4x4", kInDegrees},
    {Glm, InNameIfLeft, "", "", "QVector3D", kInDegrees}};

/// "fov=50" or "aspectRatio: 1": its keyword, which may be empty, and its value.
std::pair<std::string_view, std::string_view> keywordAndValue(std::string_view text)
{
    const std::string_view keyword = namesAt(text, 0), rest = trimmed(text.substr(keyword.size()));
    const bool isKeyword = !keyword.empty() && isLetter(text[0]) && rest.size() > 1
                           && (rest[0] == '=' || rest[0] == ':') && rest[1] != rest[0];
    return isKeyword ? std::pair(keyword, trimmed(rest.substr(1))) : std::pair(std::string_view(), text);
}

/// The parameter with a keyword.
Parameter parameterOf(std::string_view name)
{
    for (const Parameter &one : kParameters) {
        if (isListed(one.names, name))
            return one;
    }
    return {name};
}

} // namespace

void failCall(std::string text)
{
    PasteError error{std::move(text)};
    error.isOfCall = true;
    throw error;
}

void failCount(const SourceCall &call, std::size_t found, std::size_t wanted)
{
    failCall(tr("%1: %2 arguments found, %3 are needed", call.written, found, wanted));
}

std::optional<KnownCall> knownCall(const SourceCall &call, std::string_view program)
{
    if (call.isAssignment)
        return std::nullopt;
    const std::string_view object = call.object.empty() ? "-" : lastName(call.object);
    const auto isNamed = [program](std::string_view word) { return program.find(word) != program.npos; };
    for (const Library &library : kLibraries) {
        std::string_view name = call.name;
        if (!name.starts_with(library.prefix))
            continue;
        name.remove_prefix(library.prefix.size());
        const auto take = [&name](std::initializer_list<std::string_view> endings) {
            for (const std::string_view ending : endings) {
                if (name.ends_with(ending)) {
                    name.remove_suffix(ending.size());
                    return true;
                }
            }
            return false;
        };
        const bool isMinusOneToOne = take({"_gl", "_NO", "NO"}), isZeroToOne = take({"_ZO", "ZO"});
        const bool isLeftHanded = take({"LH", "lh", "LeftHanded"}), isRightHanded = take({"RH", "rh"});
        const Row *row = nullptr;
        for (const Row &one : kCalls) {
            if (one.family == library.family && isListed(one.names, name)
                && (!row || commaSeparated(one.shape.parameters).size() == call.arguments.size()))
                row = &one;
        }
        const bool isOfObject =
            library.objects.empty() ? library.word.empty() || !call.object.empty() : isListed(library.objects, object);
        // Only the renderer's size is the picture's: not a font's.
        const std::string owner = lowerCase(call.object);
        if (row && row->shape.kind == Window && library.family == Three
            && (owner.find("renderer") == owner.npos || owner.find("css") != owner.npos))
            continue;
        const bool isHandKnown = library.hand != InName || isLeftHanded || isRightHanded;
        if (!row || !isOfObject || !isHandKnown || !isNamed(library.word))
            continue;
        KnownCall known{row->shape, library.conventions};
        const bool readsProgram = library.hand == InProgram;
        if (isLeftHanded || (readsProgram && !isRightHanded && isNamed("GLM_FORCE_LEFT_HANDED")))
            known.isLeftHanded = true;
        if (isMinusOneToOne)
            known.ndcDepth = MinusOneToOne;
        else if (isZeroToOne || (readsProgram && isNamed("GLM_FORCE_DEPTH_ZERO_TO_ONE")))
            known.ndcDepth = ZeroToOne;
        return known;
    }
    return std::nullopt;
}

std::vector<CallArgument> callArguments(const SourceCall &call, const KnownCall &known)
{
    std::vector<CallArgument> sorted;
    for (const std::string_view one : commaSeparated(known.parameters)) {
        const auto [keyword, value] = keywordAndValue(one);
        const std::string_view name = keyword.empty() ? one : keyword;
        sorted.push_back({name, keyword.empty() ? keyword : value, parameterOf(name).isVector});
    }
    std::vector<bool> isGiven(sorted.size(), false);
    std::size_t tooMany = 0;
    // A window's title and flags follow its size.
    const std::size_t count =
        known.kind == Window ? std::min<std::size_t>(call.arguments.size(), 2) : call.arguments.size();
    for (std::size_t i = known.skipped; i < count; ++i) {
        const auto [keyword, value] = keywordAndValue(call.arguments[i]);
        const std::string name = plainName(keyword);
        if (name == "physicsclientid")
            continue;
        std::size_t at = i - known.skipped;
        if (!keyword.empty()) {
            const auto found = std::ranges::find_if(sorted, [&name](const CallArgument &one) {
                return one.parameter == name || isListed(parameterOf(one.parameter).names, name);
            });
            if (found == sorted.end())
                failCall(tr("%1: the argument '%2' is not known. Use the names of the call's own arguments, or none",
                            call.written, keyword));
            at = std::size_t(found - sorted.begin());
        }
        if (at >= sorted.size()) {
            ++tooMany;
            continue;
        }
        if (isGiven[at])
            failCall(tr("%1: the argument '%2' is given twice. Remove one of them", call.written,
                        keyword.empty() ? value : keyword));
        isGiven[at] = true;
        if (!value.empty())
            sorted[at].text = value;
    }
    const auto missing = std::size_t(std::ranges::count_if(sorted, [](const auto &one) { return one.text.empty(); }));
    if (missing + tooMany > 0)
        failCount(call, sorted.size() - missing + tooMany, sorted.size());
    return sorted;
}

} // namespace unprojector::cameras
