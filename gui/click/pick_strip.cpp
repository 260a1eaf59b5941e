#include "gui/click/pick_strip.h"

#include "gui/click/comparison_model.h"
#include "gui/text/number_text.h"
#include "gui/widgets/digits_font.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QStackedLayout>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace pipeline;
using namespace unproject;

namespace {

constexpr int kMostDigits = 5, kFewestDigits = 2;

QString bracketed(const QStringList &numbers)
{
    return QStringLiteral("(%1)").arg(numbers.join(QStringLiteral(", ")));
}

/// The point with so many significant digits of the largest coordinate, but only certain ones.
QString roundedText(const Components<3> &point, const Components<3> &uncertainty, int digits)
{
    const double unit = std::pow(10.0, -decimalsFor(point, digits));
    return pointText(point,
                     {std::max(unit, uncertainty.x), std::max(unit, uncertainty.y), std::max(unit, uncertainty.z)});
}

QString roundedText(const ClipPoint &point, double uncertainty, int digits)
{
    const int decimals =
        std::clamp(decimalsFor({point.x, point.y, std::max(std::abs(point.z), std::abs(point.w))}, digits), 0,
                   std::max(0, -certainPlace(uncertainty)));
    return bracketed({fixedText(point.x, decimals), fixedText(point.y, decimals), fixedText(point.z, decimals),
                      fixedText(point.w, decimals)});
}

QString noText()
{
    return QStringLiteral("–");
}

} // namespace

PickStrip::PickStrip(QWidget *parent)
    : QWidget(parent), m_pages(new QStackedLayout(this)), m_spaces(new QWidget),
      m_atClick(new QLabel(tr("at the\nclick:"))), m_names{tr("pixel"), tr("window"), tr("NDC"),   tr("clip"),
                                                           tr("eye"),   tr("world"),  tr("object")}
{
    auto *before =
        new QLabel(tr("Click the view: this line then shows the point in every space, from the pixel to the object."));
    before->setAlignment(Qt::AlignCenter);
    before->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_pages->addWidget(before);
    m_pages->addWidget(m_spaces);
    setAccessibleName(tr("The pick in every space"));

    struct Meaning {
        PipelineStage stage;
        QString tip;
    };
    const std::array<Meaning, SpaceCount> meanings{{
        {PipelineStage::ViewportMatrix, tr("Device pixel: column and row, counted from the upper left corner")},
        {PipelineStage::ViewportMatrix, tr("Window point: the pixel's centre, y upwards, and the depth")},
        {PipelineStage::ViewportMatrix, tr("Normalized device coordinates, each from −1 to 1 in the view volume")},
        {PipelineStage::ProjectionMatrix, tr("Clip coordinates x, y, z, w: divided by w they are NDC")},
        {PipelineStage::ProjectionMatrix, tr("Eye coordinates: seen from the camera, which looks along −z")},
        {PipelineStage::ViewMatrix, tr("World coordinates: the answer of the click")},
        {PipelineStage::ModelMatrix, tr("Object coordinates, as in the file of the clicked object")},
    }};
    auto *line = new QHBoxLayout(m_spaces);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(0);
    m_atClick->setAlignment(Qt::AlignCenter);
    m_atClick->setContentsMargins(6, 0, 6, 0);
    m_atClick->setToolTip(tr("The view has changed since: this line has the values at the click"));
    m_atClick->hide();
    line->addWidget(m_atClick);
    for (int space = 0; space < SpaceCount; ++space) {
        auto *button = new QToolButton;
        button->setAutoRaise(true);
        button->setFont(digitsFont(font()));
        button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
        button->setToolTip(meanings[space].tip + u'\n' + tr("A click shows its matrix."));
        connect(button, &QToolButton::clicked, this,
                [this, stage = meanings[space].stage] { emit stageRequested(stage); });
        if (space > 0) {
            auto *arrow = new QLabel(QStringLiteral("›"));
            arrow->setAlignment(Qt::AlignCenter);
            line->addWidget(arrow);
        }
        line->addWidget(button, 1);
        m_buttons[space] = button;
    }
    showTexts(); // the line has its height before the first pick
}

void PickStrip::setPick(const KeptPick &kept, const std::optional<WorldPoint> &point, const WorldVector &uncertainty)
{
    m_pages->setCurrentIndex(kept.pick ? 1 : 0);
    m_texts = {};
    if (!kept.pick)
        return;
    const Pick &pick = *kept.pick;
    m_texts[Pixel] = [pixel = pick.devicePixel](int) {
        return bracketed({QString::number(pixel.i), QString::number(pixel.j)});
    };
    const Result<Pipeline> matrices = pipelineOf(pick.setup, kept.placement.rounded());
    if (!matrices) {
        showTexts();
        return;
    }
    const bool isSnapped = point
                           && (!pick.point.world[Method::Formula]
                               || point->coordinates() != pick.point.world[Method::Formula]->coordinates());
    const PipelinePoints points = point ? pointsForward(*matrices, *point) : pointsBackward(*matrices, pick.window);
    const WindowPoint window = isSnapped && points.window ? *points.window : pick.window;
    m_texts[Window] = [window](int digits) {
        return bracketed({pixelText(window.x), pixelText(window.y), writtenText(window.z, digits + 1)});
    };
    if (points.ndc)
        m_texts[Ndc] = [ndc = *points.ndc](int digits) {
            return bracketed(
                {fixedText(ndc.x, digits - 1), fixedText(ndc.y, digits - 1), fixedText(ndc.z, digits - 1)});
        };
    const auto matrixOf = [&matrices](PipelineStage stage, PipelineDirection direction) {
        return glm::dmat3(matrices->matrix(stage, direction));
    };
    const Components<3> ofEye =
        isSnapped ? mapped(matrixOf(PipelineStage::ViewMatrix, PipelineDirection::Forward), uncertainty)
                  : Components<3>(pick.uncertainty.eye);
    const Components<3> ofObject =
        mapped(matrixOf(PipelineStage::ModelMatrix, PipelineDirection::Backward), uncertainty);
    const Components<3> ofClip = mapped(matrixOf(PipelineStage::ProjectionMatrix, PipelineDirection::Forward), ofEye);
    const double most = point ? std::max({ofClip.x, ofClip.y, ofClip.z, ofEye.z}) : 0.0; // w is the distance, or 1
    if (points.clip)
        m_texts[Clip] = [clip = *points.clip, most](int digits) {
            return roundedText(clip, most, std::max(digits - 1, 3));
        };
    if (point) {
        if (points.eye)
            m_texts[Eye] = [eye = *points.eye, open = ofEye](int digits) { return roundedText(eye, open, digits); };
        m_texts[World] = [world = *point, open = uncertainty](int digits) { return roundedText(world, open, digits); };
        if (points.object)
            m_texts[Object] = [object = *points.object, open = ofObject](int digits) {
                return roundedText(object, open, digits);
            };
    }
    showTexts();
}

void PickStrip::setStale(bool isStale)
{
    if (m_atClick->isHidden() != isStale)
        return;
    m_atClick->setVisible(isStale);
    showTexts();
}

void PickStrip::showTexts()
{
    // Ideographs are higher than digits: the line, and so the view, keeps its height with and without
    // the label.
    m_atClick->ensurePolished();
    setMinimumHeight(m_atClick->sizeHint().height());
    constexpr int kPadding = 10;
    const auto textOf = [this](int space, int digits) { return m_texts[space] ? m_texts[space](digits) : noText(); };
    const QFontMetrics metrics(m_buttons[Pixel]->font());
    const int arrows = (SpaceCount - 1) * metrics.horizontalAdvance(u'›')
                       + (m_atClick->isHidden() ? 0 : m_atClick->sizeHint().width());
    std::array<int, SpaceCount> widths{};
    std::array<QString, SpaceCount> shown;
    const auto sumOfWidths = [&] {
        int sum = arrows;
        for (int space = 0; space < SpaceCount; ++space) {
            widths[space] =
                std::max(metrics.horizontalAdvance(shown[space]), metrics.horizontalAdvance(m_names[space])) + kPadding;
            sum += widths[space];
        }
        return sum;
    };
    int digits = kMostDigits + 1;
    do {
        --digits;
        for (int space = 0; space < SpaceCount; ++space)
            shown[space] = textOf(space, digits);
    } while (sumOfWidths() > width() && digits > kFewestDigits);
    // A button would cut off the ends of its numbers. The world's point goes last.
    for (const Space space : {Ndc, Clip, Window, Object, Eye, World, Pixel}) {
        if (sumOfWidths() > width())
            shown[space] = QStringLiteral("…");
    }
    auto *line = static_cast<QHBoxLayout *>(m_spaces->layout());
    for (int space = 0; space < SpaceCount; ++space) {
        QToolButton &button = *m_buttons[space];
        button.setText(m_names[space] + u'\n' + shown[space]);
        button.setAccessibleName(m_names[space] + u' ' + textOf(space, digits));
        button.setEnabled(static_cast<bool>(m_texts[space]));
        line->setStretch(1 + 2 * space, widths[space]); // behind the label, an arrow between two
    }
    line->activate(); // the label may have come or gone
}

void PickStrip::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    if (m_pages->currentIndex() == 1)
        showTexts();
}

} // namespace unprojector::gui
