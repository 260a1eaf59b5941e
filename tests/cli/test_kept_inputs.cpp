// No command overwrites a file that it reads or that its scene names, under any of its names.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QDir>

#include <filesystem>

namespace {

const QByteArray kTriangle = "mtllib face.mtl\nusemtl skin\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray kMaterials = "newmtl skin\nmap_Kd skin.jpg\nmap_Bump -bm 1 bumps.jpg\n";
const QByteArray kGltf =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
  "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
  "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"uri": "face.bin", "byteLength": 36}, {"uri": "motion.bin", "byteLength": 4}]})";
const QByteArray kPoints = "x,y,z\n0,0,0\n";

QByteArray bytesOf(const QString &file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray("none");
}

} // namespace

class TestKeptInputs : public QObject {
    Q_OBJECT

private slots:
    void init()
    {
        m_folder = std::make_unique<Folder>();
        m_folder->write("scene.json", kFrustumScene);
        m_folder->write("face.obj", kTriangle);
        m_folder->write("face.mtl", kMaterials);
        m_folder->write("skin.jpg", "no picture");
        m_folder->write("face.gltf", kGltf);
        m_folder->write("face.bin", QByteArray(12, '\0') + QByteArray("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12)
                                        + QByteArray("\0\0\0\0\0\0\x80\x3f\0\0\0\0", 12));
        m_folder->write("bumps.jpg", "no picture");
        m_folder->write("motion.bin", "1234");
        m_folder->write("face.ply",
                        "ply\nformat ascii 1.0\ncomment TextureFile skin.jpg\nelement vertex 3\nproperty float x\n"
                        "property float y\nproperty float z\nelement face 1\n"
                        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
        for (const QByteArray suffix : {"gltf", "ply"}) {
            QByteArray scene = kFrustumScene;
            m_folder->write(QString::fromLatin1(suffix + ".json"), scene.replace("face.obj", "face." + suffix));
        }
        m_folder->write("depth.raw", QByteArray(qsizetype(800) * 600 * 4, '\0'));
        m_folder->write("points.csv", kPoints);
        m_folder->write("rows.csv", "px,py,depth\n1,2,0.5\n");
        m_folder->write("got.csv", "px,py,depth,x,y,z\n400,300,0.5,1,2,3\n");
        QVERIFY(QDir(m_folder->path(".")).mkdir("folder"));
        m_folder->write("folder/one.csv", kPoints);
        m_folder->write("folder/two.csv", kPoints);
        m_folder->write("folder/many.tps", "LM3=1\n1 2 3\nID=one\nLM3=1\n1 2 3\nID=three\n");
        QVERIFY(QDir(m_folder->path(".")).mkdir("scans"));
        for (const char *file : {"s1.ply.points.csv", "s1.ply.points-2.csv", "s2.ply.points.csv"})
            m_folder->write(QStringLiteral("scans/") + file, "name,x,y,z\na,1,2,3\n");
        m_folder->write("scans/bad.ply.points.csv", "name,x,y,z\na,1,2,\"\n");
        std::filesystem::create_hard_link(m_folder->path("face.obj").toStdU16String(),
                                          m_folder->path("hard.obj").toStdU16String());
    }

    void anInputIsRefused_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("output");
        const auto add = [](const char *name, const QStringList &words, const QString &output) {
            QTest::newRow(name) << words << output;
        };
        const QStringList cloud{"cloud", "--size", "800x600", "scene.json", "depth.raw", "-o"};
        const QStringList code{"code", "--for", "glm", "scene.json", "-o"};
        const QStringList map{"map", "--what", "formula-matrix", "--size", "4x3"};
        add("cloud over the scene", cloud, "scene.json");
        add("cloud over the depths", cloud, "depth.raw");
        add("cloud over the colors",
            {"cloud", "--size", "800x600", "--color", "skin.jpg", "scene.json", "depth.raw", "-o"}, "skin.jpg");
        add("cloud over the model", cloud, "face.obj");
        add("cloud over the model's other name", cloud, "hard.obj");
        add("code over the scene", code, "scene.json");
        add("code over the model", code, "face.obj");
        add("code over the model by another way", code, "folder/../face.obj");
        const QStringList gltf{"code", "--for", "glm", "gltf.json", "-o"};
        add("cloud over the model's materials", cloud, "face.mtl");
        add("code over the model's materials", code, "face.mtl");
        add("code over a picture", code, "skin.jpg");
        add("code over a picture that is not shown", code, "bumps.jpg");
        add("code over a buffer", gltf, "face.bin");
        add("code over a buffer that is not read", gltf, "motion.bin");
        add("code over the picture of a PLY", {"code", "--for", "glm", "ply.json", "-o"}, "skin.jpg");
        add("map over a picture that is not shown", map + QStringList{"face.obj", "-o"}, "bumps.jpg");
        add("map over the scene", map + QStringList{"scene.json", "-o"}, "scene.json");
        add("map over the model", map + QStringList{"scene.json", "-o"}, "face.obj");
        add("map over the scene's materials", map + QStringList{"scene.json", "-o"}, "face.mtl");
        add("map over the materials", map + QStringList{"face.obj", "-o"}, "face.mtl");
        add("map over a texture of a kind that is not known", map + QStringList{"face.obj", "-o"}, "skin.jpg");
        add("map over a buffer", map + QStringList{"face.gltf", "-o"}, "face.bin");
        add("landmarks over themselves", {"landmarks", "points.csv"}, "points.csv");
        add("landmarks over the mesh", {"landmarks", "--to", "csv", "--mesh", "face.obj", "points.csv"}, "hard.obj");
        add("landmarks over the mesh's materials", {"landmarks", "--to", "csv", "--mesh", "face.obj", "points.csv"},
            "face.mtl");
        add("repeats over the second", {"landmarks", "--repeats", "points.csv", "folder/one.csv", "-o"},
            "folder/one.csv");
        add("a table over one of its files", {"landmarks", "--table", "folder", "-o"}, "folder/one.csv");
        for (const QString file :
             {"scans/s1.ply.points.csv", "scans/s1.ply.points-2.csv", "scans/bad.ply.points.csv"}) {
            add(qPrintable("repeats over " + file), {"landmarks", "--repeats", "scans", "-o"}, file);
            add(qPrintable("errors over " + file), {"landmarks", "--repeats", "scans", "-o", "scans/r.csv", "--errors"},
                file);
            add(qPrintable("a table over " + file), {"landmarks", "--table", "scans", "-o"}, file);
            add(qPrintable("sliders over " + file), {"landmarks", "--table", "scans", "-o", "scans/r.csv", "--sliders"},
                file);
        }
        add("a table over specimens of its own", {"landmarks", "--table", "folder", "--format", "tps", "-o"},
            "folder/many.tps");
    }

    void anInputIsRefused()
    {
        QFETCH(QStringList, words);
        QFETCH(QString, output);
        const QString file = m_folder->path(output);
        const QByteArray before = bytesOf(file);
        const QStringList namesBefore = names();
        const Run run = runCommand(located(words) + QStringList(file));
        QVERIFY2(run.errors.contains(file.toUtf8() + ": this is the input "), run.errors.constData());
        QVERIFY2(run.errors.endsWith(" too and would be destroyed; give another name\n"), run.errors.constData());
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(bytesOf(file), before);
        QCOMPARE(names(), namesBefore);
        QCOMPARE(bytesOf(m_folder->path("scans/r.csv")), QByteArray("none"));
    }

    /// Read once for each time that it is named, it would take longer than any test may.
    void aLibraryNamedManyTimesTakesNoTime()
    {
        m_folder->write("face.obj", QByteArray("mtllib face.mtl\n").repeated(200000) + kTriangle);
        m_folder->write("face.mtl", QByteArray("# oak\n").repeated(400000) + kMaterials);
        const Run run =
            runCommand(located({"map", "--what", "formula-matrix", "--size", "4x3", "face.obj", "-o", "bumps.jpg"}));
        QVERIFY2(run.errors.contains("bumps.jpg: this is the input "), run.errors.constData());
    }

    void nothingIsAddedToAnInput_data()
    {
        QTest::addColumn<QStringList>("words");
        QTest::addColumn<QString>("output");
        const auto add = [](const char *name, const QStringList &words, const QString &output) {
            QTest::newRow(name) << words << output;
        };
        add("info", {"info", "scene.json"}, "scene.json");
        add("info, the materials", {"info", "face.obj"}, "face.mtl");
        add("matrices", {"matrices", "scene.json"}, "face.obj");
        add("compare", {"compare", "--pixels", "1", "scene.json"}, "face.obj");
        add("points, the scene", {"points", "scene.json", "rows.csv"}, "scene.json");
        add("points, the model", {"points", "scene.json", "rows.csv"}, "face.obj");
        add("project", {"project", "scene.json", "points.csv"}, "scene.json");
        add("pick, the rows", {"pick", "scene.json", "rows.csv"}, "rows.csv");
        add("pick, the model", {"pick", "scene.json", "rows.csv"}, "face.obj");
        add("pick at, the model", {"pick", "scene.json", "--at", "1,2"}, "face.obj");
        add("doctor, the points", {"doctor", "scene.json", "--points", "got.csv"}, "got.csv");
        add("doctor, the scene", {"doctor", "scene.json", "--points", "got.csv"}, "scene.json");
    }

    void nothingIsAddedToAnInput()
    {
        if (!QFile::exists("/dev/stdout"))
            QSKIP("stdout has no name here");
        QFETCH(QStringList, words);
        QFETCH(QString, output);
        const QString file = m_folder->path(output);
        const QByteArray before = bytesOf(file);
        QProcess process;
        process.setStandardOutputFile(file, QIODevice::Append);
        process.start(QStringLiteral(UNPROJECT_COMMAND), located(words));
        QVERIFY(process.waitForFinished(kPatienceMilliseconds));
        const QByteArray errors = process.readAllStandardError();
        QVERIFY2(errors.contains("stdout: this is the input "), errors.constData());
        QCOMPARE(process.exitCode(), 2);
        QCOMPARE(bytesOf(file), before);
    }

    /// It is no input: all that is in it comes from the folder's other files.
    void anEarlierTableOfAFolderIsReplaced()
    {
        for (const char *format : {"long", "wide", "tps", "nts"}) {
            const QString table = m_folder->path(QStringLiteral("folder/all.")
                                                 + (format == QByteArray("tps")   ? "tps"
                                                    : format == QByteArray("nts") ? "nts"
                                                                                  : "csv"));
            for (int time = 0; time < 2; ++time) {
                const Run run =
                    runCommand({"landmarks", "--table", m_folder->path("folder"), "--format", format, "-o", table});
                QVERIFY2(run.exitCode == 0, run.errors.constData());
                QVERIFY(bytesOf(table) != "none");
            }
            QVERIFY(QFile::remove(table));
        }
    }

private:
    QStringList names() const { return QDir(m_folder->path(".")).entryList(QDir::Files | QDir::Hidden); }
    /// Words with the folder's paths for their files.
    QStringList located(QStringList words) const
    {
        for (QString &word : words) {
            if (word.contains(u'.') || word == QStringLiteral("folder") || word == QStringLiteral("scans"))
                word = m_folder->path(word);
        }
        return words;
    }

    std::unique_ptr<Folder> m_folder;
};

UNPROJECTOR_TEST(TestKeptInputs)
#include "test_kept_inputs.moc"
