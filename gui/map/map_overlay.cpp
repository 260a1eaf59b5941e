#include "gui/map/map_overlay.h"

#include "core/base/replace_file.h"
#include "gui/document/picks.h"
#include "gui/map/map_panel.h"
#include "gui/text/error_text.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"
#include "gui/view/scene_view.h"

#include <QBuffer>
#include <QFontMetrics>
#include <QLocale>
#include <QPainter>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;

namespace {

/// A view unchanged for so long is at rest.
constexpr int kRestMilliseconds = 200;

} // namespace

MapOverlay::MapOverlay(SceneDocument &document, SceneView &view)
    : m_document(document), m_view(view), m_maker(document), m_panel(new MapPanel)
{
    m_panel->hide();
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMilliseconds);
    connect(&m_rest, &QTimer::timeout, this, &MapOverlay::ask);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (m_isShown && (changes & (kVisibleChanges | Change::Preview))) {
            drop();
            m_panel->setNote(tr("The map appears when the view stops moving."));
            m_rest.start();
        }
    });
    // Only now rays are available.
    connect(&m_document.picks().rayCasters(), &RayCasters::built, this, [this] {
        if (m_isShown && !m_map && !m_maker.isMaking())
            m_rest.start();
    });
    connect(&m_maker, &MapMaker::made, this, &MapOverlay::show);
    connect(&m_maker, &MapMaker::progressed, this, [this](double share) {
        m_panel->setNote(tr("Computing the map: %1 %").arg(static_cast<int>(100.0 * share)));
    });
    connect(&m_maker, &MapMaker::failed, this, [this](const Error &error) {
        m_panel->setNote(tr("This view has no such map: %1").arg(errorText(error)));
    });
    connect(&m_maker, &MapMaker::jobFailed, this, [this](const JobFailure &failure) {
        m_panel->setNote(
            tr("There is no map: %1. Make the window smaller, or close other programs.").arg(failureText(failure)));
    });
    connect(m_panel, &MapPanel::questionChanged, this, [this] {
        drop();
        ask();
    });
    connect(m_panel, &MapPanel::colorsChanged, this, &MapOverlay::paintMap);
    connect(m_panel, &MapPanel::closeRequested, this, &MapOverlay::closeRequested);
}

MapOverlay::~MapOverlay() = default;

void MapOverlay::setShown(bool isShown)
{
    m_isShown = isShown;
    m_panel->setVisible(isShown);
    if (isShown) {
        ask();
        return;
    }
    m_rest.stop();
    m_maker.cancel();
    drop();
}

void MapOverlay::drop()
{
    m_map.reset();
    m_image = {};
    m_view.setMap({});
    m_panel->setScale(std::nullopt);
    m_panel->setExportable(false);
    tellValue();
}

void MapOverlay::ask()
{
    if (!m_isShown)
        return;
    maps::Question question = m_panel->question();
    if (question.quantity == maps::Quantity::Uncertainty)
        question.cornerShiftPixels = m_view.cornerShiftPixels();
    if (m_maker.ask(question))
        m_panel->setNote(tr("Computing the map…"));
    else if (const auto failure = m_document.picks().rayCasters().failureOf(m_document.objects()))
        m_panel->setNote(
            tr("There is no map, because the model is not prepared for rays: %1.").arg(failureText(*failure)));
    else
        m_panel->setNote(tr("The map appears when the model is prepared for rays."));
}

void MapOverlay::show(const std::shared_ptr<const MadeMap> &map)
{
    m_map = map;
    m_scale = LogScale::of(map->statistics);
    const maps::MapStatistics &s = map->statistics;
    const auto number = [](double value) { return significantText(value, 3); };
    QString note = s.count == 0 ? tr("No pixel has a value.")
                                : tr("%1 pixels: median %2, 99 % at most %3, greatest %4")
                                      .arg(QLocale().toString(static_cast<qulonglong>(s.count)), number(s.median),
                                           number(s.percentile99), number(s.greatest));
    if (s.count > 0 && !(s.greatest > 0.0) && map->question.quantity == maps::Quantity::Displacement)
        note =
            tr("%1 pixels: no difference beyond rounding.").arg(QLocale().toString(static_cast<qulonglong>(s.count)));
    if (map->question.quantity == maps::Quantity::Uncertainty)
        note += QStringLiteral("\n")
                + tr("It is the length of the ± that the Comparison panel shows for a click there. Half a step of the "
                     "depth buffer is a part of it. The ± of a landmark adds half a pixel to the side.");
    if (map->leavesPointsOut)
        note += QStringLiteral("\n") + sentence(maps::noCloudsText());
    m_panel->setNote(note);
    m_panel->setExportable(true);
    paintMap();
    tellValue();
}

void MapOverlay::paintMap()
{
    if (!m_map)
        return;
    m_panel->setScale(m_map->statistics.greatest > 0.0 ? std::optional(m_scale) : std::nullopt);
    m_image = coloredMap(m_map->map, m_scale, m_panel->colors());
    m_view.setMap(m_image);
}

void MapOverlay::setPointer(const std::optional<WidgetPoint> &position)
{
    m_pointer = position;
    tellValue();
}

void MapOverlay::tellValue()
{
    if (!m_map || !m_pointer) {
        m_panel->setValue({});
        return;
    }
    const Result<DevicePixel> pixel = devicePixelFromWidget(m_map->setup.surface, *m_pointer);
    const float number = pixel ? m_map->map.at(*pixel) : std::nanf("");
    m_panel->setValue(std::isnan(number) ? tr("no number here")
                                         : tr("here: %1").arg(significantText(static_cast<double>(number), 4)));
}

/// The coloured map with its scale and title below.
QImage MapOverlay::withScale() const
{
    const qreal ratio = m_map->setup.surface.devicePixelRatio;
    const QFont font = m_panel->font();
    const QFontMetrics metrics(font);
    const int margin = metrics.height() / 2;
    const int strip = 4 * metrics.height() + 3 * margin;
    const int width = qRound(m_image.width() / ratio), height = qRound(m_image.height() / ratio);
    QImage picture(m_image.width(), m_image.height() + qRound(strip * ratio), QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    painter.drawImage(0, 0, m_image);
    painter.scale(ratio, ratio);
    painter.setFont(font);
    painter.setPen(Qt::black);
    painter.drawText(margin, height + margin + metrics.ascent(), m_panel->title());
    if (m_map->statistics.greatest > 0.0)
        ColorScale::paint(
            painter,
            QRect(margin, height + 2 * margin + metrics.height(), width - 2 * margin, 2 * metrics.height() + margin),
            m_scale, m_panel->colors());
    return picture;
}

QString MapOverlay::exportTo(const std::filesystem::path &file) const
{
    if (!m_map)
        return tr("There is no map to export.");
    const QString suffix = pathText(file.extension()).toLower();
    QByteArray bytes;
    if (suffix == QLatin1String(".pfm")) {
        bytes = QByteArray::fromStdString(maps::pfmText(m_map->map));
    } else if (suffix == QLatin1String(".png")) {
        QBuffer buffer(&bytes);
        buffer.open(QIODevice::WriteOnly);
        withScale().save(&buffer, "PNG");
    } else {
        return tr("%1: maps are written as .png or .pfm. End the name with one of these.").arg(pathText(file));
    }
    const base::Done written =
        base::replaceFile(file, std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    return written ? QString()
                   : QStringLiteral("%1: %2").arg(pathText(file), QString::fromStdString(written.error().text));
}

} // namespace unprojector::gui
