#include "gui/text/formula_markup.h"

#include <QRegularExpression>
#include <QStringList>

namespace unprojector::gui {
namespace {

/// The position of the brace that closes the one at `open`; the end of the text if there is none.
qsizetype closingBrace(const QString &text, qsizetype open)
{
    int depth = 0;
    for (qsizetype i = open; i < text.size(); ++i) {
        if (text[i] == u'{')
            ++depth;
        else if (text[i] == u'}' && --depth == 0)
            return i;
    }
    return text.size();
}

/// The parts between the separators outside all braces.
QStringList splitOutsideBraces(const QString &text, QChar separator)
{
    QStringList parts{QString()};
    int depth = 0;
    for (const QChar c : text) {
        depth += c == u'{' ? 1 : c == u'}' ? -1 : 0;
        if (c == separator && depth == 0)
            parts << QString();
        else
            parts.last() += c;
    }
    return parts;
}

/// Sets single Latin letters in italics, except indices and vectors.
QString withItalics(const QString &text)
{
    static const QRegularExpression letter(
        QStringLiteral("<(sub|sup|b)>.*?</\\1>|<[^>]*>|(?<![A-Za-z])([A-Za-z])(?![A-Za-z])"));
    constexpr int kLetter = 2;
    QString set;
    qsizetype end = 0;
    for (auto matches = letter.globalMatch(text); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        set += text.mid(end, match.capturedStart() - end);
        set += match.capturedStart(kLetter) < 0 ? match.captured()
                                                : QStringLiteral("<i>%1</i>").arg(match.captured(kLetter));
        end = match.capturedEnd();
    }
    return set + text.mid(end);
}

QString row(const QString &text, const QString &lines);

QString fraction(const QStringList &parts, const QString &lines)
{
    return QStringLiteral("<table cellspacing='0' cellpadding='0'>"
                          "<tr><td align='center' style='border-bottom: 1px solid %1; padding-left: 3px; "
                          "padding-right: 3px'>%2</td></tr>"
                          "<tr><td align='center' style='padding-left: 3px; padding-right: 3px'>%3</td></tr></table>")
        .arg(lines, row(parts.value(0).trimmed(), lines), row(parts.value(1).trimmed(), lines));
}

QString matrix(const QString &text, const QString &lines)
{
    const QStringList rows = text.split(u';');
    const QString bracket =
        QStringLiteral("<td rowspan='%1' width='5' style='border-%2: 1px solid %3; border-top: 1px solid %3; "
                       "border-bottom: 1px solid %3'></td>");
    QString set = QStringLiteral("<table cellspacing='0' cellpadding='0'>");
    for (int r = 0; r < rows.size(); ++r) {
        set += QStringLiteral("<tr>");
        if (r == 0)
            set += bracket.arg(rows.size()).arg(QLatin1String("left"), lines);
        for (const QString &entry : splitOutsideBraces(rows[r], u','))
            set += QStringLiteral("<td align='center' valign='middle' style='padding: 2px 7px 2px 7px'>%1</td>")
                       .arg(row(entry.trimmed(), lines));
        if (r == 0)
            set += bracket.arg(rows.size()).arg(QLatin1String("right"), lines);
        set += QStringLiteral("</tr>");
    }
    return set + QStringLiteral("</table>");
}

/// Words, fractions and matrices side by side, on one axis.
QString row(const QString &text, const QString &lines)
{
    if (!text.contains(u'{'))
        return withItalics(text);
    QStringList pieces;
    qsizetype start = 0;
    for (qsizetype open; (open = text.indexOf(u'{', start)) >= 0;) {
        const qsizetype close = closingBrace(text, open);
        pieces << withItalics(text.mid(start, open - start).trimmed());
        const QString inner = text.mid(open + 1, close - open - 1);
        const QStringList parts = splitOutsideBraces(inner, u'|');
        pieces << (parts.size() == 2 ? fraction(parts, lines) : matrix(inner, lines));
        start = close + 1;
    }
    pieces << withItalics(text.mid(start).trimmed());
    QString set = QStringLiteral("<table cellspacing='0' cellpadding='0'><tr>");
    for (const QString &piece : pieces) {
        if (!piece.isEmpty())
            set += QStringLiteral(
                       "<td valign='middle' style='padding-left: 2px; padding-right: 2px; white-space: nowrap'>%1</td>")
                       .arg(piece);
    }
    return set + QStringLiteral("</tr></table>");
}

} // namespace

QString typeset(const QString &page, const QColor &lines)
{
    static const QRegularExpression formula(
        QStringLiteral("<formula(?: no=\"([^\"]*)\")?(?: name=\"([^\"]*)\")?>(.*?)</formula>"),
        QRegularExpression::DotMatchesEverythingOption);
    QString set;
    qsizetype end = 0;
    for (auto matches = formula.globalMatch(page); matches.hasNext();) {
        const QRegularExpressionMatch match = matches.next();
        set += page.mid(end, match.capturedStart() - end);
        if (!match.captured(2).isEmpty())
            set += QStringLiteral("<a name='%1'></a>").arg(match.captured(2));
        const QString number = match.captured(1).isEmpty() ? QString() : u'(' + match.captured(1) + u')';
        set += QStringLiteral("<table width='100%' cellspacing='0' cellpadding='4'><tr><td width='24'></td><td "
                              "valign='middle'>%1</td>"
                              "<td align='right' valign='middle'>%2</td></tr></table>")
                   .arg(row(match.captured(3).simplified(), lines.name()), number);
        end = match.capturedEnd();
    }
    return set + page.mid(end);
}

} // namespace unprojector::gui
