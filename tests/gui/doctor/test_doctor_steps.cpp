// The doctor's panel as a way through three steps: the camera, the click, the printed point, and
// then the answer with its code. The whole task is done by mouse and keys.

#include "tests/support/test.h"

#include "tests/gui/doctor/doctor_desk.h"

#include "core/doctor/diagnosis.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "gui/doctor/candidates_table.h"
#include "gui/doctor/code_changes_view.h"
#include "gui/doctor/diagnosis_view.h"
#include "gui/doctor/wrong_points_form.h"
#include "gui/document/scene_edits.h"
#include "gui/document/session.h"
#include "gui/pipeline/paste_camera_dialog.h"
#include "gui/widgets/segmented_switch.h"
#include "gui/window/feature.h"
#include "tests/support/patience.h"

#include <QDialogButtonBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QSettings>
#include <QSignalSpy>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace doctordesk;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

QPushButton *buttonOf(MainWindow &window, const QString &text)
{
    for (QPushButton *button : panelOf(window).findChildren<QPushButton *>()) {
        if (button->text().remove(u'&').startsWith(text) && button->isVisible())
            return button;
    }
    return nullptr;
}

QLabel *shownLabel(MainWindow &window, const QString &text)
{
    for (QLabel *label : panelOf(window).findChildren<QLabel *>()) {
        if (label->isVisible() && label->text().startsWith(text))
            return label;
    }
    return nullptr;
}

QPoint placeIn(MainWindow &window, const QWidget &widget)
{
    return widget.mapTo(&panelOf(window), QPoint(0, 0));
}

QString cameraOf(MainWindow &window)
{
    return labelOf(window, QStringLiteral("The camera that counts"))->text();
}

/// The point of a click by the formulas, with another far plane than the scene's.
glm::dvec3 withFar(const MainWindow &window, const Pick &pick, double otherFar)
{
    const Setup &setup = const_cast<MainWindow &>(window).document().setup();
    const ProjectionWindow planes = projectionWindow(setup.projection());
    const double n = planes.nearDistance, f = planes.farDistance, d = pick.window.z;
    const double right = n * f / (f - d * (f - n)), wrong = n * otherFar / (otherFar - d * (otherFar - n));
    const glm::dvec3 eye = setup.camera().eye.coordinates();
    const glm::dvec3 point = pick.point.world[Method::Formula]->coordinates();
    return eye + (point - eye) * (wrong / right);
}

} // namespace

class TestDoctorSteps : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theStepsComeInTheirOrder()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_VERIFY_WITH_TIMEOUT(panelOf(*window).code().isVisible(), kPatienceMilliseconds);
        settle(50);
        QLabel *camera = shownLabel(*window, QStringLiteral("1  Your camera"));
        QLabel *click = shownLabel(*window, QStringLiteral("2  Your click"));
        QLabel *printed = shownLabel(*window, QStringLiteral("3  What your program printed"));
        QVERIFY(camera && click && printed);
        const QPoint one = placeIn(*window, *camera), two = placeIn(*window, *click),
                     three = placeIn(*window, *printed);
        QVERIFY(one.y() < two.y() && two.y() == three.y() && two.x() < three.x());
        QPushButton *paste = buttonOf(*window, QStringLiteral("Paste camera…"));
        QVERIFY(paste && placeIn(*window, *paste).y() > one.y() && placeIn(*window, *paste).y() < two.y());
        const int fields = placeIn(*window, *gotOf(*window)).y(),
                  verdict = placeIn(*window, *labelOf(*window, QStringLiteral("Verdict"))).y(),
                  code = placeIn(*window, panelOf(*window).code()).y(),
                  evidence = placeIn(*window, *labelOf(*window, QStringLiteral("Evidence"))).y(),
                  table = placeIn(*window, *panelOf(*window).findChild<CandidatesTable *>()).y();
        QVERIFY(two.y() < fields && fields < verdict && verdict < code && code < evidence && evidence < table);
    }

    void theCameraThatCountsIsNamed()
    {
        const auto window = doctorWindow();
        QVERIFY2(cameraOf(*window).startsWith(QStringLiteral("This scene's camera counts. Perspective, near")),
                 qPrintable(cameraOf(*window)));
        const MatrixProjection lens{glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0), std::nullopt};
        const glm::dmat4 view = glm::lookAt(glm::dvec3(9, 4, 5), kCubeCenter, glm::dvec3(0, 1, 0));
        QVERIFY(editMatrices(window->document(), lens, std::nullopt, {"lens"}));
        QVERIFY2(cameraOf(*window).startsWith(QStringLiteral("The projection that you gave counts")),
                 qPrintable(cameraOf(*window)));
        QVERIFY(editMatrices(window->document(), std::nullopt, view, {"view"}));
        QCOMPARE(cameraOf(*window),
                 QStringLiteral(
                     "The camera that you gave counts: its projection and its view. Perspective, near 2, far 50."));
        window->document().undoStack().undo();
        window->document().undoStack().undo();
        QVERIFY(editMatrices(window->document(), std::nullopt, view, {"view"}));
        QVERIFY2(cameraOf(*window).startsWith(QStringLiteral("The view that you gave counts")),
                 qPrintable(cameraOf(*window)));
    }

    /// The near and far planes are those of the answer, not those of the present view.
    void theCameraOfThePointsIsNamed()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        const QString planes = cameraOf(*window).section(u'.', 1);
        setCamera(window->document(),
                  {WorldPoint(kCubeCenter + glm::dvec3(-2.5, 2.0, 26.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
        settle();
        QCOMPARE(cameraOf(*window), QStringLiteral("The camera with which the points were entered counts.") + planes);
        QTest::mouseClick(buttonOf(*window, QStringLiteral("Use current view")), Qt::LeftButton);
        QVERIFY2(cameraOf(*window).startsWith(QStringLiteral("This scene's camera counts.")),
                 qPrintable(cameraOf(*window)));
        QVERIFY2(!cameraOf(*window).endsWith(planes), qPrintable(planes));
    }

    /// A camera that was given elsewhere counts for a click before it, as one that is given here.
    void aCameraGivenAfterTheClickCounts()
    {
        const auto window = doctorWindow();
        window->workspaces().enter(Workspace::Click);
        clickedAndWrong(*window);
        const MatrixProjection lens{glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0), std::nullopt};
        const glm::dmat4 view = glm::lookAt(glm::dvec3(9, 4, 5), kCubeCenter, glm::dvec3(0, 1, 0));
        QVERIFY(editMatrices(window->document(), lens, view, {"camera"}));
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(cameraOf(*window),
                 QStringLiteral(
                     "The camera that you gave counts: its projection and its view. Perspective, near 2, far 50."));
        QVERIFY(fieldsOf(*window, QStringLiteral("Depth")).value(0)->text().isEmpty()); // it was the former camera's
        // A click made with it keeps its depth.
        window->workspaces().enter(Workspace::Click);
        clickedAndWrong(*window);
        const double depth = window->document().picks().pick()->window.z;
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Depth")).last()->text(), QString::number(depth, 'f', 7));
    }

    /// A click made with a camera that was given elsewhere is used as it was made, whatever the form
    /// had, and whatever the view does afterwards.
    void aClickWithAGivenCameraStays_data()
    {
        addColumn<bool>("hasPoint");
        newRow("first point") << false;
        newRow("another point") << true;
    }

    void aClickWithAGivenCameraStays()
    {
        QFETCH(bool, hasPoint);
        const auto window = doctorWindow();
        if (hasPoint)
            type(gotOf(*window), pointText(clickedAndWrong(*window)));
        window->workspaces().enter(Workspace::Click);
        const MatrixProjection lens{glm::frustum(-0.4, 0.4, -0.3, 0.3, 1.0, 50.0), std::nullopt};
        QVERIFY(editMatrices(window->document(), lens, std::nullopt, {"projection"}));
        clickedAndWrong(*window, {-0.7, 0.3, 1.0});
        const Pick pick = *window->document().picks().pick();
        if (!hasPoint)
            setCamera(window->document(),
                      {WorldPoint(kCubeCenter + glm::dvec3(-2.5, 2.0, 6.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(hasPoint ? 1 : 0)->text(),
                 QStringLiteral("%1, %2").arg(pick.devicePixel.i + 0.5).arg(pick.devicePixel.j + 0.5));
        QCOMPARE(fieldsOf(*window, QStringLiteral("Depth")).value(hasPoint ? 1 : 0)->text(),
                 QString::number(pick.window.z, 'f', 7));
    }

    /// Pastes K, R, t from the Doctor, clicks, types the point of a program that forgets to flip y.
    void theWholeTaskIsDone()
    {
        const auto window = doctorWindow();
        QTest::mouseClick(buttonOf(*window, QStringLiteral("Paste camera…")), Qt::LeftButton);
        auto *dialog = window->findChild<PasteCameraDialog *>();
        QVERIFY(dialog && dialog->isVisible());
        const glm::dmat4 m =
            glm::scale(glm::dmat4(1.0), glm::dvec3(1, -1, -1))
            * glm::lookAt(kCubeCenter + glm::dvec3(1.0, 2.0, 8.0), kCubeCenter, glm::dvec3(0.0, 1.0, 0.0));
        QString text = QStringLiteral("K = [[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]]\nR = [");
        for (int i = 0; i < 3; ++i)
            text += QStringLiteral("[%1, %2, %3]%4")
                        .arg(m[0][i], 0, 'g', 17)
                        .arg(m[1][i], 0, 'g', 17)
                        .arg(m[2][i], 0, 'g', 17)
                        .arg(i < 2 ? QStringLiteral(", ") : QStringLiteral("]\n"));
        text += QStringLiteral("t = [%1, %2, %3]\n")
                    .arg(m[3][0], 0, 'g', 17)
                    .arg(m[3][1], 0, 'g', 17)
                    .arg(m[3][2], 0, 'g', 17);
        auto *field = dialog->findChild<QPlainTextEdit *>();
        field->setFocus();
        QApplication::clipboard()->setText(text);
        QTest::keySequence(field, QKeySequence::Paste);
        QTest::mouseClick(dialog->findChild<QDialogButtonBox *>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QVERIFY(!dialog->isVisible());
        settle();
        QCOMPARE(window->workspaces().current(), Workspace::Doctor);
        QVERIFY2(cameraOf(*window).startsWith(QStringLiteral("The camera that you gave counts")),
                 qPrintable(cameraOf(*window)));
        QVERIFY2(labelOf(*window, QStringLiteral("Setup of the pixels"))->text().contains(QStringLiteral("640 × 480")),
                 qPrintable(labelOf(*window, QStringLiteral("Setup of the pixels"))->text()));
        type(gotOf(*window), pointText(clickedAndWrong(*window, {0.2, 0.4, 1.0})));
        QTRY_VERIFY2_WITH_TIMEOUT(verdictOf(*window).startsWith(QStringLiteral("y is not flipped")),
                                  qPrintable(verdictOf(*window)), kPatienceMilliseconds);
        QVERIFY(panelOf(*window).code().isVisible());
    }

    void depthsOfClicksGoWithTheirCamera()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        QLineEdit *depth = fieldsOf(*window, QStringLiteral("Depth")).value(0);
        const QString pixel = fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text();
        QVERIFY(!depth->text().isEmpty());
        const MatrixProjection lens{glm::frustum(-1.0, 1.0, -0.75, 0.75, 2.0, 50.0), std::nullopt};
        QVERIFY(editMatrices(window->document(), lens, std::nullopt, {"lens"}));
        QVERIFY2(depth->text().isEmpty(), qPrintable(depth->text()));
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text(), pixel);
        QVERIFY(!buttonOf(*window, QStringLiteral("Use current view")));
        // A typed depth stays.
        type(depth, QStringLiteral("0.75"));
        const MatrixProjection other{glm::frustum(-1.0, 1.0, -0.75, 0.75, 3.0, 60.0), std::nullopt};
        QVERIFY(editMatrices(window->document(), other, std::nullopt, {"lens"}));
        QCOMPARE(depth->text(), QStringLiteral("0.75"));
    }

    void clicksGoWithTheirScene()
    {
        const auto window = doctorWindow();
        const auto textOf = [&](const char *name, int row = 0) {
            const QList<QLineEdit *> fields = fieldsOf(*window, QLatin1String(name));
            return row < fields.size() ? fields[row]->text() : QStringLiteral("no row");
        };
        const auto openAnother = [&] {
            openObjects(window->document(), cubeScene(), {WorldPoint(0.0, 0.0, 9.0), WorldPoint(), {0.0, 1.0, 0.0}});
            settle();
        };
        clickedAndWrong(*window);
        QVERIFY(!textOf("Pixel").isEmpty() && !textOf("Depth").isEmpty());
        openAnother();
        QCOMPARE(textOf("Pixel"), QString());
        QCOMPARE(textOf("Depth"), QString());
        // The row goes with what was typed for it; a row that was typed as a whole stays.
        type(fieldsOf(*window, QStringLiteral("Pixel")).value(0), QStringLiteral("3.5, 4.5"));
        type(gotOf(*window), QStringLiteral("1 2 3"));
        clickedAndWrong(*window);
        type(gotOf(*window, 1), QStringLiteral("4 5 6"));
        QTRY_VERIFY_WITH_TIMEOUT(window->document().picks().wrongPoints().size() == 2, kPatienceMilliseconds);
        window->workspaces().enter(Workspace::Pipeline); // hidden panels too
        settle();
        openAnother();
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(textOf("Pixel"), QStringLiteral("3.5, 4.5"));
        QCOMPARE(textOf("Your program's coordinate"), QStringLiteral("1 2 3"));
        QCOMPARE(textOf("Pixel", 1), QStringLiteral("no row"));
        QTRY_VERIFY_WITH_TIMEOUT(window->document().picks().wrongPoints().size() == 1, kPatienceMilliseconds);
    }

    void aLessonGivesTheClicksBack()
    {
        const auto window = doctorWindow();
        Session &session = window->session();
        const auto texts = [&] {
            QStringList all;
            for (const char *name : {"Pixel", "Depth", "Your program's coordinate"}) {
                for (const QLineEdit *field : fieldsOf(*window, QLatin1String(name)))
                    all << field->text();
            }
            return all;
        };
        clickedAndWrong(*window);
        type(gotOf(*window), QStringLiteral("4 5 6"));
        const QStringList before = texts();
        const Scene lesson = window->document().scene();
        QVERIFY(session.openLesson(lesson, QStringLiteral("step"), QStringLiteral("lesson")));
        settle();
        QCOMPARE(texts(), (QStringList{QString(), QString(), QString()}));
        clickedAndWrong(*window, {0.3, 0.2, 1.0});
        QVERIFY(session.openLesson(lesson, QStringLiteral("next step"), QStringLiteral("lesson")));
        QVERIFY(session.comeBack());
        settle();
        QCOMPARE(texts(), before);
        QTRY_VERIFY_WITH_TIMEOUT(window->document().picks().wrongPoints().size() == 1, kPatienceMilliseconds);
    }

    void aClickThatIsTakenBackLeavesAClick()
    {
        WrongPointsForm form;
        form.addClick(DevicePoint(1.5, 2.5), 0.25);
        form.addClick(DevicePoint(3.5, 4.5), 0.5); // into the same row, which waits
        QVERIFY(form.takeBackClick());
        const auto rows = form.takeClickedRows();
        QCOMPARE(rows.size(), std::size_t(1));
        QCOMPARE(rows[0].pixel, QStringLiteral("1.5, 2.5"));
        QVERIFY(form.isEmpty());
        form.putBack(rows);
        QVERIFY(rows[0].clickedDepth == 0.25 && !form.isEmpty());
        QCOMPARE(form.takeClickedRows().size(), std::size_t(1));
    }

    void theSolvedValueIsInSentenceTableAndCode()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        const Pick &pick = *window->document().picks().pick();
        const double sceneFar = projectionWindow(window->document().setup().projection()).farDistance;
        const double otherFar = std::ceil(2.0 * sceneFar / 10.0) * 10.0;
        type(gotOf(*window), pointText(withFar(*window, pick, otherFar)));
        const QString value = QStringLiteral("far is %1").arg(otherFar);
        auto *table = panelOf(*window).findChild<CandidatesTable *>();
        const auto rowWithValue = [&] {
            for (int row = 0; row < table->rowCount(); ++row) {
                if (table->item(row, 0)->text().contains(value))
                    return row;
            }
            return -1;
        };
        QTRY_VERIFY2_WITH_TIMEOUT(rowWithValue() >= 0, qPrintable(panelOf(*window).answer().text()),
                                  kPatienceMilliseconds);
        QVERIFY2(panelOf(*window).answer().text().contains(value), qPrintable(panelOf(*window).answer().text()));
        table->setCurrentCell(rowWithValue(), 0);
        const QString code = panelOf(*window).code().text();
        QVERIFY2(code.contains(QStringLiteral("gluPerspective(fovy, aspect, n, %1)").arg(otherFar)), qPrintable(code));
    }

    /// Far of any number: near, a scale and others explain the point as well.
    void eachCandidateHasOneRow()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        const double sceneFar = projectionWindow(window->document().setup().projection()).farDistance;
        const Pick &pick = *window->document().picks().pick();
        type(gotOf(*window), pointText(withFar(*window, pick, 1.2345678 * sceneFar)));
        const auto text = [&] { return panelOf(*window).answer().text(); };
        QTRY_VERIFY2_WITH_TIMEOUT(text().contains(QStringLiteral("\nAs well ")), qPrintable(text()),
                                  kPatienceMilliseconds);
        static const QRegularExpression row(QStringLiteral("^(?:As well|Next best) (.*?): "),
                                            QRegularExpression::MultilineOption);
        QStringList names;
        for (auto it = row.globalMatch(text()); it.hasNext();)
            names << it.next().captured(1);
        QVERIFY(names.size() > 1);
        QVERIFY2(names.removeDuplicates() == 0, qPrintable(text()));
    }

    void noLibraryWithoutALineIsShown()
    {
        const auto window = doctorWindow();
        CodeChangesView &code = panelOf(*window).code();
        int others = 0;
        for (const doctor::Mistake &mistake : doctor::mistakes()) {
            code.setMistake(mistake.id);
            QVERIFY2(code.text().startsWith(u'-'), mistake.id.c_str());
            others += code.library() != QStringLiteral("GLU");
            QCOMPARE(code.chosenLibrary(), QStringLiteral("GLU"));
        }
        QVERIFY(others > 0);
    }

    void theUsersLibraryIsRemembered()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        CodeChangesView &code = panelOf(*window).code();
        QTRY_VERIFY_WITH_TIMEOUT(code.isVisible(), kPatienceMilliseconds);
        const auto choose = [&code](const QString &library) {
            for (QToolButton *segment : code.findChildren<QToolButton *>()) {
                if (segment->text() == library)
                    QTest::mouseClick(segment, Qt::LeftButton);
            }
        };
        choose(QStringLiteral("GLM"));
        choose(QStringLiteral("GLU"));
        const std::vector<doctor::Mistake> &all = doctor::mistakes();
        QVERIFY(std::any_of(all.begin(), all.end(), [&code](const doctor::Mistake &mistake) {
            code.setMistake(mistake.id);
            return code.library() != QStringLiteral("GLU");
        }));
        QCOMPARE(code.chosenLibrary(), QStringLiteral("GLU"));
        code.setMistake("y-not-flipped");
        QCOMPARE(code.library(), QStringLiteral("GLU"));
        choose(QStringLiteral("NumPy"));
        QCOMPARE(code.library(), QStringLiteral("NumPy"));
        // The next start of the program.
        QSettings settings;
        const auto featureOf = [](MainWindow &of) {
            const QList<Feature *> features = of.findChildren<Feature *>();
            return *std::find_if(features.begin(), features.end(), [](const Feature *feature) {
                return QLatin1String(feature->metaObject()->className()).contains(QLatin1String("DoctorFeature"));
            });
        };
        featureOf(*window)->keep(settings);
        const auto next = doctorWindow();
        QCOMPARE(panelOf(*next).code().chosenLibrary(), QStringLiteral("GLU"));
        featureOf(*next)->restore(settings);
        QCOMPARE(panelOf(*next).code().chosenLibrary(), QStringLiteral("NumPy"));
    }

    void severalExplanationsAskForAClick()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        typeTransposed(*window);
        QTRY_VERIFY_WITH_TIMEOUT(verdictOf(*window).contains(QStringLiteral("\nOr: ")), kPatienceMilliseconds);
        // They give the same point at every click, so none tells them apart.
        QVERIFY(!buttonOf(*window, QStringLiteral("Click there to tell them apart")));
        QVERIFY(buttonOf(*window, QStringLiteral("Click there to rule out the next best")));
    }
};

UNPROJECTOR_TEST(TestDoctorSteps, display)
#include "test_doctor_steps.moc"
