// Numbers typed and refused, or not finished, while the scene changes: other objects, another
// scene, a panel that is hidden meanwhile.

#include "tests/support/test.h"

#include "gui/document/scene_edits.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/parameters/panel_user.h"

#include <QComboBox>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

class TestParametersTyping : public QObject, PanelUser {
    Q_OBJECT

private slots:
    void init() { start(); }

    void aRefusedNumberGoesWithItsObject_data()
    {
        addColumn<bool>("isHidden");
        addColumn<int>("removed");
        newRow("on the screen") << false << 1;
        newRow("in a hidden panel") << true << 1;
        newRow("the one before it, in a hidden panel") << true << 0;
    }

    void aRefusedNumberGoesWithItsObject()
    {
        QFETCH(bool, isHidden);
        QFETCH(int, removed);
        QVERIFY(refusedScale()->isBad());
        m_panel->setHidden(isHidden);
        QVERIFY(removeObject(*m_document, static_cast<std::size_t>(removed)));
        const Scene before = scene();
        m_panel->applyTyped(); // as Save does
        QVERIFY(isSameScene(scene(), before));
        m_panel->show();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        NumberField *left = field(QStringLiteral("number0"), QStringLiteral("step1"));
        QCOMPARE(left->text(), QStringLiteral("2"));
        QVERIFY(!left->isBad());
    }

    void aRefusedNumberGoesWithItsPlane()
    {
        Scene prepared = startScene();
        cut(prepared);
        open(prepared);
        showGroup(QStringLiteral("clipGroup"));
        NumberField *plane = field(QStringLiteral("number0"), QStringLiteral("plane1"));
        type(plane, QStringLiteral("0")); // its normal would have no length
        QVERIFY(plane->isBad());
        begin(field(QStringLiteral("number3"), QStringLiteral("plane1")), QStringLiteral("4"));
        m_panel->hide();
        QVERIFY(editClipPlanes(*m_document, {}, {}, {QStringLiteral("by another")}));
        m_panel->applyTyped();
        QVERIFY(scene().clipPlanes.empty());
    }

    void aRefusedNumberIsNotMeantForAnotherScene_data() { addPlaces(); }

    void aRefusedNumberIsNotMeantForAnotherScene()
    {
        QFETCH(bool, isHidden);
        QFETCH(bool, isFolded);
        NumberField *nearField = field(QStringLiteral("nearDistance"));
        type(nearField, QStringLiteral("200"));
        QVERIFY(nearField->isBad());
        m_panel->setHidden(isHidden);
        showGroup(QStringLiteral("projectionGroup"))->setOpen(!isFolded);
        Scene other = startScene();
        Frustum frustum = frustumOf(other);
        frustum.farDistance = 1000.0; // 200 would be good there
        other.projection = frustum;
        open(other);
        m_panel->applyTyped();
        QCOMPARE(frustumOf(scene()).nearDistance, 1.0);
        m_panel->show();
        showGroup(QStringLiteral("projectionGroup"));
        QCOMPARE(nearField->text(), QStringLiteral("1"));
        QVERIFY(!nearField->isBad());
    }

    void aNumberCountsThoughItsGroupIsNotSeen_data() { addPlaces(); }

    void aNumberCountsThoughItsGroupIsNotSeen()
    {
        QFETCH(bool, isHidden);
        QFETCH(bool, isFolded);
        begin(field(QStringLiteral("nearDistance")), QStringLiteral("20"));
        NumberField *farField = field(QStringLiteral("farDistance"));
        farField->setText(QStringLiteral("300")); // without the focus, so that nothing but applyTyped finishes it
        m_panel->setHidden(isHidden);
        showGroup(QStringLiteral("projectionGroup"))->setOpen(!isFolded);
        m_panel->applyTyped();
        QCOMPARE(frustumOf(scene()).nearDistance, 20.0);
        QCOMPARE(frustumOf(scene()).farDistance, 300.0);
    }

    void theShownObjectStaysShown_data()
    {
        addColumn<bool>("isHidden");
        newRow("on the screen") << false;
        newRow("in a hidden panel") << true;
    }

    /// The shown object stays shown through any change of the list.
    void theShownObjectStaysShown()
    {
        QFETCH(bool, isHidden);
        showGroup(QStringLiteral("modelGroup"));
        choose(QStringLiteral("object"), QStringLiteral("second"));
        const auto *box = m_panel->findChild<QComboBox *>(QStringLiteral("object"));
        const auto shows = [&](const char *name, int place) {
            m_panel->show();
            QCoreApplication::processEvents();
            const bool is = box->currentText() == QLatin1String(name) && box->currentIndex() == place;
            m_panel->setHidden(isHidden);
            return is;
        };
        m_panel->setHidden(isHidden);
        QVERIFY(editTransform(*m_document, 1, {Translate{{1.0, 2.0, 3.0}}}, {QStringLiteral("by another")}));
        QCOMPARE(renameObject(*m_document, 1, QStringLiteral("renamed")), NameFault::None);
        QVERIFY(shows("renamed", 1));
        QVERIFY(moveObject(*m_document, 1, 0));
        QVERIFY(shows("renamed", 0));
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QVERIFY(shows("second", 1));
        QVERIFY(removeObject(*m_document, 0));
        QVERIFY(shows("second", 0));
        // The object that takes a removed one's index is shown; another scene starts with its first.
        m_document->undoStack().undo();
        QVERIFY(removeObject(*m_document, 1));
        QVERIFY(shows("first", 0));
        m_document->undoStack().undo();
        open(startScene());
        QVERIFY(shows("first", 0));
    }

private:
    static void addPlaces()
    {
        addColumn<bool>("isHidden");
        addColumn<bool>("isFolded");
        newRow("on the screen") << false << false;
        newRow("in a hidden panel") << true << false;
        newRow("in a folded group") << false << true;
    }
    /// Both objects with a scale, the second shown, 0 typed for it and refused.
    NumberField *refusedScale()
    {
        Scene prepared = startScene();
        for (SceneObject &object : prepared.objects)
            object.transform = {Scale{{2.0, 1.0, 1.0}}};
        open(prepared);
        showGroup(QStringLiteral("modelGroup"));
        choose(QStringLiteral("object"), QStringLiteral("second"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        NumberField *scale = field(QStringLiteral("number0"), QStringLiteral("step1"));
        type(scale, QStringLiteral("0"));
        return scale;
    }
};

UNPROJECTOR_TEST(TestParametersTyping)
#include "test_parameters_typing.moc"
