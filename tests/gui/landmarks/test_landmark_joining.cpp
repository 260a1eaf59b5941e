// Points from files next to existing ones: joined by their names or their order, or in place of
// them.

#include "tests/support/test.h"

#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_templates.h"
#include "tests/gui/landmarks/landmark_desk.h"

#include <nlohmann/json.hpp>

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

namespace {

std::vector<Landmark> namedPoints(const QStringList &names)
{
    std::vector<Landmark> landmarks;
    for (const QString &name : names)
        landmarks.emplace_back().name = name.toStdString();
    return landmarks;
}

} // namespace

class TestLandmarkJoining : public LandmarksTest {
    Q_OBJECT

private slots:
    void init() { begin(); }

    void thoseThatAreThere_data()
    {
        addColumn<int>("answer");
        addColumn<int>("count");
        newRow("replaced") << int(LandmarkFileQuestions::Join::Replace) << 1;
        newRow("joined") << int(LandmarkFileQuestions::Join::Append) << 2;
        newRow("given up") << int(LandmarkFileQuestions::Join::Cancel) << 1;
    }

    void thoseThatAreThere()
    {
        QFETCH(int, answer);
        QFETCH(int, count);
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
        m_answers->join = static_cast<LandmarkFileQuestions::Join>(answer);
        m_files->importFrom(file(QStringLiteral("p.csv")));
        QCOMPARE(m_answers->joinQuestions, 0);
        m_files->importFrom(file(QStringLiteral("p.csv")));
        QCOMPARE(m_answers->joinQuestions, 1);
        QCOMPARE(static_cast<int>(points().size()), count);
    }

    void namesThatWaitAreFilled()
    {
        open({QStringLiteral("square.obj")});
        const auto named = [](const char *name) {
            Landmark landmark;
            landmark.name = name;
            return landmark;
        };
        fillFromTemplate(*m_document, {named("a"), named("b"), named("c")}, QStringLiteral("three"));
        write(QStringLiteral("p.csv"), "name,x,y,z\nB,1,2,0\nother,2,2,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(m_answers->joinQuestions, 0); // nothing that was placed is at stake
        QCOMPARE(points().size(), std::size_t(4));
        QVERIFY(!points()[0].isPlaced() && !points()[2].isPlaced());
        QCOMPARE(points()[1].name, std::string("b")); // as the template has it
        QCOMPARE(points()[3].name, std::string("other"));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("appended: “other”. Still to place: “a”, “c”.")),
                 qPrintable(m_warnings[0]));
        // Now two are placed and two names wait.
        m_answers->join = LandmarkFileQuestions::Join::Append;
        write(QStringLiteral("p.csv"), "name,x,y,z\nc,3,3,0\nb,4,4,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(m_answers->asked.placed, 2);
        QCOMPARE(m_answers->asked.waiting, 2);
        QCOMPARE(m_answers->asked.coming, 2);
        QCOMPARE(points().size(), std::size_t(5));
        QCOMPARE(points()[2].world->x, 3.0);
        QCOMPARE(points()[1].world->x, 1.0); // placed, it is not gone over
        QCOMPARE(points()[4].name, std::string("b"));
    }

    void missingOnesStayMissing()
    {
        open({QStringLiteral("square.obj")});
        Landmark a, b;
        a.name = "a";
        b.name = "b";
        a.absence = landmarks::Absence::Missing;
        QVERIFY(editLandmarks(*m_document, {a, b}, {QStringLiteral("two")}));
        // A file without positions knows no more than the scene.
        write(QStringLiteral("p.csv"), "name,x,y,z\na,,,\nb,1,2,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QVERIFY(points()[0].isMissing() && points()[1].isPlaced());
        write(QStringLiteral("p.csv"), "name,x,y,z\na,2,2,0\n");
        m_answers->join = LandmarkFileQuestions::Join::Append;
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(points().size(), std::size_t(2));
        QVERIFY(points()[0].isPlaced() && points()[0].absence == landmarks::Absence::NotPlaced);
    }

    void namesThatAFileWritesOtherwiseAreFilled()
    {
        open({QStringLiteral("square.obj")});
        fillFromTemplate(*m_document, namedPoints({"eye left", "eye_left", "Broca's point", "tip"}),
                         QStringLiteral("four"));
        write(QStringLiteral("p.pts"),
              "Version 1.0\n4\nEYE_LEFT 1 1 0\neye_left 2 2 0\nBroca_s_point 3 3 0\nchin 4 4 0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
        QCOMPARE(points().size(), std::size_t(5));
        QCOMPARE(points()[0].name, std::string("eye left"));
        QCOMPARE(points()[0].world->x, 1.0);
        QCOMPARE(points()[1].world->x, 2.0); // its very name
        QCOMPARE(points()[2].name, std::string("Broca's point"));
        QCOMPARE(points()[2].world->x, 3.0);
        QVERIFY(!points()[3].isPlaced());
        QVERIFY2(m_notices[0].contains(QStringLiteral("Names filled: 3.")), qPrintable(m_notices[0]));
        QVERIFY2(m_warnings.size() == 1 && m_warnings[0].contains(QStringLiteral("“chin”. Still to place: “tip”.")),
                 qPrintable(m_warnings.join(u'\n')));
    }

    void replacedPointsKeepTheScenesNames()
    {
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\neye left,1,1,0\neye right,2,1,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        write(QStringLiteral("p.pts"), "Version 1.0\n2\neye_left 3 1 0\neye_right 4 1 0\n");
        m_answers->join = LandmarkFileQuestions::Join::Replace;
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
        QCOMPARE(points()[0].name, std::string("eye left")); // curves know it by that
        QCOMPARE(points()[0].world->x, 3.0);
        write(QStringLiteral("p.tps"), "LM3=2\n5 1 0\n6 1 0\n\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.tps"))));
        QCOMPARE(points()[1].name, std::string("eye right"));
        QVERIFY2(m_warnings.join(u'\n').contains(QStringLiteral("in order")), qPrintable(m_warnings.join(u'\n')));
    }

    void pointsWithoutNamesFillByOrder_data()
    {
        addColumn<QByteArray>("rows");
        addColumn<int>("answer");
        addColumn<QString>("names"); ///< of placed points
        addColumn<QString>("said");
        using Order = LandmarkFileQuestions::Order;
        newRow("as many") << QByteArray("1 1 0\n2 2 0\n3 3 0\n") << -1 << "a b c"
                          << "took the unplaced names in order";
        newRow("one missing") << QByteArray("1 1 0\nNA NA NA\n3 3 0\n") << -1 << "a c"
                              << "in order";
        newRow("fewer") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Fill) << "a b"
                        << "in order";
        newRow("more") << QByteArray("1 1 0\n2 2 0\n3 3 0\n4 4 0\n") << int(Order::Fill) << "a b c "
                       << "in order";
        newRow("appended") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Behind) << " "
                           << "appended: 2. Still";
        newRow("given up") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Cancel) << QString() << QString();
    }

    void pointsWithoutNamesFillByOrder()
    {
        QFETCH(QByteArray, rows);
        QFETCH(int, answer);
        QFETCH(QString, names);
        QFETCH(QString, said);
        open({QStringLiteral("square.obj")});
        fillFromTemplate(*m_document, namedPoints({"a", "b", "c"}), QStringLiteral("three"));
        write(QStringLiteral("p.tps"), "LM3=" + QByteArray::number(rows.count('\n')) + '\n' + rows + '\n');
        if (answer >= 0)
            m_answers->order = static_cast<LandmarkFileQuestions::Order>(answer);
        QCOMPARE(m_files->importFrom(file(QStringLiteral("p.tps"))), !said.isEmpty());
        QCOMPARE(m_answers->orderText.isEmpty(), answer < 0);
        QStringList placed;
        for (const Landmark &landmark : points()) {
            if (landmark.isPlaced())
                placed << QString::fromStdString(landmark.name);
        }
        QCOMPARE(placed.join(u' '), names);
        QVERIFY2(m_warnings.join(u'\n').contains(said), qPrintable(m_warnings.join(u'\n')));
    }

    void semilandmarksAreNoPoints()
    {
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.pts"),
              "Version 1.0\n5\na 1 1 0\nb 3 3 0\nbrow:01 1 1 0\nbrow:02 2 2 0\nbrow:03 3 3 0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
        QCOMPARE(points().size(), std::size_t(2));
        QCOMPARE(m_document->scene().landmarks.curves.size(), std::size_t(1));
        QCOMPARE(m_document->scene().landmarks.curves[0].name, std::string("brow"));
        QCOMPARE(m_document->scene().landmarks.curves[0].semilandmarks.size(), std::size_t(3));
        QVERIFY2(m_notices[0].contains(QStringLiteral("p.pts: 2."))
                     && m_notices[0].contains(QStringLiteral("3, of “brow”")),
                 qPrintable(m_notices[0]));
        // A curve that the scene has itself goes through its points.
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        set.curves[0].points = {"a", "b"};
        // So do the measures of its protocol, and its placing.
        set.measures = {{"w", landmarks::MeasureKind::Distance, {"a", "b"}}};
        set.placing = 2;
        QVERIFY(editLandmarkSet(*m_document, set, {QStringLiteral("test")}));
        for (const auto join : {LandmarkFileQuestions::Join::Replace, LandmarkFileQuestions::Join::Append}) {
            m_answers->join = join;
            QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
            QCOMPARE(m_document->scene().landmarks.curves.size(), std::size_t(1));
            QCOMPARE(m_document->scene().landmarks.curves[0].points.size(), std::size_t(2));
            QVERIFY(m_document->scene().landmarks.measures == set.measures);
            QCOMPARE(m_document->scene().landmarks.placing, 2);
            QVERIFY2(m_warnings.back().contains(QStringLiteral("keeps its own curves: brow")),
                     qPrintable(m_warnings.back()));
        }
    }

    void countsAddUp_data()
    {
        addColumn<QByteArray>("rows");
        addColumn<QString>("said");
        newRow("all on the mesh") << QByteArray("a,1,2,0\nb,2,2,0\n") << "2. They lie on the mesh.";
        newRow("one beyond all distances")
            << QByteArray("a,1,2,0\nb,1e308,2,0\n")
            << "2. On the mesh: 1. They lie on the mesh. Left free, far from the mesh: 1.";
        newRow("one of each")
            << QByteArray("a,1,2,0\nb,1e308,2,0\nc,,,\nd,3,3,5\n")
            << "4. On the mesh: 1. They lie on the mesh. Left free, far from the mesh: 2. Not placed: 1.";
        newRow("none on the mesh") << QByteArray("d,3,3,5\n") << "1. Left free, far from the mesh: 1.";
    }

    void countsAddUp()
    {
        QFETCH(QByteArray, rows);
        QFETCH(QString, said);
        m_answers->stray = LandmarkFileQuestions::Stray::LeaveFree;
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\n" + rows);
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(m_notices, QStringList(QStringLiteral("Landmarks read from p.csv: ") + said));
    }

    void unitsAndKeysAreNotLost_data()
    {
        addColumn<int>("answer");
        addColumn<QByteArray>("text");
        addColumn<QString>("unit");
        addColumn<QString>("said");
        using Join = LandmarkFileQuestions::Join;
        const QByteArray plain = "name,x,y,z\na,1,2,0\n", cm = "name,x,y,z,unit\na,1,2,0,cm\n",
                         mm = "name,x,y,z,unit\na,1,2,0,mm\n";
        newRow("replaced, no unit") << int(Join::Replace) << plain << "mm" << QString();
        newRow("replaced, the same") << int(Join::Replace) << mm << "mm" << QString();
        newRow("replaced, another") << int(Join::Replace) << cm << "cm"
                                    << "cm";
        newRow("appended, no unit") << int(Join::Append) << plain << "mm" << QString();
        newRow("appended, another") << int(Join::Append) << cm << "mm"
                                    << "cm";
    }

    void unitsAndKeysAreNotLost()
    {
        QFETCH(int, answer);
        QFETCH(QByteArray, text);
        QFETCH(QString, unit);
        QFETCH(QString, said);
        open({QStringLiteral("square.obj")});
        landmarks::LandmarkSet set;
        set.unit = "mm";
        set.mesh = "skull.ply";
        set.extra.edit()["scanner"] = "old";
        set.landmarks.resize(1);
        set.landmarks[0].world = WorldPoint(4.0, 4.0, 0.0);
        QVERIFY(editLandmarkSet(*m_document, set, {QStringLiteral("test")}));
        m_answers->join = static_cast<LandmarkFileQuestions::Join>(answer);
        write(QStringLiteral("p.csv"), text);
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        QCOMPARE(QString::fromStdString(m_document->scene().landmarks.unit), unit);
        QCOMPARE(m_document->scene().landmarks.mesh, std::string("skull.ply"));
        QVERIFY(m_document->scene().landmarks.extra == set.extra);
        QCOMPARE(m_warnings.size(), said.isEmpty() ? 0 : 1);
        QVERIFY(said.isEmpty() || m_warnings[0].contains(said));
        m_document->undoStack().undo();
        QVERIFY(m_document->scene().landmarks == set);
    }

    void aQuestionIsOfTheSceneBelowIt()
    {
        open({QStringLiteral("square.obj")});
        write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
        m_answers->meanwhile = [this] { m_session->openBundledScene(); };
        QVERIFY(!m_files->importFrom(file(QStringLiteral("p.csv"))));
        QVERIFY(points().empty());
        QCOMPARE(m_failures.size(), 1);
        QVERIFY(m_failures[0].contains(QStringLiteral("p.csv")));
    }
};

UNPROJECTOR_TEST(TestLandmarkJoining, threads)
#include "test_landmark_joining.moc"
