// The map over the view: it shows the view's own picture, and disappears as soon as that changes.

#include "tests/support/test.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/landmarks/landmark_loupe.h"
#include "gui/map/map_colors.h"
#include "gui/map/map_overlay.h"
#include "gui/map/map_panel.h"
#include "gui/view/scene_view.h"
#include "tests/gui/job_faults.h"
#include "tests/gui/window_user.h"
#include "tests/support/patience.h"

#include <QComboBox>
#include <QDir>
#include <QLabel>
#include <QTemporaryDir>

#include <algorithm>
#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace guitest;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

QComboBox *boxOf(MainWindow &window, const QString &accessibleName)
{
    for (QComboBox *box : part<MapOverlay>(window).panel().findChildren<QComboBox *>()) {
        if (box->accessibleName() == accessibleName)
            return box;
    }
    return nullptr;
}

/// A pixel that has a number.
std::optional<DevicePixel> seenPixel(const maps::PixelMap &map)
{
    for (int j = map.heightPixels / 2; j < map.heightPixels; ++j) {
        for (int i = 0; i < map.widthPixels; ++i) {
            if (!std::isnan(map.at({i, j})))
                return DevicePixel{i, j};
        }
    }
    return std::nullopt;
}

double luminance(const QColor &color)
{
    return 0.2126 * color.redF() + 0.7152 * color.greenF() + 0.0722 * color.blueF();
}

} // namespace

class TestMapOverlay : public QObject {
    Q_OBJECT

private slots:
    void colorsGoFromDarkToLight()
    {
        for (const ColorMap map : {ColorMap::Viridis, ColorMap::Cividis}) {
            for (int k = 0; k < 100; ++k)
                QVERIFY(luminance(colorAt(map, k / 100.0)) < luminance(colorAt(map, (k + 1) / 100.0)));
            QVERIFY(luminance(colorAt(map, 0.0)) < 0.2 && luminance(colorAt(map, 1.0)) > 0.75);
        }
        // matplotlib's ends and middle of viridis
        const auto isNear = [](const QColor &a, const QColor &b) {
            return std::abs(a.red() - b.red()) < 6 && std::abs(a.green() - b.green()) < 6
                   && std::abs(a.blue() - b.blue()) < 6;
        };
        QVERIFY(isNear(colorAt(ColorMap::Viridis, 0.0), QColor(68, 1, 84)));
        QVERIFY(isNear(colorAt(ColorMap::Viridis, 0.5), QColor(33, 145, 140)));
        QVERIFY(isNear(colorAt(ColorMap::Viridis, 1.0), QColor(253, 231, 37)));
    }

    void scales()
    {
        maps::MapStatistics statistics;
        statistics.count = 10;
        QVERIFY(LogScale::of(statistics).low > 0.0); // all of them 0
        statistics.percentile1 = 0.0;
        statistics.leastAboveZero = 1e-6;
        statistics.greatest = 1e-2;
        const LogScale scale = LogScale::of(statistics);
        QCOMPARE(scale.low, 1e-6);
        QCOMPARE(scale.share(0.0), 0.0);
        QVERIFY(std::abs(scale.share(1e-4) - 0.5) < 1e-12);
        QCOMPARE(scale.share(1.0), 1.0);
        QCOMPARE(scale.ticks().size(), std::size_t{5});
        statistics.leastAboveZero = statistics.greatest = 3.0; // one number everywhere
        const LogScale one = LogScale::of(statistics);
        QVERIFY(one.low < 3.0 && one.high > 3.0);
        QVERIFY(one.ticks().size() >= 2);
        const QImage image = coloredMap({2, 1, {3.0F, std::nanf("")}}, scale, ColorMap::Viridis);
        QCOMPARE(image.pixel(0, 0), colorAt(ColorMap::Viridis, 1.0).rgb());
        QCOMPARE(image.pixelColor(1, 0).alpha(), 0);
    }

    void itComesAndGoes()
    {
        const auto window = windowOfSize({900, 600});
        QVERIFY(part<MapOverlay>(*window).panel().isHidden()); // off at first
        QVERIFY(part<MapOverlay>(*window).map() == nullptr);
        QAction *action = actionOf(*window, "Error Map");
        QCOMPARE(action->shortcut(), QKeySequence(Qt::Key_M));
        action->trigger();
        QVERIFY(!part<MapOverlay>(*window).panel().isHidden());
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        const Setup before = window->document().setup();
        QVERIFY(part<MapOverlay>(*window).map()->setup == before);
        QVERIFY(part<MapOverlay>(*window).map()->question.quantity == maps::Quantity::Uncertainty);

        LookAt camera = before.camera();
        camera.eye += WorldVector(0.5, 0.0, 0.0);
        setCamera(window->document(), camera);
        QVERIFY(part<MapOverlay>(*window).map() == nullptr); // no stale colours
        QVERIFY(part<MapOverlay>(*window).image().isNull());
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        QVERIFY(part<MapOverlay>(*window).map()->setup == window->document().setup());
        QVERIFY(!(part<MapOverlay>(*window).map()->setup == before));
        // A previewed camera has its own map.
        scene::SceneSettings settings = window->document().scene();
        settings.camera = before.camera();
        QVERIFY(window->document().preview(settings));
        QVERIFY(part<MapOverlay>(*window).map() == nullptr);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        QVERIFY(part<MapOverlay>(*window).map()->setup == window->document().setup());
        window->document().endPreview();
        QVERIFY(part<MapOverlay>(*window).map() == nullptr);

        action->trigger();
        QVERIFY(part<MapOverlay>(*window).panel().isHidden());
        QVERIFY(part<MapOverlay>(*window).map() == nullptr);
        setCamera(window->document(), before.camera());
        QTest::qWait(300); // longer than it takes to come to rest
        QVERIFY(part<MapOverlay>(*window).map() == nullptr);
    }

    void itIsOfThePicture()
    {
        const auto window = windowOfSize({900, 600});
        boxOf(*window, "Quantity that the map shows")->setCurrentIndex(0);
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        const MadeMap &made = *part<MapOverlay>(*window).map();
        const Setup &setup = window->document().setup();
        QCOMPARE(made.map.widthPixels, setup.surface.widthPixels);
        QCOMPARE(part<MapOverlay>(*window).image().size(),
                 QSize(setup.surface.widthPixels, setup.surface.heightPixels));
        const std::optional<DevicePixel> pixel = seenPixel(made.map);
        QVERIFY(pixel);
        QCOMPARE(part<MapOverlay>(*window).image().pixelColor(pixel->i, pixel->j).alpha(), 255);
        // The depth as a buffer of 24 bits has it.
        const auto hit = window->document().picks().rays()->at(pixelCenter(*pixel)).value();
        const double depth = DepthFormat().kept(windowFromWorld(setup, hit->world).value().z);
        const Unprojected click =
            window->document().unprojector().at(windowFromDevice(setup.surface, pixelCenter(*pixel), depth));
        QVERIFY(std::abs(double(made.map.at(*pixel)) - length(click.world.difference())) < 1e-14);

        part<MapOverlay>(*window).setPointer(widgetFromDevice(setup.surface, pixelCenter(*pixel)));
        const auto says = [&window](const QString &start) {
            for (const QLabel *label : part<MapOverlay>(*window).panel().findChildren<QLabel *>()) {
                if (label->text().startsWith(start))
                    return true;
            }
            return false;
        };
        QVERIFY(says("here: "));
        part<MapOverlay>(*window).setPointer(WidgetPoint(0.5, 0.5));
        QVERIFY(says("no number here"));
    }

    void theQuestion()
    {
        const auto window = windowOfSize({900, 600});
        part<MapOverlay>(*window).setShown(true);
        QComboBox *quantity = boxOf(*window, "Quantity that the map shows"),
                  *convention = boxOf(*window, "Program or mistake of the displacement");
        QVERIFY(convention->isHidden());
        quantity->setCurrentIndex(4);
        QVERIFY(!convention->isHidden());
        convention->setCurrentIndex(2);
        boxOf(*window, "Unit")->setCurrentIndex(1);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        const maps::Question &question = part<MapOverlay>(*window).map()->question;
        QVERIFY(question.quantity == maps::Quantity::Displacement);
        QVERIFY(question.unit == maps::Unit::Ulps);
        QVERIFY(std::get<OtherProgram>(question.other) == OtherProgram::MeshLab);
        QCOMPARE(part<MapOverlay>(*window).panel().title(), QString("Displacement: MeshLab, ulps"));
        const QImage viridis = part<MapOverlay>(*window).image();
        boxOf(*window, "Colours")->setCurrentIndex(1);
        QVERIFY(part<MapOverlay>(*window).image() != viridis);
    }

    void files()
    {
        const auto window = windowOfSize({900, 600});
        const QTemporaryDir folder;
        const auto path = [&folder](const char *name) {
            return std::filesystem::path(folder.filePath(QLatin1String(name)).toStdU16String());
        };
        QVERIFY(!part<MapOverlay>(*window).exportTo(path("none.pfm")).isEmpty()); // no map yet
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        QCOMPARE(part<MapOverlay>(*window).exportTo(path("a.PFM")), QString());
        QCOMPARE(part<MapOverlay>(*window).exportTo(path("a.png")), QString());
        QFile pfm(folder.filePath("a.PFM"));
        QVERIFY(pfm.open(QIODevice::ReadOnly));
        QCOMPARE(pfm.readAll(), QByteArray::fromStdString(maps::pfmText(part<MapOverlay>(*window).map()->map)));
        const QImage png(folder.filePath("a.png")), shown = part<MapOverlay>(*window).image();
        QCOMPARE(png.width(), shown.width());
        QVERIFY(png.height() > shown.height());
        const std::optional<DevicePixel> pixel = seenPixel(part<MapOverlay>(*window).map()->map);
        QCOMPARE(png.pixelColor(pixel->i, pixel->j), shown.pixelColor(pixel->i, pixel->j));
        QVERIFY(part<MapOverlay>(*window).exportTo(path("a.txt")).contains(".png or .pfm"));
        QVERIFY(part<MapOverlay>(*window).exportTo(path("none/a.pfm")).contains("none"));
    }

    void pointsAreOverTheMap()
    {
        const auto window = windowOfSize({900, 600});
        SceneDocument &document = window->document();
        SceneView &view = window->view();
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        const std::optional<DevicePixel> pixel = seenPixel(part<MapOverlay>(*window).map()->map);
        QVERIFY(pixel);
        const QImage shown = view.grabFramebuffer();
        QCOMPARE(shown.pixelColor(pixel->i, pixel->j),
                 part<MapOverlay>(*window).image().pixelColor(pixel->i, pixel->j));
        landmarks::Landmark landmark;
        landmark.world = document.picks().rays()->at(pixelCenter(*pixel)).value()->world;
        QVERIFY(document.sceneLandmarks().place(landmark));
        QVERIFY(part<MapOverlay>(*window).map() != nullptr); // a point is no other picture
        const QImage marked = view.grabFramebuffer();
        int changed = 0;
        for (int j = -8; j <= 8; ++j) {
            for (int i = -8; i <= 8; ++i) {
                const QPoint at(pixel->i + i, pixel->j + j);
                if (marked.rect().contains(at) && marked.pixel(at) != shown.pixel(at))
                    ++changed;
            }
        }
        QVERIFY2(changed > 20, qPrintable(QString::number(changed)));
        // The loupe is next to the panel.
        const Surface &surface = document.setup().surface;
        const QRectF beside = loupeBox(surface, {10.0, 10.0}, 100.0), usual = loupeBox(surface, {10.0, 10.0});
        QCOMPARE(usual.left() - beside.left(), 100.0);
        // The loupe goes below where there is no room beside it.
        const double all = surface.widthPixels / surface.devicePixelRatio;
        const QRectF below = loupeBox(surface, {10.0, 10.0}, all - 50.0);
        QCOMPARE(below.left(), usual.left());
        QVERIFY(below.top() > usual.bottom());
        QVERIFY(
            loupeBox(surface, deviceFromWidget(surface, {below.center().x(), below.center().y()}), all - 50.0).right()
            < below.left());
        part<MapOverlay>(*window).setShown(false);
        QCOMPARE(view.grabFramebuffer().pixelColor(pixel->i, pixel->j) == shown.pixelColor(pixel->i, pixel->j), false);
    }

    /// The number of the map and the ± of the comparison are the same.
    void uncertaintyIsThatOfAClick()
    {
        const auto window = windowOfSize({900, 600});
        boxOf(*window, "Quantity that the map shows")->setCurrentIndex(3);
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        const MadeMap &made = *part<MapOverlay>(*window).map();
        const Setup &setup = window->document().setup();
        std::vector<DevicePixel> seen; // of the model
        for (int i = 0; i < made.map.widthPixels; ++i) {
            if (const DevicePixel pixel{i, made.map.heightPixels / 2}; std::isfinite(made.map.at(pixel)))
                seen.push_back(pixel);
        }
        QVERIFY(seen.size() > 20);
        for (const double share : {0.4, 0.5, 0.6}) {
            const DevicePixel pixel = seen[std::size_t(share * double(seen.size()))];
            window->view().onLButtonDown(widgetFromDevice(setup.surface, pixelCenter(pixel)));
            const std::optional<Pick> &pick = window->document().picks().pick();
            QVERIFY(pick && pick->hit());
            const double stated = length(pick->uncertainty.world), shown = double(made.map.at(pixel));
            QVERIFY2(std::abs(stated - shown) < 0.02 * shown,
                     qPrintable(QStringLiteral("%1 %2").arg(stated).arg(shown)));
        }
    }

    void noEffectIsNoDifference()
    {
        const auto window = windowOfSize({900, 600});
        boxOf(*window, "Quantity that the map shows")->setCurrentIndex(4);
        QComboBox *convention = boxOf(*window, "Program or mistake of the displacement");
        convention->setCurrentIndex(convention->findText("viewport's origin ignored")); // it is 0, 0
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
        QVERIFY(part<MapOverlay>(*window).map()->statistics.count > 0);
        QCOMPARE(part<MapOverlay>(*window).map()->statistics.greatest, 0.0);
        const QList<QLabel *> labels = part<MapOverlay>(*window).panel().findChildren<QLabel *>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->text().endsWith(QStringLiteral("no difference beyond rounding."));
        }));
    }

    void withoutAMapItSaysWhy_data() { jobfaults::addRows(); }

    void withoutAMapItSaysWhy()
    {
        QFETCH(JobFailure::Kind, kind);
        QFETCH(QString, reason);
        const auto window = windowOfSize({900, 600});
        const auto says = [&](const QString &text) {
            const QList<QLabel *> labels = part<MapOverlay>(*window).panel().findChildren<QLabel *>();
            return std::any_of(labels.begin(), labels.end(),
                               [&](const QLabel *label) { return label->text() == text; });
        };
        {
            const jobfaults::Fault fault(kind);
            part<MapOverlay>(*window).setShown(true);
            QTRY_VERIFY_WITH_TIMEOUT(
                says(QStringLiteral("There is no map: %1. Make the window smaller, or close other programs.")
                         .arg(reason)),
                kPatienceMilliseconds);
            QVERIFY(part<MapOverlay>(*window).map() == nullptr);
        }
        part<MapOverlay>(*window).setShown(false);
        part<MapOverlay>(*window).setShown(true);
        QTRY_VERIFY_WITH_TIMEOUT(part<MapOverlay>(*window).map() != nullptr, kPatienceMilliseconds);
    }
};

UNPROJECTOR_TEST(TestMapOverlay, display)
#include "test_map_overlay.moc"
