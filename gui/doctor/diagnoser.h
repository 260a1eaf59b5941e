#pragma once

#include "core/doctor/diagnosis.h"
#include "gui/document/background.h"

#include <QObject>

#include <vector>

namespace unprojector::gui {

/// Asks core/doctor on a thread of its own: several points take longer than a frame. What is asked for last is what is wanted.
class Diagnoser : public QObject {
    Q_OBJECT
public:
    explicit Diagnoser(QObject *parent = nullptr) : QObject(parent) {}

    /// @param scene   what it has of the meshes may be asked on any thread
    /// @param points  at least one
    void ask(doctor::Case scene, std::vector<doctor::WrongPoint> points);
    /// Nothing is wanted any more.
    void cancel() { m_background.cancel(); }

signals:
    /// The answer to the last question.
    void answered(const unprojector::geometry::Result<unprojector::doctor::Diagnosis> &answer);
    /// There is no answer, and why.
    void jobFailed(const unprojector::gui::JobFailure &failure);

private:
    Background m_background;
};

} // namespace unprojector::gui
