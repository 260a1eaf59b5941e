#pragma once

#include <QColor>
#include <QDialog>
#include <QFont>
#include <QKeySequence>
#include <QList>

#include <functional>

class QAction;
class QSplitter;
class QTextBrowser;
class QToolBar;

namespace unprojector::gui {

class FindBar;

/// A window for reading: one column of text with zoom and a search in the page. It is not modal.
class ReadingWindow : public QDialog {
    Q_OBJECT
public:
    /// The text size in percent of the default.
    int zoomPercent() const;
    /// @param percent  clamped to 60 to 300
    void setZoomPercent(int percent);
    void zoomIn();
    void zoomOut();

    QTextBrowser &page() { return *m_page; }
    FindBar &findBar() { return *m_find; }

protected:
    struct PageColors {
        QColor text, heading, link, quiet;
    };

    /// @param font  the text's font in its default size
    ReadingWindow(const QString &title, const QFont &font, QWidget *parent);

    /// Puts the page's text into page().
    virtual void setText(const PageColors &colors) = 0;
    /// Called when the column's width has changed.
    virtual void columnChanged() {}
    /// Rebuilds the text in the current colours and keeps the scroll position. A subclass calls it
    /// at the end of its constructor.
    void showText();
    /// Adds a button to the bar; its tooltip shows the first key.
    QAction *addTool(const QString &text, const QString &tip, const QList<QKeySequence> &keys,
                     std::function<void()> slot);
    /// Adds the buttons that all reading windows share, after the window's own.
    void addReadingTools();
    /// Puts a widget at the left of the page.
    void addSide(QWidget *side);

    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    class Page;

    void addKeys(QKeySequence::StandardKey standard, const QKeySequence &everywhere, std::function<void()> slot);

    double m_usualPoints;
    Page *m_column;
    QTextBrowser *m_page; ///< the same object as m_column
    FindBar *m_find;
    QToolBar *m_bar;
    QSplitter *m_body;
    QAction *m_usualSize = nullptr;
};

} // namespace unprojector::gui
