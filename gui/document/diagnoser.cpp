#include "gui/document/diagnoser.h"

#include <new>
#include <utility>

namespace unprojector::gui {
using namespace doctor;

Diagnoser::Diagnoser(QObject *parent) : QObject(parent), m_latest(std::make_shared<std::atomic<int>>(0))
{
    m_pool.setMaxThreadCount(1);
}

Diagnoser::~Diagnoser()
{
    cancel();
    m_pool.waitForDone();
}

void Diagnoser::cancel()
{
    ++*m_latest;
    m_pool.clear();
}

void Diagnoser::ask(Case scene, std::vector<WrongPoint> points)
{
    cancel();
    const int number = *m_latest;
    m_pool.start([this, number, latest = m_latest, scene = std::move(scene), points = std::move(points)] {
        if (*latest != number)
            return;
        std::shared_ptr<const Result<Diagnosis>> answer;
        try {
            answer = std::make_shared<const Result<Diagnosis>>(diagnose(scene, points));
        } catch (const std::bad_alloc &) {
            // Told below.
        }
        QMetaObject::invokeMethod(
            this,
            [this, number, answer] {
                if (*m_latest != number)
                    return;
                if (answer)
                    emit answered(*answer);
                else
                    emit outOfMemory();
            },
            Qt::QueuedConnection);
    });
}

} // namespace unprojector::gui
