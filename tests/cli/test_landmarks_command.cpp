// `unproject landmarks`: from one file of landmarks to another, and tables of folders of them.

#include "tests/support/test.h"

#include "tests/cli/command.h"

#include <QDir>

#include <filesystem>

namespace {

const QByteArray kPicked = "<!DOCTYPE PickedPoints>\n<PickedPoints>\n"
                           " <point x=\"0.1\" y=\"-2\" z=\"3\" active=\"1\" name=\"Nasion\"/>\n"
                           " <point x=\"0\" y=\"0\" z=\"0\" active=\"0\" name=\"gone\"/>\n</PickedPoints>\n";
const QByteArray kTable = "name,x,y,z,object,face,u,v,w,note\nNasion,0.1,-2,3,,,,,,\ngone,,,,,,,,,\n";
const QByteArray kPts = "Version 1.0\n2\nNasion 0.1 -2 3\ngone 9999 9999 9999\n\n";

QByteArray bytesOf(const QString &file)
{
    QFile opened(file);
    return opened.open(QIODevice::ReadOnly) ? opened.readAll() : QByteArray("none");
}

} // namespace

class TestLandmarksCommand : public QObject {
    Q_OBJECT

private slots:
    /// A hundred files, one of them broken.
    void aFolderToATable()
    {
        QVERIFY(QDir().mkpath(m_folder.path("many")));
        for (int i = 0; i < 100; ++i) {
            const QString name = QString("many/skull%1").arg(i, 2, 10, QLatin1Char('0'));
            if (i == 42)
                m_folder.write(name + ".pts", "Version 1.0\n2\nNasion 1 2\n");
            else if (i % 3 == 0)
                m_folder.write(name + ".pp", kPicked);
            else if (i % 3 == 1)
                m_folder.write(name + ".pts", kPts);
            else
                m_folder.write(name + ".mrk.json",
                               R"({"markups": [{"controlPoints": [{"label": "Nasion", "position": [0.1, -2, 3]},
                           {"label": "gone", "positionStatus": "undefined"}]}]})");
        }
        m_folder.write("many/readme.txt", "no landmarks");
        m_folder.write("many/scene.json", "{\"unprojector\": 1}");
        const QString output = m_folder.path("many/all.csv");
        for (int time = 0; time < 2;
             ++time) { // the table lies in the folder itself: the second time it is not one of the files
            const Run run = runCommand({"landmarks", "--table", m_folder.path("many"), "-o", output});
            QCOMPARE(run.exitCode, 1);
            QCOMPARE(run.errors,
                     m_folder.path("many/skull42.pts").toUtf8()
                         + ":3: \"Nasion 1 2\" is not a point; write its name, x, y and z\n" + output.toUtf8()
                         + ": 99 landmarks have no coordinates (not placed: 99, skipped: 0, missing on their "
                           "specimens: 0)\n");
            const QList<QByteArray> lines = bytesOf(output).trimmed().split('\n');
            QCOMPARE(lines.size(), 1 + 2 * 99);
            QCOMPARE(lines[0], QByteArray("specimen,name,x,y,z,object,face,u,v,w,note"));
            for (int i = 0, row = 1; i < 100; ++i) {
                if (i == 42)
                    continue;
                const QByteArray name = "skull" + QByteArray::number(i).rightJustified(2, '0');
                QCOMPARE(lines[row++], name + ",Nasion,0.1,-2,3,,,,,,");
                QCOMPARE(lines[row++], name + ",gone,NA,NA,NA,,,,,,");
            }
        }
    }

    /// A data set whose file is not there is no smaller data set.
    void aLinkToNothingIsReported()
    {
        QVERIFY(QDir().mkpath(m_folder.path("links")));
        m_folder.write("links/a.csv", kTable);
        std::error_code error;
        std::filesystem::create_symlink("gone.csv",
                                        std::filesystem::path(m_folder.path("links/b.csv").toStdU16String()), error);
        if (error)
            QSKIP("this system lets the test make no links");
        const Run run = runCommand({"landmarks", "--table", m_folder.path("links"), "-o", "-", "--format", "wide"});
        QCOMPARE(run.exitCode, 1);
        QVERIFY2(run.errors.startsWith(m_folder.path("links/b.csv").toUtf8() + ": "), run.errors.constData());
    }

private:
    Folder m_folder;
};

UNPROJECTOR_TEST(TestLandmarksCommand)
#include "test_landmarks_command.moc"
