#pragma once

#include "core/base/expected.h"

#include <string>
#include <variant>

namespace unprojector::base {

/// Why something could not be done, in words.
struct Error {
    /// What a caller may do about it.
    enum class Kind {
        Value,       ///< change the value, or what the file says
        NoFile,      ///< give another name: there is no such file or folder
        File,        ///< look at the file: it cannot be read or written
        Changed,     ///< ask: another program has written the file meanwhile
        Stopped,     ///< nothing: the user wanted it
        OutOfMemory, ///< give something smaller
    };

    /// The fact and the remedy, in the language of tr(), as a phrase: no capital, no full stop.
    /// "is 100; it must be smaller than far (100)" where a subject stands before it.
    std::string text;
    std::string subject = {}; ///< the value at fault: a key, an option, a path in JSON ("camera.near"); may be empty
    std::string file = {};    ///< as the user named it, UTF-8; may be empty
    int line = 0;             ///< of the file, from 1; 0: none
    int column = 0;           ///< of the line, from 1; 0: none
    Kind kind = Kind::Value;

    /// "FILE:LINE:COLUMN: SUBJECT: TEXT", without the parts that are empty.
    std::string message() const;
};

/// The result of something that has no value.
using Done = Expected<std::monostate, Error>;

} // namespace unprojector::base
