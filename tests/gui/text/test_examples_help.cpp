// The page of formulas is complete, and the pipeline panel shows the tutorials' numbers for their
// scenes.

#include "tests/support/test.h"

#include "core/geometry/api_conventions.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/formulas_window.h"
#include "gui/pipeline/pipeline_model.h"
#include "gui/shell/appearance.h"
#include "gui/text/formula_markup.h"
#include "tests/support/errata.h"
#include "tests/support/example_scene.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSet>
#include <QTextBrowser>
#include <QTextDocumentFragment>

#include <algorithm>
#include <cmath>
#include <string_view>

using namespace unprojector;
using namespace unprojector::gui;
using namespace unprojector::geometry;
using namespace unprojector::pipeline;

namespace {

QString source()
{
    QFile file(QStringLiteral(":/help/formulas.html"));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// The page's anchors.
QSet<QString> anchors()
{
    QSet<QString> names;
    static const QRegularExpression name(QStringLiteral("<a name=['\"]([^'\"]+)['\"]"));
    const QString page = typeset(source());
    for (auto matches = name.globalMatch(page); matches.hasNext();)
        names.insert(matches.next().captured(1));
    return names;
}

QString plain(const QString &html)
{
    return QTextDocumentFragment::fromHtml(html).toPlainText().simplified();
}

} // namespace

/// The share of the page that is light.
double lightShare(FormulasWindow &window)
{
    const QImage picture = window.page().grab().toImage();
    int light = 0, all = 0;
    for (int y = 0; y < picture.height(); y += 7) {
        for (int x = 0; x < picture.width() - 30; x += 7, ++all)
            light += qGray(picture.pixel(x, y)) > 200 ? 1 : 0;
    }
    return static_cast<double>(light) / all;
}

/// The longest light vertical line, for a page with a matrix at its top.
int longestLightLine(FormulasWindow &window)
{
    window.showFormula(QStringLiteral("ortho"));
    const QImage picture = window.page().viewport()->grab().toImage();
    int longest = 0;
    for (int x = 0; x < picture.width(); ++x) {
        for (int y = 0, length = 0; y < picture.height(); ++y) {
            length = qGray(picture.pixel(x, y)) > 150 ? length + 1 : 0;
            longest = std::max(longest, length);
        }
    }
    return longest;
}

class TestExamplesHelp : public QObject {
    Q_OBJECT

private slots:
    void thePipelineShowsTheFigures_data()
    {
        using Stage = PipelineStage;
        addColumn<QByteArray>("id");
        addColumn<int>("stage");
        addColumn<int>("row");
        addColumn<int>("column");
        addColumn<double>("expected");
        newRow("fig. 2.7: m[14]") << QByteArray("zhangci-model-view") << int(Stage::ModelviewMatrix) << 2 << 3 << -8.0;
        newRow("fig. 2.10: m[10]") << QByteArray("zhangci-ortho") << int(Stage::ProjectionMatrix) << 2 << 2 << -0.1;
        newRow("fig. 2.12: m[14]") << QByteArray("zhangci-perspective") << int(Stage::ProjectionMatrix) << 2 << 3
                                   << -2.0202019;
        newRow("hand-made matrix: m[0]") << QByteArray("derivation-matrix") << int(Stage::ProjectionMatrix) << 0 << 0
                                         << 1.33333333;
        newRow("gluPerspective: m[0]") << QByteArray("derivation-perspective") << int(Stage::ProjectionMatrix) << 0 << 0
                                       << 0.75;
        newRow("2-D: MC") << QByteArray("zhangci-2d") << int(Stage::ModelMatrix) << 0 << 3 << 4.0;
    }

    void thePipelineShowsTheFigures()
    {
        QFETCH(QByteArray, id);
        QFETCH(int, stage);
        QFETCH(int, row);
        QFETCH(int, column);
        QFETCH(double, expected);
        SceneDocument document;
        document.setSurface({900, 600, 1.0});
        QVERIFY(document.open(sceneOfExample(id.toStdString())));
        PipelineModel model(document);
        model.setObject(0);
        model.update();
        const MatrixModel *matrix = model.matrix(static_cast<PipelineStage>(stage));
        const QVariant value = matrix->index(row, column).data(NumberGridModel::kValueRole);
        QVERIFY(value.isValid());
        QVERIFY2(std::abs(value.toDouble() - expected) <= 2.5e-7,
                 qPrintable(QString::number(value.toDouble(), 'g', 17)));
    }

    void theShortFormIsSet_data()
    {
        addColumn<QString>("page");
        addColumn<int>("tables");
        addColumn<QString>("text");
        const QString around = QStringLiteral("a<formula>%1</formula>b");
        // A formula is a table; a row with a built-up part is another, and each fraction and matrix one
        // more.
        newRow("nothing") << QStringLiteral("a|b {c}") << 0 << QStringLiteral("a|b {c}");
        newRow("words") << around.arg(QStringLiteral("x = 2 y")) << 1 << QStringLiteral("a x = 2 y b");
        newRow("fraction") << around.arg(QStringLiteral("{x | n} + 1")) << 3 << QStringLiteral("a x n + 1 b");
        newRow("matrix") << around.arg(QStringLiteral("{a, 0; 0, b}")) << 3 << QStringLiteral("a a 0 0 b b");
        newRow("column") << around.arg(QStringLiteral("M {x; y; 1}")) << 3 << QStringLiteral("a M x y 1 b");
        newRow("fraction in a matrix") << around.arg(QStringLiteral("{−{r + l | r − l}, 0; 0, 1}")) << 5
                                       << QStringLiteral("a − r + l r − l 0 0 1 b");
        newRow("unclosed") << around.arg(QStringLiteral("{a, b")) << 3 << QStringLiteral("a a b b");
    }

    void theShortFormIsSet()
    {
        QFETCH(QString, page);
        QFETCH(int, tables);
        QFETCH(QString, text);
        const QString set = typeset(page);
        QCOMPARE(int(set.count(QLatin1String("<table"))), tables);
        QCOMPARE(int(set.count(QLatin1String("</table"))), tables);
        QCOMPARE(int(set.count(QLatin1String("<tr"))), int(set.count(QLatin1String("</tr"))));
        QCOMPARE(int(set.count(QLatin1String("<td"))), int(set.count(QLatin1String("</td"))));
        QCOMPARE(plain(set), text);
    }

    void nothingOfTheShortFormIsLeft()
    {
        QVERIFY(!source().isEmpty());
        const QString set = typeset(source());
        QVERIFY(!set.contains(QLatin1String("formula>")));
        const QString text = plain(set);
        for (const char *left : {"{", "}", " | "})
            QVERIFY2(!text.contains(QLatin1String(left)), left);
    }

    void everyFormulaIsThereWithItsSource_data()
    {
        addColumn<int>("number");
        for (int number = 1; number <= 16; ++number)
            addRow("(%d)", number) << number;
    }

    void everyFormulaIsThereWithItsSource()
    {
        QFETCH(int, number);
        const QString page = source();
        const qsizetype at = page.indexOf(QStringLiteral("<formula no=\"%1\"").arg(number));
        QVERIFY(at > 0);
        // Each formula is printed once, and its source follows before the next heading.
        QCOMPARE(page.count(QStringLiteral("<formula no=\"%1\"").arg(number)), 1);
        const qsizetype sourceAt = page.indexOf(QLatin1String("<p class=\"source\">"), at);
        QVERIFY(sourceAt > at && sourceAt < page.indexOf(QLatin1String("<h2"), at));
        QVERIFY(plain(typeset(page)).contains(QStringLiteral("(%1)").arg(number)));
        static const QRegularExpression anchor(QStringLiteral(" name=\"([^\"]+)\">"));
        const QString name = anchor.match(page, at).captured(1);
        QVERIFY(name.size() >= 2 && page.indexOf(name, at) < page.indexOf(u'>', at) && anchors().contains(name));
    }

    void everyErrorIsThere_data()
    {
        addColumn<QString>("printed");
        addColumn<QString>("right");
        const auto row = [](const char *anchor, const char *printed, const char *right) {
            newRow(anchor) << QString::fromUtf8(printed) << QString::fromUtf8(right);
        };
        row("error-weng-sign", "z, without a sign", "distance in front of the eye");
        row("error-weng-row", "yv = rect.bottom − py", "½ lower");
        row("error-weng-x-axis", "x axis points left", "right");
        row("error-weng-y-axis", "y axis points horizontally", "vertically");
        row("error-weng-look-at", "from (cx, cy, cz) to (ex, ey, ez)", "from (ex, ey, ez), the eye, to (cx, cy, cz)");
        row("error-weng-near", "(xw, yw, near)", "(xw, yw, −near)");
        row("error-weng-clip-plane", "above the plane is cut off", "≥ 0");
        row("error-weng-depth", "(xv, yv, 0)", "0.625");
        row("error-weng-figure", "figure 2", "figure 5");
        row("error-weng-bottom", "m_rect.height, rect.bottom and m_rect.bottom", "the top of a client rectangle is 0");
        row("error-weng-eye", "coordinates of the view volume", "eye coordinates");
        row("error-weng-client", "screen", "in client coordinates");
        row("error-zhangci-product", "M = VC−1", "M = VC−1 · MC");
        row("error-zhangci-cube", "side 10, normalised to side 1", "20 and 2");
        row("error-zhangci-ortho", "−2/(znear − zfar)", "−2/(f − n)");
        row("error-zhangci-perspective", "+2.0202 for (45, 1, 1, 100)", "= −2.0202");
        row("error-zhangci-depth", "0.5 stays 0.5", "0.75");
        row("error-zhangci-height", "viewport[3] − y", "the framebuffer’s height");
        row("error-zhangci-object", "a world coordinate", "an object coordinate");
        row("error-derivation-three", "the same picture", "1.3333, the second 0.75");
        row("error-derivation-translate", "glTranslatef after glBegin", "translate before glBegin");
        row("error-derivation-undeclared", "nearz, farz", "are the first program’s");
        row("error-opencascade-model-view", "−ex, −ey, −ez, 1", "−e · u, −e · v, −e · n, 1");
        row("error-opencascade-world", "VVCS = VWCS · Mmodel-view", "by the view matrix alone");
        row("error-opencascade-ortho", "+(max + min)/(max − min)", "−(max + min)/(max − min)");
        row("error-opencascade-perspective", "+2 znear zfar/(znear − zfar)", "−2 znear zfar/(znear − zfar)");
        row("error-opencascade-viewport", "downwards in BuildNorm2ViewportMatrix", "no flip shows");
        row("error-opencascade-rows", "v · Mmodelview · Mprojection · Mviewport", "have to be transposed first");
        row("error-opencascade-depth", "only the depth z differs", "another point of the ray");
        row("error-parallel-range", "near ≤ z ≤ far", "−far ≤ z ≤ −near");
        row("error-parallel-flip", "from the right", "from the left");
        row("error-parallel-way", "by cot θ", "by cot θ · z");
        row("error-parallel-init", "void initApp", "opening brace");
        row("error-parallel-size", "const int SIZE = 4.5", "truncates to 4");
        row("error-parallel-integers", "int n=2, f=9", "+1/7 = 0.143");
        row("error-parallel-output", "gl_FragColor", "out vec4");
        row("error-parallel-cot", "π/4 ≈ 0.78", "1.01086");
    }

    void everyErrorIsThere()
    {
        QFETCH(QString, printed);
        QFETCH(QString, right);
        const QString page = source();
        const qsizetype begin = page.indexOf(QLatin1String("name=\"errors\"")),
                        end = page.indexOf(QLatin1String("</table>"), begin);
        static const QRegularExpression row(
            QStringLiteral("<tr><td><a name=\"([^\"]+)\"></a>[^\n]*?</td><td>(.*?)</td><td>(.*?)</td></tr>"));
        QByteArrayList anchors;
        bool isFound = false;
        for (auto matches = row.globalMatch(page.mid(begin, end - begin)); matches.hasNext();) {
            const QRegularExpressionMatch match = matches.next();
            anchors << match.captured(1).toLatin1();
            if (anchors.last() == QTest::currentDataTag()) {
                isFound = true;
                QVERIFY2(plain(match.captured(2)).contains(printed), qPrintable(plain(match.captured(2))));
                QVERIFY2(plain(match.captured(3)).contains(right), qPrintable(plain(match.captured(3))));
            }
        }
        QVERIFY(isFound);
        // Each anchor is one whose number test_source_errors computes.
        QCOMPARE(anchors, QByteArrayList(kErrata.begin(), kErrata.end()));
    }

    void theConventionsAreThoseComputedWith_data()
    {
        addColumn<int>("api");
        for (const Api api : kApis)
            newRow(conventionsOf(api).name) << int(api);
    }

    void theConventionsAreThoseComputedWith()
    {
        QFETCH(int, api);
        const ApiConventions &its = conventionsOf(static_cast<Api>(api));
        const QString page = source();
        const QString table =
            page.mid(page.indexOf(QLatin1String("name=\"conventions\""))).section(QLatin1String("</table>"), 0, 0);
        static const QRegularExpression cell(QStringLiteral("<td>(.*?)</td>"));
        QStringList cells;
        for (auto matches = cell.globalMatch(
                 table.section(QStringLiteral("<tr><td>%1</td>").arg(QLatin1String(its.name)), 1).section(u'\n', 0, 0));
             matches.hasNext();)
            cells << plain(matches.next().captured(1));
        QCOMPARE(cells.size(), 5);
        const bool hasNdc = its.key != std::string_view("opencv");
        QVERIFY(cells[0].startsWith(its.looksAlongPlusZ ? u'+' : u'−'));
        QVERIFY(cells[0].contains(its.isEyeYDown ? QLatin1String("y down") : QLatin1String("y up")));
        QCOMPARE(cells[0].contains(QLatin1String("world left-handed")), its.isWorldMirrored);
        QVERIFY(cells[1].startsWith(!hasNdc          ? QLatin1String("none")
                                    : its.isNdcYDown ? QLatin1String("down")
                                                     : QLatin1String("up")));
        QVERIFY(cells[2].startsWith(!hasNdc                               ? QStringLiteral("none")
                                    : its.ndcDepth == NdcDepth::ZeroToOne ? QStringLiteral("0 … 1")
                                                                          : QStringLiteral("−1 … 1")));
        QCOMPARE(cells[2].contains(QLatin1String("reversed")), its.isDepthReversed);
        QCOMPARE(cells[3], its.areVectorsRows ? QStringLiteral("rows") : QStringLiteral("columns"));
        QVERIFY(cells[4].startsWith(its.isOriginTop ? QLatin1String("top left") : QLatin1String("bottom left")));
        QCOMPARE(cells[4].contains(u'½'), its.pixelCentre == 0.5);
        QCOMPARE(cells[4].contains(QLatin1String("logical")), its.areLogicalPixels);
    }

    void theContentsLeadSomewhere()
    {
        static const QRegularExpression link(QStringLiteral("<a href=\"#([^\"]+)\""));
        const QSet<QString> names = anchors();
        const QString page = source();
        int links = 0;
        for (auto matches = link.globalMatch(page); matches.hasNext(); ++links) {
            const QString name = matches.next().captured(1);
            QVERIFY2(names.contains(name), qPrintable(name));
        }
        QVERIFY(links >= 10);

        FormulasWindow window;
        window.show();
        const QScrollBar *bar = window.page().verticalScrollBar();
        int last = -1;
        for (const char *name : {"contents", "forward", "ortho", "weng", "w9", "closed", "errors"}) {
            window.showFormula(QString::fromLatin1(name));
            QTRY_VERIFY2_WITH_TIMEOUT(bar->value() > last, name, kPatienceMilliseconds);
            last = bar->value();
        }
    }

    void thePageIsAsWideAsTheWindow_data()
    {
        addColumn<QSize>("size");
        addColumn<int>("percent");
        newRow("as it opens") << QSize(900, 700) << 100;
        newRow("wide") << QSize(1800, 900) << 100;
        newRow("smaller text") << QSize(900, 700) << 70;
    }

    void thePageIsAsWideAsTheWindow()
    {
        QFETCH(QSize, size);
        QFETCH(int, percent);
        FormulasWindow window;
        window.setZoomPercent(percent);
        window.resize(size);
        window.show();
        QTRY_COMPARE_WITH_TIMEOUT(window.page().horizontalScrollBar()->maximum(), 0, kPatienceMilliseconds);
        QVERIFY(window.page().verticalScrollBar()->maximum() > 1000);
    }

    void theTextIsZoomedWithinLimits()
    {
        FormulasWindow window;
        window.show();
        QCOMPARE(window.zoomPercent(), 100);
        QTest::keyClick(&window, Qt::Key_0, Qt::ControlModifier);
        QCOMPARE(window.zoomPercent(), 100);
        window.setZoomPercent(150);
        QCOMPARE(window.zoomPercent(), 150);
        for (const auto &[asked, given] : {std::pair(10, 60), std::pair(1000, 300)}) {
            window.setZoomPercent(asked);
            QCOMPARE(window.zoomPercent(), given);
        }
        window.setZoomPercent(100);
        QWheelEvent up({50, 50}, window.page().viewport()->mapToGlobal(QPointF(50, 50)), {}, {0, 120}, Qt::NoButton,
                       Qt::ControlModifier, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(window.page().viewport(), &up);
        QCOMPARE(window.zoomPercent(), 110);
    }

    void thePageIsDarkWhereTheWindowIs()
    {
        const Appearance before = currentAppearance();
        FormulasWindow window;
        window.show();
        QVERIFY(lightShare(window) > 0.8);
        setAppearance(Appearance::Dark);
        QTRY_VERIFY_WITH_TIMEOUT(lightShare(window) < 0.1, kPatienceMilliseconds);
        QVERIFY(longestLightLine(window) > 30); // of a matrix
        setAppearance(before);
        QTRY_VERIFY_WITH_TIMEOUT(lightShare(window) > 0.8, kPatienceMilliseconds);
    }
};

UNPROJECTOR_TEST(TestExamplesHelp)
#include "test_examples_help.moc"
