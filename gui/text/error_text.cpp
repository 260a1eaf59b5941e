#include "gui/text/error_text.h"

#include "core/geometry/angle.h"
#include "core/scene_file/scene_error_text.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QDir>
#include <QTextDocument>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
namespace {

struct Errors {
    Q_DECLARE_TR_FUNCTIONS(Errors)
};

QString degrees(double radians)
{
    return writtenText(degreesFromRadians(radians), 6);
}

/// @pre the error is ViewNotRigid
QString viewFault(const Error &error)
{
    const int column = static_cast<int>(error.other) / 4, row = static_cast<int>(error.other) % 4;
    if (row == 3)
        return Errors::tr("The view matrix does more than turn and move: %1 stands in row 4, column %2.")
            .arg(writtenText(error.value, 6))
            .arg(column + 1);
    if (row == column)
        return Errors::tr("The view matrix does more than turn and move: row %1 has the length %2, not 1.")
            .arg(row + 1)
            .arg(writtenText(std::sqrt(1.0 + error.value), 6));
    return Errors::tr("The view matrix does more than turn and move: rows %1 and %2 are not perpendicular.")
        .arg(row + 1)
        .arg(column + 1);
}

constexpr auto kModelSuffixes = "*.obj *.stl *.ply *.off *.gltf *.glb";

} // namespace

QString pathText(const std::filesystem::path &path)
{
#ifdef _WIN32
    return QDir::toNativeSeparators(QString::fromStdWString(path.wstring()));
#else
    return QString::fromLocal8Bit(path.string().c_str());
#endif
}

QString plainToolTip(const QString &text)
{
    return text.isEmpty() ? text : Qt::convertFromPlainText(text, Qt::WhiteSpaceNormal);
}

QString modelFileFilter()
{
    return Errors::tr("Models (%1)").arg(QLatin1String(kModelSuffixes));
}

QString openableFileFilter()
{
    return Errors::tr("Models and scenes (%1)").arg(QLatin1String(kModelSuffixes) + QStringLiteral(" *.json"));
}

QString errorText(const Error &error)
{
    const QString value = shortestText(error.value);
    // The number compared with comes from a computation as a rule: its last digits would only be noise, unless they are
    // what makes the difference.
    const QString rounded = writtenText(error.other, 7);
    const QString other = rounded.toDouble() == error.value ? shortestText(error.other) : rounded;
    switch (error.code) {
    case ErrorCode::NotFinite: return Errors::tr("%1 is not a finite number; give a number.").arg(value);
    case ErrorCode::NearNotPositive:
        return Errors::tr("Near is %1; it must be greater than 0 and smaller than far (%2).").arg(value, other);
    case ErrorCode::NearNotBeforeFar:
        return Errors::tr("Near is %1; it must be smaller than far (%2).").arg(value, other);
    case ErrorCode::LeftEqualsRight: return Errors::tr("Left and right are both %1; they must differ.").arg(value);
    case ErrorCode::BottomEqualsTop: return Errors::tr("Bottom and top are both %1; they must differ.").arg(value);
    case ErrorCode::FieldOfViewOutOfRange:
        return Errors::tr("The vertical field of view is %1°; it must lie between 0° and 180°, both excluded.")
            .arg(degrees(error.value));
    case ErrorCode::AspectNotPositive: return Errors::tr("The aspect is %1; it must be greater than 0.").arg(value);
    case ErrorCode::ShearAngleOutOfRange:
        return Errors::tr("The angle is %1°; it must lie between 0° and 180°, both excluded.")
            .arg(degrees(error.value));
    case ErrorCode::EyeEqualsCenter: return Errors::tr("Eye and center are the same point; move one of them.");
    case ErrorCode::UpIsZero: return Errors::tr("Up is (0, 0, 0); give it a length.");
    case ErrorCode::UpParallelToView: return Errors::tr("Up points along the view direction; choose another one.");
    case ErrorCode::EmptyViewport:
        return Errors::tr("The viewport is %1 × %2 pixels; width and height must be greater than 0.").arg(value, other);
    case ErrorCode::EmptyFramebuffer:
        return Errors::tr("The window is %1 × %2 pixels; width and height must be greater than 0.").arg(value, other);
    case ErrorCode::PixelRatioNotPositive:
        return Errors::tr("The device pixel ratio is %1; it must be greater than 0.").arg(value);
    case ErrorCode::EmptyDepthRange:
        return Errors::tr("Both ends of the depth range are %1; they must differ.").arg(value);
    case ErrorCode::DepthOutsideRange: return Errors::tr("The depth %1 lies outside the depth range.").arg(value);
    case ErrorCode::OutsideFramebuffer:
        return Errors::tr("The position (%1, %2) lies outside the view.").arg(value, other);
    case ErrorCode::ViewportNotWhole: return Errors::tr("%1 is not a whole number of pixels.").arg(value);
    case ErrorCode::ViewportTooLarge: return Errors::tr("%1 pixels are too many; use at most %2.").arg(value, other);
    case ErrorCode::FramebufferTooLarge:
        return Errors::tr("The window is %1 × %2 pixels, which is more than is drawn; make it smaller.")
            .arg(value, other);
    case ErrorCode::DepthRangeNotDrawable:
        return Errors::tr("The depth is %1; it must lie between 0 and 1.").arg(value);
    case ErrorCode::SingularMatrix: return Errors::tr("The matrix has no inverse.");
    case ErrorCode::PointAtInfinity: return Errors::tr("The point lies at infinity.");
    case ErrorCode::ScaleIsZero: return Errors::tr("The scale is 0; it must differ from 0.");
    case ErrorCode::RotationAxisIsZero: return Errors::tr("The rotation axis is (0, 0, 0); give it a length.");
    case ErrorCode::MatrixNotAProjection:
        return Errors::tr("The projection matrix is of no known form: %1 stands in row %2, column %3.")
            .arg(value)
            .arg(static_cast<int>(error.other) % 4 + 1)
            .arg(static_cast<int>(error.other) / 4 + 1);
    case ErrorCode::ObjectTooFar:
        return Errors::tr("An object reaches to %1, farther than can be computed. Look at its scales and "
                          "translations.")
            .arg(value);
    case ErrorCode::ObjectTooSmall:
        return Errors::tr("An object measures %1, less than can be computed. Look at its scales.").arg(value);
    case ErrorCode::ViewNotRigid: return viewFault(error);
    case ErrorCode::ViewMirrored:
        return Errors::tr("The view matrix is mirrored: its axes are left-handed. Negate one of its first three rows.");
    case ErrorCode::ClipPlaneHasNoNormal:
        return Errors::tr("A, B and C of the clip plane are all 0; one of them must differ.");
    }
    Q_UNREACHABLE();
}

QString errorText(const scene_file::SceneFileError &error)
{
    if (!error.cause)
        return QString::fromStdString(sceneErrorText(error));
    return QStringLiteral("%1: %2: %3")
        .arg(QString::fromStdString(error.file), QString::fromStdString(error.keyPath), errorText(*error.cause));
}

QString errorText(const text::ExpressionError &error, const QString &typed)
{
    constexpr int kMostShownCharacters = 24;
    const std::string bytes = typed.toStdString();
    const QString part = QString::fromStdString(bytes.substr(error.place, error.length));
    const auto place = QString::fromStdString(bytes.substr(0, error.place)).size() + 1;
    const auto shortened = [](const QString &text) {
        return text.size() > kMostShownCharacters ? text.left(kMostShownCharacters) + u'…' : text;
    };
    const QString all = shortened(typed.trimmed());
    using Code = text::ExpressionErrorCode;
    switch (error.code) {
    case Code::Empty: return Errors::tr("There is no number; type one.");
    case Code::MissingNumber:
        return part.isEmpty() ? Errors::tr("“%1” ends where a number is wanted.").arg(all)
                              : Errors::tr("“%1”: a number is wanted before “%2” (character %3).")
                                    .arg(all, shortened(part))
                                    .arg(place);
    case Code::MissingOperator:
        return Errors::tr("“%1”: a sign such as * or + is missing before “%2” (character %3).")
            .arg(all, shortened(part))
            .arg(place);
    case Code::AmbiguousComma:
        return Errors::tr("“%1” can be read in two ways: type %2 or %3.")
            .arg(all, QString(typed).remove(u',').trimmed(), QString(typed).replace(u',', u'.').trimmed());
    case Code::SecondPoint:
        return Errors::tr("“%1” has a second decimal point (character %2); write thousands without a comma.")
            .arg(all)
            .arg(place);
    case Code::UnknownName:
        return Errors::tr("“%1” is not a number; type one such as 0.5, 1e-3, 1/3 or 2*pi.").arg(shortened(part));
    case Code::UnknownCharacter:
        return Errors::tr("“%1”: “%2” (character %3) means nothing here; + - * / and parentheses do.")
            .arg(all, part)
            .arg(place);
    case Code::NotCalled: return Errors::tr("%1 wants its number in parentheses: %1(2).").arg(part);
    case Code::UnclosedParenthesis:
        return Errors::tr("“%1”: the parenthesis at character %2 is not closed.").arg(all).arg(place);
    case Code::UnopenedParenthesis:
        return Errors::tr("“%1”: the parenthesis at character %2 was never opened.").arg(all).arg(place);
    case Code::DivisionByZero: return Errors::tr("“%1” divides by 0 (character %2).").arg(all).arg(place);
    case Code::RootOfNegative: return Errors::tr("“%1” takes the root of a negative number.").arg(all);
    case Code::OutOfRange: return Errors::tr("%1 is too large or too small for a number here.").arg(shortened(part));
    case Code::TooDeep: return Errors::tr("“%1” has too many parentheses inside each other.").arg(all);
    }
    Q_UNREACHABLE();
}

QString errorText(const ImportError &error)
{
    const QString file = pathText(error.file);
    const QString detail = QString::fromStdString(error.detail);
    switch (error.code) {
    case ImportErrorCode::NotFound: return Errors::tr("%1 does not exist. Check the name and the folder.").arg(file);
    case ImportErrorCode::IsDirectory: return Errors::tr("%1 is a folder; open a model file in it.").arg(file);
    case ImportErrorCode::NotReadable:
        return Errors::tr("%1 cannot be read%2. Check its permissions.")
            .arg(file, detail.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(detail));
    case ImportErrorCode::EmptyFile: return Errors::tr("%1 is empty (0 bytes).").arg(file);
    case ImportErrorCode::UnknownFormat:
        return Errors::tr("%1 is no model that can be opened here%2. Use OBJ, STL, PLY, OFF, glTF or GLB.")
            .arg(file, detail.isEmpty() ? QString() : QStringLiteral(" (%1)").arg(detail));
    case ImportErrorCode::Malformed: return Errors::tr("%1 is damaged: %2").arg(file, detail);
    case ImportErrorCode::Unsupported: return Errors::tr("%1 cannot be shown: %2").arg(file, detail);
    case ImportErrorCode::NoTriangles:
        if (!detail.isEmpty())
            return Errors::tr("%1 cannot be shown: %2").arg(file, detail);
        return Errors::tr("%1 holds no triangles, so there is no surface to click on.").arg(file);
    case ImportErrorCode::NotFinite:
        return Errors::tr("%1: vertex %2 is NaN, infinite, or beyond 3.4e38%3.")
            .arg(file, QString::number(error.index), detail.isEmpty() ? QString() : QStringLiteral(": ") + detail);
    case ImportErrorCode::Cancelled: return Errors::tr("Opening %1 was cancelled.").arg(file);
    case ImportErrorCode::OutOfMemory: return Errors::tr("%1 is too large for the memory of this computer.").arg(file);
    }
    Q_UNREACHABLE();
}

} // namespace unprojector::gui
