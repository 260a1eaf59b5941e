// A series of scans: the points of each are saved next to it, in any sequence of actions.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/lessons/lesson_player.h"
#include "gui/text/error_text.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/landmarks/landmark_desk.h"
#include "tests/support/patience.h"

#include <QDir>

#include <algorithm>
#include <functional>
#include <map>
#include <random>

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

class TestScanSeries : public LandmarksTest {
    Q_OBJECT

private slots:
    void init() { begin(); }

    void whatIsKeptWithAScanIsLetGoToo()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z,object,face,u,v,w\na,1,2,0,square.obj,7,1,0,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(points().size(), std::size_t(1));
        QVERIFY(std::holds_alternative<landmarks::Free>(points()[0].anchor));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("“a” (triangle 7)")), qPrintable(m_warnings[0]));
    }

    void aSeriesThatIsNotWantedLeavesTheOneBefore()
    {
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("others")));
        for (const char *name : {"others/b.obj", "others/c.obj"})
            write(QLatin1String(name), kSquare);
        open({QStringLiteral("square.obj")});
        placeAll(1.0);
        Landmark placed;
        placed.world = WorldPoint(1.0, 1.0, 0.0);
        QVERIFY(m_document->sceneLandmarks().place(placed));
        m_answers->save = SessionQuestions::SaveAnswer::Cancel;
        QVERIFY(m_series->open(file(QStringLiteral("others"))));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_answers->saveQuestions, 1);
        QVERIFY(!m_series->isOpen()); // as if it had never been asked for
        QVERIFY(!m_series->current());
        QCOMPARE(points().size(), std::size_t(1));

        m_answers->save = SessionQuestions::SaveAnswer::Discard;
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->folder(), file(QString()));
        QVERIFY(m_document->sceneLandmarks().place(placed));
        QVERIFY(editTransform(*m_document, 0, {Translate{{1.0, 0.0, 0.0}}},
                              {QStringLiteral("Move")})); // this is asked about
        m_answers->save = SessionQuestions::SaveAnswer::Cancel;
        QVERIFY(m_series->open(file(QStringLiteral("others"))));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->folder(), file(QString()));
        QCOMPARE(m_series->scans().size(), std::size_t(1));
        QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
        QCOMPARE(m_series->scans()[0].placedCount(), points().size());
        // Its points are kept as before.
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(4.0, 3.0, 0.0)));
        QVERIFY(m_series->keep());
        QVERIFY2(read(QStringLiteral("square.obj.points.csv")).contains(",3,3,0"),
                 read(QStringLiteral("square.obj.points.csv")).constData());
    }

    void aSeriesGoesOnWhereItWasLeft()
    {
        for (const char *name : {"b.obj", "c.obj"})
            write(QLatin1String(name), kSquare);
        QFile::rename(path(QStringLiteral("square.obj")), path(QStringLiteral("a.obj")));
        open({QStringLiteral("a.obj")});
        Landmark first, second;
        first.name = "first";
        second.name = "second";
        QVERIFY(editLandmarks(*m_document, {first, second}, {QStringLiteral("template")}));
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->scans().size(), std::size_t(3));
        QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
        QCOMPARE(points().size(), std::size_t(2)); // the next point to place is still the same
        m_answers->saveQuestions = 0;
        placeAll(1.0);
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_answers->saveQuestions, 0);
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("first,1,1,0"));
        QCOMPARE(points().size(), std::size_t(2));
        QVERIFY(!points()[0].isPlaced());
        QCOMPARE(m_document->sceneLandmarks().nextUnplaced(), std::optional<std::size_t>(0));
        placeAll(2.0);
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        m_series->next(); // there is none
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
        m_series->previous();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(points()[1].world->x, 2.0);
        QVERIFY(!m_document->isModified());
        QVERIFY(m_document->undoStack().canUndo()); // what was placed there before
        // No point was placed on the third: nothing is saved for it.
        QVERIFY(!QFile::exists(path(QStringLiteral("c.obj.points.csv"))));

        // A user who quits the program keeps the points, without a question.
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(9.0, 9.0, 0.0)));
        QVERIFY(m_session->mayLeave());
        QCOMPARE(m_answers->saveQuestions, 0);
        QVERIFY(read(QStringLiteral("b.obj.points.csv")).contains("first,9,9,0"));

        // Opened again, the series goes on at the one that lacks points.
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
        open({QStringLiteral("a.obj")}); // another scene
        QCOMPARE(m_series->current(), std::optional<std::size_t>());
    }

    void aScanComesBackAfterALesson()
    {
        for (const char *name : {"t.obj", "u.obj"})
            write(QLatin1String(name), kSquare);
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        placeOne("first", 1.0);
        placeOne("second", 2.0);
        LessonPlayer player(*m_document, *m_session);
        QVERIFY(player.start("pipeline") && player.next());
        QCOMPARE(m_series->current(), std::optional<std::size_t>());
        QVERIFY(player.leave());
        QCOMPARE(m_series->current(), std::optional<std::size_t>(1));
        placeOne("third", 3.0);
        QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(3));
        QVERIFY(m_session->mayLeave());
        QVERIFY(read(QStringLiteral("t.obj.points.csv")).contains("third,3,1,0"));
        QVERIFY(!m_document->isEdited());

        // The points are the ones of its last placing.
        QVERIFY(player.start("pipeline"));
        m_series->setPlacing(2);
        QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(0));
        QVERIFY(player.leave());
        QCOMPARE(m_series->placing(), 1);
        QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(3));

        // The series goes on from a lesson behind the scan that was left for it. Edits that the steps
        // ask for cause no question.
        QVERIFY(player.start("pipeline"));
        QVERIFY(editClipPlanes(*m_document, {{0.0, 1.0, 0.0, 0.25}}, {}, {QStringLiteral("Plane")}));
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(!player.lesson());
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
        QCOMPARE(m_answers->saveQuestions, 0);
        QCOMPARE(points().size(), std::size_t(3)); // which wait here
        QVERIFY(!points()[2].isPlaced());

        // A scene opened in the scan's place is no scan, also after it comes back.
        QVERIFY(player.start("pipeline"));
        m_session->openBundledScene();
        QVERIFY(player.start("pipeline") && player.leave());
        QCOMPARE(m_series->current(), std::optional<std::size_t>());
        QVERIFY2(m_failures.isEmpty(), qPrintable(m_failures.join(u'\n')));
    }

    void aScanThatIsNotKeptIsAskedAboutInALesson()
    {
        write(QStringLiteral("t.obj"), kSquare);
        QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("other")));
        write(QStringLiteral("other/v.obj"), kSquare);
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        placeOne("first", 1.0);
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\nfirst,5,5,0\n"); // by another program
        LessonPlayer player(*m_document, *m_session);
        const std::vector<std::function<void()>> ways = {[this] { QVERIFY(!m_session->mayLeave()); },
                                                         [this] { m_series->next(); },
                                                         [this] { m_series->open(file(QStringLiteral("other"))); }};
        using Answer = SessionQuestions::SaveAnswer;
        for (const Answer answer : {Answer::Cancel, Answer::Save}) {
            for (const auto &leaves : ways) {
                QVERIFY(player.start("pipeline"));
                m_answers->save = answer;
                m_answers->saveQuestions = 0;
                leaves();
                QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
                QCOMPARE(m_answers->saveQuestions, 1);
                if (answer == Answer::Cancel) { // a user who cancels is in the lesson, and the scan still behind it
                    QVERIFY(player.lesson());
                    QCOMPARE(m_series->current(), std::optional<std::size_t>());
                    QVERIFY(player.leave());
                }
                QVERIFY(!player.lesson()); // it is back for saving, which failed, since it has no name
                QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
                QCOMPARE(m_series->scans().size(), std::size_t(2));
                placeOne("another", 2.0);
                QCOMPARE(m_series->scans()[0].placedCount(), points().size());
            }
        }
        QCOMPARE(points().size(), std::size_t(7));
        m_session->end();
    }

    void anotherSceneIsNoneOfTheSeries()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->scans()[0].placedCount(), std::size_t(1));
        m_session->openBundledScene();
        QVERIFY(points().empty());
        QCOMPARE(m_series->current(), std::optional<std::size_t>());
        QCOMPARE(m_series->scans()[0].placedCount(), std::size_t(1)); // as a table of the series has it
    }

    void aScanThatIsGivenUpLeavesTheOneShown()
    {
        write(QStringLiteral("other.obj"), kSquare);
        write(QStringLiteral("other.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,2,2,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        m_series->next();
        m_session->cancelLoading();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(5.0, 5.0, 0.0)));
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("other.obj.points.csv")).contains("a,5,5,0"));
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,2,2,0"));
        // The next opened file is not taken for it.
        m_session->openBundledScene();
        QVERIFY(points().empty());
    }

    void lookingAroundWritesNothing()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,7,7,0\n"); // by another program
        LookAt camera = m_document->scene().camera;
        camera.eye.x += 1.0;
        setCamera(*m_document, camera);
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,7,7,0"));
    }

    void aSeriesWithABrokenScan()
    {
        write(QStringLiteral("broken.obj"), "v 1 2\n");
        write(QStringLiteral("broken2.ply"), "ply\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2)); // the first that can be read
        QCOMPARE(m_warnings.size(), 1);                               // has the reasons of both
        QVERIFY2(m_warnings[0].contains(QStringLiteral("broken.obj"))
                     && m_warnings[0].contains(QStringLiteral("broken2.ply")),
                 qPrintable(m_warnings[0]));
        for (std::size_t i = 0; i < 2; ++i) { // they can be tried again
            m_series->show(i);
            QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
            QCOMPARE(m_series->current(), std::optional<std::size_t>(i));
            QCOMPARE(m_series->inView(), std::optional<std::size_t>(2)); // where landmarks are still placed
            QVERIFY(!m_series->scans()[i].problem.isEmpty());
        }
        m_series->next();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
        QCOMPARE(m_document->objects()[0].name, std::string("square.obj"));
        QVERIFY(m_series->scans()[2].problem.isEmpty());

        QVERIFY(QDir(path(QString())).mkdir(QStringLiteral("empty")));
        QVERIFY(!m_series->open(file(QStringLiteral("empty"))));
        QVERIFY(!m_series->open(file(QStringLiteral("nowhere"))));
        QCOMPARE(m_series->scans().size(), std::size_t(3)); // the one before is still there
    }

    void aDamagedFileOfPointsIsNotWrittenOver()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,two,3\n");
        write(QStringLiteral("t.obj"), kSquare);
        QString failure;
        connect(m_series.get(), &ScanSeries::failed, this, [&failure](const QString &text) { failure = text; });
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        m_series->previous();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY2(failure.endsWith(QStringLiteral("Press Ctrl+PgDown for the next scan.")), qPrintable(failure));
        QFile::remove(path(QStringLiteral("t.obj")));
        QVERIFY(m_series->open(file(QString()))); // there is no next one
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY2(!failure.contains(QStringLiteral("next scan")), qPrintable(failure));
        QVERIFY(m_series->scans()[0].problem.contains(QStringLiteral("square.obj.points.csv:2:")));
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("two"));
    }

    /// A quarter turn about z takes (x, y) to (-y, x): the file has points of the scene in its own
    /// coordinates.
    void aTurnedScanKeepsItsFilesNumbers()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,2,0\nb,,,\nc,,,\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        const QByteArray before = read(QStringLiteral("square.obj.points.csv"));
        QVERIFY(editTransform(*m_document, 0, {Rotate{90.0, {0, 0, 1}}, Scale{{2, 2, 2}}}, {QStringLiteral("turn")}));
        QVERIFY(glm::distance(points()[0].world->coordinates(), glm::dvec3(-4, 2, 0))
                < 1e-12); // it has gone with its scan
        QVERIFY(m_series->keep());
        QCOMPARE(read(QStringLiteral("square.obj.points.csv")), before); // it is unchanged
        Landmark held;
        held.object = "square.obj";
        held.anchor = landmarks::OnTriangle{0, glm::dvec3(0.5, 0.25, 0.25)};
        held.world = WorldPoint(-5.0, 10.0, 0.0); // (5, 2.5, 0) of the file
        QVERIFY(m_document->sceneLandmarks().place(held));
        Landmark free;
        free.world = WorldPoint(-8.0, 6.0, 2.0); // (3, 4, 1)
        QVERIFY(m_document->sceneLandmarks().place(free));
        QCOMPARE(renameObject(*m_document, 0, QStringLiteral("turned")), NameFault::None);
        QVERIFY(m_series->keep());
        const auto kept = landmark_files::readLandmarkFile(file(QStringLiteral("square.obj.points.csv")));
        QVERIFY(kept);
        const std::vector<Landmark> &rows = kept->sets.front().landmarks;
        QCOMPARE(rows[0].world->coordinates(), glm::dvec3(1.0, 2.0, 0.0));
        QCOMPARE(rows[1].world->coordinates(), glm::dvec3(5.0, 2.5, 0.0));
        QCOMPARE(rows[1].object, std::string("square.obj"));
        QVERIFY(glm::distance(rows[2].world->coordinates(), glm::dvec3(3.0, 4.0, 1.0)) < 1e-12);
        QVERIFY(m_series->scans()[0].points == kept->sets.front()); // as tables have them
        // The points read again into the turned scene are in the same positions.
        const std::vector<Landmark> shown = points();
        m_series->setPlacing(2);
        m_series->setPlacing(1);
        for (std::size_t i = 0; i < 3; ++i) {
            QVERIFY(glm::distance(points()[i].world->coordinates(), shown[i].world->coordinates()) < 1e-12);
            QCOMPARE(points()[i].object, std::string("turned"));
        }
        // The points keep the scan's positions when the scan is removed from the scene.
        QVERIFY(removeObject(*m_document, 0));
        QVERIFY(m_document->sceneLandmarks().rename(0, QStringLiteral("A")));
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("A,1,2,0"));
    }

    void whatSomebodyElseWroteIsNotWrittenOver()
    {
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(5.0, 5.0, 0.0)));
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,7,7,0\n");
        QVERIFY(!m_series->keep());
        QCOMPARE(m_failures.size(), 1);
        QVERIFY(m_failures[0].contains(QStringLiteral("square.obj.points.csv")));
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,7,7,0"));
        QVERIFY(m_document->isEdited()); // leaving asks
        QVERIFY(QFile::rename(path(QStringLiteral("square.obj.points.csv")), path(QStringLiteral("theirs.csv"))));
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,5,5,0"));
    }

    void aDamagedPlacingIsNotGoneOver()
    {
        const QByteArray damaged = "name,x,y,z\na,1,two,3\n";
        write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
        write(QStringLiteral("square.obj.points-2.csv"), damaged);
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        m_series->setPlacing(2);
        QCOMPARE(m_series->placing(), 1);
        QCOMPARE(m_failures.size(), 1);
        QVERIFY(m_failures[0].contains(QStringLiteral("points-2.csv:2:")));
        QVERIFY(
            m_document->sceneLandmarks().moveTo(0, WorldPoint(5.0, 5.0, 0.0))); // and the shown points are still kept
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,5,5,0"));
        QCOMPARE(read(QStringLiteral("square.obj.points-2.csv")), damaged);

        // The series goes on from a damaged scan to one that is not, and asks about points placed
        // meanwhile.
        write(QStringLiteral("square.obj.points.csv"), damaged);
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        Landmark placed;
        placed.world = WorldPoint(3.0, 3.0, 0.0);
        QVERIFY(m_document->sceneLandmarks().place(placed));
        m_answers->saveQuestions = 0;
        m_series->setPlacing(3);
        QCOMPARE(m_answers->saveQuestions, 1);
        QCOMPARE(m_series->placing(), 3);
        QVERIFY(points().size() == 1 && !points()[0].isPlaced());
        QVERIFY(m_document->sceneLandmarks().place(placed));
        QVERIFY(m_series->keep());
        QVERIFY(QFile::exists(path(QStringLiteral("square.obj.points-3.csv"))));
        QCOMPARE(read(QStringLiteral("square.obj.points.csv")), damaged);
    }

    /// Each scan's file has the points last seen on that scan and no others, for any order of actions,
    /// also if files appear and disappear.
    void noScanGetsThePointsOfAnother()
    {
        QVERIFY(QFile::remove(path(QStringLiteral("square.obj"))));
        const auto nameOf = [](std::size_t i) { return QStringLiteral("scan%1.obj").arg(i); };
        constexpr std::size_t kScans = 6;
        for (std::size_t i = 0; i < kScans; ++i)
            write(nameOf(i), kSquare);
        std::mt19937 random(11);
        const auto below = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
        std::map<std::filesystem::path, std::vector<Landmark>> seen; // by the file that keeps it
        const auto isScan = [this] {
            return m_document->objects().size() == 1 && !m_document->objects()[0].file.empty();
        };
        // Names that wait are not written for themselves.
        const auto placedOf = [](const std::vector<Landmark> &all) {
            std::vector<std::pair<std::string, WorldPoint>> placed;
            for (const Landmark &landmark : all) {
                if (landmark.isPlaced())
                    placed.emplace_back(landmark.name, *landmark.world);
            }
            return placed;
        };
        bool isUndoing = false;                       // undo may go to another scan first, and change it then
        const auto look = [&](bool isOther = false) { // changed since last time only by an action
            if (!isScan())
                return;
            const auto kept = landmark_files::landmarksBeside(m_document->objects()[0].file, m_series->placing());
            QVERIFY2(isOther || isUndoing || !seen.contains(kept) || placedOf(seen[kept]) == placedOf(points()),
                     qPrintable(pathText(kept)));
            seen[kept] = points();
        };
        const auto open = [&] {
            QVERIFY(m_series->open(file(QString())));
            QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        };
        open();
        for (int step = 0; step < 300; ++step) {
            const std::size_t kind = std::min<std::size_t>(below(14), 11), some = below(kScans);
            if (kind < 2) {
                m_series->next();
            } else if (kind == 2) {
                m_series->previous();
            } else if (kind == 3) {
                m_series->show(below(m_series->scans().size()));
            } else if (kind == 4) {
                m_series->setPlacing(1 + static_cast<int>(below(3)));
            } else if (kind == 5) {
                m_session->cancelLoading();
            } else if (kind == 6) { // one at least stays
                if (some > 0)
                    QFile::remove(path(nameOf(some)));
            } else if (kind == 7) {
                write(nameOf(some), kSquare);
            } else if (kind == 8 && below(4) == 0) {
                open();
            } else if (kind == 9 && below(4) == 0) {
                m_session->openBundledScene();
            } else if (kind == 10) {
                below(3) > 0 ? m_document->undoStack().undo() : m_document->undoStack().redo();
                isUndoing = true;
            } else if (kind == 11 && isScan()) {
                Landmark landmark;
                landmark.name = "p" + std::to_string(below(4));
                landmark.world = WorldPoint(double(below(10)), double(below(10)), 0.0);
                QVERIFY(m_document->sceneLandmarks().place(landmark));
            }
            look(kind == 10 || kind == 11);
            if (below(3) > 0) {                    // otherwise the next action meets a scan that is still loading
                QCoreApplication::processEvents(); // a scan is opened for undo
                QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
                look();
                isUndoing = false;
            }
            QVERIFY(!m_series->current() || *m_series->current() < m_series->scans().size());
        }
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        look();
        QVERIFY(m_series->keep());
        std::size_t count = 0;
        for (const auto &[kept, last] : seen) {
            const auto points = landmark_files::readLandmarkFile(kept);
            const auto placed = placedOf(points ? points->sets.front().landmarks : std::vector<Landmark>());
            QVERIFY2(placed == placedOf(last), qPrintable(pathText(kept)));
            count += placed.size();
        }
        QVERIFY(seen.size() > kScans && count > 30);
        QCOMPARE(m_answers->saveQuestions, 0); // nothing was lost on the way
    }
};

UNPROJECTOR_TEST(TestScanSeries, threads)
#include "test_scan_series.moc"
