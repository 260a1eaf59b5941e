// A lesson's links in the window: each link of each step leads somewhere, and does what it says.

#include "tests/support/test.h"

#include "core/lessons/lesson.h"
#include "gui/document/picks.h"
#include "gui/lessons/lesson_player.h"
#include "gui/pipeline/factor_shares.h"
#include "gui/pipeline/factors_view.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/formula_markup.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/lessons/lessons_user.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QSignalSpy>
#include <QSlider>
#include <QTemporaryDir>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;

namespace {

QSet<QString> anchorsOfHelp()
{
    QFile file(QStringLiteral(":/help/formulas.html"));
    QSet<QString> names;
    static const QRegularExpression name(QStringLiteral("<a name=['\"]([^'\"]+)['\"]"));
    const QString page = file.open(QIODevice::ReadOnly) ? typeset(QString::fromUtf8(file.readAll())) : QString();
    for (auto matches = name.globalMatch(page); matches.hasNext();)
        names.insert(matches.next().captured(1));
    return names;
}

/// The links of a text.
QStringList linksOf(const std::vector<std::string> &paragraphs)
{
    static const QRegularExpression link(QStringLiteral("<a href='([^']*)'>"));
    QStringList links;
    for (const std::string &paragraph : paragraphs) {
        for (auto it = link.globalMatch(QString::fromStdString(paragraph)); it.hasNext();)
            links << it.next().captured(1);
    }
    return links;
}

} // namespace

class TestLessonsLinks : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void everyStepOpensAndItsLinksLead_data()
    {
        addColumn<QByteArray>("name");
        const auto window = windowOfSize(kWide);
        for (const Lesson &lesson : part<LessonPlayer>(*window).lessons())
            newRow(lesson.name.c_str()) << QByteArray::fromStdString(lesson.name);
    }

    void everyStepOpensAndItsLinksLead()
    {
        QFETCH(QByteArray, name);
        static const QSet<QString> formulas = anchorsOfHelp();
        const auto window = windowOfSize(kWide);
        LessonPlayer &player = part<LessonPlayer>(*window);
        QVERIFY(dockOf(*window, "lesson")->isHidden());
        QVERIFY(player.start(name.toStdString()));
        for (std::size_t index = 0; index < player.lesson()->steps.size(); ++index) {
            QVERIFY(player.goTo(index));
            const lessons::Step &step = player.step();
            QVERIFY(isSeen(*window, "lesson"));
            QVERIFY(!step.workspace || *step.workspace == window->workspaces().current());
            QVERIFY(player.isAsTheStep());
            QVERIFY(!step.question || player.asked());
            QVERIFY2(panelOf(*window).sizeHint().width() <= 360, step.id.c_str());
            QVERIFY(!panelOf(*window).text().contains(u'{'));
            if (step.view) {
                follow(*window, QStringLiteral("view:%1x%2").arg(step.view->x).arg(step.view->y));
                QTRY_VERIFY2_WITH_TIMEOUT(player.hasViewOfStep(), step.id.c_str(), kPatienceMilliseconds);
            }
            for (const bool isAnswered : {false, true}) {
                if (isAnswered && !step.question)
                    break;
                if (isAnswered) {
                    // No panel shows the answer before, in any state.
                    for (const Panel panel : step.question->hides)
                        QVERIFY2(isCovered(*window, nameOf(panel)), step.id.c_str());
                    player.reveal();
                    if (step.view)
                        QTRY_VERIFY2_WITH_TIMEOUT(player.hasViewOfStep(), step.id.c_str(), kPatienceMilliseconds);
                    for (const Panel panel : step.panels)
                        QVERIFY2(!window->workspaces().dock(panel).isHidden(), step.id.c_str());
                }
                for (const QString &link : linksOf(isAnswered ? step.question->reveal : step.text)) {
                    const QByteArray where = (QString::fromStdString(step.id) + u' ' + link).toUtf8();
                    const QString to = link.section(u':', 1);
                    if (link.startsWith(QLatin1String("click:"))) {
                        window->document().picks().clearPick();
                        follow(*window, link);
                        QVERIFY2(window->document().picks().pick() && window->document().picks().pick()->hit(), where);
                    } else if (link.startsWith(QLatin1String("panel:"))) {
                        follow(*window, link);
                        QVERIFY2(!dockOf(*window, to.toLatin1())->isHidden(), where);
                        QVERIFY2(!isAnswered || !isCovered(*window, to.toLatin1()), where); // the answer speaks of it
                    } else if (link.startsWith(QLatin1String("set:"))) {
                        const int steps = window->document().undoStack().count();
                        follow(*window, link);
                        QVERIFY2(window->document().undoStack().count() == steps + 1, where);
                        window->document().undoStack().undo();
                    } else if (link == QLatin1String("apart:view")) {
                        follow(*window, link);
                        QVERIFY2(dockOf(*window, "pipeline")->findChild<FactorsView *>()->isVisible(), where);
                    } else if (link.startsWith(QLatin1String("action:"))) {
                        const QList<QAction *> actions = window->findChildren<QAction *>(to.section(u':', 0, 0));
                        QVERIFY2(actions.size() == 1, where);
                        const QSignalSpy triggers(actions.front(), &QAction::triggered);
                        follow(*window, link);
                        QVERIFY2(actions.front()->isCheckable() ? actions.front()->isChecked() != to.endsWith(u":off")
                                                                : triggers.size() == 1,
                                 where);
                    } else if (link.startsWith(QLatin1String("apart:"))) {
                        follow(*window, link);
                        const FactorShares *shares = dockOf(*window, "pipeline")->findChildren<FactorShares *>().back();
                        QVERIFY2(shares->isVisible(), where);
                        for (const QSlider *slider : shares->findChildren<QSlider *>())
                            QTRY_VERIFY2_WITH_TIMEOUT(!slider->isVisible() || !slider->visibleRegion().isEmpty(), where,
                                                      kPatienceMilliseconds);
                    } else if (link.startsWith(QLatin1String("formulas:"))) {
                        QVERIFY2(formulas.contains(to), where);
                    }
                }
            }
            QVERIFY2(window->message().isEmpty(), qPrintable(window->message()));
        }
    }

    void whatLinksSwitchGoesBack()
    {
        const auto window = windowOfSize(kWide);
        const auto isOn = [&](const char *name) {
            return window->findChild<QAction *>(QLatin1String(name))->isChecked();
        };
        const auto *pipeline = window->findChild<PipelinePanel *>();
        window->findChild<QAction *>(QStringLiteral("edge"))->trigger();
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        for (const char *name : {"vertex", "place_points", "backward", "rows"})
            follow(*window, QStringLiteral("action:") + QLatin1String(name));
        QVERIFY(isOn("vertex") && isOn("place_points") && window->document().picks().snap() == ray::Snap::Vertex);
        QVERIFY(pipeline->direction() == PipelineDirection::Backward && isSeen(*window, "pipeline"));
        follow(*window, QStringLiteral("action:place_points")); // which it is
        QVERIFY(isOn("place_points"));
        follow(*window, QStringLiteral("action:place_points:off"));
        QVERIFY(!isOn("place_points"));
        follow(*window, QStringLiteral("action:place_points"));
        follow(*window, QStringLiteral("action:nothing")); // an unknown action does nothing
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(isOn("edge") && !isOn("place_points") && window->document().picks().snap() == ray::Snap::Edge);
        QVERIFY(pipeline->direction() == PipelineDirection::Forward && pipeline->matrixView() == MatrixView());
    }

    /// The previous vector layout comes back with the previous conventions, even if its panel is
    /// hidden.
    void theWayToWriteVectorsGoesBackUnseen()
    {
        const auto window = windowOfSize(kWide);
        auto *pipeline = window->findChild<PipelinePanel *>();
        const MatrixView rows{MatrixLayout::Row, false};
        pipeline->setMatrixView(rows);
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        follow(*window, QStringLiteral("action:columns"));
        QVERIFY(pipeline->matrixView().layout == MatrixLayout::Column);
        follow(*window, QStringLiteral("action:conventions_direct3d"));
        QVERIFY(window->document().scene().conventions == Api::Direct3d && isSeen(*window, "pipeline"));
        dockOf(*window, "pipeline")->hide();
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(window->document().scene().conventions == Api::OpenGl);
        window->workspaces().show(Panel::Pipeline);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "pipeline"), kPatienceMilliseconds);
        QVERIFY(pipeline->matrixView() == rows);
    }

    /// The vector layout belongs to the scene's conventions: a lesson in others leaves it alone.
    void theWayToWriteVectorsIsOfTheConventions()
    {
        const auto window = windowOfSize(kWide);
        const auto *pipeline = window->findChild<PipelinePanel *>();
        QVERIFY(editConventions(window->document(), Api::Direct3d, {QStringLiteral("Direct3D")}));
        const MatrixLayout rows = pipeline->matrixView().layout;
        QVERIFY(rows == MatrixLayout::Row);
        LessonPlayer &lessons = part<LessonPlayer>(*window);
        QVERIFY(lessons.start("first"));
        QVERIFY(pipeline->matrixView().layout == MatrixLayout::Column);
        QVERIFY(lessons.start("pipeline") && lessons.leave());
        QVERIFY(window->document().scene().conventions == Api::Direct3d);
        QVERIFY(pipeline->matrixView().layout == rows);
        // A scene that is opened in the middle of a lesson has its own.
        const QTemporaryDir folder;
        const std::filesystem::path file(folder.filePath(QStringLiteral("rows.json")).toStdU16String());
        QVERIFY(window->session().saveScene(file));
        window->session().openBundledScene();
        QVERIFY(pipeline->matrixView().layout == MatrixLayout::Column);
        QVERIFY(lessons.start("first"));
        window->session().openFiles({file});
        QTRY_VERIFY_WITH_TIMEOUT(!lessons.lesson(), kPatienceMilliseconds);
        QVERIFY(window->document().scene().conventions == Api::Direct3d);
        QVERIFY(pipeline->matrixView().layout == rows);
    }

    void whatALinkLeadsToHasRoom()
    {
        const auto window = windowOfSize(kWide);
        QVERIFY(part<LessonPlayer>(*window).start("pipeline"));
        follow(*window, QStringLiteral("step:ortho"));
        const QDockWidget *pipeline = dockOf(*window, "pipeline"), *observer = dockOf(*window, "observer");
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "observer") && observer->height() > window->height() / 3,
                                 kPatienceMilliseconds);
        follow(*window, QStringLiteral("action:open_projection"));
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "pipeline") && pipeline->height() > observer->height() * 4 / 3,
                                 kPatienceMilliseconds);
    }

    void aLinkChangesTheScene()
    {
        const auto window = windowOfSize(kWide);
        SceneDocument &document = window->document();
        QVERIFY(part<LessonPlayer>(*window).start("pipeline") && part<LessonPlayer>(*window).next());
        const std::optional<GivenPoint> followed = document.scene().givenPoint;
        QVERIFY(followed);
        follow(*window, QStringLiteral("set:other"));
        QVERIFY(document.scene().givenPoint == (GivenPoint{ObjectPoint(2, 1, 0), followed->object}));
        QCOMPARE(document.undoStack().count(), 1); // one change for the whole link
        QVERIFY(part<LessonPlayer>(*window).isAsTheStep());
        // The link leads from a followed click back to the point, which is already the same.
        const PipelineModel &model = dockOf(*window, "pipeline")->findChild<PipelinePanel *>()->model();
        QVERIFY(model.followsGiven());
        follow(*window, QStringLiteral("click:point"));
        QVERIFY(window->document().picks().pick() && !model.followsGiven());
        follow(*window, QStringLiteral("set:other"));
        QVERIFY(model.followsGiven());
        // A point typed in another space, or removed, does not change the link's effect.
        for (const std::optional<GivenPoint> &typed : {std::optional<GivenPoint>{{ClipPoint(1, 2, 3, 4)}}, {}}) {
            QVERIFY(editGivenPoint(document, typed, {QStringLiteral("Typed")}));
            follow(*window, QStringLiteral("set:other"));
            QVERIFY(document.scene().givenPoint == (GivenPoint{ObjectPoint(2, 1, 0), followed->object}));
        }
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QVERIFY(document.scene().givenPoint == followed);
        follow(*window, QStringLiteral("set:none")); // a change unknown to the step does nothing
        QVERIFY(document.scene().givenPoint == followed);
        QVERIFY(window->message().isEmpty());
    }

    void aChangeThatDoesNotFitIsTold()
    {
        const auto window = windowOfSize(kWide);
        SceneDocument &document = window->document();
        QVERIFY(part<LessonPlayer>(*window).start("derivation"));
        QVERIFY(part<LessonPlayer>(*window).goTo(part<LessonPlayer>(*window).lesson()->steps.size() - 1));
        // This projection has no left and right to exchange.
        QVERIFY(editProjection(document, {Perspective{1.0, 1.0, 1.0, 10.0}, false, false}, {QStringLiteral("Other")}));
        const int steps = document.undoStack().count();
        follow(*window, QStringLiteral("set:exchanged"));
        QCOMPARE(document.undoStack().count(), steps);
        QVERIFY2(window->message().startsWith(QStringLiteral("The change does not fit the current scene.")),
                 qPrintable(window->message()));
    }
};

UNPROJECTOR_TEST(TestLessonsLinks, display)
#include "test_lessons_links.moc"
