# Writes a file's bytes as a C++ source: a string literal of this length is more than compilers must take.
#   cmake -DFILE=… -DNAME=kArray -DOUT=… -P embed.cmake
file(READ "${FILE}" bytes HEX)
string(REGEX REPLACE "(................................)" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${bytes}")
file(WRITE "${OUT}" "#include <cstddef>

namespace unprojector::text {

extern const unsigned char ${NAME}[];
extern const std::size_t ${NAME}Size;
const unsigned char ${NAME}[] = {
${bytes}
};
const std::size_t ${NAME}Size = sizeof ${NAME};

} // namespace unprojector::text
")
