#include "core/scene_file/scene_error_text.h"

#include "core/base/number_text.h"
#include "core/base/translation.h"
#include "core/geometry/error_text.h"

namespace unprojector::scene_file {
using namespace geometry;
using namespace base;
namespace {

std::string bytesText(double bytes)
{
    return tr("%1 MiB", shortestText(bytes / (1 << 20)));
}

std::string kindText(JsonKind kind)
{
    switch (kind) {
    case JsonKind::Null: return "null";
    case JsonKind::Boolean: return tr("true or false");
    case JsonKind::Number: return tr("a number");
    case JsonKind::Text: return tr("a text in quotes");
    case JsonKind::Array: return tr("a list in [ ]");
    case JsonKind::Object: return tr("an object in { }");
    case JsonKind::TwoNumbers: return tr("a list of 2 numbers");
    case JsonKind::ThreeNumbers: return tr("a list of 3 numbers");
    case JsonKind::FourNumbers: return tr("a list of 4 numbers");
    case JsonKind::Matrix: return tr("a list of 16 numbers, column by column");
    }
    return {};
}

std::string choicesText(const std::vector<std::string> &choices)
{
    std::string list;
    for (std::size_t i = 0; i < choices.size(); ++i)
        list = i == 0                    ? choices[i]
               : i + 1 == choices.size() ? tr("%1 or %2", list, choices[i])
                                         : list + ", " + choices[i];
    return list;
}

std::string withDetail(const std::string &sentence, const std::string &detail)
{
    return detail.empty() ? sentence : sentence + tr(" (%1)", detail);
}

std::string sentence(const SceneFileError &e)
{
    switch (e.code) {
    case SceneFileErrorCode::NotFound: return tr("there is no such file");
    case SceneFileErrorCode::IsDirectory: return tr("this is a folder, not a scene file");
    case SceneFileErrorCode::NotReadable: return withDetail(tr("the file cannot be read"), e.detail);
    case SceneFileErrorCode::NotAFile: return tr("this is a pipe or a device, not a scene file");
    case SceneFileErrorCode::NotWritable:
    case SceneFileErrorCode::Syntax: return e.detail;
    case SceneFileErrorCode::ChangedMeanwhile:
        return tr("the file was changed by another program or window since it was opened");
    case SceneFileErrorCode::IsOwnModel:
        return tr("the scene shows this model and would overwrite it; give another name");
    case SceneFileErrorCode::EmptyFile: return tr("the file is empty");
    case SceneFileErrorCode::TooLarge:
        return tr("a scene may have at most %1; keep the landmarks in a file of their own (File > Export Landmarks), "
                  "then remove them from the scene",
                  bytesText(e.limit));
    case SceneFileErrorCode::NumberTooLarge: return tr("%1 is too large for a number", e.found);
    case SceneFileErrorCode::TooDeep: return tr("brackets are nested deeper than %1 levels", shortestText(e.limit));
    case SceneFileErrorCode::DuplicateKey: return tr("the key \"%1\" is here for the second time", e.found);
    case SceneFileErrorCode::UnknownVersion:
        return tr("version %1 cannot be read, only version %2", shortestText(e.value), shortestText(e.limit));
    case SceneFileErrorCode::Missing: return tr("is missing");
    case SceneFileErrorCode::WrongType:
        return tr("expected %1, found %2", kindText(e.expectedKind),
                  e.found.empty() ? kindText(e.foundKind) : tr("\"%1\"", e.found));
    case SceneFileErrorCode::NotWhole: return tr("%1 must be a whole number", shortestText(e.value));
    case SceneFileErrorCode::OutOfRange:
        return tr("%1 must lie between %2 and %3", shortestText(e.value), shortestText(e.lowest),
                  shortestText(e.limit));
    case SceneFileErrorCode::WrongCount:
        return tr("has %1 elements; it must have %2", shortestText(e.value), shortestText(e.limit));
    case SceneFileErrorCode::TooMany:
        return tr("has %1 elements; there may be at most %2", shortestText(e.value), shortestText(e.limit));
    case SceneFileErrorCode::UnknownChoice:
        return tr("%1 must be %2", e.foundKind == JsonKind::Array ? e.found : tr("\"%1\"", e.found),
                  choicesText(e.choices));
    case SceneFileErrorCode::NotOneChoice: return tr("must have exactly one of %1", choicesText(e.choices));
    case SceneFileErrorCode::OtherAngle:
        return tr("%1 radians differ from %2, which is %3 degrees; remove the wrong key", shortestText(e.value),
                  e.found, shortestText(e.limit));
    case SceneFileErrorCode::BadFileName: return tr("this is not a name of a file");
    case SceneFileErrorCode::NotUtf8: return tr("the name is not UTF-8 and cannot be written; rename it");
    case SceneFileErrorCode::InvalidValue: return e.cause ? errorText(*e.cause) : std::string();
    }
    return {};
}

} // namespace

std::string sceneErrorText(const SceneFileError &error)
{
    std::string place = error.file;
    if (error.line > 0)
        place += ":" + std::to_string(error.line) + ":" + std::to_string(error.column);
    for (const std::string &part : {error.keyPath, sentence(error)})
        place += (place.empty() || part.empty() ? "" : ": ") + part;
    return place;
}

} // namespace unprojector::scene_file
