#include "gui/lessons/lesson_panel.h"

#include "core/text/expression.h"
#include "gui/document/scene_document.h"
#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QSignalBlocker>
#include <QTextBrowser>
#include <QToolButton>
#include <QUrl>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

constexpr int kWidth = 340;
constexpr int kMostHeight = 620;
/// Of what was typed, when it is said again.
constexpr int kDigits = 6;
/// Of the field for it.
constexpr int kLeastDigits = 8;

QLabel *wrapped()
{
    auto *label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QString withMinus(QString number)
{
    return number.replace(u'-', u'−');
}

/// An answer to as many decimals as count in it.
QString answerText(double answer, double tolerance)
{
    const int decimals = tolerance > 0.0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(tolerance))), 0, 12) : 12;
    const double scale = std::pow(10.0, decimals);
    return withMinus(writtenText(std::round(answer * scale) / scale, 15));
}

/// What it says, and little else: at large fonts the field beside it needs the room.
void makeNarrow(QPushButton &button)
{
    QSizePolicy policy = button.sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Preferred);
    button.setSizePolicy(policy);
    button.setMinimumWidth(button.fontMetrics().horizontalAdvance(button.text().remove(u'&')) + 20);
}

} // namespace

LessonPanel::LessonPanel(LessonPlayer &player, SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_player(player), m_document(document), m_title(wrapped()), m_close(new QToolButton),
      m_steps(new QComboBox), m_text(new QTextBrowser), m_hint(wrapped()), m_asking(new QWidget),
      m_answer(new QLineEdit), m_check(new QPushButton(tr("Chec&k"))), m_reveal(new QPushButton(tr("Sho&w"))),
      m_verdict(wrapped()), m_back(new QPushButton(tr("‹ Back"))), m_next(new QPushButton(tr("Next ›"))),
      m_source(wrapped())
{
    QFont bold = font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setTextFormat(Qt::PlainText);
    m_title->setAccessibleName(tr("Lesson"));

    m_close->setText(QStringLiteral("×"));
    m_close->setAutoRaise(true);
    m_close->setFocusPolicy(Qt::TabFocus);
    m_close->setToolTip(tr("Leave the lesson; the scene that was shown before it comes back"));
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
    m_text->setAccessibleName(tr("What to look at"));
    // The panel's own colour behind the text, not that of a field to type in.
    m_text->viewport()->setAutoFillBackground(false);
    connect(m_text, &QTextBrowser::anchorClicked, this, [this](const QUrl &url) { follow(url.toString()); });

    m_hint->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    m_hint->setForegroundRole(QPalette::PlaceholderText);
    connect(m_hint, &QLabel::linkActivated, this, &LessonPanel::follow);

    m_answer->setAccessibleName(tr("Your answer"));
    m_answer->setMinimumWidth(kLeastDigits * fontMetrics().horizontalAdvance(u'0'));
    makeNarrow(*m_check);
    makeNarrow(*m_reveal);
    m_answer->setPlaceholderText(tr("Your answer"));
    m_answer->setToolTip(tr("A number or an expression such as 3/4 or 2*sqrt(2)"));
    m_check->setToolTip(tr("Compare your answer with the program's"));
    m_reveal->setToolTip(tr("Show the answer, and why it is so"));
    connect(m_answer, &QLineEdit::returnPressed, this, &LessonPanel::check);
    connect(m_check, &QPushButton::clicked, this, &LessonPanel::check);
    connect(m_reveal, &QPushButton::clicked, this, &LessonPanel::reveal);
    m_verdict->setTextFormat(Qt::PlainText);                  // it repeats what was typed
    m_verdict->setMinimumHeight(fontMetrics().lineSpacing()); // the field stays where it is
    m_verdict->setAccessibleName(tr("Whether your answer is right"));

    m_back->setToolTip(tr("The step before (Alt+Page Up)"));
    connect(m_back, &QPushButton::clicked, this, [this] { m_player.previous(); });
    connect(m_next, &QPushButton::clicked, this, [this] {
        if (m_player.hasNext())
            m_player.next();
        else
            emit closeRequested();
    });

    m_source->setTextFormat(Qt::PlainText);
    m_source->setForegroundRole(QPalette::PlaceholderText);
    m_source->setAccessibleName(tr("Source of the step"));

    auto *head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_close, 0, Qt::AlignTop);
    auto *asking = new QVBoxLayout(m_asking);
    asking->setContentsMargins(0, 0, 0, 0);
    auto *field = new QHBoxLayout;
    field->addWidget(m_answer, 1);
    field->addWidget(m_check);
    field->addWidget(m_reveal);
    asking->addLayout(field);
    asking->addWidget(m_verdict);
    auto *way = new QHBoxLayout;
    way->addWidget(m_back);
    way->addStretch();
    way->addWidget(m_next);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(10, 8, 8, 8);
    layout->setSpacing(6);
    layout->addLayout(head);
    layout->addWidget(m_steps);
    layout->addWidget(m_text, 1);
    layout->addWidget(m_hint); // what comes and goes takes its room from the text: what is pressed stays where it is
    layout->addWidget(m_asking);
    layout->addWidget(m_source);
    layout->addLayout(way);

    connect(&player, &LessonPlayer::changed, this, &LessonPanel::showStep);
    connect(&document, &SceneDocument::changed, this, [this] { showHint(); });
    showStep();
}

void LessonPanel::showStep()
{
    m_answer->clear();
    m_verdict->clear();
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
        const int place = static_cast<int>(m_player.index());
        m_steps->setCurrentIndex(place);
        m_back->setEnabled(m_player.hasPrevious());
        m_next->setText(m_player.hasNext() ? tr("Next ›") : tr("Finish"));
        m_next->setToolTip(m_player.hasNext() ? tr("The next step (Alt+Page Down)")
                                              : tr("Leave the lesson; the scene that was shown before it comes back"));
        const QString source = QString::fromStdString(m_player.step().source);
        m_source->setText(source.isEmpty() ? source : tr("Source: %1").arg(source));
    }
    m_source->setVisible(lesson && !m_player.step().source.empty());
    m_asking->setVisible(lesson && m_player.step().question);
    showText();
    showHint();
    m_text->verticalScrollBar()->setValue(0);
    updateGeometry();
}

void LessonPanel::showText()
{
    if (!m_player.lesson()) {
        m_text->clear();
        return;
    }
    const lessons::Step &step = m_player.step();
    QString html = lessonHtml(step.text);
    if (step.question) {
        html += QStringLiteral("<p><b>%1</b></p>").arg(lessonTitle(step.question->text));
        if (m_player.isRevealed())
            html += lessonHtml(step.question->reveal);
        else if (!step.question->hides.empty())
            html += QStringLiteral("<p style='color: %1'>%2</p>")
                        .arg(palette().color(QPalette::Disabled, QPalette::WindowText).name(),
                             tr("Panels that show the answer are closed until then."));
    }
    m_text->setHtml(html);
}

void LessonPanel::showHint()
{
    QString hint;
    if (m_player.lesson() && !m_player.isAsTheStep())
        hint = tr("The picture is not as the step has it. <a href='restart:'>Put it back</a>");
    else if (const Surface surface = m_document.setup().surface; m_player.lesson() && !m_player.hasViewOfStep())
        hint = tr("The pixels that are spoken of are those of a view of <a href='view:%1x%2'>%1 × %2</a>. This one is "
                  "%3 × %4.")
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

void LessonPanel::check()
{
    const QString given = m_answer->text();
    const auto value = text::evaluate(given.toStdString());
    if (!value) {
        m_verdict->setText(errorText(value.error(), given));
        return;
    }
    m_verdict->clear();
    const std::optional<double> answer = m_player.answer();
    if (!answer)
        return;
    const double tolerance = m_player.step().question->tolerance;
    const auto isIt = [&](double number) { return std::abs(number - *answer) <= tolerance; };
    const QString typed = withMinus(writtenText(*value, kDigits));
    if (isIt(*value)) {
        m_verdict->setText(tr("Right: %1.").arg(answerText(*answer, tolerance)));
        showAnswer();
    } else if (isIt(-*value)) {
        m_verdict->setText(tr("%1 has the wrong sign. Try again, or have it shown.").arg(typed));
    } else {
        m_verdict->setText(tr("%1 is not it. Try again, or have it shown.").arg(typed));
    }
}

void LessonPanel::reveal()
{
    showAnswer();
    m_verdict->clear();
    if (const std::optional<double> answer = m_player.answer())
        m_verdict->setText(tr("It is %1.").arg(answerText(*answer, m_player.step().question->tolerance)));
}

void LessonPanel::showAnswer()
{
    m_player.reveal();
    showText();
    m_text->verticalScrollBar()->setValue(m_text->verticalScrollBar()->maximum());
}

void LessonPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) { // links have the colour that they were set in
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
    return m_player.lesson()
               ? m_title->text() + QStringLiteral("\n\n") + m_steps->currentText() + QStringLiteral("\n\n")
                     + m_text->toPlainText() + QStringLiteral("\n\n") + m_source->text()
               : QString();
}

QSize LessonPanel::sizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const int inner = kWidth - margins.left() - margins.right();
    QTextDocument *document = m_text->document()->clone();
    // Room for a scroll bar, even where none is needed: once there it goes only if the text fits beside it.
    document->setTextWidth(inner - m_text->verticalScrollBar()->sizeHint().width());
    const int text = static_cast<int>(document->size().height()) + 1;
    delete document;
    int height = margins.top() + margins.bottom() + text + m_title->heightForWidth(inner - 30)
                 + m_steps->sizeHint().height() + m_next->sizeHint().height() + 4 * layout()->spacing();
    for (const QWidget *part : {static_cast<QWidget *>(m_asking), static_cast<QWidget *>(m_source)}) {
        if (!part->isHidden())
            height += layout()->spacing()
                      + (part->hasHeightForWidth() ? part->heightForWidth(inner) : part->sizeHint().height());
    }
    return {kWidth, std::min(height, kMostHeight)};
}

QSize LessonPanel::minimumSizeHint() const
{
    return {220, 140};
}

} // namespace unprojector::gui
