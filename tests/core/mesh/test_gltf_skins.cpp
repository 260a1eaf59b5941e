// glTF: meshes that follow the joints of a skin.

#include "tests/support/test.h"

#include "tests/core/mesh/gltf_builder.h"

#include <glm/geometric.hpp>

#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace model_files;

namespace {

/// A quad of four vertices on a node that is far away and holds a skin of two joints.
/// - The parent of both joints is moved by (10, 0, 0) and twice as large.
/// - The second joint, its child, is moved by (0, 3, 0) and turned by 90 degrees about z.
/// - The inverse bind matrices move by (-1, 0, 0) and (0, -1, 0).
QByteArray skinned(const std::vector<quint8> &joints, const std::vector<float> &weights, const QByteArray &more = {},
                   const std::vector<float> &inverse = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0,  0, 1,
                                                        1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0,  -1, 0, 1})
{
    GltfBuilder file;
    file.add(kQuadCorners, "VEC3", kFloat);
    file.add(joints, "VEC4", kUbyte);
    file.add(weights, "VEC4", kFloat);
    file.addAccessor(file.addView(inverse), kFloat, int(inverse.size() / 16), "MAT4");
    file.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 1, 0, 0}, "VEC3", kFloat);
    return file.json(R"(,"scene":0,"scenes":[{"nodes":[0,1]}],"nodes":[
        {"mesh":0,"skin":0,"translation":[500,600,700]},
        {"children":[2],"translation":[10,0,0],"scale":[2,2,2]},
        {"children":[3]},
        {"translation":[0,3,0],"rotation":[0,0,0.7071067811865476,0.7071067811865476]}],
        "skins":[{"joints":[2,3],"inverseBindMatrices":3}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0,"NORMAL":4,"JOINTS_0":1,"WEIGHTS_0":2},"mode":5}]}])"
                     + more);
}

constexpr quint8 o = 0;

} // namespace

class TestGltfSkins : public QObject {
    Q_OBJECT

    auto imported(const QByteArray &content, const QString &name = QStringLiteral("model.gltf"))
    {
        return m_folder.imported(name, content);
    }

private slots:
    void skinsGoWithTheirJoints()
    {
        // The vertices (0,0,0), (1,0,0), (0,1,0), (1,1,0): by the first joint, by the second, by both
        // in equal parts, by one half of weights that add up to 4.
        const auto result = imported(skinned({o, o, o, o, 1, o, o, o, o, 1, o, o, 1, o, o, o},
                                             {1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0, 3, 1, 0, 0}));
        REQUIRE_MODEL(result);
        QCOMPARE(notesOf(**result),
                 QByteArray("1 mesh has a skin: it is shown where the file's nodes have its joints"));
        const Mesh &mesh = (*result)->meshes.front();
        // The first joint takes p to (10,0,0) + 2 (p - (1,0,0)), the second to (10,6,0) + 2 turned(p -
        // (0,1,0)).
        const auto first = [](double x, double y) { return glm::dvec3(10.0 + 2.0 * (x - 1.0), 2.0 * y, 0.0); };
        const auto second = [](double x, double y) { return glm::dvec3(10.0 - 2.0 * (y - 1.0), 6.0 + 2.0 * x, 0.0); };
        const std::vector<glm::dvec3> expected{first(0, 0), second(1, 0), (first(0, 1) + second(0, 1)) / 2.0,
                                               (3.0 * second(1, 1) + first(1, 1)) / 4.0};
        for (std::size_t v = 0; v < 4; ++v)
            QVERIFY2(glm::distance(mesh.position(v), expected[v]) < 1e-5, qPrintable(QString::number(v)));
    }

    void skinsTurnNormals()
    {
        const auto result = imported(skinned({1, o, o, o, 1, o, o, o, 1, o, o, o, 1, o, o, o},
                                             {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0}));
        REQUIRE_MODEL(result);
        const Mesh &mesh = (*result)->meshes.front();
        QCOMPARE(mesh.normals.size(), std::size_t(4));
        QVERIFY(glm::distance(mesh.normals[0], glm::vec3(0, 0, 1)) < 1e-6f);
        QVERIFY(glm::distance(mesh.normals[3], glm::vec3(0, 1, 0)) < 1e-6f);
    }

    void aSkinIsChecked_data()
    {
        addColumn<QByteArray>("content");
        addColumn<QString>("detail");
        const std::vector<quint8> joints(16, o);
        const std::vector<float> weights(16, 0.25f);
        std::vector<quint8> manyJoints = joints;
        manyJoints[9] = 7;
        std::vector<float> negative = weights;
        negative[6] = -0.5f;
        newRow("a joint that there is none of")
            << skinned(manyJoints, weights) << "vertex 2 of a mesh names joint 7, its skin has 2";
        newRow("a negative weight") << skinned(joints, negative) << "vertex 1 of a mesh has the joint weight -0.5";
        newRow("too few matrices") << skinned(joints, weights, {}, std::vector<float>(16, 0.0f))
                                   << "a skin of 2 joints has 1 inverse bind matrices";
        newRow("a matrix that divides") << skinned(joints, weights, {}, std::vector<float>(32, 1.0f))
                                        << "the inverse bind matrix 0 of a skin has the last row 1 1 1 1";
        newRow("no weights") << skinned(joints, weights).replace(R"(,"WEIGHTS_0":2)", "")
                             << "a mesh has JOINTS_0 without WEIGHTS_0";
        newRow("a joint that is no node") << skinned(joints, weights).replace(R"("joints":[2,3])", R"("joints":[2,9])")
                                          << "\"joints\" refers to a node";
    }

    void aSkinIsChecked()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, detail);
        const auto result = imported(content);
        VERIFY_REFUSED(result, detail);
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestGltfSkins, threads)
#include "test_gltf_skins.moc"
