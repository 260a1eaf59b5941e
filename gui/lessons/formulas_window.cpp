#include "gui/lessons/formulas_window.h"

#include "gui/text/formula_layout.h"
#include "gui/text/formula_markup.h"

#include <QAbstractTextDocumentLayout>
#include <QFile>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextFormat>

namespace unprojector::gui {
namespace {

constexpr double kPointSize = 11.0;

/// The HTML of a page with its colours filled in.
/// @param name  a file in the help's folder: "formulas.html"
QString pageText(const QString &name, const QColor &lines, const QColor &heading, const QColor &link,
                 const QColor &source)
{
    QFile file(QStringLiteral(":/help/") + name);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString colors = QStringLiteral("h2 { color: %1; } a { color: %2; } p.source { color: %3; }\n</style>")
                               .arg(heading.name(), link.name(), source.name());
    return typeset(QString::fromUtf8(file.readAll()).replace(QStringLiteral("</style>"), colors), lines);
}

} // namespace

FormulasWindow::FormulasWindow(QWidget *parent)
    : ReadingWindow(tr("Formulas"), formulaFont(kPointSize), parent), m_figures(page())
{
    page().document()->documentLayout()->registerHandler(QTextFormat::ImageObject, &m_figures);
    showText();
    addTool(tr("Contents"), tr("Back to the contents"), {Qt::ALT | Qt::Key_Up},
            [this] { showFormula(QStringLiteral("contents")); });
    addReadingTools();
}

void FormulasWindow::setText(const PageColors &colors)
{
    //: The file of the page in this language, in resources/help.
    const QString name = tr("formulas.html");
    page().setHtml(pageText(name, colors.text, colors.heading, colors.link, colors.quiet));
}

void FormulasWindow::showFormula(const QString &anchor)
{
    page().scrollToAnchor(anchor);
    if (anchor.isEmpty())
        return;
    // An anchor is in a line of the formula: the part of a fraction above it must be visible, too.
    constexpr int kLinesAbove = 1;
    QScrollBar *bar = page().verticalScrollBar();
    bar->setValue(bar->value() - kLinesAbove * QFontMetrics(page().document()->defaultFont()).lineSpacing());
}

} // namespace unprojector::gui
