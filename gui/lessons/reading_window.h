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

/// A window to read in: one column of text as on paper, with zoom and a search in the page. Not modal.
class ReadingWindow : public QDialog {
    Q_OBJECT
public:
    /// The size of the text in percent of the usual one.
    int zoomPercent() const;
    /// @param percent  kept between 60 and 300
    void setZoomPercent(int percent);
    void zoomIn();
    void zoomOut();

    QTextBrowser &page() { return *m_page; }
    FindBar &findBar() { return *m_find; }

protected:
    struct PageColors {
        QColor text, heading, link, quiet;
    };

    /// @param font  of the text, in its usual size
    ReadingWindow(const QString &title, const QFont &font, QWidget *parent);

    /// Puts the page's text into page().
    virtual void setText(const PageColors &colors) = 0;
    /// Called whenever the column has another width.
    virtual void columnChanged() {}
    /// Sets the text anew, in the colours of now, where it was scrolled to. To be called at the end of a constructor.
    void showText();
    /// A button on the bar, with its first key in the tool tip.
    QAction *addTool(const QString &text, const QString &tip, const QList<QKeySequence> &keys,
                     std::function<void()> slot);
    /// The buttons that every such window has, after its own.
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
    QTextBrowser *m_page; ///< the same
    FindBar *m_find;
    QToolBar *m_bar;
    QSplitter *m_body;
    QAction *m_usualSize = nullptr;
};

} // namespace unprojector::gui
