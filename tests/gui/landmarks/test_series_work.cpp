// Work on a series of scans is never lost: undo over scans, saving, backups, questions, recovery;
// and what goes along from scan to scan.

#include "tests/support/test.h"

#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/landmark_templates.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/landmarks/landmark_desk.h"
#include "tests/support/patience.h"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace landmarkfiles;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;

class TestSeriesWork : public LandmarksTest {
    Q_OBJECT

private slots:
    void init()
    {
        begin();
        QFile::rename(path(QStringLiteral("square.obj")), path(QStringLiteral("a.obj")));
        for (const char *name : {"b.obj", "c.obj"})
            write(QLatin1String(name), kSquare);
    }

    void undoGoesBackToTheScanOfTheStep()
    {
        openSeries();
        placeOne("first", 1.0);
        placeOne("second", 2.0);
        QVERIFY(m_document->sceneLandmarks().moveTo(1, WorldPoint(3.0, 1.0, 0.0)));
        nextScan();
        QCOMPARE(shownScan(), std::string("b.obj"));
        QVERIFY(!points()[0].isPlaced());
        m_document->sceneLandmarks().setNextUnplaced(0);
        placeOne("first", 5.0);
        setCamera(*m_document, {WorldPoint(1, 2, 30), WorldPoint(1, 2, 0), {0, 1, 0}}); // of this scan alone
        nextScan();
        QCOMPARE(shownScan(), std::string("c.obj"));
        placeAll(7.0);

        m_notices.clear();
        m_answers->fewer = SessionQuestions::FewerAnswer::Replace;
        undo();
        undo();
        QCOMPARE(shownScan(), std::string("c.obj"));
        QCOMPARE(placed(), std::size_t(0));
        QCOMPARE(stack().undoText(), QStringLiteral("Place first on b.obj"));
        undo();
        QCOMPARE(shownScan(), std::string("b.obj"));
        QCOMPARE(m_series->current(), std::optional<std::size_t>(1));
        QCOMPARE(placed(), std::size_t(0));
        QVERIFY2(m_notices.contains(QStringLiteral("Undone on b.obj: Place first.")),
                 qPrintable(m_notices.join(u'\n')));
        undo();
        QCOMPARE(shownScan(), std::string("a.obj"));
        QCOMPARE(points()[1].world->x, 2.0);
        undo();
        undo();
        QCOMPARE(shownScan(), std::string("a.obj"));
        QCOMPARE(placed(), std::size_t(0));
        QVERIFY(!stack().canUndo());

        // And back again, to the last step: each scan has its landmarks.
        m_notices.clear();
        while (stack().canRedo())
            redo();
        QCOMPARE(shownScan(), std::string("c.obj"));
        QCOMPARE(placed(), std::size_t(2));
        QVERIFY2(m_notices.contains(QStringLiteral("Redone on b.obj: Place first.")),
                 qPrintable(m_notices.join(u'\n')));
        QVERIFY(m_series->keep());
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("first,1,1,0"));
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("second,3,1,0"));
        QVERIFY(read(QStringLiteral("b.obj.points.csv")).contains("first,5,1,0"));
        QVERIFY(read(QStringLiteral("c.obj.points.csv")).contains("second,7,1,0"));

        // A new step ends what could be redone, also on other scans.
        undo();
        undo();
        undo();
        QCOMPARE(shownScan(), std::string("b.obj"));
        placeOne("third", 4.0);
        QVERIFY(!stack().canRedo());
        QVERIFY2(m_failures.isEmpty() && m_warnings.isEmpty(), qPrintable((m_failures + m_warnings).join(u'\n')));
        QCOMPARE(m_answers->saveQuestions, 0);
    }

    void undoKeepsToScansThatHaveNotChanged()
    {
        openSeries();
        placeOne("first", 1.0);
        nextScan();
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nfirst,8,8,0\n"); // by another program
        m_notices.clear();
        undo();
        QVERIFY2(m_notices.isEmpty(), qPrintable(m_notices.join(u'\n'))); // nothing was undone
        QCOMPARE(shownScan(), std::string("a.obj"));
        QCOMPARE(points()[0].world->x, 8.0);
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("a.obj")), qPrintable(m_warnings[0]));
        QVERIFY(!stack().canUndo()); // it is not tried again

        // A scan that has gone keeps the present one.
        placeOne("second", 2.0);
        nextScan();
        QVERIFY(QFile::remove(path(QStringLiteral("a.obj"))));
        undo();
        QCOMPARE(shownScan(), std::string("b.obj"));
        QCOMPARE(m_failures.size(), 1);
        QVERIFY(stack().canUndo()); // the step is still there

        // The user may stop the way to the other scan.
        write(QStringLiteral("a.obj"), kSquare + "# again\n");
        stack().undo();
        QCoreApplication::processEvents();
        m_session->cancelLoading();
        QCOMPARE(shownScan(), std::string("b.obj"));
        QVERIFY(stack().canUndo());
        m_series->previous();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(placed(), std::size_t(2)); // only undo undoes
    }

    void undoGoesBackToThePlacing()
    {
        openSeries();
        placeOne("first", 1.0);
        m_series->setPlacing(2);
        placeAll(2.0);
        undo();
        QCOMPARE(placed(), std::size_t(0));
        QCOMPARE(m_series->placing(), 2);
        undo();
        QCOMPARE(m_series->placing(), 1);
        QCOMPARE(placed(), std::size_t(0));
        redo();
        redo();
        QCOMPARE(m_series->placing(), 2);
        QCOMPARE(points()[0].world->x, 2.0);
    }

    void savingWritesTheLandmarks()
    {
        QVERIFY(!m_session->savesLandmarks());
        openSeries();
        QVERIFY(m_session->savesLandmarks());
        QVERIFY(m_session->save());
        QVERIFY(m_notices.back().contains(QStringLiteral("nothing to save")));
        placeOne("first", 1.0);
        QVERIFY(m_session->hasUnsavedChanges());
        QVERIFY(m_session->save());
        QCOMPARE(m_notices.back(), QStringLiteral("Landmarks of a.obj saved in a.obj.points.csv."));
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("first,1,1,0"));
        QVERIFY(!m_session->hasUnsavedChanges());
        QVERIFY(m_session->file().empty());
        QVERIFY(m_session->save());
        QVERIFY(m_notices.back().contains(QStringLiteral("already")));
        // Other changes are told about: they are not beside the scan.
        placeOne("second", 2.0);
        QVERIFY(editClipPlanes(*m_document, {{0.0, 1.0, 0.0, 0.25}}, {}, {QStringLiteral("Plane")}));
        QVERIFY(m_session->save());
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("second,2,1,0"));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY(m_session->hasUnsavedChanges());
        // A scene's own file is still saved, and the landmarks too.
        QVERIFY(m_session->saveScene(file(QStringLiteral("scene.json"))));
        placeOne("third", 3.0);
        QVERIFY(m_session->save());
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("third,3,1,0"));
        QVERIFY(read(QStringLiteral("scene.json")).contains("third"));
    }

    void theFirstStateOfARunIsBackedUp()
    {
        const QByteArray before = "name,x,y,z\nfirst,8,8,0\n";
        write(QStringLiteral("a.obj.points.csv"), before);
        openSeries();
        m_series->show(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(!QFile::exists(path(QStringLiteral("a.obj.points.csv~"))));
        for (const double x : {1.0, 2.0}) {
            QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(x, 1.0, 0.0)));
            QVERIFY(m_session->save());
            QCOMPARE(read(QStringLiteral("a.obj.points.csv~")), before);
        }
        nextScan();
        placeAll(3.0);
        QVERIFY(m_session->save());
        QVERIFY(m_document->sceneLandmarks().moveTo(0, WorldPoint(4.0, 1.0, 0.0)));
        QVERIFY(m_session->save());
        QVERIFY(!QFile::exists(path(QStringLiteral("b.obj.points.csv~")))); // it had none before
        // It is no scan and no specimen.
        openSeries();
        QCOMPARE(m_series->scans().size(), std::size_t(3));
        std::error_code error;
        const auto folder = landmark_files::readLandmarkFolder(file(QString()), {}, error);
        QCOMPARE(folder.sets.size(), std::size_t(2));
    }

    void fewerLandmarksAreAskedAbout_data()
    {
        addColumn<int>("left");
        addColumn<QString>("way");
        for (const char *way : {"next", "save", "quit", "close", "placing"}) {
            for (const int left : {0, 4, 5})
                addRow("%s-%d", way, left) << left << QString::fromLatin1(way);
        }
    }

    void fewerLandmarksAreAskedAbout()
    {
        QFETCH(int, left);
        QFETCH(QString, way);
        placeTen();
        const QByteArray before = read(QStringLiteral("a.obj.points.csv"));
        std::vector<std::size_t> others;
        for (std::size_t i = static_cast<std::size_t>(left); i < 10; ++i)
            others.push_back(i);
        // "Place All Again", and Del on a selection
        QVERIFY(left == 0 ? m_document->sceneLandmarks().setMissing(others)
                          : m_document->sceneLandmarks().remove(others));
        m_answers->fewer = SessionQuestions::FewerAnswer::Cancel;
        bool isDone = true;
        if (way == QStringLiteral("next"))
            m_series->next();
        else if (way == QStringLiteral("save"))
            isDone = m_session->save();
        else if (way == QStringLiteral("quit"))
            isDone = m_session->mayLeave();
        else if (way == QStringLiteral("close"))
            isDone = m_series->close();
        else
            m_series->setPlacing(2);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_answers->saveQuestions, 0);
        if (left == 5) {
            QVERIFY(m_answers->fewerQuestions.isEmpty());
            QVERIFY(isDone && read(QStringLiteral("a.obj.points.csv")) != before);
            return;
        }
        QCOMPARE(m_answers->fewerQuestions, QStringList{QStringLiteral("a.obj.points.csv 10 %1").arg(left)});
        QCOMPARE(read(QStringLiteral("a.obj.points.csv")), before);
        QCOMPARE(shownScan(), std::string("a.obj"));
        QVERIFY(m_series->isOpen() && m_series->placing() == 1);
        QCOMPARE(isDone, way == QStringLiteral("next") || way == QStringLiteral("placing"));
        QCOMPARE(placed(), static_cast<std::size_t>(left));
        stack().undo(); // the work is still there
        QCOMPARE(placed(), std::size_t(10));
    }

    void aFewerAnswerIsFollowed()
    {
        placeTen();
        const QByteArray before = read(QStringLiteral("a.obj.points.csv"));
        std::vector<std::size_t> all{0, 1, 2, 3, 4, 5, 6, 7, 8, 9};
        QVERIFY(m_document->sceneLandmarks().setMissing(all));
        m_answers->fewer = SessionQuestions::FewerAnswer::KeepSaved;
        nextScan();
        QCOMPARE(shownScan(), std::string("b.obj"));
        QCOMPARE(m_answers->fewerQuestions.size(), 1); // one question, and none about a scene
        QCOMPARE(m_answers->saveQuestions, 0);
        QCOMPARE(read(QStringLiteral("a.obj.points.csv")), before);
        m_series->previous();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(placed(), std::size_t(10));

        QVERIFY(m_document->sceneLandmarks().setMissing(all));
        m_answers->fewer = SessionQuestions::FewerAnswer::Replace;
        nextScan();
        QCOMPARE(m_answers->fewerQuestions.size(), 2);
        QVERIFY(read(QStringLiteral("a.obj.points.csv")) != before);
        undo(); // over the scans, as before
        QCOMPARE(shownScan(), std::string("a.obj"));
        QCOMPARE(placed(), std::size_t(10));
    }

    void theDirectionOfViewIsKept()
    {
        write(QStringLiteral("b.obj"), "v 100 0 0\nv 140 0 0\nv 140 0 40\nv 100 0 40\nf 1 2 3\nf 1 3 4\n"); // z is up
        openSeries();
        setCamera(*m_document, {WorldPoint(5, -30, 5), WorldPoint(5, 0, 5), {0, 0, 1}});
        switchProjection(*m_document);
        nextScan();
        const LookAt camera = *m_document->scene().camera;
        const Vector<WorldSpace> forward = camera.center - camera.eye;
        QVERIFY(std::abs(forward.x) < 1e-9 && forward.y > 0.0 && std::abs(forward.z) < 1e-9);
        QCOMPARE(camera.up.z, 1.0);
        QVERIFY(!isPerspective(m_document->scene().projection));
        const Result<glm::dmat4> clip = clipFromWorld(m_document->setup());
        QVERIFY(clip);
        double widest = 0.0;
        for (const glm::dvec3 &corner : {glm::dvec3(100, 0, 0), glm::dvec3(140, 0, 40)}) { // fitted to this scan
            const glm::dvec4 at = *clip * glm::dvec4(corner, 1.0);
            widest = std::max({widest, std::abs(at.x / at.w), std::abs(at.y / at.w)});
        }
        QVERIFY2(widest > 0.85 && widest < 1.0, qPrintable(QString::number(widest)));
        QVERIFY(!m_document->isModified());
        QVERIFY(!stack().canUndo());
    }

    void curvesComeAlongWithNames()
    {
        open({QStringLiteral("a.obj")});
        const auto placeOnSurface = [this](const char *name, double x) {
            Landmark placed;
            placed.name = name;
            placed.object = shownScan();
            placed.world = WorldPoint(x, 0.0, 0.0); // on the first edge of the first triangle
            placed.anchor = landmarks::OnTriangle{0, glm::dvec3(1.0 - x / 10.0, x / 10.0, 0.0)};
            QVERIFY(m_document->sceneLandmarks().place(placed));
        };
        placeOnSurface("one", 1.0);
        placeOnSurface("two", 8.0);
        QCOMPARE(m_document->curves().join({0, 1}, landmarks::CurveKind::Geodesic), QString());
        QVERIFY(QFile::remove(path(QStringLiteral("a.obj"))));
        m_answers->save = SessionQuestions::SaveAnswer::Discard;
        openSeries(); // b is the first scan: names and curve come from the scene
        QCOMPARE(shownScan(), std::string("b.obj"));
        QCOMPARE(points().size(), std::size_t(2));
        QCOMPARE(m_document->curves().all().size(), std::size_t(1));
        placeOnSurface("one", 2.0);
        placeOnSurface("two", 9.0);
        QVERIFY(m_series->keep());
        QVERIFY2(read(QStringLiteral("b.obj.points.csv")).contains(":09,8.2"),
                 read(QStringLiteral("b.obj.points.csv")).constData());
        QVERIFY(m_series->close());
        openSeries(); // c is new: it takes the curve of the scan before
        QCOMPARE(shownScan(), std::string("c.obj"));
        QCOMPARE(m_document->curves().all().size(), std::size_t(1));
    }

    void theTemplateOfASeriesIsChanged()
    {
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nx,1,2,0\ny,,,\nz,,,\n");
        write(QStringLiteral("b.obj.points.csv"), "name,x,y,z\ny,1,2,0\nz,,,\n");
        openSeries();
        QCOMPARE(m_series->progressText(m_series->scans()[2]), QStringLiteral("0 of 3"));
        // Template > None
        QVERIFY(m_document->sceneLandmarks().remove({1, 2}));
        QCOMPARE(m_series->progressText(m_series->scans()[0]), QStringLiteral("1 of 1"));
        QCOMPARE(m_series->progressText(m_series->scans()[2]), QStringLiteral("0 of 1"));
        QCOMPARE(m_series->landmarkNames(), (QStringList{"x", "y"})); // y is placed on b
        Landmark ten;
        ten.name = "ten";
        fillFromTemplate(*m_document, {ten}, QStringLiteral("Ten"));
        QCOMPARE(m_series->progressText(m_series->scans()[2]), QStringLiteral("0 of 2"));
        nextScan();
        const auto names = [this] {
            QStringList all;
            for (const Landmark &landmark : points())
                all << QString::fromStdString(landmark.name);
            return all;
        };
        QCOMPARE(names(), (QStringList{"y", "x", "ten"})); // and not z
        nextScan();
        QCOMPARE(names(), (QStringList{"x", "ten"})); // y was removed, and does not come back with b
        // Undo gives the names back, to all scans.
        undo();
        undo();
        QCOMPARE(shownScan(), std::string("a.obj"));
        QCOMPARE(names().mid(0, 3), (QStringList{"x", "y", "z"}));
        nextScan();
        QVERIFY(names().contains(QStringLiteral("z")));
    }

    void theTemplateIsKeptWithTheSeries()
    {
        const QString kept = QStringLiteral("series-template.csv");
        LandmarkTemplates templates;
        m_series->setTemplates(templates);
        Landmark nasion, other;
        nasion.name = "nasion";
        nasion.note = "where the nose begins";
        nasion.extra.edit() = {{"picture", "nose.png"}};
        other.name = "porion"; // no hint, though a bundled template has one
        templates.choose({nasion, other}, file(QString()));
        openSeries();
        nextScan();
        QVERIFY(!QFile::exists(path(kept))); // nothing is placed
        fillFromTemplate(*m_document, {nasion, other}, QStringLiteral("mine"));
        m_document->sceneLandmarks().waitForNext(std::nullopt);
        placeAll(1.0);
        nextScan();
        QVERIFY2(read(kept).contains("nasion") && read(kept).contains("where the nose begins"), read(kept).constData());

        crash();
        LandmarkTemplates later;
        m_series->setTemplates(later);
        openSeries();
        QCOMPARE(points().size(), std::size_t(2));
        QCOMPARE(later.hintFor(QStringLiteral("nasion")), QStringLiteral("where the nose begins"));
        QCOMPARE(later.hintFor(QStringLiteral("porion")), QString());
        QCOMPARE(later.pictureFor(QStringLiteral("nasion")).filename(), std::filesystem::path("nose.png"));
        QVERIFY2(m_notices.contains(QStringLiteral("The series takes its 2 names from series-template.csv.")),
                 qPrintable(m_notices.join(u'\n')));
        std::error_code error;
        QCOMPARE(landmark_files::readLandmarkFolder(file(QString()), {}, error).sets.size(), std::size_t(1));

        // A name that is removed stays removed, though the file of a scan still has it.
        const std::size_t porion = points()[0].name == "porion" ? 0 : 1;
        QVERIFY(!points()[porion].isPlaced());
        QVERIFY(m_document->sceneLandmarks().remove({porion}));
        placeAll(2.0);
        nextScan();
        QVERIFY(!read(kept).contains("porion"));
        openSeries();
        QCOMPARE(m_series->progressText(m_series->scans()[0]), QStringLiteral("1 of 1"));

        // A damaged one is reported once the scan is shown, and not replaced.
        const QByteArray damaged = "name,x,y,z\nnasion,1,two,3\n";
        write(kept, damaged);
        m_warnings.clear();
        openSeries();
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("series-template.csv:2:")), qPrintable(m_warnings[0]));
        placeOne("more", 3.0);
        nextScan();
        QCOMPARE(read(kept), damaged);
    }

    /// A name to place that was added on the last scan is in the template, though another folder is
    /// opened; a name that was removed is not, though its landmark is placed on that scan.
    void namesOfTheLastScanAreKept()
    {
        const QString kept = QStringLiteral("series-template.csv");
        QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("others")));
        write(QStringLiteral("others/o.obj"), kSquare);
        write(kept, "name,x,y,z\nx,,,\ny,,,\n");
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nx,1,2,0\ny,,,\n");
        write(QStringLiteral("b.obj.points.csv"), "name,x,y,z\nx,1,2,0\ny,3,2,0\n");
        LandmarkTemplates templates;
        m_series->setTemplates(templates);
        openSeries();
        QCOMPARE(shownScan(), std::string("a.obj"));
        QVERIFY(m_document->sceneLandmarks().remove({1})); // y
        nextScan();
        QCOMPARE(placed(), std::size_t(2));
        std::vector<Landmark> all = points();
        all.emplace_back().name = "ten";
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("Ten")}));
        placeOne("extra", 4.0); // fills the name to place
        all = points();
        all.emplace_back().name = "more";
        QVERIFY(editLandmarks(*m_document, all, {QStringLiteral("More")}));
        QVERIFY(m_series->open(file(QStringLiteral("others"))));
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(shownScan(), std::string("o.obj"));
        const auto read = landmark_files::readLandmarkFile(file(kept));
        QVERIFY(read);
        QStringList names;
        for (const Landmark &landmark : read->sets.front().landmarks)
            names << QString::fromStdString(landmark.name);
        QCOMPARE(names, (QStringList{"x", "ten", "more"}));
        openSeries();
        QCOMPARE(m_series->progressText(m_series->scans()[2]), QStringLiteral("0 of 3"));
        QCOMPARE(m_series->progressText(m_series->scans()[1]), QStringLiteral("3 of 4")); // with y, placed there
    }

    void aRenamedLandmarkIsStillMeasured()
    {
        for (const char *name : {"a.obj.points.csv", "b.obj.points.csv"})
            write(QLatin1String(name), "name,x,y,z\nnasion,1,2,0\nchin,4,6,0\n");
        write(QStringLiteral("c.obj.points.csv"), "name,x,y,z\nChin 2,4,6,0\n");
        write(QStringLiteral("series.measures.csv"), "name,kind,landmarks\nheight,distance,Nasion,chin\n");
        openSeries();
        m_series->show(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_document->sceneLandmarks().rename(0, QStringLiteral("n")));
        QCOMPARE(m_series->measures().front().landmarks, (std::vector<std::string>{"n", "chin"}));
        QVERIFY(read(QStringLiteral("series.measures.csv")).contains("height,distance,n,chin"));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("Scans that still have “Nasion”: 1.")),
                 qPrintable(m_warnings[0]));
        // Another landmark is none of the measure's.
        m_series->show(2);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY(m_document->sceneLandmarks().rename(0, QStringLiteral("tip")));
        QCOMPARE(m_series->measures().front().landmarks, (std::vector<std::string>{"n", "chin"}));
        QCOMPARE(m_warnings.size(), 1);
    }

    void missingOnPurposeIsDone()
    {
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nx,1,2,0\ny,,,\n");
        openSeries();
        landmarks::LandmarkSet set = m_document->scene().landmarks;
        QVERIFY(set.landmarks[1].name == "y");
        set.landmarks[1].absence = landmarks::Absence::Missing;
        QVERIFY(editLandmarkSet(*m_document, set, {QStringLiteral("Missing")}));
        QCOMPARE(m_series->progressText(m_series->scans()[0]), QStringLiteral("1 of 2, 1 missing"));
        QVERIFY(m_series->scans()[0].isComplete(points()));
        Scan skipped = m_series->scans()[0];
        skipped.points.landmarks[1].absence = landmarks::Absence::Skipped;
        QVERIFY(!skipped.isComplete(points())); // it is still to be placed
        // A damaged file of landmarks is passed over too.
        QVERIFY(m_session->save());
        crash();
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\na,1,two,3\n");
        openSeries();
        QCOMPARE(m_series->current(), std::optional<std::size_t>(1));
    }

    void aKilledSeriesContinues()
    {
        const auto isKept = [this] {
            return !QDir(path(QStringLiteral("recovery"))).entryList({QStringLiteral("*.recovery")}).isEmpty();
        };
        openSeries();
        nextScan();
        m_series->setPlacing(2);
        placeOne("first", 1.0);
        QVERIFY(m_session->save());
        placeOne("second", 2.0);
        QTRY_VERIFY_WITH_TIMEOUT(isKept(), kPatienceMilliseconds);
        crash();
        QCOMPARE(m_session->offered().size(), std::size_t(1));
        const RecoveryInfo info = m_session->offered()[0];
        QVERIFY2(info.shownName().startsWith(QStringLiteral("b.obj of the series “")), qPrintable(info.shownName()));
        QVERIFY2(info.lostText().endsWith(QStringLiteral("(landmarks placed: 2; in its file: 1)")),
                 qPrintable(info.lostText()));
        m_session->recover(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QVERIFY2(m_failures.isEmpty() && m_warnings.isEmpty(), qPrintable((m_failures + m_warnings).join(u'\n')));
        QVERIFY(m_series->isOpen());
        QCOMPARE(m_series->current(), std::optional<std::size_t>(1));
        QCOMPARE(m_series->placing(), 2);
        QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(2));
        QVERIFY(m_session->hasUnsavedChanges());
        nextScan(); // as if nothing had happened: no question, and they are in their file
        QCOMPARE(shownScan(), std::string("c.obj"));
        QCOMPARE(m_answers->saveQuestions, 0);
        QVERIFY(read(QStringLiteral("b.obj.points-2.csv")).contains("second,2,1,0"));
        QVERIFY(!isKept());
        QCOMPARE(points().size(), std::size_t(2)); // the names come along
    }

    void aSeriesKilledAfterSavingLosesNothing()
    {
        openSeries();
        placeOne("first", 1.0);
        const QDir recovery(path(QStringLiteral("recovery")));
        const auto kept = [&recovery] { return recovery.entryList({QStringLiteral("*.recovery")}); };
        QTRY_VERIFY_WITH_TIMEOUT(!kept().isEmpty(), kPatienceMilliseconds);
        const QString name = QStringLiteral("recovery/") + kept().front();
        const QByteArray first = read(name);
        placeOne("second", 2.0);
        nextScan(); // the file has both now; the program is killed before it removes what it kept
        crash();
        write(name, first);
        m_session->offerRecovery();
        QCOMPARE(m_session->offered().size(), std::size_t(1));
        m_session->recover(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
        QCOMPARE(placed(), std::size_t(2)); // the later state, from the file
        QVERIFY2(m_failures.isEmpty() && m_warnings.isEmpty(), qPrintable((m_failures + m_warnings).join(u'\n')));
        QVERIFY(!m_session->hasUnsavedChanges());
        nextScan();
        QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("second,2,1,0"));
    }

    void aFileThatChangedAfterTheCrashIsNotReplaced()
    {
        openSeries();
        placeOne("first", 1.0);
        const QDir recovery(path(QStringLiteral("recovery")));
        QTRY_VERIFY_WITH_TIMEOUT(!recovery.entryList({QStringLiteral("*.recovery")}).isEmpty(), kPatienceMilliseconds);
        crash();
        const QByteArray theirs = "name,x,y,z\nfirst,7,7,0\n";
        write(QStringLiteral("a.obj.points.csv"), theirs);
        m_session->recover(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(points()[0].world->x, 1.0);
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY(!m_series->keep());
        QCOMPARE(read(QStringLiteral("a.obj.points.csv")), theirs);
        // A folder that is gone leaves a scene with the landmarks.
        QTRY_VERIFY_WITH_TIMEOUT(!recovery.entryList({QStringLiteral("*.recovery")}).isEmpty(), kPatienceMilliseconds);
        crash();
        QVERIFY(QFile::rename(path(QStringLiteral("a.obj")), path(QStringLiteral("z.obj"))));
        m_session->recover(0);
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
        QCOMPARE(m_session->offered().size(), std::size_t(1)); // its model cannot be read: it stays offered
    }

private:
    QUndoStack &stack() const { return m_document->undoStack(); }
    /// Undoes a step, also one on another scan.
    void undo()
    {
        stack().undo();
        QCoreApplication::processEvents();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
    }

    void redo()
    {
        stack().redo();
        QCoreApplication::processEvents();
        QTRY_VERIFY_WITH_TIMEOUT(!m_session->isLoading(), kPatienceMilliseconds);
    }

    std::string shownScan() const { return m_document->objects()[0].name; }
    std::size_t placed() const
    {
        return static_cast<std::size_t>(
            std::count_if(points().begin(), points().end(), [](const Landmark &each) { return each.isPlaced(); }));
    }
    /// Ends as a crash does: the recovery file stays. Starts again.
    void crash()
    {
        // A killed program runs no destructor; its file stays as one of a program that ended.
        m_series.reset();
        m_session.reset();
        m_failures.clear();
        m_warnings.clear();
        m_notices.clear();
        m_document = std::make_unique<SceneDocument>();
        m_document->setSurface({800, 600, 1.0});
        Session::Options options;
        options.recoveryFolder = path(QStringLiteral("recovery"));
        m_session = std::make_unique<Session>(*m_document, *m_answers, options);
        m_series = std::make_unique<ScanSeries>(*m_document, *m_session);
        const auto note = [](QStringList &list) { return [&list](const QString &text) { list << text; }; };
        connect(m_series.get(), &ScanSeries::failed, this, note(m_failures));
        connect(m_series.get(), &ScanSeries::warned, this, note(m_warnings));
        connect(m_series.get(), &ScanSeries::noticed, this, note(m_notices));
        m_session->offerRecovery();
    }

    /// Places ten landmarks on the first scan and saves them.
    void placeTen()
    {
        openSeries();
        for (int i = 0; i < 10; ++i)
            placeOne(("p" + std::to_string(i)).c_str(), i);
        QVERIFY(m_session->save());
    }
};

UNPROJECTOR_TEST(TestSeriesWork, threads)
#include "test_series_work.moc"
