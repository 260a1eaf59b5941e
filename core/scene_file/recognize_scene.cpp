#include "core/scene_file/scene_file.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

namespace unprojector::scene_file {
namespace {

using Json = nlohmann::ordered_json;

/// Handles JSON parser events until the key that only scenes have, or anything but an object.
class SceneKeyFinder {
public:
    bool hasFound() const { return m_hasFound; }

    // NOLINTBEGIN(readability-identifier-naming): what nlohmann::json::sax_parse calls; false ends
    // it
    bool null() { return m_level > 0; }
    bool boolean(bool) { return m_level > 0; }
    bool number_integer(Json::number_integer_t) { return m_level > 0; }
    bool number_unsigned(Json::number_unsigned_t) { return m_level > 0; }
    bool number_float(Json::number_float_t, const std::string &) { return m_level > 0; }
    bool string(std::string &) { return m_level > 0; }
    bool binary(Json::binary_t &) { return false; }
    bool start_object(std::size_t) { return ++m_level > 0; }
    bool start_array(std::size_t) { return m_level++ > 0; }
    bool end_object() { return --m_level > 0; }
    bool end_array() { return --m_level > 0; }
    bool key(const std::string &name)
    {
        m_hasFound = m_level == 1 && name == "unprojector";
        return !m_hasFound;
    }
    bool parse_error(std::size_t, const std::string &, const nlohmann::detail::exception &) { return false; }
    // NOLINTEND(readability-identifier-naming)

private:
    std::size_t m_level = 0; ///< number of open brackets
    bool m_hasFound = false;
};

} // namespace

bool isSceneText(std::string_view text)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text.starts_with(kByteOrderMark))
        text.remove_prefix(kByteOrderMark.size());
    SceneKeyFinder finder;
    Json::sax_parse(text.begin(), text.end(), &finder);
    return finder.hasFound();
}

bool isSceneFile(const std::filesystem::path &file)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error))
        return false;
    std::ifstream stream(file, std::ios::binary);
    // Reads only the start first: a model of gigabytes need not be read whole to see that it is no
    // scene.
    constexpr std::size_t kStart = 64;
    std::string text(kStart, '\0');
    const auto read = [&](std::size_t from) {
        stream.read(text.data() + from, static_cast<std::streamsize>(text.size() - from));
        text.resize(from + static_cast<std::size_t>(stream.gcount()));
    };
    read(0);
    const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
    if (first != std::string::npos && text[first] != '{')
        return false;
    if (text.size() == kStart) {
        // The key stands near the start of this program's scenes; a model with data inside is not read whole.
        constexpr std::uintmax_t kEnough = std::uintmax_t{8} << 20;
        const auto size = std::filesystem::file_size(file, error);
        text.resize(std::max<std::size_t>(kStart, error ? 0 : std::min(size, kEnough)));
        read(kStart);
    }
    return isSceneText(text);
}

} // namespace unprojector::scene_file
