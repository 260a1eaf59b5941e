// Models at survey coordinates, (4·10⁶, 5·10⁵, 300), with details of a millimetre: opened from a
// file of every format that can hold them, drawn, and clicked.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/text/formula_text.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/mesh_model.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QTemporaryDir>
#include <QtEndian>

#include <glm/geometric.hpp>

#include <bit>
#include <cmath>

using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::mesh;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

constexpr double kMillimetre = 1e-3;
const glm::dvec3 kCorner{4000000.123, 500000.456, 300.789};

/// A field of 4 x 4 squares of 2 cm, each with a height of its own: steps of two millimetres.
constexpr int kSquares = 4;
constexpr double kEdge = 20.0 * kMillimetre;

double heightOf(int square)
{
    return (square * 7 % (kSquares * kSquares)) * 2.0 * kMillimetre;
}

/// The corners of a square, counter-clockwise from above, relative to the field's corner.
std::vector<glm::dvec3> cornersOf(int square)
{
    const double x = square % kSquares * kEdge, y = square / kSquares * kEdge, z = heightOf(square);
    return {{x, y, z}, {x + kEdge, y, z}, {x + kEdge, y + kEdge, z}, {x, y + kEdge, z}};
}

glm::dvec3 middleOf(int square)
{
    const std::vector<glm::dvec3> corners = cornersOf(square);
    return kCorner + (corners[0] + corners[2]) / 2.0;
}

constexpr int kCount = kSquares * kSquares;

std::vector<glm::dvec3> allCorners()
{
    std::vector<glm::dvec3> all;
    for (int square = 0; square < kCount; ++square) {
        for (const glm::dvec3 &corner : cornersOf(square))
            all.push_back(corner);
    }
    return all;
}

/// "4000000.123 500000.456 300.789"
QByteArray written(const glm::dvec3 &v)
{
    return QByteArray::number(v.x, 'f', 3) + ' ' + QByteArray::number(v.y, 'f', 3) + ' '
           + QByteArray::number(v.z, 'f', 3);
}

/// @param line  of a square whose first corner has this number
template <class Line>
QByteArray squares(Line line)
{
    QByteArray text;
    for (int square = 0; square < kCount; ++square)
        text += line(4 * square);
    return text;
}

QByteArray corners(const char *head = "")
{
    QByteArray text;
    for (const glm::dvec3 &corner : allCorners())
        text += head + written(kCorner + corner) + '\n';
    return text;
}

/// "4 0 1 2 3"
QByteArray indexed(int first)
{
    QByteArray line = "4";
    for (int i = first; i < first + 4; ++i)
        line += ' ' + QByteArray::number(i);
    return line + '\n';
}

QByteArray obj()
{
    return corners("v ") + squares([](int first) {
               QByteArray line = "f";
               for (int i = first; i < first + 4; ++i)
                   line += ' ' + QByteArray::number(i + 1);
               return line + '\n';
           });
}

QByteArray off()
{
    return "OFF\n" + QByteArray::number(4 * kCount) + ' ' + QByteArray::number(kCount) + " 0\n" + corners()
           + squares(indexed);
}

QByteArray plyHead(const char *format)
{
    return QByteArray("ply\nformat ") + format + " 1.0\nelement vertex " + QByteArray::number(4 * kCount)
           + "\nproperty double x\nproperty double y\nproperty double z\nelement face " + QByteArray::number(kCount)
           + "\nproperty list uchar int vertex_indices\nend_header\n";
}

template <class Number>
void append(QByteArray &bytes, Number number)
{
    number = qToLittleEndian(number);
    bytes.append(reinterpret_cast<const char *>(&number), sizeof number);
}

QByteArray binaryPly()
{
    QByteArray bytes = plyHead("binary_little_endian");
    for (const glm::dvec3 &corner : allCorners()) {
        for (int axis = 0; axis < 3; ++axis)
            append(bytes, std::bit_cast<quint64>(kCorner[axis] + corner[axis]));
    }
    for (int first = 0; first < 4 * kCount; first += 4) {
        bytes += char(4);
        for (int i = first; i < first + 4; ++i)
            append(bytes, static_cast<qint32>(i));
    }
    return bytes;
}

QByteArray stl()
{
    const std::vector<glm::dvec3> all = allCorners();
    return "solid field\n" + squares([&all](int first) {
               QByteArray text;
               for (const auto &[a, b, c] : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
                   text += "facet normal 0 0 1\nouter loop\n";
                   for (const int i : {a, b, c})
                       text += "vertex " + written(kCorner + all[static_cast<std::size_t>(first + i)]) + '\n';
                   text += "endloop\nendfacet\n";
               }
               return text;
           })
           + "endsolid field\n";
}

/// Singles about a node that is far away.
QByteArray gltf()
{
    QByteArray buffer;
    for (const glm::dvec3 &corner : allCorners()) {
        for (int axis = 0; axis < 3; ++axis)
            append(buffer, std::bit_cast<quint32>(static_cast<float>(corner[axis])));
    }
    const auto positionBytes = buffer.size();
    for (int first = 0; first < 4 * kCount; first += 4) {
        for (const int i : {0, 1, 2, 0, 2, 3})
            append(buffer, static_cast<quint16>(first + i));
    }
    const auto number = [](auto value) { return QByteArray::number(value); };
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0,"translation":[)"
           + written(kCorner).replace(' ', ',')
           + R"(]}],"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[
             {"bufferView":0,"componentType":5126,"count":)"
           + number(4 * kCount) + R"(,"type":"VEC3"},{"bufferView":1,"componentType":5123,"count":)"
           + number(6 * kCount) + R"(,"type":"SCALAR"}],"bufferViews":[{"buffer":0,"byteLength":)"
           + number(positionBytes) + R"(},{"buffer":0,"byteOffset":)" + number(positionBytes) + R"(,"byteLength":)"
           + number(buffer.size() - positionBytes) + R"(}],"buffers":[{"byteLength":)" + number(buffer.size())
           + R"(,"uri":"data:application/octet-stream;base64,)" + buffer.toBase64() + "\"}]}";
}

} // namespace

namespace {

/// A pyramid that looks to +z.
std::vector<SceneObject> pyramid(float size, bool isFlat)
{
    Mesh mesh;
    for (const glm::vec3 &corner :
         {glm::vec3(-1, -1, 0), glm::vec3(1, -1, 0), glm::vec3(1, 1, 0), glm::vec3(-1, 1, 0), glm::vec3(0, 0, 1)}) {
        mesh.positions.push_back(size * corner);
        if (!isFlat)
            mesh.normals.push_back(glm::normalize(corner + glm::vec3(0, 0, 1)));
    }
    mesh.indices = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4};
    return {{"pyramid", {}, modelOf(std::move(mesh)), {}}};
}

} // namespace

class TestFarModels : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void millimetresArePicked_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        newRow("OBJ") << "field.obj" << obj();
        newRow("PLY") << "field.ply" << plyHead("ascii") + corners() + squares(indexed);
        newRow("binary PLY") << "field.ply" << binaryPly();
        newRow("OFF") << "field.off" << off();
        newRow("STL") << "field.stl" << stl();
        newRow("glTF") << "field.gltf" << gltf();
    }

    void millimetresArePicked()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QTemporaryDir folder;
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();

        const auto window = shownWindow(false, {500, 420});
        window->session().openFiles({std::filesystem::path(file.fileName().toStdU16String())});
        QVERIFY(QTest::qWaitFor([&] { return !window->session().isLoading(); }, kPatienceMilliseconds));
        SceneDocument &document = window->document();
        QCOMPARE(document.objects().size(), std::size_t(1));
        QCOMPARE(document.objects()[0].model->triangleCount(), std::size_t(2 * kCount));
        // The eye is above, somewhat to the side: no step hides the middle of a square.
        const glm::dvec3 middle = kCorner + glm::dvec3(2.0 * kEdge, 2.0 * kEdge, 15.0 * kMillimetre);
        for (const glm::dvec3 &way : {glm::dvec3(0.02, -0.04, 0.16), glm::dvec3(-0.05, 0.01, 0.2)}) {
            setCamera(document, {WorldPoint(middle + way), WorldPoint(middle), {0.0, 1.0, 0.0}});
            SceneView &view = window->view();
            (void)view.grabFramebuffer();
            for (int square = 0; square < kCount; ++square) {
                const QPointF local = localOf(*window, middleOf(square));
                click(view, local);
                QVERIFY(document.picks().pick());
                const Pick &pick = *document.picks().pick();
                QVERIFY2(pick.hit(), qPrintable(QStringLiteral("square %1").arg(square)));
                const glm::dvec3 truth = onPlane(rayThrough(pick.setup, windowOf(view, pixelUnder(view, local))),
                                                 middleOf(square), {0, 0, 1});
                const glm::dvec3 picked = pick.point.world[Method::Formula]->coordinates();
                const double off = glm::length(picked - truth);
                QVERIFY2(off < 0.25 * kMillimetre,
                         qPrintable(QStringLiteral("square %1: %2 mm off").arg(square).arg(off / kMillimetre)));
                QVERIFY(glm::length(picked - middleOf(square)) < kMillimetre);
            }
        }
        // The text of the formulas is readable.
        const QString text = formulasOf(*document.picks().pick()).text();
        QVERIFY2(text.contains(QStringLiteral("(4000000.")) && text.contains(QStringLiteral(", 500000."))
                     && !text.contains(u'e' + QStringLiteral("+0")),
                 qPrintable(text));
    }

    void theLargestAndTheSmallestAreDrawnAsOthers_data()
    {
        addColumn<float>("size");
        addColumn<bool>("isFlat");
        for (const bool isFlat : {false, true}) {
            for (const float size : {1e-29f, 1e-18f, 1e18f, 1e25f, 1e38f})
                addRow("%g, %s", double(size), isFlat ? "flat" : "smooth") << size << isFlat;
        }
    }

    void theLargestAndTheSmallestAreDrawnAsOthers()
    {
        QFETCH(float, size);
        QFETCH(bool, isFlat);
        const auto window = shownWindow(false, {500, 420});
        SceneDocument &document = window->document();
        SceneView &view = window->view();
        const QPointF local(view.width() / 2 + 20.5, view.height() / 2 - 15.5);
        glm::dvec3 usual(0.0);
        QColor usualColor;
        for (const float factor : {1.0f, size}) {
            openObjects(document, pyramid(factor, isFlat));
            const QColor color = view.grabFramebuffer().pixelColor(local.toPoint());
            click(view, local);
            QVERIFY(document.picks().pick() && document.picks().pick()->hit());
            const glm::dvec3 picked =
                document.picks().pick()->point.world[Method::Formula]->coordinates() / double(factor);
            if (factor == 1.0f) {
                usual = picked;
                usualColor = color;
                continue;
            }
            QVERIFY2(glm::length(picked - usual) < 1e-5, qPrintable(QString::number(glm::length(picked - usual))));
            QVERIFY2(std::abs(color.lightness() - usualColor.lightness()) < 3,
                     qPrintable(QStringLiteral("%1 for %2").arg(color.name(), usualColor.name())));
        }
    }
};

UNPROJECTOR_TEST(TestFarModels, display)
#include "test_far_models.moc"
