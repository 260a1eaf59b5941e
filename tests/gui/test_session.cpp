// A session without a window: what it opens, saves and asks. Questions are answered by the test.

#include "core/scene/bundled_scene.h"
#include "gui/document/lesson_player.h"
#include "gui/document/scene_document.h"
#include "gui/document/session.h"

#include <QDir>
#include <QFile>
#include <QSignalSpy>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

#include <functional>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;

namespace {

constexpr int kMostMilliseconds = 20000;
const QByteArray kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
const QByteArray kHead = R"({"unprojector": 1, "window": {"width": 300, "height": 200},
    "projection": {"type": "ortho", "left": -3, "right": 3, "bottom": -2, "top": 2, "near": 1, "far": 9},
    "view": {"eye": [0, 0, 5], "center": [0, 0, 0], "up": [0, 1, 0]})";

std::filesystem::path pathOf(const QString &name)
{
    return std::filesystem::path(name.toStdU16String());
}

QByteArray read(const QString &file)
{
    QFile stream(file);
    return stream.open(QIODevice::ReadOnly) ? stream.readAll() : QByteArray();
}

/// Answers as it was told to, and notes what it was asked.
class CannedAnswers : public SessionQuestions {
public:
    SaveAnswer save = SaveAnswer::Cancel;
    bool yes = false;
    std::filesystem::path fileName;
    QStringList asked;
    std::function<void()> whileAsking = [] {};

    SaveAnswer askSave(const QString &name, bool) override
    {
        note(QStringLiteral("save ") + name);
        return save;
    }
    std::filesystem::path askFileName(const std::filesystem::path &proposal) override
    {
        note(QStringLiteral("name ") + QString::fromStdU16String(proposal.filename().u16string()));
        return fileName;
    }
    bool askOverwrite(const std::filesystem::path &file) override
    {
        note(QStringLiteral("overwrite ") + QString::fromStdU16String(file.filename().u16string()));
        return yes;
    }
    bool askOverwriteChanged(const std::filesystem::path &file) override
    {
        note(QStringLiteral("changed ") + QString::fromStdU16String(file.filename().u16string()));
        return yes;
    }
    bool askDeleteKept(const QString &name) override
    {
        note(QStringLiteral("delete ") + name);
        return yes;
    }

private:
    void note(const QString &question)
    {
        asked << question;
        whileAsking();
    }
};

/// A session with all it needs.
struct Desk {
    explicit Desk(const QString &recoveryFolder) : session(document, answers, {true, recoveryFolder, {}})
    {
        QObject::connect(&session, &Session::failed, &context, [this](const QString &reason) { failures << reason; });
        QObject::connect(&session, &Session::noticed, &context, [this](const QString &text) { notices << text; });
    }
    bool openAndWait(const QStringList &files, bool adds = false)
    {
        std::vector<std::filesystem::path> paths;
        for (const QString &file : files)
            paths.push_back(pathOf(file));
        adds ? session.addFiles(paths) : session.openFiles(paths);
        return QTest::qWaitFor([this] { return !session.isLoading(); }, kMostMilliseconds);
    }
    QStringList names() const
    {
        QStringList names;
        for (const SceneObject &object : document.objects())
            names << QString::fromStdString(object.name);
        return names;
    }
    void cut(double d = 0.5) { QVERIFY(document.editClipPlanes({{0.0, 1.0, 0.0, d}}, {}, {QStringLiteral("Plane")})); }

    SceneDocument document;
    CannedAnswers answers;
    Session session;
    QStringList failures;
    QStringList notices;
    QObject context;
};

using Step = std::function<void(Desk &)>;

} // namespace

Q_DECLARE_METATYPE(Step)

class TestSession : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("unprojector-test-session"));
    }
    void init()
    {
        m_folder = std::make_unique<QTemporaryDir>();
        write(QStringLiteral("triangle.obj"), kTriangle);
    }

    void scenesAreKnownByTheirContents_data();
    void scenesAreKnownByTheirContents();
    void aSavedNameGetsItsSuffix_data();
    void aSavedNameGetsItsSuffix();
    void whatSomebodyElseChangedIsAskedAbout_data();
    void whatSomebodyElseChangedIsAskedAbout();
    void aRecoveredSceneKnowsWhatItsFileHeld();
    void aReadOnlySceneIsNotWrittenOver();
    void whatLoadsIsEndedBeforeAQuestion_data();
    void whatLoadsIsEndedBeforeAQuestion();
    void modelsAreAddedAsOneStep();
    void whatWasAddedIsTold_data();
    void whatWasAddedIsTold();
    void modelsFarApartAreTold();
    void modelsOfOneNameAreToldApart();
    void aFileOfManyObjectsIsReadOnce();
    void aLessonAsksNothingAndLosesNothing();
    void theSceneBehindALessonIsAskedAbout_data();
    void theSceneBehindALessonIsAskedAbout();
    void theSceneBehindALessonIsKeptInCaseOfACrash();
    void theNameAndTheMarkFollow();
    void theAnswerIsObeyed();

private:
    QString file(const QString &name) const { return m_folder->filePath(name); }
    QString write(const QString &name, const QByteArray &text) const
    {
        QFile stream(file(name));
        if (!stream.open(QIODevice::WriteOnly) || stream.write(text) != text.size())
            qFatal("the test's folder cannot be written");
        return file(name);
    }
    QString writeScene(const QString &name) const
    {
        return write(name, kHead + R"(, "objects": [{"name": "t", "file": "triangle.obj"}]})");
    }
    std::unique_ptr<Desk> desk() const { return std::make_unique<Desk>(file(QStringLiteral("recovery"))); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

void TestSession::scenesAreKnownByTheirContents_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("json") << "scene.json";
    QTest::newRow("capitals") << "SCENE.Json";
    QTest::newRow("no suffix") << "scene";
    QTest::newRow("another suffix") << "scene.txt";
}

void TestSession::scenesAreKnownByTheirContents()
{
    QFETCH(QString, name);
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({writeScene(name)}));
    QVERIFY2(desk->failures.isEmpty(), qPrintable(desk->failures.join(u' ')));
    QCOMPARE(desk->names(), QStringList(QStringLiteral("t")));
    QCOMPARE(desk->session.name(), name);
    desk->cut();
    QVERIFY(desk->session.save());
    QVERIFY2(read(file(name)).contains("clipPlanes"), "it is saved under the name that it has");
}

void TestSession::aSavedNameGetsItsSuffix_data()
{
    QTest::addColumn<QString>("given");
    QTest::addColumn<QString>("written");
    QTest::addColumn<QString>("there");
    QTest::addColumn<bool>("yes");
    QTest::newRow("none") << "face"
                          << "face.json"
                          << "" << false;
    QTest::newRow("its own") << "face.json"
                             << "face.json"
                             << "" << false;
    QTest::newRow("another") << "face.scene"
                             << "face.scene"
                             << "" << false;
    QTest::newRow("its own, there already: that was asked with the name") << "face.json"
                                                                          << "face.json"
                                                                          << "face.json" << false;
    QTest::newRow("none, and there is one: no") << "face"
                                                << ""
                                                << "face.json" << false;
    QTest::newRow("none, and there is one: yes") << "face"
                                                 << "face.json"
                                                 << "face.json" << true;
    QTest::newRow("no name") << ""
                             << ""
                             << "" << false;
}

void TestSession::aSavedNameGetsItsSuffix()
{
    QFETCH(QString, given);
    QFETCH(QString, written);
    QFETCH(QString, there);
    QFETCH(bool, yes);
    if (!there.isEmpty())
        write(there, "somebody's");
    const auto desk = this->desk();
    desk->session.openBundledScene();
    desk->cut();
    desk->answers.yes = yes;
    desk->answers.fileName = given.isEmpty() ? std::filesystem::path() : pathOf(file(given));
    QCOMPARE(desk->session.save(), !written.isEmpty());
    QStringList questions{QStringLiteral("name scene.json")};
    if (!there.isEmpty() && given != there)
        questions << QStringLiteral("overwrite face.json");
    QCOMPARE(desk->answers.asked, questions);
    QCOMPARE(desk->session.hasUnsavedChanges(), written.isEmpty());
    if (!written.isEmpty()) {
        QVERIFY(read(file(written)).contains("unprojector"));
        QCOMPARE(desk->session.name(), written);
    } else if (!there.isEmpty()) {
        QCOMPARE(read(file(there)), QByteArray("somebody's"));
    }
}

void TestSession::whatSomebodyElseChangedIsAskedAbout_data()
{
    QTest::addColumn<bool>("yes");
    QTest::newRow("leave it") << false;
    QTest::newRow("replace it") << true;
}

void TestSession::whatSomebodyElseChangedIsAskedAbout()
{
    QFETCH(bool, yes);
    const QString scene = writeScene(QStringLiteral("scene.json"));
    const auto one = desk(), other = desk();
    QVERIFY(one->openAndWait({scene}) && other->openAndWait({scene}));
    one->cut(0.25);
    QVERIFY(one->session.save());
    one->cut(0.75);
    QVERIFY(one->session.save());
    QVERIFY2(one->answers.asked.isEmpty(), "what it wrote itself is no change of somebody else's");
    const QByteArray ofOne = read(scene);

    other->cut(0.5);
    other->answers.yes = yes;
    QCOMPARE(other->session.save(), yes);
    QCOMPARE(other->answers.asked, QStringList(QStringLiteral("changed scene.json")));
    QCOMPARE(other->session.hasUnsavedChanges(), !yes);
    QCOMPARE(read(scene) == ofOne, !yes);
    QVERIFY(other->failures.isEmpty());
    if (yes) {
        other->cut(0.125);
        QVERIFY(other->session.save());
        QCOMPARE(other->answers.asked.size(), 1);
    }
}

void TestSession::aRecoveredSceneKnowsWhatItsFileHeld()
{
    const QString scene = writeScene(QStringLiteral("scene.json"));
    {
        const auto crashed = desk();
        QVERIFY(crashed->openAndWait({scene}));
        crashed->cut();
        QTRY_VERIFY(!QDir(file(QStringLiteral("recovery"))).entryList({QStringLiteral("*.recovery")}).isEmpty());
    }
    write(QStringLiteral("scene.json"), kHead + R"(, "author": "somebody else"})");
    const auto desk = this->desk();
    desk->session.offerRecovery();
    QCOMPARE(desk->session.offered().size(), std::size_t(1));
    QSignalSpy ended(&desk->session, &Session::loadingEnded);
    desk->session.recover(0);
    QVERIFY(!ended.isEmpty() || ended.wait(kMostMilliseconds));
    QVERIFY(desk->session.hasUnsavedChanges());
    QVERIFY(!desk->session.save());
    QCOMPARE(desk->answers.asked, QStringList(QStringLiteral("changed scene.json")));
    QVERIFY(read(scene).contains("somebody else"));
    desk->session.end();
}

void TestSession::aReadOnlySceneIsNotWrittenOver()
{
    const QString scene = writeScene(QStringLiteral("scene.json"));
    const QByteArray before = read(scene);
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({scene}));
    QVERIFY(QFile::setPermissions(scene, QFile::ReadOwner));
    desk->cut();
    QVERIFY(!desk->session.save());
    QCOMPARE(desk->failures.size(), 1);
    QVERIFY2(desk->failures[0].contains(QStringLiteral("scene.json"))
                 && desk->failures[0].contains(QStringLiteral("read-only")),
             qPrintable(desk->failures[0]));
    QCOMPARE(read(scene), before);
    QVERIFY(desk->session.hasUnsavedChanges());
    QVERIFY(QFile::setPermissions(scene, QFile::ReadOwner | QFile::WriteOwner));
    desk->session.end();
}

void TestSession::whatLoadsIsEndedBeforeAQuestion_data()
{
    QTest::addColumn<Step>("step");
    QTest::addColumn<int>("questions");
    QTest::newRow("bundled scene") << Step([](Desk &d) { d.session.openBundledScene(); }) << 1;
    QTest::newRow("scene") << Step([this](Desk &d) {
        d.session.openScene(pathOf(writeScene(QStringLiteral("scene.json"))));
    }) << 1;
    QTest::newRow("unreadable scene") << Step([this](Desk &d) {
        d.session.openScene(pathOf(write(QStringLiteral("bad.json"), "{")));
        QCOMPARE(d.failures.size(), 1);
    }) << 0;
    QTest::newRow("closing") << Step([](Desk &d) { QVERIFY(!d.session.mayLeave()); }) << 1;
    QTest::newRow("save as") << Step([](Desk &d) { QVERIFY(!d.session.saveAs()); }) << 1;
}

void TestSession::whatLoadsIsEndedBeforeAQuestion()
{
    QFETCH(Step, step);
    QFETCH(int, questions);
    const auto desk = this->desk();
    desk->session.openBundledScene();
    desk->cut();
    const QStringList names = desk->names();
    QSignalSpy ended(&desk->session, &Session::loadingEnded);
    // Both would replace the scene if they ended while the question stands.
    desk->session.openFiles({pathOf(file(QStringLiteral("triangle.obj")))});
    QVERIFY(desk->session.isLoading());
    desk->answers.whileAsking = [&] { QTest::qWait(300); };
    step(*desk);
    QCOMPARE(desk->answers.asked.size(), questions);
    QVERIFY(!desk->session.isLoading());
    QCOMPARE(ended.size(), 1);
    QTest::qWait(100);
    QCOMPARE(desk->names(), names);
    QCOMPARE(desk->answers.asked.size(), questions);
    desk->session.end();
}

void TestSession::modelsAreAddedAsOneStep()
{
    const auto desk = this->desk();
    desk->session.openBundledScene();
    const QStringList before = desk->names();
    const QString broken = write(QStringLiteral("broken.obj"), "v 0 0 0\nf 1 2 9\n");
    QVERIFY(
        desk->openAndWait({file(QStringLiteral("triangle.obj")), broken, file(QStringLiteral("triangle.obj"))}, true));
    QCOMPARE(desk->failures.size(), 1);
    QVERIFY(desk->failures[0].contains(QStringLiteral("broken.obj")));
    const QString name = QStringLiteral("triangle.obj");
    QCOMPARE(desk->names(), before + QStringList({name, QStringLiteral("triangle.obj (2)")}));
    QCOMPARE(desk->notices, QStringList(QStringLiteral("2 models added: 2 triangles")));
    QVERIFY(desk->session.hasUnsavedChanges());
    QCOMPARE(desk->session.name(), QStringLiteral("Bundled scene"));
    QVERIFY(desk->answers.asked.isEmpty());
    desk->document.undoStack().undo();
    QCOMPARE(desk->names(), before);
    QVERIFY(!desk->session.hasUnsavedChanges());
    desk->session.end();
}

void TestSession::whatWasAddedIsTold_data()
{
    QTest::addColumn<double>("scale"); // of the triangle that is added, beside one of edge 1
    QTest::addColumn<QString>("said");
    const QString added = QStringLiteral("added.obj added: 1 triangle");
    QTest::newRow("of the same size") << 1.0 << added;
    QTest::newRow("100 times as large") << 99.9 << added;
    QTest::newRow("101 times as large")
        << 101.0 << added + ". added.obj is 101 times as large as the rest: Fit, in Objects, shows each.";
    QTest::newRow("100 times as small") << 0.0101 << added;
    QTest::newRow("5000 times as small")
        << 0.0002 << added + ". The rest is 5,000 times as large as added.obj: Fit, in Objects, shows each.";
    QTest::newRow("a point") << 0.0 << added;
}

void TestSession::whatWasAddedIsTold()
{
    QFETCH(double, scale);
    QFETCH(QString, said);
    const QByteArray edge = QByteArray::number(scale);
    const QString added =
        write(QStringLiteral("added.obj"), "v 0 0 0\nv " + edge + " 0 0\nv 0 " + edge + " 0\nf 1 2 3\n");
    QLocale::setDefault(QLocale(QLocale::English, QLocale::UnitedStates));
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj"))}));
    QVERIFY(desk->notices.isEmpty());
    QVERIFY(desk->openAndWait({added}, true));
    QVERIFY2(desk->failures.isEmpty(), qPrintable(desk->failures.join(u' ')));
    QCOMPARE(desk->notices, QStringList(said));
    QCOMPARE(desk->document.undoStack().count(), 1);
    desk->session.end();
}

void TestSession::modelsFarApartAreTold()
{
    const QString away = write(QStringLiteral("away.obj"), "v 1000 0 0\nv 1001 0 0\nv 1000 1 0\nf 1 2 3\n");
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj")), away}));
    QCOMPARE(desk->notices.size(), 1);
    QVERIFY2(desk->notices[0].contains(QStringLiteral("so far apart")), qPrintable(desk->notices[0]));
    desk->notices.clear();
    QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj")), file(QStringLiteral("triangle.obj"))}));
    QVERIFY(desk->notices.isEmpty());
}

void TestSession::modelsOfOneNameAreToldApart()
{
    QVERIFY(QDir(m_folder->path()).mkpath(QStringLiteral("other")));
    const QString other = write(QStringLiteral("other/triangle.obj"), kTriangle);
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj")), other}));
    QCOMPARE(desk->names(), QStringList({QStringLiteral("triangle.obj"), QStringLiteral("triangle.obj (2)")}));
}

void TestSession::aFileOfManyObjectsIsReadOnce()
{
    QByteArray objects;
    for (int i = 0; i < 5; ++i)
        objects += QByteArray(i ? ", " : "") + R"({"name": "a", "file": "triangle.obj"}, {"name": "b", "bundled": ")"
                   + QByteArray::fromStdString(bundledScene()[0].model->name) + "\"}";
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({write(QStringLiteral("many.json"), kHead + R"(, "objects": [)" + objects + "]}")}));
    QVERIFY2(desk->failures.isEmpty(), qPrintable(desk->failures.join(u' ')));
    const std::vector<SceneObject> &shown = desk->document.objects();
    QCOMPARE(shown.size(), std::size_t(10));
    for (std::size_t i = 2; i < shown.size(); ++i)
        QCOMPARE(shown[i].model.get(), shown[i % 2].model.get());
    QVERIFY(shown[0].model != shown[1].model);
}

void TestSession::aLessonAsksNothingAndLosesNothing()
{
    const auto desk = this->desk();
    desk->session.openBundledScene();
    desk->cut();
    const QStringList names = desk->names();
    LessonPlayer player(desk->document, desk->session);
    desk->session.openFiles({pathOf(file(QStringLiteral("triangle.obj")))});
    QVERIFY(player.start("pipeline"));
    QVERIFY(!desk->session.isLoading()); // it would replace the step
    QVERIFY(!desk->session.hasUnsavedChanges());
    desk->cut(0.25);
    QVERIFY(player.next() && player.leave());
    QCOMPARE(desk->names(), names);
    QCOMPARE(desk->document.scene().clipPlanes.at(0).w, 0.5);
    QVERIFY(desk->session.hasUnsavedChanges());
    QVERIFY(desk->answers.asked.isEmpty());
    desk->session.end();
}

void TestSession::theSceneBehindALessonIsAskedAbout_data()
{
    QTest::addColumn<Step>("step");
    QTest::newRow("bundled scene") << Step([](Desk &d) { d.session.openBundledScene(); });
    QTest::newRow("model") << Step([this](Desk &d) { d.openAndWait({file(QStringLiteral("triangle.obj"))}); });
    QTest::newRow("scene") << Step([this](Desk &d) { d.openAndWait({writeScene(QStringLiteral("scene.json"))}); });
    QTest::newRow("closing") << Step([](Desk &d) {
        if (d.session.mayLeave())
            d.session.end();
    });
}

void TestSession::theSceneBehindALessonIsAskedAbout()
{
    QFETCH(Step, step);
    const auto desk = this->desk();
    desk->session.openBundledScene();
    desk->cut();
    const QStringList names = desk->names();
    LessonPlayer player(desk->document, desk->session);
    QVERIFY(player.start("pipeline"));
    desk->cut(0.25);
    desk->answers.whileAsking = [&] { QCOMPARE(desk->names(), names); }; // what is asked about is shown
    step(*desk);
    QCOMPARE(desk->answers.asked, QStringList(QStringLiteral("save Bundled scene")));
    QVERIFY(!player.lesson());
    QCOMPARE(desk->names(), names);
    QVERIFY(desk->session.hasUnsavedChanges());
    desk->answers.asked.clear();
    desk->answers.save = SessionQuestions::SaveAnswer::Discard;
    QVERIFY(player.start("pipeline"));
    step(*desk);
    QCOMPARE(desk->answers.asked.size(), 1);
    desk->session.end();
    QVERIFY(QDir(file(QStringLiteral("recovery"))).entryList(QDir::Files).isEmpty());
    // Where nothing is unsaved nothing is asked, and nothing comes back.
    desk->session.openBundledScene();
    desk->answers.asked.clear();
    QVERIFY(player.start("pipeline"));
    desk->cut(0.25);
    step(*desk);
    QVERIFY(desk->answers.asked.isEmpty());
    desk->session.end();
}

void TestSession::theSceneBehindALessonIsKeptInCaseOfACrash()
{
    {
        const auto crashed = desk();
        crashed->session.openBundledScene();
        crashed->cut();
        LessonPlayer player(crashed->document, crashed->session);
        QVERIFY(player.start("pipeline"));
    }
    const auto desk = this->desk();
    desk->session.offerRecovery();
    QCOMPARE(desk->session.offered().size(), std::size_t(1));
    QCOMPARE(desk->session.offered()[0].name, QStringLiteral("Bundled scene"));
    desk->session.recover(0);
    QTRY_COMPARE(desk->document.scene().clipPlanes.size(), std::size_t(1));
    // It goes with the scene, there and back, and ends with it.
    const auto kept = [this] { return QDir(file(QStringLiteral("recovery"))).entryList({"*"}, QDir::Files).size(); };
    const int files = static_cast<int>(kept());
    QVERIFY(files > 0);
    LessonPlayer player(desk->document, desk->session);
    QVERIFY(player.start("pipeline"));
    QVERIFY(kept() == files);
    QVERIFY(player.leave());
    QVERIFY(kept() == files);
    QVERIFY(player.start("pipeline"));
    desk->answers.save = SessionQuestions::SaveAnswer::Discard;
    QVERIFY(desk->session.mayLeave());
    desk->session.end();
    QVERIFY(kept() == 0);
}

void TestSession::theNameAndTheMarkFollow()
{
    const auto desk = this->desk();
    QSignalSpy changes(&desk->session, &Session::changed);
    QSignalSpy opened(&desk->session, &Session::opened);
    QVERIFY(desk->session.openLesson(desk->document.scene(), QStringLiteral("Step"), QStringLiteral("rows")));
    QCOMPARE(desk->session.name(), QStringLiteral("Step"));
    QCOMPARE(opened.takeLast().at(0).toString(), QStringLiteral("rows"));
    QVERIFY(!desk->session.hasUnsavedChanges());
    desk->session.openBundledScene();
    QVERIFY(opened.takeLast().at(0).toString().isEmpty());
    changes.clear();
    desk->cut();
    QVERIFY(!changes.isEmpty() && desk->session.hasUnsavedChanges());
    changes.clear();
    desk->document.undoStack().undo();
    QVERIFY(!changes.isEmpty() && !desk->session.hasUnsavedChanges());
}

void TestSession::theAnswerIsObeyed()
{
    const QString scene = writeScene(QStringLiteral("scene.json"));
    const auto desk = this->desk();
    QVERIFY(desk->openAndWait({scene}));
    desk->cut();
    desk->answers.save = SessionQuestions::SaveAnswer::Cancel;
    desk->session.openBundledScene();
    QCOMPARE(desk->names(), QStringList(QStringLiteral("t")));
    desk->answers.save = SessionQuestions::SaveAnswer::Save;
    desk->session.openBundledScene();
    QCOMPARE(desk->names().size(), 5);
    QVERIFY(read(scene).contains("clipPlanes"));
    desk->cut();
    desk->answers.save = SessionQuestions::SaveAnswer::Discard;
    QVERIFY(desk->openAndWait({scene}));
    QCOMPARE(desk->names(), QStringList(QStringLiteral("t")));
    QCOMPARE(desk->answers.asked, (QStringList{QStringLiteral("save scene.json"), QStringLiteral("save scene.json"),
                                               QStringLiteral("save Bundled scene")}));
}

QTEST_GUILESS_MAIN(TestSession)
#include "test_session.moc"
