#include "gui/text/sentences.h"

#include "core/base/translation.h"

namespace unprojector::gui {

QString ended(const std::string &said)
{
    constexpr QStringView kEnds = u".!?…。！？";
    QString line = QString::fromStdString(said);
    if (!line.isEmpty() && !kEnds.contains(line.back()))
        line += base::language() == base::Language::Chinese ? u'。' : u'.';
    return line;
}

QString sentence(const std::string &said)
{
    QString line = ended(said);
    if (!line.isEmpty())
        line[0] = line[0].toUpper();
    return line;
}

QString joinSentences(const QStringList &said)
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
