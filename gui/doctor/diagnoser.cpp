#include "gui/doctor/diagnoser.h"

#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace doctor;

void Diagnoser::ask(Case scene, std::vector<WrongPoint> points)
{
    cancel();
    m_background.start(
        [scene = std::move(scene), points = std::move(points)](Job &) { return diagnose(scene, points); },
        [this](const JobResult<Result<Diagnosis>> &answer) {
            if (answer)
                emit answered(*answer);
            else
                emit jobFailed(answer.error());
        });
}

} // namespace unprojector::gui
