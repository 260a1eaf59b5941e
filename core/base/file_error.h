#pragma once

#include "core/base/expected.h"

#include <string>
#include <variant>

namespace unprojector::base {

/// The reason why a file could not be written.
enum class FileErrorCode {
    IsDirectory,
    IsReadOnly,       ///< the existing file; checked before anything is written
    NotAFile,         ///< a device, a pipe or a socket: see isStream
    NoFolder,         ///< the target folder does not exist
    ChangedMeanwhile, ///< another program has written it since its stamp was taken
    System,           ///< reason: the system's message, e.g. a full disk
};

struct FileError {
    FileErrorCode code = FileErrorCode::System;
    /// The system's message from base::systemErrorText: common ones are in the language of tr().
    /// UTF-8; may be empty.
    std::string reason;
};

/// The error and its remedy, as a phrase to follow the file's name.
std::string fileErrorText(const FileError &error);

/// The result of an operation without a value.
using Written = Expected<std::monostate, FileError>;

} // namespace unprojector::base
