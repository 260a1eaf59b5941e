#include "core/scene_file/scene_error_text.h"

#include "core/geometry/angle.h"
#include "core/text/error_text.h"
#include "core/text/number_text.h"

#include <cmath>

namespace unprojector::scene_file {
using namespace geometry;
using namespace text;
namespace {

std::string bytesText(double bytes)
{
    return shortestText(bytes / (1 << 20)) + " MiB";
}

const char *kindText(JsonKind kind)
{
    switch (kind) {
    case JsonKind::Null: return "null";
    case JsonKind::Boolean: return "true or false";
    case JsonKind::Number: return "a number";
    case JsonKind::Text: return "a text in quotes";
    case JsonKind::Array: return "a list in [ ]";
    case JsonKind::Object: return "an object in { }";
    case JsonKind::TwoNumbers: return "a list of 2 numbers";
    case JsonKind::ThreeNumbers: return "a list of 3 numbers";
    case JsonKind::FourNumbers: return "a list of 4 numbers";
    case JsonKind::Matrix: return "a list of 16 numbers, column by column";
    }
    return "";
}

std::string choicesText(const std::vector<std::string> &choices)
{
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i)
        list += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
    return list;
}

std::string withDetail(const std::string &sentence, const std::string &detail)
{
    return detail.empty() ? sentence : sentence + " (" + detail + ")";
}

/// Of a value under its key: the value comes first, the key is named before.
std::string causeText(const Error &error)
{
    const std::string value = shortestText(error.value), other = shortestText(error.other);
    switch (error.code) {
    case ErrorCode::NotFinite: return value + " is not a finite number";
    case ErrorCode::NearNotPositive: return value + " must be greater than 0";
    case ErrorCode::NearNotBeforeFar: return value + " must be smaller than far (" + other + ")";
    case ErrorCode::LeftEqualsRight: return value + " must differ from right";
    case ErrorCode::BottomEqualsTop: return value + " must differ from top";
    case ErrorCode::FieldOfViewOutOfRange:
    case ErrorCode::ShearAngleOutOfRange:
        return shortestText(degreesFromRadians(error.value)) + " must lie between 0 and 180 degrees, both excluded";
    case ErrorCode::AspectNotPositive:
    case ErrorCode::PixelRatioNotPositive: return value + " must be greater than 0";
    case ErrorCode::EyeEqualsCenter: return "must be another point than the eye";
    case ErrorCode::UpIsZero:
    case ErrorCode::RotationAxisIsZero: return "the axis (0, 0, 0) has no direction";
    case ErrorCode::UpParallelToView: return "must not point along the view direction";
    case ErrorCode::EmptyViewport:
    case ErrorCode::EmptyFramebuffer:
        return "the size " + value + " x " + other + " is empty; width and height must be greater than 0";
    case ErrorCode::EmptyDepthRange: return "both ends are " + value + "; they must differ";
    case ErrorCode::DepthOutsideRange: return value + " lies outside the depth range";
    case ErrorCode::OutsideFramebuffer: return "(" + value + ", " + other + ") lies outside the window";
    case ErrorCode::ViewportNotWhole:
    case ErrorCode::ViewportTooLarge:
    case ErrorCode::FramebufferTooLarge:
    case ErrorCode::DepthRangeNotDrawable:
    case ErrorCode::ObjectTooFar:
    case ErrorCode::ObjectTooSmall: return errorText(error); // of showing, not of the file
    case ErrorCode::SingularMatrix: return "the matrix has no inverse";
    case ErrorCode::PointAtInfinity: return "the point lies at infinity";
    case ErrorCode::ScaleIsZero: return "a factor is 0; it must differ from 0";
    case ErrorCode::MatrixNotAProjection: return "the entry " + value + " fits no projection of a known form";
    case ErrorCode::ViewNotRigid: return viewFault(error);
    case ErrorCode::ViewMirrored: return "the axes are left-handed; negate one of the first three rows";
    case ErrorCode::ClipPlaneHasNoNormal: return "the first three numbers are all 0; one of them must differ from 0";
    }
    return {};
}

std::string sentence(const SceneFileError &e)
{
    switch (e.code) {
    case SceneFileErrorCode::NotFound: return "there is no such file";
    case SceneFileErrorCode::IsDirectory: return "this is a folder, not a scene file";
    case SceneFileErrorCode::NotReadable: return withDetail("the file cannot be read", e.detail);
    case SceneFileErrorCode::NotAFile: return "this is a pipe or a device, not a scene file";
    case SceneFileErrorCode::NotWritable: return e.detail;
    case SceneFileErrorCode::ChangedMeanwhile:
        return "the file was changed by another program or window since it was opened";
    case SceneFileErrorCode::IsOwnModel:
        return "the scene shows this model and would be written over it; give another name";
    case SceneFileErrorCode::EmptyFile: return "the file is empty";
    case SceneFileErrorCode::TooLarge: return "a scene may have at most " + bytesText(e.limit);
    case SceneFileErrorCode::Syntax: return e.detail;
    case SceneFileErrorCode::NumberTooLarge: return e.found + " is too large for a number";
    case SceneFileErrorCode::TooDeep: return "brackets are nested deeper than " + shortestText(e.limit) + " levels";
    case SceneFileErrorCode::DuplicateKey: return "the key \"" + e.found + "\" stands here for the second time";
    case SceneFileErrorCode::UnknownVersion:
        return "version " + shortestText(e.value) + " cannot be read, only version " + shortestText(e.limit);
    case SceneFileErrorCode::Missing: return "is missing";
    case SceneFileErrorCode::WrongType:
        return "expected " + std::string(kindText(e.expectedKind)) + ", found "
               + (e.found.empty() ? kindText(e.foundKind) : "\"" + e.found + "\"");
    case SceneFileErrorCode::NotWhole: return shortestText(e.value) + " must be a whole number";
    case SceneFileErrorCode::OutOfRange:
        return shortestText(e.value) + " must lie between " + shortestText(e.lowest) + " and " + shortestText(e.limit);
    case SceneFileErrorCode::WrongCount:
        return "has " + shortestText(e.value) + " elements; it must have " + shortestText(e.limit);
    case SceneFileErrorCode::TooMany:
        return "has " + shortestText(e.value) + " elements; there may be at most " + shortestText(e.limit);
    case SceneFileErrorCode::UnknownChoice:
        return (e.foundKind == JsonKind::Array ? e.found : "\"" + e.found + "\"") + " must be "
               + choicesText(e.choices);
    case SceneFileErrorCode::NotOneChoice: return "must have exactly one of " + choicesText(e.choices);
    case SceneFileErrorCode::OtherAngle:
        return shortestText(e.value) + " is not the angle of " + e.found + ", " + shortestText(e.limit)
               + " degrees; remove the one that does not hold";
    case SceneFileErrorCode::BadFileName: return "this is no name of a file";
    case SceneFileErrorCode::NotUtf8: return "the name is not UTF-8 and cannot be written; rename it";
    case SceneFileErrorCode::InvalidValue: return e.cause ? causeText(*e.cause) : std::string();
    }
    return {};
}

} // namespace

std::string sceneErrorText(const SceneFileError &error)
{
    std::string place = error.file;
    if (error.line > 0)
        place += ":" + std::to_string(error.line) + ":" + std::to_string(error.column);
    if (!error.keyPath.empty())
        place += ": " + error.keyPath;
    return place + ": " + sentence(error);
}

} // namespace unprojector::scene_file
