#pragma once

#include <QSlider>

namespace unprojector::gui {

/// A slider for a double, to try numbers with: evenly spaced ones, or so many steps in each power of ten.
class NumberSlider : public QSlider {
    Q_OBJECT
public:
    enum class Scale { Linear, Logarithmic };
    NumberSlider(const QString &name, const QString &help, Scale scale, QWidget *parent = nullptr);

    /// @param step  between two numbers where they are evenly spaced
    /// @pre lowest < highest; both above 0 where it is logarithmic
    void setNumbers(double lowest, double highest, double step = 1.0);
    /// To be followed by setNumbers.
    void setScale(Scale scale) { m_scale = scale; }
    /// Shows a number, at an end where it lies beyond. Not while the slider is held.
    void setNumber(double number);
    /// Each drag has a number of its own, and so have the keys in between: it is undone as one.
    quint64 session() const { return m_session; }

signals:
    /// The user moved it there; three digits, or tenths of a step, that mean what they say.
    void moved(double number);

protected:
    void focusInEvent(QFocusEvent *event) override;

private:
    double numberAt(int position) const;
    int positionOf(double number) const;

    Scale m_scale;
    double m_lowest = 0.0;
    double m_step = 1.0;
    quint64 m_session = 0;
};

} // namespace unprojector::gui
