#include "gui/outside/observer_panel.h"

#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/outside/observer_view.h"
#include "gui/text/help_anchors.h"
#include "gui/text/number_text.h"
#include "gui/view/painters/observer_shapes.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/icons.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QSlider>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariantAnimation>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace unproject;

namespace {

constexpr int kSteps = 1000;

/// A small square in the colour of an object in the view.
class Swatch : public QWidget {
public:
    explicit Swatch(const glm::vec4 &color) : m_color(QColor::fromRgbF(color.r, color.g, color.b))
    {
        const int side = fontMetrics().ascent();
        setFixedSize(side, side);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        QColor fill = m_color;
        fill.setAlphaF(0.35);
        painter.setPen(QPen(m_color, 2.0));
        painter.setBrush(fill);
        painter.drawRect(QRectF(rect()).adjusted(1.0, 1.0, -1.0, -1.0));
    }

private:
    QColor m_color;
};

void setTextWidth(QPushButton &button, int least)
{
    constexpr int kPadding = 18;
    button.setFixedWidth(
        std::max(least, button.fontMetrics().size(Qt::TextShowMnemonic, button.text()).width() + kPadding));
}

QLabel *endLabel(const QString &text, const QString &toolTip)
{
    auto *label = new QLabel(text);
    label->setToolTip(toolTip);
    return label;
}

} // namespace

ObserverPanel::ObserverPanel(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_view(new ObserverView(document))
{
    m_slider = new QSlider(Qt::Horizontal);
    m_slider->setRange(0, kSteps);
    m_slider->setSingleStep(kSteps / 100);
    m_slider->setPageStep(kSteps / 10);
    constexpr int kLeastHeights = 3; // a corner leaves room to drag its handle
    m_slider->setMinimumWidth(kLeastHeights * m_slider->sizeHint().height());
    m_slider->setAccessibleName(tr("From eye space to the canonical view volume"));
    m_slider->setToolTip(tr("Morph the view from eye space (left, 0 %) into the canonical view volume (right, 100 "
                            "%).\nThe view volume becomes the cube [−1, 1]³ of NDC; straight lines stay straight.\nThe "
                            "cube's z axis points away from the eye, because NDC is left-handed."));
    m_percent = new QLabel;
    m_percent->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_percent->setMinimumWidth(m_percent->fontMetrics().horizontalAdvance(tr("%1 %").arg(100)));
    m_percent->setAccessibleName(tr("Progress of the morph to the canonical view volume"));

    m_animate = new QPushButton;
    m_animate->setToolTip(tr("Play the morph to the other end"));
    m_animation = new QVariantAnimation(this);
    m_animation->setEasingCurve(QEasingCurve::InOutSine);
    auto *fit = new QPushButton(tr("F&it"));
    fit->setToolTip(tr("Show the eye and the view volume fully (F in the view)"));
    // Narrower than in the style, so that the slider has room in a narrow dock; as wide as their
    // longest text.
    showAnimating(true);
    setTextWidth(*m_animate, 0);
    showAnimating(false);
    setTextWidth(*m_animate, m_animate->width());
    setTextWidth(*fit, 0);

    auto *ends = new QHBoxLayout;
    ends->addWidget(endLabel(tr("Eye space"), tr("Before the projection: lengths and angles are true")));
    ends->addStretch();
    ends->addWidget(
        endLabel(tr("Canonical view volume"), tr("After the projection: NDC, each coordinate from −1 to 1")));
    m_help = new HelpLink({}); // the row of tools is the widest, even in a corner
    ends->addWidget(m_help);
    auto *tools = new QHBoxLayout;
    tools->setSpacing(6);
    tools->addWidget(m_slider, 1);
    tools->addWidget(m_percent);
    tools->addWidget(m_animate);
    tools->addWidget(fit);
    m_toDock = new QToolButton;
    m_toDock->setIcon(drawnIcon(Drawing::ToDock));
    m_toDock->setAutoRaise(true);
    m_close = new QToolButton;
    m_close->setIcon(drawnIcon(Drawing::Close));
    m_close->setAutoRaise(true);
    m_close->setAccessibleName(tr("Close"));
    m_close->setToolTip(tr("Close the view from outside (0)"));
    tools->addWidget(m_toDock);
    tools->addWidget(m_close);

    m_legend = new QWidget;
    auto *legend = new QGridLayout(m_legend);
    legend->setContentsMargins(0, 2, 0, 0);
    legend->setHorizontalSpacing(6);
    legend->setVerticalSpacing(1);
    legend->setColumnStretch(1, 1);
    const auto addEntry = [legend](const glm::vec4 &color, const QString &text, const QString &toolTip) {
        const int row = legend->rowCount();
        auto *name = new QLabel(text);
        auto *value = new QLabel;
        value->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
        value->setAccessibleName(text);
        name->setToolTip(toolTip);
        value->setToolTip(toolTip);
        legend->addWidget(new Swatch(color), row, 0);
        legend->addWidget(name, row, 1);
        legend->addWidget(value, row, 2, Qt::AlignRight);
        return value;
    };
    const QString dragHint =
        tr("Distance of the plane from the eye in world units. Drag one of its edges in the view to change it.");
    m_nearDistance = addEntry(observer_color::kNearPlane, tr("Near: projection window"), dragHint);
    m_farDistance = addEntry(observer_color::kFarPlane, tr("Far"), dragHint);
    m_ray = addEntry(observer_color::kRay, tr("Ray of the clicked pixel"),
                     tr("From the eye (orthographic: from the near plane) through the clicked pixel to the far plane, "
                        "and whether it hits a surface"));

    auto *bar = new QVBoxLayout;
    bar->setContentsMargins(8, 4, 8, 6);
    bar->setSpacing(2);
    bar->addLayout(ends);
    bar->addLayout(tools);
    bar->addWidget(m_legend);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_view, 1);
    layout->addLayout(bar);

    connect(m_slider, &QSlider::valueChanged, this,
            [this](int value) { m_view->setMorph(static_cast<double>(value) / kSteps); });
    connect(m_slider, &QSlider::sliderPressed, m_animation, &QVariantAnimation::stop);
    connect(m_view, &ObserverView::morphChanged, this, &ObserverPanel::showMorph);
    connect(m_animate, &QPushButton::clicked, this, &ObserverPanel::animate);
    connect(m_animation, &QVariantAnimation::valueChanged, this,
            [this](const QVariant &value) { m_view->setMorph(value.toDouble()); });
    connect(m_animation, &QVariantAnimation::stateChanged, this,
            [this](QAbstractAnimation::State state) { showAnimating(state == QAbstractAnimation::Running); });
    connect(fit, &QPushButton::clicked, m_view, &ObserverView::fit);
    connect(m_toDock, &QToolButton::clicked, this, [this] { emit dockRequested(m_close->isVisible()); });
    connect(m_close, &QToolButton::clicked, this, &ObserverPanel::closeRequested);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & (Change::Setup | Change::Pick))
            showDistances();
    });
    m_outOfSight = new QPushButton(tr("× out of sight: show it"));
    m_outOfSight->setToolTip(tr("Your program's point is outside this view. Move back until it is visible"));
    m_outOfSight->hide();
    auto *overView = new QVBoxLayout(m_view);
    overView->setSizeConstraint(QLayout::SetNoConstraint);
    overView->addWidget(m_outOfSight, 0, Qt::AlignTop | Qt::AlignLeft);
    connect(m_outOfSight, &QPushButton::clicked, m_view, &ObserverView::fit);
    connect(
        m_view, &ObserverView::wrongPointsSeen, m_outOfSight,
        [this](bool areSeen) { m_outOfSight->setVisible(!areSeen); }, Qt::QueuedConnection);
    setIsInset(false);
    showMorph(0.0);
    showDistances();
}

void ObserverPanel::setIsInset(bool isInset)
{
    m_legend->setVisible(!isInset);
    m_close->setVisible(isInset); // a dock has its own button
    const QString where = isInset ? tr("Move into its own panel") : tr("Move back into the corner of the view");
    m_toDock->setAccessibleName(where);
    m_toDock->setToolTip(where);
}

void ObserverPanel::showMorph(double t)
{
    m_percent->setText(tr("%1 %").arg(std::lround(t * 100.0)));
    // The slider displays the parameter; it must not round it.
    const QSignalBlocker blocker(m_slider);
    m_slider->setValue(static_cast<int>(std::lround(t * kSteps)));
}

void ObserverPanel::showDistances()
{
    const Projection &projection = m_document.setup().projection();
    m_help->setAnchor(helpAnchorOfSteps(kindOf(projection)));
    const ProjectionWindow w = projectionWindow(projection);
    constexpr int kDigits = 5;
    m_nearDistance->setText(writtenText(w.nearDistance, kDigits));
    m_farDistance->setText(writtenText(w.farDistance, kDigits));
    const std::optional<Pick> &pick = m_document.picks().pick();
    m_ray->setText(!pick ? tr("none") : pick->hit() ? tr("hit") : tr("no hit"));
}

void ObserverPanel::animate()
{
    if (m_animation->state() == QAbstractAnimation::Running) {
        m_animation->stop();
        return;
    }
    const double from = m_view->morph(), to = from < 0.5 ? 1.0 : 0.0;
    constexpr int kWholeWayMilliseconds = 3000;
    m_animation->setStartValue(from);
    m_animation->setEndValue(to);
    m_animation->setDuration(static_cast<int>(kWholeWayMilliseconds * std::abs(to - from)));
    m_animation->start();
}

void ObserverPanel::showAnimating(bool isAnimating)
{
    m_animate->setText(isAnimating ? tr("Sto&p") : tr("&Play"));
}

void ObserverPanel::hideEvent(QHideEvent *event)
{
    m_animation->stop();
    QWidget::hideEvent(event);
}

} // namespace unprojector::gui
