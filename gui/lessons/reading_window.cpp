#include "gui/lessons/reading_window.h"

#include "gui/lessons/find_bar.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QGuiApplication>
#include <QHelpEvent>
#include <QKeyEvent>
#include <QResizeEvent>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBrowser>
#include <QTextFormat>
#include <QToolBar>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr int kLeastPercent = 60;
constexpr int kMostPercent = 300;
constexpr int kStepPercent = 10;
/// The column's width in widths of the letter x. Longer lines are hard to read.
constexpr double kColumnLetters = 104.0;

} // namespace

/// The text, in one column in the middle of the window.
class ReadingWindow::Page : public QTextBrowser {
public:
    explicit Page(ReadingWindow &window) : m_window(window) {}

    void fitColumn()
    {
        const int column =
            static_cast<int>(kColumnLetters * QFontMetricsF(document()->defaultFont()).horizontalAdvance(u'x'));
        const int margin = std::max(14, (width() - verticalScrollBar()->sizeHint().width() - column) / 2);
        setViewportMargins(margin, 0, margin, 0);
        m_window.columnChanged();
    }

protected:
    void resizeEvent(QResizeEvent *event) override
    {
        fitColumn(); // first, because the text is laid out in the remaining width
        QTextBrowser::resizeEvent(event);
    }

    /// Zooms through the window, because QTextBrowser's own zoom has no limits.
    void wheelEvent(QWheelEvent *event) override
    {
        if (event->modifiers() & Qt::ControlModifier) {
            const int notches = event->angleDelta().y();
            if (notches > 0)
                m_window.zoomIn();
            else if (notches < 0)
                m_window.zoomOut();
            event->accept();
            return;
        }
        QTextBrowser::wheelEvent(event);
    }

    /// Shows a figure's alternative text as its tooltip.
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
    ReadingWindow &m_window;
};

ReadingWindow::ReadingWindow(const QString &title, const QFont &font, QWidget *parent)
    : QDialog(parent), m_usualPoints(font.pointSizeF()), m_column(new Page(*this)), m_page(m_column),
      m_find(new FindBar(*m_page)), m_bar(new QToolBar), m_body(new QSplitter)
{
    setWindowTitle(title);
    setWindowFlag(Qt::WindowMaximizeButtonHint);
    constexpr int kDigits = 128, kLines = 44;
    resize(QSize(kDigits * fontMetrics().horizontalAdvance(u'0'), kLines * fontMetrics().lineSpacing())
               .boundedTo(screen()->availableSize() * 9 / 10));

    m_page->setFrameShape(QFrame::NoFrame);
    m_page->setAutoFillBackground(true);
    m_page->setAccessibleName(title);
    m_page->document()->setDefaultFont(font);
    m_page->document()->setDocumentMargin(18.0);
    m_bar->setToolButtonStyle(Qt::ToolButtonTextOnly);
    m_bar->setAccessibleName(tr("Page"));
    m_body->setChildrenCollapsible(false);
    m_body->addWidget(m_page);

    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_bar);
    layout->addWidget(m_body, 1);
    layout->addWidget(m_find); // below the page: the text does not move when the bar opens
    m_page->setFocus();
}

QAction *ReadingWindow::addTool(const QString &text, const QString &tip, const QList<QKeySequence> &keys,
                                std::function<void()> slot)
{
    QAction *action = m_bar->addAction(text);
    action->setShortcuts(keys);
    action->setToolTip(tr("%1 (%2)").arg(tip, keys.first().toString(QKeySequence::NativeText)));
    connect(action, &QAction::triggered, this, std::move(slot));
    return action;
}

void ReadingWindow::addReadingTools()
{
    m_bar->addSeparator();
    addTool(tr("A−"), tr("Smaller text"), {QKeySequence::ZoomOut}, [this] { zoomOut(); });
    m_usualSize = addTool({}, tr("Text in its usual size"), {Qt::CTRL | Qt::Key_0}, [this] { setZoomPercent(100); });
    QList<QKeySequence> larger = QKeySequence::keyBindings(QKeySequence::ZoomIn);
    larger << QKeySequence(Qt::CTRL | Qt::Key_Equal);
    addTool(tr("A+"), tr("Larger text"), larger, [this] { zoomIn(); });
    setZoomPercent(100);
    m_bar->addSeparator();
    addTool(tr("Find"), tr("Find words in the page"), {QKeySequence::Find}, [this] { m_find->openField(); });
    addKeys(QKeySequence::FindNext, Qt::Key_F3, [this] { m_find->findNext(); });
    addKeys(QKeySequence::FindPrevious, Qt::SHIFT | Qt::Key_F3, [this] { m_find->findPrevious(); });
    // A read-only page without a caret doesn't handle these keys.
    QScrollBar *scroll = m_page->verticalScrollBar();
    addKeys(QKeySequence::MoveToStartOfDocument, Qt::CTRL | Qt::Key_Home, [scroll] { scroll->setValue(0); });
    addKeys(QKeySequence::MoveToEndOfDocument, Qt::CTRL | Qt::Key_End,
            [scroll] { scroll->setValue(scroll->maximum()); });
}

void ReadingWindow::addKeys(QKeySequence::StandardKey standard, const QKeySequence &everywhere,
                            std::function<void()> slot)
{
    auto *action = new QAction(this);
    QList<QKeySequence> keys = QKeySequence::keyBindings(standard);
    if (!keys.contains(everywhere))
        keys << everywhere;
    action->setShortcuts(keys);
    connect(action, &QAction::triggered, this, std::move(slot));
    addAction(action);
}

void ReadingWindow::addSide(QWidget *side)
{
    m_body->insertWidget(0, side);
    m_body->setStretchFactor(0, 0);
    m_body->setStretchFactor(1, 1);
}

void ReadingWindow::showText()
{
    // The page is white like paper; in dark colours it follows the application's palette.
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
    setText({colors.color(QPalette::Text), isDark ? link : QColor(0x1f, 0x3a, 0x5f), link,
             isDark ? QColor(0xa0, 0xa4, 0xaa) : QColor(0x66, 0x66, 0x66)});
    m_page->verticalScrollBar()->setValue(place);
    m_find->searchAgain();
}

void ReadingWindow::keyPressEvent(QKeyEvent *event)
{
    if (event->key() == Qt::Key_Escape && m_find->isVisible())
        m_find->closeField();
    else
        QDialog::keyPressEvent(event);
}

void ReadingWindow::changeEvent(QEvent *event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showText();
}

int ReadingWindow::zoomPercent() const
{
    return static_cast<int>(std::lround(100.0 * m_page->document()->defaultFont().pointSizeF() / m_usualPoints));
}

void ReadingWindow::setZoomPercent(int percent)
{
    percent = std::clamp(percent, kLeastPercent, kMostPercent);
    QFont font = m_page->document()->defaultFont();
    font.setPointSizeF(m_usualPoints * percent / 100.0);
    m_page->document()->setDefaultFont(font);
    m_column->fitColumn();
    m_usualSize->setText(tr("%1 %").arg(percent));
}

void ReadingWindow::zoomIn()
{
    setZoomPercent(zoomPercent() + kStepPercent);
}

void ReadingWindow::zoomOut()
{
    setZoomPercent(zoomPercent() - kStepPercent);
}

} // namespace unprojector::gui
