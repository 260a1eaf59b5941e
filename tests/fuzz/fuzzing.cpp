#include "tests/fuzz/fuzzing.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <system_error>

namespace fuzz {
namespace {

struct Folder {
    std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("unprojector_fuzz_" + std::to_string(std::random_device()()));
    Folder() { std::filesystem::create_directories(path); }
    Folder(const Folder &) = delete;
    Folder &operator=(const Folder &) = delete;
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path, ignored);
    }
};

} // namespace

void require(bool isKept, const char *promise)
{
    if (isKept)
        return;
    std::fprintf(stdout, "broken promise: %s\n", promise);
    std::fflush(stdout);
    std::abort();
}

const std::filesystem::path &folder()
{
    static const Folder own;
    return own.path;
}

std::filesystem::path fileOf(const char *name, const std::uint8_t *data, std::size_t size)
{
    const std::filesystem::path file = folder() / name;
    std::ofstream stream(file, std::ios::binary | std::ios::trunc);
    stream.write(reinterpret_cast<const char *>(data), static_cast<std::streamsize>(size));
    require(stream.good(), "the disk takes the fuzzer's file");
    return file;
}

void silence()
{
    if (std::FILE *nowhere = std::fopen("/dev/null", "w"))
        stderr = nowhere; // glibc's may be assigned; descriptor 2 stays open
}

} // namespace fuzz
