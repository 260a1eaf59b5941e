#include "gui/click/verdict_view.h"

#include "core/unproject/agreement.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/steady_label.h"

#include <QColor>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPalette>
#include <QToolButton>
#include <QVBoxLayout>

namespace unprojector::gui {
namespace {

/// A colour that is readable on a light and on a dark window.
QColor colorOf(bool isDark, const QColor &onLight, const QColor &onDark)
{
    return isDark ? onDark : onLight;
}

} // namespace

VerdictView::VerdictView(QWidget *parent)
    : QWidget(parent), m_mark(new QLabel), m_verdict(new SteadyLabel), m_why(new QToolButton),
      m_accuracy(new SteadyLabel), m_cause(new SteadyLabel)
{
    m_verdict->setAccessibleName(tr("Do the methods agree?"));
    m_why->setText(tr("&Why?"));
    m_why->setToolTip(tr("Cause of the difference, and uncertainty of the coordinate"));
    m_why->setCheckable(true);
    m_why->setAutoRaise(true);
    m_accuracy->setAccessibleName(tr("Accuracy"));
    m_cause->setAccessibleName(tr("Cause of the difference"));

    auto *line = new QHBoxLayout;
    line->setSpacing(4);
    line->addWidget(m_mark, 0, Qt::AlignVCenter);
    line->addWidget(m_verdict, 1, Qt::AlignVCenter);
    line->addWidget(m_why, 0, Qt::AlignVCenter);
    auto *reasons = new QWidget;
    auto *reasonLines = new QVBoxLayout(reasons);
    reasonLines->setContentsMargins(0, 0, 0, 0);
    reasonLines->setSpacing(2);
    const auto add = [reasonLines](QWidget *label, const QString &anchor) {
        auto *reason = new QWidget;
        auto *row = new QHBoxLayout(reason);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(2);
        row->addWidget(label, 1, Qt::AlignTop);
        row->addWidget(new HelpLink(anchor), 0, Qt::AlignTop);
        reasonLines->addWidget(reason);
        return reason;
    };
    m_causeLine = add(m_cause, QStringLiteral("matrix"));
    add(m_accuracy, QStringLiteral("certainty"));
    reasons->hide();
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(line);
    layout->addWidget(reasons);
    connect(m_why, &QToolButton::toggled, reasons, &QWidget::setVisible);
}

void VerdictView::setPick(const unproject::Pick &pick, const QString &accuracy, const QString &name,
                          const std::vector<double> &uncertainty)
{
    const std::optional<unproject::Agreement> agreement = unproject::agreementOf(pick);
    m_sign = !agreement                                ? Sign::Beyond
             : agreement->isToTheLastPlaces()          ? Sign::Agree
             : agreement->isWithinUncertainty == false ? Sign::Beyond
                                                       : Sign::Differ;
    m_verdict->setText(QString::fromStdString(unproject::verdictText(pick)));
    m_cause->setText(QString::fromStdString(unproject::differenceCauseText(pick)));
    m_causeLine->setVisible(agreement.has_value());
    m_accuracy->setText(accuracy);
    m_accuracy->setValue({name, uncertainty});
    showSign();
}

/// Each sign has its own shape, so that colour is not the only difference.
void VerdictView::showSign()
{
    const bool isDark = palette().color(QPalette::Window).lightnessF() < 0.5;
    QPalette colors = m_mark->palette();
    QColor color;
    switch (m_sign) {
    case Sign::Agree:
        m_mark->setText(QStringLiteral("●"));
        color = colorOf(isDark, QColor(0x1a, 0x7f, 0x37), QColor(0x3f, 0xb9, 0x50));
        break;
    case Sign::Differ:
        m_mark->setText(QStringLiteral("▲"));
        color = colorOf(isDark, QColor(0x9a, 0x67, 0x00), QColor(0xd2, 0x99, 0x22));
        break;
    case Sign::Beyond:
        m_mark->setText(QStringLiteral("■"));
        color = colorOf(isDark, QColor(0xcf, 0x22, 0x2e), QColor(0xff, 0x7b, 0x72));
        break;
    }
    m_mark->setFixedWidth(m_mark->fontMetrics().height()); // the text must not move with the sign
    colors.setColor(QPalette::WindowText, color);
    m_mark->setPalette(colors);
}

QString VerdictView::text() const
{
    return m_verdict->text() + u'\n' + m_cause->text() + u'\n' + m_accuracy->text() + u'\n';
}

void VerdictView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showSign();
}

} // namespace unprojector::gui
