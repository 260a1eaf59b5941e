#include "gui/pipeline/depth_precision_panel.h"

#include "gui/document/camera_looks.h"
#include "gui/document/picks.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/depth_precision_plot.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/steady_label.h"

#include <QBoxLayout>
#include <QResizeEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace unprojector::gui {
using namespace geometry;
using namespace scene;
using namespace unproject;

namespace {

constexpr int kMargin = 8;
/// A smaller improvement is not worth mentioning.
constexpr double kWorthwhile = 1.5;

QString formatName(const DepthFormat &format)
{
    return format.isFloat ? DepthPrecisionPanel::tr("32-bit floats")
                          : DepthPrecisionPanel::tr("%1 bits").arg(format.bits);
}

/// An error in the scene's units.
QString errorText(double error)
{
    return significantText(error, 2).replace(u'-', u'−');
}

/// Two digits, written out: "31", "8200".
QString timesText(double times)
{
    const double unit = std::pow(10.0, std::floor(std::log10(times)) - 1.0);
    return writtenText(std::round(times / unit) * unit, 2);
}

/// The words before any click.
QString assumedText()
{
    return DepthPrecisionPanel::tr("24 bits are assumed until the first click reads the depth buffer.");
}

/// The point that words and mark refer to.
struct Place {
    double distance;
    bool isPoint; ///< the clicked one; else the middle of the view
};

Place placeOf(const SceneDocument &document, const DepthScale &scale)
{
    if (document.picks().pick() && document.picks().pick()->hit()) {
        if (const std::optional<WorldPoint> point = document.picks().pickedPoint()) {
            const double distance = -eyeFromWorld(eyeFrame(document.setup().camera()).value(), *point).z;
            if (distance >= scale.nearDistance && distance <= scale.farDistance)
                return {distance, true};
        }
    }
    return {std::clamp(centerDistance(document.scene().camera), scale.nearDistance, scale.farDistance), false};
}

} // namespace

DepthPrecisionPanel::DepthPrecisionPanel(const SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_plot(new DepthPrecisionPlot), m_words(new SteadyLabel),
      m_help(new HelpLink(QStringLiteral("certainty")))
{
    m_layout = new QBoxLayout(QBoxLayout::TopToBottom, this);
    m_layout->setContentsMargins(kMargin, kMargin, kMargin, kMargin);
    m_layout->setSpacing(kMargin);
    // The panel sets its own least size: the present contents must not prevent a narrower one.
    m_layout->setSizeConstraint(QLayout::SetNoConstraint);
    m_layout->addWidget(m_plot, 3);
    auto *words = new QHBoxLayout;
    words->setSpacing(kMargin / 2);
    words->addWidget(m_words, 1, Qt::AlignTop);
    words->addWidget(m_help, 0, Qt::AlignTop);
    m_layout->addLayout(words, 2);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (isVisible()
            && changes
                   & (Changes(Change::Objects) | Change::Placement | Change::Visibility | Change::Setup | Change::Pick))
            refresh();
    });
    refresh();
}

QSize DepthPrecisionPanel::minimumSizeHint() const
{
    return {m_plot->minimumSizeHint().width() + 2 * kMargin, m_layout->minimumSize().height()};
}

void DepthPrecisionPanel::arrange()
{
    const bool isBeside = width() - 2 * kMargin >= 2 * m_plot->minimumSizeHint().width();
    m_layout->setDirection(isBeside ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom);
    m_layout->setStretch(1, isBeside ? 2 : 0);
}

void DepthPrecisionPanel::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        arrange();
}

void DepthPrecisionPanel::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        arrange();
}

void DepthPrecisionPanel::showEvent(QShowEvent *event)
{
    refresh();
    QWidget::showEvent(event);
}

void DepthPrecisionPanel::refresh()
{
    const Setup &setup = m_document.setup();
    const DepthScale scale = depthScaleOf(setup);
    // A click reveals the format that the driver has given.
    const DepthFormat format = m_document.picks().pick() ? m_document.picks().pick()->sample.format : DepthFormat();
    const Place place = placeOf(m_document, scale);
    const double now = halfDepthStepAt(scale, format, place.distance);
    const QString drawn = m_document.picks().pick() ? tr("as drawn: %1") : tr("as drawn: %1, assumed");
    std::vector<DepthPrecisionPlot::Curve> curves{{drawn.arg(formatName(format)), scale, format}};

    QStringList said{
        (place.isPoint ? tr("At the point, %1 in front of the eye, a rounded depth is accurate to ±%2.")
                       : tr("In the middle of the view, %1 in front of the eye, a rounded depth is accurate to ±%2."))
            .arg(writtenText(place.distance, 4), errorText(now))};
    if (!scale.isPerspective) {
        said << tr(
            "With glOrtho the error is the same at every distance. Only a shorter range from near to far reduces it.");
    } else {
        std::vector<Box> boxes;
        for (const SceneObject &object : m_document.objects()) {
            if (!object.isHidden)
                boxes.push_back(boundsOf(object));
        }
        if (const std::optional<double> better = betterNear(setup, boxes); better && *better < place.distance) {
            DepthScale nearer = scale;
            nearer.nearDistance = *better;
            const double then = halfDepthStepAt(nearer, format, place.distance);
            if (now / then >= kWorthwhile) {
                const QString name = writtenText(*better, 4);
                curves.push_back({tr("with near %1").arg(name), nearer, format});
                said << tr("Near %1 instead of %2 makes this %3 times better here (±%4).")
                            .arg(name, writtenText(scale.nearDistance, 4), timesText(now / then), errorText(then));
            }
        } else if (nearestDistance(setup, boxes)) {
            said << tr("Near is about as large as the objects allow.");
        }
        DepthScale reversed = scale;
        reversed.range = {1.0, 0.0};
        const DepthFormat floats = DepthFormat::floatingPoint();
        const double then = halfDepthStepAt(reversed, floats, place.distance);
        // Reversed floats may be better at other distances than here: the curve stays.
        if (!(format == floats && scale == reversed))
            curves.push_back({tr("floats, reversed"), reversed, floats});
        if (now / then >= kWorthwhile) {
            said << tr("A float buffer with NDC depths from 0 to 1 (glClipControl) and reversed depths (1 at near) "
                       "would be %1 times better (±%2).")
                        .arg(timesText(now / then), errorText(then));
        } else if (curves.size() > 1 && curves.back().format == floats) {
            said << tr("A float buffer with reversed depths (1 at near) would change little here (±%1).")
                        .arg(errorText(then));
        }
    }
    if (!m_document.picks().pick())
        said << assumedText();
    const QString words = joinSentences(said);
    m_words->setText(words);
    m_plot->setAccessibleDescription(words);
    m_plot->show(std::move(curves), place.isPoint ? std::optional(place.distance) : std::nullopt);
}

} // namespace unprojector::gui
