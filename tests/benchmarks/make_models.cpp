// Writes a large model as a file of each format: a closed sphere with hills and shared vertices. It
// is for the benchmarks of loading, and for trying a large file.
//
//   make_models FOLDER 913       # 12 · 913² = 10,002,828 triangles: sphere913.stl, .ply, .obj,
// .glb

#include "tests/support/cube_sphere.h"

#include <nlohmann/json.hpp>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <vector>

using namespace unprojector::scene;
using namespace unprojector::mesh;

namespace {

std::vector<glm::vec3> normalsOf(const Mesh &mesh)
{
    std::vector<glm::vec3> normals(mesh.positions.size(), glm::vec3(0.0f));
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const glm::vec3 a = mesh.positions[mesh.indices[i]];
        const glm::vec3 normal =
            glm::cross(mesh.positions[mesh.indices[i + 1]] - a, mesh.positions[mesh.indices[i + 2]] - a);
        for (std::size_t c = 0; c < 3; ++c)
            normals[mesh.indices[i + c]] += normal;
    }
    for (glm::vec3 &normal : normals)
        normal = glm::normalize(normal);
    return normals;
}

/// A file written through a buffer; numbers in little-endian order, as these machines have them.
class Output {
public:
    explicit Output(const std::filesystem::path &file) : m_stream(file, std::ios::binary) {}
    ~Output() { flush(); }
    Output(const Output &) = delete;
    Output &operator=(const Output &) = delete;

    void text(std::string_view text)
    {
        m_buffer += text;
        if (m_buffer.size() > 1 << 20)
            flush();
    }
    template <class T>
    void bytes(const T &value)
    {
        text({reinterpret_cast<const char *>(&value), sizeof value});
    }
    template <class T>
    void number(T value)
    {
        char digits[32];
        std::to_chars_result end{};
        if constexpr (std::is_floating_point_v<T>)
            end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, 6);
        else
            end = std::to_chars(digits, digits + sizeof digits, value);
        text({digits, static_cast<std::size_t>(end.ptr - digits)});
    }

private:
    void flush()
    {
        m_stream.write(m_buffer.data(), static_cast<std::streamsize>(m_buffer.size()));
        m_buffer.clear();
    }

    std::ofstream m_stream;
    std::string m_buffer;
};

void writeStl(const Mesh &sphere, const std::filesystem::path &file)
{
    Output output(file);
    output.text(std::string(80, ' '));
    output.bytes(static_cast<std::uint32_t>(sphere.indices.size() / 3));
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        output.bytes(glm::vec3(0.0f));
        for (std::size_t c = 0; c < 3; ++c)
            output.bytes(sphere.positions[sphere.indices[i + c]]);
        output.bytes(std::uint16_t{0});
    }
}

void writePly(const Mesh &sphere, const std::filesystem::path &file)
{
    Output output(file);
    output.text("ply\nformat binary_little_endian 1.0\nelement vertex " + std::to_string(sphere.positions.size())
                + "\nproperty float x\nproperty float y\nproperty float z\nelement face "
                + std::to_string(sphere.indices.size() / 3) + "\nproperty list uchar int vertex_indices\nend_header\n");
    for (const glm::vec3 &position : sphere.positions)
        output.bytes(position);
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        output.bytes(std::uint8_t{3});
        for (std::size_t c = 0; c < 3; ++c)
            output.bytes(sphere.indices[i + c]);
    }
}

void writeObj(const Mesh &sphere, const std::filesystem::path &file)
{
    Output output(file);
    for (const glm::vec3 &position : sphere.positions) {
        output.text("v");
        for (int axis = 0; axis < 3; ++axis) {
            output.text(" ");
            output.number(position[axis]);
        }
        output.text("\n");
    }
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3) {
        output.text("f");
        for (std::size_t c = 0; c < 3; ++c) {
            output.text(" ");
            output.number(sphere.indices[i + c] + 1);
        }
        output.text("\n");
    }
}

void writeGlb(const Mesh &sphere, const std::filesystem::path &file)
{
    const std::size_t vertexBytes = 12 * sphere.positions.size();
    const std::size_t indexBytes = 4 * sphere.indices.size();
    glm::vec3 lowest(2.0f), highest(-2.0f);
    for (const glm::vec3 &position : sphere.positions) {
        lowest = glm::min(lowest, position);
        highest = glm::max(highest, position);
    }
    using nlohmann::json;
    const auto view = [](std::size_t offset, std::size_t size, int target) {
        return json{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}, {"target", target}};
    };
    json positions{{"bufferView", 0}, {"componentType", 5126}, {"count", sphere.positions.size()}, {"type", "VEC3"}};
    positions["min"] = {lowest.x, lowest.y, lowest.z};
    positions["max"] = {highest.x, highest.y, highest.z};
    json normals = positions;
    normals["bufferView"] = 1;
    normals.erase("min");
    normals.erase("max");
    json primitive{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}}, {"indices", 2}};
    json document;
    document["asset"] = {{"version", "2.0"}};
    document["scene"] = 0;
    document["scenes"] = json::array({{{"nodes", {0}}}});
    document["nodes"] = json::array({{{"mesh", 0}}});
    document["meshes"] = json::array({{{"primitives", json::array({primitive})}}});
    document["buffers"] = json::array({{{"byteLength", 2 * vertexBytes + indexBytes}}});
    document["bufferViews"] = {view(0, vertexBytes, 34962), view(vertexBytes, vertexBytes, 34962),
                               view(2 * vertexBytes, indexBytes, 34963)};
    document["accessors"] = {
        positions,
        normals,
        {{"bufferView", 2}, {"componentType", 5125}, {"count", sphere.indices.size()}, {"type", "SCALAR"}}};
    std::string text = document.dump();
    text.append((4 - text.size() % 4) % 4, ' ');

    Output output(file);
    output.text("glTF");
    output.bytes(std::uint32_t{2});
    output.bytes(static_cast<std::uint32_t>(12 + 8 + text.size() + 8 + 2 * vertexBytes + indexBytes));
    output.bytes(static_cast<std::uint32_t>(text.size()));
    output.text("JSON" + text);
    output.bytes(static_cast<std::uint32_t>(2 * vertexBytes + indexBytes));
    output.text(std::string_view("BIN\0", 4));
    for (const glm::vec3 &position : sphere.positions)
        output.bytes(position);
    for (const glm::vec3 &normal : normalsOf(sphere))
        output.bytes(normal);
    for (const std::uint32_t index : sphere.indices)
        output.bytes(index);
}

} // namespace

int main(int argumentCount, char **arguments)
{
    static_assert(std::endian::native == std::endian::little, "STL, PLY and GLB are written as they lie in memory");
    const int divisions = argumentCount == 3 ? std::atoi(arguments[2]) : 0;
    if (divisions < 1 || divisions > 10000) {
        std::cerr << "Usage: make_models FOLDER DIVISIONS, for 12 * DIVISIONS^2 triangles\n";
        return 2;
    }
    const auto model = cubeSphere(static_cast<std::uint32_t>(divisions));
    const Mesh &sphere = model->meshes.front();
    const std::filesystem::path folder(arguments[1]);
    std::filesystem::create_directories(folder);
    const std::string name = "sphere" + std::to_string(divisions);
    writeStl(sphere, folder / (name + ".stl"));
    writePly(sphere, folder / (name + ".ply"));
    writeObj(sphere, folder / (name + ".obj"));
    writeGlb(sphere, folder / (name + ".glb"));
    return 0;
}
