// Points without faces: dots that can be seen and clicked, and the claimed uncertainty of a point
// clicked by its dot.

#include "tests/support/test.h"

#include "core/geometry/proportions.h"
#include "core/mesh/import/mesh_import.h"
#include "core/scene/point_size.h"
#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_edits.h"
#include "gui/text/formula_text.h"
#include "tests/gui/gui_scene.h"

#include <QFile>
#include <QTemporaryDir>

#include <glm/common.hpp>

using namespace guitest;
using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::gui;
using namespace unprojector::scene;
using namespace unprojector::unproject;

namespace {

/// Farther apart than their dots are wide, away from the axes and the ground.
const std::vector<glm::dvec3> kPoints{{2.0, 1.0, 0.0}, {3.0, 1.5, 0.25}, {2.5, 2.5, -0.5}, {4.0, 2.0, 0.5}};

const LookAt kFromBefore{WorldPoint(3.0, 1.75, 6.0), WorldPoint(3.0, 1.75, 0.0), {0.0, 1.0, 0.0}};

QByteArray lines(const char *head)
{
    QByteArray text;
    for (const glm::dvec3 &p : kPoints)
        text += head + QByteArray::number(p.x) + ' ' + QByteArray::number(p.y) + ' ' + QByteArray::number(p.z) + '\n';
    return text;
}

} // namespace

class TestPointClouds : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    void aPointIsADot_data()
    {
        addColumn<QString>("name");
        addColumn<QByteArray>("content");
        addColumn<bool>("isOrtho");
        const QByteArray ply = "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
                               "property double z\nend_header\n"
                               + lines("");
        newRow("PLY") << "cloud.ply" << ply << false;
        newRow("PLY, orthographic") << "cloud.ply" << ply << true;
        newRow("OBJ") << "cloud.obj" << lines("v ") << false;
    }

    void aPointIsADot()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, content);
        QFETCH(bool, isOrtho);
        QTemporaryDir folder;
        QFile file(folder.filePath(name));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) == content.size());
        file.close();
        const auto model = mesh::importModel(std::filesystem::path(file.fileName().toStdU16String()), {});
        QVERIFY(model);
        QCOMPARE((*model)->pointCount(), kPoints.size());

        const auto window = shownWindow(false, {420, 360});
        SceneDocument &document = window->document();
        SceneView &view = window->view();
        openObjects(document, {{"cloud", {}, *model, {}}}, kFromBefore);
        if (isOrtho)
            switchProjection(document);
        QVERIFY(setObjectHidden(document, 0, true));
        const QImage without = view.grabFramebuffer();
        QVERIFY(setObjectHidden(document, 0, false));
        const QImage with = view.grabFramebuffer();
        const int dot = static_cast<int>(pointPixels(document.setup().surface));
        QVERIFY(dot >= 3 && dot >= 3.0 * view.devicePixelRatio() - 0.5);
        QVERIFY2(differentPixels(with, without) >= static_cast<int>(kPoints.size()) * dot * dot,
                 qPrintable(QString::number(differentPixels(with, without))));

        for (const glm::dvec3 &point : kPoints) {
            const QPointF middle = localOf(*window, point);
            const DevicePixel pixel = pixelUnder(view, middle);
            QVERIFY(with.pixelColor(pixel.i, pixel.j).lightness()
                    < without.pixelColor(pixel.i, pixel.j).lightness() - 60);
            int hits = 0;
            double farthest = 0.0; // from the point, of the claimed uncertainty
            for (int i = -dot; i <= dot; ++i) {
                for (int j = -dot; j <= dot; ++j) {
                    click(view, middle + QPointF(i, j) / view.devicePixelRatio());
                    QVERIFY(document.picks().pick());
                    const Pick pick = *document.picks().pick();
                    if (!pick.hit())
                        continue;
                    ++hits;
                    QCOMPARE(pick.object, std::optional<std::size_t>(0));
                    // The click may be anywhere in the dot: the point lies within the claimed
                    // uncertainty.
                    const glm::dvec3 off = glm::abs(pick.point.world[Method::Formula]->coordinates() - point);
                    const WorldVector claimed = pick.uncertainty.world;
                    const double snapped = 1.01; // the rasteriser's 1/256 pixel
                    QVERIFY2(off.x <= snapped * claimed.x && off.y <= snapped * claimed.y,
                             qPrintable(QStringLiteral("%1, %2 of %3").arg(off.x).arg(off.y).arg(claimed.x)));
                    QVERIFY2(off.z < 1e-6,
                             qPrintable(QString::number(off.z))); // a dot is flat: its depth is the point's
                    QVERIFY(pick.certainty.footprintWidth
                            > (dot - 0.01) * pixelFootprint(pick.setup, -pick.point.eye[Method::Formula]->z).x);
                    farthest = std::max(farthest, off.x / claimed.x);
                    QVERIFY(certaintyText(pick).contains(QStringLiteral("%1 pixels").arg(dot)));
                }
            }
            QCOMPARE(hits, dot * dot);
            QVERIFY(farthest > 1.2 / dot); // half a pixel would be too little
        }
    }

    void theDotGrowsWithThePixelRatio_data()
    {
        addColumn<double>("ratio");
        addColumn<double>("pixels");
        newRow("smaller than 1") << 0.5 << 3.0;
        newRow("1") << 1.0 << 3.0;
        newRow("1.25") << 1.25 << 4.0;
        newRow("2") << 2.0 << 6.0;
    }

    void theDotGrowsWithThePixelRatio()
    {
        QFETCH(double, ratio);
        QFETCH(double, pixels);
        QCOMPARE(pointPixels({800, 600, ratio}), pixels);
    }
};

UNPROJECTOR_TEST(TestPointClouds, display, at 1.5)
#include "test_point_clouds.moc"
