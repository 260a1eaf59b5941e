#include "core/cameras/pasted_calls.h"

#include "core/base/expression.h"
#include "core/base/number_text.h"
#include "core/base/source_text.h"
#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/known_calls.h"
#include "core/geometry/camera.h"
#include "core/geometry/error_text.h"
#include "core/geometry/numbers.h"
#include "core/geometry/projection.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using namespace base;

namespace {

/// The arguments of a call by their parameters. A number is x of its vector.
using Values = std::map<std::string_view, glm::dvec3>;

std::string numberText(double value)
{
    constexpr int kDigits = 5;
    return significantText(value, kDigits);
}

std::string vectorText(const glm::dvec3 &v)
{
    return '(' + numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z) + ')';
}

PastedMatrix pastedOf(const glm::dmat4 &matrix, std::string said)
{
    PastedMatrix pasted;
    pasted.form = MatrixForm::Call;
    for (int i = 0; i < 16; ++i)
        pasted.numbers[std::size_t(i)] = matrix[i / 4][i % 4] + 0.0;
    pasted.call = std::move(said);
    return pasted;
}

/// Fails for a parameter that no projection or view has.
[[noreturn]] void fail(const SourceCall &call, const geometry::Error &error)
{
    failCall(std::string(call.written) + ": " + errorText(error));
}

/// The matrix of glFrustum or glOrtho, with NDC depths in [0, 1] or an eye that looks along +z if
/// the library has these. Near may lie behind far, as in reversed depth.
glm::dmat4 clipFromEye(const Ortho &v, const KnownCall &known, const SourceCall &call)
{
    const double n = v.nearDistance, f = v.farDistance, width = v.right - v.left, height = v.top - v.bottom;
    const bool isPerspective = known.kind == CallKind::Perspective;
    if (isPerspective && std::min(n, f) <= 0.0)
        fail(call, {ErrorCode::NearNotPositive, std::min(n, f), std::max(n, f)});
    if (v.left == v.right)
        fail(call, {ErrorCode::LeftEqualsRight, v.left});
    if (v.bottom == v.top)
        fail(call, {ErrorCode::BottomEqualsTop, v.bottom});
    if (n == f)
        fail(call, {ErrorCode::NearNotBeforeFar, n, f});
    const bool isZeroToOne = known.ndcDepth == NdcDepth::ZeroToOne;
    const double depths = isZeroToOne ? 1.0 : 2.0, x = (v.right + v.left) / width, y = (v.top + v.bottom) / height;
    glm::dmat4 m(0.0);
    if (isPerspective) {
        m[0][0] = 2.0 * n / width;
        m[1][1] = 2.0 * n / height;
        m[2] = {x, y, -(isZeroToOne ? f : f + n) / (f - n), -1.0};
        m[3][2] = -depths * f * n / (f - n);
    } else {
        m[0][0] = 2.0 / width;
        m[1][1] = 2.0 / height;
        m[2][2] = -depths / (f - n);
        m[3] = {-x, -y, -(isZeroToOne ? n : f + n) / (f - n), 1.0};
    }
    if (known.isLeftHanded)
        m[2] = -m[2];
    return m;
}

class Reader {
public:
    Reader(std::string_view text, const std::optional<double> &aspect)
        : m_aspect(aspect), m_program(text), m_text(withoutComments(text)), m_calls(sourceCalls(m_text)), m_rest(m_text)
    {
    }

    PastedCalls read()
    {
        if (std::ranges::none_of(m_calls, [this](const SourceCall &call) {
                return knownCall(call, m_program) || (!call.isAssignment && !movedCamera(call).empty());
            }))
            return {};
        std::vector<std::string_view> leftOut; // calls that change the view
        for (const SourceCall &call : m_calls) {
            const std::optional<KnownCall> known = knownCall(call, m_program);
            if (known && std::string_view(m_text).substr(0, call.at).ends_with("inverse("))
                failCall(tr("%1: the text takes its inverse. Give the numbers of the matrix", call.written));
            if (known)
                readKnown(call, *known);
            else if (const std::string_view camera = movedCamera(call); !camera.empty())
                readMove(call, camera);
            if (call.isAssignment)
                readLens(call);
            else if (isLeftOut(call) && std::ranges::find(leftOut, call.written) == leftOut.end())
                leftOut.push_back(call.written);
        }
        if (!m_parts.viewport && m_window && !m_aspect) // a given size counts
            m_parts.viewport = m_window;
        else if (!m_parts.viewport && m_viewportError && !m_aspect)
            throw *m_viewportError;
        std::string dense = m_text;
        std::erase(dense, ' ');
        if (m_parts.projection && dense.find("[1][1]*=-1") != dense.npos)
            m_parts.projection->call += tr(". %1 is ignored: the picture is the same", "[1][1] *= -1");
        if (!m_three.name.empty())
            setView({m_three.name}, {{CallKind::View, {}}, {}},
                    {WorldPoint(m_three.position), WorldPoint(m_three.position + m_three.direction),
                     WorldVector(m_three.upThen)});
        for (const std::string_view one : leftOut) {
            if (m_parts.view)
                m_parts.view->call += tr(". %1 is ignored: the view is read without it", one);
        }
        for (const SourceCall &one : m_calls) { // width = 800 is no number of a matrix
            if (one.isAssignment && number(one.arguments[0]))
                blank(one);
        }
        return {true, m_parts, m_rest};
    }

private:
    void blank(const SourceCall &call) { m_rest.replace(call.at, call.end - call.at, call.end - call.at, ' '); }

    /// The value of a variable that has exactly one in the text.
    std::optional<std::string_view> assigned(std::string_view name) const
    {
        std::optional<std::string_view> value;
        for (const SourceCall &one : m_calls) {
            if (!one.isAssignment || one.written != name)
                continue;
            if (value && *value != one.arguments[0]) // only the program knows which value applies
                return std::nullopt;
            value = one.arguments[0];
        }
        return value;
    }

    std::optional<SourceNumber> number(std::string_view text) const
    {
        return sourceNumber(text, [this](std::string_view name) { return assigned(name); });
    }

    double number(const SourceCall &call, std::string_view argument)
    {
        const std::optional<SourceNumber> read = number(argument);
        if (!read)
            failCall(tr("%1: the argument '%2' is not a number. Put its value there", call.written, argument));
        if (!read->wholeQuotient.empty())
            m_wholeQuotient = *read;
        return read->value;
    }

    /// A vector of three numbers: "glm::vec3(0, 0, 5)", "{0, 0, 5}", "-Vector3.UnitY", a variable.
    std::optional<glm::dvec3> vector(std::string_view text) const
    {
        constexpr std::pair<std::string_view, glm::dvec3> kVectors[] = {{" unitx ", {1.0, 0.0, 0.0}},
                                                                        {" unity up ", {0.0, 1.0, 0.0}},
                                                                        {" unitz ", {0.0, 0.0, 1.0}},
                                                                        {" zero ", {0.0, 0.0, 0.0}},
                                                                        {" one ", {1.0, 1.0, 1.0}}};
        constexpr int kMostMarks = 16; // a variable may refer to itself
        double sign = 1.0;
        text = trimmed(text);
        for (int mark = 0; mark < kMostMarks; ++mark) {
            if (text.starts_with("new ") || text.starts_with('&') || text.starts_with('-')) { // D3DX takes pointers
                sign = text.front() == '-' ? -sign : sign;
                text = trimmed(text.substr(text.front() == 'n' ? 4 : 1));
                continue;
            }
            const std::string_view names = namesAt(text, 0);
            const std::size_t open = behindBlanks(text, behindTemplate(text, names.size()));
            if (open < text.size()) {
                if (closingBracket(text, open) != text.size() - 1)
                    break;
                const auto parts = commaSeparated(text.substr(open + 1, text.size() - open - 2));
                if (parts.size() == 2 || parts.size() > 4)
                    break;
                glm::dvec3 result(0.0);
                for (std::size_t i = 0; i < 3 && !parts.empty(); ++i) {
                    // glm::vec3(1.0f) repeats its number
                    const std::optional<SourceNumber> value = number(parts[std::min(i, parts.size() - 1)]);
                    if (!value)
                        return std::nullopt;
                    result[int(i)] = sign * value->value;
                }
                return result;
            }
            for (const auto &[known, value] : kVectors) {
                if (isListed(known, plainName(names)))
                    return sign * value;
            }
            const std::optional<std::string_view> value = assigned(names);
            if (!value)
                break;
            text = trimmed(*value);
        }
        return std::nullopt;
    }

    glm::dvec3 vector(const SourceCall &call, std::string_view argument) const
    {
        const std::optional<glm::dvec3> value = vector(argument);
        if (!value)
            failCall(tr("%1: the argument '%2' is not a vector of numbers. Put three numbers there", call.written,
                        argument));
        return *value;
    }

    /// Reads a call. A viewport of a resized window, glViewport(0, 0, w, h), counts only where no other call has
    /// numbers.
    void readKnown(const SourceCall &call, const KnownCall &known)
    {
        if (known.kind != CallKind::Viewport && known.kind != CallKind::Window)
            return readCall(call, known);
        try {
            readCall(call, known);
        } catch (const PasteError &error) {
            if (!m_viewportError)
                m_viewportError = error;
        }
    }

    void readCall(const SourceCall &call, const KnownCall &known)
    {
        blank(call);
        m_wholeQuotient = {};
        // gluOrtho2D has no clip distances.
        Values values{{"near", glm::dvec3(-1.0)}, {"far", glm::dvec3(1.0)}};
        std::string said;
        for (const CallArgument &one : callArguments(call, known)) {
            const bool isOfSize = one.parameter == "aspect" && m_aspect && !number(one.text);
            if (isOfSize)
                said = tr(". The aspect %1 is that of the size", one.text);
            values[one.parameter] = isOfSize       ? glm::dvec3(*m_aspect)
                                    : one.isVector ? vector(call, one.text)
                                                   : glm::dvec3(number(call, one.text));
        }
        if (call.name.ends_with("Camera")) {
            m_camera = call.variable;
            if (!m_parts.projection)
                m_lens = Lens{call, known, values};
        }
        if (known.kind == CallKind::View)
            return readView(call, known, values);
        if (known.kind == CallKind::Perspective || known.kind == CallKind::Orthographic)
            return readProjection(call, known, values, said);
        const Viewport viewport{values["x"].x, values["y"].x, values["width"].x, values["height"].x};
        if (const Check valid = check(viewport); !valid && !m_parts.viewport)
            fail(call, valid.error());
        std::optional<Viewport> &taken = known.kind == CallKind::Window ? m_window : m_parts.viewport;
        taken = taken.value_or(viewport);
    }

    /// @param more  what to say behind the arguments
    void readProjection(const SourceCall &call, const KnownCall &known, Values &v, const std::string &more)
    {
        std::string said;
        const glm::dmat4 matrix = clipFromEye(volumeOf(call, known, v, said), known, call);
        said += more;
        if (m_parts.projection) {
            m_parts.projection->call += tr(". %1 follows and is ignored: one projection is read", call.written);
            return;
        }
        const bool isZeroToOne = known.ndcDepth == NdcDepth::ZeroToOne;
        if (known.isLeftHanded)
            said += isZeroToOne ? tr("; left-handed, NDC depths from 0 to 1")
                                : tr("; left-handed, NDC depths from -1 to 1");
        else if (isZeroToOne)
            said += tr("; right-handed, NDC depths from 0 to 1");
        if (known.dropsRest && !m_wholeQuotient.wholeQuotient.empty())
            said += tr(". %1 is read as %2; in C, C++ and C# it is %3, as long as no number of it has a point",
                       m_wholeQuotient.wholeQuotient, numberText(m_wholeQuotient.value),
                       numberText(std::trunc(m_wholeQuotient.value)));
        m_parts.projection = pastedOf(matrix, std::move(said));
        m_parts.projection->ndcDepth = known.ndcDepth;
    }

    static Ortho volumeOf(const SourceCall &call, const KnownCall &known, Values &v, std::string &said)
    {
        const double nearDistance = v["near"].x, farDistance = v["far"].x, width = v["width"].x, height = v["height"].x;
        if (!v.contains("fov")) {
            const Ortho volume =
                v.contains("left")
                    ? Ortho{v["left"].x, v["right"].x, v["bottom"].x, v["top"].x, nearDistance, farDistance}
                    : Ortho{-width / 2.0, width / 2.0, -height / 2.0, height / 2.0, nearDistance, farDistance};
            said = tr("%1: left %2, right %3, bottom %4, top %5, near %6, far %7", call.written,
                      numberText(volume.left), numberText(volume.right), numberText(volume.bottom),
                      numberText(volume.top), numberText(nearDistance), numberText(farDistance));
            return volume;
        }
        const bool areDegrees = known.areDegrees;
        const double angle = v["fov"].x, aspect = v.contains("aspect") ? v["aspect"].x : width / height;
        const Perspective lens{areDegrees ? Angle::fromDegrees(angle) : Angle(angle), aspect, nearDistance,
                               farDistance};
        if (!areDegrees && angle >= kPi)
            failCall(tr("%1: the angle is in radians and must be smaller than pi. You entered %2", call.written,
                        numberText(angle)));
        if (const double fov = lens.verticalFov.radians.value; !(fov > 0.0 && fov < kPi))
            fail(call, {ErrorCode::FieldOfViewOutOfRange, fov});
        if (!(std::abs(aspect) > 0.0) || !std::isfinite(aspect))
            fail(call, {ErrorCode::AspectNotPositive, aspect});
        said = tr("%1: fovy %2°, aspect %3, near %4, far %5", call.written, numberText(lens.verticalFov.degrees()),
                  numberText(aspect), numberText(nearDistance), numberText(farDistance));
        if (areDegrees && angle < kPi)
            said += tr(". The angle is in degrees: %1 would be %2° if it were in radians", numberText(angle),
                       numberText(degreesFromRadians(angle)));
        const Frustum f = frustumFromPerspective(lens);
        return {f.left, f.right, f.bottom, f.top, f.nearDistance, f.farDistance};
    }

    void readView(const SourceCall &call, const KnownCall &known, Values &v)
    {
        if (v.contains("eyex")) {
            for (const char *point : {"eye", "center", "up"}) {
                const std::string name = point;
                v[point] = {v.at(name + 'x').x, v.at(name + 'y').x, v.at(name + 'z').x};
            }
        }
        const glm::dvec3 center = v.contains("direction") ? v["eye"] + v["direction"] : v["center"];
        setView(call, known, {WorldPoint(v["eye"]), WorldPoint(center), WorldVector(v["up"])});
    }

    /// Sets the matrix of gluLookAt. A left-handed eye looks along +z: it is rotated by 180 degrees
    /// about its y axis.
    void setView(const SourceCall &call, const KnownCall &known, const LookAt &camera)
    {
        const Result<EyeFrame> frame = eyeFrame(camera);
        if (!frame)
            fail(call, frame.error());
        if (m_parts.view) {
            m_parts.view->call += tr(". %1 follows and is ignored: one view is read", call.written);
            return;
        }
        std::string said = tr("%1: eye %2, center %3, up %4", call.written, vectorText(camera.eye.coordinates()),
                              vectorText(camera.center.coordinates()), vectorText(camera.up.coordinates()));
        glm::dmat4 matrix = eyeFromWorld(*frame);
        if (known.isLeftHanded) {
            said += tr("; left-handed");
            for (int column = 0; column < 4; ++column) {
                matrix[column][0] = -matrix[column][0];
                matrix[column][2] = -matrix[column][2];
            }
        }
        m_parts.view = pastedOf(matrix, std::move(said));
    }

    /// The camera that three.js moves or turns, by camera.position.set, camera.position.z =, the
    /// same of up, or camera.lookAt: the one that the text creates, or a variable with its name.
    /// Empty for other calls.
    std::string_view movedCamera(const SourceCall &call) const
    {
        const std::string_view name = call.name, member = lastName(call.object);
        const bool isSet = call.isAssignment ? isListed(" x y z ", name) : name == "set";
        std::string_view camera;
        if (!call.isAssignment && name == "lookAt")
            camera = call.object;
        else if (isSet && (member == "position" || member == "up"))
            camera = namesBefore(call.object);
        return isCamera(camera) ? camera : std::string_view();
    }

    void readMove(const SourceCall &call, std::string_view camera)
    {
        const bool isUp = lastName(call.object) == "up";
        glm::dvec3 &set = isUp ? m_three.up : m_three.position;
        if (!isUp)
            m_three.name = camera;
        if (call.isAssignment) {
            set[call.name[0] - 'x'] = number(call, call.arguments[0]);
            return;
        }
        blank(call);
        glm::dvec3 point(0.0);
        if (call.arguments.size() == 1)
            point = vector(call, call.arguments[0]);
        else if (call.arguments.size() != 3)
            failCount(call, call.arguments.size(), 3);
        for (int i = 0; i < 3 && call.arguments.size() == 3; ++i)
            point[i] = number(call, call.arguments[std::size_t(i)]);
        if (call.name == "set") {
            set = point;
        } else {
            m_three.direction = point - m_three.position;
            m_three.upThen = m_three.up;
        }
    }

    /// Takes camera.fov = 50 and the like of three.js. Those without a number are reported.
    void readLens(const SourceCall &call)
    {
        const bool isCount = isCamera(call.object) && isListed(" fov aspect near far ", call.name) && m_lens
                             && m_lens->values.contains(call.name) && number(call.arguments[0]);
        if (isCount) {
            m_lens->values[call.name] = glm::dvec3(number(call.arguments[0])->value);
            m_parts.projection.reset();
            readProjection(m_lens->call, m_lens->known, m_lens->values, {});
        } else if (m_parts.projection && isCamera(call.object) && isListed(" fov aspect near far zoom ", call.name))
            m_parts.projection->call += tr(". %1 is ignored: put its value into the call", call.written);
    }

    /// Returns whether a call turns or moves the view, or an object in it, in an unsupported way.
    bool isLeftOut(const SourceCall &call) const
    {
        const std::string_view name = call.name, member = lastName(call.object);
        for (const std::string_view one : {"glTranslate", "glRotate", "glScale", "glMultMatrix"}) {
            if (name.starts_with(one))
                return true;
        }
        if (member == "rotation" || member == "quaternion")
            return isCamera(namesBefore(call.object));
        return (name.starts_with("rotate") || name.starts_with("translate")) && isCamera(call.object);
    }

    bool isCamera(std::string_view object) const
    {
        return m_camera.empty() ? lowerCase(object).find("cam") != std::string::npos
                                : lastName(object) == lastName(m_camera); // this.camera
    }

    /// A three.js camera, whose members the text may set.
    struct Lens {
        SourceCall call;
        KnownCall known;
        Values values;
    };
    std::optional<Lens> m_lens;
    std::optional<double> m_aspect; ///< of the size
    std::string_view m_program;
    std::string m_text;
    std::vector<SourceCall> m_calls;
    std::string m_rest; ///< the text without what is read
    PastedScene m_parts;
    std::optional<Viewport> m_window;
    std::optional<PasteError> m_viewportError;
    SourceNumber m_wholeQuotient; ///< of the current call
    std::string_view m_camera;    ///< the variable that holds the three.js camera

    /// A three.js camera. lookAt turns it at its current position; moved later, it keeps its
    /// direction.
    struct ThreeCamera {
        std::string_view name; ///< empty until a call moves it
        glm::dvec3 position{0.0}, up{0.0, 1.0, 0.0};
        glm::dvec3 direction{0.0, 0.0, -1.0}, upThen{0.0, 1.0, 0.0};
    };
    ThreeCamera m_three;
};

} // namespace

Result<PastedCalls, PasteError> pastedCalls(std::string_view text, const std::optional<double> &aspect)
{
    constexpr std::size_t kLongest = 100'000; // too long for a text of a few calls
    if (text.size() > kLongest)
        return PastedCalls();
    try {
        return Reader(text, aspect).read();
    } catch (PasteError &error) {
        return std::move(error);
    }
}

} // namespace unprojector::cameras
