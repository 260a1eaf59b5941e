// Scenes, picks, landmarks, cameras and diagnoses through the library for other programs.
#include "tests/support/test.h"

#include "unprojector/unprojector.h"

#include <glm/geometric.hpp>

#include <QFile>
#include <QTemporaryDir>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <vector>

using namespace unprojector;

namespace {

Setup setup()
{
    return Setup::of(Perspective{}, {{0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}}, {800, 600, {}, {}}).value();
}

constexpr std::array<double, 12> kSquare{-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
constexpr std::array<std::uint32_t, 6> kTriangles{0, 1, 2, 0, 2, 3};

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

void write(const QString &name, const QByteArray &text)
{
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
}

} // namespace

class TestLibraryFiles : public QObject {
    Q_OBJECT

private slots:
    void aMeshInMemoryIsPicked()
    {
        const auto scene = Scene::of(setup(), kSquare, kTriangles);
        QVERIFY(scene);
        QCOMPARE(scene->objects().size(), std::size_t{1});
        QCOMPARE(scene->objects()[0].triangles, std::size_t{2});
        const auto picker = Picker::of(*scene);
        QVERIFY(picker);
        const Hit hit = picker->at(400.0, 300.0);
        QVERIFY(hit.isHit && !hit.isOutside);
        QVERIFY(glm::length(hit.world) < 1e-12);
        QVERIFY(std::abs(hit.distance - 5.0) < 1e-12);
        QCOMPARE(hit.normal, glm::dvec3(0.0, 0.0, 1.0));
        const Hit corner =
            picker->at(400.0 + 600.0 / 2.0 / std::tan(0.39269908169872414) / 5.0 - 2.0, 300.0 + 140.0, Snap::Vertex);
        QVERIFY(corner.isHit && corner.vertex == 1);
        QCOMPARE(corner.world, glm::dvec3(1.0, -1.0, 0.0));
        const Hit none = picker->at(5.0, 5.0), outside = picker->at(-5.0, 5.0);
        QVERIFY(!none.isHit && !none.isOutside && std::isnan(none.world.x) && none.object == -1);
        QVERIFY(!outside.isHit && outside.isOutside);
    }

    void manyPicksAreTheSingleOnes()
    {
        const auto picker = Picker::of(Scene::of(setup(), kSquare, kTriangles).value());
        QVERIFY(picker);
        std::vector<double> px, py;
        for (int i = 0; i < 5000; ++i) {
            px.push_back(i * 0.16);
            py.push_back((i * 37 % 5000) * 0.12);
        }
        std::vector<Hit> hits(px.size());
        (*picker)(px.data(), py.data(), hits.data(), hits.size(), Snap::Surface, 0);
        std::size_t count = 0;
        for (std::size_t i = 0; i < hits.size(); ++i) {
            const Hit one = picker->at(px[i], py[i]);
            QCOMPARE(hits[i].isHit, one.isHit);
            QVERIFY(!one.isHit || hits[i].world == one.world);
            count += one.isHit ? 1 : 0;
        }
        QVERIFY(count > 500 && count < 4500);
    }

    void aModelIsOpenedAndSaved()
    {
        const QTemporaryDir folder;
        write(folder.filePath(QStringLiteral("形 ä.obj")), "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
        const auto model = Scene::load(pathOf(folder.filePath(QStringLiteral("形 ä.obj"))));
        QVERIFY(model);
        QCOMPARE(model->setup().width(), 800);
        const auto file = pathOf(folder.filePath(QStringLiteral("scene.json")));
        QVERIFY(model->save(file));
        const auto scene = Scene::load(file);
        QVERIFY(scene);
        QVERIFY(scene->setup() == model->setup());
        QVERIFY(Picker::of(*scene).value().at(400.5, 300.5).isHit);
        QCOMPARE(scene->setupAt(80, 60).value().width(), 80);
        QVERIFY(!scene->setupAt(0, 60));
        const Scene made = Scene::of(setup(), kSquare, kTriangles).value();
        QVERIFY(!made.save(file));
        QVERIFY(made.setupAt(800, 600).value() == setup());
    }

    void missingFilesAreTold()
    {
        for (const char *name : {"none.json", "none.ply"}) {
            const auto scene = Scene::load(name);
            QVERIFY(!scene);
            QCOMPARE(scene.error().kind, Error::Kind::MissingFile);
            QVERIFY(scene.error().message.find(name) != std::string::npos);
        }
        const auto landmarks = Landmarks::read("none.csv");
        QVERIFY(!landmarks);
        QCOMPARE(landmarks.error().kind, Error::Kind::MissingFile);
        const auto depth = readDepth("none.png");
        QVERIFY(!depth);
        QCOMPARE(depth.error().kind, Error::Kind::MissingFile);
    }

    void wrongMeshesAreNamed()
    {
        std::vector<double> vertices(kSquare.begin(), kSquare.end());
        vertices[4] = std::numeric_limits<double>::infinity();
        QCOMPARE(Scene::of(setup(), vertices, kTriangles).error().message,
                 std::string("vertex 1 has the coordinate inf; give finite numbers"));
        const std::array<std::uint32_t, 3> outside{0, 1, 4};
        QCOMPARE(Scene::of(setup(), kSquare, outside).error().message,
                 std::string("triangle 0 has the vertex 4; there are 4 vertices, from 0"));
        QVERIFY(!Scene::of(setup(), kSquare, {}));
        const std::array<std::uint32_t, 4> more{0, 1, 2, 3};
        QCOMPARE(Scene::of(setup(), kSquare, more).error().message,
                 std::string("triangles has 4 numbers; give three vertex numbers a triangle"));
        QCOMPARE(Scene::of(setup(), std::span(kSquare).first(11), std::span(more).first(3)).error().message,
                 std::string("vertices has 11 numbers; give three coordinates a vertex"));
    }

    void landmarksComeBack()
    {
        const QTemporaryDir folder;
        Specimen specimen;
        specimen.name = "skull";
        specimen.landmarks.resize(3);
        specimen.landmarks[0].name = "nasion";
        specimen.landmarks[0].world = glm::dvec3(1.0, 2.0, 0.1);
        specimen.landmarks[1].name = "bregma";
        specimen.landmarks[1].absence = Absence::Missing;
        specimen.landmarks[2].name = "lambda";
        specimen.landmarks[2].world = glm::dvec3(-4.0, 5.0, 1e-7);
        const auto file = pathOf(folder.filePath(QStringLiteral("skull.csv")));
        QVERIFY(Landmarks::of({specimen}).write(file));
        const auto read = Landmarks::read(file);
        QVERIFY(read);
        const auto &landmarks = read->specimens().front().landmarks;
        QCOMPARE(landmarks.size(), std::size_t{3});
        QCOMPARE(landmarks[2].world.value(), glm::dvec3(-4.0, 5.0, 1e-7));
        QVERIFY(!landmarks[1].world && landmarks[1].absence == Absence::Missing);
        const auto lost = read->write(pathOf(folder.filePath(QStringLiteral("skull.tps"))));
        QVERIFY(lost && !lost->empty()); // TPS has no names
        QVERIFY(!read->write(pathOf(folder.filePath(QStringLiteral("skull.ljson")))));
    }

    void aCameraIsRead()
    {
        const std::string text =
            R"({"K": [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]], "R": [[1,0,0],[0,1,0],[0,0,1]], "t": [0, 0, 2], "image_size": [640, 480]})";
        CameraChoices choices;
        choices.nearDistance = 0.1;
        choices.farDistance = 10.0;
        const auto read = readCamera(std::vector<CameraText>{{"camera.json", text}}, choices);
        QVERIFY(read);
        QCOMPARE(read->program, std::string("OpenCV"));
        const glm::dmat3 K(500, 0, 0, 0, 500, 0, 319.5, 239.5, 1);
        const auto same = Setup::fromOpenCv(K, glm::dmat3(1.0), {0.0, 0.0, 2.0}, {640, 480, {}, {}}, 0.1, 10.0);
        QVERIFY(same);
        QVERIFY(*same == read->setup);
        choices.axes = "sideways";
        QCOMPARE(readCamera(std::vector<CameraText>{{"camera.json", text}}, choices).error().message,
                 std::string("there are no axes \"sideways\"; known: opengl, opencv, direct3d, unreal, ros"));
    }

    void aMistakeIsFound()
    {
        const auto unprojection = Unprojection::of(setup());
        QVERIFY(unprojection);
        std::vector<WrongPoint> points;
        for (const auto &[px, py, depth] : {std::array{100.5, 50.5, 0.9}, {300.5, 500.5, 0.8}, {700.5, 222.5, 0.95}}) {
            WrongPoint point;
            point.pixel = {px, py};
            point.depth = depth;
            point.got = unprojection->at({px, 600.0 - py}, depth).value(); // y is not flipped
            point.lastDigit = glm::dvec3(1e-6);
            points.push_back(point);
        }
        const auto diagnosis = diagnose(setup(), points);
        QVERIFY(diagnosis);
        QCOMPARE(diagnosis->verdict, std::string("y-not-flipped"));
        QVERIFY(diagnosis->right == unprojection->at(points[0].pixel, *points[0].depth).value());
        QVERIFY(!diagnosis->code.empty() && !diagnosis->sentence.empty());
        QVERIFY(diagnosis->report.find("y-not-flipped") != std::string::npos);
        QVERIFY(!diagnose(setup(), {}));
        points[1].lastDigit.y = 0.0;
        QCOMPARE(diagnose(setup(), points).error().message,
                 std::string("pixel[1]: the unit of a last digit is 0; it must be greater than 0"));
        QVERIFY(!diagnose(setup(), std::vector<WrongPoint>(101, points[0])));
    }

    void aSetupComesBackFromItsText()
    {
        const auto given = setup();
        const auto again = Setup::fromSceneText(given.sceneText());
        QVERIFY(again);
        QVERIFY(*again == given);
        QVERIFY(!Setup::fromSceneText("{"));
        const auto vulkan = given.matrices("vulkan").value();
        const auto back = Setup::fromMatrices(vulkan.clipFromEye, vulkan.eyeFromWorld, {800, 600, {}, {}}, "vulkan");
        QVERIFY(back);
        QVERIFY(back->findings().empty());
        QVERIFY(given.matrices("gl").error().message.starts_with("there are no conventions \"gl\"; known: opengl, "));
    }
};

UNPROJECTOR_TEST(TestLibraryFiles)
#include "test_library_files.moc"
