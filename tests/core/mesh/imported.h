#pragma once

#include "core/mesh/import/mesh_import.h"
#include "tests/core/mesh/model_files.h"
#include "tests/support/data_files.h"

#include <QTest>

#include <QByteArrayList>
#include <QTemporaryDir>

#include <glm/geometric.hpp>

#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <string>

/// Helpers that the tests of the model readers share: a folder for each test, and measures of the
/// imported model.
namespace model_files {

class ImportFolder {
public:
    std::filesystem::path write(const QString &name, const QByteArray &content) const
    {
        std::filesystem::path file = path() / pathOf(name);
        // Truncating a file that was just written waits for the disk on some systems.
        std::filesystem::remove(file);
        std::ofstream(file, std::ios::binary).write(content.constData(), content.size());
        return file;
    }
    auto imported(const QString &name, const QByteArray &content) const
    {
        return unprojector::mesh::importModel(write(name, content), {});
    }
    std::filesystem::path path() const { return pathOf(m_folder.path()); }

private:
    QTemporaryDir m_folder;
};

/// The model's notes as commands print them.
inline QByteArray notesOf(const unprojector::mesh::Model &model)
{
    QByteArrayList texts;
    for (const unprojector::base::Note &note : model.notes)
        texts.append(QByteArray::fromStdString(note.text()));
    return texts.join("; ");
}

/// The triangles' area in object space.
inline double areaOf(const unprojector::mesh::Mesh &mesh)
{
    double area = 0.0;
    for (std::size_t i = 0; i < 3 * mesh.triangleCount(); i += 3) {
        const glm::dvec3 a = mesh.position(mesh.vertexAt(i));
        area +=
            glm::length(glm::cross(mesh.position(mesh.vertexAt(i + 1)) - a, mesh.position(mesh.vertexAt(i + 2)) - a))
            / 2.0;
    }
    return area;
}

/// A grid of 5 x 5 points near a survey's origin, in steps of a millimetre, as a file would have
/// them.
inline glm::dvec3 surveyPoint(int i)
{
    const int column = i % 5, row = i / 5;
    return {4000000.0 + 0.001 * column, 500000.0 + 0.001 * row, 300.0 + 0.001 * ((i * 7) % 5)};
}
inline constexpr int kSurveyPoints = 25;

/// The two triangles of each of the grid's 16 squares, as numbers of its points.
inline std::vector<std::array<int, 3>> surveyTriangles()
{
    std::vector<std::array<int, 3>> triangles;
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const int a = 5 * row + column;
            triangles.push_back({a, a + 1, a + 6});
            triangles.push_back({a, a + 6, a + 5});
        }
    }
    return triangles;
}

inline QByteArray surveyWords(int i)
{
    const glm::dvec3 p = surveyPoint(i);
    return QByteArray::number(p.x, 'f', 3) + ' ' + QByteArray::number(p.y, 'f', 3) + ' '
           + QByteArray::number(p.z, 'f', 3);
}

/// Returns whether all corners of the grid's triangles are where the file has them, in its order.
inline bool hasSurveyDetail(const unprojector::mesh::Mesh &mesh, double tolerance = 1e-5)
{
    const auto triangles = surveyTriangles();
    if (mesh.triangleCount() != triangles.size())
        return false;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (std::size_t c = 0; c < 3; ++c) {
            if (!(glm::distance(mesh.position(mesh.vertexAt(3 * t + c)), surveyPoint(triangles[t][c])) < tolerance))
                return false;
        }
    }
    return true;
}

} // namespace model_files

#define REQUIRE_MODEL(result) QVERIFY2((result).hasValue(), (result).hasValue() ? "" : (result).error().text.c_str())

/// Verifies that a file is the box of every format, with these notes.
#define VERIFY_BOX_WITH_NOTES(result, notes)                                                                           \
    do {                                                                                                               \
        REQUIRE_MODEL(result);                                                                                         \
        QCOMPARE((result).value()->triangleCount(), std::size_t{12});                                                  \
        QVERIFY((result).value()->bounds.lowest == glm::dvec3(-1, 0, 0));                                              \
        QVERIFY((result).value()->bounds.highest == glm::dvec3(2, 1, 2));                                              \
        QCOMPARE(notesOf(**(result)), notes);                                                                          \
    } while (false)

/// Verifies that a file is rejected. @param part  of the message
#define VERIFY_REFUSED(result, part)                                                                                   \
    do {                                                                                                               \
        QVERIFY(!(result).hasValue());                                                                                 \
        QVERIFY2(QString::fromStdString((result).error().text).contains(part), (result).error().text.c_str());         \
    } while (false)

namespace model_files {

inline constexpr auto kNotFinite = "vertex %1 is NaN, infinite, or beyond 3.4e38";

/// Verifies that a model is the triangle (0, 0, 0), (1, 0, 0), (0, 1, 0).
inline void verifyTriangle(const unprojector::mesh::Model &model)
{
    QCOMPARE(model.triangleCount(), std::size_t{1});
    QCOMPARE(model.meshes.size(), std::size_t{1});
    const unprojector::mesh::Mesh &mesh = model.meshes.front();
    const glm::dvec3 expected[] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (std::size_t corner = 0; corner < 3; ++corner)
        QVERIFY(mesh.position(mesh.vertexAt(corner)) == expected[corner]);
    for (const glm::vec3 &normal : mesh.normals)
        QVERIFY(normal == glm::vec3(0, 0, 1));
}

/// Verifies that a model is two triangles of the area 1 that face z.
inline void verifyQuad(const unprojector::mesh::Model &model)
{
    QCOMPARE(model.triangleCount(), std::size_t{2});
    const unprojector::mesh::Mesh &mesh = model.meshes.front();
    double area = 0.0;
    for (std::size_t t = 0; t < 2; ++t) {
        const glm::dvec3 a = mesh.position(mesh.vertexAt(3 * t));
        const glm::dvec3 normal =
            glm::cross(mesh.position(mesh.vertexAt(3 * t + 1)) - a, mesh.position(mesh.vertexAt(3 * t + 2)) - a);
        QVERIFY2(normal.z > 0.0, "a triangle is turned over");
        area += glm::length(normal) / 2.0;
    }
    QVERIFY(std::abs(area - 1.0) < 1e-6);
}

/// Verifies that a file is read or refused as its case tells.
template <class Imported>
void verifyCase(const Imported &result, const data_files::Case &example)
{
    static const std::map<std::string, QByteArray> kErrors{
        {"malformed", "the file is damaged: %1"},
        {"unsupported", "the file cannot be shown: %1"},
        {"no triangles", "the file holds neither triangles nor points"},
        {"not finite", kNotFinite}};
    for (const auto &[word, text] : example.told) {
        const QByteArray told = QByteArray::fromStdString(text);
        if (const auto error = kErrors.find(word); error != kErrors.end()) {
            QVERIFY(!result.hasValue());
            QCOMPARE(QByteArray::fromStdString(result.error().text), QByteArray(error->second).replace("%1", told));
            continue;
        }
        static const std::set<std::string> kShapes{"box", "triangle", "quad", "triangles", "notes"};
        QVERIFY2(kShapes.contains(word), ("unknown word: " + word).c_str());
        REQUIRE_MODEL(result);
        const unprojector::mesh::Model &model = **result;
        if (word == "triangles") {
            QCOMPARE(QByteArray::number(qulonglong(model.triangleCount())), told);
            continue;
        }
        QCOMPARE(notesOf(model), told);
        if (word == "box")
            VERIFY_BOX_WITH_NOTES(result, told);
        else if (word == "triangle")
            verifyTriangle(model);
        else if (word == "quad")
            verifyQuad(model);
        for (const unprojector::mesh::Mesh &mesh : model.meshes)
            QCOMPARE(mesh.normals.size(), mesh.positions.size());
    }
}

} // namespace model_files
