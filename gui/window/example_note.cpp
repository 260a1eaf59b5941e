#include "gui/window/example_note.h"

#include "gui/text/example_texts.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

constexpr int kWidth = 340;
constexpr int kMostHeight = 520;

} // namespace

ExampleNote::ExampleNote(QWidget *parent)
    : QWidget(parent), m_title(new QLabel), m_close(new QToolButton), m_text(new QTextBrowser), m_source(new QLabel)
{
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setWordWrap(true);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_title->setAccessibleName(tr("Example"));

    m_close->setText(QStringLiteral("×"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setToolTip(tr("Close the note; the example stays"));
    m_close->setAccessibleName(tr("Close the note"));
    m_close->hide();
    connect(m_close, &QToolButton::clicked, this, &ExampleNote::closeRequested);

    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    m_text->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_text->document()->setDocumentMargin(0.0);
    m_text->setAccessibleName(tr("What to look at"));
    // The note's own colour behind the text, not that of a field to type in.
    m_text->viewport()->setAutoFillBackground(false);
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl &url) {
        if (url.scheme() == QLatin1String("formulas"))
            emit formulasRequested(url.path());
        const QStringList sides = url.path().split(u'x');
        if (url.scheme() == QLatin1String("view") && sides.size() == 2)
            emit viewSizeRequested({sides[0].toInt(), sides[1].toInt()});
    });

    m_source->setWordWrap(true);
    m_source->setTextFormat(Qt::PlainText);
    m_source->setForegroundRole(QPalette::PlaceholderText);
    m_source->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_source->setAccessibleName(tr("Source of the example"));

    auto *head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_close, 0, Qt::AlignTop);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(head);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_source);
}

void ExampleNote::showExample(const std::string &id)
{
    const std::optional<ExampleText> text = exampleText(id);
    if (!text) {
        clear();
        return;
    }
    m_title->setText(text->name);
    m_text->setHtml(text->text);
    m_source->setText(tr("Source: %1").arg(text->source));
    updateGeometry();
}

void ExampleNote::clear()
{
    m_title->clear();
    m_text->clear();
    m_source->clear();
    updateGeometry();
}

bool ExampleNote::isEmpty() const
{
    return m_title->text().isEmpty();
}

void ExampleNote::setClosesItself(bool does)
{
    m_close->setVisible(does);
}

QString ExampleNote::text() const
{
    return isEmpty() ? QString()
                     : m_title->text() + QStringLiteral("\n\n") + m_text->toPlainText() + QStringLiteral("\n\n")
                           + m_source->text();
}

QSize ExampleNote::sizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const int inner = kWidth - margins.left() - margins.right();
    QTextDocument *document = m_text->document()->clone();
    // Room for a scroll bar, even where none is needed: once there it goes only if the text fits beside it.
    document->setTextWidth(inner - m_text->verticalScrollBar()->sizeHint().width());
    const int text = static_cast<int>(document->size().height()) + 1;
    delete document;
    const int height = margins.top() + margins.bottom() + 2 * layout()->spacing() + m_title->heightForWidth(inner - 30)
                       + 8 + text + m_source->heightForWidth(inner);
    return {kWidth, std::min(height, kMostHeight)};
}

QSize ExampleNote::minimumSizeHint() const
{
    return {220, 140};
}

} // namespace unprojector::gui
