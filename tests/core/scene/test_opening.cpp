// The kind that a file is opened as, and the sources of a scene's models.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "core/opening/models.h"

#include <QTemporaryDir>

#include <fstream>

using namespace unprojector;
using namespace unprojector::mesh;
using namespace unprojector::opening;
using namespace unprojector::scene_file;

namespace {

const char *const kTriangle = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

SceneFile sceneOf(const std::string &objects)
{
    return parseScene(R"({"unprojector": 1, "window": {"width": 300, "height": 200},
        "projection": {"type": "ortho", "left": -1, "right": 1, "bottom": -1, "top": 1, "near": 1, "far": 9},
        "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": [)"
                          + objects + "]}",
                      "scene.json")
        .value();
}

} // namespace

class TestOpening : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void aFileIsReadOnce()
    {
        const std::filesystem::path file = write("triangle.off", kTriangle);
        ModelFiles files;
        ModelPointer model = *files.read(file);
        QCOMPARE(*files.read(file), model);
        double done = 0.0;
        QCOMPARE(*files.read(file, [&done](double share) { return (done = share) <= 1.0; }), model);
        QCOMPARE(done, 1.0);
        QVERIFY(files.read(file, [](double) { return false; }).error().kind == base::Error::Kind::Stopped);
        QVERIFY2(*files.read(file.parent_path() / "." / "triangle.off") == model, "another name of the same file");
        QVERIFY(files.read(file.parent_path() / "other.off").error().kind == base::Error::Kind::NoFile);
        write("triangle.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 2 1 \n");
        const ModelPointer changed = *files.read(file);
        QVERIFY2(changed != model, "the file has changed");
        QCOMPARE(*files.read(file), changed);
        const std::weak_ptr<const Model> unused = std::exchange(model, nullptr);
        QVERIFY2(unused.expired(), "nobody has the model any more");
    }

    void whatWasNotPreparedIsNotKept()
    {
        const std::filesystem::path file = write("triangle.off", kTriangle);
        ModelFiles files;
        int count = 0;
        const auto prepare = [&count](Model &) { return ++count > 1; };
        QVERIFY(files.read(file, {}, prepare).error().kind == base::Error::Kind::Stopped);
        const ModelPointer model = *files.read(file, {}, prepare);
        QCOMPARE(*files.read(file, {}, prepare), model);
        QCOMPARE(count, 2);
        const std::filesystem::path other = write("other.off", kTriangle);
        const auto noMemory = [](Model &) -> bool { throw std::bad_alloc(); };
        QVERIFY(files.read(other, {}, noMemory).error().kind == base::Error::Kind::OutOfMemory);
    }

    void scenesAreToldFromModels()
    {
        QVERIFY(isMeantAsScene(write("broken.JSON", "no scene at all")));
        QVERIFY(isMeantAsScene(write("scene.txt", R"({"unprojector": 1})")));
        QVERIFY(!isMeantAsScene(write("triangle.off", kTriangle)));
        QVERIFY(!isMeantAsScene(write("model.gltf", R"({"asset": {"version": "2.0"}})")));
    }

    void theObjectsOfASceneComeInItsOrder()
    {
        const std::filesystem::path file = write("triangle.off", kTriangle),
                                    sceneFile = file.parent_path() / "scene.json";
        const SceneFile scene = sceneOf(R"({"name": "a", "file": "triangle.off"}, {"name": "pot", "bundled": "Teapot"},
                                       {"name": "b", "file": "triangle.off"})");
        QVERIFY(modelFiles(scene, sceneFile) == std::vector{file});
        int count = 0;
        const auto objects = objectsOf(scene, sceneFile, [&count](const std::filesystem::path &of) {
            ++count;
            return ReadModel(*importModel(of, {}));
        });
        QVERIFY(objects);
        QCOMPARE(count, 1);
        QCOMPARE(objects->size(), std::size_t(3));
        QVERIFY(objects->at(0).file == file && objects->at(1).file.empty());
        QCOMPARE(objects->at(0).model, objects->at(2).model);
        QCOMPARE(objects->at(0).model->triangleCount(), std::size_t(1));
        QCOMPARE(objects->at(1).model, examples::bundledModels().at("Teapot"));
        QCOMPARE(objects->at(2).name, "b");
    }

    void theFirstModelThatIsMissingIsNamed()
    {
        ModelFiles files;
        const auto read = [&files](const std::filesystem::path &file) { return files.read(file); };
        const auto errorOf = [&](const char *objects) {
            return objectsOf(sceneOf(objects), "scene.json", read).error().message();
        };
        QCOMPARE(errorOf(R"({"name": "a", "bundled": "Nessie"})"),
                 std::string("a: there is no bundled model \"Nessie\""));
        const std::string missing = errorOf(R"({"name": "a", "file": "none.off"}, {"name": "b", "bundled": "Nessie"})");
        QVERIFY2(missing.starts_with("a: none.off: "), missing.c_str());
    }

private:
    std::filesystem::path write(const char *name, const char *text) const
    {
        const std::filesystem::path file = std::filesystem::path(m_folder->path().toStdU16String()) / name;
        std::ofstream(file, std::ios::binary) << text;
        return file;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

UNPROJECTOR_TEST(TestOpening)
#include "test_opening.moc"
