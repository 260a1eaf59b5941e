// Pictures of the view in files: as the view shows them, at other sizes, with and without marks and
// background.

#include "tests/support/test.h"

#include "tests/gui/document_edits.h"
#include "tests/gui/picking.h"
#include "tests/gui/window_user.h"

#include "gui/document/picks.h"
#include "gui/document/scene_curves.h"
#include "gui/shell/contact_sheet.h"
#include "gui/shell/export_picture_dialog.h"
#include "gui/view/scene_picture.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFontMetrics>
#include <QGuiApplication>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryDir>

#include <cmath>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using namespace guitest;

namespace {

constexpr PictureMarks kNoMarks{false, false, false, false, false, false};

Surface surfaceOf(MainWindow &window)
{
    return window.document().setup().surface;
}

/// Twice as many pixels for everything.
Surface twice(Surface surface)
{
    surface.widthPixels *= 2;
    surface.heightPixels *= 2;
    surface.devicePixelRatio *= 2.0;
    return surface;
}

QImage pictureOf(MainWindow &window, const PictureOptions &options)
{
    const Result<QImage> picture = scenePicture(window.view(), options);
    return picture ? *picture : QImage();
}

QSize sizeOf(const Surface &surface)
{
    return {surface.widthPixels, surface.heightPixels};
}

/// The cube with a pick on it, from a point beside the axes.
std::unique_ptr<MainWindow> pickedCube()
{
    auto window = cubeWindow(false);
    click(window->view(), QPointF(localOf(*window, kCubeCenter + glm::dvec3(0.3, 0.2, 1.0)).toPoint()));
    return window;
}

/// Places where two pictures differ, in the second one's pixels.
QRect differences(const QImage &a, const QImage &b)
{
    QRect found;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (a.pixel(x, y) != b.pixel(x, y))
                found |= QRect(x, y, 1, 1);
        }
    }
    return found;
}

template <class Box>
Box *boxNamed(const QWidget &dialog, const char *name)
{
    for (Box *box : dialog.findChildren<Box *>()) {
        if (box->accessibleName() == QLatin1String(name))
            return box;
    }
    return nullptr;
}

QCheckBox *checkBox(const QWidget &dialog, const char *text)
{
    for (QCheckBox *box : dialog.findChildren<QCheckBox *>()) {
        if (box->text().remove(u'&') == QLatin1String(text))
            return box;
    }
    return nullptr;
}

} // namespace

class TestExportPicture : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { redirectSettings(); }

    /// A tile with room for one of two words.
    void theSheetBreaksAReasonAtWords()
    {
        const auto sheetOf = [](const QString &reason) {
            constexpr int kMargins = 16;
            const int width =
                QFontMetrics(QGuiApplication::font()).horizontalAdvance(QStringLiteral("damaged 1234")) + kMargins;
            const QSize tile(width, width);
            ContactSheet sheet(tile, tile);
            sheet.addProblem(reason, QStringLiteral("a.obj"));
            return sheet.image();
        };
        QCOMPARE(sheetOf(QStringLiteral("damaged 1234567890")), sheetOf(QStringLiteral("damaged\n1234567890")));
        // A word that is too long for a line is still shown whole.
        const QString longName(60, u'w');
        QVERIFY(sheetOf(longName) != sheetOf(longName.first(30)));
    }

    void atTheViewsSizeThePictureIsTheViews_data()
    {
        addColumn<bool>("smooth");
        newRow("edges as they are drawn") << false;
        newRow("smooth edges") << true;
    }

    void atTheViewsSizeThePictureIsTheViews()
    {
        QFETCH(bool, smooth);
        const auto window = pickedCube();
        window->view().setSmoothEdges(smooth);
        landmarks::Landmark landmark;
        landmark.name = "corner";
        landmark.world = WorldPoint(kCubeCenter + glm::dvec3(1.0, 1.0, 1.0));
        QVERIFY(editLandmarks(window->document(), {landmark}, EditLabel{QStringLiteral("edit")}));
        settle();
        const QImage view = window->view().grabFramebuffer();
        const QImage picture = pictureOf(*window, {surfaceOf(*window), {}, false});
        QCOMPARE(picture.size(), view.size());
        QCOMPARE(differentPixels(picture, view.convertToFormat(picture.format())), 0);
    }

    void atTwiceTheSizeThePickIsWhereItIsProjected()
    {
        const auto window = pickedCube();
        const Surface large = twice(surfaceOf(*window));
        PictureOptions options{large, kNoMarks, false};
        const QImage without = pictureOf(*window, options);
        options.marks.pick = true;
        const QImage with = pictureOf(*window, options);
        QCOMPARE(with.size(), sizeOf(large));
        // Only the pick's mark differs: it is around the projected point, equally wide and high.
        const glm::dvec2 place = 2.0 * placeOf(*window, picked(*window));
        const QPoint at(int(place.x), large.heightPixels - 1 - int(place.y));
        const int half = int(4.0 * large.devicePixelRatio);
        const QRect around = QRect(at - QPoint(half, half), QSize(2 * half + 1, 2 * half + 1));
        const QRect changed = differences(without.copy(around), with.copy(around));
        QVERIFY2(std::abs(changed.center().x() - half) <= 2 && std::abs(changed.center().y() - half) <= 2,
                 qPrintable(QStringLiteral("%1, %2").arg(changed.center().x()).arg(changed.center().y())));
        QVERIFY(without.pixel(at) != with.pixel(at));
    }

    void aPictureOfAnotherShapeShowsWhatIsBesideTheView()
    {
        const auto window = pickedCube();
        Surface wide = surfaceOf(*window);
        wide.widthPixels += 200;
        const QImage view = pictureOf(*window, {surfaceOf(*window), kNoMarks, false});
        const QImage picture = pictureOf(*window, {wide, kNoMarks, false});
        QCOMPARE(picture.size(), sizeOf(wide));
        QVERIFY(differentPixels(picture.copy(100, 0, view.width(), view.height()), view) < view.width());
    }

    void marksAreLeftOut_data()
    {
        addColumn<bool PictureMarks::*>("mark");
        newRow("the pick") << &PictureMarks::pick;
        newRow("landmarks") << &PictureMarks::landmarks;
        newRow("the ground") << &PictureMarks::grid;
        newRow("axes") << &PictureMarks::axes;
    }

    void marksAreLeftOut()
    {
        QFETCH(bool PictureMarks::*, mark);
        const auto window = pickedCube();
        landmarks::Landmark landmark;
        landmark.name = "corner";
        landmark.world = WorldPoint(kCubeCenter + glm::dvec3(1.0, 1.0, 1.0));
        QVERIFY(editLandmarks(window->document(), {landmark}, EditLabel{QStringLiteral("edit")}));
        const QImage none = pictureOf(*window, {surfaceOf(*window), kNoMarks, false});
        const QImage all = pictureOf(*window, {surfaceOf(*window), {}, false});
        PictureMarks one = kNoMarks, others;
        one.*mark = true;
        others.*mark = false;
        QVERIFY(differentPixels(pictureOf(*window, {surfaceOf(*window), one, false}), none) > 0);
        QVERIFY(differentPixels(pictureOf(*window, {surfaceOf(*window), others, false}), all) > 0);
    }

    void aTransparentPictureHasTheObjectsAlone()
    {
        const auto window = pickedCube();
        for (const bool smooth : {false, true}) {
            window->view().setSmoothEdges(smooth);
            const QImage opaque = pictureOf(*window, {surfaceOf(*window), kNoMarks, false});
            const QImage picture = pictureOf(*window, {surfaceOf(*window), kNoMarks, true});
            QVERIFY(picture.hasAlphaChannel());
            QVERIFY(!opaque.hasAlphaChannel());
            QCOMPARE(qAlpha(picture.pixel(2, 2)), 0);
            const QPoint cube = localOf(*window, kCubeCenter + glm::dvec3(0.0, 0.0, 1.0)).toPoint();
            const QPoint pixel = cube * surfaceOf(*window).devicePixelRatio;
            QCOMPARE(qAlpha(picture.pixel(pixel)), 255);
            QCOMPARE(picture.pixelColor(pixel).rgb(), opaque.pixelColor(pixel).rgb());
            // Over the same background, an edge is no darker than it is in the view.
            int between = 0;
            for (int x = 0; x < picture.width(); ++x) {
                const int alpha = qAlpha(picture.pixel(x, pixel.y()));
                between += alpha > 0 && alpha < 255;
            }
            QVERIFY(smooth ? between > 0 : between == 0);
        }
    }

    void theViewStaysAsItIs()
    {
        const auto window = pickedCube();
        const QImage before = window->view().grabFramebuffer();
        const Setup setup = window->document().setup();
        int told = 0;
        QObject context;
        connect(&window->document(), &SceneDocument::changed, &context, [&told] { ++told; });
        QVERIFY(!pictureOf(*window, {twice(surfaceOf(*window)), {}, true}).isNull());
        QCOMPARE(told, 0);
        QVERIFY(window->document().setup() == setup);
        QVERIFY(!window->document().picks().sinceClick().isAnything());
        QCOMPARE(differentPixels(window->view().grabFramebuffer(), before), 0);
        // Clicks are read as before.
        const glm::dvec3 point = picked(*window);
        window->view().pickPixel(window->document().picks().pick()->devicePixel);
        QCOMPARE(picked(*window), point);
    }

    void thePictureIsInTheFile()
    {
        const auto window = pickedCube();
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdU16String()) / u8"Bild ä.png";
        const PictureOptions options{{640, 480, 1.0}, {}, true};
        QCOMPARE(writePicture(window->view(), options, file), QString());
        const QImage read(folder.filePath(QStringLiteral("Bild ä.png")));
        QCOMPARE(read.size(), QSize(640, 480));
        QVERIFY(read.hasAlphaChannel());
    }

    void aFileThatCannotBeWrittenIsTold()
    {
        const auto window = pickedCube();
        const QTemporaryDir folder;
        const std::filesystem::path file = std::filesystem::path(folder.path().toStdU16String()) / "none" / "a.png";
        QVERIFY(!writePicture(window->view(), {{64, 48, 1.0}, {}, true}, file).isEmpty());
    }

    void theFormIsAsTheViewAtFirst()
    {
        const auto window = pickedCube();
        const ExportPictureDialog dialog(window->view());
        const PictureOptions options = dialog.options();
        QVERIFY(options.surface == surfaceOf(*window));
        QVERIFY(options.marks.pick && options.marks.landmarks && options.marks.curves && options.marks.grid
                && options.marks.axes);
        QVERIFY(!options.isTransparent);
        QCOMPARE(dialog.problem(), QString());
        QVERIFY(!checkBox(dialog, "Error map")->isEnabled());
        checkBox(dialog, "Pick")->setChecked(false);
        checkBox(dialog, "Transparent background")->setChecked(true);
        QVERIFY(!dialog.options().marks.pick);
        QVERIFY(dialog.options().isTransparent);
    }

    void theSidesKeepTheProportions()
    {
        const auto window = pickedCube();
        const ExportPictureDialog dialog(window->view());
        const Surface view = surfaceOf(*window);
        boxNamed<QSpinBox>(dialog, "Width")->setValue(2 * view.widthPixels);
        QVERIFY(dialog.options().surface == twice(view));
        boxNamed<QSpinBox>(dialog, "Height")->setValue(view.heightPixels);
        QVERIFY(dialog.options().surface == view);
        checkBox(dialog, "Keep the view's proportions")->setChecked(false);
        boxNamed<QSpinBox>(dialog, "Width")->setValue(100);
        const Surface narrow{100, view.heightPixels, view.devicePixelRatio};
        QVERIFY(dialog.options().surface == narrow);
    }

    void aSizeThatTheDriverCannotDrawIsRefused()
    {
        const auto window = pickedCube();
        const int largest = window->view().largestPicture();
        QVERIFY(largest >= 1024);
        const ExportPictureDialog dialog(window->view());
        const auto isRefused = [&dialog] {
            for (const QPushButton *button : dialog.findChildren<QPushButton *>()) {
                if (button->text().remove(u'&') == QStringLiteral("Export…"))
                    return !button->isEnabled();
            }
            return false;
        };
        QVERIFY(!isRefused());
        checkBox(dialog, "Keep the view's proportions")->setChecked(false);
        boxNamed<QSpinBox>(dialog, "Width")->setValue(largest + 1);
        QVERIFY(isRefused());
        QVERIFY2(dialog.problem().contains(QString::number(largest)), qPrintable(dialog.problem()));
        boxNamed<QSpinBox>(dialog, "Width")->setValue(largest);
        QVERIFY(!isRefused());
        boxNamed<QSpinBox>(dialog, "Height")->setValue(largest);
        QCOMPARE(isRefused(), double(largest) * largest > 64e6);
    }
};

UNPROJECTOR_TEST(TestExportPicture, display)
#include "test_export_picture.moc"
