// Matrices of other programs, pasted into the real dialog, and the window's key for it. The scene
// changes in one step; its file keeps the matrices as given.

#include "tests/gui/pipeline/pasting.h"
#include "tests/gui/window_user.h"
#include "tests/support/test.h"

#include "core/scene_file/scene_file.h"
#include "gui/document/scene_edits.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/widgets/number_grid.h"
#include "gui/window/actions.h"

#include <QMimeData>
#include <QSignalSpy>

#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

using namespace guitest;
using namespace unprojector::scene_file;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::pipeline;

namespace {

glm::dmat4 lens()
{
    return glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0);
}

glm::dmat4 view()
{
    return glm::lookAt(glm::dvec3(3, 2, 5), glm::dvec3(0.0), glm::dvec3(0, 1, 0));
}

QString number(double value)
{
    return QString::number(value, 'g', 17);
}

/// The matrix as NumPy prints it.
QString printed(const glm::dmat4 &m)
{
    QStringList rows;
    for (int i = 0; i < 4; ++i)
        rows << QStringLiteral("[%1  %2  %3  %4]")
                    .arg(number(m[0][i]), number(m[1][i]), number(m[2][i]), number(m[3][i]));
    return QStringLiteral("[%1]").arg(rows.join("\n "));
}

double difference(const glm::dmat4 &a, const glm::dmat4 &b)
{
    double largest = 0.0;
    for (int i = 0; i < 16; ++i)
        largest = std::max(largest, std::abs(a[i / 4][i % 4] - b[i / 4][i % 4]));
    return largest;
}

/// The product of the scene's own camera.
glm::dmat4 shownProduct(const Pasting &pasting)
{
    return *clipFromWorld(pasting.document.setup());
}

/// The document's file, written and read again, without its objects.
SceneFile saved(const SceneDocument &document)
{
    SceneFile file = sceneFileFrom(document.scene(), document.setup(), {});
    file.objects.clear();
    return parseScene(*sceneText(file), "saved").value();
}

} // namespace

/// A box whose protected functions the clipboard and the pointer call.
class OpenBox : public PlainTextBox {
public:
    using PlainTextBox::canInsertFromMimeData;
    using PlainTextBox::insertFromMimeData;
};

class TestPasteMatrices : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theReportSaysWhereEachIsFrom()
    {
        Pasting pasting;
        pasting.paste("projection = " + printed(lens()) + "\nview = " + printed(view())
                      + "\nviewInverse = " + printed(glm::inverse(view())) + "\nviewport: QRect(0,0 300x200)\nfov = 3");
        QVERIFY(pasting.says("“projection”, line 1, read by rows."));
        QVERIFY(pasting.says("“view”, line 5, read by rows."));
        QVERIFY(pasting.says("Not used: fov.") && pasting.says("The viewport, 300 × 200 at (0, 0), is not used"));
        QVERIFY(pasting.says("(3, 2, 5)") && pasting.says("2, 50"));
        QVERIFY(!pasting.named<QComboBox>("Matrix") && pasting.named<QComboBox>("NDC depths"));
        pasting.ok()->click();
        QCOMPARE(pasting.document.scene().projection.matrix()->clipFromEye, lens());
        QCOMPARE(*pasting.document.scene().camera.matrix(), view());
        QVERIFY(difference(shownProduct(pasting), lens() * view()) <= 1e-13);
    }

    void aMatrixAloneIsReadByItsForm()
    {
        Pasting pasting;
        const LookAt camera = pasting.document.setup().camera();
        pasting.paste(printed(lens()));
        QVERIFY(pasting.says("No name tells what it is: its form does."));
        QVERIFY(pasting.says("The text has no view: the scene's view is kept."));
        QCOMPARE(pasting.document.setup().camera(), camera);
        pasting.paste(printed(lens() * view()));
        QVERIFY(pasting.says("Decomposed into projection and view"));
        QVERIFY(difference(shownProduct(pasting), lens() * view()) <= 1e-12);
        pasting.paste(printed(glm::translate(glm::dmat4(1.0), {0, 0, -5})));
        QVERIFY(pasting.says("It has the form of another matrix, too"));
        QVERIFY(pasting.says("The text has no projection: the scene's projection is kept."));
        pasting.choose("Matrix", 2); // projection
        QVERIFY(pasting.says("the scene's view is kept"));
        // It may lead the other way.
        pasting.paste(printed(glm::inverse(view()) * glm::rotate(glm::dmat4(1.0), 3.0, glm::dvec3(0, 1, 0))));
        const auto eye = [&] { return pasting.document.setup().camera().eye.coordinates(); };
        QVERIFY(glm::distance(eye(), {3, 2, 5}) > 1.0);
        QVERIFY(pasting.says("Nothing tells its direction. It is read from world to camera."));
        QVERIFY(pasting.named<QComboBox>("Axes of the camera"));
        QVERIFY(pasting.click("Camera to world"));
        QVERIFY(glm::distance(eye(), {3, 2, 5}) < 1e-12);
        QVERIFY(pasting.says("It is read from camera to world, so this is its inverse."));
    }

    void findingsAreCorrectedByLinks()
    {
        Pasting pasting;
        glm::dmat4 turned = lens();
        turned[1][1] = -turned[1][1];
        pasting.paste("projection = " + printed(turned)
                      + "\nview = " + printed(view() * glm::scale(glm::dmat4(1.0), glm::dvec3(2.0))));
        QVERIFY(pasting.says("It flips y") && pasting.says("It scales by 2"));
        QVERIFY(pasting.click("Flip y") && pasting.click("Remove the Scale"));
        QVERIFY(!pasting.click("Flip y") && !pasting.click("Remove the Scale"));
        QVERIFY(difference(shownProduct(pasting), lens() * view()) <= 1e-12);
        QVERIFY(pasting.click("Undo the corrections"));
        QVERIFY(pasting.says("It flips y") && !pasting.click("Undo the corrections"));
        // Another text has none of them.
        QVERIFY(pasting.click("Flip y"));
        pasting.paste("projection = " + printed(lens()));
        QVERIFY(!pasting.click("Undo the corrections"));
        pasting.paste("view = " + printed(lens()) + "\nprojection = " + printed(view()));
        QVERIFY(pasting.click("Swap Them"));
        QVERIFY(difference(shownProduct(pasting), lens() * view()) <= 1e-13);
    }

    void theOrderIsToldByTheNumbers()
    {
        const glm::dmat4 turn{glm::dmat3(view())};
        Pasting pasting;
        pasting.paste(printed(glm::transpose(view())));
        QVERIFY(pasting.says("It is read in the order, by rows or by columns, that makes 0 0 0 1 its last row."));
        QVERIFY(pasting.click("Read as Row-major") && pasting.says("looks transposed"));
        pasting.paste(printed(glm::transpose(turn)));
        QVERIFY(pasting.says("It is a camera's matrix by rows and by columns"));
        QVERIFY(pasting.click("Read as Column-major") && !pasting.click("Read as Row-major"));
        pasting.ok()->click();
        QVERIFY(difference(*pasting.document.scene().camera.matrix(), turn) <= 1e-12);
    }

    void theDepthsCanBeSaid()
    {
        glm::dmat4 zeroToOne = lens();
        zeroToOne[2][2] = -50.0 / 48.0;
        zeroToOne[3][2] = -100.0 / 48.0;
        Pasting pasting;
        pasting.paste(printed(zeroToOne));
        QVERIFY(pasting.says("seems to use NDC depths from 0 to 1") && pasting.click("Read as 0 to 1"));
        QVERIFY(pasting.says("2, 50"));
        pasting.choose("NDC depths", 1);
        QVERIFY(!pasting.report()->toPlainText().contains("2, 50"));
        pasting.choose("NDC depths", 2);
        pasting.ok()->click();
        QCOMPARE(pasting.document.scene().projection.matrix()->ndcDepth, std::optional(NdcDepth::ZeroToOne));
    }

    void aTextWithoutACameraIsRefused_data()
    {
        addColumn<QString>("text");
        addColumn<QString>("message");
        newRow("words") << "no matrix at all"
                        << "0 numbers found, 16 are needed.";
        newRow("NaN") << "1 0 0 0\n0 nan 0 0\n"
                      << "line 2: \"nan\" is not a finite number.";
        newRow("zeros") << QStringLiteral("0 ").repeated(16) << "No camera yet";
        newRow("a zero view") << "view = " + QStringLiteral("0 ").repeated(16)
                              << "Not a camera: the view matrix is not rotation + translation";
        newRow("a call") << "gluPerspective(45, aspect, 0.1, 100)"
                         << "GluPerspective: the argument 'aspect' is not a number. Put its value there.";
    }

    void aTextWithoutACameraIsRefused()
    {
        QFETCH(QString, text);
        QFETCH(QString, message);
        Pasting pasting;
        pasting.paste(text);
        QVERIFY(pasting.says(message));
        QVERIFY(!pasting.ok()->isEnabled());
        pasting.dialog->accept();
        QVERIFY(pasting.dialog->isVisible());
        QCOMPARE(pasting.document.undoStack().count(), 0);
    }

    void callsAreTaken()
    {
        Pasting pasting;
        pasting.paste("glViewport(10, 20, 300, 200);\nglFrustum(-1, 1, -0.75, 0.75, 2, 50);\n"
                      "gluLookAt(3, 2, 5, 0, 0, 0, 0, 1, 0);");
        QVERIFY(pasting.says("glFrustum: left -1, right 1, bottom -0.75, top 0.75, near 2, far 50."));
        QVERIFY(pasting.says("gluLookAt: eye (3, 2, 5), center (0, 0, 0), up (0, 1, 0)."));
        QVERIFY(pasting.says("The viewport is set by glViewport: 300 × 200 at (10, 20)."));
        QVERIFY(!pasting.named<QComboBox>("NDC depths"));
        pasting.ok()->click();
        QVERIFY(difference(shownProduct(pasting), lens() * view()) <= 1e-13);
        QCOMPARE(pasting.document.setup().viewport, (Viewport{10.0, 20.0, 300.0, 200.0}));
        QCOMPARE(pasting.document.undoStack().count(), 1);
    }

    void aReversedDepthRangeIsUndone()
    {
        Pasting pasting;
        const Setup before = pasting.document.setup();
        // Reversed, with its far plane at infinity, near 2.
        glm::dmat4 reversed = lens();
        reversed[2][2] = 0.0;
        reversed[3][2] = 2.0;
        pasting.paste(printed(reversed) + "\n" + printed(view()));
        QVERIFY(pasting.says("It has reversed depths") && pasting.says("far plane at infinity"));
        pasting.ok()->click();
        SceneDocument &document = pasting.document;
        QCOMPARE(document.setup().depthRange, (DepthRange{1.0, 0.0}));
        // The next one is not reversed: the depth range is as it was.
        QVERIFY(editMatrices(document, MatrixProjection{lens(), std::nullopt}, std::nullopt, {"again"}));
        QCOMPARE(document.setup().depthRange, DepthRange{});
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.setup(), before);
        QVERIFY(!document.scene().projection.matrix() && !document.scene().camera.matrix());
        document.undoStack().redo();
        QCOMPARE(document.scene().projection.matrix()->clipFromEye, reversed);
    }

    void theSameTextGivesTheSameDepths()
    {
        Pasting pasting;
        SceneDocument &document = pasting.document;
        glm::dmat4 reversed = lens();
        reversed[2][2] = 0.0;
        reversed[3][2] = 2.0;
        const auto paste = [&document](const glm::dmat4 &matrix) {
            return editMatrices(document, MatrixProjection{matrix, std::nullopt}, std::nullopt, {"Paste"}).hasValue();
        };
        const auto changeProjection = [&document] {
            const Projection other = Ortho{-1.0, 1.0, -1.0, 1.0, 1.0, 9.0};
            return editProjection(document, {other, false, false}, {"Projection"}).hasValue();
        };
        for (int time = 0; time < 2; ++time) {
            QVERIFY(paste(reversed) && changeProjection());
            QCOMPARE(document.setup().depthRange, (DepthRange{1.0, 0.0}));
        }
        QVERIFY(paste(lens()));
        QCOMPARE(document.setup().depthRange, DepthRange{});
        // A range that was set since stays.
        QVERIFY(paste(reversed) && changeProjection());
        QVERIFY(editViewport(document, document.scene().viewport, {0.25, 0.75}, {"Depth range"}));
        QVERIFY(paste(lens()));
        QCOMPARE(document.setup().depthRange, (DepthRange{0.25, 0.75}));
    }

    void theFileKeepsThemAsGiven()
    {
        Pasting pasting;
        pasting.paste(printed(lens()) + "\n" + printed(view()));
        pasting.ok()->click();
        SceneDocument &document = pasting.document;
        const SceneFile file = saved(document);
        QCOMPARE(std::get<MatrixProjection>(file.projection).clipFromEye, lens());
        QCOMPARE(std::get<glm::dmat4>(file.view), view());
        const auto scene = sceneFromFile(file, {}, {});
        QVERIFY(scene && scene->projection.matrix() && scene->camera.matrix());
        QCOMPARE(*scene->camera.matrix(), view());
        // A turn of the camera gives another view, but keeps the projection; undone, the view is as
        // given again.
        LookAt camera = document.setup().camera();
        camera.eye.x += 1.0;
        setCamera(document, camera);
        QVERIFY(std::holds_alternative<LookAt>(saved(document).view));
        QVERIFY(std::holds_alternative<MatrixProjection>(saved(document).projection));
        document.undoStack().undo();
        QVERIFY(std::holds_alternative<glm::dmat4>(saved(document).view));
    }

    void whatStillHoldsIsSaidInThePipeline()
    {
        SceneDocument document;
        document.setSurface(surfaceFromWidget(400, 300, 1.0));
        openObjects(document, cubeScene());
        PipelinePanel panel(document);
        panel.resize(460, 2000);
        panel.show();
        glm::dmat4 turned = lens();
        turned[1][1] = -turned[1][1];
        QVERIFY(editMatrices(document, MatrixProjection{turned, std::nullopt}, view(), {"Paste Matrices"}));
        const auto button = [&]() -> QPushButton * {
            for (QPushButton *one : panel.findChildren<QPushButton *>()) {
                if (one->text() == "Flip y" && one->isVisible())
                    return one;
            }
            return nullptr;
        };
        QVERIFY(button());
        button()->click();
        QCOMPARE(document.scene().projection.matrix()->clipFromEye, lens());
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Flip y"));
        QVERIFY(!button());
        document.undoStack().undo();
        QVERIFY(button());
    }

    void pastingNothingChangesNothing()
    {
        OpenBox box;
        QMimeData nothing, picture, marked;
        box.insertFromMimeData(&nothing);
        picture.setData(QStringLiteral("image/png"), "x");
        box.insertFromMimeData(&picture);
        QVERIFY(!box.canInsertFromMimeData(&nothing) && !box.canInsertFromMimeData(&picture));
        QCOMPARE(box.toPlainText(), QString());
        marked.setData(QStringLiteral("text/markdown"), "**1**");
        marked.setText(QStringLiteral("**1**"));
        box.insertFromMimeData(&marked);
        QCOMPARE(box.toPlainText(), QStringLiteral("**1**"));
        box.setReadOnly(true);
        box.insertFromMimeData(&marked);
        QCOMPARE(box.toPlainText(), QStringLiteral("**1**"));
    }

    void aTextThatIsTooLongIsRefused()
    {
        Pasting pasting;
        pasting.paste(QStringLiteral("1 2 3"));
        pasting.paste(QStringLiteral("1 ").repeated(500'000) + QStringLiteral("1"));
        QVERIFY(pasting.says(QStringLiteral("The text has 1000001 characters; at most 1000000 can be pasted.")));
        QCOMPARE(pasting.text()->toPlainText(), QStringLiteral("1 2 3"));
        OpenBox box;
        QSignalSpy refused(&box, &PlainTextBox::refused);
        QMimeData four;
        four.setText(QStringLiteral("1234"));
        box.setMost(7);
        box.insertFromMimeData(&four);
        box.insertFromMimeData(&four);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(refused[0][0].toLongLong(), 8);
        QCOMPARE(box.toPlainText(), QStringLiteral("1234"));
        box.selectAll();
        box.insertFromMimeData(&four);
        QCOMPARE(refused.size(), 1);
    }

    /// Everywhere, except in fields and tables that take a paste themselves.
    void theKeyPastesInTheWindow()
    {
        const auto window = windowOfSize({1000, 700});
        const auto dialog = [&] { return window->findChild<PasteCameraDialog *>(); };
        const auto close = [&] {
            delete dialog();
            window->activateWindow();
            if (!QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds))
                qFatal("The window is not active.");
        };
        QClipboard &clipboard = *QGuiApplication::clipboard();
        clipboard.setText(QStringLiteral("no camera"));
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        window->view().setFocus();
        QTest::keySequence(&window->view(), QKeySequence::Paste);
        QVERIFY(dialog() && dialog()->isVisible());
        QCOMPARE(dialog()->findChild<PlainTextBox *>()->toPlainText(), QStringLiteral("no camera"));
        close();
        // The view shows the camera meanwhile, as after OK.
        const QImage before = window->view().grabFramebuffer();
        QImage shown;
        for (const bool isTaken : {false, true}) {
            trigger(*window, kPasteCameraAction);
            dialog()->setText("K = [[500, 0, 159.5], [0, 510, 119.5], [0, 0, 1]]\n"
                              "R = [[1, 0, 0], [0, -1, 0], [0, 0, -1]]\nt = [0, 0, 8]");
            settle();
            shown = isTaken ? shown : window->view().grabFramebuffer();
            if (isTaken)
                dialog()->accept();
            else
                dialog()->reject();
            settle();
            QCOMPARE(window->view().grabFramebuffer() == before, !isTaken);
            QCOMPARE(window->document().undoStack().canUndo(), isTaken);
            close();
        }
        QCOMPARE(window->view().grabFramebuffer(), shown);
        // The action begins with a camera only.
        trigger(*window, kPasteCameraAction);
        QCOMPARE(dialog()->findChild<PlainTextBox *>()->toPlainText(), QString());
        close();
        clipboard.setText(printed(view()));
        trigger(*window, kPasteCameraAction);
        QCOMPARE(dialog()->findChild<PlainTextBox *>()->toPlainText(), printed(view()));
        close();
        clipboard.clear();
        QTest::keySequence(&window->view(), QKeySequence::Paste);
        QVERIFY(!dialog());
        clipboard.setText(QStringLiteral("1 2 3"));
        window->workspaces().enter(Workspace::Pipeline);
        settle();
        for (NumberGrid *grid : window->findChildren<NumberGrid *>()) {
            if (!grid->isVisible())
                continue;
            QKeyEvent event(QEvent::ShortcutOverride, Qt::Key_V, Qt::ControlModifier, "v");
            event.ignore();
            QCoreApplication::sendEvent(grid, &event);
            QCOMPARE(event.isAccepted(), static_cast<const NumberGridModel *>(grid->model())->isTypable());
        }
    }

    void whatIsTypedInAMatrixStaysThere()
    {
        const std::unique_ptr<MainWindow> window = shownWindow(false, {900, 700}, true);
        PipelinePanel panel(window->document(), window.get());
        panel.resize(400, 600);
        panel.show();
        NumberGrid *grid = panel.findChildren<NumberGrid *>().first();
        grid->setFocus();
        grid->setCurrentIndex(grid->model()->index(0, 0));
        for (const Qt::Key key :
             {Qt::Key_V, Qt::Key_E, Qt::Key_S, Qt::Key_M, Qt::Key_F, Qt::Key_P, Qt::Key_5, Qt::Key_Home}) {
            QKeyEvent event(QEvent::ShortcutOverride, key, {},
                            key == Qt::Key_Home ? QString() : QString(QChar(key)).toLower());
            event.ignore();
            QCoreApplication::sendEvent(grid, &event);
            QVERIFY2(event.isAccepted(), qPrintable(QKeySequence(key).toString()));
        }
        // Ctrl makes them commands, as everywhere.
        QKeyEvent command(QEvent::ShortcutOverride, Qt::Key_1, Qt::ControlModifier, "1");
        command.ignore();
        QCoreApplication::sendEvent(grid, &command);
        QVERIFY(!command.isAccepted());
    }
};

UNPROJECTOR_TEST(TestPasteMatrices, display)
#include "test_paste_matrices.moc"
