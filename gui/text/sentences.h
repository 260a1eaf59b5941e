#pragma once

#include <QString>
#include <QStringList>

namespace unprojector::gui {

/// Sentences one after the other: with a blank between them, and with none where the one before ends as Chinese ones do, whose
/// full stop has its own room. Empty ones are left out.
inline QString inARow(const QStringList &said)
{
    constexpr QStringView kWideEnds = u"。！？；：";
    QString text;
    for (const QString &sentence : said) {
        if (sentence.isEmpty())
            continue;
        if (!text.isEmpty() && !kWideEnds.contains(text.back()))
            text += u' ';
        text += sentence;
    }
    return text;
}

} // namespace unprojector::gui
