// The list of the last picks: its clicks, and their changes when objects and scenes change. No
// window.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/told_changes.h"

#include "gui/document/pick_history.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"

#include <QSignalSpy>

using namespace unprojector;
using namespace unprojector::gui;
using namespace documenttest;
using namespace unprojector::geometry;

namespace {

/// A click on an object of the bundled scene.
void click(SceneDocument &document, double x, std::optional<std::size_t> object = 0)
{
    pickAt(document, WidgetPoint(x, 300.0), {object ? 0.5 : 1.0, object, 24});
}

/// "1 2 4", the numbers of the list.
QString numbers(const PickHistory &history)
{
    QStringList numbers;
    for (const EarlierPick &earlier : history.picks())
        numbers << QString::number(earlier.number);
    return numbers.join(u' ');
}

struct Desk {
    Desk() { openScene(document); }
    SceneDocument document;
    PickHistory history{document};
};

} // namespace

class TestPickHistory : public QObject {
    Q_OBJECT

private slots:
    void clicksAreListedInTheirOrder()
    {
        Desk desk;
        QSignalSpy changed(&desk.history, &PickHistory::changed);
        QCOMPARE(desk.history.shownNumber(), 0);
        click(desk.document, 100.0);
        click(desk.document, 200.0, std::nullopt);
        click(desk.document, 300.0, 1);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2 3"));
        QCOMPARE(desk.history.shownNumber(), 3);
        QCOMPARE(changed.count(), 3);
        QCOMPARE(desk.history.picks()[1].kept.pick->devicePixel.i, 200);
        desk.document.picks().clearPick();
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2 3"));
        QCOMPARE(desk.history.shownNumber(), 0);
    }

    void aPickOfBeforeTheListIsInIt()
    {
        SceneDocument document;
        openScene(document);
        click(document, 100.0);
        const PickHistory history(document);
        QCOMPARE(numbers(history), QStringLiteral("1"));
        QCOMPARE(history.shownNumber(), 1);
    }

    /// The press picks; with the drag the pick before comes back, see SceneView.
    void aDragTakesThePickOfItsPressBack()
    {
        Desk desk;
        const auto drag = [&desk](double x) {
            const KeptPick former = desk.document.picks().keptPick();
            click(desk.document, x);
            desk.document.picks().putBack(former);
        };
        drag(100.0);
        QCOMPARE(numbers(desk.history), QString());
        click(desk.document, 200.0);
        click(desk.document, 300.0);
        desk.history.show(1);
        drag(400.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2"));
        QCOMPARE(desk.history.shownNumber(), 1);
        // A press on the pixel of the last pick adds nothing, and takes nothing away.
        desk.history.show(2);
        drag(300.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2"));
        QCOMPARE(desk.history.shownNumber(), 2);
        click(desk.document, 500.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2 3"));
    }

    void theSameClickAgainIsNoOtherPick()
    {
        Desk desk;
        click(desk.document, 100.0);
        click(desk.document, 100.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1"));
        QCOMPARE(desk.history.shownNumber(), 1);
    }

    void theSamePixelInAnotherViewIsAnotherPick()
    {
        Desk desk;
        click(desk.document, 100.0);
        setCamera(desk.document, cameraAt(17.0));
        click(desk.document, 100.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2"));
        QVERIFY(desk.history.picks()[0].kept.pick->setup != desk.history.picks()[1].kept.pick->setup);
    }

    void theListEnds()
    {
        Desk desk;
        for (std::size_t i = 0; i < PickHistory::kMost + 2; ++i)
            click(desk.document, 100.0 + static_cast<double>(i));
        QCOMPARE(desk.history.picks().size(), PickHistory::kMost);
        QCOMPARE(desk.history.picks().front().number, 3);
    }

    void anotherSceneEmptiesTheList()
    {
        Desk desk;
        click(desk.document, 100.0);
        QSignalSpy changed(&desk.history, &PickHistory::changed);
        openScene(desk.document);
        QCOMPARE(numbers(desk.history), QString());
        QCOMPARE(desk.history.shownNumber(), 0);
        QVERIFY(!changed.isEmpty());
        click(desk.document, 100.0);
        QCOMPARE(numbers(desk.history), QStringLiteral("1"));
    }

    void anEarlierPickIsShownAgain()
    {
        Desk desk;
        click(desk.document, 100.0);
        click(desk.document, 200.0, 1);
        desk.history.show(1);
        QCOMPARE(desk.document.picks().pick()->devicePixel.i, 100);
        QCOMPARE(desk.history.shownNumber(), 1);
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2"));
        desk.history.show(7); // there is none
        QCOMPARE(desk.history.shownNumber(), 1);
    }

    void picksGoWithTheirObjects()
    {
        Desk desk;
        click(desk.document, 100.0, 0);
        click(desk.document, 200.0, 1);
        click(desk.document, 300.0, std::nullopt);
        QVERIFY(removeObject(desk.document, 0));
        QCOMPARE(numbers(desk.history), QStringLiteral("2 3"));
        QCOMPARE(*desk.history.picks()[0].kept.pick->object, std::size_t(0));
        desk.history.show(1); // it is not there
        QCOMPARE(desk.history.shownNumber(), 3);
        QVERIFY(removeObject(desk.document, 0));
        QCOMPARE(numbers(desk.history), QStringLiteral("3"));
        desk.document.undoStack().undo();
        desk.document.undoStack().undo();
        QCOMPARE(numbers(desk.history), QStringLiteral("1 2 3"));
        QCOMPARE(*desk.history.picks()[0].kept.pick->object, std::size_t(0));
        QCOMPARE(*desk.history.picks()[1].kept.pick->object, std::size_t(1));
    }

    void picksFollowTheirObjects()
    {
        Desk desk;
        click(desk.document, 100.0, 0);
        click(desk.document, 200.0, 1);
        QSignalSpy changed(&desk.history, &PickHistory::changed);
        QVERIFY(renameObject(desk.document, 0, QStringLiteral("other")) == NameFault::None);
        QVERIFY(!changed.isEmpty());
        QVERIFY(moveObject(desk.document, 0, 1));
        QCOMPARE(*desk.history.picks()[0].kept.pick->object, std::size_t(1));
        QCOMPARE(*desk.history.picks()[1].kept.pick->object, std::size_t(0));
        desk.history.show(1);
        QCOMPARE(desk.document.objects()[*desk.document.picks().pick()->object].name, std::string("other"));
    }

    void thePickKeepsItsAnswerWhileAnotherIsShown()
    {
        Desk desk;
        desk.document.picks().rayCasters().complete(desk.document.objects());
        click(desk.document, 400.0, 0);
        QVERIFY(desk.document.picks().pickedRay()->state == PickedRay::State::Answered);
        click(desk.document, 200.0, std::nullopt);
        QVERIFY(desk.history.picks()[0].kept.ray.state == PickedRay::State::Answered);
    }
};

UNPROJECTOR_TEST(TestPickHistory)
#include "test_pick_history.moc"
