#include "gui/parameters/number_slider.h"

#include "gui/widgets/wheel.h"

#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kStepsOfDecade = 100;
constexpr int kDigits = 3;

} // namespace

NumberSlider::NumberSlider(const QString &name, const QString &help, Scale scale, QWidget *parent)
    : QSlider(Qt::Horizontal, parent), m_scale(scale)
{
    setAccessibleName(name);
    setAccessibleDescription(help);
    setToolTip(help);
    ignoreWheelWithoutFocus(this);
    const auto begin = [this] { ++m_session; };
    connect(this, &QSlider::sliderPressed, this, begin);
    connect(this, &QSlider::sliderReleased, this, begin);
    connect(this, &QSlider::valueChanged, this, [this](int position) { emit moved(numberAt(position)); });
}

void NumberSlider::setNumbers(double lowest, double highest, double step)
{
    const QSignalBlocker blocker(this);
    m_lowest = lowest;
    m_step = step;
    setRange(0, m_scale == Scale::Linear
                    ? static_cast<int>(std::lround((highest - lowest) / step))
                    : static_cast<int>(std::lround(std::log10(highest / lowest) * kStepsOfDecade)));
    setPageStep(10);
}

void NumberSlider::setNumber(double number)
{
    if (isSliderDown())
        return;
    const QSignalBlocker blocker(this);
    setValue(positionOf(number));
}

double NumberSlider::numberAt(int position) const
{
    if (m_scale == Scale::Linear) {
        const double number = m_lowest + position * m_step;
        // Down to a tenth of a step, however far from zero.
        const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(m_step))));
        return QString::number(std::abs(number) < 0.5 * m_step ? 0.0 : number, 'f', decimals).toDouble();
    }
    const double number = m_lowest * std::pow(10.0, static_cast<double>(position) / kStepsOfDecade);
    return QString::number(number, 'g', kDigits).toDouble();
}

int NumberSlider::positionOf(double number) const
{
    if (m_scale == Scale::Logarithmic && number <= m_lowest)
        return minimum();
    const double position =
        m_scale == Scale::Linear ? (number - m_lowest) / m_step : std::log10(number / m_lowest) * kStepsOfDecade;
    return static_cast<int>(std::lround(std::clamp(position, 0.0, static_cast<double>(maximum()))));
}

void NumberSlider::focusInEvent(QFocusEvent *event)
{
    QSlider::focusInEvent(event);
    ++m_session;
}

} // namespace unprojector::gui
