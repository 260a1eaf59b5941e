#include "tests/support/test.h"

#include "gui/document/scene_edits.h"

// Points from files and into files, alone and with their models.

#include "tests/gui/landmarks/landmark_desk.h"
#include "tests/support/patience.h"

#include <QSignalSpy>

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

class TestOpenedLandmarks : public LandmarksTest {
    Q_OBJECT

private slots:
    void init() { begin(); }

    void pointFilesByName_data()
    {
        addColumn<QString>("name");
        addColumn<bool>("is");
        newRow("picked points") << "a.pp" << true;
        newRow("in capitals") << "A.PP" << true;
        newRow("markups") << "a.mrk.json" << true;
        newRow("a scene") << "a.json" << false;
        newRow("a template") << "a.pptpl" << false;
        newRow("NTSYS") << "a.nts" << true;
        newRow("a picking list") << "a.txt" << true;
        newRow("sliders") << "a.Sliders.csv" << false;
        newRow("a model") << "a.ply" << false;
        newRow("no suffix") << "points" << false;
    }

    void pointFilesByName()
    {
        QFETCH(QString, name);
        QFETCH(bool, is);
        QCOMPARE(LandmarkFiles::isLandmarkFile(name.toStdU16String()), is);
    }

    void openedWithTheirModel()
    {
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
        open({QStringLiteral("p.csv"), QStringLiteral("square.obj")});
        QCOMPARE(m_failures, QStringList());
        QCOMPARE(points().size(), std::size_t(1));
        QCOMPARE(points()[0].object, std::string("square.obj"));
        // The points belong to no object without the model.
        init();
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
        open({QStringLiteral("p.csv"), QStringLiteral("none.obj")});
        QCOMPARE(m_failures.size(), 1);
        QVERIFY(points().empty());
    }

    void openedAlone()
    {
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\nb,,,\n");
        open({QStringLiteral("p.csv")});
        QCOMPARE(m_document->objects().size(), std::size_t(1));
        QCOMPARE(points().size(), std::size_t(2));
        QVERIFY(!points()[1].isPlaced());
        m_document->undoStack().undo();
        QVERIFY(points().empty());
    }

    void pointsWithoutAnObjectAreInSight()
    {
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1000,2000,30\nb,1400,2100,40\n");
        QSignalSpy noticed(m_files.get(), &LandmarkFiles::noticed);
        open({QStringLiteral("p.csv")});
        QCOMPARE(points().size(), std::size_t(2));
        QVERIFY(noticed.count() == 1 && noticed[0][0].toString().contains(QStringLiteral("No object")));
        const glm::dmat4 clipFromScene = *clipFromWorld(m_document->setup());
        for (const Landmark &landmark : points()) {
            const glm::dvec4 clip = clipFromScene * glm::dvec4(landmark.world->coordinates(), 1.0);
            QVERIFY(clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w);
        }
    }

    void importedPointsAreTied()
    {
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0.125\n");
        QSignalSpy noticed(m_files.get(), &LandmarkFiles::noticed);
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(points()[0].world->coordinates(), glm::dvec3(1.0, 2.0, 0.0));
        QVERIFY(std::holds_alternative<landmarks::OnTriangle>(points()[0].anchor));
        QCOMPARE(m_answers->strayText, QString());
        QCOMPARE(noticed.count(), 1);
        QVERIFY2(noticed[0][0].toString().contains(QStringLiteral("0.13 (a)"))
                     || noticed[0][0].toString().contains(QStringLiteral("0.12 (a)")),
                 qPrintable(noticed[0][0].toString()));
    }

    void straysAreAskedAbout_data()
    {
        addColumn<int>("answer");
        addColumn<bool>("isRead");
        addColumn<double>("z");
        newRow("moved onto the mesh") << int(LandmarkFileQuestions::Stray::Tie) << true << 0.0;
        newRow("left where they are") << int(LandmarkFileQuestions::Stray::LeaveFree) << true << 5.0;
        newRow("given up") << int(LandmarkFileQuestions::Stray::Cancel) << false << 0.0;
    }

    void straysAreAskedAbout()
    {
        QFETCH(int, answer);
        QFETCH(bool, isRead);
        QFETCH(double, z);
        m_answers->stray = static_cast<LandmarkFileQuestions::Stray>(answer);
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\nfar,3,4,5\n");
        QCOMPARE(m_files->importFrom(file(QStringLiteral("p.csv"))), isRead);
        QVERIFY2(m_answers->strayText.contains(QStringLiteral("“far” is 5 away")), qPrintable(m_answers->strayText));
        QCOMPARE(points().size(), std::size_t(isRead ? 2 : 0));
        if (isRead) {
            QCOMPARE(points()[1].world->z, z);
            QCOMPARE(std::holds_alternative<landmarks::Free>(points()[1].anchor), z != 0.0);
        }
    }

    void whatDoesNotHoldIsLetGo_data()
    {
        addColumn<QByteArray>("held");
        addColumn<QString>("said");
        newRow("a triangle") << QByteArray(R"({"triangle": 1, "barycentric": [0.5, 0.25, 0.25]})") << "";
        newRow("no such triangle") << QByteArray(R"({"triangle": 2, "barycentric": [0.5, 0.25, 0.25]})")
                                   << "does not exist: 1, such as “a” (triangle 2)";
        newRow("no such vertex") << QByteArray(R"({"vertex": 4})") << "does not exist: 1, such as “a” (vertex 4)";
        newRow("no such edge") << QByteArray(R"({"edge": [0, 9], "share": 0.5})") << "“a” (edge 0–9)";
        newRow("another mesh's") << QByteArray(R"({"triangle": 0, "barycentric": [0.5, 0.25, 0.25]})")
                                 << "away from their anchor";
    }

    void whatDoesNotHoldIsLetGo()
    {
        QFETCH(QByteArray, held);
        QFETCH(QString, said);
        // The second triangle is (0, 0), (10, 10), (0, 10).
        write(QStringLiteral("scene.json"),
              R"({"unprojector": 1, "window": {"width": 800, "height": 600, "devicePixelRatio": 1},
              "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -0.75, "top": 0.75, "near": 1, "far": 100},
              "view": {"eye": [5, 5, 30], "center": [5, 5, 0], "up": [0, 1, 0]},
              "objects": [{"name": "square", "file": "square.obj"}],
              "landmarks": {"points": [{"name": "a", "position": [2.5, 5, 0],
                                        "uncertainty": [1e-13, 1e-13, 1e-13], "object": "square", "held": )"
                  + held + "}]}}");
        open({QStringLiteral("scene.json")});
        QVERIFY2(m_failures.isEmpty(), qPrintable(m_failures.join(u'\n')));
        QCOMPARE(points().size(), std::size_t(1));
        QVERIFY(*points()[0].world == WorldPoint(2.5, 5.0, 0.0));
        QCOMPARE(std::holds_alternative<landmarks::Free>(points()[0].anchor), !said.isEmpty());
        // Without its anchor, it is as uncertain as a typed position.
        QCOMPARE(points()[0].uncertainty.has_value(), said.isEmpty());
        QCOMPARE(m_warnings.size(), said.isEmpty() ? 0 : 1);
        if (said.isEmpty())
            return;
        QVERIFY2(m_warnings[0].contains(said) && m_warnings[0].startsWith(QStringLiteral("scene.json: ")),
                 qPrintable(m_warnings[0]));
    }

    void aPointOnAnObjectThatIsNotThereIsFree()
    {
        write(QStringLiteral("scene.json"),
              R"({"unprojector": 1, "window": {"width": 800, "height": 600, "devicePixelRatio": 1},
              "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -0.75, "top": 0.75, "near": 1, "far": 100},
              "view": {"eye": [5, 5, 30], "center": [5, 5, 0], "up": [0, 1, 0]},
              "objects": [{"name": "square", "file": "square.obj"}],
              "landmarks": {"points": [{"name": "a", "position": [2.5, 5, 0], "object": "skull", "held": {"vertex": 1}}]}})");
        open({QStringLiteral("scene.json")});
        QCOMPARE(points().size(), std::size_t(1));
        QVERIFY(*points()[0].world == WorldPoint(2.5, 5.0, 0.0));
        QVERIFY(points()[0].object.empty() && std::holds_alternative<landmarks::Free>(points()[0].anchor));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("missing object: 1, such as “a” (on “skull”)")),
                 qPrintable(m_warnings[0]));
        // A scan's are the scan's, whatever it was called.
        write(QStringLiteral("square.obj.points.csv"),
              "name,x,y,z,object,face,u,v,w\na,2.5,5,0,old.obj,1,0.5,0.25,0.25\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(points()[0].object, std::string("square.obj"));
        QVERIFY2(m_warnings.back().contains(QStringLiteral("“old.obj”")), qPrintable(m_warnings.back()));
    }

    void whatCannotBeReadSaysWhy_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("text");
        addColumn<QString>("said");
        newRow("a word for a number") << "p.csv" << QByteArray("name,x,y,z\na,1,two,3\n") << "p.csv:2:";
        newRow("not there") << "none.csv" << QByteArray() << "none.csv";
        newRow("of no known kind") << "p.doc" << QByteArray("1 2 3") << "p.doc";
    }

    void whatCannotBeReadSaysWhy()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, text);
        QFETCH(QString, said);
        if (!text.isEmpty())
            write(name, text);
        open({QStringLiteral("square.obj")});
        QVERIFY(!m_files->importFrom(file(name)));
        QCOMPARE(m_failures.size(), 1);
        QVERIFY2(m_failures[0].contains(said), qPrintable(m_failures[0]));
    }

    void exportedAndReadBack_data()
    {
        addColumn<QString>("suffix");
        for (const char *suffix : {"csv", "pp", "mrk.json", "fcsv", "pts", "tps"})
            newRow(suffix) << suffix;
    }

    void exportedAndReadBack()
    {
        QFETCH(QString, suffix);
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1.1,2.3,0\nb,3,4,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        const std::vector<Landmark> before = points();
        QVERIFY(m_files->exportTo(file(QStringLiteral("out.") + suffix)));
        QVERIFY(m_files->importFrom(file(QStringLiteral("out.") + suffix)));
        QCOMPARE(points().size(), std::size_t(2));
        for (std::size_t i = 0; i < 2; ++i)
            QCOMPARE(points()[i].world->coordinates(), before[i].world->coordinates());
        QCOMPARE(m_failures, QStringList());
    }

    void whatIsLostIsSaid()
    {
        open({QStringLiteral("square.obj")});
        Landmark landmark;
        landmark.name = "a";
        landmark.note = "worn";
        landmark.world = WorldPoint(1.0, 2.0, 0.0);
        QVERIFY(editLandmarks(*m_document, {landmark}, {QStringLiteral("test")}));
        QVERIFY(m_files->exportTo(file(QStringLiteral("out.csv"))));
        QCOMPARE(m_warnings, QStringList());
        QVERIFY(m_files->exportTo(file(QStringLiteral("out.pts"))));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("out.pts")) && m_warnings[0].contains(QStringLiteral("note")),
                 qPrintable(m_warnings[0]));
        QVERIFY(!m_files->exportTo(file(QStringLiteral("out.doc"))));
        QVERIFY(!m_files->exportTo(file(QStringLiteral("no/such/folder/out.csv"))));
        QCOMPARE(m_failures.size(), 2);
    }
};

UNPROJECTOR_TEST(TestOpenedLandmarks, threads)
#include "test_opened_landmarks.moc"
