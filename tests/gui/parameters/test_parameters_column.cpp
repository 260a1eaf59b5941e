// The column of groups: folding, by mouse and keyboard, its kept state, Reset, the sliders, the focus
// after an addition or a removal, the places of its numbers, and the width that it asks for.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/parameters/panel_user.h"

#include "gui/parameters/group_heading.h"
#include "gui/parameters/number_slider.h"

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSet>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

const char *const kGroups[] = {"viewGroup", "projectionGroup", "viewportGroup", "modelGroup", "clipGroup"};

/// Numbers of all lengths, and one of every kind of part.
Scene fullScene()
{
    Scene scene = startScene();
    scene.camera = {WorldPoint(-1.0 / 3.0, 1.2345678901234567e-300, 123456789.123456789),
                    scene.camera->center,
                    {1e-5, 1.0, -2.0 / 3.0}};
    scene.projection = Frustum{-1.0 / 3.0, 2.0 / 3.0, -1e-7, 80000.0, 7.149488340677281, 31.88249808802577};
    scene.viewport = {ViewportRule::Kind::Fixed, Viewport{-16384.0, -16384.0, 16384.0, 16384.0}, 4.0 / 3.0};
    scene.depthRange = {0.649999976, 1.0 / 3.0};
    scene.objects[0].transform = {Translate{{-1.0 / 3.0, 123.456789, -1e-5}},
                                  Rotate{-123.456789, {0.1 + 0.2, 1.0, 0.0}}, Scale{{1e-10, -1.0 / 3.0, 1e10}}};
    scene.clipPlanes.assign(6, {-0.123456789, 1.0, 2.0e-7, -123456789.0});
    return scene;
}

} // namespace

class TestParametersColumn : public QObject, PanelUser {
    Q_OBJECT

private slots:
    void init() { start(); }

    void aHeadingFolds_data()
    {
        addColumn<int>("key"); // 0: a click
        addColumn<bool>("fromOpen");
        addColumn<bool>("isOpen");
        newRow("click") << 0 << true << false;
        newRow("click-again") << 0 << false << true;
        newRow("space") << int(Qt::Key_Space) << true << false;
        newRow("enter") << int(Qt::Key_Enter) << true << false;
        newRow("return") << int(Qt::Key_Return) << false << true;
        newRow("left") << int(Qt::Key_Left) << true << false;
        newRow("left-of-a-folded-one") << int(Qt::Key_Left) << false << false;
        newRow("right") << int(Qt::Key_Right) << false << true;
    }

    void aHeadingFolds()
    {
        QFETCH(int, key);
        QFETCH(bool, fromOpen);
        QFETCH(bool, isOpen);
        ParameterGroup *group = showGroup(QStringLiteral("viewGroup"));
        group->setOpen(fromOpen);
        QToolButton *button = heading(QStringLiteral("viewGroup"));
        if (key == 0)
            QTest::mouseClick(button, Qt::LeftButton);
        else
            QTest::keyClick(button, static_cast<Qt::Key>(key));
        QCOMPARE(group->isOpen(), isOpen);
        QCOMPARE(group->findChild<NumberField *>()->isVisible(), isOpen);
        QCOMPARE(button->accessibleName(), QStringLiteral("View"));
        QCOMPARE(button->accessibleDescription(), isOpen ? QStringLiteral("Open") : QStringLiteral("Folded"));
    }

    void arrowsGoFromHeadingToHeading()
    {
        heading(QStringLiteral("viewGroup"))->setFocus();
        for (const char *next : {"projectionGroup", "viewportGroup", "modelGroup", "clipGroup", "clipGroup"}) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
            QCOMPARE(QApplication::focusWidget(), heading(QString::fromLatin1(next)));
        }
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Up);
        QCOMPARE(QApplication::focusWidget(), heading(QStringLiteral("modelGroup")));
    }

    void whatIsFoldedIsKept()
    {
        showGroup(QStringLiteral("viewGroup"))->setOpen(false);
        showGroup(QStringLiteral("clipGroup"));
        const QByteArray state = m_panel->saveState();
        ParametersPanel other(*m_document);
        QVERIFY(other.restoreState(state));
        QCOMPARE(other.saveState(), state);
        QVERIFY(!other.findChild<ParameterGroup *>(QStringLiteral("viewGroup"))->isOpen());
        QVERIFY(other.findChild<ParameterGroup *>(QStringLiteral("clipGroup"))->isOpen());
        QVERIFY(!other.findChild<ParameterGroup *>(QStringLiteral("modelGroup"))->isOpen());
    }

    void anotherStateIsRefused()
    {
        const QByteArray state = m_panel->saveState();
        QVERIFY(!m_panel->restoreState({}));
        QVERIFY(!m_panel->restoreState("nonsense viewGroup"));
        QCOMPARE(m_panel->saveState(), state);
    }

    void aFoldedGroupCatchesUp()
    {
        NumberField *eye = field(QStringLiteral("eyeX"));
        ParameterGroup *group = showGroup(QStringLiteral("viewGroup"));
        group->setOpen(false);
        LookAt camera = scene().camera;
        camera.eye.x = 3.0;
        QVERIFY(editCamera(*m_document, camera, {QStringLiteral("by another")}));
        QCOMPARE(eye->value(), 0.0); // a folded group costs nothing
        group->setOpen(true);
        QCOMPARE(eye->text(), QStringLiteral("3"));
    }

    void resetIsOneStep_data()
    {
        addColumn<QString>("group");
        for (const char *group : {"viewGroup", "projectionGroup", "viewportGroup", "modelGroup", "clipGroup"})
            newRow(group) << QString::fromLatin1(group);
    }

    void resetIsOneStep()
    {
        QFETCH(QString, group);
        Scene changed = startScene();
        LookAt camera = changed.camera;
        camera.eye.x = 4.0;
        changed.camera = camera;
        fixedViewport(changed);
        changed.depthRange = {0.25, 0.5};
        rotated(changed);
        cut(changed);
        changed.clipPlanesOff = {{1, {0.0, 1.0, 0.0, 2.0}}};
        open(changed);
        showGroup(group);
        click(QStringLiteral("reset"), group);
        QCOMPARE(m_document->undoStack().count(), 1);
        const Scene &now = scene();
        if (group == QStringLiteral("viewGroup")) {
            QVERIFY(now.camera->eye.coordinates() == changed.home->eye.coordinates());
            QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Reset View"));
        } else if (group == QStringLiteral("projectionGroup")) {
            QVERIFY(now.projectionFollowsViewport && now.clipDistancesFitObjects);
            QCOMPARE(field(QStringLiteral("fovy"))->text(), QStringLiteral("45"));
        } else if (group == QStringLiteral("viewportGroup")) {
            QVERIFY(now.viewport == ViewportRule{} && now.depthRange == DepthRange{});
        } else if (group == QStringLiteral("modelGroup")) {
            QVERIFY(now.objects[0].transform.empty());
        } else {
            QVERIFY(now.clipPlanes.empty() && now.clipPlanesOff.empty());
        }
        click(QStringLiteral("reset"), group); // there is nothing left to do
        QCOMPARE(m_document->undoStack().count(), 1);
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), changed));
    }

    void aDragIsOneStep()
    {
        Scene prepared = startScene();
        perspective(prepared);
        open(prepared);
        NumberSlider *fovy = slider(QStringLiteral("Field of view"));
        QVERIFY(fovy);
        int changes = 0;
        connect(m_document.get(), &SceneDocument::changed, this,
                [&](Changes told) { changes += told & Change::Setup ? 1 : 0; });
        for (const int end : {90, 60}) {
            fovy->setSliderDown(true);
            for (const int way : {end - 10, end - 5, end})
                fovy->setValue(way - 1); // the first place is 1 degree
            fovy->setSliderDown(false);
            QCOMPARE(field(QStringLiteral("fovy"))->text(), QString::number(end));
        }
        QCOMPARE(changes, 6); // live
        QCOMPARE(m_document->undoStack().count(), 2);
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Field of view"));
        m_document->undoStack().undo();
        QCOMPARE(field(QStringLiteral("fovy"))->text(), QStringLiteral("90"));
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), prepared));
    }

    /// Their range depends on the objects' size and the eye's distance. Their steps are round numbers,
    /// also far from zero.
    void theEyesSlidersFollowTheScene()
    {
        const auto ends = [this](const QString &name) {
            NumberSlider *eye = slider(name, QStringLiteral("viewGroup"));
            eye->setSliderDown(true); // it keeps its range
            eye->setValue(eye->minimum());
            const double lowest = scene().camera->eye.x;
            eye->setValue(eye->maximum());
            const double highest = scene().camera->eye.x;
            eye->setSliderDown(false);
            m_document->undoStack().undo();
            return std::pair(lowest, highest);
        };
        for (const double offset : {0.0, 5412349.5}) {
            Scene prepared = startScene();
            prepared.objects[0].transform = {Translate{{offset, 0.0, 0.0}}};
            prepared.camera = {WorldPoint(offset + 3.0, 2.0, 5.0), WorldPoint(offset, 0.0, 0.0), {0.0, 1.0, 0.0}};
            open(prepared);
            const double size = m_document->bounds().diagonal();
            const double reach = std::max(size, 6.2);
            const auto [lowest, highest] = ends(QStringLiteral("Eye x"));
            QVERIFY2(lowest <= offset - reach && highest >= offset + reach,
                     qPrintable(QString::number(lowest, 'g', 12)));
            QVERIFY2(highest - lowest <= 7.0 * reach, qPrintable(QString::number(highest - lowest)));
            QVERIFY(field(QStringLiteral("eyeX"))->text().size() <= 11);
        }
        for (const char *name : {"Eye y", "Eye z", "Center x", "Center y", "Center z"})
            QVERIFY2(slider(QString::fromLatin1(name), QStringLiteral("viewGroup")), name);
        QVERIFY(!slider(QStringLiteral("Up x"), QStringLiteral("viewGroup")));
    }

    void aDragOfTheEyeIsOneStep()
    {
        NumberSlider *eye = slider(QStringLiteral("Eye x"), QStringLiteral("viewGroup"));
        const Scene before = scene();
        eye->setSliderDown(true);
        const int lowest = eye->minimum(), highest = eye->maximum();
        for (const int position : {lowest, highest}) {
            eye->setValue(position);
            QCOMPARE(field(QStringLiteral("eyeX"))->text().toDouble(), scene().camera->eye.x);
            QCOMPARE(eye->maximum(), highest); // it keeps its range while it is held
        }
        eye->setSliderDown(false);
        QVERIFY(scene().camera->eye.x > before.camera->eye.x);
        QVERIFY(scene().camera->eye.y == before.camera->eye.y && scene().camera->center == before.camera->center);
        QCOMPARE(m_document->undoStack().count(), 1);
        QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Eye x"));
        m_document->undoStack().undo();
        QVERIFY(isSameScene(scene(), before));
    }

    void keysOnASliderAreOneStep()
    {
        NumberSlider *slide = slider(QStringLiteral("Far"));
        slide->setFocus();
        const int before = slide->value();
        for (int i = 0; i < 3; ++i)
            QTest::keyClick(slide, Qt::Key_Right);
        QCOMPARE(slide->value(), before + 3);
        QVERIFY(frustumOf(scene()).farDistance > 100.0);
        QCOMPARE(m_document->undoStack().count(), 1);
        field(QStringLiteral("top"))->setFocus();
        slide->setFocus();
        QTest::keyClick(slide, Qt::Key_Left);
        QCOMPARE(m_document->undoStack().count(), 2);
    }

    void nearAndFarDoNotPassEachOtherBySlider()
    {
        NumberSlider *nearSlider = slider(QStringLiteral("Near"));
        NumberSlider *farSlider = slider(QStringLiteral("Far"));
        nearSlider->setValue(nearSlider->maximum());
        QVERIFY(frustumOf(scene()).nearDistance > 90.0 && frustumOf(scene()).nearDistance < 100.0);
        type(QStringLiteral("nearDistance"), QStringLiteral("50"));
        farSlider->setValue(farSlider->minimum());
        QVERIFY(frustumOf(scene()).farDistance > 50.0 && frustumOf(scene()).farDistance < 60.0);
    }

    /// A box may begin behind the eye.
    void nearOfABoxGoesBelowZeroBySlider()
    {
        Scene prepared = startScene();
        box(prepared);
        open(prepared);
        NumberSlider *nearSlider = slider(QStringLiteral("Near"));
        const auto nearDistance = [this] { return projectionWindow(scene().projection).nearDistance; };
        nearSlider->setValue(nearSlider->minimum());
        QVERIFY(nearDistance() <= -10.0);
        type(QStringLiteral("nearDistance"), QStringLiteral("-10"));
        const int atTen = nearSlider->value();
        QVERIFY(atTen > nearSlider->minimum() || nearDistance() == -10.0);
        QTest::keyClick(nearSlider, Qt::Key_Right);
        QVERIFY(nearDistance() > -10.0 && nearDistance() < -9.0);
        NumberSlider *farSlider = slider(QStringLiteral("Far"));
        farSlider->setValue(farSlider->minimum());
        QVERIFY(projectionWindow(scene().projection).farDistance > nearDistance());
        QVERIFY(projectionWindow(scene().projection).farDistance < 0.0);
        // The near distance is above zero again in a perspective.
        choose(QStringLiteral("projectionKind"), QStringLiteral("Perspective"));
        nearSlider->setValue(nearSlider->minimum());
        QVERIFY(nearDistance() > 0.0);
    }

    void aSliderShowsTheNumber()
    {
        Scene prepared = startScene();
        perspective(prepared);
        open(prepared);
        type(QStringLiteral("fovy"), QStringLiteral("100"));
        QCOMPARE(slider(QStringLiteral("Field of view"))->value(), 99);
        const int steps = m_document->undoStack().count();
        NumberSlider *nearSlider = slider(QStringLiteral("Near"));
        const int atOne = nearSlider->value();
        type(QStringLiteral("nearDistance"), QStringLiteral("0.1"));
        QCOMPARE(nearSlider->value(), atOne - 100); // a hundred places in a power of ten
        type(QStringLiteral("nearDistance"), QStringLiteral("1e-9"));
        QCOMPARE(nearSlider->value(), nearSlider->minimum());
        QVERIFY(std::get<Perspective>(*scene().projection).nearDistance == 1e-9);
        QCOMPARE(m_document->undoStack().count(), steps + 2);
    }

    void theWheelOnlyScrollsPastASlider()
    {
        NumberSlider *slide = slider(QStringLiteral("Far"));
        const QPointF position(5.0, 5.0);
        QWheelEvent turn(position, slide->mapToGlobal(position), {}, {0, 120}, Qt::NoButton, Qt::NoModifier,
                         Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(slide, &turn);
        QCOMPARE(m_document->undoStack().count(), 0);
    }

    void theKeyboardStaysWhereItIsAfterAClick_data()
    {
        addColumn<QString>("group");
        addColumn<QString>("button");
        newRow("plane") << "clipGroup"
                        << "addPlane";
        newRow("step") << "modelGroup"
                       << "addRotate";
        newRow("reset") << "viewGroup"
                        << "reset";
    }

    void theKeyboardStaysWhereItIsAfterAClick()
    {
        QFETCH(QString, group);
        QFETCH(QString, button);
        QWidget *used = showGroup(group)->findChild<QWidget *>(button);
        NumberField *top = field(QStringLiteral("top"));
        top->setFocus();
        QCoreApplication::processEvents();
        QTest::mouseClick(used, Qt::LeftButton);
        QCOMPARE(QApplication::focusWidget(), top);
    }

    void byTheKeyboardTheNewFieldIsNext_data()
    {
        addColumn<QString>("group");
        addColumn<QString>("button");
        addColumn<QString>("part");
        newRow("plane") << "clipGroup"
                        << "addPlane"
                        << "plane1";
        newRow("step") << "modelGroup"
                       << "addRotate"
                       << "step1";
    }

    void byTheKeyboardTheNewFieldIsNext()
    {
        QFETCH(QString, group);
        QFETCH(QString, button);
        QFETCH(QString, part);
        QWidget *used = showGroup(group)->findChild<QWidget *>(button);
        used->setFocus(Qt::TabFocusReason);
        QTest::keyClick(used, Qt::Key_Space);
        NumberField *first = field(QStringLiteral("number0"), part);
        QCOMPARE(QApplication::focusWidget(), first);
        QCOMPARE(first->selectedText(), first->text());
        // The focus goes back when it is removed.
        QWidget *remove = m_panel->findChild<QWidget *>(part)->findChild<QWidget *>(QStringLiteral("remove"));
        remove->setFocus(Qt::TabFocusReason);
        QTest::keyClick(remove, Qt::Key_Space);
        QVERIFY(qobject_cast<QPushButton *>(QApplication::focusWidget()));
    }

    void whatIsTypedCountsBeforeAButton()
    {
        Scene prepared = startScene();
        scaled(prepared);
        open(prepared);
        showGroup(QStringLiteral("modelGroup"));
        begin(field(QStringLiteral("number0"), QStringLiteral("step1")), QStringLiteral("5"));
        click(QStringLiteral("addTranslate"));
        QVERIFY((scene().objects[0].transform == std::vector<TransformStep>{Scale{{5.0, 1.0, 1.0}}, Translate{}}));
    }

    void tabGoesDownTheColumn()
    {
        openAll();
        for (const char *button : {"addTranslate", "addPlane", "addRotate", "addPlane"})
            click(QString::fromLatin1(button));
        QCoreApplication::processEvents();
        heading(QStringLiteral("viewGroup"))->setFocus();
        const auto place = [this] {
            const QWidget *focus = QApplication::focusWidget();
            // Buttons of a line are as high as it, or centred in it.
            return focus->mapTo(m_panel->widget(), QPoint(0, focus->height() / 2));
        };
        int stops = 1;
        for (QPoint before = place(), start = before;; ++stops) {
            QWidget *left = QApplication::focusWidget();
            QTest::keyClick(left, Qt::Key_Tab);
            if (QApplication::focusWidget() == left && qobject_cast<QLabel *>(left))
                QTest::keyClick(left, Qt::Key_Tab); // from the text to its link, which is a stop of its own
            const QPoint now = place();
            if (now == start)
                break;
            const int line = m_panel->fontMetrics().height() / 2;
            QVERIFY2(now.y() > before.y() + line || (now.y() > before.y() - line && now.x() > before.x()),
                     qPrintable(QApplication::focusWidget()->accessibleName()));
            before = now;
        }
        QVERIFY(stops > 50);
    }

    void numbersShareARowWhereTheyFit()
    {
        openFull();
        const auto isShared = [this] {
            QCoreApplication::processEvents();
            return field(QStringLiteral("eyeX"))->y() == field(QStringLiteral("eyeZ"))->y();
        };
        QVERIFY(!isShared());
        m_panel->resize(2 * m_panel->minimumSizeHint().width(), 600);
        QVERIFY(isShared());
        m_panel->resize(m_panel->minimumSizeHint().width(), 600);
        QVERIFY(!isShared());
    }

    void unitsStandInOneColumn()
    {
        openFull();
        for (const int width : {m_panel->minimumSizeHint().width(), 2 * m_panel->minimumSizeHint().width()}) {
            m_panel->resize(width, 600);
            QCoreApplication::processEvents();
            QSet<int> columns;
            int fields = 0;
            for (const NumberField *field : m_panel->findChildren<NumberField *>()) {
                if (!field->isVisible())
                    continue;
                ++fields;
                int units = 0;
                for (const QLabel *label : field->parentWidget()->findChildren<QLabel *>()) {
                    if (!label->isVisible() || label->y() != field->y() || label->x() < field->x())
                        continue;
                    if (label->text().size() > 1) {
                        ++units;
                        columns << label->mapTo(m_panel->widget(), QPoint()).x();
                    }
                }
                // A factor has no unit. If sliders are in that column, the row has its unit once,
                // beneath the title.
                const auto sliders = field->parentWidget()->findChildren<NumberSlider *>();
                const bool isBeneath = std::any_of(sliders.begin(), sliders.end(), [field](const NumberSlider *slider) {
                    return slider->y() == field->y() && slider->x() > field->geometry().right();
                });
                const bool isFactor = field->accessibleName().contains(QStringLiteral("Scale"));
                QVERIFY2(units == (isFactor || isBeneath ? 0 : 1), qPrintable(field->accessibleName()));
                if (isBeneath) {
                    const auto labels = field->parentWidget()->findChildren<QLabel *>();
                    QCOMPARE(std::count_if(labels.begin(), labels.end(),
                                           [](const QLabel *label) {
                                               return label->isVisible()
                                                      && label->text() == QStringLiteral("world units");
                                           }),
                             1);
                }
            }
            QVERIFY(fields > 50);
            QCOMPARE(columns.size(), 1);
        }
    }

    void itAsksForTheSameWidthWhateverIsDone()
    {
        openFull();
        const QSize least = m_panel->minimumSizeHint();
        const auto isSame = [&] {
            QCoreApplication::processEvents();
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return m_panel->minimumSizeHint() == least && m_panel->widget()->minimumSizeHint().width() <= least.width();
        };
        open(startScene());
        QVERIFY(isSame());
        for (const char *group : kGroups) {
            showGroup(QString::fromLatin1(group))->setOpen(false);
            QVERIFY2(isSame(), group);
        }
        openAll();
        for (const char *kind : {"Perspective", "Orthographic", "Oblique", "Frustum"}) {
            choose(QStringLiteral("projectionKind"), QString::fromLatin1(kind));
            QVERIFY2(isSame(), kind);
        }
        for (const char *step : {"addTranslate", "addRotate", "addScale", "addPlane"}) {
            click(QString::fromLatin1(step));
            QVERIFY2(isSame(), step);
        }
        type(QStringLiteral("nearDistance"), QStringLiteral("abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz"));
        QVERIFY(isSame());
        Scene named = startScene();
        named.objects[0].name = std::string(200, 'M');
        open(named);
        QVERIFY(isSame());
    }

private:
    void openAll()
    {
        for (const char *group : kGroups)
            showGroup(QString::fromLatin1(group));
    }
    void openFull()
    {
        open(fullScene());
        openAll();
    }
    NumberSlider *slider(const QString &name, const QString &group = QStringLiteral("projectionGroup"))
    {
        for (auto *found : showGroup(group)->findChildren<NumberSlider *>()) {
            if (found->accessibleName() == name)
                return found;
        }
        return nullptr;
    }
    QToolButton *heading(const QString &group)
    {
        return m_panel->findChild<ParameterGroup *>(group)->heading().button();
    }
};

UNPROJECTOR_TEST(TestParametersColumn)
#include "test_parameters_column.moc"
