# Writes files' bytes as one C++ source: a string literal of this length is more than compilers must take.
#   cmake -DFOLDER=… -DFILES="a.json|b/c.txt" -DOUT=… -P embed.cmake
set(arrays)
set(rows)
string(REPLACE "|" ";" FILES "${FILES}")
foreach(file IN LISTS FILES)
    file(READ "${FOLDER}/${file}" bytes HEX)
    string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
    string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
    string(MAKE_C_IDENTIFIER "${file}" name)
    string(APPEND arrays "constexpr unsigned char ${name}[] = {\n${bytes}\n};\n")
    string(APPEND rows "    {\"${file}\", {reinterpret_cast<const char *>(${name}), sizeof ${name}}},\n")
endforeach()
file(WRITE "${OUT}" "#include \"core/base/resource.h\"

#include <cassert>
#include <utility>

namespace unprojector::base {
namespace {

${arrays}
const std::pair<std::string_view, std::string_view> kResources[] = {
${rows}};

} // namespace

std::string_view resource(std::string_view path)
{
    for (const auto &[name, bytes] : kResources) {
        if (name == path)
            return bytes;
    }
    assert(false && \"core/CMakeLists.txt does not name this file\");
    return {};
}

} // namespace unprojector::base
")
