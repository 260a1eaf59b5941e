// Points in the whole window: opened with their model, dropped, from menus, and on a series of
// scans by keys.

#include "tests/support/test.h"

#include "tests/gui/scan_folder.h"
#include "tests/gui/window_user.h"

#include "gui/document/camera_looks.h"
#include "gui/document/landmark_files.h"
#include "gui/document/landmark_objects.h"
#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/landmarks/curves_view.h"
#include "gui/landmarks/landmark_marks.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/landmarks/landmarks_model.h"
#include "gui/landmarks/landmarks_panel.h"
#include "gui/landmarks/landmarks_table.h"
#include "gui/landmarks/scan_series.h"
#include "gui/shell/overlay_bars.h"
#include "gui/widgets/save_name.h"
#include "tests/support/patience.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QUrl>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

class TestLandmarksWindow : public QObject, ScanFolder {
    Q_OBJECT

private slots:
    void init()
    {
        begin();
        for (const char *name : {"a.obj", "b.obj"})
            write(QLatin1String(name), kSquare);
    }

    /// Every undo and redo has its own text: none keeps that of an earlier one.
    void theStatusBarTellsEachUndo()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        for (const char *name : {"one", "two"}) {
            landmarks::Landmark landmark;
            landmark.name = name;
            landmark.world = geometry::WorldPoint(1.0, 2.0, 0.0);
            QVERIFY(window->document().sceneLandmarks().place(landmark));
        }
        auto *undo = window->findChild<QAction *>(QStringLiteral("undo"));
        QVERIFY(undo);
        undo->trigger();
        QCOMPARE(window->statusBar()->currentMessage(), QStringLiteral("Undone: Place two."));
        undo->trigger();
        QCOMPARE(window->statusBar()->currentMessage(), QStringLiteral("Undone: Place one."));
        QCOMPARE(window->document().landmarks().size(), std::size_t(0));
        for (QAction *action : window->findChildren<QAction *>()) {
            if (action->shortcut() == QKeySequence(QKeySequence::Redo))
                action->trigger();
        }
        QCOMPARE(window->statusBar()->currentMessage(), QStringLiteral("Redone: Place one."));
        QCOMPARE(window->document().landmarks().size(), std::size_t(1));
    }

    /// A template by the mouse and keys: K skips, X marks as missing, and the last click ends placing.
    void aTemplateIsPlacedToItsEnd()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        SceneDocument &document = window->document();
        SceneLandmarks &list = document.sceneLandmarks();
        write(QStringLiteral("t.csv"), "name,x,y,z\none,,,\ntwo,,,\nthree,,,\nfour,,,\n");
        window->session().openFiles({std::filesystem::path(path(QStringLiteral("a.obj")).toStdU16String())});
        QTRY_COMPARE_WITH_TIMEOUT(document.objects()[0].name, std::string("a.obj"), kPatienceMilliseconds);
        part<LandmarksPanel>(*window).takeTemplate(path(QStringLiteral("t.csv")).toStdU16String());
        fitAll(document);
        document.picks().rayCasters().complete(document.objects());
        QVERIFY(part<LandmarkTool>(*window).isPlacing());
        window->activateWindow(); // keys are for the active one
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        SceneView &view = window->view();
        const auto clickAt = [&](double x) { click(view, localOf(*window, glm::dvec3(x, 5.0, 0.0))); };
        QTest::keyClick(&view, Qt::Key_K);
        QVERIFY(list.all()[0].absence == landmarks::Absence::Skipped && list.nextUnplaced() == 1u);
        QTest::keyClick(&view, Qt::Key_X);
        QVERIFY(list.all()[1].isMissing() && list.nextUnplaced() == 2u);
        clickAt(2.0);
        clickAt(4.0);
        QVERIFY(list.nextUnplaced() == 0u);
        clickAt(6.0);
        QVERIFY(!part<LandmarkTool>(*window).isPlacing()); // a further click reads a coordinate
        clickAt(8.0);
        QCOMPARE(list.all().size(), std::size_t(4));
        QVERIFY(document.picks().pickedPoint());
        document.undoStack().undo(); // of the last landmark: its click is wanted again
        QVERIFY(part<LandmarkTool>(*window).isPlacing());
        clickAt(7.0);
        QVERIFY(!part<LandmarkTool>(*window).isPlacing() && std::abs(list.all()[0].world->x - 7.0) < 0.1);
        // Placing goes on freely if the user wants it.
        actionOf(*window, QStringLiteral("Place Landmarks"))->trigger();
        clickAt(9.0);
        QVERIFY(part<LandmarkTool>(*window).isPlacing());
        QCOMPARE(list.all().size(), std::size_t(5));

        // A right click on a marker opens its menu, elsewhere that of the pixel.
        const auto menuAt = [&](double x) {
            const QPoint at = localOf(*window, glm::dvec3(x, 5.0, 0.0)).toPoint();
            QTest::mouseClick(&view, Qt::RightButton, {}, at);
            auto *menu = qobject_cast<QMenu *>(QApplication::activePopupWidget());
            QString name = menu ? menu->objectName() : QString();
            if (menu)
                menu->close();
            return name;
        };
        list.selectOnly(0);
        QCOMPARE(menuAt(4.0), QStringLiteral("landmarkMenu"));
        QVERIFY(list.selection() == std::vector<std::size_t>{3}); // the one under the pointer
        QCOMPARE(menuAt(5.5), QStringLiteral("viewMenu"));
    }

    void droppedPointsComeToTheTable()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        write(QStringLiteral("p.csv"), "name,x,y,z\nfirst,1,2,0\n");
        emit window->view().filesDropped(
            {QUrl::fromLocalFile(path(QStringLiteral("p.csv"))), QUrl::fromLocalFile(path(QStringLiteral("a.obj")))});
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(1), kPatienceMilliseconds);
        window->workspaces().show(Panel::Landmarks);
        QVERIFY(isSeen(*window, "points"));
        auto *table = window->findChild<LandmarksTable *>();
        QVERIFY(table);
        QCOMPARE(table->model()->rowCount(), 1);
        QVERIFY(actionOf(*window, QStringLiteral("Import Landmarks…")));
        QVERIFY(actionOf(*window, QStringLiteral("Export Landmarks…")));
        write(QStringLiteral("p.csv"), "name,x,y,z\nfirst,1,two,0\n");
        emit window->view().filesDropped({QUrl::fromLocalFile(path(QStringLiteral("p.csv")))});
        QVERIFY2(window->message().contains(QStringLiteral("p.csv:2:")), qPrintable(window->message()));
        QCOMPARE(window->document().landmarks().size(), std::size_t(1));
    }

    void aDroppedTemplateHasItsNamesPlaced()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        write(QStringLiteral("t.PPTPL"), "<!DOCTYPE PickPointsTemplate>\n<PickPointsTemplate>\n"
                                         " <point name=\"tip\" active=\"0\"/>\n <point name=\"chin\" active=\"0\"/>\n"
                                         "</PickPointsTemplate>\n");
        emit window->view().filesDropped({QUrl::fromLocalFile(path(QStringLiteral("t.PPTPL")))});
        const std::vector<landmarks::Landmark> &landmarks = window->document().landmarks();
        QVERIFY2(landmarks.size() == 2, qPrintable(window->message()));
        QVERIFY(landmarks[0].name == "tip" && !landmarks[0].isPlaced() && landmarks[1].name == "chin");
        QCOMPARE(window->document().sceneLandmarks().nextUnplaced(), std::optional<std::size_t>(0));
        QVERIFY(part<LandmarkTool>(*window).isPlacing()); // a template is chosen only for placing
        QVERIFY(!actionOf(*window, QStringLiteral("Next Scan"))->isEnabled());
        QVERIFY(!actionOf(*window, QStringLiteral("Repeats…"))->isEnabled());
        // A model dropped along gets the template's points.
        emit window->view().filesDropped(
            {QUrl::fromLocalFile(path(QStringLiteral("t.PPTPL"))), QUrl::fromLocalFile(path(QStringLiteral("a.obj")))});
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects().size(), std::size_t(1), kPatienceMilliseconds);
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(2), kPatienceMilliseconds);
        write(QStringLiteral("t.PPTPL"), "<PickedPoints/>");
        emit window->view().filesDropped({QUrl::fromLocalFile(path(QStringLiteral("t.PPTPL")))});
        QVERIFY2(window->message().contains(QStringLiteral("t.PPTPL")), qPrintable(window->message()));
    }

    void keysGoThroughASeries()
    {
        std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        QVERIFY(part<ScanSeries>(*window).open(path(QString()).toStdU16String()));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects().size(), std::size_t(1), kPatienceMilliseconds);
        QVERIFY(actionOf(*window, QStringLiteral("Next Scan"))->isEnabled());
        QVERIFY(!actionOf(*window, QStringLiteral("Previous Scan"))->isEnabled());
        landmarks::Landmark landmark;
        landmark.name = "first";
        landmark.world = WorldPoint(1.0, 2.0, 0.0);
        QVERIFY(window->document().sceneLandmarks().place(landmark));
        window->activateWindow(); // keys are for the active one
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        QTest::keyClick(&window->view(), Qt::Key_PageDown, Qt::ControlModifier);
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, std::string("b.obj"), kPatienceMilliseconds);
        QVERIFY(QFile::exists(path(QStringLiteral("a.obj.points.csv"))));
        QCOMPARE(window->document().landmarks().size(), std::size_t(1)); // it waits here
        QVERIFY(!window->document().landmarks()[0].isPlaced());
        QVERIFY(window->document().sceneLandmarks().place(landmark));
        QVERIFY(window->close());
        QVERIFY(QFile::exists(path(QStringLiteral("b.obj.points.csv"))));
    }

    /// What is reported in one moment stands together; the next report replaces it.
    void aScanReportsItsMeshAndItsLandmarks()
    {
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        QVERIFY(QDir(path({})).mkdir(QStringLiteral("scans")));
        write(QStringLiteral("scans/a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 1 1 2\n");
        write(QStringLiteral("scans/a.obj.points.csv"), "name,x,y,z\nfirst,1,two,0\n");
        QVERIFY(window->findChild<ScanSeries *>()->open(path(QStringLiteral("scans")).toStdU16String()));
        QTRY_VERIFY2_WITH_TIMEOUT(window->message().contains(QStringLiteral("Not drawn: 1 triangle"))
                                      && window->message().contains(QStringLiteral("a.obj.points.csv:2:")),
                                  qPrintable(window->message()), kPatienceMilliseconds);
        settle();
        window->showMessage(QStringLiteral("another"));
        QCOMPARE(window->message(), QStringLiteral("another"));
        window->showMessage(QStringLiteral("one more"));
        window->showMessage(QStringLiteral("another")); // said already
        QCOMPARE(window->message(), QStringLiteral("another\none more"));
    }

    void longMessagesAreFolded()
    {
        MessageBar bar;
        QStringList lines;
        for (int i = 0; i < 40; ++i)
            lines << QStringLiteral("line %1").arg(i);
        bar.showMessage(lines.mid(0, 4).join(u'\n'));
        auto *more = bar.findChild<QToolButton *>();
        auto *all = bar.findChild<QPlainTextEdit *>();
        QVERIFY(more->isHidden() && all->isHidden());
        bar.showMessage(lines.join(u'\n'));
        QCOMPARE(bar.findChild<QLabel *>()->text().split(u'\n').size(), 3);
        QCOMPARE(bar.text(), lines.join(u'\n'));
        QVERIFY(more->isVisible() && more->text().contains(QStringLiteral("40")));
        more->click();
        QVERIFY(all->isVisible() && all->toPlainText() == bar.text());
        QVERIFY(bar.sizeHint().height() < 20 * bar.fontMetrics().lineSpacing()); // the view stays in sight
        bar.showMessage(QStringLiteral("another"));
        QVERIFY(all->isHidden() && more->isHidden());
    }

    void whatIsBeingTypedIsKeptWithItsScan()
    {
        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nfirst,1,2,0\nlast,,,\n");
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        QVERIFY(part<ScanSeries>(*window).open(path(QString()).toStdU16String()));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(2), kPatienceMilliseconds);
        window->workspaces().show(Panel::Landmarks);
        auto *table = window->findChild<LandmarksTable *>();
        const auto type = [table](const QString &text) {
            const QModelIndex name = table->model()->index(0, LandmarksModel::Name);
            table->setCurrentIndex(name);
            table->edit(name);
            auto *editor = table->viewport()->findChild<QLineEdit *>();
            QVERIFY(editor);
            editor->setText(text);
        };
        const auto kept = [this] {
            QFile file(path(QStringLiteral("a.obj.points.csv")));
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        type(QStringLiteral("nasion"));
        part<ScanSeries>(*window).next();
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, std::string("b.obj"), kPatienceMilliseconds);
        QVERIFY2(kept().contains("nasion,1,2,0"), kept().constData());
        QVERIFY(!window->document().landmarks()[0].isPlaced());
        part<ScanSeries>(*window).previous();
        QTRY_COMPARE_WITH_TIMEOUT(window->document().objects()[0].name, std::string("a.obj"), kPatienceMilliseconds);
        type(QStringLiteral("bregma"));
        QVERIFY(window->close());
        QVERIFY2(kept().contains("bregma,1,2,0"), kept().constData());
    }

    void theTypedSuffixSelectsTheFormat()
    {
        const QStringList filters{QStringLiteral("Rows (*.csv)"), QStringLiteral("Columns (*.csv)"),
                                  QStringLiteral("Markups (*.mrk.json)"), QStringLiteral("C++ (*.cpp *.h)")};
        QCOMPARE(filterOf(QStringLiteral("a.csv"), filters, 1), std::optional(1)); // the chosen one of two
        QCOMPARE(filterOf(QStringLiteral("a.CSV"), filters, 2), std::optional(0));
        QCOMPARE(filterOf(QStringLiteral("a.mrk.json"), filters, 0), std::optional(2));
        QCOMPARE(filterOf(QStringLiteral("a.json"), filters, 0), std::optional(2));
        QCOMPARE(filterOf(QStringLiteral("a.b.h"), filters, 0), std::optional(3));
        QCOMPARE(filterOf(QStringLiteral("a.txt"), filters, 0), std::optional<int>());
        QCOMPARE(filterOf(QStringLiteral("a"), filters, 0), std::optional<int>());

        write(QStringLiteral("a.obj.points.csv"), "name,x,y,z\nfirst,1,2,0\n");
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 800});
        QVERIFY(window->findChild<ScanSeries *>()->open(path(QString()).toStdU16String()));
        QTRY_VERIFY_WITH_TIMEOUT(!window->session().isLoading(), kPatienceMilliseconds);
        window->workspaces().show(Panel::Series);
        QStringList names{path(QStringLiteral("all.txt")), path(QStringLiteral("all.tps"))}, said, proposed;
        QTimer answers; // the table is still chosen in the dialog
        connect(&answers, &QTimer::timeout, this, [&names, &said, &proposed] {
            QWidget *modal = QApplication::activeModalWidget();
            if (auto *box = qobject_cast<QMessageBox *>(modal)) {
                said << box->text();
                box->button(QMessageBox::Ok)->click();
            } else if (auto *dialog = qobject_cast<QFileDialog *>(modal); dialog && !names.isEmpty()) {
                auto *name = dialog->findChild<QLineEdit *>();
                if (proposed.isEmpty()) {
                    proposed << name->text();
                    emit dialog->filterSelected(dialog->nameFilters()[2]);
                    proposed << name->text();
                }
                name->setText(names.takeFirst());
                QMetaObject::invokeMethod(dialog, "accept");
            }
        });
        answers.start(20);
        const auto buttons = dockOf(*window, "series")->findChildren<QToolButton *>();
        const auto button = std::find_if(buttons.begin(), buttons.end(),
                                         [](QToolButton *each) { return each->text() == QStringLiteral("Export…"); });
        QVERIFY(button != buttons.end());
        (*button)->click();
        answers.stop();
        const QString folder = QFileInfo(path(QStringLiteral("a.obj"))).dir().dirName();
        QCOMPARE(proposed, (QStringList{folder + QStringLiteral(".csv"), folder + QStringLiteral(".tps")}));
        QCOMPARE(said.size(), 1);
        QVERIFY2(said[0].contains(QStringLiteral(".csv, .tps, .nts")), qPrintable(said[0]));
        QVERIFY(!QFile::exists(path(QStringLiteral("all.txt"))));
        QFile table(path(QStringLiteral("all.tps")));
        QVERIFY(table.open(QIODevice::ReadOnly));
        QVERIFY(table.readAll().startsWith("LM3=1"));
    }

    /// The whole workflow by mouse and keys: a scan, a template, three points, one of them dragged and
    /// moved by keys and back, saved, and opened again.
    void fromAScanToASavedSceneAndBack()
    {
        // A hill on a plate, in triangles.
        constexpr int kSide = 24;
        QByteArray scan;
        for (int j = 0; j <= kSide; ++j) {
            for (int i = 0; i <= kSide; ++i)
                scan += QStringLiteral("v %1 %2 %3\n")
                            .arg(i)
                            .arg(j)
                            .arg(4.0 * std::sin(0.13 * i) * std::sin(0.13 * j))
                            .toUtf8();
        }
        for (int j = 0; j < kSide; ++j) {
            for (int i = 0; i < kSide; ++i) {
                const int a = j * (kSide + 1) + i + 1, b = a + kSide + 1;
                scan += QStringLiteral("f %1 %2 %3\nf %1 %3 %4\n").arg(a).arg(a + 1).arg(b + 1).arg(b).toUtf8();
            }
        }
        write(QStringLiteral("hill.obj"), scan);
        write(QStringLiteral("three.csv"), "name,x,y,z,note\nfoot,,,,down there\ntop,,,,\nflank,,,,\n");
        // The answer is typed into the dialog that comes next.
        const auto answer = [this](const QString &file) {
            QTimer::singleShot(0, this, [file] {
                auto *dialog = qobject_cast<QFileDialog *>(QApplication::activeModalWidget());
                QVERIFY(dialog);
                dialog->selectFile(file);
                QMetaObject::invokeMethod(dialog, "accept");
            });
        };
        landmarks::LandmarkSet saved;
        {
            const std::unique_ptr<MainWindow> window = windowOfSize({1280, 900});
            SceneDocument &document = window->document();
            SceneView &view = window->view();
            answer(path(QStringLiteral("hill.obj")));
            actionOf(*window, QStringLiteral("Open…"))->trigger();
            QTRY_COMPARE_WITH_TIMEOUT(document.objects()[0].name, std::string("hill.obj"), kPatienceMilliseconds);
            window->workspaces().show(Panel::Landmarks);
            settle();
            answer(path(QStringLiteral("three.csv")));
            actionOf(*window, QStringLiteral("Load Template…"))->trigger();
            QCOMPARE(document.landmarks().size(), std::size_t(3));
            QCOMPARE(document.sceneLandmarks().nextUnplaced(), std::optional<std::size_t>(0));

            QVERIFY(part<LandmarkTool>(*window).isPlacing());
            fitAll(document);
            document.picks().rayCasters().complete(document.objects());
            for (const glm::dvec3 &place :
                 {glm::dvec3(4.3, 4.6, 1.2), glm::dvec3(12.2, 12.1, 4.0), glm::dvec3(18.4, 7.7, 2.2)})
                click(view, localOf(*window, place));
            for (const landmarks::Landmark &landmark : document.landmarks()) {
                QVERIFY(std::holds_alternative<landmarks::OnTriangle>(landmark.anchor));
                QCOMPARE(landmark.object, std::string("hill.obj"));
                QVERIFY(landmark.uncertainty && length(*landmark.uncertainty) > 0.0);
            }
            QVERIFY(!document.sceneLandmarks().nextUnplaced() && !part<LandmarkTool>(*window).isPlacing());
            actionOf(*window, QStringLiteral("Place Landmarks"))->trigger(); // to move them at once
            const landmarks::LandmarkSet placed = document.scene().landmarks;

            const QPointF top = localOf(*window, placed.landmarks[1].world->coordinates());
            drag(view, top, top + QPointF(40, 25), Qt::LeftButton);
            const landmarks::LandmarkSet dragged = document.scene().landmarks;
            QVERIFY(dragged.landmarks[1] != placed.landmarks[1] && dragged.landmarks[2] == placed.landmarks[2]);
            QVERIFY(std::holds_alternative<landmarks::OnTriangle>(dragged.landmarks[1].anchor));
            for (const Qt::Key key : {Qt::Key_Right, Qt::Key_Right, Qt::Key_Up})
                QTest::keyClick(&view, key);
            QVERIFY(document.landmarks()[1] != dragged.landmarks[1]);
            const auto undo = [&] { actionOf(*window, QStringLiteral("Undo Move top"))->trigger(); };
            QVERIFY(actionOf(*window, QStringLiteral("Undo Move top")));
            undo(); // all the steps of the keys
            QVERIFY(document.scene().landmarks == dragged);
            undo();
            QVERIFY(document.scene().landmarks == placed);
            actionOf(*window, QStringLiteral("Redo Move top"))->trigger();
            QVERIFY(document.scene().landmarks == dragged);

            // A curve by its key, its number of semilandmarks typed, and exported; then all three
            // points a pixel to the right.
            document.sceneLandmarks().select({0, 1});
            QCOMPARE(actionOf(*window, QStringLiteral("Join on the Surface"))->shortcut(), QKeySequence(Qt::Key_J));
            actionOf(*window, QStringLiteral("Join on the Surface"))->trigger();
            QCOMPARE(document.curves().all().size(), std::size_t(1));
            auto *curves = window->findChild<CurvesView *>()->findChild<QTreeWidget *>();
            QVERIFY(curves->isVisible());
            const glm::dvec3 eye = document.scene().camera->eye.coordinates();
            QTest::keyClicks(curves, QStringLiteral("1"));
            auto *number = curves->viewport()->findChild<QLineEdit *>();
            QVERIFY(number);
            QTest::keyClicks(number, QStringLiteral("5"));
            QTest::keyClick(number, Qt::Key_Return);
            QTRY_COMPARE_WITH_TIMEOUT(document.curves().all()[0].count, 15u, kPatienceMilliseconds);
            QVERIFY(document.scene().camera->eye.coordinates() == eye); // no key of the camera
            for (const char *name : {"hill.csv", "hill.pp", "hill.mrk.json", "hill.fcsv", "hill.pts", "hill.tps"}) {
                answer(path(QLatin1String(name)));
                actionOf(*window, QStringLiteral("Export Landmarks…"))->trigger();
                QVERIFY2(QFile::exists(path(QLatin1String(name))), name);
            }
            document.sceneLandmarks().select({0, 1, 2});
            view.setFocus();
            QTest::keyClick(&view, Qt::Key_Right);
            QVERIFY(document.landmarks()[0] != dragged.landmarks[0] && document.landmarks()[2] != dragged.landmarks[2]);
            document.undoStack().undo();
            QVERIFY(document.landmarks() == dragged.landmarks);

            answer(path(QStringLiteral("hill.json")));
            actionOf(*window, QStringLiteral("Save Scene"))->trigger();
            QVERIFY(!document.isModified());
            QVERIFY(QFile::exists(path(QStringLiteral("hill.json"))));
            saved = document.scene().landmarks;
            QVERIFY(window->close());
        }
        const std::unique_ptr<MainWindow> window = windowOfSize({1280, 900});
        window->session().openFiles({std::filesystem::path(path(QStringLiteral("hill.json")).toStdU16String())});
        QTRY_COMPARE_WITH_TIMEOUT(window->document().landmarks().size(), std::size_t(3), kPatienceMilliseconds);
        QVERIFY(window->document().scene().landmarks == saved); // to the last digit
        for (const landmarks::Landmark &landmark : window->document().landmarks()) {
            const auto held = worldOf(landmark.anchor, window->document().objects()[0]);
            QVERIFY(held && length(*held - *landmark.world) < 1e-12); // and where the mesh has it
        }
        const std::vector<LandmarkMark> marks = landmarkMarks(window->document());
        QCOMPARE(marks.size(), std::size_t(3));
    }

private:
};

UNPROJECTOR_TEST(TestLandmarksWindow, display)
#include "test_landmarks_window.moc"
