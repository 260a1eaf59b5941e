#include "gui/click/answer_view.h"

#include "gui/text/number_text.h"
#include "gui/widgets/contrast.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/elided_label.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// The size of its digits relative to a table's.
constexpr double kScale = 1.35;

/// x, y and z with all their digits.
QString allDigits(const Components<3> &point)
{
    return QStringLiteral("%1, %2, %3").arg(shortestText(point.x), shortestText(point.y), shortestText(point.z));
}

} // namespace

AnswerView::AnswerView(QWidget *parent)
    : QWidget(parent), m_heading(new ElidedLabel), m_point(new QLabel), m_copy(new QToolButton)
{
    QFont bold = m_heading->font();
    bold.setBold(true);
    m_heading->setFont(bold);
    m_heading->setAccessibleName(tr("Clicked object"));
    m_point->setAccessibleName(tr("World coordinate"));
    m_point->setTextFormat(Qt::RichText);
    m_point->setWordWrap(true);
    m_point->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);

    auto *menu = new QMenu(this);
    m_copy->setText(tr("&Copy"));
    m_copy->setAutoRaise(true);
    m_copy->setPopupMode(QToolButton::MenuButtonPopup);
    m_copy->setMenu(menu);
    connect(m_copy, &QToolButton::clicked, this, &AnswerView::copy);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });

    auto *line = new QHBoxLayout;
    line->addWidget(m_heading, 1);
    line->addWidget(m_copy);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addLayout(line);
    layout->addWidget(m_point);
    showPoint();
}

void AnswerView::copy()
{
    if (m_at)
        copyToClipboard(allDigits(*m_at));
    else
        emit copyAllRequested();
}

const QString &AnswerView::heading() const
{
    return m_heading->fullText();
}

void AnswerView::setAnswer(const QString &heading, const std::optional<Components<3>> &point,
                           const Components<3> &uncertainty)
{
    m_heading->setFullText(heading);
    m_at = point;
    m_uncertainty = uncertainty;
    showPoint();
}

void AnswerView::showPoint()
{
    m_plain.clear();
    m_point->setVisible(m_at.has_value());
    m_copy->setToolTip(m_at ? tr("Copy the coordinate with all digits; the arrow offers other forms")
                            : tr("Copy everything about this click"));
    if (!m_at) {
        m_point->clear();
        return;
    }
    QFont font = digitsFont(QApplication::font(this));
    font.setPointSizeF(font.pointSizeF() * kScale);
    if (m_point->font() != font)
        m_point->setFont(font);
    const QString grey =
        quietInk(palette().color(QPalette::WindowText), palette().color(QPalette::Window)).name(QColor::HexRgb);
    QStringList plain, marked, each;
    for (int axis = 0; axis < 3; ++axis) {
        const double value = (*m_at)[axis];
        const Notation notation = notationWithin(*m_at, value, m_uncertainty[axis]);
        const QString number = notation.text(value);
        const qsizetype certain = notation.certainLength(value, m_uncertainty[axis]);
        const qsizetype power = certain > 0 && number.contains(u'e') ? number.indexOf(u'e') : number.size();
        plain << number;
        marked << QStringLiteral("%1<span style='color:%2'>%3</span>%4")
                      .arg(number.left(certain), grey, number.mid(certain, power - certain), number.mid(power));
        each << QStringLiteral("%1 = %2 ± %3")
                    .arg(QStringLiteral("xyz")[axis])
                    .arg(shortestText(value), boundText(m_uncertainty[axis]));
    }
    const QString bound = boundText(std::max({m_uncertainty.x, m_uncertainty.y, m_uncertainty.z}));
    const QString format = QStringLiteral("(%1) ±%2%3");
    m_plain = format.arg(plain.join(QStringLiteral(", ")), QStringLiteral(" "), bound);
    // A line that is too long ends behind a comma, never within a number.
    const bool fits = m_point->fontMetrics().horizontalAdvance(m_plain) <= width();
    m_point->setText(format.arg(marked.join(fits ? QStringLiteral(", ") : QStringLiteral(",<br>&nbsp;")),
                                QString(QChar::Nbsp), bound));
    m_point->setToolTip(
        each.join(u'\n') + u'\n'
        + tr("World units. The ± beside the point is the largest of the three; Why? has the ± along the "
             "view.\nGrey digits are smaller than the uncertainty."));
    m_point->setAccessibleDescription(m_plain);
}

void AnswerView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showPoint();
}

void AnswerView::fillMenu(QMenu &menu)
{
    menu.clear();
    if (m_at) {
        const QString certain = pointText(*m_at, m_uncertainty).mid(1).chopped(1);
        menu.addAction(tr("Copy to the last certain digit"), this, [certain] { copyToClipboard(certain); })
            ->setToolTip(certain);
        menu.addAction(tr("Copy with ±"), this, [this] { copyToClipboard(m_plain); })->setToolTip(m_plain);
        menu.addSeparator();
        addCopyActions(menu, {}, {QStringLiteral("world"), {m_at->x, m_at->y, m_at->z}});
        menu.addSeparator();
    }
    menu.addAction(tr("Copy everything about this click"), this, &AnswerView::copyAllRequested);
}

void AnswerView::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::ApplicationFontChange)
        showPoint();
}

} // namespace unprojector::gui
