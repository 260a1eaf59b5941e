// A session without a window: its opening, saving and questions. The test answers the questions.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "tests/gui/document/session_desk.h"
#include "tests/support/patience.h"

#include <QSignalSpy>
#include <QStandardPaths>

using namespace sessions;
using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::scene;

class TestSession : public QObject, protected FolderUser {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("unprojector-test-session"));
    }
    void init() { changeFolder(); }

    void scenesAreKnownByTheirContents_data()
    {
        addColumn<QString>("name");
        newRow("json") << "scene.json";
        newRow("capitals") << "SCENE.Json";
        newRow("no suffix") << "scene";
        newRow("another suffix") << "scene.txt";
    }

    void scenesAreKnownByTheirContents()
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

    void aSavedNameGetsItsSuffix_data()
    {
        addColumn<QString>("given");
        addColumn<QString>("written");
        addColumn<QString>("there");
        addColumn<bool>("yes");
        newRow("none") << "face"
                       << "face.json"
                       << "" << false;
        newRow("its own") << "face.json"
                          << "face.json"
                          << "" << false;
        newRow("another") << "face.scene"
                          << "face.scene"
                          << "" << false;
        newRow("its own, there already: that was asked with the name") << "face.json"
                                                                       << "face.json"
                                                                       << "face.json" << false;
        newRow("none, and there is one: no") << "face"
                                             << ""
                                             << "face.json" << false;
        newRow("none, and there is one: yes") << "face"
                                              << "face.json"
                                              << "face.json" << true;
        newRow("no name") << ""
                          << ""
                          << "" << false;
    }

    void aSavedNameGetsItsSuffix()
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

    void whatSomebodyElseChangedIsAskedAbout_data()
    {
        addColumn<bool>("yes");
        newRow("leave it") << false;
        newRow("replace it") << true;
    }

    void whatSomebodyElseChangedIsAskedAbout()
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

    void aRecoveredSceneKnowsWhatItsFileHeld()
    {
        const QString scene = writeScene(QStringLiteral("scene.json"));
        {
            const auto crashed = desk();
            QVERIFY(crashed->openAndWait({scene}));
            crashed->cut();
            QTRY_VERIFY_WITH_TIMEOUT(
                !QDir(file(QStringLiteral("recovery"))).entryList({QStringLiteral("*.recovery")}).isEmpty(),
                kPatienceMilliseconds);
        }
        write(QStringLiteral("scene.json"), kHead + ", \"author\": \"somebody else\"}");
        const auto desk = this->desk();
        desk->session.offerRecovery();
        QCOMPARE(desk->session.offered().size(), std::size_t(1));
        QSignalSpy ended(&desk->session, &Session::loadingEnded);
        desk->session.recover(0);
        QVERIFY(!ended.isEmpty() || ended.wait(kPatienceMilliseconds));
        QVERIFY(desk->session.hasUnsavedChanges());
        QVERIFY(!desk->session.save());
        QCOMPARE(desk->answers.asked, QStringList(QStringLiteral("changed scene.json")));
        QVERIFY(read(scene).contains("somebody else"));
        desk->session.end();
    }

    void aReadOnlySceneIsNotWrittenOver()
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

    void whatLoadsIsEndedBeforeAQuestion_data()
    {
        addColumn<Step>("step");
        addColumn<int>("questions");
        newRow("bundled scene") << Step([](Desk &d) { d.session.openBundledScene(); }) << 1;
        newRow("scene") << Step([this](Desk &d) {
            d.session.openScene(pathOf(writeScene(QStringLiteral("scene.json"))));
        }) << 1;
        newRow("unreadable scene") << Step([this](Desk &d) {
            d.session.openScene(pathOf(write(QStringLiteral("bad.json"), "{")));
            QCOMPARE(d.failures.size(), 1);
        }) << 0;
        newRow("closing") << Step([](Desk &d) { QVERIFY(!d.session.mayLeave()); }) << 1;
        newRow("save as") << Step([](Desk &d) { QVERIFY(!d.session.saveAs()); }) << 1;
    }

    void whatLoadsIsEndedBeforeAQuestion()
    {
        QFETCH(Step, step);
        QFETCH(int, questions);
        const auto desk = this->desk();
        desk->session.openBundledScene();
        desk->cut();
        const QStringList names = desk->names();
        QSignalSpy ended(&desk->session, &Session::loadingEnded);
        // Both would replace the scene if they ended while the question is open.
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

    void modelsAreAddedAsOneStep()
    {
        const auto desk = this->desk();
        desk->session.openBundledScene();
        const QStringList before = desk->names();
        const QString broken = write(QStringLiteral("broken.obj"), "v 0 0 0\nf 1 2 9\n");
        QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj")), broken, file(QStringLiteral("triangle.obj"))},
                                  true));
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

    void whatWasAddedIsTold_data()
    {
        addColumn<double>("scale"); // of the triangle that is added, beside one of edge 1
        addColumn<QString>("said");
        const QString added = QStringLiteral("added.obj added: 1 triangle");
        newRow("of the same size") << 1.0 << added;
        newRow("100 times as large") << 99.9 << added;
        newRow("101 times as large") << 101.0
                                     << added
                                            + ". added.obj is 101 times as large as the rest. To see one "
                                              "object, choose Fit in the Objects panel.";
        newRow("100 times as small") << 0.0101 << added;
        newRow("5000 times as small") << 0.0002
                                      << added
                                             + ". The rest is 5,000 times as large as added.obj. To see one "
                                               "object, choose Fit in the Objects panel.";
        newRow("a point") << 0.0 << added;
    }

    void whatWasAddedIsTold()
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

    void modelsFarApartAreTold()
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

    void modelsOfOneNameAreToldApart()
    {
        QVERIFY(QDir(file(QString())).mkpath(QStringLiteral("other")));
        const QString other = write(QStringLiteral("other/triangle.obj"), kTriangle);
        const auto desk = this->desk();
        QVERIFY(desk->openAndWait({file(QStringLiteral("triangle.obj")), other}));
        QCOMPARE(desk->names(), QStringList({QStringLiteral("triangle.obj"), QStringLiteral("triangle.obj (2)")}));
    }

    void aFileOfManyObjectsIsReadOnce()
    {
        QByteArray objects;
        for (int i = 0; i < 5; ++i)
            objects += QByteArray(i ? ", " : "")
                       + "{\"name\": \"a\", \"file\": \"triangle.obj\"}, {\"name\": \"b\", \"bundled\": \""
                       + QByteArray::fromStdString(examples::bundledScene()[0].model->name) + "\"}";
        const auto desk = this->desk();
        QVERIFY(desk->openAndWait({write(QStringLiteral("many.json"), kHead + ", \"objects\": [" + objects + "]}")}));
        QVERIFY2(desk->failures.isEmpty(), qPrintable(desk->failures.join(u' ')));
        const std::vector<SceneObject> &shown = desk->document.objects();
        QCOMPARE(shown.size(), std::size_t(10));
        for (std::size_t i = 2; i < shown.size(); ++i)
            QCOMPARE(shown[i].model.get(), shown[i % 2].model.get());
        QVERIFY(shown[0].model != shown[1].model);
    }

    void keysThatAreNotKeptAreNamed()
    {
        const auto desk = this->desk();
        QSignalSpy warned(&desk->session, &Session::warned);
        QVERIFY(desk->openAndWait({writeScene("scene.json")}));
        QVERIFY(warned.isEmpty());
        QVERIFY(desk->openAndWait(
            {write("scene.json", kHead
                                     + ", \"author\": \"A\",\n"
                                       "        \"objects\": [{\"file\": \"triangle.obj\", \"colour\": \"red\", "
                                       "\"transform\": [{\"translate\": [0, 0, 1]},\n"
                                       "            {\"comment\": 1, \"scale\": [2, 2, 2], \"unit\": \"cm\"}]}],\n"
                                       "        \"ui\": {\"clipPlanesOff\": [{\"place\": 0, \"plane\": [1, 0, 0, 0]}, "
                                       "{\"place\": 1, \"plane\": [0, 0, 1, 2], \"by\": \"hand\"}]}}")}));
        QCOMPARE(warned.size(), 1);
        QCOMPARE(
            warned[0][0].toString(),
            QStringLiteral("scene.json: objects[0].transform[1].comment and 1 more: unknown key in a transform step; "
                           "it is not saved.\nscene.json: ui.clipPlanesOff[1].by: unknown key; it is not saved once "
                           "the clip plane is switched on."));
    }

    void aPreviewedCameraIsNotSaved()
    {
        const auto desk = this->desk();
        const QString scene = writeScene(QStringLiteral("scene.json"));
        QVERIFY(desk->openAndWait({scene}));
        QVERIFY(desk->session.save());
        const QByteArray before = read(scene);
        SceneSettings other = desk->document.scene();
        other.windowSize = geometry::Surface{641, 479, 1.0};
        QVERIFY(desk->document.preview(other));
        QVERIFY(desk->document.setup() != desk->document.ownSetup());
        QVERIFY(desk->session.save());
        QCOMPARE(read(scene), before);
        QCOMPARE(desk->document.setup().surface.widthPixels, 641);
    }

    void theNameAndTheMarkFollow()
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

    void theAnswerIsObeyed()
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
};

UNPROJECTOR_TEST(TestSession)
#include "test_session.moc"
