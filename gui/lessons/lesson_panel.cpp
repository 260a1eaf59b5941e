#include "gui/lessons/lesson_panel.h"

#include "gui/document/scene_document.h"
#include "gui/lessons/answer_block.h"
#include "gui/lessons/answer_text.h"
#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr int kWidth = 340;
constexpr int kMostHeight = 620;
/// The anchor of the answer in the text.
constexpr char kAnswer[] = "answer";

QLabel *wrapped()
{
    auto *label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

LessonPanel::LessonPanel(LessonPlayer &player, SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_player(player), m_document(document), m_title(wrapped()), m_close(new QToolButton),
      m_steps(new QComboBox), m_text(new QTextBrowser), m_hint(wrapped()), m_asking(new AnswerBlock(player)),
      m_back(new QPushButton(tr("‹ Back"))), m_leave(new QPushButton(tr("Leave"))),
      m_next(new QPushButton(tr("Next ›")))
{
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setAccessibleName(tr("Lesson"));

    m_close->setText(QStringLiteral("×"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setToolTip(tr("Leave the lesson and return to the scene before it"));
    m_close->setAccessibleName(tr("Leave the lesson"));
    m_close->hide();
    connect(m_close, &QToolButton::clicked, this, &LessonPanel::closeRequested);

    m_steps->setAccessibleName(tr("Step"));
    m_steps->setToolTip(tr("The step of the lesson that is shown"));
    m_steps->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(m_steps, &QComboBox::activated, this, [this](int place) {
        if (!m_player.goTo(static_cast<std::size_t>(place)))
            m_steps->setCurrentIndex(static_cast<int>(m_player.index()));
    });

    m_text->setFrameShape(QFrame::NoFrame);
    m_text->setOpenLinks(false);
    m_text->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_text->document()->setDocumentMargin(0.0);
    m_text->setAccessibleName(tr("Explanation"));
    // The text has the panel's background, unlike an input field.
    m_text->viewport()->setAutoFillBackground(false);
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl &url) { follow(url.toString()); });

    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    connect(m_hint, &QLabel::linkActivated, this, &LessonPanel::follow);

    m_back->setToolTip(tr("The previous step (Alt+Page Up)"));
    connect(m_back, &QPushButton::clicked, this, &LessonPanel::goBack);
    m_leave->setToolTip(tr("Leave the lesson and return to the scene before it"));
    m_leave->hide();
    connect(m_leave, &QPushButton::clicked, this, &LessonPanel::finished);
    connect(m_next, &QPushButton::clicked, this, &LessonPanel::goOn);

    auto *head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_close, 0, Qt::AlignTop);
    auto *way = new QHBoxLayout;
    way->addWidget(m_back);
    way->addStretch();
    way->addWidget(m_leave);
    way->addWidget(m_next);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(head);
    layout->addWidget(m_steps);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_hint); // it takes its room from the text, so that buttons don't move
    layout->addWidget(m_asking);
    layout->addLayout(way);

    connect(&player, &LessonPlayer::changed, this, &LessonPanel::showStep);
    connect(&player, &LessonPlayer::revealed, this, [this] {
        showText();
        m_text->scrollToAnchor(QLatin1String(kAnswer));
    });
    connect(&document, &SceneDocument::changed, this, [this] { showHint(); });
    showStep();
}

void LessonPanel::showStep()
{
    m_isAtEnd = false;
    const Lesson *lesson = m_player.lesson();
    const QSignalBlocker blocker(m_steps);
    m_steps->clear();
    m_title->setText(lesson ? lessonTitle(lesson->title) : QString());
    if (lesson) {
        const int count = static_cast<int>(lesson->steps.size());
        for (int i = 0; i < count; ++i) {
            m_steps->addItem(tr("%1 of %2: %3")
                                 .arg(i + 1)
                                 .arg(count)
                                 .arg(lessonTitle(lesson->steps[static_cast<std::size_t>(i)].title)));
        }
        m_steps->setCurrentIndex(static_cast<int>(m_player.index()));
    }
    m_asking->showQuestion();
    showWayOn();
    showText();
    showHint();
    m_text->verticalScrollBar()->setValue(0);
    updateGeometry();
}

void LessonPanel::setAtEnd(bool isAtEnd)
{
    m_isAtEnd = isAtEnd;
    if (isAtEnd)
        m_asking->hide();
    else
        m_asking->showQuestion();
    showWayOn();
    showText();
    showHint();
    m_text->verticalScrollBar()->setValue(0);
}

void LessonPanel::showWayOn()
{
    if (!m_player.lesson())
        return;
    m_back->setEnabled(m_isAtEnd || m_player.hasPrevious());
    m_leave->setVisible(m_isAtEnd);
    if (!m_isAtEnd) {
        m_next->show();
        m_next->setText(m_player.hasNext() ? tr("Next ›") : tr("Finish"));
        m_next->setToolTip(m_player.hasNext() ? tr("The next step (Alt+Page Down)")
                                              : tr("Summary of the answers, and the next lesson"));
        return;
    }
    const Lesson *following = m_player.following();
    m_next->setVisible(following != nullptr);
    m_next->setText(tr("Next lesson ›"));
    m_next->setToolTip(following ? lessonTitle(following->title) : QString());
}

void LessonPanel::goOn()
{
    if (!m_isAtEnd && m_player.hasNext())
        m_player.next();
    else if (!m_isAtEnd)
        setAtEnd(true);
    else if (const Lesson *following = m_player.following())
        emit lessonRequested(std::string(following->name)); // a copy: the panel shows another lesson then
}

void LessonPanel::goBack()
{
    if (m_isAtEnd)
        setAtEnd(false);
    else
        m_player.previous();
}

void LessonPanel::showText()
{
    if (!m_player.lesson()) {
        m_text->clear();
        return;
    }
    if (m_isAtEnd) {
        m_text->setHtml(summaryHtml(m_player.tally(), m_player.following()));
        return;
    }
    const lessons::Step &step = m_player.step();
    QString html = lessonHtml(step.text);
    if (step.question && m_player.isRevealed())
        html += QStringLiteral("<a name='%1'></a>").arg(QLatin1String(kAnswer)) + lessonHtml(step.question->reveal);
    if (!step.source.empty())
        html +=
            QStringLiteral("<p>%1</p>").arg(tr("Source: %1").arg(QString::fromStdString(step.source)).toHtmlEscaped());
    m_text->setHtml(html);
}

void LessonPanel::showHint()
{
    QString hint;
    const Surface surface = m_document.setup().surface;
    if (!m_player.lesson() || m_isAtEnd)
        hint.clear(); // no step is shown
    else if (!m_player.isAsTheStep())
        hint = tr("The view differs from the step. <a href='restart:'>Restore it</a>");
    else if (!m_player.hasViewOfStep())
        hint = tr("The text uses the pixels of a view of <a href='view:%1x%2'>%1 × %2</a>. This view is %3 × %4.")
                   .arg(m_player.step().view->x)
                   .arg(m_player.step().view->y)
                   .arg(surface.widthPixels)
                   .arg(surface.heightPixels);
    m_hint->setText(hint);
    m_hint->setVisible(!hint.isEmpty());
}

void LessonPanel::follow(const QString &link)
{
    const std::optional<lessons::Link> to = lessons::parseLink(link.toStdString());
    if (!to)
        return;
    if (std::holds_alternative<lessons::RestartLink>(*to)) {
        m_player.restart();
        showHint();
    } else if (const auto *step = std::get_if<lessons::StepLink>(&*to)) {
        if (const lessons::Step *one = m_player.lesson()->step(step->id))
            m_player.goTo(static_cast<std::size_t>(one - m_player.lesson()->steps.data()));
    } else {
        emit linkFollowed(*to);
    }
}

void LessonPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) { // the text contains the colour of links
        const int place = m_text->verticalScrollBar()->value();
        showText();
        m_text->verticalScrollBar()->setValue(place);
    }
}

void LessonPanel::setClosesItself(bool does)
{
    m_close->setVisible(does);
}

QString LessonPanel::text() const
{
    if (!m_player.lesson())
        return {};
    QStringList parts{m_title->text(), m_steps->currentText(), m_text->toPlainText()};
    if (!m_asking->isHidden())
        parts << m_asking->question();
    return parts.join(QStringLiteral("\n\n"));
}

QSize LessonPanel::sizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const int inner = kWidth - margins.left() - margins.right();
    QTextDocument *document = m_text->document()->clone();
    // Reserves room for a scroll bar: once visible, it disappears only if the text fits beside it.
    document->setTextWidth(inner - m_text->verticalScrollBar()->sizeHint().width());
    const int text = static_cast<int>(document->size().height()) + 1;
    delete document;
    int height = margins.top() + margins.bottom() + text + m_title->heightForWidth(inner - 30)
                 + m_steps->sizeHint().height() + m_next->sizeHint().height() + 4 * layout()->spacing();
    if (!m_asking->isHidden())
        height += layout()->spacing() + m_asking->heightForWidth(inner);
    return {kWidth, std::min(height, kMostHeight)};
}

QSize LessonPanel::minimumSizeHint() const
{
    return {220, 140};
}

} // namespace unprojector::gui
