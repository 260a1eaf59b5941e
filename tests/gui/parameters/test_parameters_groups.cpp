// The parameters by group: kinds of projection, rules of the viewport, steps of a model, clip
// planes. Expected numbers are literals.

#include "tests/support/test.h"

#include "gui/document/scene_edits.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/parameters/panel_user.h"

#include <QCheckBox>
#include <QComboBox>
#include <QPushButton>
#include <QRect>
#include <QToolButton>

#include <glm/geometric.hpp>

#include <cmath>
#include <vector>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

/// A few roundings of window positions up to 1000 pixels.
constexpr double kRoundingPixels = 1e-9;
/// A few roundings of coordinates of about 1.
constexpr double kRounding = 1e-12;

} // namespace

class TestParametersGroups : public QObject, PanelUser {
    Q_OBJECT

private slots:
    void init() { start(); }

    void frustumAndPerspectiveShowTheSamePicture()
    {
        Scene prepared = startScene();
        perspective(prepared);
        open(prepared);
        showGroup(QStringLiteral("projectionGroup"));
        const WorldPoint points[] = {WorldPoint(0.3, 0.2, 8.0), WorldPoint(-1.0, 0.5, 0.0),
                                     WorldPoint(2.0, -3.0, -70.0)};
        std::vector<WindowPoint> before;
        for (const WorldPoint &point : points)
            before.push_back(windowPoint(point));
        for (const QString &kind : {QStringLiteral("Frustum"), QStringLiteral("Perspective")}) {
            choose(QStringLiteral("projectionKind"), kind);
            QCOMPARE(kindOf(scene().projection),
                     kind == QStringLiteral("Frustum") ? ProjectionKind::Frustum : ProjectionKind::Perspective);
            for (std::size_t i = 0; i < before.size(); ++i)
                QVERIFY(glm::length(windowPoint(points[i]).coordinates() - before[i].coordinates()) < kRoundingPixels);
        }
        QCOMPARE(m_document->undoStack().count(), 2);
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), prepared));
    }

    void boxesAndPerspectivesAgreeAtThePivot_data()
    {
        addColumn<QString>("from");
        addColumn<QString>("to");
        const QStringList kinds{"Frustum", "Perspective", "Orthographic", "Oblique"};
        for (const QString &from : kinds) {
            for (const QString &to : kinds) {
                if (from != to)
                    newRow(qPrintable(from + QStringLiteral("-to-") + to)) << from << to;
            }
        }
    }

    void boxesAndPerspectivesAgreeAtThePivot()
    {
        QFETCH(QString, from);
        QFETCH(QString, to);
        Scene prepared = startScene();
        perspective(prepared); // symmetric: an off-centre frustum has no perspective of its own
        open(prepared);
        showGroup(QStringLiteral("projectionGroup"));
        choose(QStringLiteral("projectionKind"), from);
        // The points are in the plane of the center, at 10 from the eye.
        const WorldPoint points[] = {WorldPoint(0.0, 0.0, 0.0), WorldPoint(-1.5, 2.5, 0.0), WorldPoint(3.0, -1.0, 0.0)};
        std::vector<WindowPoint> before;
        for (const WorldPoint &point : points)
            before.push_back(windowPoint(point));
        choose(QStringLiteral("projectionKind"), to);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QVERIFY(std::abs(windowPoint(points[i]).x - before[i].x) < kRoundingPixels);
            QVERIFY(std::abs(windowPoint(points[i]).y - before[i].y) < kRoundingPixels);
        }
    }

    void onlyTheNumbersOfTheKindAreShown()
    {
        showGroup(QStringLiteral("projectionGroup"));
        const auto shown = [this] {
            QStringList names;
            for (const NumberField *f : showGroup(QStringLiteral("projectionGroup"))->findChildren<NumberField *>()) {
                if (f->isVisible())
                    names << f->objectName();
            }
            names.sort();
            return names.join(u' ');
        };
        QCOMPARE(shown(), QStringLiteral("bottom farDistance left nearDistance right top"));
        choose(QStringLiteral("projectionKind"), QStringLiteral("Perspective"));
        QCOMPARE(shown(), QStringLiteral("aspect farDistance fovy nearDistance"));
        choose(QStringLiteral("projectionKind"), QStringLiteral("Oblique"));
        QCOMPARE(shown(), QStringLiteral("bottom farDistance left nearDistance phi right theta top"));
        for (const char *angle : {"theta", "phi"}) // a shear that is seen
            QVERIFY(std::abs(field(QLatin1String(angle))->value() - 45.0) < 1e-12);
    }

    void anEditSwitchesOffWhatWouldTakeItBack_data()
    {
        addColumn<QString>("name");
        addColumn<QString>("text");
        addColumn<bool>("isPerspective");
        addColumn<bool>("follows");
        addColumn<bool>("fits");
        newRow("near") << "nearDistance"
                       << "2" << false << true << false;
        newRow("far") << "farDistance"
                      << "77" << false << true << false;
        newRow("left") << "left"
                       << "-3" << false << false << true;
        newRow("right") << "right"
                        << "3" << false << false << true;
        newRow("aspect") << "aspect"
                         << "3" << true << false << true;
        newRow("field-of-view") << "fovy"
                                << "30" << true << true << true;
        newRow("top") << "top"
                      << "3" << false << true << true;
    }

    void anEditSwitchesOffWhatWouldTakeItBack()
    {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(bool, isPerspective);
        Scene prepared = startScene();
        if (isPerspective)
            perspective(prepared);
        prepared.projectionFollowsViewport = prepared.clipDistancesFitObjects = true;
        open(prepared);
        NumberField *target = field(name);
        type(target, text);
        QVERIFY(!target->isBad());
        QCOMPARE(target->text(), text);
        QTEST(scene().projectionFollowsViewport, "follows");
        QTEST(scene().clipDistancesFitObjects, "fits");
        QCOMPARE(m_panel->findChild<QCheckBox *>(QStringLiteral("followsViewport"))->isChecked(),
                 scene().projectionFollowsViewport);
        QCOMPARE(m_panel->findChild<QCheckBox *>(QStringLiteral("fitsObjects"))->isChecked(),
                 scene().clipDistancesFitObjects);
        m_document->undoStack().undo();
        QVERIFY(scene().projectionFollowsViewport && scene().clipDistancesFitObjects);
    }

    void theSwitchesAreUndoable()
    {
        showGroup(QStringLiteral("projectionGroup"));
        click(QStringLiteral("fitsObjects"));
        QVERIFY(scene().clipDistancesFitObjects);
        QVERIFY(frustumOf(scene()).nearDistance > 1.0);
        click(QStringLiteral("followsViewport"));
        const Frustum &f = frustumOf(scene());
        QVERIFY(std::abs((f.right - f.left) / (f.top - f.bottom) - 801.0 / 601.0) < kRounding);
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), startScene()));
        QVERIFY(!m_panel->findChild<QCheckBox *>(QStringLiteral("fitsObjects"))->isChecked());
    }

    void theViewportFollowsItsRule_data()
    {
        addColumn<QString>("kind");
        addColumn<QRect>("viewport");
        newRow("whole") << "Whole window" << QRect(0, 0, 801, 601);
        newRow("letterbox") << "Keep aspect" << QRect(0, 0, 801, 601);
        newRow("quarter") << "Lower right quarter" << QRect(400, 0, 400, 300);
        newRow("fixed") << "Fixed rectangle" << QRect(0, 0, 801, 601);
    }

    void theViewportFollowsItsRule()
    {
        QFETCH(QString, kind);
        showGroup(QStringLiteral("viewportGroup"));
        choose(QStringLiteral("viewportKind"), kind);
        const auto viewport = [this] {
            const Viewport &v = m_document->setup().viewport;
            return QRect(static_cast<int>(v.x), static_cast<int>(v.y), static_cast<int>(v.width),
                         static_cast<int>(v.height));
        };
        QTEST(viewport(), "viewport");
        if (kind == QStringLiteral("Keep aspect")) {
            type(QStringLiteral("viewportAspect"), QStringLiteral("1"));
            QCOMPARE(viewport(), QRect(100, 0, 601, 601));
            type(QStringLiteral("viewportAspect"), QStringLiteral("2"));
            QCOMPARE(viewport(), QRect(0, 100, 801, 401));
        } else if (kind == QStringLiteral("Fixed rectangle")) {
            type(QStringLiteral("viewportX"), QStringLiteral("-20"));
            type(QStringLiteral("viewportY"), QStringLiteral("30"));
            type(QStringLiteral("viewportWidth"), QStringLiteral("320"));
            type(QStringLiteral("viewportHeight"), QStringLiteral("240"));
            QCOMPARE(viewport(), QRect(-20, 30, 320, 240));
            m_document->setSurface({500, 400, 1.0});
            QCOMPARE(viewport(), QRect(-20, 30, 320, 240));
        } else if (kind == QStringLiteral("Lower right quarter")) {
            m_document->setSurface({500, 400, 1.0});
            QCOMPARE(viewport(), QRect(250, 0, 250, 200));
        }
    }

    void aFixedRectangleStartsFromTheViewportInUse()
    {
        showGroup(QStringLiteral("viewportGroup"));
        choose(QStringLiteral("viewportKind"), QStringLiteral("Lower right quarter"));
        choose(QStringLiteral("viewportKind"), QStringLiteral("Fixed rectangle"));
        QCOMPARE(field(QStringLiteral("viewportX"))->text(), QStringLiteral("400"));
        QCOMPARE(field(QStringLiteral("viewportHeight"))->text(), QStringLiteral("300"));
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), startScene()));
    }

    void theOrderOfStepsMatters()
    {
        showGroup(QStringLiteral("modelGroup"));
        click(QStringLiteral("addTranslate"));
        type(field(QStringLiteral("number0"), QStringLiteral("step1")), QStringLiteral("1"));
        click(QStringLiteral("addRotate"));
        type(field(QStringLiteral("number0"), QStringLiteral("step2")), QStringLiteral("90"));
        type(field(QStringLiteral("number3"), QStringLiteral("step2")), QStringLiteral("1"));
        type(field(QStringLiteral("number2"), QStringLiteral("step2")), QStringLiteral("0"));
        const auto placed = [this] {
            return worldFromObject(scene().objects[0].transform) * glm::dvec4(1.0, 0.0, 0.0, 1.0);
        };
        // T R: turned to (0, 1, 0), then moved.
        QVERIFY(placed() == glm::dvec4(1.0, 1.0, 0.0, 1.0));
        click(QStringLiteral("up"), QStringLiteral("step2"));
        // R T: moved to (2, 0, 0), then turned.
        QVERIFY(placed() == glm::dvec4(0.0, 2.0, 0.0, 1.0));
        m_document->undoStack().undo();
        QVERIFY(placed() == glm::dvec4(1.0, 1.0, 0.0, 1.0));
    }

    void stepsAreAddedRemovedAndUndone()
    {
        showGroup(QStringLiteral("modelGroup"));
        click(QStringLiteral("addTranslate"));
        click(QStringLiteral("addScale"));
        click(QStringLiteral("addRotate"));
        type(field(QStringLiteral("number1"), QStringLiteral("step2")), QStringLiteral("3"));
        const std::vector<TransformStep> all{Translate{}, Scale{{1.0, 3.0, 1.0}}, Rotate{0.0, {0.0, 1.0, 0.0}}};
        QVERIFY(scene().objects[0].transform == all);
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step1"))
                     ->findChild<QToolButton *>(QStringLiteral("up"))
                     ->isEnabled());
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step3"))
                     ->findChild<QToolButton *>(QStringLiteral("down"))
                     ->isEnabled());

        click(QStringLiteral("remove"), QStringLiteral("step1"));
        QVERIFY(scene().objects[0].transform == std::vector<TransformStep>(all.begin() + 1, all.end()));
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step3")));
        click(QStringLiteral("down"), QStringLiteral("step1"));
        QVERIFY(std::holds_alternative<Rotate>(scene().objects[0].transform.at(0)));
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QVERIFY(scene().objects[0].transform == all);
        QCOMPARE(field(QStringLiteral("number1"), QStringLiteral("step2"))->text(), QStringLiteral("3"));
        while (m_document->undoStack().canUndo())
            m_document->undoStack().undo();
        QVERIFY(scene().objects[0].transform.empty());
    }

    void everyObjectHasStepsOfItsOwn()
    {
        showGroup(QStringLiteral("modelGroup"));
        click(QStringLiteral("addTranslate"));
        choose(QStringLiteral("object"), QStringLiteral("second"));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step1")));
        click(QStringLiteral("addTranslate"));
        type(field(QStringLiteral("number2"), QStringLiteral("step1")), QStringLiteral("8"));
        QVERIFY(scene().objects[0].transform == std::vector<TransformStep>{Translate{}});
        QVERIFY((scene().objects[1].transform == std::vector<TransformStep>{Translate{{0.0, 0.0, 8.0}}}));
    }

    void objectsAreRemovedAndPutBack()
    {
        showGroup(QStringLiteral("modelGroup"));
        auto *box = m_panel->findChild<QComboBox *>(QStringLiteral("object"));
        const auto names = [box] {
            QStringList all;
            for (int i = 0; i < box->count(); ++i)
                all << box->itemText(i);
            return all;
        };
        const QStringList both{QStringLiteral("first"), QStringLiteral("second")};
        QCOMPARE(names(), both);
        choose(QStringLiteral("object"), QStringLiteral("second"));
        click(QStringLiteral("addScale"));
        click(QStringLiteral("removeObject"));
        QCOMPARE(names(), both.first(1));
        QCOMPARE(scene().objects.size(), std::size_t(1));
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step1")));
        click(QStringLiteral("removeObject"));
        QVERIFY(scene().objects.empty());
        QVERIFY(!box->isEnabled() && !m_panel->findChild<QToolButton *>(QStringLiteral("removeObject"))->isEnabled());
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QCOMPARE(names(), both);
        // The shown object is the one that it was, although another has come before it.
        choose(QStringLiteral("object"), QStringLiteral("second"));
        QVERIFY(removeObject(*m_document, 0));
        QCOMPARE(box->currentText(), QStringLiteral("second"));
        QVERIFY(m_panel->findChild<QWidget *>(QStringLiteral("step1")));
        m_document->undoStack().undo();
        QCOMPARE(box->currentText(), QStringLiteral("second"));
    }

    void whoHearsOfANumberMayRemoveItsField()
    {
        Scene prepared = startScene();
        rotated(prepared);
        open(prepared);
        showGroup(QStringLiteral("modelGroup"));
        NumberField *angle = field(QStringLiteral("number0"), QStringLiteral("step1"));
        bool isFirst = true;
        connect(m_document.get(), &SceneDocument::changed, this, [&](Changes changes) {
            if (changes & Change::Placement && std::exchange(isFirst, false)) {
                QVERIFY(editTransform(*m_document, 0, {}, {QStringLiteral("by another")}));
                QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            }
        });
        begin(angle, QStringLiteral("45"));
        angle->commit();
        QVERIFY(scene().objects[0].transform.empty());
        QVERIFY(!m_panel->findChild<QWidget *>(QStringLiteral("step1")));
        m_document->undoStack().undo();
        QVERIFY(scene().objects[0].transform == (std::vector<TransformStep>{Rotate{45.0, {0.0, 1.0, 0.0}}}));
    }

    void sixPlanesAtMost()
    {
        showGroup(QStringLiteral("clipGroup"));
        for (int i = 0; i < 6; ++i)
            click(QStringLiteral("addPlane"));
        QCOMPARE(scene().clipPlanes.size(), std::size_t(6));
        auto *add = m_panel->findChild<QPushButton *>(QStringLiteral("addPlane"));
        QVERIFY(!add->isEnabled());
        click(QStringLiteral("isOn"), QStringLiteral("plane4")); // a plane that is off counts
        QVERIFY(!add->isEnabled());
        m_document->undoStack().undo();
        m_document->undoStack().undo();
        QCOMPARE(scene().clipPlanes.size(), std::size_t(5));
        QVERIFY(add->isEnabled());
    }

    void aPlaneSwitchedOffIsKept()
    {
        Scene prepared = startScene();
        prepared.clipPlanes = {{1.0, 0.0, 0.0, 1.0}, {0.0, 1.0, 0.0, 2.0}, {0.0, 0.0, 1.0, 3.0}};
        open(prepared);
        showGroup(QStringLiteral("clipGroup"));
        click(QStringLiteral("isOn"), QStringLiteral("plane2"));
        QVERIFY(scene().clipPlanes == (std::vector<glm::dvec4>{{1.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 1.0, 3.0}}));
        // It stays the second line and can be edited.
        QCOMPARE(field(QStringLiteral("number3"), QStringLiteral("plane2"))->text(), QStringLiteral("2"));
        type(field(QStringLiteral("number3"), QStringLiteral("plane2")), QStringLiteral("7"));
        click(QStringLiteral("isOn"), QStringLiteral("plane2"));
        QVERIFY(scene().clipPlanes
                == (std::vector<glm::dvec4>{{1.0, 0.0, 0.0, 1.0}, {0.0, 1.0, 0.0, 7.0}, {0.0, 0.0, 1.0, 3.0}}));
        while (m_document->undoStack().canUndo())
            m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), prepared));
        QVERIFY(m_panel->findChild<QWidget *>(QStringLiteral("plane2"))->findChild<QCheckBox *>()->isChecked());
    }

    void aPlaneInTheMiddleIsRemoved()
    {
        Scene prepared = startScene();
        prepared.clipPlanes = {{1.0, 0.0, 0.0, 1.0}, {0.0, 1.0, 0.0, 2.0}, {0.0, 0.0, 1.0, 3.0}};
        open(prepared);
        showGroup(QStringLiteral("clipGroup"));
        click(QStringLiteral("remove"), QStringLiteral("plane2"));
        QVERIFY(scene().clipPlanes == (std::vector<glm::dvec4>{{1.0, 0.0, 0.0, 1.0}, {0.0, 0.0, 1.0, 3.0}}));
        QCOMPARE(field(QStringLiteral("number3"), QStringLiteral("plane2"))->text(), QStringLiteral("3"));
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), prepared));
    }

private:
    WindowPoint windowPoint(const WorldPoint &point) const
    {
        return windowFromWorld(m_document->setup(), point).value();
    }
};

UNPROJECTOR_TEST(TestParametersGroups)
#include "test_parameters_groups.moc"
