#pragma once

#include "core/geometry/result.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace unprojector::scene_file {

/// The reason why a scene file could not be read or written. `SceneFileError` has the position and
/// the values.
enum class SceneFileErrorCode {
    NotFound,
    IsDirectory,
    NotAFile,         ///< a device, a pipe or a socket
    NotReadable,      ///< detail: the system's reason
    NotWritable,      ///< detail: base::fileErrorText
    ChangedMeanwhile, ///< by another program, since its stamp was taken
    IsOwnModel,       ///< the target is the model of keyPath
    EmptyFile,        ///< nothing but blanks
    TooLarge,         ///< limit: the most bytes a scene may have
    Syntax,           ///< line, column; detail: the parser's message, in the language of tr()
    NumberTooLarge,   ///< line, column; found: the number as written, beyond the range of doubles
    TooDeep,          ///< line, column; limit: the most levels of brackets
    DuplicateKey,     ///< line, column; found: the key
    UnknownVersion,   ///< keyPath; value: the version found, limit: the supported one
    Missing,          ///< keyPath
    WrongType,        ///< keyPath; expected, found
    NotWhole,         ///< keyPath; value: a number with a fraction where a count is wanted
    OutOfRange,       ///< keyPath; value; lowest, limit: the ends of the allowed range, both included
    WrongCount,       ///< keyPath; value: number of elements, limit: required number
    TooMany,          ///< keyPath; value: number of elements, limit: maximum number
    UnknownChoice,    ///< keyPath; found; choices
    NotOneChoice,     ///< keyPath; choices: the keys of which exactly one must be present
    OtherAngle,       ///< keyPath; value: radians that differ from the angle in `found`, limit: in degrees
    BadFileName,      ///< keyPath; empty, or with a zero byte
    NotUtf8,          ///< keyPath; a name that JSON cannot represent
    InvalidValue,     ///< keyPath; cause: core's error about the value
};

/// The kinds of JSON values, found or expected.
enum class JsonKind { Null, Boolean, Number, Text, Array, Object, TwoNumbers, ThreeNumbers, FourNumbers, Matrix };

struct SceneFileError {
    SceneFileErrorCode code = SceneFileErrorCode::Syntax;
    std::string file;       ///< UTF-8, as it was given
    std::size_t line = 0;   ///< counted from 1; 0: no line, see keyPath
    std::size_t column = 0; ///< counted from 1, in bytes
    std::string keyPath;    ///< "objects[0].transform[1].rotate"; empty for the whole document
    std::string found;      ///< UTF-8, shortened
    std::string detail;     ///< from the system or the JSON parser
    JsonKind expectedKind = JsonKind::Null;
    JsonKind foundKind = JsonKind::Null;
    double value = 0.0;
    double lowest = 0.0;
    double limit = 0.0;
    std::vector<std::string> choices;
    std::optional<geometry::Error> cause;
};

} // namespace unprojector::scene_file
