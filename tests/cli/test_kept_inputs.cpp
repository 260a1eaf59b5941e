// No command overwrites a file that it reads or that its scene names, under any of its names.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QDir>

#include <filesystem>

namespace {

const QByteArray kTriangle = "mtllib face.mtl\nusemtl skin\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray kMaterials = "newmtl skin\nmap_Kd skin.jpg\nmap_Bump -bm 1 bumps.jpg\n";
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
        m_folder->write("depth.raw", QByteArray(qsizetype(800) * 600 * 4, '\0'));
        m_folder->write("points.csv", kPoints);
        m_folder->write("rows.csv", "px,py,depth\n1,2,0.5\n");
        m_folder->write("got.csv", "px,py,depth,x,y,z\n400,300,0.5,1,2,3\n");
        std::filesystem::create_hard_link(m_folder->path("face.obj").toStdU16String(),
                                          m_folder->path("hard.obj").toStdU16String());
    }

    void anotherNameOfAnInputIsRefused_data()
    {
        addColumn<QStringList>("words");
        newRow("cloud over the model") << QStringList{"cloud", "--size", "800x600", "scene.json", "depth.raw", "-o"};
        newRow("landmarks over the mesh")
            << QStringList{"landmarks", "--to", "csv", "--mesh", "face.obj", "points.csv"};
    }

    void anotherNameOfAnInputIsRefused()
    {
        QFETCH(QStringList, words);
        const QString file = m_folder->path("hard.obj");
        const QByteArray before = bytesOf(file);
        const QStringList namesBefore = names();
        const Run run = runCommand(located(words) + QStringList(file));
        QVERIFY2(run.errors.contains(file.toUtf8() + ": this is the input "), run.errors.constData());
        QVERIFY2(run.errors.endsWith(" too and would be destroyed; give another name\n"), run.errors.constData());
        QCOMPARE(run.exitCode, 2);
        QCOMPARE(bytesOf(file), before);
        QCOMPARE(names(), namesBefore);
    }

    /// Read once for each time that it is named, it would take longer than any test may.
    void aLibraryNamedManyTimesTakesNoTime()
    {
        m_folder->write("face.obj", QByteArray("mtllib face.mtl\n").repeated(200000) + kTriangle);
        m_folder->write("face.mtl", QByteArray("# oak\n").repeated(400000) + kMaterials);
        m_folder->write("bumps.jpg", "no picture");
        const Run run =
            runCommand(located({"map", "--what", "formula-matrix", "--size", "4x3", "face.obj", "-o", "bumps.jpg"}));
        QVERIFY2(run.errors.contains("bumps.jpg: this is the input "), run.errors.constData());
    }

    void nothingIsAddedToAnInput_data()
    {
        addColumn<QStringList>("words");
        addColumn<QString>("output");
        const auto add = [](const char *name, const QStringList &words, const QString &output) {
            newRow(name) << words << output;
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

private:
    QStringList names() const { return QDir(m_folder->path(".")).entryList(QDir::Files | QDir::Hidden); }
    /// Words with the folder's paths for their files.
    QStringList located(QStringList words) const
    {
        for (QString &word : words) {
            if (word.contains(u'.'))
                word = m_folder->path(word);
        }
        return words;
    }

    std::unique_ptr<Folder> m_folder;
};

UNPROJECTOR_TEST(TestKeptInputs)
#include "test_kept_inputs.moc"
