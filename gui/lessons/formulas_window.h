#pragma once

#include "gui/lessons/figure_object.h"
#include "gui/lessons/reading_window.h"

namespace unprojector::gui {

/// All formulas, typeset as a handout, each with its source, and the errors found in the tutorials.
class FormulasWindow : public ReadingWindow {
    Q_OBJECT
public:
    explicit FormulasWindow(QWidget *parent = nullptr);

    /// Scrolls to a position of the page.
    /// @param anchor  a name in formulas.html: "ortho", "errors"
    void showFormula(const QString &anchor);

protected:
    void setText(const PageColors &colors) override;

private:
    FigureObject m_figures;
};

} // namespace unprojector::gui
