#pragma once

#include <QTextCursor>
#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QTextEdit;
class QToolButton;

namespace unprojector::gui {

/// Finds words in a page of text: marks all hits, one of them as the current one. Hidden until it
/// is opened.
class FindBar : public QWidget {
    Q_OBJECT
public:
    /// @param page  outlives the bar
    explicit FindBar(QTextEdit &page, QWidget *parent = nullptr);

    /// Shows the field with the last search text, selected.
    void openField();
    /// Removes the marks; the current hit stays selected in the page.
    void closeField();
    /// Goes to the hit after or before the current one, and wraps around. Opens the bar if it is
    /// closed.
    void findNext() { step(1); }
    void findPrevious() { step(-1); }
    /// Repeats the search after the page's text was replaced.
    void searchAgain();

    /// The hits in the page, in order.
    const std::vector<QTextCursor> &hits() const { return m_hits; }

protected:
    void keyPressEvent(QKeyEvent *event) override;

private:
    void search(int from);
    void step(int by);
    void showHit();
    void mark();
    int firstVisiblePosition() const;

    QTextEdit &m_page;
    QLineEdit *m_field;
    QLabel *m_count;
    QToolButton *m_previous, *m_next;
    std::vector<QTextCursor> m_hits;
    int m_present = -1; ///< index of the current hit; -1 without hits
    int m_start = 0;    ///< where the search began: further typing searches from there
};

} // namespace unprojector::gui
