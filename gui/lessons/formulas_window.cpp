#include "gui/lessons/formulas_window.h"

#include "gui/lessons/figure_object.h"
#include "gui/lessons/find_bar.h"
#include "gui/text/formula_layout.h"
#include "gui/text/formula_markup.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QFile>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QResizeEvent>
#include <QScrollBar>
#include <QTextBrowser>
#include <QTextFormat>
#include <QToolBar>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
namespace {

constexpr double kPointSize = 11.0;
constexpr int kLeastPercent = 60;
constexpr int kMostPercent = 300;
constexpr int kStepPercent = 10;
/// The width of the text column, in widths of the letter x: longer lines are hard to read.
constexpr double kColumnLetters = 104.0;

/// One column in the middle of the window, as on paper.
class Page : public QTextBrowser {
public:
    Page() : m_figures(*this) { document()->documentLayout()->registerHandler(QTextFormat::ImageObject, &m_figures); }

    void fitColumn()
    {
        const int column =
            static_cast<int>(kColumnLetters * QFontMetricsF(document()->defaultFont()).horizontalAdvance(u'x'));
        const int margin = std::max(14, (width() - verticalScrollBar()->sizeHint().width() - column) / 2);
        setViewportMargins(margin, 0, margin, 0);
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        fitColumn(); // before the layout, which uses the remaining width
        QTextBrowser::resizeEvent(event);
    }

    /// The window clamps the zoom; the text browser would not.
    void wheelEvent(QWheelEvent *event) override
    {
        if (event->modifiers() & Qt::ControlModifier) {
            auto *window = static_cast<FormulasWindow *>(this->window());
            const int notches = event->angleDelta().y();
            window->setZoomPercent(window->zoomPercent()
                                   + (notches > 0   ? kStepPercent
                                      : notches < 0 ? -kStepPercent
                                                    : 0));
            event->accept();
            return;
        }
        QTextBrowser::wheelEvent(event);
    }

    /// Shows the description of a figure.
    bool viewportEvent(QEvent *event) override
    {
        if (event->type() != QEvent::ToolTip)
            return QTextBrowser::viewportEvent(event);
        const auto *help = static_cast<QHelpEvent *>(event);
        const QPointF inText =
            QPointF(help->pos()) + QPointF(horizontalScrollBar()->value(), verticalScrollBar()->value());
        const QTextFormat format = document()->documentLayout()->formatAt(inText);
        const QString words = format.isImageFormat() ? format.stringProperty(QTextFormat::ImageAltText) : QString();
        if (words.isEmpty())
            return QTextBrowser::viewportEvent(event);
        QToolTip::showText(help->globalPos(), QStringLiteral("<p>%1</p>").arg(words.toHtmlEscaped()), viewport());
        return true;
    }

private:
    FigureObject m_figures;
};

/// The page with the colours that differ from its text.
/// @param name  in the folder of the help: "formulas.html"
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

FormulasWindow::FormulasWindow(QWidget *parent) : QDialog(parent), m_page(new Page), m_find(new FindBar(*m_page))
{
    setWindowTitle(tr("Formulas"));
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    constexpr int kDigits = 128, kLines = 44;
    resize(QSize(kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing())
               .boundedTo(screen()->availableSize() * 9 / 10));

    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setAutoFillBackground(true);
    m_page->setAccessibleName(tr("Formulas"));
    m_page->document()->setDefaultFont(formulaFont(kPointSize));
    m_page->document()->setDocumentMargin(18.0);
    showPage();

    auto *bar = new QToolBar;
    bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    bar->setAccessibleName(tr("Page"));
    const auto add = [this, bar](const QString &text, const QString &tip, const QList<QKeySequence> &keys, auto slot) {
        QAction *action = bar->addAction(text);
        action->setShortcuts(keys);
        action->setToolTip(tr("%1 (%2)").arg(tip, keys.first().toString(QKeySequence::NativeText)));
        connect(action, &QAction::triggered, this, slot);
        return action;
    };
    add(tr("Contents"), tr("Back to the contents"), {Qt::ALT | Qt::Key_Up},
        [this] { showFormula(QStringLiteral("contents")); });
    bar->addSeparator();
    add(tr("A−"), tr("Smaller text"), {QKeySequence::ZoomOut},
        [this] { setZoomPercent(zoomPercent() - kStepPercent); });
    m_usualSize = add({}, tr("Text in its usual size"), {Qt::CTRL | Qt::Key_0}, [this] { setZoomPercent(100); });
    QList<QKeySequence> larger = QKeySequence::keyBindings(QKeySequence::ZoomIn);
    larger << QKeySequence(Qt::CTRL | Qt::Key_Equal);
    add(tr("A+"), tr("Larger text"), larger, [this] { setZoomPercent(zoomPercent() + kStepPercent); });
    setZoomPercent(100);
    bar->addSeparator();
    add(tr("Find"), tr("Find words in the page"), {QKeySequence::Find}, [this] { m_find->openField(); });
    const auto addKeys = [this](QKeySequence::StandardKey standard, const QKeySequence &everywhere, auto does) {
        auto *action = new QAction(this);
        QList<QKeySequence> keys = QKeySequence::keyBindings(standard);
        if (!keys.contains(everywhere))
            keys << everywhere;
        action->setShortcuts(keys);
        connect(action, &QAction::triggered, this, does);
        addAction(action);
    };
    addKeys(QKeySequence::FindNext, Qt::Key_F3, [this] { m_find->findNext(); });
    addKeys(QKeySequence::FindPrevious, Qt::SHIFT | Qt::Key_F3, [this] { m_find->findPrevious(); });
    // A page without a caret doesn't handle these keys.
    QScrollBar *scroll = m_page->verticalScrollBar();
    addKeys(QKeySequence::MoveToStartOfDocument, Qt::CTRL | Qt::Key_Home, [scroll] { scroll->setValue(0); });
    addKeys(QKeySequence::MoveToEndOfDocument, Qt::CTRL | Qt::Key_End,
            [scroll] { scroll->setValue(scroll->maximum()); });

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(m_page);
    layout->addWidget(m_find); // below the page: the text stays in place when the field appears
    m_page->setFocus();
}

void FormulasWindow::showPage()
{
    // Paper's colours, or the window's if it is dark.
    QPalette colors = QGuiApplication::palette();
    const bool isDark = colors.color(QPalette::Window).lightnessF() < 0.5F;
    if (!isDark) {
        colors.setColor(QPalette::Base, Qt::white);
        colors.setColor(QPalette::Text, QColor(0x1a, 0x1a, 0x1a));
        colors.setColor(QPalette::Link, QColor(0x1f, 0x4e, 0x8c));
    }
    colors.setColor(QPalette::Window, colors.color(QPalette::Base));
    colors.setColor(QPalette::WindowText, colors.color(QPalette::Text));
    m_page->setPalette(colors);
    const int place = m_page->verticalScrollBar()->value();
    const QColor link = colors.color(QPalette::Link);
    //: The file of the page in this language, in resources/help.
    const QString name = tr("formulas.html");
    m_page->setHtml(pageText(name, colors.color(QPalette::Text), isDark ? link : QColor(0x1f, 0x3a, 0x5f), link,
                             isDark ? QColor(0xa0, 0xa4, 0xaa) : QColor(0x66, 0x66, 0x66)));
    m_page->verticalScrollBar()->setValue(place);
    m_find->searchAgain();
}

void FormulasWindow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_find->isVisible())
        m_find->closeField();
    else
        QDialog::keyPressEvent(event);
}

void FormulasWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showPage();
}

void FormulasWindow::showFormula(const QString &anchor)
{
    m_page->scrollToAnchor(anchor);
    if (anchor.isEmpty())
        return;
    // An anchor is in a line of the formula: the part of a fraction above it must be visible, too.
    constexpr int kLinesAbove = 1;
    QScrollBar *bar = m_page->verticalScrollBar();
    bar->setValue(bar->value() - kLinesAbove * QFontMetrics(m_page->document()->defaultFont()).lineSpacing());
}

int FormulasWindow::zoomPercent() const
{
    return static_cast<int>(std::lround(100.0 * m_page->document()->defaultFont().pointSizeF() / kPointSize));
}

void FormulasWindow::setZoomPercent(int percent)
{
    percent = std::clamp(percent, kLeastPercent, kMostPercent);
    QFont font = m_page->document()->defaultFont();
    font.setPointSizeF(kPointSize * percent / 100.0);
    m_page->document()->setDefaultFont(font);
    static_cast<Page *>(m_page)->fitColumn();
    m_usualSize->setText(tr("%1 %").arg(percent));
}

} // namespace unprojector::gui
