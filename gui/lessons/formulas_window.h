#pragma once

#include <QDialog>

class QAction;
class QTextBrowser;

namespace unprojector::gui {

class FindBar;

/// All formulas, typeset as a handout, each with its source, and the errors found in the tutorials.
/// Not modal.
class FormulasWindow : public QDialog {
    Q_OBJECT
public:
    explicit FormulasWindow(QWidget *parent = nullptr);

    /// Scrolls to a position of the page.
    /// @param anchor  a name in formulas.html: "ortho", "errors"
    void showFormula(const QString &anchor);

    /// The size of the text in percent of the default.
    int zoomPercent() const;
    /// @param percent  clamped to 60 … 300
    void setZoomPercent(int percent);

    QTextBrowser &page() { return *m_page; }
    FindBar &findBar() { return *m_find; }

protected:
    void changeEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    void showPage();

    QTextBrowser *m_page;
    FindBar *m_find;
    QAction *m_usualSize = nullptr;
};

} // namespace unprojector::gui
