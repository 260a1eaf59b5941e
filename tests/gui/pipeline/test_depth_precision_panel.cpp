// The error that rounding a depth leaves, in its panel: computed for this picture, without advice
// that would cut anything off.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/pipeline/depth_precision_panel.h"
#include "gui/pipeline/depth_precision_plot.h"
#include "gui/widgets/steady_label.h"
#include "tests/gui/document_edits.h"
#include "tests/gui/gui_scene.h"

#include <cmath>

using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

class TestDepthPrecisionPanel : public QObject {
    Q_OBJECT

private slots:
    /// A cube of edge 2 with its middle 5 in front of the eye: its front is 4 away.
    void init()
    {
        m_panel.reset();
        m_document = std::make_unique<SceneDocument>();
        m_document->setSurface({800, 600, 1.0});
        const LookAt home{WorldPoint(guitest::kCubeCenter + glm::dvec3(0.0, 0.0, 5.0)),
                          WorldPoint(guitest::kCubeCenter),
                          {0.0, 1.0, 0.0}};
        openObjects(*m_document, guitest::cubeScene(), home);
        m_panel = std::make_unique<DepthPrecisionPanel>(*m_document);
        m_panel->resize(500, 300);
        m_panel->show();
    }

    void aFartherNearIsComputed()
    {
        setPerspective(0.1);
        // 5^2 / 0.1 / 2^25 at the camera's centre
        QVERIFY2(text().contains(QStringLiteral("5 in front of the eye, a rounded depth is accurate to ±7.4e−06")),
                 qPrintable(text()));
        QVERIFY2(text().contains(QStringLiteral("Near 3 instead of 0.1 makes this 31 times better")),
                 qPrintable(text()));
        QCOMPARE(plot().curves().size(), std::size_t(3));
        QCOMPARE(plot().curves()[1].scale.nearDistance, 3.0);
        QVERIFY(!plot().marked());
        // No click has given the number of bits yet.
        QVERIFY2(text().contains(QStringLiteral("24 bits are assumed")), qPrintable(text()));
        QCOMPARE(plot().curves()[0].name, QStringLiteral("as drawn: 24 bits, assumed"));
    }

    void aNearThatFitsIsLeftAlone()
    {
        setPerspective(3.5);
        QVERIFY2(!text().contains(QStringLiteral("instead of")), qPrintable(text()));
        const QString fits = QStringLiteral("Near is about as large as the objects allow");
        QVERIFY2(text().contains(fits), qPrintable(text()));
        LookAt inside = m_document->setup().camera();
        inside.eye = WorldPoint(guitest::kCubeCenter + glm::dvec3(0.0, 0.0, 0.5));
        setCamera(*m_document, inside);
        setPerspective(0.001);
        QVERIFY2(!text().contains(QStringLiteral("instead of")), qPrintable(text()));
        QVERIFY2(!text().contains(fits), qPrintable(text())); // the eye is within it
    }

    void aBoxHasOneErrorEverywhere()
    {
        ProjectionRule rule{Ortho{-2.0, 2.0, -2.0, 2.0, -1.0, 9.0}, false, false};
        QVERIFY(editProjection(*m_document, rule, {}));
        QVERIFY2(text().contains(QStringLiteral("at every distance")), qPrintable(text()));
        QCOMPARE(plot().curves().size(), std::size_t(1));
        QVERIFY(!m_panel->grab().isNull()); // distances from -1 on have no logarithm
    }

    void theClickedPointIsMarked()
    {
        setPerspective(0.1);
        DepthSample sample;
        sample.depth = unitDepthAt(depthScaleOf(m_document->setup()), 4.0); // on the cube's front
        sample.object = 0;
        sample.format = DepthFormat(16);
        pickAt(*m_document, WidgetPoint(400.0, 300.0), sample);
        QVERIFY(plot().marked());
        QVERIFY(std::abs(*plot().marked() - 4.0) < 1e-9);
        QVERIFY2(text().startsWith(
                     QStringLiteral("At the point, 4 in front of the eye, a rounded depth is accurate to ±0.0012")),
                 qPrintable(text()));
        QVERIFY2(text().contains(QStringLiteral("would be 8200 times better")), qPrintable(text()));
        QCOMPARE(plot().curves()[0].name, QStringLiteral("as drawn: 16 bits"));
        const DepthFormat format(16);
        QCOMPARE(halfDepthStepAt(plot().curves()[0].scale, format, 4.0),
                 m_document->picks().pick()->certainty.halfDepthStep);
    }

    void aCurveStaysWhereItGainsNothing()
    {
        setPerspective(3.5);
        QCOMPARE(plot().curves().back().name, QStringLiteral("floats, reversed"));
        DepthSample sample; // just behind the near plane, where floats have no finer steps than 24 bits
        sample.depth = unitDepthAt(depthScaleOf(m_document->setup()), 4.0);
        sample.object = 0;
        pickAt(*m_document, WidgetPoint(400.0, 300.0), sample);
        QVERIFY2(text().contains(
                     QStringLiteral("A float buffer with reversed depths (1 at near) would change little here (±")),
                 qPrintable(text()));
        QVERIFY2(!text().contains(QStringLiteral("assumed")), qPrintable(text()));
        QCOMPARE(plot().curves().back().name, QStringLiteral("floats, reversed"));
    }

private:
    void setPerspective(double nearDistance)
    {
        ProjectionRule rule{Perspective{0.8, 800.0 / 600.0, nearDistance, 100.0}, false, false};
        QVERIFY(editProjection(*m_document, rule, {}));
    }

    QString text() const { return m_panel->findChild<SteadyLabel *>()->text(); }
    const DepthPrecisionPlot &plot() const { return *m_panel->findChild<DepthPrecisionPlot *>(); }

    std::unique_ptr<SceneDocument> m_document;
    std::unique_ptr<DepthPrecisionPanel> m_panel;
};

UNPROJECTOR_TEST(TestDepthPrecisionPanel, display)
#include "test_depth_precision_panel.moc"
