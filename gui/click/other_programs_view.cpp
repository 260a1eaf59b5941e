#include "gui/click/other_programs_view.h"

#include "gui/text/map_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/help_link.h"

#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>

namespace unprojector::gui {

OtherProgramsView::OtherProgramsView(QWidget *parent) : QWidget(parent), m_fold(new QToolButton), m_answers(new QLabel)
{
    m_fold->setText(tr("What other programs would give"));
    m_fold->setToolTip(tr("For the same click: how far their points are from the formula's, and why"));
    m_fold->setCheckable(true);
    m_fold->setAutoRaise(true);
    m_fold->setArrowType(Qt::RightArrow);
    m_fold->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_answers->setWordWrap(true);
    m_answers->setTextFormat(Qt::RichText);
    m_answers->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    m_answers->setAccessibleName(m_fold->text());
    m_answers->hide();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto *head = new QHBoxLayout;
    head->addWidget(m_fold);
    head->addStretch();
    head->addWidget(new HelpLink(QStringLiteral("half-pixel")));
    layout->addLayout(head);
    layout->addWidget(m_answers);
    connect(m_fold, &QToolButton::toggled, this, [this](bool isOpen) {
        m_fold->setArrowType(isOpen ? Qt::DownArrow : Qt::RightArrow);
        m_answers->setVisible(isOpen);
    });
}

void OtherProgramsView::setAnswers(const std::optional<OtherAnswers> &answers, const std::optional<WorldPoint> &formula,
                                   const WorldVector &certainty)
{
    m_plain.clear();
    if (!answers || !formula) {
        m_answers->setText(tr("A click on a surface has them, as soon as its ray is known."));
        return;
    }
    // Snapped or not: what a click takes besides is no program's answer.
    QString rows =
        QStringLiteral("<p style='margin:0 0 4px 0'>%1</p>")
            .arg(tr("Measured from the formula's point, whatever vertex, edge or place of the mesh the click takes.")
                     .toHtmlEscaped());
    for (const OtherAnswer &answer : *answers) {
        const QString name = programName(answer.program), reason = programReason(answer.program);
        const QString why = reason.toHtmlEscaped();
        QString off = tr("no answer: the depth that it reads is not known");
        m_plain += name;
        if (answer.point) {
            const double distanceToFormula = distance(*answer.point, *formula);
            off = tr("%1 off, at %2").arg(significantText(distanceToFormula, 3), pointText(*answer.point, certainty));
            for (const double number : {distanceToFormula, answer.point->x, answer.point->y, answer.point->z})
                m_plain += QLatin1Char('\t') + shortestText(number);
        }
        m_plain += QLatin1Char('\t') + reason + QLatin1Char('\n');
        rows += QStringLiteral("<p style='margin:0 0 4px 0'>%1<br>%2</p>")
                    .arg(tr("<b>%1</b>: %2", "a program: how far its point is off")
                             .arg(name.toHtmlEscaped(), off.toHtmlEscaped()),
                         why);
    }
    m_answers->setText(rows);
}

} // namespace unprojector::gui
