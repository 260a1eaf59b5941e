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

/// The words as they are typed, whatever their case; a typed hyphen and a straight quote find those of print.
QRegularExpression findPattern(const QString &words);

/// Finds words in a page of text: all hits are marked, and one of them is the present one. Hidden until it is opened.
class FindBar : public QWidget {
    Q_OBJECT
public:
    /// @param page  outlives the bar
    explicit FindBar(QTextEdit &page, QWidget *parent = nullptr);

    /// Shows the field with the last search text, selected.
    void openField();
    /// Shows the field with these words, and their first hit from a position of the text on; the focus stays where it
    /// is.
    void find(const QString &words, int from);
    /// Takes the marks away; the present hit stays selected in the page.
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
