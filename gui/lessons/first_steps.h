#pragma once

#include <QFrame>
#include <QString>

namespace unprojector::gui {

/// A quiet note in the view of somebody who is new: three things to try.
class FirstSteps : public QFrame {
    Q_OBJECT
public:
    /// @param lesson  the title of the one that is offered
    explicit FirstSteps(const QString &lesson, QWidget *parent = nullptr);

signals:
    void lessonRequested();
    void closeRequested();
};

} // namespace unprojector::gui
