// The panels of numbers stand still: no pick, of tiny or of huge models, changes a panel's least
// width. Labels grow with their texts; once they have, the same changes leave every part in place.

#include "tests/support/test.h"

#include "gui/click/comparison_panel.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/lifecycle_panel.h"
#include "gui/pipeline/pipeline_panel.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/view/lifecycle_log.h"
#include "gui/widgets/steady_label.h"
#include "tests/gui/document_edits.h"

#include <QLabel>
#include <QVBoxLayout>

#include <functional>
#include <memory>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::mesh;
using namespace unprojector::scene;

namespace {

/// Opens a scene seen by glFrustum from five units away, scaled by `size`.
void openScene(SceneDocument &document, double size, double offset = 0.0)
{
    Scene scene;
    scene.camera = scene.home = {WorldPoint(offset, 0, 5 * size), WorldPoint(offset, 0, 0), {0, 1, 0}};
    scene.projection = Frustum{-1.2345678 * size, 1.2345678 * size, -0.98765432 * size,
                               0.98765432 * size, 2.0123456 * size, 10.987654 * size};
    scene.projectionFollowsViewport = false;
    scene.clipDistancesFitObjects = false;
    auto model = std::make_shared<Model>();
    model->bounds.add(glm::dvec3(-size));
    model->bounds.add(glm::dvec3(size));
    SceneObject object;
    object.name = "Box";
    object.model = model;
    scene.objects = {object};
    QVERIFY(document.open(scene));
}

/// The user's changes to the numbers, one after the other.
const std::vector<std::function<void(SceneDocument &)>> &happenings()
{
    const auto pick = [](SceneDocument &document) {
        pickAt(document, WidgetPoint(412.0, 199.0), {0.712345678, 0, 24});
    };
    static const std::vector<std::function<void(SceneDocument &)>> list{
        pick,
        [](SceneDocument &document) {
            pickAt(document, WidgetPoint(3.0, 2.0), {1.0, {}, 24});
        },
        [pick](SceneDocument &document) {
            pick(document);
            LookAt camera = document.setup().camera();
            camera.eye.x += 37.0;
            camera.eye.y -= 55.0;
            camera.eye.z += 12.0;
            setCamera(document, camera);
        },
        [pick](SceneDocument &document) {
            openScene(document, 1e-9);
            pick(document);
        },
        [pick](SceneDocument &document) {
            openScene(document, 123456789.0, -4.5e9);
            pick(document);
        },
        [](SceneDocument &document) {
            LookAt camera = document.setup().camera();
            camera.eye.z *= 9.0;
            setCamera(document, camera);
        },
        [](SceneDocument &document) {
            QVERIFY(editTransform(document, 0, {Translate{{1.0, 2.0, 3.0}}}, {QStringLiteral("Move")}));
        },
        [pick](SceneDocument &document) {
            openScene(document, 0.03);
            setProjection(document, Oblique{{-0.2, 0.2, -0.1, 0.1, 0.01, 0.9}, 0.7, 0.9});
            pick(document);
        },
        [](SceneDocument &document) { document.picks().clearPick(); },
    };
    return list;
}

QString places(const QWidget &panel)
{
    QStringList list;
    for (const QWidget *child : panel.findChildren<QWidget *>(Qt::FindDirectChildrenOnly)) {
        const QRect r = child->geometry();
        list << QStringLiteral("%1 (%2): %3,%4 %5x%6")
                    .arg(QLatin1String(child->metaObject()->className()), child->accessibleName())
                    .arg(r.x())
                    .arg(r.y())
                    .arg(r.width())
                    .arg(r.height());
    }
    const QSize least = panel.minimumSizeHint().expandedTo(panel.minimumSize());
    list << QStringLiteral("at least %1x%2").arg(least.width()).arg(least.height());
    return list.join(u'\n');
}

} // namespace

class TestSteadyPanels : public QObject {
    Q_OBJECT

private slots:
    void aSteadyLabelGrowsAndDoesNotShrink()
    {
        QWidget panel;
        auto *label = new SteadyLabel;
        auto *below = new QLabel(QStringLiteral("below"));
        auto *layout = new QVBoxLayout(&panel);
        layout->addWidget(label);
        layout->addWidget(below);
        layout->addStretch();
        panel.show();
        const auto placeAt = [&](int width) {
            panel.resize(width, 800);
            QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
            return below->y();
        };
        const int first = placeAt(300);
        label->setText(QStringLiteral("several words in a row ").repeated(8));
        const int grown = placeAt(300), grownNarrow = placeAt(200);
        QVERIFY(first < grown && grown < grownNarrow);
        for (const QString &text : {QString(), QStringLiteral("short")}) {
            label->setText(text);
            QCOMPARE(placeAt(200), grownNarrow);
            QCOMPARE(placeAt(300), grown);
            label->setMarkup(QStringLiteral("<b>%1</b>").arg(text), text);
            QCOMPARE(placeAt(300), grown);
        }
        label->setText({});
        label->startOver();
        QCOMPARE(placeAt(300), first);
    }

    void nothingMovesOnceItHasGrown_data()
    {
        addColumn<QString>("which");
        for (const char *which : {"comparison", "pipeline", "viewport", "life"})
            newRow(which) << QString::fromLatin1(which);
    }

    void nothingMovesOnceItHasGrown()
    {
        QFETCH(QString, which);
        SceneDocument document;
        document.setSurface({842, 723, 1.0});
        openScene(document, 1.0);
        LifecycleLog log;
        QWidget frame;
        std::unique_ptr<QWidget> panel; // goes before the frame
        if (which == QStringLiteral("comparison"))
            panel = std::make_unique<ComparisonPanel>(document);
        else if (which == QStringLiteral("pipeline"))
            panel = std::make_unique<PipelinePanel>(document);
        else if (which == QStringLiteral("viewport"))
            panel = std::make_unique<ViewportInspector>(document);
        else
            panel = std::make_unique<LifecyclePanel>(log);

        const auto settle = [] {
            // A layout that grows asks the one around it, level by level.
            for (int level = 0; level < 4; ++level)
                QCoreApplication::sendPostedEvents();
            QCoreApplication::processEvents();
        };
        const int digit = panel->fontMetrics().horizontalAdvance(u'0');
        const int least = panel->minimumSizeHint().expandedTo(panel->minimumSize()).width();
        // The panel is inside a window, not one itself: the window system resizes windows late, and
        // once more after that.
        frame.resize(90 * digit, 2400);
        panel->setParent(&frame);
        panel->show();
        frame.show();
        for (const int width : {least, 90 * digit}) {
            panel->resize(width, 2400);
            settle();
            QCOMPARE(panel->width(), width);
            QString grown;
            for (const bool isGrown : {false, true}) {
                openScene(document, 1.0);
                document.picks().clearPick();
                for (std::size_t i = 0; i < happenings().size(); ++i) {
                    happenings()[i](document);
                    if (auto *inspector = qobject_cast<ViewportInspector *>(panel.get()))
                        inspector->setPointer(WidgetPoint(100.0 * static_cast<double>(i), 321.5));
                    log.append(
                        {LifecycleEvent::Kind::OnLButtonDown, QStringLiteral("1234.5, 987.5"),
                         QStringLiteral("glReadPixels(1234, 1987, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth): depth = "
                                        "0.123456789, object id 12"),
                         12.3456});
                    log.append({LifecycleEvent::Kind::OnDraw,
                                {},
                                QStringLiteral("glBindFramebuffer, glClearBuffer"),
                                8888.88});
                    log.append({LifecycleEvent::Kind::OnDraw, {}, QStringLiteral("glDrawArrays"), 8888.88});
                    settle();
                    const QString where = QStringLiteral(" at %1 px, happening %2").arg(width).arg(i);
                    QCOMPARE(panel->minimumSizeHint().expandedTo(panel->minimumSize()).width(), least);
                    const QString now = places(*panel);
                    // The comparison's parts come and go with the pick: test_comparison_panel checks
                    // that it stands still.
                    QVERIFY2(which == QStringLiteral("comparison") || !isGrown || now == grown,
                             qPrintable(grown + QStringLiteral("\n->\n") + now + where));
                }
                grown = places(*panel);
            }
        }
    }
};

UNPROJECTOR_TEST(TestSteadyPanels)
#include "test_steady_panels.moc"
