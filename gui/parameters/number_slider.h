#pragma once

#include <QSlider>

namespace unprojector::gui {

/// A slider for a double, to try numbers: evenly spaced, or with equal steps in each power of ten.
class NumberSlider : public QSlider {
    Q_OBJECT
public:
    enum class Scale { Linear, Logarithmic };
    NumberSlider(const QString &name, const QString &help, Scale scale, QWidget *parent = nullptr);

    /// @param step  between two numbers if they are evenly spaced
    /// @pre lowest < highest; both above 0 if it is logarithmic
    void setNumbers(double lowest, double highest, double step = 1.0);
    /// Sets the scale. Call setNumbers afterwards.
    void setScale(Scale scale) { m_scale = scale; }
    /// Shows a number, clamped to the ends. Ignored while the user holds the slider.
    void setNumber(double number);
    /// The number of an edit session: each drag has its own, and so do the keys in between; a
    /// session is one step of undo.
    quint64 session() const { return m_session; }

signals:
    /// Emitted when the user moved the slider, with the number rounded to three digits or to tenths
    /// of a step.
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
