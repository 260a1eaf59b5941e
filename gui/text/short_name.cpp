#include "gui/text/short_name.h"

#include <QStringList>

#include <cstddef>
#include <vector>

namespace unprojector::gui {

std::optional<QString> shortName(const QString &name, const QFontMetrics &metrics, int width)
{
    constexpr qsizetype kLeast = 3;
    if (metrics.horizontalAdvance(name) <= width)
        return name;
    const QStringList words = name.split(u' ', Qt::SkipEmptyParts);
    if (words.size() < 2)
        return std::nullopt;
    std::vector<qsizetype> kept;
    for (const QString &word : words)
        kept.push_back(word.size());
    // A single letter is as wide as the point that replaces it.
    const auto shortened = [&](std::size_t i) {
        return kept[i] - (kept[i] == words[static_cast<qsizetype>(i)].size() ? 2 : 1);
    };
    while (true) {
        std::optional<std::size_t> longest;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            if (shortened(i) >= kLeast && (!longest || kept[i] > kept[*longest]))
                longest = i;
        }
        if (!longest)
            return std::nullopt;
        kept[*longest] = shortened(*longest);
        QStringList parts;
        for (std::size_t i = 0; i < kept.size(); ++i) {
            const QString &word = words[static_cast<qsizetype>(i)];
            QString part = word.left(kept[i]);
            if (part.back().isHighSurrogate()) // keeps surrogate pairs together
                part.chop(1);
            parts << (part.size() < word.size() ? part + u'.' : part);
        }
        if (const QString text = parts.join(u' '); metrics.horizontalAdvance(text) <= width)
            return text;
    }
}

} // namespace unprojector::gui
