#include "core/cameras/call_signature.h"

#include "core/cameras/call_syntax.h"

#include <algorithm>
#include <array>
#include <span>
#include <string>

namespace unprojector::cameras {
using namespace geometry;

namespace {

struct Named {
    std::string_view name;
    CallShape shape;
    bool isPerspective = true;
};

/// The entry of a table under a name, or nothing.
/// @param shared  what all entries have in common
std::optional<CallSignature> found(std::span<const Named> table, std::string_view name, CallSignature shared)
{
    const auto entry = std::find_if(table.begin(), table.end(), [name](const Named &one) { return one.name == name; });
    if (entry == table.end())
        return std::nullopt;
    shared.shape = entry->shape;
    shared.isPerspective = entry->isPerspective;
    return shared;
}

bool takeEnd(std::string_view &name, std::string_view end)
{
    const bool isThere = name.ends_with(end);
    if (isThere)
        name.remove_suffix(end.size());
    return isThere;
}

std::optional<CallSignature> ofOpenGl(std::string_view name)
{
    constexpr std::array<Named, 8> kCalls{{{"gluPerspective", CallShape::FieldOfView},
                                           {"glFrustum", CallShape::Edges},
                                           {"glFrustumf", CallShape::Edges},
                                           {"glOrtho", CallShape::Edges, false},
                                           {"glOrthof", CallShape::Edges, false},
                                           {"gluOrtho2D", CallShape::EdgesOnly, false},
                                           {"gluLookAt", CallShape::LookAtNumbers},
                                           {"glViewport", CallShape::Viewport}}};
    return found(kCalls, name, {.areDegrees = true});
}

/// The signature of PyBullet's functions.
std::optional<CallSignature> ofPyBullet(std::string_view name)
{
    constexpr std::array<Named, 3> kCalls{{{"computeViewMatrix", CallShape::LookAtPoints},
                                           {"computeProjectionMatrixFOV", CallShape::FieldOfView},
                                           {"computeProjectionMatrix", CallShape::Edges}}};
    return found(kCalls, name, {.areDegrees = true, .dropsRest = false});
}

/// The signature of Android's Matrix: setLookAtM(result, offset, …).
std::optional<CallSignature> ofAndroid(std::string_view name)
{
    constexpr std::array<Named, 4> kCalls{{{"setLookAtM", CallShape::LookAtNumbers},
                                           {"perspectiveM", CallShape::FieldOfView},
                                           {"frustumM", CallShape::Edges},
                                           {"orthoM", CallShape::Edges, false}}};
    return found(kCalls, name, {.areDegrees = true, .firstArgument = 2});
}

/// The signature of glam's functions: Mat4::perspective_rh_gl. Without _gl, NDC depths are from 0.
std::optional<CallSignature> ofGlam(std::string_view name)
{
    constexpr std::array<Named, 5> kCalls{{{"perspective", CallShape::FieldOfView},
                                           {"frustum", CallShape::Edges},
                                           {"orthographic", CallShape::Edges, false},
                                           {"look_at", CallShape::LookAtPoints},
                                           {"look_to", CallShape::LookTo}}};
    const bool isOpenGl = takeEnd(name, "_gl"), isLeftHanded = takeEnd(name, "_lh");
    if (!isLeftHanded && !takeEnd(name, "_rh"))
        return std::nullopt;
    return found(kCalls, name,
                 {.isLeftHanded = isLeftHanded, .ndcDepth = isOpenGl ? NdcDepth::MinusOneToOne : NdcDepth::ZeroToOne});
}

/// The signature for GLM's names, which QMatrix4x4 and gl-matrix share: "perspectiveLH_ZO".
std::optional<CallSignature> ofGlm(const CallText &call, std::string_view program)
{
    constexpr std::array<Named, 5> kCalls{{{"perspective", CallShape::FieldOfView},
                                           {"perspectiveFov", CallShape::FieldOfViewOfSize},
                                           {"frustum", CallShape::Edges},
                                           {"ortho", CallShape::Edges, false},
                                           {"lookAt", CallShape::LookAtPoints}}};
    const auto names = [program](std::string_view word) { return program.find(word) != program.npos; };
    const bool isGlm = call.object == "glm" || (call.object.empty() && names("glm"));
    const bool isGlMatrix = call.object == "mat4" || call.object.ends_with(".mat4");
    const bool isQt = !isGlm && !isGlMatrix && !call.object.empty() && (names("QMatrix4x4") || names("QVector3D"));
    if (!isGlm && !isGlMatrix && !isQt)
        return std::nullopt;
    bool isLeftHanded = isGlm && names("GLM_FORCE_LEFT_HANDED");
    bool isZeroToOne = isGlm && names("GLM_FORCE_DEPTH_ZERO_TO_ONE");
    std::string_view name = call.name;
    if (takeEnd(name, "ZO"))
        isZeroToOne = true;
    else if (takeEnd(name, "NO"))
        isZeroToOne = false;
    takeEnd(name, "_");
    if (takeEnd(name, "LH"))
        isLeftHanded = true;
    else if (takeEnd(name, "RH"))
        isLeftHanded = false;
    std::optional<CallSignature> signature =
        found(kCalls, name,
              {.isLeftHanded = isLeftHanded,
               .ndcDepth = isZeroToOne ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne,
               .areDegrees = isQt,
               .dropsRest = !isGlMatrix,
               .firstArgument = isGlMatrix ? std::size_t{1} : std::size_t{0}});
    if (signature && name == "ortho" && call.arguments.size() == argumentCount(CallShape::EdgesOnly))
        signature->shape = CallShape::EdgesOnly;
    return signature;
}

std::optional<CallSignature> ofThree(std::string_view name)
{
    constexpr std::array<Named, 2> kCalls{
        {{"PerspectiveCamera", CallShape::FieldOfView}, {"OrthographicCamera", CallShape::EdgesTopFirst, false}}};
    return found(kCalls, name, {.areDegrees = true, .dropsRest = false});
}

/// The signature for names that DirectXMath and System.Numerics share: "PerspectiveOffCenter".
std::optional<CallSignature> ofMatrix(std::string_view name, CallSignature shared)
{
    constexpr std::array<Named, 10> kCalls{{{"PerspectiveFov", CallShape::FieldOfView},
                                            {"Ortho", CallShape::Size, false},
                                            {"OrthoOffCenter", CallShape::Edges, false},
                                            {"PerspectiveFieldOfView", CallShape::FieldOfView},
                                            {"Perspective", CallShape::Size},
                                            {"PerspectiveOffCenter", CallShape::Edges},
                                            {"Orthographic", CallShape::Size, false},
                                            {"OrthographicOffCenter", CallShape::Edges, false},
                                            {"LookAt", CallShape::LookAtPoints},
                                            {"LookTo", CallShape::LookTo}}};
    return found(kCalls, name, shared);
}

/// The signature of DirectXMath, of D3DX, whose first argument is the result, and of SharpDX's
/// Matrix.
std::optional<CallSignature> ofDirectXMath(const CallText &call)
{
    std::string_view name = call.name;
    const bool isD3dx = name.starts_with("D3DXMatrix"), isSharpDx = syntax::lastName(call.object) == "Matrix";
    constexpr std::string_view kPrefix = "XMMatrix", kD3dx = "D3DXMatrix";
    if (isD3dx)
        name.remove_prefix(kD3dx.size());
    else if (name.starts_with(kPrefix))
        name.remove_prefix(kPrefix.size());
    else if (!isSharpDx)
        return std::nullopt;
    const bool isLeftHanded = takeEnd(name, "LH");
    if (!isLeftHanded && !takeEnd(name, "RH"))
        return std::nullopt;
    return ofMatrix(name, {.isLeftHanded = isLeftHanded,
                           .ndcDepth = NdcDepth::ZeroToOne,
                           .firstArgument = isD3dx ? std::size_t{1} : std::size_t{0}});
}

std::optional<CallSignature> ofNumerics(const CallText &call)
{
    constexpr std::string_view kPrefix = "Create";
    std::string_view name = call.name;
    if (!name.starts_with(kPrefix))
        return std::nullopt;
    name.remove_prefix(kPrefix.size());
    const bool isLeftHanded = takeEnd(name, "LeftHanded");
    const std::string type = syntax::lastName(call.object);
    const bool isOpenTk = type == "Matrix4" || type == "Matrix4d";
    return ofMatrix(
        name, {.isLeftHanded = isLeftHanded, .ndcDepth = isOpenTk ? NdcDepth::MinusOneToOne : NdcDepth::ZeroToOne});
}

} // namespace

bool isProjection(CallShape shape)
{
    return shape != CallShape::LookAtNumbers && shape != CallShape::LookAtPoints && shape != CallShape::LookTo
           && shape != CallShape::Viewport;
}

std::size_t argumentCount(CallShape shape)
{
    switch (shape) {
    case CallShape::FieldOfView:
    case CallShape::Size:
    case CallShape::EdgesOnly:
    case CallShape::Viewport: return 4;
    case CallShape::FieldOfViewOfSize: return 5;
    case CallShape::Edges:
    case CallShape::EdgesTopFirst: return 6;
    case CallShape::LookAtNumbers: return 9;
    case CallShape::LookAtPoints:
    case CallShape::LookTo: break;
    }
    return 3;
}

std::optional<CallSignature> signatureOf(const CallText &call, std::string_view program)
{
    for (const auto of : {ofOpenGl, ofThree, ofPyBullet, ofAndroid, ofGlam}) {
        if (auto signature = of(call.name))
            return signature;
    }
    if (auto signature = ofDirectXMath(call))
        return signature;
    if (auto signature = ofNumerics(call))
        return signature;
    return ofGlm(call, program);
}

} // namespace unprojector::cameras
