#include "gui/text/proportion_text.h"

#include "core/geometry/proportions.h"
#include "gui/text/number_text.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
namespace {

struct ProportionTexts {
    Q_DECLARE_TR_FUNCTIONS(ProportionTexts)
};

/// The text with the typographic minus, as in the paper.
QString typographic(QString text)
{
    return text.replace(u'-', u'−');
}

QString limit(double value)
{
    return typographic(writtenText(value, 5));
}

/// The text in parentheses if its sign would follow an operator.
QString term(const QString &text)
{
    return text.startsWith(u'−') ? u'(' + text + u')' : text;
}

} // namespace

QString ProportionText::line() const
{
    return symbols.left(4) + left + QStringLiteral(" = ") + right
           + (share.isEmpty() ? share : QStringLiteral(" = ") + share);
}

ProportionText proportionText(const Setup &setup, Axis axis, const std::optional<WindowPoint> &pointer)
{
    const ProjectionWindow w = projectionWindow(setup.projection());
    const Viewport &v = setup.viewport;
    const bool isX = axis == Axis::X;
    const double low = isX ? w.left : w.bottom, high = isX ? w.right : w.top;
    const double corner = isX ? v.x : v.y, size = isX ? v.width : v.height;
    const int pixels = isX ? setup.surface.widthPixels : setup.surface.heightPixels;

    constexpr int kDigits = 5, kPixelDecimals = 1, kShareDecimals = 4;
    const int decimals = decimalsFor({low, high, 0.0}, kDigits);
    const auto inPlane = [decimals](double value) { return typographic(fixedText(value, decimals)); };
    const qsizetype planeColumns = std::max(inPlane(low).size(), inPlane(high).size());
    const qsizetype pixelColumns = fixedText(pixels, kPixelDecimals).size();

    ProportionText text;
    QString inWindow = isX ? QStringLiteral("x_w") : QStringLiteral("y_w");
    QString inView = isX ? QStringLiteral("x_v") : QStringLiteral("y_v");
    if (pointer) {
        const Proportions p = proportions(setup, *pointer);
        inWindow = inPlane(isX ? p.position.x : p.position.y);
        inView = typographic(fixedText(isX ? pointer->x : pointer->y, kPixelDecimals));
        text.share = typographic(fixedText(isX ? p.share.x : p.share.y, kShareDecimals));
    }
    text.symbols = isX ? QStringLiteral("(3) (x_w − left) / (right − left) = (x_v − vx) / width")
                       : QStringLiteral("(4) (y_w − bottom) / (top − bottom) = (y_v − vy) / height");
    const QString bottom = term(limit(low));
    const auto opened = [](const QString &value, qsizetype columns) {
        return (u'(' + value).rightJustified(columns + 1);
    };
    text.left = QStringLiteral("%1 − %2) / (%3 − %2)").arg(opened(inWindow, planeColumns), bottom, limit(high));
    text.right = QStringLiteral("%1 − %2) / %3").arg(opened(inView, pixelColumns), term(limit(corner)), limit(size));
    return text;
}

QString proportionMarkup(const QString &plain)
{
    static const QRegularExpression index(QStringLiteral("\\b([xy])_([wv])\\b|\\b(v)([xy])\\b"));
    QString markup = plain.toHtmlEscaped();
    markup.replace(index, QStringLiteral("\\1\\3<sub>\\2\\4</sub>"));
    return QStringLiteral("<div style=\"white-space: pre-wrap\">%1</div>")
        .arg(markup.replace(u'\n', QLatin1String("<br>")));
}

bool isDistorted(double circleAspect)
{
    constexpr double kVisible = 0.005;
    return std::abs(std::log(circleAspect)) > kVisible;
}

std::pair<QString, QString> aspectTexts(double one, double other)
{
    const auto text = [](double aspect, int digits) {
        constexpr std::array<std::pair<int, int>, 7> kNamed{
            {{1, 1}, {4, 3}, {3, 2}, {16, 9}, {16, 10}, {5, 4}, {2, 1}}};
        constexpr double kSame = 1e-4;
        for (const auto &[more, less] : kNamed) {
            const double named = static_cast<double>(more) / less;
            if (std::abs(aspect / named - 1.0) < kSame)
                return QStringLiteral("%1 : %2").arg(more).arg(less);
            if (std::abs(aspect * named - 1.0) < kSame)
                return QStringLiteral("%1 : %2").arg(less).arg(more);
        }
        return significantText(aspect, digits) + QStringLiteral(" : 1");
    };
    constexpr int kFewest = 3, kMost = 17;
    for (int digits = kFewest; digits < kMost; ++digits) {
        if (const std::pair texts(text(one, digits), text(other, digits)); texts.first != texts.second)
            return texts;
    }
    return {text(one, kFewest), text(other, kFewest)};
}

QString circleText(double circleAspect)
{
    if (!isDistorted(circleAspect))
        return ProportionTexts::tr("A circle is drawn as a circle.");
    const QString ratio = significantText(circleAspect, 3);
    return circleAspect > 1.0 ? ProportionTexts::tr("A circle would be drawn %1 : 1, wider than high.").arg(ratio)
                              : ProportionTexts::tr("A circle would be drawn %1 : 1, higher than wide.").arg(ratio);
}

} // namespace unprojector::gui
