// Models in every format: their positions are the numbers of the file, and their vertices have the
// file's numbers.

#include "tests/support/test.h"

#include "tests/core/mesh/gltf_builder.h"
#include "tests/core/mesh/imported.h"
#include "tests/core/mesh/model_files.h"

#include "core/geometry/transform.h"
#include "core/ray/closest_place.h"
#include "core/scene/measures.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace model_files;
using namespace unprojector::geometry;

Q_DECLARE_METATYPE(glm::dvec3)

namespace {

/// Corners of triangles.
using Places = std::vector<glm::dvec3>;

QByteArray written(double value)
{
    return QByteArray::number(value, 'g', QLocale::FloatingPointShortest);
}

QByteArray written(const glm::dvec3 &place)
{
    return written(place.x) + ' ' + written(place.y) + ' ' + written(place.z);
}

/// Positions with `digits` digits behind the point, as files have them, or with all digits of a
/// double.
Places placesAbout(const glm::dvec3 &center, double size, int digits)
{
    std::mt19937_64 engine(20261126);
    std::uniform_real_distribution<double> share(-size, size);
    Places places;
    for (int i = 0; i < 300; ++i) {
        glm::dvec3 place = center + glm::dvec3(share(engine), share(engine), share(engine));
        for (int axis = 0; digits > 0 && axis < 3; ++axis)
            place[axis] = QByteArray::number(place[axis], 'f', digits).toDouble();
        places.push_back(place);
    }
    return places;
}

QByteArray objOf(const Places &places)
{
    QByteArray text;
    for (const glm::dvec3 &place : places)
        text += "v " + written(place) + '\n';
    for (std::size_t i = 1; i <= places.size(); i += 3)
        text += "f " + QByteArray::number(qulonglong{i}) + ' ' + QByteArray::number(qulonglong{i} + 1) + ' '
                + QByteArray::number(qulonglong{i} + 2) + '\n';
    return text;
}

QByteArray faceLines(const Places &places)
{
    QByteArray text;
    for (std::size_t i = 0; i < places.size(); i += 3)
        text += "3 " + QByteArray::number(qulonglong{i}) + ' ' + QByteArray::number(qulonglong{i} + 1) + ' '
                + QByteArray::number(qulonglong{i} + 2) + '\n';
    return text;
}

QByteArray offOf(const Places &places)
{
    QByteArray text = "OFF\n" + QByteArray::number(qulonglong(places.size())) + ' '
                      + QByteArray::number(qulonglong(places.size() / 3)) + " 0\n";
    for (const glm::dvec3 &place : places)
        text += written(place) + '\n';
    return text + faceLines(places);
}

QByteArray plyHeaderOf(const Places &places, const QByteArray &format, const QByteArray &type)
{
    return "ply\nformat " + format + " 1.0\nelement vertex " + QByteArray::number(qulonglong(places.size()))
           + "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type + " z\nelement face "
           + QByteArray::number(qulonglong(places.size() / 3))
           + "\nproperty list uchar int vertex_indices\nend_header\n";
}

QByteArray plyTextOf(const Places &places)
{
    QByteArray text = plyHeaderOf(places, "ascii", "double");
    for (const glm::dvec3 &place : places)
        text += written(place) + '\n';
    return text + faceLines(places);
}

template <class Number>
QByteArray plyLittleOf(const Places &places, const QByteArray &type)
{
    QByteArray bytes = plyHeaderOf(places, "binary_little_endian", type);
    for (const glm::dvec3 &place : places)
        bytes += little(Number(place.x)) + little(Number(place.y)) + little(Number(place.z));
    for (quint32 i = 0; i < places.size(); i += 3)
        bytes += '\3' + little(i) + little(i + 1) + little(i + 2);
    return bytes;
}

QByteArray stlTextOf(const Places &places)
{
    QByteArray text("solid places\n");
    for (std::size_t i = 0; i < places.size(); i += 3)
        text += "facet normal 0 0 0\nouter loop\nvertex " + written(places[i]) + "\nvertex " + written(places[i + 1])
                + "\nvertex " + written(places[i + 2]) + "\nendloop\nendfacet\n";
    return text + "endsolid places\n";
}

QByteArray stlBinaryOf(const Places &places)
{
    QByteArray bytes(80, ' ');
    bytes += little(quint32(places.size() / 3));
    for (std::size_t i = 0; i < places.size(); ++i) {
        bytes += i % 3 == 0 ? QByteArray(12, '\0') : QByteArray();
        bytes += little(float(places[i].x)) + little(float(places[i].y)) + little(float(places[i].z));
        bytes += i % 3 == 2 ? QByteArray(2, '\0') : QByteArray();
    }
    return bytes;
}

/// The positions of all corners of all triangles.
Places cornersOf(const Model &model)
{
    Places corners;
    for (const Mesh &mesh : model.meshes) {
        for (std::size_t element = 0; element < mesh.elementCount(); ++element)
            corners.push_back(mesh.position(mesh.vertexAt(element)));
    }
    return corners;
}

bool hasRemainders(const Model &model)
{
    return std::any_of(model.meshes.begin(), model.meshes.end(),
                       [](const Mesh &mesh) { return !mesh.remainders.empty(); });
}

} // namespace

class TestExactPositions : public QObject {
    Q_OBJECT

private slots:
    void aFloatAndItsRemainderAreTheNumber()
    {
        std::mt19937_64 engine(7);
        std::uniform_real_distribution<double> exponent(-125.0, 127.0), mantissa(1.0, 2.0);
        for (int i = 0; i < 100000; ++i) {
            const double value = (i % 2 == 0 ? 1.0 : -1.0) * mantissa(engine) * std::exp2(std::floor(exponent(engine)));
            const auto rounded = static_cast<float>(value);
            QCOMPARE(withRemainder(rounded, remainderOf(value, rounded)), value);
        }
        // The float is of the next power of two; halfway between two floats.
        for (const double value : {std::nextafter(2.0, 1.0), 1.0 + 0x1p-24, -(1.0 + 3 * 0x1p-24), 0.0, 1e-300, 1e-39}) {
            const auto rounded = static_cast<float>(value);
            const double again = withRemainder(rounded, remainderOf(value, rounded));
            QVERIFY(again == (std::abs(value) < double{std::numeric_limits<float>::min()} ? double{rounded} : value));
        }
    }

    void positionsAreTheFilesNumbers_data()
    {
        addColumn<QByteArray>("suffix");
        addColumn<glm::dvec3>("center");
        addColumn<double>("size");
        addColumn<int>("digits");
        for (const char *suffix : {"obj", "off", "text.ply", "double.ply", "stl"}) {
            const auto row = [suffix](const char *what, const glm::dvec3 &center, double size, int digits) {
                newRow(qPrintable(QString("%1, %2").arg(suffix, what)))
                    << QByteArray(suffix) << center << size << digits;
            };
            row("seven decimals", glm::dvec3(0.0), 10.0, 7);
            row("all digits", glm::dvec3(0.0), 10.0, 0);
            row("as far as wide", glm::dvec3(11.0, 0.0, -10.0), 10.0, 0);
            row("a map", glm::dvec3(431234.5, 5812345.6, 120.0), 300.0, 3);
            row("a map, all digits", glm::dvec3(4.3e8, -5.8e8, 120.0), 300.0, 0);
            row("small", glm::dvec3(0.0), 1e-30, 0);
            row("large", glm::dvec3(0.0), 1e30, 0);
        }
    }

    void positionsAreTheFilesNumbers()
    {
        QFETCH(QByteArray, suffix);
        QFETCH(glm::dvec3, center);
        QFETCH(double, size);
        QFETCH(int, digits);
        const Places places = placesAbout(center, size, digits);
        const QByteArray contents = suffix == "obj"        ? objOf(places)
                                    : suffix == "off"      ? offOf(places)
                                    : suffix == "text.ply" ? plyTextOf(places)
                                    : suffix == "stl"      ? stlTextOf(places)
                                                           : plyLittleOf<double>(places, "double");
        const auto model = m_folder.imported(QString("places." + suffix), contents);
        REQUIRE_MODEL(model);
        QVERIFY(hasRemainders(**model));
        const Places corners = cornersOf(**model);
        QCOMPARE(corners.size(), places.size());
        Box box;
        for (std::size_t i = 0; i < places.size(); ++i) {
            QVERIFY2(corners[i] == places[i], (written(corners[i]) + " for " + written(places[i])).constData());
            box.add(places[i]);
        }
        QVERIFY((*model)->bounds.lowest == box.lowest && (*model)->bounds.highest == box.highest);
        const Measures measures = measuresOf({"places", {}, *model, {}});
        QVERIFY(measures.box.lowest == box.lowest && measures.box.highest == box.highest);
        QVERIFY(measures.lowestHalfGap == glm::dvec3(0.0) && measures.highestHalfGap == glm::dvec3(0.0));
        QCOMPARE(measures.vertices, places.size());
    }

    void floatsHaveNoRemainders_data()
    {
        addColumn<QByteArray>("suffix");
        addColumn<glm::dvec3>("center");
        for (const char *suffix : {"float.ply", "double.ply", "stl"}) {
            newRow(qPrintable(QString("%1, about zero").arg(suffix))) << QByteArray(suffix) << glm::dvec3(0.0);
            newRow(qPrintable(QString("%1, far away").arg(suffix)))
                << QByteArray(suffix) << glm::dvec3(4e6, 5e5, 300.0);
        }
    }

    void floatsHaveNoRemainders()
    {
        QFETCH(QByteArray, suffix);
        QFETCH(glm::dvec3, center);
        Places places = placesAbout(center, 100.0, 0);
        for (glm::dvec3 &place : places)
            place = glm::dvec3(glm::vec3(place));
        const auto model = m_folder.imported(QString("places." + suffix), suffix == "stl" ? stlBinaryOf(places)
                                                                          : suffix == "double.ply"
                                                                              ? plyLittleOf<double>(places, "double")
                                                                              : plyLittleOf<float>(places, "float"));
        REQUIRE_MODEL(model);
        QVERIFY(!hasRemainders(**model));
        QVERIFY(cornersOf(**model) == places);
    }

    void placementInAFileIsInDouble()
    {
        const auto model =
            m_folder.imported("quad.gltf", quad(R"(,"translation":[0.1,1000000.7,-0.3],"scale":[1.0000001,1,1])"));
        REQUIRE_MODEL(model);
        const Mesh &mesh = (*model)->meshes.front();
        QVERIFY(mesh.position(0) == glm::dvec3(0.1, 1000000.7, -0.3));
        QVERIFY(mesh.position(3) == glm::dvec3(0.1 + 1.0000001, 1000001.7, -0.3));
    }

    void quarterTurnsAreExact()
    {
        const glm::dvec3 x(1, 0, 0), y(0, 1, 0);
        for (const auto &[degrees, image] : {std::pair(90.0, y), {-90.0, -y}, {180.0, -x}, {270.0, -y}, {360.0, x}})
            QVERIFY(glm::dvec3(worldFromObject({Rotate{degrees, {0, 0, 1}}})[0]) == image);
    }

    /// A map's coordinates, rotated and moved back to the origin: the result equals the rounded
    /// 60-digit result.
    void placementsThatCancelKeepTheirDigits()
    {
        const auto isRounded = [](const glm::dvec3 &number, const glm::dvec3 &exact) {
            const glm::dvec3 off = glm::abs(number - exact), most = 2e-16 * glm::abs(exact);
            return off.x <= most.x && off.y <= most.y && off.z <= most.z;
        };
        const glm::dmat4 m = worldFromObject({Translate{{1854545, -4995092, -1046321}}, Rotate{33, {1, 2, 3}},
                                              Translate{{451234.5, 5411234.25, 300.125}}});
        QVERIFY(isRounded(glm::dvec3(m[3]), {0.24522316122868495, 0.0015578757082460625, 0.37555369578494097}));
        QVERIFY(isRounded(glm::dvec3(m[0]), {0.8501940988064651, 0.45972977639838386, -0.25655121720107765}));

        QByteArray nested = quad(R"(,"translation":[451234.5,5411234.25,300.125]},)"
                                 R"({"children":[0],"rotation":[0.1,0.28,0.2,0.933]},)"
                                 R"({"children":[1],"translation":[1373920,-5063372,-1399885])");
        nested.replace(R"("nodes":[0])", R"("nodes":[2])");
        const auto model = m_folder.imported("nested.gltf", nested);
        REQUIRE_MODEL(model);
        QVERIFY(isRounded((*model)->meshes.front().position(0),
                          {-0.26633539861044264, -0.19209817106511756, -0.07289486118430384}));
    }

    /// The same place has the same digits in one file; two places that differ in the tenth are two.
    void equalFloatsAreNotOneVertex()
    {
        const auto model = m_folder.imported("places.stl", stlTextOf({{1.0, 0.0, 0.0},
                                                                      {2.0, 0.0, 0.0},
                                                                      {1.0, 1.0, 0.0},
                                                                      {1.0000000001, 0.0, 0.0},
                                                                      {2.0, 0.0, 0.0},
                                                                      {1.0, 1.0, 5.0}}));
        REQUIRE_MODEL(model);
        QCOMPARE((*model)->fileVertices, std::size_t{5});
        QCOMPARE(measuresOf({"places", {}, *model, {}}).vertices, std::size_t{5});
    }

    void verticesHaveTheNumbersOfTheFile_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("contents");
        const QByteArray texcoords("vt 0 0\nvt 1 0\nvt 1 1\nvn 0 0 1\nvn 0 1 0\n");
        QByteArray materials = objBox();
        materials.replace("f 5 6 7 8", "usemtl other\nf 5 6 7 8");
        materials.replace("f 3 4 8 7", "usemtl third\nf 3 4 8 7");
        newRow("OBJ") << "box.obj" << objBox();
        newRow("OBJ of three materials") << "box.obj" << materials;
        QByteArray normals = objBox(texcoords, "//1");
        normals.replace("f 5//1 6//1 7//1 8//1", "f 5//2 6//2 7//2 8//2");
        newRow("OBJ with normals") << "box.obj" << normals;
        QByteArray colors = plyHeader("ascii");
        colors.replace("end_header", "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header");
        for (int i = 0; i < 8; ++i)
            colors += corner(i) + '\n';
        int shade = 0;
        for (const auto &q : kQuads)
            colors +=
                QString("4 %1 %2 %3 %4 %5 0 0\n").arg(q[0]).arg(q[1]).arg(q[2]).arg(q[3]).arg(shade += 20).toUtf8();
        newRow("PLY with colours of faces") << "box.ply" << colors;
        newRow("PLY") << "box.ply" << plyText();
        newRow("OFF") << "box.off" << offBox();
        GltfBuilder file;
        std::vector<float> places;
        for (const auto &c : kCorners)
            places.insert(places.end(), {c[0], c[1], c[2]});
        file.add(places, "VEC3", kFloat);
        for (int part = 0; part < 3; ++part) {
            std::vector<quint16> indices;
            for (int i = 2 * part; i < 2 * part + 2; ++i) {
                const auto &q = kQuads[i];
                for (const int vertex : {q[0], q[1], q[2], q[0], q[2], q[3]})
                    indices.push_back(static_cast<quint16>(vertex));
            }
            file.add(indices, "SCALAR", kUshort);
        }
        newRow("glTF") << "box.gltf"
                       << file.json(R"(,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],"materials":[{},{}],)"
                                    R"("meshes":[{"primitives":[)"
                                    R"({"attributes":{"POSITION":0},"indices":1,"material":0},)"
                                    R"({"attributes":{"POSITION":0},"indices":2,"material":1},)"
                                    R"({"attributes":{"POSITION":0},"indices":3,"material":0}]}])");
    }

    void verticesHaveTheNumbersOfTheFile()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, contents);
        const auto model = m_folder.imported(name, contents);
        REQUIRE_MODEL(model);
        std::size_t split = 0;
        for (std::size_t m = 0; m < (*model)->meshes.size(); ++m) {
            const Mesh &mesh = (*model)->meshes[m];
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                const std::uint32_t number = (*model)->vertexNumber(m, v);
                QVERIFY(number < (*model)->fileVertices);
                // Three primitives of glTF have all eight.
                const float *expected = kCorners[number % 8];
                QVERIFY(mesh.position(v) == glm::dvec3(expected[0], expected[1], expected[2]));
                const auto place = (*model)->vertexOf(number);
                QVERIFY(place);
                QVERIFY((*model)->meshes[place->mesh].position(place->vertex) == mesh.position(v));
                QVERIFY(ray::placeOf(landmarks::AtVertex{number}, **model)->coordinates() == mesh.position(v));
            }
            split += mesh.positions.size();
        }
        QCOMPARE((*model)->fileVertices, std::size_t{name == "box.gltf" ? 24u : 8u});
        QVERIFY(split > (*model)->fileVertices || name == "box.gltf"); // at the box's edges
        QVERIFY(!(*model)->vertexOf(static_cast<std::uint32_t>((*model)->fileVertices)));
    }

private:
    ImportFolder m_folder;
};

UNPROJECTOR_TEST(TestExactPositions, threads)
#include "test_exact_positions.moc"
