#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace unprojector::gui {

/// A heading of a page of the manual with the text below it, up to the next heading.
struct ManualSection {
    QString title;
    int level = 1;       ///< 1: the page's own
    QString slug;        ///< by which links lead to it, as GitHub makes it of the title
    QString englishSlug; ///< of the same heading in the English page
    QString text;        ///< as read, the title included
};

/// A page of the manual.
struct ManualPage {
    QString name; ///< "picking"
    QString title;
    QString markdown;
    std::vector<ManualSection> sections;

    /// The index of a heading; the page's own where there is none of this slug, or it is empty.
    /// @param slug  of the page's language or of the English page
    int indexOf(const QString &slug) const;
    bool has(const QString &slug) const;
};

/// The pages, in the order in which the first of them, index.md, links to them; those without a link last.
/// @param folder  of the language, in the resources: "manual/zh_CN"; a page that it lacks is the English one
std::vector<ManualPage> manualPages(const QString &folder);

/// The anchor that GitHub gives a heading: "Left and right" is "left-and-right".
QString headingSlug(const QString &title);

/// Where a link of the manual leads.
struct ManualPlace {
    QString page; ///< empty: the page of the link
    QString slug; ///< empty: the page's beginning
};
/// @param address  "picking.md#snap-to-the-mesh", "picking", "#limits"
ManualPlace manualPlace(const QString &address);

/// What to mark of typed words in a section that matches them: all of them where they stand there as typed, else the
/// longest; empty where not each of them is in the section.
QString wordsIn(const ManualSection &section, const QString &words);

} // namespace unprojector::gui
