#include "gui/document/change_notifier.h"

#include <utility>

namespace unprojector::gui {

ChangeNotifier::Batch::Batch(ChangeNotifier &notifier) : m_notifier(notifier)
{
    ++m_notifier.m_batches;
}

ChangeNotifier::Batch::~Batch()
{
    --m_notifier.m_batches;
    m_notifier.notify({});
}

void ChangeNotifier::notify(Changes changes)
{
    m_pending |= changes;
    if (m_batches > 0 || !m_pending)
        return;
    ++m_batches;
    emit changing(m_pending);
    --m_batches;
    emit changed(std::exchange(m_pending, {}));
}

} // namespace unprojector::gui
