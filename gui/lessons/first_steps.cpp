#include "gui/lessons/first_steps.h"

#include "gui/widgets/icons.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

namespace unprojector::gui {

FirstSteps::FirstSteps(const QString &lesson, QWidget *parent) : QFrame(parent)
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setAccessibleName(tr("First steps"));
    auto *text =
        new QLabel(tr("<p><b>Three things to try</b></p>"
                      "<p><b>Click</b> a point of the model: its world coordinate stands beside, computed twice.</p>"
                      "<p><b>Drag</b>: the view turns about the point under the pointer. The wheel zooms.</p>"
                      "<p><b>Take a lesson</b> of five minutes: <a href='lesson'>%1</a>, "
                      "more in File &gt; Lessons.</p>")
                       .arg(lesson.toHtmlEscaped()));
    text->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    text->setWordWrap(true);
    constexpr int kDigits = 40;
    text->setFixedWidth(kDigits * fontMetrics().horizontalAdvance(u'0'));
    auto *close = new QToolButton;
    close->setIcon(drawnIcon(Drawing::Close));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close; Help > First Steps brings it back"));
    close->setAccessibleName(tr("Close"));
    auto *layout = new QHBoxLayout(this);
    layout->addWidget(text);
    layout->addWidget(close, 0, Qt::AlignTop);
    connect(text, &QLabel::linkActivated, this, &FirstSteps::lessonRequested);
    connect(close, &QToolButton::clicked, this, &FirstSteps::closeRequested);
}

} // namespace unprojector::gui
