#pragma once

#include "gui/lessons/manual_pages.h"
#include "gui/lessons/reading_window.h"

#include <vector>

class QLineEdit;
class QTreeWidget;
class QTreeWidgetItem;
class QUrl;

namespace unprojector::gui {

/// The manual: its contents, a search in all pages, and a page.
class ManualWindow : public ReadingWindow {
    Q_OBJECT
public:
    explicit ManualWindow(QWidget *parent = nullptr);

    /// Shows a place, after which Back leads to the one before.
    /// @param address  as a link of a page: "picking.md#snap-to-the-mesh"; empty: the first page
    void openPlace(const QString &address);
    /// Of the pages visited.
    void goBack() { walk(-1); }
    void goForward() { walk(1); }

    const std::vector<ManualPage> &pages() const { return m_pages; }
    const ManualPage &currentPage() const { return m_pages[static_cast<std::size_t>(m_present.page)]; }
    QLineEdit &searchField() { return *m_search; }
    /// Pages, and their headings below them; while a search is typed, those that have its words.
    QTreeWidget &contents() { return *m_contents; }

protected:
    void setText(const PageColors &colors) override;
    void columnChanged() override;
    void keyPressEvent(QKeyEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    /// Indices of a page and of a section in it.
    struct Place {
        int page = 0;
        int section = 0;
        int scroll = -1; ///< where it was left; -1: at the section
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
    std::vector<Place> m_before, m_after; ///< where Back and Forward lead, the next ones last
};

} // namespace unprojector::gui
