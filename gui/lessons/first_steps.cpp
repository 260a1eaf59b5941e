#include "gui/lessons/first_steps.h"

#include "gui/widgets/icons.h"

#include <QGridLayout>
#include <QLabel>
#include <QToolButton>

#include <algorithm>

namespace unprojector::gui {

FirstSteps::FirstSteps(const QString &lesson, QWidget *parent) : QFrame(parent)
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAccessibleName(tr("First steps"));
    const std::array<QString, StepCount> texts{
        tr("<b>Click</b> a point of the model. Its world coordinate appears on the right, computed in two ways."),
        tr("<b>Drag</b> the view: it turns about the point under the pointer. The wheel zooms."),
        tr("<b>Take a lesson</b> of five minutes: <a href='lesson'>%1</a>.").arg(lesson.toHtmlEscaped()),
    };
    auto *heading = new QLabel(QStringLiteral("<b>%1</b>").arg(tr("Three things to try")));
    auto *close = new QToolButton;
    close->setIcon(drawnIcon(Drawing::Close));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close; Help > First Steps brings it back"));
    close->setAccessibleName(tr("Close"));
    auto *layout = new QGridLayout(this);
    layout->addWidget(heading, 0, 0, 1, 2, Qt::AlignVCenter);
    layout->addWidget(close, 0, 2, Qt::AlignTop);
    layout->setColumnStretch(1, 1);
    constexpr int kDigits = 40;
    for (int step = 0; step < StepCount; ++step) {
        auto *text = new QLabel(texts[step]);
        text->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
        text->setWordWrap(true);
        const int width = kDigits * fontMetrics().horizontalAdvance(u'0');
        text->setFixedSize(width, text->heightForWidth(width));
        connect(text, &QLabel::linkActivated, this, &FirstSteps::lessonRequested);
        m_ticks[step] = new QLabel;
        m_ticks[step]->setAlignment(Qt::AlignTop | Qt::AlignHCenter);
        layout->addWidget(m_ticks[step], step + 1, 0);
        layout->addWidget(text, step + 1, 1, 1, 2);
        setDone(static_cast<Step>(step), false);
    }
    connect(close, &QToolButton::clicked, this, &FirstSteps::closeRequested);
}

void FirstSteps::setDone(Step step, bool isDone)
{
    m_isDone[step] = isDone;
    m_ticks[step]->setText(isDone ? QStringLiteral("☑") : QStringLiteral("☐"));
    m_ticks[step]->setAccessibleName(isDone ? tr("Done") : tr("To do"));
}

bool FirstSteps::isAllDone() const
{
    return std::all_of(m_isDone.begin(), m_isDone.end(), [](bool isDone) { return isDone; });
}

} // namespace unprojector::gui
