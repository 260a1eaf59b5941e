#include "core/matrices/call_signature.h"

#include "core/matrices/call_syntax.h"

#include <array>
#include <string>

namespace unprojector::matrices {
using namespace geometry;

namespace {

struct Named {
    std::string_view name;
    CallShape shape;
    bool isPerspective = true;
};

/// The entry of a table under a name, or nothing.
template <std::size_t Count>
std::optional<CallSignature> found(const std::array<Named, Count> &table, std::string_view name)
{
    for (const Named &one : table) {
        if (one.name != name)
            continue;
        CallSignature signature;
        signature.shape = one.shape;
        signature.isPerspective = one.isPerspective;
        return signature;
    }
    return std::nullopt;
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
    std::optional<CallSignature> signature = found(kCalls, name);
    if (signature)
        signature->areDegrees = true;
    return signature;
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
    std::optional<CallSignature> signature = found(kCalls, name);
    if (!signature)
        return std::nullopt;
    signature->isLeftHanded = isLeftHanded;
    signature->ndcDepth = isZeroToOne ? NdcDepth::ZeroToOne : NdcDepth::MinusOneToOne;
    signature->areDegrees = isQt;
    signature->dropsRest = !isGlMatrix;
    signature->firstArgument = isGlMatrix ? 1 : 0;
    if (name == "ortho" && call.arguments.size() == argumentCount(CallShape::EdgesOnly))
        signature->shape = CallShape::EdgesOnly;
    return signature;
}

std::optional<CallSignature> ofThree(std::string_view name)
{
    constexpr std::array<Named, 2> kCalls{
        {{"PerspectiveCamera", CallShape::FieldOfView}, {"OrthographicCamera", CallShape::EdgesTopFirst, false}}};
    std::optional<CallSignature> signature = found(kCalls, name);
    if (signature) {
        signature->areDegrees = true;
        signature->dropsRest = false;
    }
    return signature;
}

/// The signature for names that DirectXMath and System.Numerics share: "PerspectiveOffCenter".
std::optional<CallSignature> ofMatrix(std::string_view name)
{
    constexpr std::array<Named, 8> kCalls{{{"PerspectiveFov", CallShape::FieldOfView},
                                           {"PerspectiveFieldOfView", CallShape::FieldOfView},
                                           {"Perspective", CallShape::Size},
                                           {"PerspectiveOffCenter", CallShape::Edges},
                                           {"Orthographic", CallShape::Size, false},
                                           {"OrthographicOffCenter", CallShape::Edges, false},
                                           {"LookAt", CallShape::LookAtPoints},
                                           {"LookTo", CallShape::LookTo}}};
    std::optional<CallSignature> signature = found(kCalls, name);
    if (signature)
        signature->ndcDepth = NdcDepth::ZeroToOne;
    return signature;
}

std::optional<CallSignature> ofDirectXMath(std::string_view name)
{
    constexpr std::string_view kPrefix = "XMMatrix";
    if (!name.starts_with(kPrefix))
        return std::nullopt;
    name.remove_prefix(kPrefix.size());
    const bool isLeftHanded = takeEnd(name, "LH");
    if (!isLeftHanded && !takeEnd(name, "RH"))
        return std::nullopt;
    std::optional<CallSignature> signature = ofMatrix(name);
    if (signature)
        signature->isLeftHanded = isLeftHanded;
    return signature;
}

std::optional<CallSignature> ofNumerics(const CallText &call)
{
    constexpr std::string_view kPrefix = "Create";
    std::string_view name = call.name;
    if (!name.starts_with(kPrefix))
        return std::nullopt;
    name.remove_prefix(kPrefix.size());
    const bool isLeftHanded = takeEnd(name, "LeftHanded");
    std::optional<CallSignature> signature = ofMatrix(name);
    if (!signature)
        return std::nullopt;
    signature->isLeftHanded = isLeftHanded;
    const std::string type = syntax::lastName(call.object);
    if (type == "Matrix4" || type == "Matrix4d") // OpenTK
        signature->ndcDepth = NdcDepth::MinusOneToOne;
    return signature;
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
    if (auto signature = ofOpenGl(call.name))
        return signature;
    if (auto signature = ofThree(call.name))
        return signature;
    if (auto signature = ofDirectXMath(call.name))
        return signature;
    if (auto signature = ofNumerics(call))
        return signature;
    return ofGlm(call, program);
}

} // namespace unprojector::matrices
