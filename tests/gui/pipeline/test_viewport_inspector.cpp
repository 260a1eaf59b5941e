// The numbers of the inspector, read from its table and its texts: literal, worked out by hand.

#include "tests/support/test.h"

#include "core/examples/examples.h"
#include "gui/document/camera_looks.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/corners_model.h"
#include "gui/pipeline/viewport_inspector.h"
#include "gui/text/proportion_text.h"
#include "tests/gui/depth_ranges.h"
#include "tests/gui/document_edits.h"
#include "tests/support/patience.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QLabel>
#include <QSignalSpy>
#include <QTableView>
#include <QTextDocument>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::scene;

namespace {

/// A few roundings of numbers up to 4000.
constexpr double kRounding = 1e-11;

QPointF cell(const CornersModel &model, int row, int column)
{
    return model.index(row, column).data(CornersModel::kValueRole).toPointF();
}

bool isAt(const CornersModel &model, int row, int column, double x, double y)
{
    const QPointF p = cell(model, row, column);
    if (std::abs(p.x() - x) < kRounding && std::abs(p.y() - y) < kRounding)
        return true;
    qWarning("row %d, column %d: (%.17g, %.17g) is not (%.17g, %.17g)", row, column, p.x(), p.y(), x, y);
    return false;
}

/// Collapses runs of blanks: the padding is not tested.
QString plain(const QString &text)
{
    return text.simplified().replace(QStringLiteral("( "), QStringLiteral("("));
}

void giveProjection(SceneDocument &document, const Projection &projection,
                    ViewportRule::Kind rule = ViewportRule::Kind::WholeWindow)
{
    ViewportRule viewport;
    viewport.kind = rule;
    QVERIFY(editViewport(document, viewport, document.scene().depthRange, {QStringLiteral("Viewport")}));
    QVERIFY(editProjection(document, {projection, false, false}, {QStringLiteral("Projection")}));
}

QLabel *labelNamed(const QWidget &panel, const QString &accessibleName)
{
    for (QLabel *label : panel.findChildren<QLabel *>()) {
        if (label->accessibleName() == accessibleName)
            return label;
    }
    return nullptr;
}

} // namespace

class TestViewportInspector : public QObject {
    Q_OBJECT

private slots:
    void cornersInAllSpaces_data()
    {
        addColumn<Surface>("surface");
        addColumn<int>("row");
        addColumn<QPointF>("widget");
        addColumn<QPointF>("device");
        addColumn<QPointF>("window");
        addColumn<QPointF>("ndc");
        const auto row = [](const char *name, const Surface &surface, int which, QPointF widget, QPointF device,
                            QPointF window,
                            QPointF ndc) { newRow(name) << surface << which << widget << device << window << ndc; };
        // opencascade-transforms, fig. 4.1: the centre of 300 x 300 is (150, 150).
        row("opencascade centre", {300, 300, 1.0}, CornersModel::Centre, {150, 150}, {150, 150}, {150.5, 149.5},
            {1 / 300.0, -1 / 300.0});
        const Surface at1{400, 300, 1.0}, at125{500, 375, 1.25}, at2{800, 600, 2.0};
        row("top-left@1x", at1, CornersModel::TopLeft, {0, 0}, {0, 0}, {0.5, 299.5}, {-0.9975, 299 / 300.0});
        row("top-right@1x", at1, CornersModel::TopRight, {399, 0}, {399, 0}, {399.5, 299.5}, {0.9975, 299 / 300.0});
        row("bottom-left@1x", at1, CornersModel::BottomLeft, {0, 299}, {0, 299}, {0.5, 0.5}, {-0.9975, -299 / 300.0});
        row("bottom-right@1x", at1, CornersModel::BottomRight, {399, 299}, {399, 299}, {399.5, 0.5},
            {0.9975, -299 / 300.0});
        row("centre@1x", at1, CornersModel::Centre, {200, 150}, {200, 150}, {200.5, 149.5}, {0.0025, -1 / 300.0});
        row("top-left@1.25x", at125, CornersModel::TopLeft, {0, 0}, {0, 0}, {0.5, 374.5}, {-0.998, 374 / 375.0});
        row("bottom-right@1.25x", at125, CornersModel::BottomRight, {399.2, 299.2}, {499, 374}, {499.5, 0.5},
            {0.998, -374 / 375.0});
        row("bottom-right@2x", at2, CornersModel::BottomRight, {399.5, 299.5}, {799, 599}, {799.5, 0.5},
            {799 / 800.0, -599 / 600.0});
        row("centre@2x", at2, CornersModel::Centre, {200, 150}, {400, 300}, {400.5, 299.5}, {1 / 800.0, -1 / 600.0});
    }

    void cornersInAllSpaces()
    {
        QFETCH(Surface, surface);
        QFETCH(int, row);
        SceneDocument document;
        document.setSurface(surface);
        const ViewportInspector panel(document);
        const char *names[] = {"widget", "device", "window", "ndc"};
        for (int column = 0; column < CornersModel::ColumnCount; ++column) {
            const QPointF expected = *static_cast<const QPointF *>(QTest::qData(names[column], qMetaTypeId<QPointF>()));
            QVERIFY(isAt(panel.corners(), row, column, expected.x(), expected.y()));
        }
    }

    void aQuarterViewportMovesNdcOnly()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        giveProjection(document, Ortho{-10, 10, -10, 10, 1, 100}, ViewportRule::Kind::Quarter);
        const ViewportInspector panel(document);
        QCOMPARE(labelNamed(panel, "Viewport")->text(), QStringLiteral("glViewport(400, 0, 400, 300)"));
        QVERIFY(isAt(panel.corners(), CornersModel::BottomRight, CornersModel::Window, 799.5, 0.5));
        QVERIFY(isAt(panel.corners(), CornersModel::BottomRight, CornersModel::Ndc, 0.9975, -299 / 300.0));
        QVERIFY(isAt(panel.corners(), CornersModel::TopLeft, CornersModel::Window, 0.5, 599.5));
        QVERIFY(isAt(panel.corners(), CornersModel::TopLeft, CornersModel::Ndc, -2.9975, 599.5 / 150.0 - 1.0));
        // Rows outside the viewport look different.
        const auto ink = [&panel](int row) {
            return panel.corners().index(row, CornersModel::Ndc).data(Qt::ForegroundRole);
        };
        QVERIFY(ink(CornersModel::TopLeft).isValid());
        QVERIFY(!ink(CornersModel::BottomRight).isValid());
    }

    void theDepthRangeMovesNothing_data() { depthranges::addRows(); }

    void theDepthRangeMovesNothing()
    {
        for (const Projection &projection :
             {Projection(Frustum{-1, 1, -1, 1, 1, 100}), Projection(Ortho{-9, 9, -2, 2, 1, 9})}) {
            SceneDocument document;
            document.setSurface({800, 600, 1.0});
            giveProjection(document, projection);
            ViewportInspector panel(document);
            panel.show();
            panel.setPointer(WidgetPoint(412.0, 300.0));
            const auto copied = [&] {
                QApplication::clipboard()->clear();
                panel.actions().constFirst()->trigger();
                return QApplication::clipboard()->text();
            };
            const QString whole = copied();
            QVERIFY(whole.contains(QStringLiteral("Pointer\t412\t300\t412\t300\t412.5\t299.5\t0.03125\t")));
            QVERIFY(editViewport(document, document.scene().viewport, depthranges::ofThisRow(),
                                 {QStringLiteral("Depths")}));
            QCOMPARE(copied(), whole);
        }
    }

    void thePointersRowFollowsIt()
    {
        SceneDocument document;
        document.setSurface({500, 375, 1.25});
        ViewportInspector panel(document);
        panel.show();
        const CornersModel &corners = panel.corners();
        QVERIFY(!corners.index(CornersModel::Pointer, 0).data(CornersModel::kValueRole).isValid());
        panel.setPointer(WidgetPoint(399.0, 299.0));
        QVERIFY(isAt(corners, CornersModel::Pointer, CornersModel::Widget, 399, 299));
        QVERIFY(isAt(corners, CornersModel::Pointer, CornersModel::Device, 498, 373));
        QVERIFY(isAt(corners, CornersModel::Pointer, CornersModel::Window, 498.5, 1.5));
        QVERIFY(isAt(corners, CornersModel::Pointer, CornersModel::Ndc, 0.994, -372 / 375.0));
        panel.setPointer(WidgetPoint(400.0, 10.0)); // one pixel beyond the right edge
        QVERIFY(!corners.index(CornersModel::Pointer, 0).data(CornersModel::kValueRole).isValid());
        panel.setPointer(WidgetPoint(0.0, 0.0));
        QVERIFY(isAt(corners, CornersModel::Pointer, CornersModel::Window, 0.5, 374.5));
        panel.clearPointer();
        QVERIFY(!corners.index(CornersModel::Pointer, 0).data(CornersModel::kValueRole).isValid());
        QCOMPARE(corners.index(CornersModel::Pointer, 0).data().toString(), QStringLiteral("–"));
    }

    void theProportionsHaveTheirNumbers_data()
    {
        addColumn<Projection>("projection");
        addColumn<Viewport>("viewport");
        addColumn<QString>("x");
        addColumn<QString>("y");
        // The pointer's pixel has its centre at (412.5, 299.5) in a window of 800 x 600.
        newRow("symmetric box") << Projection(Ortho{-0.83, 0.83, -0.83, 0.83, 1, 100}) << Viewport{0, 0, 800, 600}
                                << "(3) (0.0259 − (−0.83)) / (0.83 − (−0.83)) = (412.5 − 0) / 800 = 0.5156"
                                << "(4) (−0.0014 − (−0.83)) / (0.83 − (−0.83)) = (299.5 − 0) / 600 = 0.4992";
        newRow("quarter viewport") << Projection(Ortho{-10, 10, -10, 10, 1, 100}) << Viewport{400, 0, 400, 300}
                                   << "(3) (−9.375 − (−10)) / (10 − (−10)) = (412.5 − 400) / 400 = 0.0313"
                                   << "(4) (9.967 − (−10)) / (10 − (−10)) = (299.5 − 0) / 300 = 0.9983";
        newRow("outside, mirrored") << Projection(Ortho{4, 2, 2, 4, 1, 100}) << Viewport{-100, 300, 500, 300}
                                    << "(3) (1.9500 − 4) / (2 − 4) = (412.5 − (−100)) / 500 = 1.0250"
                                    << "(4) (1.9967 − 2) / (4 − 2) = (299.5 − 300) / 300 = −0.0017";
    }

    void theProportionsHaveTheirNumbers()
    {
        QFETCH(Projection, projection);
        QFETCH(Viewport, viewport);
        QFETCH(QString, x);
        QFETCH(QString, y);
        const Setup setup{{800, 600, 1.0}, viewport, {}, projection, {}};
        const WindowPoint pointer(412.5, 299.5, 0.0);
        QCOMPARE(plain(proportionText(setup, Axis::X, pointer).line()), x);
        QCOMPARE(plain(proportionText(setup, Axis::Y, pointer).line()), y);
        QCOMPARE(proportionText(setup, Axis::X, pointer).symbols,
                 QStringLiteral("(3) (x_w − left) / (right − left) = (x_v − vx) / width"));
        const QString without = plain(proportionText(setup, Axis::Y, std::nullopt).line());
        QVERIFY2(without.startsWith(QStringLiteral("(4) (y_w − ")) && without.contains(QStringLiteral("(y_v − ")),
                 qPrintable(without));
    }

    void indexesAreSetAsSuch()
    {
        const QString markup =
            proportionMarkup(QStringLiteral("(3) (x_w − left) = (x_v − vx) / width\n  = (y_v − vy)"));
        QVERIFY2(markup.contains(QStringLiteral("(x<sub>w</sub> − left) = (x<sub>v</sub> − v<sub>x</sub>) / width<br>"
                                                "  = (y<sub>v</sub> − v<sub>y</sub>)")),
                 qPrintable(markup));
        // The panel does the same, and copied words stay plain.
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        ViewportInspector panel(document);
        panel.resize(900, 400);
        panel.show();
        const QString symbols = labelNamed(panel, "Proportion (3)")->text();
        QVERIFY2(symbols.contains(QStringLiteral("(x<sub>w</sub> − left)")), qPrintable(symbols));
        const QLabel *numbers = labelNamed(panel, "Numbers of proportion (4)");
        QVERIFY2(numbers->text().contains(QStringLiteral("(y<sub>v</sub> − 0) / 600")), qPrintable(numbers->text()));
        QVERIFY2(panel.text().contains(QStringLiteral("(x_w - ")), qPrintable(panel.text()));

        panel.setPointer(WidgetPoint(412.0, 300.0));
        QVERIFY2(numbers->text().endsWith(QStringLiteral("= (299.5 − 0) / 600 = 0.4992")), qPrintable(numbers->text()));
        panel.clearPointer();
        QCOMPARE(numbers->textFormat(), Qt::RichText);
    }

    void textsOfThePointerKeepTheirWidth()
    {
        const Setup setup{{800, 600, 1.0}, {0, 0, 800, 600}, {}, Ortho{-12, 9, -1, 1, 1, 100}, {}};
        const QString first = proportionText(setup, Axis::X, WindowPoint(0.5, 0.5, 0.0)).line();
        for (const double x : {9.5, 99.5, 456.5, 457.5, 799.5})
            QCOMPARE(proportionText(setup, Axis::X, WindowPoint(x, 0.5, 0.0)).line().size(), first.size());
    }

    void aDistortedCircleIsNamed_data()
    {
        addColumn<Projection>("projection");
        addColumn<QString>("text");
        addColumn<bool>("isMarked");
        newRow("glFrustum +-1 at 800x600") << Projection(Frustum{-1, 1, -1, 1, 1, 100})
                                           << "A circle would be drawn 1.33 : 1, wider than high." << true;
        newRow("gluPerspective of the aspect")
            << Projection(Perspective{0.8, 4.0 / 3.0, 1, 100}) << "A circle is drawn as a circle." << false;
        newRow("too wide a box") << Projection(Ortho{-4, 4, -1, 1, 1, 100})
                                 << "A circle would be drawn 0.333 : 1, higher than wide." << true;
        newRow("a third of a percent") << Projection(Perspective{0.8, 4.0 / 3.01, 1, 100})
                                       << "A circle is drawn as a circle." << false;
    }

    void aDistortedCircleIsNamed()
    {
        QFETCH(Projection, projection);
        QFETCH(QString, text);
        QFETCH(bool, isMarked);
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        giveProjection(document, projection);
        const ViewportInspector panel(document);
        const QLabel *label = labelNamed(panel, "Shape of a circle");
        QCOMPARE(label->text(), text);
        QCOMPARE(label->font().bold(), isMarked);
    }

    void thePanelFollowsEveryResize()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        ViewportInspector panel(document);
        panel.show();
        panel.setPointer(WidgetPoint(700.0, 10.0));
        document.setSurface({500, 375, 1.25}); // 400 x 300 logical: the pointer is outside now
        QVERIFY(labelNamed(panel, "Window")
                    ->text()
                    .startsWith(QStringLiteral("Window 500 × 375 device pixels, device pixel ratio 1.25 <a ")));
        QVERIFY(panel.text().startsWith(QStringLiteral("Window 500 × 375 device pixels, device pixel ratio 1.25\n")));
        QCOMPARE(labelNamed(panel, "Viewport")->text(), QStringLiteral("glViewport(0, 0, 500, 375)"));
        QVERIFY(isAt(panel.corners(), CornersModel::BottomRight, CornersModel::Device, 499, 374));
        QVERIFY(!panel.corners().index(CornersModel::Pointer, 0).data(CornersModel::kValueRole).isValid());
        document.setSurface({1000, 750, 1.25});
        QVERIFY(isAt(panel.corners(), CornersModel::Pointer, CornersModel::Device, 875, 12));
    }

    void hiddenItDoesNothing()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        ViewportInspector panel(document);
        QSignalSpy changes(&panel.corners(), &QAbstractItemModel::dataChanged);
        panel.setPointer(WidgetPoint(10.0, 20.0));
        document.setSurface({400, 300, 1.0});
        QCOMPARE(changes.count(), 0);
        panel.show();
        QVERIFY(isAt(panel.corners(), CornersModel::Pointer, CornersModel::Window, 10.5, 279.5));
        QVERIFY(isAt(panel.corners(), CornersModel::TopRight, CornersModel::Device, 399, 0));
        // A camera that moves does not change this picture.
        changes.clear();
        QVERIFY(
            editProjection(document, {document.scene().projection, true, false}, {QStringLiteral("Clip distances")}));
        changes.clear();
        LookAt camera = document.setup().camera();
        camera.eye.x += 1.0;
        setCamera(document, camera);
        QCOMPARE(changes.count(), 0);
    }

    void everythingCanBeCopied()
    {
        SceneDocument document;
        document.setSurface({800, 600, 1.0});
        giveProjection(document, Frustum{-1, 1, -1, 1, 1, 100});
        ViewportInspector panel(document);
        panel.show();
        panel.setPointer(WidgetPoint(412.0, 300.0));
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
        panel.actions().constFirst()->trigger();
        const QString text = QApplication::clipboard()->text();
        for (const char *part : {"Window 800 × 600", "glViewport(0, 0, 800, 600)", "= (412.5 - 0) / 800 = 0.5156",
                                 "1.33 : 1", "Pointer\t412\t300\t412\t300\t412.5\t299.5\t0.03125\t"})
            QVERIFY2(text.contains(QString::fromUtf8(part)), qPrintable(text));
    }

    void atAnyWidthNothingIsCutOff_data()
    {
        addColumn<int>("width");
        for (const int width : {620, 700, 900, 1280, 2000})
            addRow("%d", width) << width;
    }

    void atAnyWidthNothingIsCutOff()
    {
#ifdef _WIN32
        QSKIP("The widths are those of the fonts that the layout is judged by, DejaVu's.");
#endif
        QFETCH(int, width);
        SceneDocument document;
        document.setSurface({1000, 750, 1.25});
        ViewportInspector panel(document);
        panel.resize(width, 190);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel, kPatienceMilliseconds));
        panel.setPointer(WidgetPoint(412.0, 300.0));
        QVERIFY2(panel.minimumSizeHint().width() <= 620, qPrintable(QString::number(panel.minimumSizeHint().width())));
        for (const QLabel *label : panel.findChildren<QLabel *>()) {
            if (!label->isVisible())
                continue;
            const QRect there(label->mapTo(&panel, QPoint(0, 0)), label->size());
            QVERIFY2(panel.rect().contains(there), qPrintable(label->text()));
            QTextDocument set;
            set.setDocumentMargin(0.0);
            set.setDefaultFont(label->font());
            if (label->textFormat() == Qt::RichText)
                set.setHtml(label->text());
            else
                set.setPlainText(label->text());
            QVERIFY2(set.idealWidth() <= label->width(), qPrintable(label->text()));
        }
        const auto *table = panel.findChild<QTableView *>();
        QVERIFY(table->isVisible() || labelNamed(panel, "Proportion (3)")->isVisible());
        if (table->isVisible())
            QVERIFY(panel.rect().contains(QRect(table->mapTo(&panel, QPoint(0, 0)), table->size())));
    }
};

UNPROJECTOR_TEST(TestViewportInspector)
#include "test_viewport_inspector.moc"
