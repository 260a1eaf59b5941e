// The text that a model file has in place of its texture's file name.

#include "core/mesh/import/mesh_reader.h"
#include "tests/fuzz/fuzzing.h"

#include <string>

using namespace unprojector::mesh;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    static const std::filesystem::path picture = fuzz::fileOf("picture.png", data, 0);
    const std::filesystem::path model = fuzz::folder() / "model.obj";
    const std::string reference(fuzz::text(data, size));
    const std::filesystem::path found = reader::resolveReference(model, reference);
    fuzz::require(found.empty() || std::filesystem::is_regular_file(found), "what is found is a file");
    if (found.empty() || found == picture) // any other may be large
        fuzz::require(reader::readTexture(model, reference).encoded.empty(), "there is only an empty picture");
    return 0;
}
