#include "core/cameras/pasted_calls.h"

#include "core/base/number_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/argument_reader.h"
#include "core/cameras/call_keywords.h"
#include "core/cameras/call_matrices.h"
#include "core/cameras/call_signature.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using base::tr;

namespace {

constexpr int kDigits = 5;

std::string numberText(double value)
{
    return base::significantText(value, kDigits);
}

std::string vectorText(const glm::dvec3 &v)
{
    return '(' + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + ')';
}

PastedMatrix pastedOf(const glm::dmat4 &matrix, const CallSignature &signature, std::string said)
{
    PastedMatrix pasted;
    pasted.form = MatrixForm::Call;
    for (int i = 0; i < 16; ++i)
        pasted.numbers[std::size_t(i)] = matrix[i / 4][i % 4] + 0.0;
    if (isProjection(signature.shape))
        pasted.ndcDepth = signature.ndcDepth;
    pasted.call = std::move(said);
    return pasted;
}

class Reader {
public:
    explicit Reader(std::string_view text)
        : m_program(text), m_text(withoutComments(text)), m_arguments(m_text), m_assignments(assignmentTexts(m_text)),
          m_rest(m_text)
    {
    }

    PastedCalls read()
    {
        for (const CallText &call : callTexts(m_text)) {
            readAssignments(call.at);
            const std::optional<CallSignature> signature = signatureOf(call, m_program);
            if (signature)
                readCall(call, *signature);
            else
                readThree(call);
            if (isLeftOut(call) && std::find(m_leftOut.begin(), m_leftOut.end(), call.written) == m_leftOut.end())
                m_leftOut.push_back(call.written);
        }
        if (m_read.hasAny)
            readAssignments(m_text.size());
        if (!m_three.name.empty())
            setThreeView();
        if (std::optional<PastedMatrix> &view = m_read.parts.view) {
            for (const std::string &one : m_leftOut)
                view->call += tr(". %1 is ignored: the view is read without it", one);
        }
        for (const AssignmentText &one : m_assignments) { // width = 800 is no number of a matrix
            if (m_arguments.number(one.value))
                blank(one.at, one.end);
        }
        m_read.rest = m_rest;
        return m_read;
    }

private:
    void blank(std::size_t at, std::size_t end)
    {
        std::fill(m_rest.begin() + std::ptrdiff_t(at), m_rest.begin() + std::ptrdiff_t(end), ' ');
    }
    void blank(const CallText &call)
    {
        m_read.hasAny = true;
        blank(call.at, call.end);
    }

    /// Fails for parameters that no projection or view has.
    static void require(const CallText &call, const Check &valid)
    {
        if (!valid)
            failCall(call.written + ": " + geometry::errorText(valid.error()));
    }
    [[noreturn]] static void failCount(const CallText &call, std::size_t found, std::size_t wanted)
    {
        failCall(tr("%1: %2 arguments found, %3 are needed", call.written, found, wanted));
    }

    /// The value of an argument, or of a number assigned to a name.
    ArgumentNumber number(const std::string &name, const std::string &argument) const
    {
        const auto value = m_arguments.number(argument);
        if (!value)
            failCall(tr("%1: the argument '%2' is not a number. Put its value there", name, argument));
        return *value;
    }

    /// The numbers of a call, starting at an argument.
    std::vector<double> numbers(const CallText &call, std::size_t first, std::size_t count)
    {
        std::vector<double> values;
        for (std::size_t i = first; i < first + count; ++i) {
            const ArgumentNumber one = number(call.written, call.arguments[i]);
            values.push_back(one.value);
            if (!one.wholeQuotient.empty())
                m_wholeQuotient = one;
        }
        return values;
    }

    glm::dvec3 vector(const CallText &call, std::size_t index) const
    {
        const auto value = m_arguments.vector(call.arguments[index]);
        if (!value)
            failCall(tr("%1: the argument '%2' is not a vector of numbers. Put three numbers there", call.written,
                        call.arguments[index]));
        return *value;
    }

    void readCall(CallText call, const CallSignature &signature)
    {
        blank(call);
        m_wholeQuotient = {};
        if (call.arguments.size() >= signature.firstArgument)
            call.arguments.erase(call.arguments.begin(),
                                 call.arguments.begin() + std::ptrdiff_t(signature.firstArgument));
        sortByKeyword(call, signature.shape);
        if (call.name.ends_with("Camera")) {
            addDefaults(call, signature);
            m_camera = call.variable;
        }
        const std::size_t wanted = argumentCount(signature.shape);
        const auto missing = std::size_t(std::count(call.arguments.begin(), call.arguments.end(), std::string()));
        if (call.arguments.size() != wanted || missing > 0)
            failCount(call, call.arguments.size() - missing, wanted);
        if (signature.shape == CallShape::Viewport)
            readViewport(call);
        else if (isProjection(signature.shape))
            readProjection(call, signature);
        else
            readView(call, signature);
    }

    /// Adds the default arguments of three.js.
    static void addDefaults(CallText &call, const CallSignature &signature)
    {
        const std::vector<std::string> defaults = signature.isPerspective
                                                      ? std::vector<std::string>{"50", "1", "0.1", "2000"}
                                                      : std::vector<std::string>{"-1", "1", "1", "-1", "0.1", "2000"};
        call.arguments.resize(std::max(call.arguments.size(), defaults.size()));
        for (std::size_t i = 0; i < defaults.size(); ++i) {
            if (call.arguments[i].empty())
                call.arguments[i] = defaults[i];
        }
    }

    void readViewport(const CallText &call)
    {
        const std::vector<double> v = numbers(call, 0, 4);
        if (m_read.parts.viewport)
            return;
        const Viewport viewport{v[0], v[1], v[2], v[3]};
        require(call, geometry::check(viewport));
        m_read.parts.viewport = viewport;
    }

    void readProjection(const CallText &call, const CallSignature &signature)
    {
        std::string said;
        const Ortho volume = volumeOf(call, signature, said);
        require(call, check(volume, signature.isPerspective));
        if (m_read.parts.projection) {
            m_read.parts.projection->call += tr(". %1 follows and is ignored: one projection is read", call.written);
            return;
        }
        if (signature.isLeftHanded || signature.ndcDepth == NdcDepth::ZeroToOne)
            said += handText(signature);
        if (signature.dropsRest && !m_wholeQuotient.wholeQuotient.empty()) {
            const double value = m_wholeQuotient.value;
            said += tr(". %1 is read as %2; in C, C++ and C# it is %3, as long as no number of it has a point",
                       m_wholeQuotient.wholeQuotient, numberText(value), numberText(std::trunc(value)));
        }
        m_read.parts.projection = pastedOf(cameras::clipFromEye(volume, signature), signature, said);
    }

    static std::string handText(const CallSignature &signature)
    {
        const bool isZeroToOne = signature.ndcDepth == NdcDepth::ZeroToOne;
        if (signature.isLeftHanded)
            return isZeroToOne ? tr("; left-handed, NDC depths from 0 to 1")
                               : tr("; left-handed, NDC depths from -1 to 1");
        return tr("; right-handed, NDC depths from 0 to 1");
    }

    Ortho volumeOf(const CallText &call, const CallSignature &signature, std::string &said)
    {
        const std::vector<double> v = numbers(call, 0, call.arguments.size());
        Ortho volume;
        switch (signature.shape) {
        case CallShape::FieldOfView: return volumeOf(call, signature, v[0], v[1], v[2], v[3], said);
        case CallShape::FieldOfViewOfSize: return volumeOf(call, signature, v[0], v[1] / v[2], v[3], v[4], said);
        case CallShape::Size: volume = {-v[0] / 2.0, v[0] / 2.0, -v[1] / 2.0, v[1] / 2.0, v[2], v[3]}; break;
        case CallShape::EdgesTopFirst: volume = {v[0], v[1], v[3], v[2], v[4], v[5]}; break;
        case CallShape::EdgesOnly: volume = {v[0], v[1], v[2], v[3], -1.0, 1.0}; break;
        default: volume = {v[0], v[1], v[2], v[3], v[4], v[5]}; break;
        }
        said = tr("%1: left %2, right %3, bottom %4, top %5, near %6, far %7", call.written, numberText(volume.left),
                  numberText(volume.right), numberText(volume.bottom), numberText(volume.top),
                  numberText(volume.nearDistance), numberText(volume.farDistance));
        return volume;
    }

    Ortho volumeOf(const CallText &call, const CallSignature &signature, double angle, double aspect,
                   double nearDistance, double farDistance, std::string &said)
    {
        Perspective lens;
        lens.verticalFov = signature.areDegrees ? Angle::fromDegrees(angle) : Angle(angle);
        lens.aspect = aspect;
        lens.nearDistance = nearDistance;
        lens.farDistance = farDistance;
        if (!signature.areDegrees && angle >= kPi)
            failCall(tr("%1: the angle is in radians and must be smaller than pi. You entered %2", call.written,
                        numberText(angle)));
        if (const double fov = lens.verticalFov.radians.value; !(fov > 0.0 && fov < kPi))
            require(call, Error{ErrorCode::FieldOfViewOutOfRange, fov});
        if (!(std::abs(aspect) > 0.0) || !std::isfinite(aspect))
            require(call, Error{ErrorCode::AspectNotPositive, aspect});
        said = tr("%1: fovy %2°, aspect %3, near %4, far %5", call.written, numberText(lens.verticalFov.degrees()),
                  numberText(aspect), numberText(nearDistance), numberText(farDistance));
        if (signature.areDegrees && angle < kPi)
            said += tr(". The angle is in degrees: %1 would be %2° if it were in radians", numberText(angle),
                       numberText(degreesFromRadians(angle)));
        const Frustum f = frustumFromPerspective(lens);
        return {f.left, f.right, f.bottom, f.top, f.nearDistance, f.farDistance};
    }

    void readView(const CallText &call, const CallSignature &signature)
    {
        glm::dvec3 eye(0.0), center(0.0), up(0.0);
        if (signature.shape == CallShape::LookAtNumbers) {
            const std::vector<double> v = numbers(call, 0, 9);
            eye = {v[0], v[1], v[2]};
            center = {v[3], v[4], v[5]};
            up = {v[6], v[7], v[8]};
        } else {
            eye = vector(call, 0);
            center = vector(call, 1);
            if (signature.shape == CallShape::LookTo)
                center += eye;
            up = vector(call, 2);
        }
        setView(call, signature, {WorldPoint(eye), WorldPoint(center), WorldVector(up)});
    }

    void setView(const CallText &call, const CallSignature &signature, const LookAt &camera)
    {
        const Result<glm::dmat4> matrix = cameras::eyeFromWorld(camera, signature.isLeftHanded);
        if (!matrix)
            require(call, matrix.error());
        if (m_read.parts.view) {
            m_read.parts.view->call += tr(". %1 follows and is ignored: one view is read", call.written);
            return;
        }
        std::string said = tr("%1: eye %2, center %3, up %4", call.written, vectorText(camera.eye.coordinates()),
                              vectorText(camera.center.coordinates()), vectorText(camera.up.coordinates()));
        if (signature.isLeftHanded)
            said += tr("; left-handed");
        m_read.parts.view = pastedOf(*matrix, signature, std::move(said));
    }

    void setThreeView()
    {
        CallText camera;
        camera.written = m_three.name;
        CallSignature signature;
        signature.shape = CallShape::LookAtPoints;
        setView(camera, signature,
                {WorldPoint(m_three.position), WorldPoint(m_three.position + m_three.direction),
                 WorldVector(m_three.upThen)});
    }

    /// Reads camera.position.set, camera.up.set and camera.lookAt of three.js, for the camera that
    /// the text creates or a variable with its name.
    void readThree(const CallText &call)
    {
        std::string object = call.object;
        const bool isSet = call.name == "set";
        const auto takeEnd = [&object](std::string_view end) {
            const bool isThere = object.ends_with(end);
            if (isThere)
                object.resize(object.size() - end.size());
            return isThere;
        };
        const bool isPosition = isSet && takeEnd(".position"), isUp = isSet && !isPosition && takeEnd(".up");
        const bool isLookAt = call.name == "lookAt";
        if ((!isPosition && !isUp && !isLookAt) || !isCamera(object))
            return;
        blank(call);
        glm::dvec3 point(0.0);
        if (call.arguments.size() == 1) {
            point = vector(call, 0);
        } else if (call.arguments.size() == 3) {
            const std::vector<double> v = numbers(call, 0, 3);
            point = {v[0], v[1], v[2]};
        } else {
            failCount(call, call.arguments.size(), 3);
        }
        if (isUp) {
            m_three.up = point;
            return;
        }
        m_three.name = object;
        if (isPosition) {
            m_three.position = point;
        } else {
            m_three.direction = point - m_three.position;
            m_three.upThen = m_three.up;
        }
    }

    /// Returns whether a call turns or moves the view, or an object in it, in an unsupported way.
    bool isLeftOut(const CallText &call) const
    {
        for (const std::string_view name : {"glTranslate", "glRotate", "glScale", "glMultMatrix"}) {
            if (call.name.starts_with(name))
                return true;
        }
        for (const std::string_view member : {".rotation", ".quaternion"}) {
            if (call.object.ends_with(member))
                return isCamera(call.object.substr(0, call.object.size() - member.size()));
        }
        const bool isTurn = call.name.starts_with("rotate") || call.name.starts_with("translate");
        return isTurn && !call.object.empty() && isCamera(call.object);
    }

    bool isCamera(const std::string &object) const
    {
        if (!m_camera.empty())
            return object == m_camera;
        return base::lowerCase(object).find("cam") != std::string::npos;
    }

    /// Reads the assignments to single members of the camera before a position: camera.position.z =
    /// 5.
    void readAssignments(std::size_t end)
    {
        for (; m_nextAssignment < m_assignments.size() && m_assignments[m_nextAssignment].at < end;
             ++m_nextAssignment) {
            const AssignmentText &one = m_assignments[m_nextAssignment];
            const std::size_t dot = one.name.rfind('.');
            if (dot == one.name.npos)
                continue;
            std::string object = one.name.substr(0, dot);
            const std::string member = one.name.substr(dot + 1);
            constexpr std::string_view kPosition = ".position", kAxes = "xyz";
            if (object.ends_with(kPosition) && member.size() == 1 && kAxes.find(member) != kAxes.npos) {
                object.resize(object.size() - kPosition.size());
                if (isCamera(object))
                    move(one, object, int(kAxes.find(member)));
            } else if (isCamera(object) && m_read.parts.projection && isOfLens(member)) {
                m_read.parts.projection->call += tr(". %1 is ignored: put its value into the call", one.name);
            }
        }
    }

    static bool isOfLens(const std::string &member)
    {
        return member == "fov" || member == "aspect" || member == "near" || member == "far" || member == "zoom";
    }

    void move(const AssignmentText &to, const std::string &object, int axis)
    {
        const double value = number(to.name, to.value).value;
        m_three.name = object;
        m_three.position[axis] = value;
    }

    std::string_view m_program;
    std::string m_text;
    ArgumentReader m_arguments;
    std::vector<AssignmentText> m_assignments;
    std::size_t m_nextAssignment = 0;
    std::string m_rest;
    PastedCalls m_read;
    ArgumentNumber m_wholeQuotient;     ///< of the current call
    std::vector<std::string> m_leftOut; ///< names of calls that change the view
    std::string m_camera;               ///< the variable that holds the three.js camera

    /// A three.js camera. lookAt turns it at its current position; moved later, it keeps its
    /// direction.
    struct ThreeCamera {
        std::string name; ///< empty until a call moves it
        glm::dvec3 position{0.0}, up{0.0, 1.0, 0.0};
        glm::dvec3 direction{0.0, 0.0, -1.0}, upThen{0.0, 1.0, 0.0};
    };
    ThreeCamera m_three;
};

} // namespace

Result<PastedCalls, PasteError> pastedCalls(std::string_view text)
{
    constexpr std::size_t kLongest = 100'000; // too long for a text of a few calls
    if (text.size() > kLongest)
        return PastedCalls();
    try {
        return Reader(text).read();
    } catch (PasteError &error) {
        return std::move(error);
    }
}

} // namespace unprojector::cameras
