// The figures of Help: named by its pages, drawn in every size and colour.

#include "tests/support/test.h"

#include "gui/lessons/formulas_window.h"
#include "gui/text/figures/help_figures.h"
#include "gui/text/formula_layout.h"
#include "gui/text/translation.h"
#include "tests/support/patience.h"

#include <QFile>
#include <QFontMetricsF>
#include <QHelpEvent>
#include <QImage>
#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTextBrowser>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr double kPointSize = 11.0;

QString source(const QString &name)
{
    QFile file(QStringLiteral(":/help/") + name);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

struct Named {
    QString anchor; ///< the last one before it
    QString figure, words;
};

/// The figures of a page, in its order.
QList<Named> figuresOf(const QString &page)
{
    static const QRegularExpression expression(QStringLiteral(
        "<a name=\"([^\"]*)\"|<formula[^>]* name=\"([^\"]*)\"|<img src=\"figure:([^\"]*)\" alt=\"([^\"]*)\""));
    QList<Named> named;
    QString anchor;
    for (auto matches = expression.globalMatch(page); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        if (match.capturedLength(3) > 0)
            named.push_back({anchor, match.captured(3), match.captured(4)});
        else
            anchor = match.captured(1) + match.captured(2);
    }
    return named;
}

FigureColors colorsOf(bool isDark)
{
    return isDark ? FigureColors::of(Qt::white, QColor(0x7a, 0xb4, 0xf5), QColor(0x1f, 0x20, 0x23))
                  : FigureColors::of(Qt::black, QColor(0x1f, 0x4e, 0x8c), Qt::white);
}

QImage drawn(const QString &name, double ratio, bool isDark = false, double margin = 0.0)
{
    const QFont font = formulaFont(kPointSize);
    const QSizeF size = helpFigureSize(name, font);
    QImage image(((size + QSizeF(2.0 * margin, 2.0 * margin)) * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(colorsOf(isDark).paper);
    QPainter painter(&image);
    drawHelpFigure(painter, QRectF({margin, margin}, size), name, font, colorsOf(isDark));
    return image;
}

/// The parts of a figure.
struct Ink {
    struct Label {
        QString text;
        QRectF box; ///< of its ink
        QColor color;
    };
    std::vector<Label> labels;
    std::vector<QLineF> lines;
};

/// Draws nothing, and records the calls.
class InkEngine : public QPaintEngine {
public:
    InkEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice *) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState &) override {}
    Type type() const override { return User; }
    void drawPixmap(const QRectF &, const QPixmap &, const QRectF &) override {}
    void drawPath(const QPainterPath &) override {}
    void drawLines(const QLineF *lines, int count) override
    {
        for (int i = 0; i < count; ++i)
            ink.lines.push_back(state->transform().map(lines[i]));
    }
    void drawPolygon(const QPointF *points, int count, PolygonDrawMode mode) override
    {
        for (int i = 1; i < count && mode == PolylineMode; ++i)
            ink.lines.push_back(state->transform().map(QLineF(points[i - 1], points[i])));
    }
    void drawTextItem(const QPointF &at, const QTextItem &item) override
    {
        const QRectF box = QFontMetricsF(item.font()).tightBoundingRect(item.text()).translated(at);
        ink.labels.push_back({item.text(), state->transform().mapRect(box), state->pen().color()});
    }

    Ink ink;
};

class InkDevice : public QPaintDevice {
public:
    QPaintEngine *paintEngine() const override { return &m_engine; }
    const Ink &ink() const { return m_engine.ink; }

protected:
    int metric(PaintDeviceMetric metric) const override
    {
        switch (metric) {
        case PdmWidth:
        case PdmHeight: return 2000;
        case PdmDevicePixelRatio: return 1;
        case PdmDevicePixelRatioScaled: return static_cast<int>(devicePixelRatioFScale());
        case PdmDpiX:
        case PdmDpiY:
        case PdmPhysicalDpiX:
        case PdmPhysicalDpiY: return 96;
        default: return 1000;
        }
    }

private:
    mutable InkEngine m_engine;
};

Ink inkOf(const QString &name)
{
    InkDevice device;
    const QFont font = formulaFont(kPointSize);
    QPainter painter(&device);
    drawHelpFigure(painter, QRectF(QPointF(), helpFigureSize(name, font)), name, font, colorsOf(false));
    painter.end();
    return device.ink();
}

/// The mean difference of two pictures of one size, 0 to 255.
double differenceOf(const QImage &one, const QImage &other)
{
    double sum = 0.0;
    for (int y = 0; y < one.height(); ++y) {
        for (int x = 0; x < one.width(); ++x)
            sum += std::abs(qGray(one.pixel(x, y)) - qGray(other.pixel(x, y)));
    }
    return sum / one.width() / one.height();
}

} // namespace

class TestHelpFigures : public QObject {
    Q_OBJECT

private slots:
    void everyDerivationHasItsFigure_data()
    {
        addColumn<QString>("figure");
        const std::pair<const char *, const char *> chapters[] = {
            {"spaces", "pipeline"},
            {"homogeneous", "homogeneous"},
            {"view", "look-at"},
            {"view-steps", "view-steps"},
            {"normals", "normals"},
            {"frustum-steps", "frustum-steps"},
            {"w4", "near-window"},
            {"ortho-steps", "ortho"},
            {"frustum", "frustum"},
            {"depth-row", "depth"},
            {"perspective", "perspective"},
            {"oblique", "oblique"},
            {"clip-planes", "clip-plane"},
            {"viewport", "viewport"},
            {"scales", "scales"},
            {"w2", "similar-triangles"},
            {"w8", "flip"},
            {"closed", "ray"},
            {"eye-to-world", "eye-to-world"},
            {"certainty", "certainty"},
            {"half-pixel", "half-pixel"},
        };
        for (const auto &[anchor, figure] : chapters)
            newRow(anchor) << figure;
    }

    void everyDerivationHasItsFigure()
    {
        QFETCH(QString, figure);
        const QList<Named> figures = figuresOf(source(QStringLiteral("formulas.html")));
        const QString anchor = QString::fromLatin1(QTest::currentDataTag());
        const bool isThere = std::any_of(figures.begin(), figures.end(), [&](const Named &one) {
            return one.anchor == anchor && one.figure == figure;
        });
        QVERIFY(isThere);
    }

    void bothPagesHaveTheSame()
    {
        const QList<Named> english = figuresOf(source(QStringLiteral("formulas.html"))),
                           chinese = figuresOf(source(QStringLiteral("formulas_zh_CN.html")));
        QCOMPARE(english.size(), chinese.size());
        QStringList named;
        static const QRegularExpression character(QStringLiteral("[\\x{4e00}-\\x{9fff}]"));
        for (qsizetype i = 0; i < english.size(); ++i) {
            QCOMPARE(chinese[i].anchor, english[i].anchor);
            QCOMPARE(chinese[i].figure, english[i].figure);
            QVERIFY2(english[i].words.size() > 40, qPrintable(english[i].figure));
            QVERIFY2(chinese[i].words.contains(character), qPrintable(english[i].figure));
            named << english[i].figure;
        }
        QStringList drawn = helpFigureNames();
        named.sort();
        drawn.sort();
        QCOMPARE(named, drawn);
    }

    void aFigureIsDrawn_data()
    {
        addColumn<QString>("name");
        for (const QString &name : helpFigureNames())
            newRow(qPrintable(name)) << name;
    }

    void aFigureIsDrawn()
    {
        QFETCH(QString, name);
        const QImage once = drawn(name, 1.0), twice = drawn(name, 2.0);
        QVERIFY(std::abs(twice.width() - 2 * once.width()) <= 1);
        QVERIFY(std::abs(twice.height() - 2 * once.height()) <= 1);
        // Lines and letters are as sharp at twice the pixels: it is not the small picture made larger.
        const QImage scaled = once.scaled(twice.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QVERIFY(differenceOf(twice, scaled) > 0.3);
        // The figure is still the same.
        const QImage back = twice.scaled(once.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        QVERIFY(differenceOf(back, once) < 8.0);

        const QImage dark = drawn(name, 1.0, true);
        QVERIFY(differenceOf(dark, once) > 150.0);
        QVERIFY(differenceOf(dark, QImage(dark.size(), dark.format())) > 0.0);

        // Nothing is cut off: the area outside its bounds stays empty, in every language.
        constexpr double kMargin = 24.0;
        for (const char *language : {"en-US", "zh-CN"}) {
            const Translation translation({QString::fromLatin1(language)});
            const QImage wide = drawn(name, 1.0, false, kMargin);
            const QRect inside(wide.rect().adjusted(kMargin - 1, kMargin - 1, 1 - kMargin, 1 - kMargin));
            for (int y = 0; y < wide.height(); ++y) {
                for (int x = 0; x < wide.width(); ++x) {
                    if (!inside.contains(x, y))
                        QVERIFY2(qGray(wide.pixel(x, y)) == 255, qPrintable(QStringLiteral("%1, %2").arg(x).arg(y)));
                }
            }
        }
    }

    void itsLabelsAreClear_data()
    {
        addColumn<QString>("name");
        addColumn<QString>("language");
        for (const char *language : {"en-US", "zh-CN"}) {
            for (const QString &name : helpFigureNames())
                addRow("%s %s", qPrintable(name), language) << name << QString::fromLatin1(language);
        }
    }

    void itsLabelsAreClear()
    {
        QFETCH(QString, name);
        QFETCH(QString, language);
        const Translation translation({language});
        const Ink ink = inkOf(name);
        QVERIFY(!ink.labels.empty());
        const double em = QFontMetricsF(formulaFont(kPointSize)).height();
        QStringList faults;
        for (const Ink::Label &label : ink.labels) {
            for (const QLineF &line : ink.lines) {
                for (int i = 0; i <= 400; ++i) {
                    if (label.box.contains(line.pointAt(i / 400.0))) {
                        faults << QStringLiteral("a line through %1").arg(label.text);
                        break;
                    }
                }
            }
            // Two labels of different colours are distinct and look it.
            for (const Ink::Label &other : ink.labels) {
                if (other.color != label.color && other.box.left() >= label.box.left()
                    && other.box.adjusted(-0.4 * em, 0, 0, 0).intersects(label.box))
                    faults << QStringLiteral("%1 at %2").arg(other.text, label.text);
            }
        }
        QVERIFY2(faults.isEmpty(), qPrintable(faults.join(QStringLiteral("; "))));
    }

    void thePageDrawsItInItsSize()
    {
        FormulasWindow window;
        window.resize(1100, 900);
        window.show();
        window.showFormula(QStringLiteral("depth-row"));
        const QColor line = colorsOf(false).second;
        const auto colored = [&](int ratio) {
            QImage picture(window.page().viewport()->size() * ratio, QImage::Format_RGB32);
            picture.setDevicePixelRatio(ratio);
            window.page().viewport()->render(&picture);
            int count = 0;
            for (int y = 0; y < picture.height(); ++y) {
                for (int x = 0; x < picture.width(); ++x)
                    count += QColor(picture.pixel(x, y)) == line ? 1 : 0;
            }
            return count;
        };
        QVERIFY(colored(1) > 0);
        QVERIFY(colored(2) > 2 * colored(1));
        // It grows with the text, and has to fit into a narrow window.
        const int all = window.page().verticalScrollBar()->maximum();
        window.setZoomPercent(140);
        QVERIFY(window.page().verticalScrollBar()->maximum() > all);
        window.setZoomPercent(100);
        window.resize(420, 600);
        QTRY_COMPARE_WITH_TIMEOUT(window.page().width(), 420, kPatienceMilliseconds);
        const QString figures = [] {
            QString page;
            for (const QString &name : helpFigureNames())
                page += QStringLiteral("<p><img src='figure:%1'></p>").arg(name);
            return page;
        }();
        window.page().setHtml(figures);
        QTRY_COMPARE_WITH_TIMEOUT(window.page().horizontalScrollBar()->maximum(), 0, kPatienceMilliseconds);
    }

    void anUnknownFigureIsNone() { QVERIFY(helpFigureSize(QStringLiteral("none"), formulaFont(kPointSize)).isEmpty()); }

    void aLabelIsOneLineInEverySize()
    {
        for (int tenths = 60; tenths < 300; tenths += 3) {
            const double points = tenths / 10.0;
            const QFont font = formulaFont(points);
            const FormulaLayout label(QStringLiteral("A x + B y + C z + D ≥ 0"), font);
            QVERIFY2(label.size().height() < 1.7 * QFontMetricsF(font).height(), qPrintable(QString::number(points)));
        }
    }

    void itsWordsAreItsTooltip()
    {
        FormulasWindow window;
        window.resize(900, 700);
        window.show();
        window.page().setHtml(QStringLiteral("<p><img src='figure:frustum' alt='The view volume'></p><p>Words</p>"));
        const auto toolTipAt = [&window](const QPoint &place) {
            QWidget *viewport = window.page().viewport();
            QHelpEvent help(QEvent::ToolTip, place, viewport->mapToGlobal(place));
            QCoreApplication::sendEvent(viewport, &help);
            return QToolTip::text();
        };
        QVERIFY(toolTipAt({100, 100}).contains(QStringLiteral("The view volume")));
    }
};

} // namespace unprojector::gui

UNPROJECTOR_TEST(unprojector::gui::TestHelpFigures)
#include "test_help_figures.moc"
