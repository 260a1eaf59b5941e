#pragma once

#include <QSize>
#include <QWidget>

#include <string>

class QLabel;
class QTextBrowser;
class QToolButton;

namespace unprojector::gui {

/// What to look at in the example that is shown: title, text, source. About 340 logical pixels wide; the text scrolls
/// where it is taller than the note.
class ExampleNote : public QWidget {
    Q_OBJECT
public:
    explicit ExampleNote(QWidget *parent = nullptr);

    /// @param id  of one of examples(); the note is emptied for any other
    void showExample(const std::string &id);
    void clear();
    bool isEmpty() const;
    /// Where the frame around the note has no button that closes it, the note has one. At first it has none.
    void setClosesItself(bool does);
    /// Title, text and source, plain.
    QString text() const;

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    /// Its own button was pressed.
    void closeRequested();
    /// A link to the formulas was followed.
    /// @param anchor  a name in formulas.html
    void formulasRequested(const QString &anchor);
    /// A link to the size of the tutorial's window was followed.
    /// @param size  of the view, logical pixels
    void viewSizeRequested(const QSize &size);

private:
    QLabel *m_title;
    QToolButton *m_close;
    QTextBrowser *m_text;
    QLabel *m_source;
};

} // namespace unprojector::gui
