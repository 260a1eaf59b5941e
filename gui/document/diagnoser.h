#pragma once

#include "core/doctor/diagnosis.h"

#include <QObject>
#include <QThreadPool>

#include <atomic>
#include <memory>
#include <vector>

namespace unprojector::gui {

/// Asks core/doctor on a thread of its own: several points take longer than a frame. What is asked for last is what is wanted.
class Diagnoser : public QObject {
    Q_OBJECT
public:
    explicit Diagnoser(QObject *parent = nullptr);
    ~Diagnoser() override;

    /// @param scene   what it has of the meshes may be asked on any thread
    /// @param points  at least one
    void ask(doctor::Case scene, std::vector<doctor::WrongPoint> points);
    /// Nothing is wanted any more.
    void cancel();

signals:
    /// The answer to the last question.
    void answered(const unprojector::geometry::Result<unprojector::doctor::Diagnosis> &answer);
    void outOfMemory();

private:
    QThreadPool m_pool;
    std::shared_ptr<std::atomic<int>> m_latest; ///< the number of the last question
};

} // namespace unprojector::gui
