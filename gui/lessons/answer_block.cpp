#include "gui/lessons/answer_block.h"

#include "core/base/expression.h"
#include "gui/lessons/answer_text.h"
#include "gui/lessons/lesson_player.h"
#include "gui/lessons/lesson_text.h"
#include "gui/text/error_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QTextDocument>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// The least width of the field.
constexpr int kLeastDigits = 8;
/// The height of the verdict.
constexpr int kLines = 2;

/// Limits a button to the width of its text: at large fonts the field beside it needs the room.
void makeNarrow(QPushButton &button)
{
    QSizePolicy policy = button.sizePolicy();
    policy.setHorizontalPolicy(QSizePolicy::Preferred);
    button.setSizePolicy(policy);
    button.setMinimumWidth(button.fontMetrics().horizontalAdvance(button.text().remove(u'&')) + 20);
}

QLabel *wrapped()
{
    auto *label = new QLabel;
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

} // namespace

AnswerBlock::AnswerBlock(LessonPlayer &player, QWidget *parent)
    : QWidget(parent), m_player(player), m_question(wrapped()), m_answer(new QLineEdit),
      m_check(new QPushButton(tr("Chec&k"))), m_reveal(new QPushButton(tr("Sho&w"))), m_verdict(wrapped())
{
    QFont bold = font();
    bold.setBold(true);
    m_question->setFont(bold);
    m_question->setTextFormat(Qt::RichText);
    m_question->setAccessibleName(tr("Question"));
    m_question->setBuddy(m_answer);
    m_answer->setAccessibleName(tr("Your answer"));
    m_answer->setMinimumWidth(kLeastDigits * fontMetrics().horizontalAdvance(u'0'));
    m_answer->setPlaceholderText(tr("Your answer"));
    m_answer->setToolTip(tr("A number or an expression such as 3/4 or 2*sqrt(2)"));
    makeNarrow(*m_check);
    makeNarrow(*m_reveal);
    m_check->setToolTip(tr("Compare your answer with the program's"));
    m_reveal->setToolTip(tr("Show the answer and its explanation"));
    connect(m_answer, &QLineEdit::returnPressed, this, &AnswerBlock::check);
    connect(m_check, &QPushButton::clicked, this, &AnswerBlock::check);
    connect(m_reveal, &QPushButton::clicked, this, &AnswerBlock::reveal);
    m_verdict->setTextFormat(Qt::PlainText); // it repeats the typed text
    m_verdict->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_verdict->setAccessibleName(tr("Verdict on your answer"));

    auto *scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFixedHeight(kLines * fontMetrics().lineSpacing() + 2);
    scroll->setWidget(m_verdict);
    scroll->viewport()->setAutoFillBackground(false);
    m_verdict->setAutoFillBackground(false);
    auto *field = new QHBoxLayout;
    field->addWidget(m_answer, 1);
    field->addWidget(m_check);
    field->addWidget(m_reveal);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_question);
    layout->addLayout(field);
    layout->addWidget(scroll);
}

void AnswerBlock::showQuestion()
{
    const bool asks = m_player.lesson() && m_player.step().question;
    setVisible(asks);
    m_answer->clear();
    m_question->setText(asks ? lessonTitle(m_player.step().question->text) : QString());
    QString note;
    if (asks && !m_player.isRevealed()) {
        const std::vector<lessons::CoveredPanel> covered = m_player.coveredPanels();
        const bool doAllOpen = std::all_of(covered.begin(), covered.end(),
                                           [this](const auto &one) { return one.until == m_player.index(); });
        if (!covered.empty() && doAllOpen) // else the covers say when each opens
            note = coverText(covered.front(), m_player.index());
    }
    say(note);
}

QString AnswerBlock::question() const
{
    QTextDocument text;
    text.setHtml(m_question->text());
    return text.toPlainText();
}

void AnswerBlock::check()
{
    const QString given = m_answer->text();
    const auto value = base::evaluate(given.toStdString());
    if (!value) {
        say(errorText(value.error(), given));
        return;
    }
    const std::optional<lessons::Asked> asked = m_player.asked();
    if (!asked)
        say({});
    else if (m_player.check(*value))
        say(tr("Right: %1.").arg(answerText(*asked)));
    else
        say(wrongAnswerText(*asked, *value));
}

void AnswerBlock::reveal()
{
    m_player.reveal();
    const std::optional<lessons::Asked> asked = m_player.asked();
    say(asked ? tr("It is %1.").arg(answerText(*asked)) : QString());
}

void AnswerBlock::say(const QString &verdict)
{
    m_verdict->setText(verdict);
}

} // namespace unprojector::gui
