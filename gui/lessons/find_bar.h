#pragma once

#include <QTextCursor>
#include <QWidget>

#include <vector>

class QLabel;
class QLineEdit;
class QTextEdit;
class QRegularExpression;
class QToolButton;

namespace unprojector::gui {

/// The search pattern for typed words, case-insensitive. A typed hyphen also matches minus and
/// dash; a straight quote also matches a curly quote and a prime.
QRegularExpression findPattern(const QString &words);

/// A bar that searches a page of text. It marks all hits; one of them is the current hit. It is
/// hidden until it is opened.
class FindBar : public QWidget {
    Q_OBJECT
public:
    /// @param page  outlives the bar
    explicit FindBar(QTextEdit &page, QWidget *parent = nullptr);

    /// Shows the field with the last search text, selected.
    void openField();
    /// Shows the field with these words, and their first hit at or after a text position. The focus
    /// does not change.
    void find(const QString &words, int from);
    /// Hides the bar and removes the marks; the current hit stays selected in the page.
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
