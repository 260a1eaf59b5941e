#pragma once

#include "core/doctor/diagnosis.h"
#include "gui/document/background.h"

#include <QObject>

#include <vector>

namespace unprojector::gui {

/// Runs core/doctor on a separate thread: several points take longer than a frame. A new question
/// replaces the former one.
class Diagnoser : public QObject {
    Q_OBJECT
public:
    explicit Diagnoser(QObject *parent = nullptr) : QObject(parent) {}

    /// @param scene   its mesh queries must be thread-safe
    /// @param points  at least one
    void ask(doctor::Case scene, std::vector<doctor::WrongPoint> points);
    /// Cancels the question.
    void cancel() { m_background.cancel(); }

signals:
    /// Emitted with the answer to the last question.
    void answered(const unprojector::geometry::Result<unprojector::doctor::Diagnosis> &answer);
    /// Emitted when there is no answer, with the reason.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    Background m_background;
};

} // namespace unprojector::gui
