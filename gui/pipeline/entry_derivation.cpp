#include "gui/pipeline/entry_derivation.h"

#include "gui/pipeline/stage_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;

namespace {

using Space = PointModel::Space;

/// The digits that the grids show of a double.
constexpr int kSignificantDigits = 9;

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::EntryDerivation)
};

/// Formats numbers as the panel does.
class Numbers {
public:
    explicit Numbers(const MatrixView &view) : m_view(view) {}

    QString text(double value, int significant = kSignificantDigits) const
    {
        const bool isWhole = m_view.isWhole || m_view.digits == Digits::Float;
        return QString::fromStdString(
            numberText(value, m_view.digits, isWhole && significant >= kSignificantDigits ? 0 : significant));
    }
    /// The number after another operator.
    QString factor(double value) const
    {
        const QString number = text(value);
        return number.startsWith(u'-') ? QStringLiteral("(%1)").arg(number) : number;
    }
    /// The number as a summand: " + 5" or " - 5".
    QString summand(double value) const
    {
        const QString number = text(value);
        return number.startsWith(u'-') ? QStringLiteral(" - ") + number.mid(1) : QStringLiteral(" + ") + number;
    }

private:
    MatrixView m_view;
};

struct Sum {
    QString text; ///< "0 · 2.2 + 0.1 · (-4.2)"
    double value = 0.0;
    double size = 0.0; ///< of all terms together, without their signs
};

/// The names of coordinate and space: "clip y"; before the division on the way back "y′".
QString entryName(const PointModel &point, int coordinate)
{
    const QString axis = point.indexOf(coordinate).data(NumberGridModel::kLabelRole).toString();
    return axis.size() > 1 ? axis : QStringLiteral("%1 %2").arg(point.name(), axis);
}

double valueAt(const QModelIndex &index)
{
    const QVariant value = index.data(NumberGridModel::kValueRole);
    return value.isValid() ? value.toDouble() : std::numeric_limits<double>::quiet_NaN();
}

Space spaceBefore(Space space, PipelineDirection direction)
{
    return static_cast<Space>(static_cast<int>(space) + (direction == PipelineDirection::Forward ? -1 : 1));
}

/// The stage between a space and the next one forward; none for a division or the step to the
/// widget.
std::optional<PipelineStage> stageAfter(Space space)
{
    switch (space) {
    case Space::Object: return PipelineStage::ModelMatrix;
    case Space::World: return PipelineStage::ViewMatrix;
    case Space::Eye: return PipelineStage::ProjectionMatrix;
    case Space::Ndc: return PipelineStage::ViewportMatrix;
    case Space::Clip:
    case Space::Window:
    case Space::Widget: break;
    }
    return std::nullopt;
}

/// The text after the equals sign and the terms: the shown number, or a remark on the difference.
QString resultText(const Numbers &numbers, const Sum &sum, double shown)
{
    // Four products and three sums, each half a unit in the last place, and as much again in their
    // inputs.
    const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * sum.size;
    // The relative difference that nine digits show.
    constexpr double kSame = 1e-9;
    if (std::abs(sum.value - shown) > kSame * sum.size)
        return Texts::tr("%1; the number shown, %2, is the input, and the steps before it were computed back from it")
            .arg(numbers.text(sum.value), numbers.text(shown));
    if (shown != 0.0 && std::abs(shown) <= rounding)
        return Texts::tr("0: the %1 shown is only rounding error").arg(numbers.text(shown, 2));
    if (shown == 0.0 || rounding == 0.0)
        return numbers.text(shown);
    const double certain = std::floor(std::log10(std::abs(shown) / rounding)) + 1.0;
    return numbers.text(shown, std::clamp(static_cast<int>(certain), 1, kSignificantDigits));
}

Sum productSum(const Numbers &numbers, const MatrixModel &matrix, const PointModel &source, int row)
{
    const bool isColumns = matrix.view().layout == MatrixLayout::Column;
    Sum sum;
    for (int i = 0; i < 4; ++i) {
        const double entry = valueAt(matrix.indexOf(row, i)), coordinate = valueAt(source.indexOf(i));
        const double first = isColumns ? entry : coordinate, second = isColumns ? coordinate : entry;
        sum.text += i == 0 ? numbers.text(first) : numbers.summand(first);
        sum.text += QStringLiteral(" · ") + numbers.factor(second);
        sum.value += entry * coordinate;
        sum.size += std::abs(entry * coordinate);
    }
    return sum;
}

/// "row 2 of Projection · eye"
QString productName(const MatrixModel &matrix, const QString &name, const PointModel &source, int row)
{
    return matrix.view().layout == MatrixLayout::Column
               ? Texts::tr("row %1 of %2 · %3").arg(row + 1).arg(name, source.name())
               : Texts::tr("%3 · column %1 of %2").arg(row + 1).arg(name, source.name());
}

/// "(NDC x + 1) · w/2 + vx = (0.22 + 1) · 25 + 0"
QString viewportText(const Numbers &numbers, const Setup &setup, const PointModel &ndc, int axis)
{
    const Viewport &v = setup.viewport;
    const DepthRange &range = setup.depthRange;
    const std::array scale{v.width / 2.0, v.height / 2.0, (range.atFar - range.atNear) / 2.0};
    const std::array shift{v.x, v.y, range.atNear};
    const std::array names{QStringLiteral("w/2 + vx"), QStringLiteral("h/2 + vy"), QStringLiteral("(df − dn)/2 + dn")};
    const auto i = static_cast<std::size_t>(axis);
    return QStringLiteral("(%1 + 1) · %2 = (%3 + 1) · %4%5")
        .arg(entryName(ndc, axis), names[i], numbers.text(valueAt(ndc.indexOf(axis))), numbers.factor(scale[i]),
             numbers.summand(shift[i]));
}

/// The conversion of a position between window and widget, for a name or a number.
QString flipText(const Numbers &numbers, const Setup &setup, const PipelineModel &model, bool isY,
                 const QString &position)
{
    const ApiConventions &api = conventionsOf(model.api());
    const bool isForward = model.direction() == PipelineDirection::Forward;
    const double ratio = api.areLogicalPixels ? 1.0 : setup.surface.devicePixelRatio;
    QString text = position;
    if (!isForward && ratio != 1.0)
        text += QStringLiteral(" · ") + numbers.text(ratio);
    if (isY && !api.isOriginTop)
        text = QStringLiteral("%1 - %2").arg(setup.surface.heightPixels).arg(text);
    if (api.pixelCentre == 0.0)
        text += isForward ? QStringLiteral(" + 0.5") : QStringLiteral(" - 0.5");
    if (isForward && ratio != 1.0)
        text =
            (text == position ? text : QStringLiteral("(%1)").arg(text)) + QStringLiteral(" / ") + numbers.text(ratio);
    return text;
}

EntryDerivation divided(const Numbers &numbers, const PointModel &source, const PointModel &point, int coordinate)
{
    EntryDerivation result;
    result.source = source.space();
    result.coordinates = {coordinate, 3};
    const double of = valueAt(source.indexOf(coordinate)), by = valueAt(source.indexOf(3));
    result.text = QStringLiteral("%1 = %2 / %3\n= %4 / %5 = %6")
                      .arg(entryName(point, coordinate), entryName(source, coordinate), entryName(source, 3),
                           numbers.text(of), numbers.factor(by),
                           resultText(numbers, {{}, of / by, std::abs(of / by)}, valueAt(point.indexOf(coordinate))));
    return result;
}

EntryDerivation flipped(const Numbers &numbers, const Setup &setup, const PipelineModel &model,
                        const PointModel &source, const PointModel &point, int coordinate)
{
    EntryDerivation result;
    const QString name = entryName(point, coordinate);
    if (coordinate > 1) { // of a window point, on the way back
        result.text = coordinate == 3       ? Texts::tr("%1 = 1, as for every point").arg(name)
                      : model.isDepthRead() ? Texts::tr("%1 is the depth that was read at the click").arg(name)
                                            : Texts::tr("%1 was computed: a widget position has no depth").arg(name);
        return result;
    }
    result.source = source.space();
    result.coordinates = {coordinate};
    const QString number = numbers.text(valueAt(source.indexOf(coordinate)));
    const bool isNegative = number.startsWith(u'-');
    const QString formula = flipText(numbers, setup, model, coordinate == 1, entryName(source, coordinate));
    const QString given =
        flipText(numbers, setup, model, coordinate == 1, isNegative ? QStringLiteral("(%1)").arg(number) : number);
    const QString shown = numbers.text(valueAt(point.indexOf(coordinate)));
    result.text = given == shown ? QStringLiteral("%1 = %2\n= %3").arg(name, formula, shown)
                                 : QStringLiteral("%1 = %2\n= %3 = %4").arg(name, formula, given, shown);
    return result;
}

} // namespace

std::optional<PipelineStage> stageOf(Space space, PipelineDirection direction)
{
    if (space == startOf(direction))
        return std::nullopt;
    if (direction == PipelineDirection::Forward)
        return stageAfter(spaceBefore(space, direction));
    // The point before its division replaces the clip point on the way back: the projection leads
    // there.
    if (space == Space::Clip)
        return PipelineStage::ProjectionMatrix;
    return space == Space::Eye ? std::nullopt : stageAfter(space);
}

std::optional<PointModel::Space> spaceMadeBy(PipelineStage stage, PipelineDirection direction)
{
    for (int i = 0; i < PointModel::kSpaces; ++i) {
        if (stageOf(static_cast<Space>(i), direction) == stage)
            return static_cast<Space>(i);
    }
    return std::nullopt;
}

PointModel::Space startOf(PipelineDirection direction)
{
    return direction == PipelineDirection::Forward ? Space::Object : Space::Widget;
}

EntryDerivation entryDerivation(const PipelineModel &model, const Setup &setup, PointModel::Space space, int coordinate)
{
    const PipelineDirection direction = model.direction();
    const PointModel &point = *model.point(space);
    const Numbers numbers(model.view());
    if (space == startOf(direction))
        return {direction == PipelineDirection::Forward
                    ? Texts::tr("%1: start of the forward path; switch to Backward to see it computed from world.")
                          .arg(entryName(point, coordinate))
                    : Texts::tr("%1: start of the backward path; switch to Forward to see it computed from window.")
                          .arg(entryName(point, coordinate)),
                {},
                0,
                {},
                {}};
    const PointModel &source = *model.point(spaceBefore(space, direction));
    if (std::isnan(valueAt(point.indexOf(coordinate))) || std::isnan(valueAt(source.indexOf(0))))
        return {Texts::tr("%1 has no number yet: click the model, or type a point.").arg(entryName(point, coordinate)),
                {},
                0,
                {},
                {}};
    const std::optional<PipelineStage> stage = stageOf(space, direction);
    if (!stage)
        return source.space() == Space::Clip ? divided(numbers, source, point, coordinate)
                                             : flipped(numbers, setup, model, source, point, coordinate);
    const MatrixModel &matrix = *model.matrix(*stage);
    EntryDerivation result{{}, stage, coordinate, source.space(), {0, 1, 2, 3}};
    const Sum sum = productSum(numbers, matrix, source, coordinate);
    result.text =
        QStringLiteral("%1 = %2\n= %3 = %4")
            .arg(entryName(point, coordinate), productName(matrix, stageName(*stage, direction), source, coordinate),
                 sum.text, resultText(numbers, sum, valueAt(point.indexOf(coordinate))));
    if (space == Space::Window && coordinate < 3 && model.api() == Api::OpenGl)
        result.text += QStringLiteral("\n= ") + viewportText(numbers, setup, source, coordinate);
    return result;
}

QString entryHint()
{
    return Texts::tr("Click a number to see how it is computed. Double-click a vector to type your own.");
}

QString unbrokenTerms(QString text)
{
    const QChar blank(QChar::Nbsp);
    for (const QChar sign : {u'·', u'/'})
        text.replace(QStringLiteral(" %1 ").arg(sign), QString(blank) + sign + blank);
    for (const QChar sign : {u'+', u'-'})
        text.replace(QStringLiteral(" %1 ").arg(sign), QString(blank) + sign + u' ');
    return text.replace(QStringLiteral("= "), u'=' + QString(blank));
}

} // namespace unprojector::gui
