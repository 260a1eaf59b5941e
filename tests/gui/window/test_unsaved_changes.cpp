// Unsaved changes: their kinds, the questions about them, and the effects of the answers.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/lessons/lesson_player.h"
#include "gui/shell/main_window.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QFileDialog>
#include <QLineEdit>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTimer>
#include <QWheelEvent>

#include <functional>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene_file;

namespace {

using Act = std::function<void(MainWindow &)>;
/// The unsaved result of an action: nothing; a look, which belongs to a scene with a file; work.
enum class Kind { Nothing, Look, Work };

void setCamera(MainWindow &window, double z)
{
    setCamera(window.document(), {WorldPoint(0.0, 0.0, z), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}});
}

void cut(MainWindow &window, const std::vector<glm::dvec4> &planes = {{0.0, 1.0, 0.0, 0.0}})
{
    if (!editClipPlanes(window.document(), planes, {}, {QStringLiteral("Plane")}))
        qFatal("the change is refused");
}

void type(MainWindow &window, const char *field, const QString &text)
{
    auto *line = window.findChild<QLineEdit *>(QLatin1String(field));
    if (!line)
        qFatal("no such field");
    line->selectAll();
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
}

/// A window that asks, as the user's does, with its settings in the test's folder.
std::unique_ptr<MainWindow> askingWindow(const QString &recoveryFolder)
{
    MainWindow::Options options;
    options.smoothEdges = false;
    options.recoveryFolder = recoveryFolder;
    return std::make_unique<MainWindow>(options);
}

/// Records and answers the dialogs that come up during an action. Each must get an answer.
class MessageBoxAnswers {
public:
    explicit MessageBoxAnswers(std::optional<QMessageBox::StandardButton> answer)
    {
        QObject::connect(&m_timer, &QTimer::timeout, qApp, [this, answer] {
            QWidget *dialog = QApplication::activeModalWidget();
            if (auto *box = qobject_cast<QMessageBox *>(dialog)) {
                QCOMPARE(box->textFormat(), Qt::PlainText); // a file's name may look like markup
                m_questions << box->text();
                box->button(answer.value_or(QMessageBox::Cancel))->click();
            } else if (auto *files = qobject_cast<QFileDialog *>(dialog)) {
                m_questions << QStringLiteral("file");
                files->reject();
            }
        });
        m_timer.start(10);
    }
    const QStringList &questions() const { return m_questions; }

private:
    QStringList m_questions;
    QTimer m_timer;
};

} // namespace

Q_DECLARE_METATYPE(Act)
Q_DECLARE_METATYPE(Kind)

class TestUnsavedChanges : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void cleanup() { QFile::remove(file()); }

    void onlyWorkIsAskedAbout_data()
    {
        addColumn<Act>("deed");
        addColumn<Kind>("kind");
        const auto row = [](const char *name, Kind kind, const Act &deed) { newRow(name) << deed << kind; };
        row("nothing", Kind::Nothing, [](MainWindow &) {});
        row("home at home", Kind::Nothing, [](MainWindow &w) { goHome(w.document()); });
        row("removed object, put back", Kind::Nothing, [](MainWindow &w) {
            QVERIFY(removeObject(w.document(), 1));
            w.document().undoStack().undo();
        });
        row("removed object", Kind::Work, [](MainWindow &w) { QVERIFY(removeObject(w.document(), 1)); });
        row("camera moved", Kind::Look, [](MainWindow &w) { setCamera(w, 7.0); });
        row("camera moved and fitted", Kind::Look, [](MainWindow &w) {
            setCamera(w, 7.0);
            fitAll(w.document());
        });
        row("home", Kind::Look, [](MainWindow &w) {
            setCamera(w, 7.0);
            goHome(w.document());
        });
        row("perspective and box", Kind::Look, [](MainWindow &w) { switchProjection(w.document()); });
        row("zoomed a box", Kind::Look, [](MainWindow &w) { setProjection(w.document(), Ortho{-2, 2, -2, 2, 1, 50}); });
        row("near typed", Kind::Work, [](MainWindow &w) { type(w, "nearDistance", QStringLiteral("0.75")); });
        row("eye typed", Kind::Work, [](MainWindow &w) { type(w, "eyeX", QStringLiteral("3.5")); });
        row("near and far by hand", Kind::Work, [](MainWindow &w) {
            QVERIFY(
                editProjection(w.document(), {w.document().scene().projection, true, false}, {QStringLiteral("Fit")}));
        });
        row("transform", Kind::Work, [](MainWindow &w) {
            QVERIFY(editTransform(w.document(), 0, {Translate{{1.0, 0.0, 0.0}}}, {QStringLiteral("Move")}));
        });
        row("clip plane", Kind::Work, [](MainWindow &w) { cut(w); });
        row("clip plane, then camera", Kind::Work, [](MainWindow &w) {
            cut(w);
            setCamera(w, 7.0);
        });
        row("clip plane undone, then camera", Kind::Look, [](MainWindow &w) {
            cut(w);
            w.document().undoStack().undo();
            setCamera(w, 7.0);
        });
        row("clip plane redone", Kind::Work, [](MainWindow &w) {
            cut(w);
            w.document().undoStack().undo();
            w.document().undoStack().redo();
        });
    }

    void onlyWorkIsAskedAbout()
    {
        QFETCH(Act, deed);
        QFETCH(Kind, kind);
        const bool isWork = kind == Kind::Work;
        {
            const auto untitled = window();
            untitled->session().openBundledScene();
            deed(*untitled);
            QCOMPARE(untitled->isWindowModified(), isWork);
            const MessageBoxAnswers answers(QMessageBox::Cancel);
            QCOMPARE(untitled->close(), !isWork);
            QCOMPARE(answers.questions(),
                     isWork ? QStringList(QStringLiteral(
                         "Save the changes to Bundled scene as a scene file? Model files are not changed."))
                            : QStringList());
        }
        // The view is part of a scene that has a file.
        const auto titled = window();
        titled->session().openBundledScene();
        QVERIFY(titled->session().saveScene(path()));
        deed(*titled);
        const bool isChanged = kind != Kind::Nothing;
        QCOMPARE(titled->isWindowModified(), isChanged);
        const MessageBoxAnswers answers(QMessageBox::Discard);
        QVERIFY(titled->close());
        QCOMPARE(answers.questions(),
                 isChanged ? QStringList(QStringLiteral("Save the changes to scene.json?")) : QStringList());
    }

    void theWindowsSizeIsNoChange()
    {
        const auto titled = shownWindow(false, {640, 480});
        titled->session().openBundledScene();
        QVERIFY(titled->session().saveScene(path()));
        QVERIFY(resized(*titled, {700, 500}));
        QVERIFY(!titled->session().hasUnsavedChanges() && !titled->isWindowModified());
    }

    void aHandThatMovesNothingChangesNothing()
    {
        const auto titled = shownWindow(0, {640, 480});
        titled->session().openBundledScene();
        fitAll(titled->document());
        QVERIFY(titled->session().saveScene(path()));
        SceneView &view = titled->view();
        const QPointF place = localOf(*titled, {0.1, 0.5, 0.2});
        QWheelEvent sideways(place, view.mapToGlobal(place), {}, {120, 0}, Qt::NoButton, Qt::NoModifier,
                             Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&view, &sideways);
        for (const Qt::MouseButton button : {Qt::LeftButton, Qt::MiddleButton})
            drag(view, place, place, button);
        fitAll(titled->document());
        QVERIFY(!titled->isWindowModified());
        // A drag changes the scene; after saving, a drag or wheel without movement adds nothing.
        drag(view, place, place + QPointF(40.0, 20.0), Qt::LeftButton);
        QVERIFY(titled->isWindowModified());
        QVERIFY(titled->session().saveScene(path()));
        drag(view, place, place, Qt::LeftButton);
        turnWheel(view, place, 0);
        QVERIFY(!titled->isWindowModified());
    }

    void undoingAllOfItClearsTheMark_data()
    {
        addColumn<bool>("hasFile");
        newRow("with a file") << true;
        newRow("without one") << false;
    }

    void undoingAllOfItClearsTheMark()
    {
        QFETCH(bool, hasFile);
        const auto window = this->window();
        window->session().openBundledScene();
        if (hasFile)
            QVERIFY(window->session().saveScene(path()));
        setCamera(*window, 7.0);
        type(*window, "nearDistance", QStringLiteral("0.75"));
        type(*window, "nearDistance", QStringLiteral("0.5"));
        cut(*window);
        setCamera(*window, 8.0);
        QVERIFY(window->isWindowModified());
        while (window->document().undoStack().canUndo()) {
            QVERIFY(window->isWindowModified() || !hasFile);
            window->document().undoStack().undo();
        }
        QVERIFY(!window->isWindowModified());
    }

    void undoingPastASaveSetsTheMark()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        cut(*window);
        QVERIFY(window->session().saveScene(path()));
        QVERIFY(!window->isWindowModified());
        window->document().undoStack().undo();
        QVERIFY(window->isWindowModified());
        window->document().undoStack().redo();
        QVERIFY(!window->isWindowModified());
    }

    void workOlderThanTheUndoStackIsStillWork()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        cut(*window);
        for (int i = 0; i < window->document().undoStack().undoLimit() + 5; ++i)
            setCamera(*window, 7.0 + i);
        while (window->document().undoStack().canUndo())
            window->document().undoStack().undo();
        QCOMPARE(window->document().scene().clipPlanes.size(), std::size_t(1));
        QVERIFY(window->isWindowModified());
    }

    void aLookBetweenEditsKeepsThemApart()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        SceneDocument &document = window->document();
        QVERIFY(editClipPlanes(document, {{0.0, 1.0, 0.0, 0.0}}, {}, {QStringLiteral("Plane"), QStringLiteral("key")}));
        setCamera(document, {WorldPoint(0.0, 0.0, 7.0), WorldPoint(0.0, 0.0, 0.0), {0.0, 1.0, 0.0}},
                  QStringLiteral("key"));
        document.undoStack().undo();
        QVERIFY(document.isEdited());
        document.undoStack().undo();
        QVERIFY(!document.isEdited());
    }

    void theAnswerIsObeyed()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        QVERIFY(window->session().saveScene(path()));
        const auto planesInFile = [this] { return readSceneFile(path()).value().clipPlanes.size(); };
        cut(*window);
        {
            const MessageBoxAnswers answers(QMessageBox::Cancel);
            window->session().openBundledScene();
            QCOMPARE(window->document().scene().clipPlanes.size(), std::size_t(1));
            QVERIFY(!answers.questions().isEmpty());
            QCOMPARE(planesInFile(), std::size_t(0));
        }
        {
            const MessageBoxAnswers answers(QMessageBox::Save);
            window->session().openBundledScene();
            QCOMPARE(answers.questions().size(), 1);
            QCOMPARE(window->document().scene().clipPlanes.size(), std::size_t(0));
            QCOMPARE(planesInFile(), std::size_t(1));
        }
        cut(*window, {{0.0, 1.0, 0.0, 0.0}, {1.0, 0.0, 0.0, 0.0}});
        const MessageBoxAnswers answers(QMessageBox::Discard);
        QVERIFY(window->close());
        QCOMPARE(answers.questions().size(), 1);
        QCOMPARE(planesInFile(), std::size_t(1));
    }

    void aSceneWithoutAFileIsSavedUnderAName()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        cut(*window);
        const MessageBoxAnswers answers(QMessageBox::Save);
        QVERIFY2(!window->close(), "no name was given, so the scene is not saved, and the window stays");
        QCOMPARE(answers.questions().size(), 2);
        QCOMPARE(answers.questions().constLast(), QStringLiteral("file"));
        QVERIFY(window->isWindowModified());
    }

    void ofALessonsSceneOnlyASavedOneIsAskedAbout()
    {
        const auto window = this->window();
        window->session().openBundledScene();
        bringUp(*window);
        LessonPlayer &player = part<LessonPlayer>(*window);
        {
            const MessageBoxAnswers answers(QMessageBox::Cancel);
            QVERIFY(player.start("pipeline"));
            const std::vector<std::function<bool()>> ways = {
                [&player] { return player.next(); }, [&player] { return player.previous(); },
                [&player] { return player.restart(); }, [&player] { return player.leave(); }};
            for (const auto &goes : ways) {
                cut(*window, {{0.0, 1.0, 0.0, 0.25}});
                QVERIFY(window->session().hasUnsavedChanges());
                QVERIFY(goes());
            }
            QCOMPARE(answers.questions(), QStringList());
            QCOMPARE(window->session().name(), QStringLiteral("Bundled scene"));
        }
        QVERIFY(player.start("pipeline"));
        QVERIFY(window->session().saveScene(path()));
        cut(*window, {{0.0, 1.0, 0.0, 0.25}});
        const MessageBoxAnswers answers(QMessageBox::Cancel);
        QVERIFY(!player.leave());
        auto *dock = window->findChild<QDockWidget *>(QStringLiteral("lesson"));
        dock->close();
        QCOMPARE(answers.questions().size(), 2);
        QVERIFY(player.lesson());
        QTRY_VERIFY2_WITH_TIMEOUT(dock->isVisible(), "who stays sees the lesson", kPatienceMilliseconds);
        QCOMPARE(window->session().file(), path());
    }

private:
    QString file() const { return m_folder.filePath(QStringLiteral("scene.json")); }
    std::filesystem::path path() const { return std::filesystem::path(file().toStdU16String()); }
    std::unique_ptr<MainWindow> window() const { return askingWindow(m_folder.filePath(QStringLiteral("recovery"))); }

    QTemporaryDir m_folder;
};

UNPROJECTOR_TEST(TestUnsavedChanges, display)
#include "test_unsaved_changes.moc"
