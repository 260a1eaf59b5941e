#include "gui/lessons/manual_pages.h"

#include "gui/lessons/find_bar.h"

#include <QDir>
#include <QFile>
#include <QHash>
#include <QRegularExpression>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QtGui/qtguiglobal.h>

#include <algorithm>

namespace unprojector::gui {
namespace {

const QString kEnglishFolder = QStringLiteral("manual");
const QString kIndex = QStringLiteral("index");

/// The contents of a page's file; empty if there is no such file.
QString fileText(const QString &folder, const QString &name)
{
    QFile file(QStringLiteral(":/%1/%2.md").arg(folder, name));
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

std::vector<ManualSection> sectionsOf(const QString &markdown)
{
    std::vector<ManualSection> sections;
    QHash<QString, int> uses;
    QTextDocument text;
    setManualText(text, markdown);
    for (QTextBlock block = text.begin(); block.isValid(); block = block.next()) {
        if (const int level = block.blockFormat().headingLevel(); level > 0) {
            QString slug = headingSlug(block.text());
            if (const int before = uses[slug]++; before > 0)
                slug += QStringLiteral("-%1").arg(before);
            sections.push_back({block.text(), level, slug, slug, {}});
        }
        if (!sections.empty())
            sections.back().text += block.text() + u'\n';
    }
    return sections;
}

ManualPage pageOf(const QString &folder, const QString &name)
{
    ManualPage page{name, name, fileText(folder, name), {}};
    const QString english = fileText(kEnglishFolder, name);
    const bool isTranslated = !page.markdown.isEmpty() && folder != kEnglishFolder;
    if (page.markdown.isEmpty())
        page.markdown = english;
    page.sections = sectionsOf(page.markdown);
    if (isTranslated) {
        const std::vector<ManualSection> same = sectionsOf(english);
        for (std::size_t i = 0; i < std::min(same.size(), page.sections.size()); ++i)
            page.sections[i].englishSlug = same[i].slug;
    }
    if (!page.sections.empty())
        page.title = page.sections.front().title;
    return page;
}

QStringList pageNames(const QString &index)
{
    QStringList names{kIndex};
    static const QRegularExpression link(QStringLiteral("\\]\\(([a-z0-9-]+)\\.md"));
    for (auto matches = link.globalMatch(index); matches.hasNext();)
        names << matches.next().captured(1);
    const QStringList files = QDir(QStringLiteral(":/") + kEnglishFolder).entryList({QStringLiteral("*.md")});
    for (const QString &file : files)
        names << file.chopped(3);
    names.removeDuplicates();
    return names;
}

} // namespace

int ManualPage::indexOf(const QString &slug) const
{
    for (const auto member : {&ManualSection::slug, &ManualSection::englishSlug}) {
        const auto found = std::find_if(sections.begin(), sections.end(),
                                        [&](const ManualSection &section) { return section.*member == slug; });
        if (found != sections.end())
            return static_cast<int>(found - sections.begin());
    }
    return 0;
}

bool ManualPage::has(const QString &slug) const
{
    return std::any_of(sections.begin(), sections.end(), [&](const ManualSection &section) {
        return section.slug == slug || section.englishSlug == slug;
    });
}

std::vector<ManualPage> manualPages(const QString &folder)
{
    std::vector<ManualPage> pages;
    for (const QString &name : pageNames(fileText(kEnglishFolder, kIndex))) {
        ManualPage page = pageOf(folder, name);
        if (!page.markdown.isEmpty())
            pages.push_back(std::move(page));
    }
    return pages;
}

void setManualText(QTextDocument &text, const QString &markdown)
{
#if QT_CONFIG(textmarkdownreader)
    text.setMarkdown(markdown, QTextDocument::MarkdownDialectGitHub);
#else
    text.clear();
    QTextCursor cursor(&text);
    bool isCode = false;
    for (const QString &line : markdown.split(u'\n')) {
        isCode ^= line.startsWith(QStringLiteral("```"));
        int level = 0;
        while (!isCode && level < line.size() && line[level] == u'#')
            ++level;
        QTextBlockFormat block;
        block.setHeadingLevel(level);
        if (cursor.atStart())
            cursor.setBlockFormat(block);
        else
            cursor.insertBlock(block);
        cursor.insertText(level > 0 ? line.mid(level).trimmed() : line);
    }
#endif
}

QString headingSlug(const QString &title)
{
    QString slug;
    for (const QChar c : title.toLower()) {
        if (c == u' ')
            slug += u'-';
        else if (c.isLetterOrNumber() || c.isMark() || c == u'-' || c == u'_')
            slug += c;
    }
    return slug;
}

ManualPlace manualPlace(const QString &address)
{
    // Only the name counts: in the sources, a translated page is one folder deeper.
    QString page = address.section(u'#', 0, 0).section(u'/', -1);
    if (page.endsWith(QStringLiteral(".md")))
        page.chop(3);
    return {page, address.section(u'#', 1)};
}

QString wordsIn(const ManualSection &section, const QString &words)
{
    if (section.text.contains(findPattern(words)))
        return words;
    QString longest;
    for (const QString &word : words.split(u' ', Qt::SkipEmptyParts)) {
        if (!section.text.contains(findPattern(word)))
            return {};
        if (word.size() > longest.size())
            longest = word;
    }
    return longest;
}

} // namespace unprojector::gui
