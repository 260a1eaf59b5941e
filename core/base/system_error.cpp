#include "core/base/system_error.h"

#include "core/base/translation.h"

namespace unprojector::base {

std::string systemErrorText(const std::error_code &error)
{
    struct Text {
        std::errc condition;
        const char *english;
    };
    constexpr Text kTexts[] = {
        {std::errc::no_such_file_or_directory, marked("No such file or directory")},
        {std::errc::permission_denied, marked("Permission denied")},
        {std::errc::operation_not_permitted, marked("Operation not permitted")},
        {std::errc::no_space_on_device, marked("No space left on device")},
        {std::errc::file_too_large, marked("File too large")},
        {std::errc::filename_too_long, marked("File name too long")},
        {std::errc::is_a_directory, marked("Is a directory")},
        {std::errc::not_a_directory, marked("Not a directory")},
        {std::errc::read_only_file_system, marked("Read-only file system")},
        {std::errc::io_error, marked("Input/output error")},
        {std::errc::broken_pipe, marked("Broken pipe")},
        {std::errc::device_or_resource_busy, marked("Device or resource busy")},
        {std::errc::too_many_files_open, marked("Too many open files")},
        {std::errc::too_many_symbolic_link_levels, marked("Too many levels of symbolic links")},
    };
    if (language() != Language::English) {
        for (const Text &text : kTexts) {
            if (error == text.condition)
                return tr(text.english);
        }
    }
    return error.message();
}

std::string systemErrorText(int number)
{
    return systemErrorText(std::error_code(number, std::generic_category()));
}

} // namespace unprojector::base
