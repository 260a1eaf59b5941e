#pragma once

#include <QFrame>
#include <QString>

#include <array>

class QLabel;

namespace unprojector::gui {

/// Three things to try for a new user, in a corner of the view. Each is ticked once it is done.
class FirstSteps : public QFrame {
    Q_OBJECT
public:
    enum Step { Click, Drag, Lesson, StepCount };

    /// @param lesson  the title of the offered lesson
    explicit FirstSteps(const QString &lesson, QWidget *parent = nullptr);

    void setDone(Step step, bool isDone);
    bool isDone(Step step) const { return m_isDone[step]; }
    bool isAllDone() const;

signals:
    void lessonRequested();
    void closeRequested();

private:
    std::array<QLabel *, StepCount> m_ticks;
    std::array<bool, StepCount> m_isDone{};
};

} // namespace unprojector::gui
