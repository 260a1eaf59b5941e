#pragma once

#include <QFrame>
#include <QString>

namespace unprojector::gui {

/// A quiet note in the view of somebody who is new: three things to try.
class FirstSteps : public QFrame {
    Q_OBJECT
public:
    /// @param example  the name of the one that is offered
    explicit FirstSteps(const QString &example, QWidget *parent = nullptr);

signals:
    void exampleRequested();
    void closeRequested();
};

} // namespace unprojector::gui
