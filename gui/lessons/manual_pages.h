#pragma once

#include <QString>
#include <QStringList>

#include <vector>

class QTextDocument;

namespace unprojector::gui {

/// A heading of a page of the manual with the text below it, up to the next heading.
struct ManualSection {
    QString title;
    int level = 1;       ///< 1: the page's title
    QString slug;        ///< the anchor for links, in GitHub's form
    QString englishSlug; ///< the slug of the same heading in the English page
    QString text;        ///< plain text without Markdown, with the title
};

/// A page of the manual.
struct ManualPage {
    QString name; ///< "picking"
    QString title;
    QString markdown;
    std::vector<ManualSection> sections;

    /// The index of the section with a slug; the first section if there is none, or the slug is
    /// empty.
    /// @param slug  in the page's language or in English
    int indexOf(const QString &slug) const;
    bool has(const QString &slug) const;
};

/// All pages, in the order of the links in index.md, which is the first page. Pages without a link
/// come last.
/// @param folder  the language's folder in the resources: "manual/zh_CN"; pages missing there are
/// English
std::vector<ManualPage> manualPages(const QString &folder);

/// Renders a page. A Qt without its Markdown reader shows the headings, and all else as written.
void setManualText(QTextDocument &text, const QString &markdown);

/// GitHub's anchor for a heading: "Left and right" gives "left-and-right".
QString headingSlug(const QString &title);

/// The target of a link in the manual.
struct ManualPlace {
    QString page; ///< empty: the page with the link
    QString slug; ///< empty: the page's beginning
};
/// Parses the address of a link: "picking.md#snap-to-the-mesh", "picking", "#limits".
ManualPlace manualPlace(const QString &address);

/// The part of the typed words to mark in a section: all of them if the section has exactly this
/// phrase, else the longest word. Empty if the section lacks one of the words.
QString wordsIn(const ManualSection &section, const QString &words);

} // namespace unprojector::gui
