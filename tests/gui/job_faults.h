#pragma once

#include "gui/document/background.h"

#include <QTest>

#include <new>
#include <system_error>

/// Jobs that fail as on a machine without threads or memory to spare.
namespace jobfaults {

/// Makes each job fail in this way while it lives. @pre no job runs when it is constructed or
/// destroyed
class Fault {
public:
    explicit Fault(unprojector::gui::JobFailure::Kind kind)
    {
        unprojector::gui::Background::fault = [kind](unprojector::gui::Background::Step step) {
            if (kind == unprojector::gui::JobFailure::Kind::NoThread
                && step == unprojector::gui::Background::Step::Start)
                throw std::system_error(std::make_error_code(std::errc::resource_unavailable_try_again));
            if (kind == unprojector::gui::JobFailure::Kind::OutOfMemory
                && step == unprojector::gui::Background::Step::Work)
                throw std::bad_alloc();
        };
    }
    ~Fault() { unprojector::gui::Background::fault = nullptr; }
    Fault(const Fault &) = delete;
    Fault &operator=(const Fault &) = delete;
};

inline void addRows()
{
    QTest::addColumn<unprojector::gui::JobFailure::Kind>("kind");
    QTest::addColumn<QString>("reason");
    QTest::newRow("no thread") << unprojector::gui::JobFailure::Kind::NoThread
                               << QStringLiteral("the system cannot start another thread");
    QTest::newRow("no memory") << unprojector::gui::JobFailure::Kind::OutOfMemory
                               << QStringLiteral("there is not enough memory");
}

} // namespace jobfaults

Q_DECLARE_METATYPE(unprojector::gui::JobFailure::Kind)
