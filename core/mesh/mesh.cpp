#include "core/mesh/mesh.h"

#include "core/mesh/soup_numbers.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace unprojector::mesh {
using namespace geometry;

namespace {

glm::ivec3 remaindersOf(const glm::dvec3 &exact, const glm::vec3 &rounded)
{
    return {remainderOf(exact.x, rounded.x), remainderOf(exact.y, rounded.y), remainderOf(exact.z, rounded.z)};
}

} // namespace

std::size_t Model::triangleCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.triangleCount();
    return count;
}

std::size_t Model::pointCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.pointCount();
    return count;
}

glm::dvec3 originFor(const Box &box)
{
    glm::dvec3 origin(0.0);
    if (box.isEmpty())
        return origin;
    const glm::dvec3 size = box.highest - box.lowest;
    const double width = std::max({size.x, size.y, size.z});
    // Slightly more than the width. Then every float of the box is between half the origin and
    // twice it, where the difference of two floats is a float too.
    constexpr double kFar = 1.01;
    for (int axis = 0; axis < 3; ++axis) {
        const double middle = box.center()[axis];
        if (std::isfinite(middle) && std::abs(middle) > kFar * width)
            origin[axis] = static_cast<double>(static_cast<float>(middle));
    }
    return origin;
}

std::size_t Model::vertexCount() const
{
    std::size_t count = 0;
    for (const Mesh &mesh : meshes)
        count += mesh.positions.size();
    return count;
}

const std::vector<std::uint32_t> &Model::numbersIn(std::size_t mesh) const
{
    return soupNumbers ? soupNumbers->of(meshes[mesh]) : meshes[mesh].vertexNumbers;
}

std::uint32_t Model::vertexNumber(std::size_t mesh, std::size_t vertex) const
{
    if (const std::vector<std::uint32_t> &numbers = numbersIn(mesh); !numbers.empty())
        return numbers[vertex];
    std::size_t number = vertex;
    for (std::size_t i = 0; i < mesh; ++i)
        number += meshes[i].positions.size();
    return static_cast<std::uint32_t>(number);
}

std::optional<Model::VertexPlace> Model::vertexOf(std::uint32_t number) const
{
    std::size_t before = 0;
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const std::vector<std::uint32_t> &numbers = numbersIn(i);
        const std::size_t count = meshes[i].positions.size(), place = number - before;
        if (numbers.empty() ? number < before + count : number < count && numbers[number] == number)
            return VertexPlace{i, numbers.empty() ? place : number};
        if (const auto found = std::find(numbers.begin(), numbers.end(), number); found != numbers.end())
            return VertexPlace{i, static_cast<std::size_t>(found - numbers.begin())};
        before += count;
    }
    return std::nullopt;
}

std::int32_t remainderOf(double exact, float rounded)
{
    if (std::abs(rounded) < std::numeric_limits<float>::min() || !std::isfinite(rounded))
        return 0;
    return static_cast<std::int32_t>(std::bit_cast<std::int64_t>(exact) - std::bit_cast<std::int64_t>(double{rounded}));
}

void addPosition(Mesh &mesh, const glm::dvec3 &position)
{
    const glm::dvec3 exact = position - mesh.origin;
    const glm::vec3 rounded(exact);
    const glm::ivec3 remainder = remaindersOf(exact, rounded);
    if (mesh.remainders.empty() && remainder != glm::ivec3(0)) {
        mesh.remainders.reserve(mesh.positions.capacity());
        mesh.remainders.resize(mesh.positions.size(), glm::ivec3(0));
    }
    if (!mesh.remainders.empty() || remainder != glm::ivec3(0))
        mesh.remainders.push_back(remainder);
    mesh.positions.push_back(rounded);
}

void setPosition(Mesh &mesh, std::size_t vertex, const glm::dvec3 &position)
{
    const glm::dvec3 exact = position - mesh.origin;
    mesh.positions[vertex] = glm::vec3(exact);
    mesh.remainders[vertex] = remaindersOf(exact, mesh.positions[vertex]);
}

void setPositions(Mesh &mesh, const glm::dvec3 &origin, std::span<const glm::dvec3> positions)
{
    mesh.origin = origin;
    mesh.positions.clear();
    mesh.remainders.clear();
    mesh.positions.reserve(positions.size());
    for (const glm::dvec3 &position : positions)
        addPosition(mesh, position);
}

void ShownBox::add(const Mesh &mesh, std::size_t vertex)
{
    const glm::vec3 &p = mesh.positions[vertex];
    // Only vertices at the box's rim in single precision are tested in double.
    if (p.x > m_lowest.x && p.y > m_lowest.y && p.z > m_lowest.z && p.x < m_highest.x && p.y < m_highest.y
        && p.z < m_highest.z)
        return;
    m_lowest = glm::min(m_lowest, p);
    m_highest = glm::max(m_highest, p);
    m_box.add(mesh.position(vertex));
}

Box boundsOf(const std::vector<Mesh> &meshes)
{
    Box box;
    for (const Mesh &mesh : meshes) {
        ShownBox own;
        for (std::size_t element = 0; element < mesh.elementCount(); ++element)
            own.add(mesh, mesh.vertexAt(element));
        box.add(own.box());
    }
    return box;
}

} // namespace unprojector::mesh
