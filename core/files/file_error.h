#pragma once

#include "core/geometry/result.h"

#include <string>

namespace unprojector::files {

/// Why a file could not be written.
enum class FileErrorCode {
    IsDirectory,
    IsReadOnly,       ///< the file that is there; it is asked before anything is written
    NotAFile,         ///< a device, a pipe or a socket: see isStream
    NoFolder,         ///< the folder that it was to lie in is not there
    ChangedMeanwhile, ///< somebody else has written it since its stamp was taken
    System,           ///< reason: what the system says, as of a full disk
};

struct FileError {
    FileErrorCode code = FileErrorCode::System;
    /// Of the system, as text::systemErrorText says it: in the language of tr() where it is a usual one. UTF-8; may be empty.
    std::string reason;
};

/// What is wrong and what to do, as half a sentence to stand behind the file's name.
std::string fileErrorText(const FileError &error);

/// The result of something that only succeeds or fails.
using Written = geometry::Result<std::monostate, FileError>;

} // namespace unprojector::files
