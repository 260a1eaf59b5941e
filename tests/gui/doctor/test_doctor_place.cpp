// The workspace Doctor in use: a click, another program's point for it, and the answer.

#include "tests/support/test.h"

#include "tests/gui/doctor/doctor_desk.h"
#include "tests/gui/job_faults.h"

#include "core/doctor/diagnosis.h"
#include "core/doctor/mistakes.h"
#include "core/doctor/report_text.h"
#include "gui/doctor/candidates_table.h"
#include "gui/doctor/code_changes_view.h"
#include "gui/doctor/diagnoser.h"
#include "gui/doctor/diagnosis_view.h"
#include "gui/doctor/space_choice.h"
#include "gui/doctor/wrong_points_form.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_edits.h"
#include "gui/outside/observer_panel.h"
#include "gui/outside/observer_view.h"
#include "gui/text/doctor_text.h"
#include "gui/widgets/segmented_switch.h"
#include "tests/support/patience.h"

#include <QComboBox>
#include <QMenu>
#include <QPushButton>
#include <QSignalSpy>

#include <glm/matrix.hpp>

#include <cmath>
#include <functional>

using namespace unprojector;
using namespace unprojector::gui;
using namespace doctordesk;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

using Happening = std::function<void(MainWindow &)>;

} // namespace

class TestDoctorPlace : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void theMistakeIsNamed()
    {
        const auto window = doctorWindow();
        const glm::dvec3 got = clickedAndWrong(*window);
        const DevicePixel pixel = window->document().picks().pick()->devicePixel;
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text(),
                 QStringLiteral("%1, %2").arg(pixel.i + 0.5).arg(pixel.j + 0.5));
        type(gotOf(*window), pointText(got));
        QTRY_VERIFY2_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QString::fromStdString(doctor::mistakeOf("y-not-flipped").sentence)),
            qPrintable(verdictOf(*window)), kPatienceMilliseconds);
        const QString text = panelOf(*window).answer().text();
        QVERIFY2(text.contains(QStringLiteral("y not flipped: all ")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("Next best")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("the depth is right, the pixel is not")), qPrintable(text));
        QVERIFY2(text.contains(QStringLiteral("To be sure")), qPrintable(text));
        QCOMPARE(panelOf(*window).code().text(),
                 QStringLiteral("- gluUnProject(x, y, d, modelview, projection, viewport, &X, &Y, &Z);\n"
                                "+ gluUnProject(x, H - y, d, modelview, projection, viewport, &X, &Y, &Z);\n"));
        const auto *candidates = panelOf(*window).findChild<CandidatesTable *>();
        QVERIFY(candidates->isVisible() && candidates->rowCount() >= 5);
        const std::vector<WrongPointMark> &marks = window->document().picks().wrongPoints();
        QCOMPARE(marks.size(), std::size_t(1));
        QVERIFY(distance(marks[0].got, WorldPoint(got)) < 1e-4);
        QVERIFY(marks[0].right
                && distance(*marks[0].right, *window->document().picks().pick()->point.world[Method::Formula]) < 1e-4);
    }

    void aRightPointIsRight()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        type(gotOf(*window), pointText(window->document().picks().pick()->point.world[Method::Formula]->coordinates()));
        QTRY_COMPARE_WITH_TIMEOUT(verdictOf(*window), QStringLiteral("The point is right to the digits given."),
                                  kPatienceMilliseconds);
        QVERIFY(!panelOf(*window).code().isVisible());
    }

    void theDepthOfAClickIsItsOwn()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        const double depth = window->document().picks().pick()->window.z;
        const QString shown = QString::number(depth, 'f', 7);
        QVERIFY(shown.toDouble() != depth);
        QLineEdit *field = fieldsOf(*window, QStringLiteral("Depth")).value(0);
        QCOMPARE(field->text(), shown);
        const auto *form = panelOf(*window).findChild<WrongPointsForm *>();
        QCOMPARE(form->points().at(0).depth, std::optional(depth));
        // The typed number stays as typed.
        type(field, QStringLiteral("0.987654"));
        QCOMPARE(form->points().at(0).depth, std::optional(0.987654));
    }

    void garbageIsUnknown()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        type(gotOf(*window), QStringLiteral("11.1234 22.2345 -30.3456"));
        QTRY_VERIFY_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QStringLiteral("Unknown. No known mistake explains this point")),
            kPatienceMilliseconds);
        QVERIFY(panelOf(*window).answer().text().contains(QStringLiteral("Projects to pixel ")));
        QVERIFY(!panelOf(*window).code().isVisible());
        // The digits that the closest candidate explains are black; the count is of these.
        QString markup, black;
        for (const QLabel *label : panelOf(*window).answer().findChildren<QLabel *>())
            markup += label->text();
        static const QRegularExpression bold(QStringLiteral("<b>([^<]*)</b>")),
            count(QStringLiteral("(\\d+) of the 18 digits"));
        for (auto it = bold.globalMatch(markup); it.hasNext();)
            black += it.next().captured(1);
        const QRegularExpressionMatch counted = count.match(markup);
        QVERIFY2(counted.hasMatch(), qPrintable(markup));
        QCOMPARE(black.remove(QRegularExpression(QStringLiteral("\\D"))).size(), counted.captured(1).toInt());
        // The closest candidate has its code as well, once it is chosen.
        auto *candidates = panelOf(*window).findChild<CandidatesTable *>();
        candidates->setCurrentCell(1, 0);
        QVERIFY(panelOf(*window).code().isVisible() && !panelOf(*window).code().text().isEmpty());
    }

    void aPointOfTheSceneIsNamed()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        type(gotOf(*window), pointText(window->document().setup().camera().eye.coordinates()));
        QTRY_VERIFY_WITH_TIMEOUT(verdictOf(*window).startsWith(QStringLiteral("The point given is the eye. Usually")),
                                 kPatienceMilliseconds);
        QVERIFY(!panelOf(*window).code().isVisible());
        QVERIFY(!panelOf(*window).answer().text().contains(QStringLiteral("Chance")));
        const SceneObject &cube = window->document().objects().front();
        const glm::dvec3 vertex = cube.model->meshes.front().position(0) + kCubeCenter;
        type(gotOf(*window), pointText(vertex));
        QTRY_VERIFY_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QStringLiteral("The point given is vertex 0 of \"cube\".")),
            kPatienceMilliseconds);
    }

    void whatCannotBeToldApartIsNamedTogether()
    {
        const auto window = doctorWindow();
        clickedAndWrong(*window);
        typeTransposed(*window);
        QTRY_VERIFY_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QStringLiteral("The product of projection and view is transposed")),
            kPatienceMilliseconds);
        const QString verdict = verdictOf(*window), text = panelOf(*window).answer().text();
        QVERIFY2(verdict.contains(QStringLiteral("\nOr: ")), qPrintable(verdict));
        QVERIFY2(verdict.contains(QStringLiteral("They cannot be separated: every click")), qPrintable(verdict));
        QVERIFY2(text.contains(QStringLiteral("As well ")), qPrintable(text));
    }

    void nonsenseIsNamedAndStays()
    {
        const auto window = doctorWindow();
        const auto fault = [&] { return panelOf(*window).findChild<WrongPointsForm *>()->fault(); };
        clickedAndWrong(*window);
        type(gotOf(*window), QStringLiteral("0.7051 -0.41x2 0.0918"));
        QCOMPARE(gotOf(*window)->text(), QStringLiteral("0.7051 -0.41x2 0.0918"));
        QVERIFY2(fault().contains(QStringLiteral("0.7051 -0.41x2 0.0918")), qPrintable(fault()));
        QVERIFY2(fault().contains(QStringLiteral("\"-0.41x2\" is not a number; give three")), qPrintable(fault()));
        QVERIFY(window->document().picks().wrongPoints().empty());
        type(gotOf(*window), QStringLiteral("nan -0.41 0.0918"));
        QVERIFY2(fault().contains(QStringLiteral("\"nan\" is not a finite number")), qPrintable(fault()));
        type(gotOf(*window), QStringLiteral("0,5 0,25 1,0"));
        QVERIFY2(fault().contains(QStringLiteral("write decimals with a point")), qPrintable(fault()));
        type(gotOf(*window), QStringLiteral("1 2"));
        QVERIFY2(fault().contains(QStringLiteral("it has 2 numbers")), qPrintable(fault()));
        QLineEdit *pixel = fieldsOf(*window, QStringLiteral("Pixel")).value(0);
        type(gotOf(*window), QStringLiteral("1 2 3"));
        type(pixel, QStringLiteral("90000, 5"));
        QVERIFY2(fault().contains(QStringLiteral("90000, 5 lies outside the view of")), qPrintable(fault()));
        type(pixel, QStringLiteral("200, 100"));
        QVERIFY2(fault().isEmpty(), qPrintable(fault()));
        type(fieldsOf(*window, QStringLiteral("Depth")).value(0), QStringLiteral("5.88"));
        QVERIFY2(fault().startsWith(QStringLiteral("The depth 5.88 lies outside the depth range")),
                 qPrintable(fault()));
        type(fieldsOf(*window, QStringLiteral("Depth")).value(0), {});
        // The number counts without Enter too, once the typing pauses.
        window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(window.get(), kPatienceMilliseconds));
        pixel->setFocus();
        pixel->selectAll();
        QTest::keyClicks(pixel, QStringLiteral("abc"));
        QVERIFY2(fault().isEmpty(), qPrintable(fault()));
        QTRY_VERIFY_WITH_TIMEOUT(fault().startsWith(QStringLiteral("“abc” is not a pixel")), kPatienceMilliseconds);
    }

    void pointsAsProgramsPrintThem_data()
    {
        addColumn<QString>("form");
        newRow("blanks") << QStringLiteral("%1 %2 %3");
        newRow("commas") << QStringLiteral("%1, %2, %3");
        newRow("GLM") << QStringLiteral("dvec3(%1, %2, %3)");
        newRow("NumPy") << QStringLiteral("[%1 %2 %3]");
        newRow("named") << QStringLiteral("x=%1 y=%2 z=%3");
        newRow("in brackets") << QStringLiteral("(%1,%2,%3)");
    }

    void pointsAsProgramsPrintThem()
    {
        QFETCH(QString, form);
        const auto window = doctorWindow();
        const glm::dvec3 got = clickedAndWrong(*window);
        QString text = form;
        for (int axis = 0; axis < 3; ++axis)
            text = text.arg(QString::number(got[axis], 'f', 4).replace(u'-', QChar(0x2212)));
        type(gotOf(*window), text);
        QTRY_VERIFY2_WITH_TIMEOUT(verdictOf(*window).startsWith(QStringLiteral("y is not flipped")),
                                  qPrintable(verdictOf(*window)), kPatienceMilliseconds);
    }

    void theCodeIsThatOfTheLibrary()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        CodeChangesView &code = panelOf(*window).code();
        QTRY_VERIFY_WITH_TIMEOUT(code.isVisible(), kPatienceMilliseconds);
        for (const char *library : {"GLU", "GLM", "Qt", "three.js", "NumPy"}) {
            code.setLibrary(QLatin1String(library));
            QCOMPARE(code.library(), QLatin1String(library));
            QVERIFY2(code.text().startsWith(u'-') && code.text().contains(QStringLiteral("\n+ ")), library);
        }
        QVERIFY(code.text().contains(QStringLiteral("y_n = 2 * (H - y - vy) / h - 1")));
        // Two changes are made one after the other.
        const auto saysFirst = [&code] {
            const QList<QLabel *> labels = code.findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
                return label->text().contains(QStringLiteral("first \"x and y swapped\", then \"y not flipped\""));
            });
        };
        QVERIFY(!saysFirst());
        code.setMistake("xy-swapped+y-not-flipped");
        QVERIFY(saysFirst());
    }

    void aSecondClickMakesASecondRow()
    {
        const auto window = doctorWindow();
        click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(-0.5, 0.2, 1.0)));
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 1); // it waited still
        const glm::dvec3 second = clickedAndWrong(*window, {-0.7, 0.3, 1.0});
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 2);
        type(gotOf(*window, 1), pointText(second));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(2),
                                  kPatienceMilliseconds);
        QVERIFY(verdictOf(*window).startsWith(QStringLiteral("y is not flipped")));
        for (QToolButton *button : panelOf(*window).findChildren<QToolButton *>()) {
            if (button->accessibleName() == QStringLiteral("Remove this point")) {
                QTest::mouseClick(button, Qt::LeftButton);
                break;
            }
        }
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
    }

    void aDragIsNoClick()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        const QString pixel = fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text();
        drag(window->view(), {200.0, 200.0}, {260.0, 210.0}, Qt::LeftButton);
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 1);
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text(), pixel);
    }

    void aDragOnTheBackgroundTakesNothingBack()
    {
        const auto window = doctorWindow();
        const QPointF background(12.0, 12.0);
        typeOwnWindow(*window, QStringLiteral("500 x 300"));
        const auto pixel = [&] { return fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text(); };
        click(window->view(), background);
        QVERIFY(window->document().picks().pick() && !window->document().picks().pick()->hit());
        QVERIFY(pixel().isEmpty());
        const QLabel *said = labelOf(*window, QStringLiteral("Setup of the pixels"));
        QVERIFY2(said->text().startsWith(QStringLiteral("Not used: a click on the background")),
                 qPrintable(said->text()));
        click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(0.4, 0.6, 1.0)));
        const QString clicked = pixel();
        QVERIFY(!clicked.isEmpty());
        drag(window->view(), background + QPointF(5.0, 0.0), background + QPointF(60.0, 10.0), Qt::LeftButton);
        QCOMPARE(pixel(), clicked);
        QVERIFY2(!said->text().startsWith(QStringLiteral("Not used")), qPrintable(said->text()));
        // The pixel is still of the view in which it was clicked.
        QVERIFY2(said->text().contains(QStringLiteral("when they were entered")), qPrintable(said->text()));
    }

    /// No usual ratio: only the screen suggests it.
    void aWindowOfOnesOwnHasTheRatioOfTheScreen()
    {
        const auto window = doctorWindow();
        constexpr double kRatio = 2.625;
        Surface surface = window->document().setup().surface;
        surface.devicePixelRatio = kRatio;
        window->document().setSurface(surface);
        typeOwnWindow(*window, QStringLiteral("%1 x %2").arg(surface.widthPixels).arg(surface.heightPixels));
        const double height = surface.heightPixels, depth = 0.9;
        const glm::dvec2 at(300.5, 200.5);
        type(fieldsOf(*window, QStringLiteral("Pixel")).value(0), QStringLiteral("300.5, 200.5"));
        type(fieldsOf(*window, QStringLiteral("Depth")).value(0), QStringLiteral("0.9"));
        type(gotOf(*window), pointText(unprojected(*window, {at.x / kRatio, height - at.y / kRatio, depth})));
        QTRY_VERIFY2_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QString::fromStdString(doctor::mistakeSentence("ratio-logical-in-device"))),
            qPrintable(verdictOf(*window)), kPatienceMilliseconds);
    }

    void withoutAnAnswerTheLastOneGoes_data() { jobfaults::addRows(); }

    void withoutAnAnswerTheLastOneGoes()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        const auto window = doctorWindow();
        const glm::dvec3 wrong = clickedAndWrong(*window);
        type(gotOf(*window), pointText(wrong));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
        {
            const jobfaults::Fault fault(kind);
            type(gotOf(*window), pointText(wrong + 1.0));
            QTRY_COMPARE_WITH_TIMEOUT(
                verdictOf(*window),
                QStringLiteral("The mistakes could not be tried: %1. Close other programs, then try again.")
                    .arg(reason),
                kPatienceMilliseconds);
            QVERIFY(!panelOf(*window).code().isVisible());
            QVERIFY(!panelOf(*window).findChild<CandidatesTable *>()->isVisible());
            QVERIFY(window->document().picks().wrongPoints().empty());
        }
        type(gotOf(*window), pointText(wrong));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
    }

    void theVerdictIsLargeInEveryFont()
    {
        const auto window = doctorWindow();
        QFont font = panelOf(*window).font();
        font.setPixelSize(16); // its size in points is then -1
        panelOf(*window).setFont(font);
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_VERIFY_WITH_TIMEOUT(panelOf(*window).code().isVisible(), kPatienceMilliseconds);
        const QLabel *verdict = labelOf(*window, QStringLiteral("Verdict"));
        QVERIFY(verdict->fontInfo().pixelSize() > 16);
        font.setPixelSize(24);
        panelOf(*window).setFont(font);
        QVERIFY(verdict->fontInfo().pixelSize() > 24);
        gotOf(*window)->selectAll();
        QTest::keyClick(gotOf(*window), Qt::Key_Delete);
        QTRY_COMPARE_WITH_TIMEOUT(verdict->fontInfo().pixelSize(), 24, kPatienceMilliseconds);
    }

    void theClickThatTellsIsPicked()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_VERIFY_WITH_TIMEOUT(panelOf(*window).code().isVisible(), kPatienceMilliseconds);
        QPushButton *there = nullptr;
        for (QPushButton *button : panelOf(*window).answer().findChildren<QPushButton *>()) {
            if (button->text().remove(u'&').startsWith(QStringLiteral("Click there")))
                there = button;
        }
        QTRY_VERIFY_WITH_TIMEOUT(there && there->isVisible(), kPatienceMilliseconds);
        QTest::mouseClick(there, Qt::LeftButton);
        const DevicePixel pixel = window->document().picks().pick()->devicePixel;
        const QString text = QStringLiteral("%1, %2").arg(pixel.i + 0.5).arg(pixel.j + 0.5);
        QVERIFY2(there->text().endsWith(text), qPrintable(there->text()));
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(1)->text(), text);
        QCOMPARE(window->focusWidget(), gotOf(*window, 1)); // whether or not the window is active
    }

    void rowsCanBePasted_data()
    {
        addColumn<bool>("byMenu");
        newRow("by key") << false;
        newRow("by menu") << true;
    }

    void rowsCanBePasted()
    {
        QFETCH(bool, byMenu);
        const auto window = doctorWindow();
        QApplication::clipboard()->setText(QStringLiteral("px,py,depth,x,y,z\n100.5,200.5,0.5,1.2,3.4,5.6\n"
                                                          "200.5,100.5,,\"2.2\",oops,5.6\n300.5,90.5,,7.25,8,9\n"));
        gotOf(*window)->setFocus();
        if (byMenu) {
            QContextMenuEvent asks(QContextMenuEvent::Keyboard, QPoint(5, 5),
                                   gotOf(*window)->mapToGlobal(QPoint(5, 5)));
            QApplication::sendEvent(gotOf(*window), &asks);
            auto *menu = gotOf(*window)->findChild<QMenu *>();
            QVERIFY(menu);
            for (QAction *action : menu->actions()) {
                if (action->isVisible() && action->text().startsWith(QStringLiteral("&Paste")))
                    action->trigger();
            }
            menu->close();
        } else {
            QTest::keySequence(gotOf(*window), QKeySequence::Paste);
        }
        const auto texts = [&](const QString &name) {
            QStringList result;
            for (const QLineEdit *field : fieldsOf(*window, name))
                result << field->text();
            return result;
        };
        QCOMPARE(texts(QStringLiteral("Pixel")), (QStringList{"100.5, 200.5", "300.5, 90.5"}));
        QCOMPARE(texts(QStringLiteral("Depth")), (QStringList{"0.5", ""}));
        QCOMPARE(texts(QStringLiteral("Your program's coordinate")), (QStringList{"1.2 3.4 5.6", "7.25 8 9"}));
        const QString fault = panelOf(*window).findChild<WrongPointsForm *>()->fault();
        QVERIFY2(fault.contains(QStringLiteral("row 3: y")), qPrintable(fault));
    }

    void aHundredPastedRowsAreUsed()
    {
        const auto window = doctorWindow();
        QString rows;
        for (int i = 0; i < 1000; ++i)
            rows += QStringLiteral("%1.5,200.5,0.5,1.2,3.4,5.%2\n").arg(i % 500).arg(i);
        QApplication::clipboard()->setText(rows);
        gotOf(*window)->setFocus();
        auto *form = panelOf(*window).findChild<WrongPointsForm *>();
        QSignalSpy changes(form, &WrongPointsForm::changed);
        QTest::keySequence(gotOf(*window), QKeySequence::Paste);
        QCOMPARE(changes.count(), 1);
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 100);
        QCOMPARE(form->fault(), QStringLiteral("The first 100 points are used; 900 more are ignored."));
    }

    void thePictureStaysThatOfTheClick()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_VERIFY_WITH_TIMEOUT(verdictOf(*window).startsWith(QStringLiteral("y is not flipped")),
                                 kPatienceMilliseconds);
        QPushButton *now = nullptr;
        for (QPushButton *button : panelOf(*window).findChildren<QPushButton *>()) {
            if (button->text().remove(u'&') == QStringLiteral("Use current view"))
                now = button;
        }
        QVERIFY(now && !now->isVisible());
        setCamera(window->document(), {WorldPoint(20, 3, 4), WorldPoint(kCubeCenter), {0, 1, 0}});
        settle(100);
        QVERIFY(verdictOf(*window).startsWith(QStringLiteral("y is not flipped")));
        QVERIFY(now->isVisible());
        QTest::mouseClick(now, Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!verdictOf(*window).startsWith(QStringLiteral("y is not flipped")),
                                 kPatienceMilliseconds);
        QVERIFY(!now->isVisible());
    }

    void theChosenCandidateStaysWhileTheViewTurns()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_VERIFY_WITH_TIMEOUT(panelOf(*window).code().isVisible(), kPatienceMilliseconds);
        auto *candidates = panelOf(*window).findChild<CandidatesTable *>();
        candidates->setCurrentCell(2, 0);
        const QString code = panelOf(*window).code().text();
        const QSignalSpy answers(panelOf(*window).findChild<Diagnoser *>(), &Diagnoser::answered);
        setCamera(window->document(), {WorldPoint(20, 3, 4), WorldPoint(kCubeCenter), {0, 1, 0}});
        settle(100);
        QCOMPARE(answers.size(), 0);
        QCOMPARE(candidates->currentRow(), 2);
        QCOMPARE(panelOf(*window).code().text(), code);
    }

    void aClickMadeBeforeIsTaken_data()
    {
        addColumn<Workspace>("workspace");
        addColumn<Happening>("happening");
        const auto nothing = [](MainWindow &) {};
        const auto orbit = [](MainWindow &window) {
            setCamera(window.document(), {WorldPoint(20, 3, 4), WorldPoint(kCubeCenter), {0, 1, 0}});
        };
        const auto lens = [](MainWindow &window) { setProjection(window.document(), Ortho{-5, 5, -4, 4, 1, 30}); };
        const auto resize = [](MainWindow &window) {
            QVERIFY(resized(window, {1000, 700}));
            settle();
        };
        newRow("Click") << Workspace::Click << Happening(nothing);
        newRow("Click, orbit") << Workspace::Click << Happening(orbit);
        newRow("Click, projection") << Workspace::Click << Happening(lens);
        newRow("Click, window size") << Workspace::Click << Happening(resize);
        newRow("Pipeline, orbit") << Workspace::Pipeline << Happening(orbit);
        newRow("Points") << Workspace::Landmarks << Happening(nothing);
        newRow("Points, orbit") << Workspace::Landmarks << Happening(orbit);
    }

    /// After any change since the click, the form has the click, and the doctor finds the mistake in
    /// the click's setup.
    void aClickMadeBeforeIsTaken()
    {
        QFETCH(Workspace, workspace);
        QFETCH(Happening, happening);
        const auto window = doctorWindow();
        window->workspaces().enter(workspace);
        settle();
        const glm::dvec3 got = clickedAndWrong(*window);
        const Pick pick = *window->document().picks().pick();
        QVERIFY(pick.hit());
        happening(*window);
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(0)->text(),
                 QStringLiteral("%1, %2").arg(pick.devicePixel.i + 0.5).arg(pick.devicePixel.j + 0.5));
        QCOMPARE(fieldsOf(*window, QStringLiteral("Depth")).value(0)->text(), QString::number(pick.window.z, 'f', 7));
        type(gotOf(*window), pointText(got));
        const auto *form = panelOf(*window).findChild<WrongPointsForm *>();
        QCOMPARE(form->points().at(0).depth, std::optional(pick.window.z));
        QTRY_VERIFY2_WITH_TIMEOUT(
            verdictOf(*window).startsWith(QString::fromStdString(doctor::mistakeOf("y-not-flipped").sentence)),
            qPrintable(verdictOf(*window)), kPatienceMilliseconds);
    }

    /// The clicked point gets its pixel in the setup of the points that are there already.
    void aClickMadeElsewhereIsAddedToThePoints()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        const Setup first = window->document().picks().pick()->setup;
        window->workspaces().enter(Workspace::Click);
        setCamera(window->document(),
                  {WorldPoint(kCubeCenter + glm::dvec3(-2.5, 2.0, 6.0)), WorldPoint(kCubeCenter), {0.0, 1.0, 0.0}});
        settle();
        click(window->view(), localOf(*window, kCubeCenter + glm::dvec3(-0.7, 0.3, 1.0)));
        const WorldPoint world = *window->document().picks().pickedPoint();
        window->workspaces().enter(Workspace::Doctor);
        settle();
        const QList<QLineEdit *> pixels = fieldsOf(*window, QStringLiteral("Pixel"));
        QCOMPARE(pixels.size(), 2);
        const DevicePoint at = deviceFromWindow(first.surface, *windowFromWorld(first, world));
        QCOMPARE(pixels[1]->text(), QStringLiteral("%1, %2").arg(std::floor(at.x) + 0.5).arg(std::floor(at.y) + 0.5));
        // Another look takes it no second time.
        window->workspaces().enter(Workspace::Click);
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 2);
    }

    void anEarlierPickTakesNothingBack()
    {
        const auto window = doctorWindow();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        const KeptPick first = window->document().picks().keptPick();
        clickedAndWrong(*window, {-0.7, 0.3, 1.0});
        const QString second = fieldsOf(*window, QStringLiteral("Pixel")).value(1)->text();
        QVERIFY(!second.isEmpty());
        window->workspaces().enter(Workspace::Click);
        window->document().picks().show({});
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).value(1)->text(), second);
        window->workspaces().enter(Workspace::Click);
        window->document().picks().show(first);
        window->workspaces().enter(Workspace::Doctor);
        settle();
        QCOMPARE(fieldsOf(*window, QStringLiteral("Pixel")).size(), 2);
    }

    /// The chosen space stays the object's when it is renamed, and becomes no other one when it is
    /// removed.
    void theSpaceOfAnObjectStays()
    {
        const auto window = doctorWindow();
        SceneDocument &document = window->document();
        clickedAndWrong(*window);
        type(gotOf(*window),
             pointText(document.picks().pick()->point.world[Method::Formula]->coordinates() - kCubeCenter));
        auto *space = panelOf(*window).findChild<SpaceChoice *>();
        const auto choose = [&](int item) {
            space->setCurrentIndex(item);
            emit space->activated(item);
        };
        const auto isRight = [&] {
            return verdictOf(*window) == QStringLiteral("The point is right to the digits given.");
        };
        const std::string name = document.objects()[0].name;
        const QString text = QStringLiteral("Object: ") + QString::fromStdString(name);
        QCOMPARE(space->itemText(2), text);
        choose(2);
        QTRY_VERIFY_WITH_TIMEOUT(isRight(), kPatienceMilliseconds);
        QVERIFY(renameObject(document, 0, QStringLiteral("box")) == NameFault::None);
        QCOMPARE(space->currentText(), QStringLiteral("Object: box"));
        document.undoStack().undo();
        QCOMPARE(space->currentText(), text);

        // Another one before it.
        std::vector<SceneObject> more{document.objects()[0]};
        more[0].name = "other";
        QVERIFY(addObjects(document, more));
        QVERIFY(moveObject(document, 1, 0));
        QCOMPARE(space->currentText(), text);
        QTRY_VERIFY_WITH_TIMEOUT(isRight(), kPatienceMilliseconds);

        QVERIFY(removeObject(document, 1));
        QCOMPARE(space->currentText(), text + QStringLiteral(" (removed)"));
        QTRY_VERIFY2_WITH_TIMEOUT(
            panelOf(*window).answer().text().startsWith(QStringLiteral("The object of this space")),
            qPrintable(panelOf(*window).answer().text()), kPatienceMilliseconds);
        document.undoStack().undo();
        QCOMPARE(space->currentText(), text);
        QTRY_VERIFY_WITH_TIMEOUT(isRight(), kPatienceMilliseconds);

        QVERIFY(removeObject(document, 1));
        choose(0);
        QCOMPARE(space->count(), 3);
        document.undoStack().undo();
        QCOMPARE(space->currentText(), QStringLiteral("World"));
    }

    void theMarksGoWithThePlace()
    {
        const auto window = doctorWindow();
        const QImage before = window->view().grabFramebuffer();
        type(gotOf(*window), pointText(clickedAndWrong(*window)));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
        const WrongPointMark mark = window->document().picks().wrongPoints().front();
        const QImage marked = window->view().grabFramebuffer();
        const glm::dvec2 place = placeOf(*window, mark.got.coordinates());
        const QPoint at(int(place.x), marked.height() - 1 - int(place.y));
        QVERIFY(marked.rect().contains(at));
        QVERIFY(marked.pixelColor(at) != before.pixelColor(at));
        window->workspaces().enter(Workspace::Click);
        QTRY_VERIFY_WITH_TIMEOUT(window->document().picks().wrongPoints().empty(), kPatienceMilliseconds);
        window->workspaces().enter(Workspace::Doctor);
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
    }

    void theWrongPointIsFoundFromOutside()
    {
        const auto window = doctorWindow();
        actionOf(*window, QStringLiteral("View from Outside"))->setChecked(true);
        auto *observer = window->findChild<ObserverPanel *>();
        QVERIFY(observer && QTest::qWaitForWindowExposed(window.get(), kPatienceMilliseconds));
        QTRY_VERIFY_WITH_TIMEOUT(observer->view().isReady(), kPatienceMilliseconds);
        const auto button = [&] {
            const auto buttons = observer->view().findChildren<QPushButton *>();
            return buttons.value(0);
        };
        clickedAndWrong(*window);
        type(gotOf(*window), QStringLiteral("300.1234 222.2345 3000.3456"));
        QTRY_COMPARE_WITH_TIMEOUT(window->document().picks().wrongPoints().size(), std::size_t(1),
                                  kPatienceMilliseconds);
        QTRY_VERIFY_WITH_TIMEOUT(button()->isVisible(), kPatienceMilliseconds);
        QTest::mouseClick(button(), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(!button()->isVisible(), kPatienceMilliseconds);
        const auto place = observer->view().placeOf(window->document().picks().wrongPoints().front().got);
        QVERIFY(place && QRectF(observer->view().rect()).contains(*place));
    }
};

UNPROJECTOR_TEST(TestDoctorPlace, display)
#include "test_doctor_place.moc"
