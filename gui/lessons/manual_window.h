#pragma once

#include "gui/lessons/manual_pages.h"
#include "gui/lessons/reading_window.h"

#include <vector>

class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;
class QUrl;

namespace unprojector::gui {

/// The window of the manual: table of contents, a search in all pages, and the current page.
class ManualWindow : public ReadingWindow {
    Q_OBJECT
public:
    explicit ManualWindow(QWidget *parent = nullptr);

    /// Shows a section of the manual, and adds the former one to the history.
    /// @param address  in the form of links: "picking.md#snap-to-the-mesh"; empty: the first page
    void openPlace(const QString &address);
    /// Goes back in the history of visited sections.
    void goBack() { walk(-1); }
    void goForward() { walk(1); }

    const std::vector<ManualPage> &pages() const { return m_pages; }
    const ManualPage &currentPage() const { return m_pages[static_cast<std::size_t>(m_present.page)]; }
    QLineEdit &searchField() { return *m_search; }
    /// The pages with their headings; during a search only the pages and headings with matching
    /// text.
    QTreeWidget &contents() { return *m_contents; }

protected:
    void setText(const PageColors &colors) override;
    void columnChanged() override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// A position in the manual: the indices of a page and of its section.
    struct Place {
        int page = 0;
        int section = 0;
        int scroll = -1; ///< scroll position when the user left; -1: at the section
    };

    void makeSide();
    void follow(const QUrl &link);
    void visit(const Place &place);
    void walk(int by);
    void showPlace(const Place &place);
    /// The position of a heading in the page's text.
    int positionOf(int section) const;
    void fillContents();
    void markPlace();
    void openHit(const QTreeWidgetItem &item);

    std::vector<ManualPage> m_pages;
    QWidget *m_side = nullptr; ///< the contents with the search
    QLineEdit *m_search = nullptr;
    QTreeWidget *m_contents = nullptr;
    QAction *m_back = nullptr, *m_forward = nullptr;
    Place m_present;
    std::vector<Place> m_before, m_after; ///< the history for Back and Forward, the next one last
};

} // namespace unprojector::gui
