// Points from files and into files, alone and with their models, and series of scans.

#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "gui/document/lesson_player.h"
#include "gui/document/point_files.h"
#include "gui/document/point_templates.h"
#include "gui/document/scan_series.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"
#include "gui/text/error_text.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <random>

using namespace unprojector;
using namespace unprojector::gui;
using landmarks::Landmark;

namespace {

struct FixedAnswers : SessionQuestions, PointFileQuestions {
    SaveAnswer askSave(const QString &, bool) override
    {
        ++saveQuestions;
        return save;
    }
    std::filesystem::path askFileName(const std::filesystem::path &) override { return {}; }
    bool askOverwrite(const std::filesystem::path &) override { return true; }
    bool askOverwriteChanged(const std::filesystem::path &) override { return true; }
    bool askDeleteKept(const QString &) override { return true; }
    Join askJoin(const Counts &counts) override
    {
        ++joinQuestions;
        asked = counts;
        if (meanwhile)
            meanwhile();
        return join;
    }
    PointFileQuestions::Stray askStray(const QString &text) override
    {
        strayText = text;
        return stray;
    }

    Order askOrder(const QString &text) override
    {
        orderText = text;
        return order;
    }

    SaveAnswer save = SaveAnswer::Discard;
    Join join = Join::Replace;
    PointFileQuestions::Stray stray = PointFileQuestions::Stray::Tie;
    int saveQuestions = 0, joinQuestions = 0;
    std::function<void()> meanwhile; ///< happens while somebody is asked
    Counts asked;
    QString strayText, orderText;
    Order order = Order::Fill;
};

/// A square of two triangles from (0, 0, 0) to (10, 10, 0).
const QByteArray kSquare = "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nf 1 2 3\nf 1 3 4\n";

} // namespace

class TestPointFiles : public QObject {
    Q_OBJECT

private slots:
    void init();
    void pointFilesByName_data();
    void pointFilesByName();
    void openedWithTheirModel();
    void openedAlone();
    void pointsWithoutAnObjectAreInSight();
    void importedPointsAreTied();
    void straysAreAskedAbout_data();
    void straysAreAskedAbout();
    void thoseThatAreThere_data();
    void thoseThatAreThere();
    void namesThatWaitAreFilled();
    void namesThatAFileWritesOtherwiseAreFilled();
    void replacedPointsKeepTheScenesNames();
    void pointsWithoutNamesFillByOrder_data();
    void pointsWithoutNamesFillByOrder();
    void semilandmarksAreNoPoints();
    void countsAddUp_data();
    void countsAddUp();
    void whatDoesNotHoldIsLetGo_data();
    void whatDoesNotHoldIsLetGo();
    void aPointOnAnObjectThatIsNotThereIsFree();
    void whatIsKeptWithAScanIsLetGoToo();
    void aSeriesThatIsNotWantedLeavesTheOneBefore();
    void whatCannotBeReadSaysWhy_data();
    void whatCannotBeReadSaysWhy();
    void exportedAndReadBack_data();
    void exportedAndReadBack();
    void whatIsLostIsSaid();
    void aSeriesGoesOnWhereItWasLeft();
    void aScanComesBackAfterALesson();
    void aScanThatIsNotKeptComesBackToBeAskedAbout();
    void anotherSceneIsNoneOfTheSeries();
    void aScanThatIsGivenUpLeavesTheOneShown();
    void lookingAroundWritesNothing();
    void aSeriesWithABrokenScan();
    void aDamagedFileOfPointsIsNotWrittenOver();
    void tablesOfASeries();
    void repeatsOfASeries();
    void aTurnedScanKeepsItsFilesNumbers();
    void whatSomebodyElseWroteIsNotWrittenOver();
    void aDamagedPlacingIsNotGoneOver();
    void whatATableLacksIsSaid();
    void unitsAndKeysAreNotLost_data();
    void unitsAndKeysAreNotLost();
    void aQuestionIsOfTheSceneBelowIt();
    void aHundredScansAndABrokenOne();
    void noScanGetsThePointsOfAnother();

private:
    QString path(const QString &name) const { return m_folder->filePath(name); }
    std::filesystem::path file(const QString &name) const { return path(name).toStdU16String(); }
    void write(const QString &name, const QByteArray &text) const
    {
        QFile out(path(name));
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }
    QByteArray read(const QString &name) const
    {
        QFile in(path(name));
        return in.open(QIODevice::ReadOnly) ? in.readAll() : QByteArray("no file");
    }
    void open(const QStringList &names)
    {
        std::vector<std::filesystem::path> files;
        for (const QString &name : names)
            files.push_back(file(name));
        m_session->openFiles(files);
        QTRY_VERIFY(!m_session->isLoading());
    }
    const std::vector<Landmark> &points() const { return m_document->landmarks(); }
    void placeAll(double x)
    {
        while (m_document->points().waiting()) {
            Landmark placed;
            placed.world = WorldPoint(x, 1.0, 0.0);
            QVERIFY(m_document->points().place(placed));
        }
    }

    void placeOne(const char *name, double x)
    {
        Landmark placed;
        placed.name = name;
        placed.world = WorldPoint(x, 1.0, 0.0);
        QVERIFY(m_document->points().place(placed));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<FixedAnswers> m_answers;
    std::unique_ptr<Session> m_session;
    std::unique_ptr<PointFiles> m_files;
    std::unique_ptr<ScanSeries> m_series;
    QStringList m_failures, m_warnings, m_notices;
};

void TestPointFiles::init()
{
    m_series.reset();
    m_files.reset();
    m_session.reset();
    m_failures.clear();
    m_warnings.clear();
    m_notices.clear();
    m_folder = std::make_unique<QTemporaryDir>();
    m_answers = std::make_unique<FixedAnswers>();
    m_document = std::make_unique<SceneDocument>();
    m_document->setSurface({800, 600, 1.0});
    Session::Options options;
    options.remembers = true;
    options.recoveryFolder = path(QStringLiteral("recovery"));
    m_session = std::make_unique<Session>(*m_document, *m_answers, options);
    m_files = std::make_unique<PointFiles>(*m_document, m_answers.get());
    m_series = std::make_unique<ScanSeries>(*m_document, *m_session);
    const auto note = [](QStringList &list) { return [&list](const QString &text) { list << text; }; };
    connect(m_files.get(), &PointFiles::failed, this, note(m_failures));
    connect(m_series.get(), &ScanSeries::failed, this, note(m_failures));
    connect(m_session.get(), &Session::failed, this, note(m_failures));
    connect(m_files.get(), &PointFiles::warned, this, note(m_warnings));
    connect(m_series.get(), &ScanSeries::warned, this, note(m_warnings));
    connect(m_session.get(), &Session::warned, this, note(m_warnings));
    connect(m_files.get(), &PointFiles::noticed, this, note(m_notices));
    connect(m_session.get(), &Session::pointFilesOpened, this,
            [this](const std::vector<std::filesystem::path> &opened) {
                for (const std::filesystem::path &one : opened)
                    m_files->importFrom(one);
            });
    write(QStringLiteral("square.obj"), kSquare);
}

void TestPointFiles::pointFilesByName_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<bool>("is");
    QTest::newRow("picked points") << "a.pp" << true;
    QTest::newRow("in capitals") << "A.PP" << true;
    QTest::newRow("markups") << "a.mrk.json" << true;
    QTest::newRow("a scene") << "a.json" << false;
    QTest::newRow("a template") << "a.pptpl" << false;
    QTest::newRow("only written") << "a.nts" << false;
    QTest::newRow("a model") << "a.ply" << false;
    QTest::newRow("no suffix") << "points" << false;
}

void TestPointFiles::pointFilesByName()
{
    QFETCH(QString, name);
    QFETCH(bool, is);
    QCOMPARE(PointFiles::isPointFile(name.toStdU16String()), is);
}

void TestPointFiles::openedWithTheirModel()
{
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
    open({QStringLiteral("p.csv"), QStringLiteral("square.obj")});
    QCOMPARE(m_failures, QStringList());
    QCOMPARE(points().size(), std::size_t(1));
    QCOMPARE(points()[0].object, std::string("square.obj"));
    // Without the model there is nothing that they belong to.
    init();
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
    open({QStringLiteral("p.csv"), QStringLiteral("none.obj")});
    QCOMPARE(m_failures.size(), 1);
    QVERIFY(points().empty());
}

void TestPointFiles::openedAlone()
{
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\nb,,,\n");
    open({QStringLiteral("p.csv")});
    QCOMPARE(m_document->objects().size(), std::size_t(1));
    QCOMPARE(points().size(), std::size_t(2));
    QVERIFY(points()[1].isMissing());
    m_document->undoStack().undo();
    QVERIFY(points().empty());
}

void TestPointFiles::pointsWithoutAnObjectAreInSight()
{
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1000,2000,30\nb,1400,2100,40\n");
    QSignalSpy noticed(m_files.get(), &PointFiles::noticed);
    open({QStringLiteral("p.csv")});
    QCOMPARE(points().size(), std::size_t(2));
    QVERIFY(noticed.count() == 1 && noticed[0][0].toString().contains(QStringLiteral("no object")));
    const glm::dmat4 clipFromScene = *clipFromWorld(m_document->geometry());
    for (const Landmark &point : points()) {
        const glm::dvec4 clip = clipFromScene * glm::dvec4(point.world->coordinates(), 1.0);
        QVERIFY(clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w);
    }
}

void TestPointFiles::importedPointsAreTied()
{
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0.125\n");
    QSignalSpy noticed(m_files.get(), &PointFiles::noticed);
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
    QCOMPARE(points()[0].world->coordinates(), glm::dvec3(1.0, 2.0, 0.0));
    QVERIFY(std::holds_alternative<landmarks::OnTriangle>(points()[0].hold));
    QCOMPARE(m_answers->strayText, QString());
    QCOMPARE(noticed.count(), 1);
    QVERIFY2(noticed[0][0].toString().contains(QStringLiteral("0.13 (a)"))
                 || noticed[0][0].toString().contains(QStringLiteral("0.12 (a)")),
             qPrintable(noticed[0][0].toString()));
}

void TestPointFiles::straysAreAskedAbout_data()
{
    QTest::addColumn<int>("answer");
    QTest::addColumn<bool>("isRead");
    QTest::addColumn<double>("z");
    QTest::newRow("moved onto the mesh") << int(PointFileQuestions::Stray::Tie) << true << 0.0;
    QTest::newRow("left where they are") << int(PointFileQuestions::Stray::LeaveFree) << true << 5.0;
    QTest::newRow("given up") << int(PointFileQuestions::Stray::Cancel) << false << 0.0;
}

void TestPointFiles::straysAreAskedAbout()
{
    QFETCH(int, answer);
    QFETCH(bool, isRead);
    QFETCH(double, z);
    m_answers->stray = static_cast<PointFileQuestions::Stray>(answer);
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\nfar,3,4,5\n");
    QCOMPARE(m_files->importFrom(file(QStringLiteral("p.csv"))), isRead);
    QVERIFY2(m_answers->strayText.contains(QStringLiteral("“far” is 5 off")), qPrintable(m_answers->strayText));
    QCOMPARE(points().size(), std::size_t(isRead ? 2 : 0));
    if (isRead) {
        QCOMPARE(points()[1].world->z, z);
        QCOMPARE(std::holds_alternative<landmarks::Free>(points()[1].hold), z != 0.0);
    }
}

void TestPointFiles::thoseThatAreThere_data()
{
    QTest::addColumn<int>("answer");
    QTest::addColumn<int>("count");
    QTest::newRow("replaced") << int(PointFileQuestions::Join::Replace) << 1;
    QTest::newRow("joined") << int(PointFileQuestions::Join::Append) << 2;
    QTest::newRow("given up") << int(PointFileQuestions::Join::Cancel) << 1;
}

void TestPointFiles::thoseThatAreThere()
{
    QFETCH(int, answer);
    QFETCH(int, count);
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\na,1,2,0\n");
    m_answers->join = static_cast<PointFileQuestions::Join>(answer);
    m_files->importFrom(file(QStringLiteral("p.csv")));
    QCOMPARE(m_answers->joinQuestions, 0);
    m_files->importFrom(file(QStringLiteral("p.csv")));
    QCOMPARE(m_answers->joinQuestions, 1);
    QCOMPARE(static_cast<int>(points().size()), count);
}

void TestPointFiles::namesThatWaitAreFilled()
{
    open({QStringLiteral("square.obj")});
    const auto named = [](const char *name) {
        Landmark point;
        point.name = name;
        return point;
    };
    fillFromTemplate(*m_document, {named("a"), named("b"), named("c")}, QStringLiteral("three"));
    write(QStringLiteral("p.csv"), "name,x,y,z\nB,1,2,0\nother,2,2,0\n");
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
    QCOMPARE(m_answers->joinQuestions, 0); // nothing that was placed is at stake
    QCOMPARE(points().size(), std::size_t(4));
    QVERIFY(points()[0].isMissing() && points()[2].isMissing());
    QCOMPARE(points()[1].name, std::string("b")); // as the template has it
    QCOMPARE(points()[3].name, std::string("other"));
    QCOMPARE(m_warnings.size(), 1);
    QVERIFY2(m_warnings[0].contains(QStringLiteral("behind the others: “other”. Still without a place: “a”, “c”.")),
             qPrintable(m_warnings[0]));
    // Now two are placed and two names wait.
    m_answers->join = PointFileQuestions::Join::Append;
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

namespace {

std::vector<Landmark> namedPoints(const QStringList &names)
{
    std::vector<Landmark> points;
    for (const QString &name : names)
        points.emplace_back().name = name.toStdString();
    return points;
}

} // namespace

void TestPointFiles::namesThatAFileWritesOtherwiseAreFilled()
{
    open({QStringLiteral("square.obj")});
    fillFromTemplate(*m_document, namedPoints({"eye left", "eye_left", "Broca's point", "tip"}),
                     QStringLiteral("four"));
    write(QStringLiteral("p.pts"), "Version 1.0\n4\nEYE_LEFT 1 1 0\neye_left 2 2 0\nBroca_s_point 3 3 0\nchin 4 4 0\n");
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
    QCOMPARE(points().size(), std::size_t(5));
    QCOMPARE(points()[0].name, std::string("eye left"));
    QCOMPARE(points()[0].world->x, 1.0);
    QCOMPARE(points()[1].world->x, 2.0); // its very name
    QCOMPARE(points()[2].name, std::string("Broca's point"));
    QCOMPARE(points()[2].world->x, 3.0);
    QVERIFY(points()[3].isMissing());
    QVERIFY2(m_notices[0].contains(QStringLiteral("Names that have their point now: 3.")), qPrintable(m_notices[0]));
    QVERIFY2(m_warnings.size() == 1 && m_warnings[0].contains(QStringLiteral("“chin”. Still without a place: “tip”.")),
             qPrintable(m_warnings.join(u'\n')));
}

void TestPointFiles::replacedPointsKeepTheScenesNames()
{
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\neye left,1,1,0\neye right,2,1,0\n");
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
    write(QStringLiteral("p.pts"), "Version 1.0\n2\neye_left 3 1 0\neye_right 4 1 0\n");
    m_answers->join = PointFileQuestions::Join::Replace;
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
    QCOMPARE(points()[0].name, std::string("eye left")); // curves know it by that
    QCOMPARE(points()[0].world->x, 3.0);
    write(QStringLiteral("p.tps"), "LM3=2\n5 1 0\n6 1 0\n\n");
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.tps"))));
    QCOMPARE(points()[1].name, std::string("eye right"));
    QVERIFY2(m_warnings.join(u'\n').contains(QStringLiteral("by their order")), qPrintable(m_warnings.join(u'\n')));
}

void TestPointFiles::pointsWithoutNamesFillByOrder_data()
{
    QTest::addColumn<QByteArray>("rows");
    QTest::addColumn<int>("answer");
    QTest::addColumn<QString>("names"); ///< of those with a place
    QTest::addColumn<QString>("said");
    using Order = PointFileQuestions::Order;
    QTest::newRow("as many") << QByteArray("1 1 0\n2 2 0\n3 3 0\n") << -1 << "a b c"
                             << "took those that waited, by their order";
    QTest::newRow("one missing") << QByteArray("1 1 0\nNA NA NA\n3 3 0\n") << -1 << "a c"
                                 << "by their order";
    QTest::newRow("fewer") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Fill) << "a b"
                           << "by their order";
    QTest::newRow("more") << QByteArray("1 1 0\n2 2 0\n3 3 0\n4 4 0\n") << int(Order::Fill) << "a b c "
                          << "by their order";
    QTest::newRow("put behind") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Behind) << " "
                                << "put behind the others: 2. Still";
    QTest::newRow("given up") << QByteArray("1 1 0\n2 2 0\n") << int(Order::Cancel) << QString() << QString();
}

void TestPointFiles::pointsWithoutNamesFillByOrder()
{
    QFETCH(QByteArray, rows);
    QFETCH(int, answer);
    QFETCH(QString, names);
    QFETCH(QString, said);
    open({QStringLiteral("square.obj")});
    fillFromTemplate(*m_document, namedPoints({"a", "b", "c"}), QStringLiteral("three"));
    write(QStringLiteral("p.tps"), "LM3=" + QByteArray::number(rows.count('\n')) + '\n' + rows + '\n');
    if (answer >= 0)
        m_answers->order = static_cast<PointFileQuestions::Order>(answer);
    QCOMPARE(m_files->importFrom(file(QStringLiteral("p.tps"))), !said.isEmpty());
    QCOMPARE(m_answers->orderText.isEmpty(), answer < 0);
    QStringList placed;
    for (const Landmark &point : points()) {
        if (!point.isMissing())
            placed << QString::fromStdString(point.name);
    }
    QCOMPARE(placed.join(u' '), names);
    QVERIFY2(m_warnings.join(u'\n').contains(said), qPrintable(m_warnings.join(u'\n')));
}

void TestPointFiles::semilandmarksAreNoPoints()
{
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.pts"), "Version 1.0\n5\na 1 1 0\nb 3 3 0\nbrow:01 1 1 0\nbrow:02 2 2 0\nbrow:03 3 3 0\n");
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
    QCOMPARE(points().size(), std::size_t(2));
    QCOMPARE(m_document->landmarkSet().curves.size(), std::size_t(1));
    QCOMPARE(m_document->landmarkSet().curves[0].name, std::string("brow"));
    QCOMPARE(m_document->landmarkSet().curves[0].semilandmarks.size(), std::size_t(3));
    QVERIFY2(m_notices[0].contains(QStringLiteral("p.pts: 2."))
                 && m_notices[0].contains(QStringLiteral("3, of “brow”")),
             qPrintable(m_notices[0]));
    // A curve that the scene has itself goes through its points.
    landmarks::LandmarkSet set = m_document->landmarkSet();
    set.curves[0].points = {"a", "b"};
    QVERIFY(m_document->editLandmarkSet(set, {QStringLiteral("test")}));
    for (const auto join : {PointFileQuestions::Join::Replace, PointFileQuestions::Join::Append}) {
        m_answers->join = join;
        QVERIFY(m_files->importFrom(file(QStringLiteral("p.pts"))));
        QCOMPARE(m_document->landmarkSet().curves.size(), std::size_t(1));
        QCOMPARE(m_document->landmarkSet().curves[0].points.size(), std::size_t(2));
        QVERIFY2(m_warnings.back().contains(QStringLiteral("its own stay: brow")), qPrintable(m_warnings.back()));
    }
}

void TestPointFiles::countsAddUp_data()
{
    QTest::addColumn<QByteArray>("rows");
    QTest::addColumn<QString>("said");
    QTest::newRow("all on the mesh") << QByteArray("a,1,2,0\nb,2,2,0\n") << "2. They lie on the mesh.";
    QTest::newRow("one beyond all distances")
        << QByteArray("a,1,2,0\nb,1e308,2,0\n")
        << "2. On the mesh: 1. They lie on the mesh. Free where they are, far from it: 1.";
    QTest::newRow("one of each") << QByteArray("a,1,2,0\nb,1e308,2,0\nc,,,\nd,3,3,5\n")
                                 << "4. On the mesh: 1. They lie on the mesh. Free where they are, far from it: 2. "
                                    "Without a place: 1.";
    QTest::newRow("none on the mesh") << QByteArray("d,3,3,5\n") << "1. Free where they are, far from it: 1.";
}

void TestPointFiles::countsAddUp()
{
    QFETCH(QByteArray, rows);
    QFETCH(QString, said);
    m_answers->stray = PointFileQuestions::Stray::LeaveFree;
    open({QStringLiteral("square.obj")});
    write(QStringLiteral("p.csv"), "name,x,y,z\n" + rows);
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
    QCOMPARE(m_notices, QStringList(QStringLiteral("Points read from p.csv: ") + said));
}

void TestPointFiles::whatDoesNotHoldIsLetGo_data()
{
    QTest::addColumn<QByteArray>("held");
    QTest::addColumn<QString>("said");
    QTest::newRow("a triangle") << QByteArray(R"({"triangle": 1, "barycentric": [0.5, 0.25, 0.25]})") << "";
    QTest::newRow("no such triangle") << QByteArray(R"({"triangle": 2, "barycentric": [0.5, 0.25, 0.25]})")
                                      << "held by what their object does not have: 1, as “a” (triangle 2)";
    QTest::newRow("no such vertex") << QByteArray(R"({"vertex": 4})") << "does not have: 1, as “a” (vertex 4)";
    QTest::newRow("no such edge") << QByteArray(R"({"edge": [0, 9], "share": 0.5})") << "“a” (edge 0–9)";
    QTest::newRow("another mesh's") << QByteArray(R"({"triangle": 0, "barycentric": [0.5, 0.25, 0.25]})")
                                    << "elsewhere than what holds them";
}

void TestPointFiles::whatDoesNotHoldIsLetGo()
{
    QFETCH(QByteArray, held);
    QFETCH(QString, said);
    // The second triangle is (0, 0), (10, 10), (0, 10).
    write(QStringLiteral("scene.json"),
          R"({"unprojector": 1, "window": {"width": 800, "height": 600, "devicePixelRatio": 1},
              "projection": {"type": "frustum", "left": -1, "right": 1, "bottom": -0.75, "top": 0.75, "near": 1, "far": 100},
              "view": {"eye": [5, 5, 30], "center": [5, 5, 0], "up": [0, 1, 0]},
              "objects": [{"name": "square", "file": "square.obj"}],
              "landmarks": {"points": [{"name": "a", "position": [2.5, 5, 0], "object": "square", "held": )"
              + held + "}]}}");
    open({QStringLiteral("scene.json")});
    QVERIFY2(m_failures.isEmpty(), qPrintable(m_failures.join(u'\n')));
    QCOMPARE(points().size(), std::size_t(1));
    QVERIFY(*points()[0].world == WorldPoint(2.5, 5.0, 0.0));
    QCOMPARE(std::holds_alternative<landmarks::Free>(points()[0].hold), !said.isEmpty());
    QCOMPARE(m_warnings.size(), said.isEmpty() ? 0 : 1);
    if (said.isEmpty())
        return;
    QVERIFY2(m_warnings[0].contains(said) && m_warnings[0].startsWith(QStringLiteral("scene.json: ")),
             qPrintable(m_warnings[0]));
}

void TestPointFiles::aPointOnAnObjectThatIsNotThereIsFree()
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
    QVERIFY(points()[0].object.empty() && std::holds_alternative<landmarks::Free>(points()[0].hold));
    QCOMPARE(m_warnings.size(), 1);
    QVERIFY2(m_warnings[0].contains(QStringLiteral("not here: 1, as “a” (on “skull”)")), qPrintable(m_warnings[0]));
    // A scan's are the scan's, whatever it was called.
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z,object,face,u,v,w\na,2.5,5,0,old.obj,1,0.5,0.25,0.25\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(points()[0].object, std::string("square.obj"));
    QVERIFY2(m_warnings.back().contains(QStringLiteral("“old.obj”")), qPrintable(m_warnings.back()));
}

void TestPointFiles::whatIsKeptWithAScanIsLetGoToo()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z,object,face,u,v,w\na,1,2,0,square.obj,7,1,0,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(points().size(), std::size_t(1));
    QVERIFY(std::holds_alternative<landmarks::Free>(points()[0].hold));
    QCOMPARE(m_warnings.size(), 1);
    QVERIFY2(m_warnings[0].contains(QStringLiteral("“a” (triangle 7)")), qPrintable(m_warnings[0]));
}

void TestPointFiles::aSeriesThatIsNotWantedLeavesTheOneBefore()
{
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("others")));
    for (const char *name : {"others/b.obj", "others/c.obj"})
        write(QLatin1String(name), kSquare);
    open({QStringLiteral("square.obj")});
    placeAll(1.0);
    Landmark placed;
    placed.world = WorldPoint(1.0, 1.0, 0.0);
    QVERIFY(m_document->points().place(placed));
    m_answers->save = SessionQuestions::SaveAnswer::Cancel;
    QVERIFY(m_series->open(file(QStringLiteral("others"))));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_answers->saveQuestions, 1);
    QVERIFY(!m_series->isOpen()); // as if it had never been asked for
    QVERIFY(!m_series->current());
    QCOMPARE(points().size(), std::size_t(1));

    m_answers->save = SessionQuestions::SaveAnswer::Discard;
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->folder(), file(QString()));
    QVERIFY(m_document->points().place(placed));
    QVERIFY(
        m_document->editTransform(0, {Translate{{1.0, 0.0, 0.0}}}, {QStringLiteral("Move")})); // this is asked about
    m_answers->save = SessionQuestions::SaveAnswer::Cancel;
    QVERIFY(m_series->open(file(QStringLiteral("others"))));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->folder(), file(QString()));
    QCOMPARE(m_series->scans().size(), std::size_t(1));
    QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
    QCOMPARE(m_series->scans()[0].placedCount(), points().size());
    // And its points are kept as before.
    QVERIFY(m_document->points().moveTo(0, WorldPoint(4.0, 3.0, 0.0)));
    QVERIFY(m_series->keep());
    QVERIFY2(read(QStringLiteral("square.obj.points.csv")).contains(",3,3,0"),
             read(QStringLiteral("square.obj.points.csv")).constData());
}

void TestPointFiles::whatCannotBeReadSaysWhy_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("said");
    QTest::newRow("a word for a number") << "p.csv" << QByteArray("name,x,y,z\na,1,two,3\n") << "p.csv:2:";
    QTest::newRow("not there") << "none.csv" << QByteArray() << "none.csv";
    QTest::newRow("of no known kind") << "p.txt" << QByteArray("1 2 3") << "p.txt";
}

void TestPointFiles::whatCannotBeReadSaysWhy()
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

void TestPointFiles::exportedAndReadBack_data()
{
    QTest::addColumn<QString>("suffix");
    for (const char *suffix : {"csv", "pp", "mrk.json", "fcsv", "pts", "tps"})
        QTest::newRow(suffix) << suffix;
}

void TestPointFiles::exportedAndReadBack()
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

void TestPointFiles::whatIsLostIsSaid()
{
    open({QStringLiteral("square.obj")});
    Landmark point;
    point.name = "a";
    point.note = "worn";
    point.world = WorldPoint(1.0, 2.0, 0.0);
    QVERIFY(m_document->editLandmarks({point}, {QStringLiteral("test")}));
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

void TestPointFiles::aSeriesGoesOnWhereItWasLeft()
{
    for (const char *name : {"b.obj", "c.obj"})
        write(QLatin1String(name), kSquare);
    QFile::rename(path(QStringLiteral("square.obj")), path(QStringLiteral("a.obj")));
    open({QStringLiteral("a.obj")});
    Landmark first, second;
    first.name = "first";
    second.name = "second";
    QVERIFY(m_document->editLandmarks({first, second}, {QStringLiteral("template")}));
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->scans().size(), std::size_t(3));
    QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
    QCOMPARE(points().size(), std::size_t(2)); // what was to be placed is what is to be placed
    m_answers->saveQuestions = 0;
    placeAll(1.0);
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_answers->saveQuestions, 0);
    QVERIFY(read(QStringLiteral("a.obj.points.csv")).contains("first,1,1,0"));
    QCOMPARE(points().size(), std::size_t(2));
    QVERIFY(points()[0].isMissing());
    QCOMPARE(m_document->points().waiting(), std::optional<std::size_t>(0));
    placeAll(2.0);
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
    m_series->next(); // there is none
    QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
    m_series->previous();
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(points()[1].world->x, 2.0);
    QVERIFY(!m_document->isModified());
    QVERIFY(!m_document->undoStack().canUndo());
    // Nothing was placed on the third: there is nothing of it to keep.
    QVERIFY(!QFile::exists(path(QStringLiteral("c.obj.points.csv"))));

    // Whoever leaves the program keeps the points, without a question.
    QVERIFY(m_document->points().moveTo(0, WorldPoint(9.0, 9.0, 0.0)));
    QVERIFY(m_session->mayLeave());
    QCOMPARE(m_answers->saveQuestions, 0);
    QVERIFY(read(QStringLiteral("b.obj.points.csv")).contains("first,9,9,0"));

    // Opened again, the series goes on at the one that lacks points.
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
    open({QStringLiteral("a.obj")}); // another scene
    QCOMPARE(m_series->current(), std::optional<std::size_t>());
}

void TestPointFiles::aScanComesBackAfterALesson()
{
    for (const char *name : {"t.obj", "u.obj"})
        write(QLatin1String(name), kSquare);
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
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

    // Its points are those of the placing that it was left in.
    QVERIFY(player.start("pipeline"));
    m_series->setPlacing(2);
    QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(0));
    QVERIFY(player.leave());
    QCOMPARE(m_series->placing(), 1);
    QCOMPARE(m_series->scans()[1].placedCount(), std::size_t(3));

    // From a lesson it goes on behind the scan that was left for it, and nothing is asked about what the steps tell to do.
    QVERIFY(player.start("pipeline"));
    QVERIFY(m_document->editClipPlanes({{0.0, 1.0, 0.0, 0.25}}, {}, {QStringLiteral("Plane")}));
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
    QVERIFY(!player.lesson());
    QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
    QCOMPARE(m_answers->saveQuestions, 0);
    QCOMPARE(points().size(), std::size_t(3)); // which wait here
    QVERIFY(points()[2].isMissing());

    // What was opened instead of it is no scan, whatever comes back to it.
    QVERIFY(player.start("pipeline"));
    m_session->openBundledScene();
    QVERIFY(player.start("pipeline") && player.leave());
    QCOMPARE(m_series->current(), std::optional<std::size_t>());
    QVERIFY2(m_failures.isEmpty(), qPrintable(m_failures.join(u'\n')));
}

void TestPointFiles::aScanThatIsNotKeptComesBackToBeAskedAbout()
{
    write(QStringLiteral("t.obj"), kSquare);
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("other")));
    write(QStringLiteral("other/v.obj"), kSquare);
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    placeOne("first", 1.0);
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\nfirst,5,5,0\n"); // by somebody else
    m_answers->save = SessionQuestions::SaveAnswer::Cancel;
    LessonPlayer player(*m_document, *m_session);
    const std::vector<std::function<void()>> ways = {[this] { QVERIFY(!m_session->mayLeave()); },
                                                     [this] { m_series->next(); },
                                                     [this] { m_series->open(file(QStringLiteral("other"))); }};
    for (const auto &leaves : ways) {
        QVERIFY(player.start("pipeline"));
        m_answers->saveQuestions = 0;
        leaves();
        QTRY_VERIFY(!m_session->isLoading());
        QCOMPARE(m_answers->saveQuestions, 1);
        QVERIFY(!player.lesson());
        QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
        QCOMPARE(m_series->scans().size(), std::size_t(2));
        placeOne("another", 2.0);
        QCOMPARE(m_series->scans()[0].placedCount(), points().size());
    }
    QCOMPARE(points().size(), std::size_t(4));
    m_session->end();
}

void TestPointFiles::anotherSceneIsNoneOfTheSeries()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->scans()[0].placedCount(), std::size_t(1));
    m_session->openBundledScene();
    QVERIFY(points().empty());
    QCOMPARE(m_series->current(), std::optional<std::size_t>());
    QCOMPARE(m_series->scans()[0].placedCount(), std::size_t(1)); // as a table of the series has it
}

void TestPointFiles::aScanThatIsGivenUpLeavesTheOneShown()
{
    write(QStringLiteral("other.obj"), kSquare);
    write(QStringLiteral("other.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,2,2,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    m_series->next();
    m_session->cancelLoading();
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
    QVERIFY(m_document->points().moveTo(0, WorldPoint(5.0, 5.0, 0.0)));
    QVERIFY(m_series->keep());
    QVERIFY(read(QStringLiteral("other.obj.points.csv")).contains("a,5,5,0"));
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,2,2,0"));
    // And what is opened next is not taken for it.
    m_session->openBundledScene();
    QVERIFY(points().empty());
}

void TestPointFiles::lookingAroundWritesNothing()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,7,7,0\n"); // by another program
    LookAt camera = m_document->scene().camera;
    camera.eye.x += 1.0;
    m_document->setCamera(camera);
    QVERIFY(m_series->keep());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,7,7,0"));
}

void TestPointFiles::aSeriesWithABrokenScan()
{
    write(QStringLiteral("broken.obj"), "v 1 2\n");
    write(QStringLiteral("broken2.ply"), "ply\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->current(), std::optional<std::size_t>(0));
    QVERIFY(!m_series->scans()[0].problem.isEmpty());
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
    m_series->next();
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->current(), std::optional<std::size_t>(2));
    QCOMPARE(m_document->objects()[0].name, std::string("square.obj"));
    QVERIFY(m_series->scans()[2].problem.isEmpty());

    QVERIFY(QDir(path(QString())).mkdir(QStringLiteral("empty")));
    QVERIFY(!m_series->open(file(QStringLiteral("empty"))));
    QVERIFY(!m_series->open(file(QStringLiteral("nowhere"))));
    QCOMPARE(m_series->scans().size(), std::size_t(3)); // the one before is still there
}

void TestPointFiles::aDamagedFileOfPointsIsNotWrittenOver()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,two,3\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QVERIFY(m_series->scans()[0].problem.contains(QStringLiteral("square.obj.points.csv:2:")));
    QVERIFY(m_series->keep());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("two"));
}

void TestPointFiles::tablesOfASeries()
{
    write(QStringLiteral("other.obj"), kSquare);
    write(QStringLiteral("other.obj.points.csv"), "name,x,y,z\nb,1,2,0\na,3,4,0\n");
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,5,6,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->pointNames(), (QStringList{"b", "a"}));
    QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
    QCOMPARE(read(QStringLiteral("wide.csv")),
             QByteArray("specimen,b_x,b_y,b_z,a_x,a_y,a_z\nother,1,2,0,3,4,0\nsquare,,,,5,6,0\n"));
    QVERIFY(m_series->exportTable(file(QStringLiteral("all.tps")), ScanSeries::Table::Tps));
    QCOMPARE(read(QStringLiteral("all.tps")),
             QByteArray("LM3=2\n1 2 0\n3 4 0\nID=other\n\nLM3=2\nNA NA NA\n5 6 0\nID=square\n\n"));
    QVERIFY(m_series->exportTable(file(QStringLiteral("all.nts")), ScanSeries::Table::Nts));
    QVERIFY(m_series->exportTable(file(QStringLiteral("long.csv")), ScanSeries::Table::Long));
    QVERIFY(read(QStringLiteral("long.csv")).startsWith("specimen,name,x,y,z"));
    QVERIFY(!m_series->exportTable(file(QStringLiteral("no/folder/x.csv")), ScanSeries::Table::Wide));
}

void TestPointFiles::repeatsOfASeries()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,0,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QStringList told;
    connect(m_series.get(), &ScanSeries::noticed, this, [&told](const QString &text) { told << text; });
    QVERIFY(m_series->exportTable(file(QStringLiteral("repeats.csv")), ScanSeries::Table::Repeats));
    QVERIFY2(told.back().contains(QStringLiteral("No scan was placed more than once")), qPrintable(told.back()));
    m_series->setPlacing(2);
    QCOMPARE(points().size(), std::size_t(1));
    QVERIFY(points()[0].isMissing());
    m_document->points().waitForNext(std::nullopt);
    placeAll(3.0);
    QVERIFY(m_series->exportTable(file(QStringLiteral("repeats.csv")), ScanSeries::Table::Repeats));
    QVERIFY2(told.back().startsWith(QStringLiteral("Repeats written to repeats.csv. Scans that were placed more than "
                                                   "once: 1;")),
             qPrintable(told.back()));
    QVERIFY(QFile::exists(path(QStringLiteral("square.obj.points-2.csv"))));
    QCOMPARE(read(QStringLiteral("square.obj.points.csv")), QByteArray("name,x,y,z\na,1,0,0\n"));
    const QByteArray repeats = read(QStringLiteral("repeats.csv"));
    QVERIFY2(repeats.startsWith("specimen,name,placings,x,y,z,error,farthest\nsquare,a,2,2,0.5,0,1.58"),
             repeats.constData());
    m_series->setPlacing(1);
    QCOMPARE(points()[0].world->x, 1.0);
    QVERIFY(m_document->points().moveTo(0, WorldPoint(4.0, 4.0, 0.0)));
    QVERIFY(m_series->close());
    QVERIFY(!m_series->isOpen() && !m_series->hasNext() && !m_series->hasPrevious());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,4,4,0")); // kept, and still shown
    QCOMPARE(points()[0].world->x, 4.0);
    QVERIFY(m_document->points().moveTo(0, WorldPoint(5.0, 4.0, 0.0)));
    QVERIFY(m_session->mayLeave());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,4,4,0")); // no scan of a series any more
}

/// A quarter turn about z takes (x, y) to (-y, x): what is placed in the scene stands in the file by the file's own coordinates.
void TestPointFiles::aTurnedScanKeepsItsFilesNumbers()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,2,0\nb,,,\nc,,,\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    const QByteArray before = read(QStringLiteral("square.obj.points.csv"));
    QVERIFY(m_document->editTransform(0, {Rotate{90.0, {0, 0, 1}}, Scale{{2, 2, 2}}}, {QStringLiteral("turn")}));
    QVERIFY(glm::distance(points()[0].world->coordinates(), glm::dvec3(-4, 2, 0)) < 1e-12); // it has gone with its scan
    QVERIFY(m_series->keep());
    QCOMPARE(read(QStringLiteral("square.obj.points.csv")), before); // nothing of it has changed
    Landmark held;
    held.object = "square.obj";
    held.hold = landmarks::OnTriangle{0, glm::dvec3(0.5, 0.25, 0.25)};
    held.world = WorldPoint(-5.0, 10.0, 0.0); // (5, 2.5, 0) of the file
    QVERIFY(m_document->points().place(held));
    Landmark free;
    free.world = WorldPoint(-8.0, 6.0, 2.0); // (3, 4, 1)
    QVERIFY(m_document->points().place(free));
    QCOMPARE(m_document->renameObject(0, QStringLiteral("turned")), NameFault::None);
    QVERIFY(m_series->keep());
    const auto kept = landmark_files::readLandmarkFile(file(QStringLiteral("square.obj.points.csv")));
    QVERIFY(kept);
    const std::vector<Landmark> &rows = kept->sets.front().landmarks;
    QCOMPARE(rows[0].world->coordinates(), glm::dvec3(1.0, 2.0, 0.0));
    QCOMPARE(rows[1].world->coordinates(), glm::dvec3(5.0, 2.5, 0.0));
    QCOMPARE(rows[1].object, std::string("square.obj"));
    QVERIFY(glm::distance(rows[2].world->coordinates(), glm::dvec3(3.0, 4.0, 1.0)) < 1e-12);
    QVERIFY(m_series->scans()[0].points == kept->sets.front()); // as tables have them
    // Read again into the scene as it stands, they are where they were.
    const std::vector<Landmark> shown = points();
    m_series->setPlacing(2);
    m_series->setPlacing(1);
    for (std::size_t i = 0; i < 3; ++i) {
        QVERIFY(glm::distance(points()[i].world->coordinates(), shown[i].world->coordinates()) < 1e-12);
        QCOMPARE(points()[i].object, std::string("turned"));
    }
    // Without the scan in the scene its points have the places that it gave them.
    QVERIFY(m_document->removeObject(0));
    QVERIFY(m_document->points().rename(0, QStringLiteral("A")));
    QVERIFY(m_series->keep());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("A,1,2,0"));
}

void TestPointFiles::whatSomebodyElseWroteIsNotWrittenOver()
{
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QVERIFY(m_document->points().moveTo(0, WorldPoint(5.0, 5.0, 0.0)));
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

void TestPointFiles::aDamagedPlacingIsNotGoneOver()
{
    const QByteArray damaged = "name,x,y,z\na,1,two,3\n";
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,1,0\n");
    write(QStringLiteral("square.obj.points-2.csv"), damaged);
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    m_series->setPlacing(2);
    QCOMPARE(m_series->placing(), 1);
    QCOMPARE(m_failures.size(), 1);
    QVERIFY(m_failures[0].contains(QStringLiteral("points-2.csv:2:")));
    QVERIFY(m_document->points().moveTo(0, WorldPoint(5.0, 5.0, 0.0))); // and what is shown is still kept
    QVERIFY(m_series->keep());
    QVERIFY(read(QStringLiteral("square.obj.points.csv")).contains("a,5,5,0"));
    QCOMPARE(read(QStringLiteral("square.obj.points-2.csv")), damaged);

    // From a damaged one it is gone on to one that is not, and what was placed meanwhile is asked about.
    write(QStringLiteral("square.obj.points.csv"), damaged);
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    Landmark placed;
    placed.world = WorldPoint(3.0, 3.0, 0.0);
    QVERIFY(m_document->points().place(placed));
    m_answers->saveQuestions = 0;
    m_series->setPlacing(3);
    QCOMPARE(m_answers->saveQuestions, 1);
    QCOMPARE(m_series->placing(), 3);
    QVERIFY(points().size() == 1 && points()[0].isMissing());
    QVERIFY(m_document->points().place(placed));
    QVERIFY(m_series->keep());
    QVERIFY(QFile::exists(path(QStringLiteral("square.obj.points-3.csv"))));
    QCOMPARE(read(QStringLiteral("square.obj.points.csv")), damaged);
}

void TestPointFiles::whatATableLacksIsSaid()
{
    write(QStringLiteral("other.obj"), kSquare);
    write(QStringLiteral("third.obj"), kSquare);
    write(QStringLiteral("other.obj.points.csv"), "name,x,y,z,note\na,3,4,0,worn\n");
    write(QStringLiteral("other.obj.points-3.csv"), "name,x,y,z\na,3,5,0\n"); // the second observer left it out
    write(QStringLiteral("square.obj.points.csv"), "name,x,y,z\na,1,two,3\n");
    write(QStringLiteral("third.obj.points.csv"), "specimen,name,x,y,z\np,a,1,2,3\nq,a,1,2,3\n");
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    for (const auto table : {ScanSeries::Table::Wide, ScanSeries::Table::Tps, ScanSeries::Table::Repeats}) {
        m_warnings.clear();
        QVERIFY(m_series->exportTable(file(QStringLiteral("all.csv")), table));
        QCOMPARE(m_warnings.size(), 1);
        QVERIFY2(m_warnings[0].contains(QStringLiteral("square.obj.points.csv:2:"))
                     && m_warnings[0].contains(QStringLiteral("third.obj.points.csv")),
                 qPrintable(m_warnings[0]));
        QCOMPARE(m_warnings[0].contains(QStringLiteral("note")), table != ScanSeries::Table::Repeats);
    }
    QVERIFY2(read(QStringLiteral("all.csv")).contains("other,a,2,3,4.5,0,"),
             read(QStringLiteral("all.csv")).constData());
}

void TestPointFiles::unitsAndKeysAreNotLost_data()
{
    QTest::addColumn<int>("answer");
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("unit");
    QTest::addColumn<QString>("said");
    using Join = PointFileQuestions::Join;
    const QByteArray plain = "name,x,y,z\na,1,2,0\n", cm = "name,x,y,z,unit\na,1,2,0,cm\n",
                     mm = "name,x,y,z,unit\na,1,2,0,mm\n";
    QTest::newRow("replaced, no unit") << int(Join::Replace) << plain << "mm" << QString();
    QTest::newRow("replaced, the same") << int(Join::Replace) << mm << "mm" << QString();
    QTest::newRow("replaced, another") << int(Join::Replace) << cm << "cm"
                                       << "cm";
    QTest::newRow("appended, no unit") << int(Join::Append) << plain << "mm" << QString();
    QTest::newRow("appended, another") << int(Join::Append) << cm << "mm"
                                       << "cm";
}

void TestPointFiles::unitsAndKeysAreNotLost()
{
    QFETCH(int, answer);
    QFETCH(QByteArray, text);
    QFETCH(QString, unit);
    QFETCH(QString, said);
    open({QStringLiteral("square.obj")});
    landmarks::LandmarkSet set;
    set.unit = "mm";
    set.mesh = "skull.ply";
    set.extra["scanner"] = "old";
    set.landmarks.resize(1);
    set.landmarks[0].world = WorldPoint(4.0, 4.0, 0.0);
    QVERIFY(m_document->editLandmarkSet(set, {QStringLiteral("test")}));
    m_answers->join = static_cast<PointFileQuestions::Join>(answer);
    write(QStringLiteral("p.csv"), text);
    QVERIFY(m_files->importFrom(file(QStringLiteral("p.csv"))));
    QCOMPARE(QString::fromStdString(m_document->landmarkSet().unit), unit);
    QCOMPARE(m_document->landmarkSet().mesh, std::string("skull.ply"));
    QVERIFY(m_document->landmarkSet().extra == set.extra);
    QCOMPARE(m_warnings.size(), said.isEmpty() ? 0 : 1);
    QVERIFY(said.isEmpty() || m_warnings[0].contains(said));
    m_document->undoStack().undo();
    QVERIFY(m_document->landmarkSet() == set);
}

void TestPointFiles::aQuestionIsOfTheSceneBelowIt()
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

/// Each scan is a triangle of its own size, on which three points have been placed; one file is broken, and so are the points of
/// another one.
void TestPointFiles::aHundredScansAndABrokenOne()
{
    constexpr int kScans = 100, kBroken = 41, kDamaged = 70;
    QVERIFY(QFile::remove(path(QStringLiteral("square.obj"))));
    const auto nameOf = [](int i) { return QStringLiteral("scan%1.obj").arg(i, 3, 10, QChar(u'0')); };
    for (int i = 0; i < kScans; ++i) {
        const QByteArray size = QByteArray::number(i + 1);
        write(nameOf(i),
              i == kBroken ? QByteArray("v 1 2\n") : "v 0 0 0\nv " + size + " 0 0\nv 0 " + size + " 0\nf 1 2 3\n");
        if (i == kDamaged)
            write(nameOf(i) + QStringLiteral(".points.csv"), "name,x,y,z\na,1,two,3\n");
    }
    open({nameOf(0)});
    fillFromTemplate(
        *m_document,
        [] {
            std::vector<Landmark> names(3);
            names[0].name = "a";
            names[1].name = "b";
            names[2].name = "c";
            return names;
        }(),
        QStringLiteral("three"));
    QVERIFY(m_series->open(file(QString())));
    QTRY_VERIFY(!m_session->isLoading());
    QCOMPARE(m_series->scans().size(), std::size_t(kScans));
    for (int i = 0; i < kScans; ++i) {
        QCOMPARE(m_series->current(), std::optional<std::size_t>(i));
        if (i != kBroken && i != kDamaged) {
            QCOMPARE(m_document->objects()[0].name, nameOf(i).toStdString());
            for (const glm::dvec3 &corner : {glm::dvec3(0.0), glm::dvec3(i + 1, 0, 0), glm::dvec3(0, i + 1, 0)}) {
                Landmark placed;
                placed.world = WorldPoint(corner);
                QVERIFY(m_document->points().place(placed));
            }
            QVERIFY(!m_document->points().waiting());
        }
        m_series->next();
        QTRY_VERIFY(!m_session->isLoading());
    }
    QCOMPARE(m_answers->saveQuestions, 1); // of the names that were there before
    QCOMPARE(m_failures.size(), 2);
    QVERIFY(m_failures[0].contains(nameOf(kBroken)) && m_failures[1].contains(nameOf(kDamaged)));

    QVERIFY(m_series->exportTable(file(QStringLiteral("long.csv")), ScanSeries::Table::Long));
    const auto rows = landmark_files::readLandmarkFile(file(QStringLiteral("long.csv")));
    QVERIFY(rows);
    QCOMPARE(rows->sets.size(), std::size_t(kScans - 2));
    QVERIFY(m_series->exportTable(file(QStringLiteral("all.tps")), ScanSeries::Table::Tps));
    const auto tps = landmark_files::readLandmarkFile(file(QStringLiteral("all.tps")));
    QVERIFY(tps);
    QCOMPARE(tps->sets.size(), std::size_t(kScans - 2));
    QVERIFY(m_series->exportTable(file(QStringLiteral("wide.csv")), ScanSeries::Table::Wide));
    const QList<QByteArray> wide = read(QStringLiteral("wide.csv")).trimmed().split('\n');
    QCOMPARE(wide.size(), qsizetype(kScans - 2 + 1));
    QCOMPARE(wide[0], QByteArray("specimen,a_x,a_y,a_z,b_x,b_y,b_z,c_x,c_y,c_z"));
    std::size_t row = 0;
    for (int i = 0; i < kScans; ++i) {
        if (i == kBroken || i == kDamaged)
            continue;
        const std::string specimen = nameOf(i).chopped(4).toStdString();
        QCOMPARE(rows->sets[row].name, specimen);
        QCOMPARE(tps->sets[row].name, specimen);
        QCOMPARE(rows->sets[row].landmarks[2].world->coordinates(), glm::dvec3(0, i + 1, 0));
        QCOMPARE(tps->sets[row].landmarks[1].world->coordinates(), glm::dvec3(i + 1, 0, 0));
        ++row;
        QCOMPARE(wide[qsizetype(row)],
                 QStringLiteral("scan%1,0,0,0,%2,0,0,0,%2,0").arg(i, 3, 10, QChar(u'0')).arg(i + 1).toUtf8());
    }
    QVERIFY(m_warnings.join(u'\n').contains(nameOf(kDamaged)));
}

/// Whatever is done in whatever order, while files come and go: each scan's file has what was last seen on that scan, and no other's.
void TestPointFiles::noScanGetsThePointsOfAnother()
{
    QVERIFY(QFile::remove(path(QStringLiteral("square.obj"))));
    const auto nameOf = [](std::size_t i) { return QStringLiteral("scan%1.obj").arg(i); };
    constexpr std::size_t kScans = 6;
    for (std::size_t i = 0; i < kScans; ++i)
        write(nameOf(i), kSquare);
    std::mt19937 random(11);
    const auto below = [&random](std::size_t count) { return static_cast<std::size_t>(random() % count); };
    std::map<std::filesystem::path, std::vector<Landmark>> seen; // by the file that keeps it
    const auto isScan = [this] { return m_document->objects().size() == 1 && !m_document->objects()[0].file.empty(); };
    // Names that wait are not written for themselves.
    const auto placedOf = [](const std::vector<Landmark> &all) {
        std::vector<std::pair<std::string, WorldPoint>> placed;
        for (const Landmark &point : all) {
            if (!point.isMissing())
                placed.emplace_back(point.name, *point.world);
        }
        return placed;
    };
    const auto look = [&](bool isOther = false) { // other than last time only by a deed
        if (!isScan())
            return;
        const auto kept = landmark_files::landmarksBeside(m_document->objects()[0].file, m_series->placing());
        QVERIFY2(isOther || !seen.contains(kept) || placedOf(seen[kept]) == placedOf(points()),
                 qPrintable(pathText(kept)));
        seen[kept] = points();
    };
    const auto open = [&] {
        QVERIFY(m_series->open(file(QString())));
        QTRY_VERIFY(!m_session->isLoading());
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
            m_document->undoStack().undo();
        } else if (kind == 11 && isScan()) {
            Landmark point;
            point.name = "p" + std::to_string(below(4));
            point.world = WorldPoint(double(below(10)), double(below(10)), 0.0);
            QVERIFY(m_document->points().place(point));
        }
        look(kind == 10 || kind == 11);
        if (below(3) > 0) { // else what is loading is met by what comes next
            QTRY_VERIFY(!m_session->isLoading());
            look();
        }
        QVERIFY(!m_series->current() || *m_series->current() < m_series->scans().size());
    }
    QTRY_VERIFY(!m_session->isLoading());
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

QTEST_MAIN(TestPointFiles)
#include "test_point_files.moc"
