// The pick in every space, under the view, and its coordinates next to the lines along the axes.

#include "tests/support/test.h"

#include "tests/gui/window_user.h"

#include "core/pipeline/pipeline.h"
#include "gui/click/answer_view.h"
#include "gui/click/comparison_model.h"
#include "gui/click/comparison_panel.h"
#include "gui/click/earlier_picks_view.h"
#include "gui/click/pick_strip.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/lessons/lesson_player.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/text/number_text.h"
#include "gui/view/drop_labels.h"
#include "gui/widgets/whole_table.h"
#include "tests/support/patience.h"

#include "tests/gui/document_edits.h"

#include <QLabel>
#include <QSettings>
#include <QSignalSpy>
#include <QToolBar>
#include <QToolButton>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;

namespace {

QList<QToolButton *> spacesOf(const PickStrip &strip)
{
    return strip.findChildren<QToolButton *>();
}

QStringList textsOf(const PickStrip &strip)
{
    QStringList texts;
    for (const QToolButton *space : spacesOf(strip))
        texts << space->text();
    return texts;
}

/// The numbers of a text like "world\n(1.2, -3, 4)".
std::vector<double> numbersOf(const QString &text)
{
    std::vector<double> numbers;
    for (const QString &number : text.section(u'(', 1).chopped(1).split(QStringLiteral(", ")))
        numbers.push_back(number.toDouble());
    return numbers;
}

void clickMiddle(MainWindow &window)
{
    window.view().onLButtonDown(WidgetPoint(window.view().width() / 2.0, window.view().height() / 2.0));
}

} // namespace

class TestPickStrip : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }
    void init() { QSettings().clear(); }

    void everySpaceHasItsCoordinate()
    {
        const auto window = windowOfSize({1280, 800});
        clickMiddle(*window);
        const unproject::Pick &pick = *window->document().picks().pick();
        QVERIFY(pick.hit());
        const QStringList texts = textsOf(part<PickStrip>(*window));
        QCOMPARE(texts.size(), 7);
        const WorldPoint world = *pick.point.world[unproject::Method::Formula];
        const glm::dvec3 eye = pick.point.eye[unproject::Method::Formula]->coordinates();
        // A wider font leaves room for fewer digits.
        const auto isAt = [&](int space, const std::vector<double> &expected, std::size_t fewestPlaces) {
            const QStringList shown = texts[space].section(u'(', 1).chopped(1).split(QStringLiteral(", "));
            std::size_t most = 0;
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const auto places = std::size_t(shown.value(qsizetype(i)).section(u'.', 1).size());
                most = std::max(most, places);
                if (std::abs(shown.value(qsizetype(i)).toDouble() - expected[i])
                    > 0.5001 * std::pow(10.0, -double(places)))
                    return false;
            }
            return std::size_t(shown.size()) == expected.size() && most >= fewestPlaces;
        };
        QCOMPARE(numbersOf(texts[0]), (std::vector{double(pick.devicePixel.i), double(pick.devicePixel.j)}));
        QVERIFY2(isAt(1, {pick.window.x, pick.window.y, pick.window.z}, 3),
                 qPrintable(texts.join(u' ').replace(u'\n', u' ')));
        const glm::dvec4 clip = *clipFromEye(pick.setup) * glm::dvec4(eye, 1.0);
        QVERIFY(isAt(2, {clip.x / clip.w, clip.y / clip.w, clip.z / clip.w}, 1));
        QVERIFY(isAt(3, {clip.x, clip.y, clip.z, clip.w}, 1));
        QVERIFY(isAt(4, {eye.x, eye.y, eye.z}, 1));
        QVERIFY(isAt(5, {world.x, world.y, world.z}, 1));
        const glm::dmat4 placement = window->document().picks().keptPick().placement.rounded();
        const glm::dvec3 object = glm::dvec3(glm::inverse(placement) * glm::dvec4(world.coordinates(), 1.0));
        QVERIFY(isAt(6, {object.x, object.y, object.z}, 1));
    }

    void theBackgroundHasNoPoint()
    {
        const auto window = windowOfSize({1280, 800});
        window->view().onLButtonDown(WidgetPoint(2, 2));
        QVERIFY(!window->document().picks().pick()->hit());
        const QList<QToolButton *> spaces = spacesOf(part<PickStrip>(*window));
        for (int space = 0; space < 7; ++space)
            QCOMPARE(spaces[space]->isEnabled(), space < 4);
        QVERIFY(spaces[5]->text().endsWith(u'–'));
    }

    /// The near plane is so close that the depth buffer leaves little of the depth certain.
    void noUncertainDigitIsShown()
    {
        const auto window = windowOfSize({1280, 800});
        QVERIFY(window->document().edit({QStringLiteral("Near")},
                                        [](scene::Scene &scene) { scene.clipDistancesFitObjects = false; }));
        setProjection(window->document(), Perspective{radiansFromDegrees(45.0), 1.2, 1e-4, 1e5});
        clickMiddle(*window);
        const unproject::Pick &pick = *window->document().picks().pick();
        QVERIFY(pick.hit());
        const WorldVector uncertainty = pick.uncertainty.world;
        const double least = std::max({uncertainty.x, uncertainty.y, uncertainty.z});
        QVERIFY2(least > 1e-3, qPrintable(QString::number(least))); // else the digits shown would be certain anyway
        const QStringList texts = textsOf(part<PickStrip>(*window));
        for (const int space : {3, 4, 5, 6}) { // the object's scale is 0.8
            const QString number = texts[space].section(u'(', 1).section(u',', 2, 2).trimmed().remove(u')');
            const int decimals = number.contains(u'.') ? int(number.size() - number.indexOf(u'.') - 1) : 0;
            QVERIFY2(std::pow(10.0, -decimals) >= 0.2 * least, qPrintable(texts[space]));
        }
    }

    void thePointHasTheSameDigitsEverywhere_data()
    {
        addColumn<double>("nearDistance");
        addColumn<double>("farDistance");
        newRow("the opening's planes") << 0.0 << 0.0;
        newRow("planes far apart") << 0.001 << 1e5;
    }

    /// The headline, the table, the line below the view, the lines along the axes and the list of
    /// picks: each has the coordinate rounded to a place of its own, and none has a black digit below
    /// the certain place.
    void thePointHasTheSameDigitsEverywhere()
    {
        QFETCH(double, nearDistance);
        QFETCH(double, farDistance);
        const auto window = windowOfSize({1280, 800});
        if (nearDistance > 0.0) {
            QVERIFY(window->document().edit({QStringLiteral("Near")},
                                            [](scene::Scene &scene) { scene.clipDistancesFitObjects = false; }));
            setProjection(window->document(), Perspective{radiansFromDegrees(45.0), 1.2, nearDistance, farDistance});
        }
        const auto lastPlaceOf = [](const QString &number) {
            return number.contains(u'.') ? int(number.indexOf(u'.') - number.size() + 1) : 0;
        };
        const auto numbersIn = [](const QString &text) {
            return text.section(u'(', 1).section(u')', 0, 0).split(QStringLiteral(", "));
        };
        int clicks = 0;
        for (const double share : {0.44, 0.47, 0.5, 0.53, 0.56}) {
            window->view().onLButtonDown(WidgetPoint(window->view().width() * share, window->view().height() * share));
            const unproject::Pick &pick = *window->document().picks().pick();
            if (!pick.hit())
                continue;
            ++clicks;
            const WorldPoint point = *window->document().picks().pickedPoint();
            const std::vector<DropLabel> labels = dropLabels(window->document(), window->view().font(), {});
            ComparisonPanel &panel = part<ComparisonPanel>(*window);
            for (int axis = 0; axis < 3; ++axis) {
                const double uncertainty = pick.uncertainty.world[axis];
                const QModelIndex cell = panel.model().index(axis, ComparisonModel::Formula);
                const QString table = cell.data().toString(),
                              black = table.left(cell.data(ComparisonModel::kCertainLengthRole).toInt());
                const QString headline = numbersIn(part<AnswerView>(*window).text())[axis];
                QCOMPARE(headline, table);
                QVERIFY2(black.isEmpty() || std::pow(10.0, lastPlaceOf(black)) >= uncertainty, qPrintable(black));
                QStringList shown{numbersIn(textsOf(part<PickStrip>(*window))[5])[axis],
                                  numbersIn(part<EarlierPicksView>(*window).table().item(0, 1)->text())[axis]};
                for (const DropLabel &label : labels) {
                    if (label.text.startsWith(QStringLiteral("xyz")[axis]))
                        shown << label.text.mid(2);
                }
                for (const QString &number : shown)
                    QVERIFY2(std::pow(10.0, lastPlaceOf(number)) >= uncertainty, qPrintable(number));
                shown << table;
                for (const QString &number : shown)
                    QCOMPARE(number, fixedText(point[axis], -lastPlaceOf(number)));
                // A black digit of another column is not finer than the distance from the formula's
                // number.
                for (const int column : {ComparisonModel::Matrix, ComparisonModel::MatrixInFloat}) {
                    const QModelIndex other = panel.model().index(axis, column);
                    const QString certain =
                        other.data().toString().left(other.data(ComparisonModel::kCertainLengthRole).toInt());
                    const double off = std::abs(other.data(ComparisonModel::kValueRole).toDouble() - point[axis]);
                    QVERIFY2(certain.isEmpty() || std::pow(10.0, lastPlaceOf(certain)) >= off + uncertainty,
                             qPrintable(certain));
                }
            }
        }
        QVERIFY(clicks >= 3);
    }

    void aNarrowStripRounds()
    {
        const auto window = windowOfSize({1280, 800});
        clickMiddle(*window);
        const PickStrip &strip = part<PickStrip>(*window);
        const qsizetype wide = textsOf(strip)[5].size();
        QVERIFY(resized(*window, {800, 700}));
        clickMiddle(*window);
        QVERIFY(textsOf(strip)[5].size() < wide);
        for (const QToolButton *space : spacesOf(strip))
            QVERIFY2(space->fontMetrics().horizontalAdvance(space->text().section(u'\n', 1)) <= space->width(),
                     qPrintable(space->text()));
    }

    void theViewKeepsItsSizeAtTheFirstPick()
    {
        const auto window = windowOfSize({1280, 800});
        const QSize before = window->view().size();
        clickMiddle(*window);
        settle(20);
        QCOMPARE(window->view().size(), before);
        QVERIFY(!window->document().picks().sinceClick().isAnything());
    }

    void aSpaceOpensItsMatrix()
    {
        const auto window = windowOfSize({1280, 800});
        clickMiddle(*window);
        const QList<QToolButton *> spaces = spacesOf(part<PickStrip>(*window));
        QSignalSpy asked(&part<PickStrip>(*window), &PickStrip::stageRequested);
        spaces[4]->click();
        QVERIFY(window->workspaces().current() == Workspace::Pipeline);
        QCOMPARE(asked[0][0].value<pipeline::PipelineStage>(), pipeline::PipelineStage::ProjectionMatrix);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(*window, "pipeline"), kPatienceMilliseconds);
    }

    void itSaysThatItIsOfTheClick()
    {
        const auto window = windowOfSize({1280, 800});
        clickMiddle(*window);
        const PickStrip &strip = part<PickStrip>(*window);
        const QLabel *label = nullptr;
        for (const QLabel *each : strip.findChildren<QLabel *>()) {
            if (each->text().startsWith(QStringLiteral("at the")))
                label = each;
        }
        QVERIFY(label && !label->isVisible());
        const QStringList texts = textsOf(strip);
        LookAt camera = window->document().setup().camera();
        camera.eye.x += 0.5;
        setCamera(window->document(), camera);
        QVERIFY(label->isVisible());
        QCOMPARE(textsOf(strip).size(), texts.size());
        QCOMPARE(numbersOf(textsOf(strip)[0]), numbersOf(texts[0]));
        QVERIFY(std::abs(numbersOf(textsOf(strip)[4])[0] - numbersOf(texts[4])[0]) < 0.01);
        // A click on a space shows the same numbers in the pipeline.
        spacesOf(strip)[4]->click();
        QVERIFY(part<PipelinePanel>(*window).model().showsClick());
        clickMiddle(*window);
        QVERIFY(!label->isVisible());
        QVERIFY(!part<PipelinePanel>(*window).model().showsClick());
    }

    void itIsHiddenWhereItWouldTellOrTakeRoom()
    {
        const auto window = windowOfSize({1280, 800});
        const PickStrip &strip = part<PickStrip>(*window);
        QVERIFY(strip.isVisible());
        window->workspaces().hidePanels(true);
        QVERIFY(!strip.isVisible());
        window->workspaces().hidePanels(false);
        QVERIFY(strip.isVisible());
        QVERIFY(part<LessonPlayer>(*window).start("rows"));
        QVERIFY(!strip.isVisible());
        window->workspaces().enter(Workspace::Pipeline); // whose kept layout has it
        QVERIFY(!strip.isVisible());
        QVERIFY(part<LessonPlayer>(*window).leave());
        QVERIFY(strip.isVisible());
    }

    void itStaysHiddenAfterARestart()
    {
        {
            const auto window = windowOfSize({1280, 800}, true);
            window->findChild<QToolBar *>(QStringLiteral("strip"))->toggleViewAction()->trigger();
            QVERIFY(!part<PickStrip>(*window).isVisible());
            window->workspaces().enter(Workspace::Doctor);
            QVERIFY(!part<PickStrip>(*window).isVisible());
            window->close();
        }
        const auto window = windowOfSize({1280, 800}, true);
        QVERIFY(!part<PickStrip>(*window).isVisible());
    }

    void theLinesAlongTheAxesHaveTheirCoordinates()
    {
        const auto window = windowOfSize({1280, 800});
        clickMiddle(*window);
        const Picks &picks = window->document().picks();
        QVERIFY(picks.pick()->hit());
        const WorldPoint point = *picks.pickedPoint();
        const std::vector<DropLabel> labels = dropLabels(window->document(), window->view().font(), {});
        QVERIFY(!labels.empty());
        for (const DropLabel &label : labels) {
            const int axis = int(QStringLiteral("xyz").indexOf(label.text[0]));
            QVERIFY(axis >= 0);
            QVERIFY2(std::abs(label.text.mid(2).toDouble() - point[axis]) <= 1e-3, qPrintable(label.text));
            QVERIFY(QRectF(window->view().rect()).contains(label.box)); // not cut at the view's edge
            for (const DropLabel &other : labels)
                QVERIFY(&other == &label || !other.box.intersects(label.box));
        }
        window->view().onLButtonDown(WidgetPoint(2, 2));
        QVERIFY(dropLabels(window->document(), window->view().font(), {}).empty());
    }

    /// Near the model, the lines along the axes leave the view.
    void noCoordinateIsCutAtTheViewsEdge()
    {
        const auto window = windowOfSize({1280, 800});
        LookAt camera = *window->document().scene().camera;
        camera.eye = camera.eye + (camera.center - camera.eye) * 0.7;
        QVERIFY(editCamera(window->document(), camera, {QStringLiteral("test")}));
        const QRectF view(window->view().rect());
        int hits = 0, shown = 0;
        for (int j = 1; j < 10; ++j) {
            for (int i = 1; i < 10; ++i) {
                window->view().onLButtonDown(WidgetPoint(view.width() * i / 10.0, view.height() * j / 10.0));
                hits += window->document().picks().pick()->hit() ? 1 : 0;
                for (const DropLabel &label : dropLabels(window->document(), window->view().font(), {})) {
                    QVERIFY2(view.contains(label.box), qPrintable(label.text));
                    ++shown;
                }
            }
        }
        QVERIFY2(hits > 20 && shown > 2 * hits, qPrintable(QStringLiteral("%1 of %2").arg(shown).arg(hits)));
    }
};

UNPROJECTOR_TEST(TestPickStrip, display)
#include "test_pick_strip.moc"
