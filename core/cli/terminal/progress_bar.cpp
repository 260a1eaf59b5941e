#include "core/cli/terminal/progress_bar.h"

#include "core/base/columns.h"
#include "core/base/translation.h"
#include "core/cli/terminal/console.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <utility>

namespace unprojector::cli {
using base::columnsOf;
using base::firstColumns;
using base::tr;
namespace {

using namespace std::chrono_literals;

constexpr auto kFirst = 1s;
constexpr auto kBetween = 100ms;

// One terminal has one bar, and any thread may write to it.
std::mutex terminalMutex;
ProgressBar *shownBar = nullptr;

/// Bytes in three digits and a unit.
std::string amountText(double amount, ProgressBar::Unit of)
{
    constexpr std::array kUnits{"B", "kB", "MB", "GB", "TB", "PB", "EB"};
    const bool areBytes = of == ProgressBar::Unit::Bytes;
    std::size_t unit = 0;
    for (; areBytes && amount >= 999.5 && unit + 1 < kUnits.size(); ++unit)
        amount /= 1000.0;
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "%.*f%s%s", amount < 9.95 && unit > 0 ? 1 : 0, amount, areBytes ? " " : "",
                  areBytes ? kUnits[unit] : "");
    return text.data();
}

/// 1:05, 2:00:07
std::string timeText(double seconds)
{
    constexpr double kMost = 359999.0; // 99:59:59
    const auto whole = static_cast<int>(std::min(std::round(seconds), kMost));
    std::array<char, 32> text;
    if (whole >= 3600)
        std::snprintf(text.data(), text.size(), "%d:%02d:%02d", whole / 3600, whole / 60 % 60, whole % 60);
    else
        std::snprintf(text.data(), text.size(), "%d:%02d", whole / 60, whole % 60);
    return text.data();
}

} // namespace

ProgressScreen errorTerminal()
{
    const char *kind = std::getenv("TERM");
    if (!isTerminal(stderr) || (kind != nullptr && std::string_view(kind) == "dumb"))
        return {};
    return {terminalColumns(stderr),
            [](std::string_view text) {
                std::fwrite(text.data(), 1, text.size(), stderr);
                std::fflush(stderr);
            },
            std::chrono::steady_clock::now};
}

ProgressBar::ProgressBar(std::optional<std::uint64_t> total, Unit unit, ProgressScreen screen)
    : m_total(total.value_or(0)), m_unit(unit), m_screen(std::move(screen)),
      m_start(m_screen.write ? m_screen.now() : ProgressScreen::Time{}), m_next(m_start + kFirst)
{
    if (!m_screen.write)
        return;
    const std::lock_guard lock(terminalMutex);
    shownBar = this;
}

ProgressBar::~ProgressBar()
{
    finish();
}

void ProgressBar::finish()
{
    const std::lock_guard lock(terminalMutex);
    erase();
    m_screen.write = {};
    if (shownBar == this)
        shownBar = nullptr;
}

void ProgressBar::advance(std::uint64_t amount)
{
    if (!m_screen.write)
        return;
    const std::lock_guard lock(terminalMutex);
    m_done += amount;
    if (const ProgressScreen::Time now = m_screen.now(); now >= m_next)
        draw(now);
}

std::string ProgressBar::line(ProgressScreen::Time now) const
{
    const double seconds = std::chrono::duration<double>(now - m_start).count();
    const auto done = static_cast<double>(m_done), total = static_cast<double>(m_total);
    // Some terminals begin the next line already in the last column.
    const std::size_t room = std::max<std::size_t>(m_screen.columns, 1) - 1;
    std::string text;
    if (m_total == 0) {
        text = amountText(done, m_unit) + ", " + amountText(done / seconds, m_unit) + "/s";
        return text.substr(0, room);
    }
    const double share = std::min(done / total, 1.0); // a file may grow while it is read
    std::array<char, 8> percent;
    std::snprintf(percent.data(), percent.size(), "%3.0f%%", std::floor(100.0 * share));
    std::string behind = tr(" %1 of %2", amountText(done, m_unit), amountText(total, m_unit));
    if (m_done > 0)
        behind += tr(", %1 left", timeText(seconds * (1.0 - share) / share));
    text = percent.data();
    constexpr std::size_t kLeast = 10, kMost = 40;
    const std::size_t taken = text.size() + columnsOf(behind) + 3;
    if (room >= taken + kLeast) {
        const std::size_t width = std::min(room - taken, kMost);
        const auto filled = static_cast<std::size_t>(share * static_cast<double>(width));
        std::string bar(filled, '=');
        if (filled < width)
            bar += '>';
        bar.resize(width, ' ');
        text += " [" + bar + ']';
    }
    return std::string(firstColumns(text + behind, room));
}

void ProgressBar::draw(ProgressScreen::Time now)
{
    std::string text = line(now);
    const std::size_t width = columnsOf(text);
    if (width < m_width)
        text.append(m_width - width, ' ');
    m_screen.write('\r' + text);
    m_width = width;
    m_next = now + kBetween;
}

void ProgressBar::erase()
{
    if (m_width == 0)
        return;
    m_screen.write('\r' + std::string(m_width, ' ') + '\r');
    m_width = 0;
}

void withoutProgressBar(const std::function<void()> &write)
{
    const std::lock_guard lock(terminalMutex);
    if (shownBar != nullptr)
        shownBar->erase();
    write();
}

} // namespace unprojector::cli
