#include "gui/map/map_panel.h"

#include "gui/text/map_text.h"
#include "gui/text/number_text.h"
#include "gui/widgets/help_link.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {
namespace {

/// The two methods differ by rounding only, which says little of a picture.
constexpr maps::Quantity kFirstShown = maps::Quantity::Uncertainty;

QString helpOf(maps::Quantity quantity)
{
    switch (quantity) {
    case maps::Quantity::FormulaMatrix:
    case maps::Quantity::MatrixRay: return QStringLiteral("matrix");
    case maps::Quantity::FormulaRay: return QStringLiteral("closed");
    case maps::Quantity::Uncertainty: return QStringLiteral("certainty");
    case maps::Quantity::Displacement: return QStringLiteral("half-pixel");
    }
    Q_UNREACHABLE();
}

} // namespace

ColorScale::ColorScale(QWidget *parent) : QWidget(parent)
{
    setAccessibleName(tr("Scale of the map"));
    setToolTip(
        tr("Logarithmic, from the first percentile to the maximum. Smaller values, also 0, have the darkest colour"));
}

void ColorScale::setScale(const std::optional<LogScale> &scale, ColorMap colors)
{
    m_scale = scale;
    m_colors = colors;
    if (m_scale)
        setAccessibleDescription(
            tr("from %1 to %2").arg(significantText(m_scale->low, 3), significantText(m_scale->high, 3)));
    update();
}

QSize ColorScale::sizeHint() const
{
    return {26 * fontMetrics().horizontalAdvance(u'0'), 2 * fontMetrics().height() + 8};
}

void ColorScale::paint(QPainter &painter, const QRect &area, const LogScale &scale, ColorMap colors)
{
    const QFontMetrics metrics = painter.fontMetrics();
    const QRect bar(area.left(), area.top(), area.width(), area.height() - metrics.height() - 5);
    for (int x = 0; x < bar.width(); ++x)
        painter.fillRect(QRect(bar.left() + x, bar.top(), 1, bar.height()),
                         colorAt(colors, static_cast<double>(x) / std::max(1, bar.width() - 1)));
    int free = area.left() - 1; // right of the last written number
    for (const double tick : scale.ticks()) {
        const int x = bar.left() + static_cast<int>(scale.share(tick) * (bar.width() - 1));
        painter.drawLine(x, bar.bottom(), x, bar.bottom() + 4);
        const QString text = significantText(tick, 2);
        const int width = metrics.horizontalAdvance(text);
        const int left = std::clamp(x - width / 2, area.left(), std::max(area.left(), area.right() - width));
        if (left <= free)
            continue;
        painter.drawText(left, area.bottom() - metrics.descent(), text);
        free = left + width + metrics.horizontalAdvance(u' ');
    }
}

void ColorScale::paintEvent(QPaintEvent *)
{
    if (!m_scale)
        return;
    QPainter painter(this);
    painter.setPen(palette().color(QPalette::WindowText));
    paint(painter, rect(), *m_scale, m_colors);
}

MapPanel::MapPanel(QWidget *parent)
    : QFrame(parent), m_quantity(new QComboBox), m_convention(new QComboBox), m_unit(new QComboBox),
      m_colors(new QComboBox), m_scale(new ColorScale), m_value(new QLabel), m_note(new QLabel),
      m_export(new QPushButton(tr("E&xport…"))), m_help(new HelpLink(helpOf(kFirstShown)))
{
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    for (const maps::Quantity quantity : maps::kQuantities) {
        m_quantity->addItem(quantityName(quantity));
        m_quantity->setItemData(m_quantity->count() - 1, quantityText(quantity), Qt::ToolTipRole);
        if (quantity == kFirstShown)
            m_quantity->setCurrentIndex(m_quantity->count() - 1);
    }
    m_quantity->setAccessibleName(tr("Quantity that the map shows"));
    m_quantity->setToolTip(tr("Quantity that the map shows"));
    for (const maps::NamedConvention &convention : maps::namedConventions()) {
        m_convention->addItem(conventionName(convention));
        if (const auto *program = std::get_if<unproject::OtherProgram>(&convention.other))
            m_convention->setItemData(m_convention->count() - 1, programReason(*program), Qt::ToolTipRole);
    }
    m_convention->setAccessibleName(tr("Program or mistake of the displacement"));
    m_convention->setToolTip(tr("Program that answers, or mistake that is made"));
    m_convention->hide();
    for (const maps::Unit unit : {maps::Unit::World, maps::Unit::Ulps})
        m_unit->addItem(unitName(unit));
    m_unit->setAccessibleName(tr("Unit"));
    m_unit->setToolTip(tr("World units, or units in the last place of the point's largest coordinate"));
    m_colors->addItems({QStringLiteral("viridis"), QStringLiteral("cividis")});
    m_colors->setAccessibleName(tr("Colours"));
    m_colors->setToolTip(tr("Colours from dark to light, also for colour-blind users"));
    for (QComboBox *box : {m_quantity, m_convention, m_unit, m_colors}) {
        box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box->setMinimumContentsLength(6);
    }
    m_value->setAccessibleName(tr("The map's number under the pointer"));
    m_note->setWordWrap(true);
    m_note->setAccessibleName(tr("The map's numbers"));
    m_export->setToolTip(tr("Write the map as an image with its scale (PNG), or as numbers (PFM)"));
    m_export->setEnabled(false);
    auto *close = new QToolButton;
    close->setText(QStringLiteral("×"));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close the map"));
    close->setAccessibleName(close->toolTip());

    auto *head = new QHBoxLayout;
    head->addWidget(m_quantity, 1);
    head->addWidget(m_help);
    head->addWidget(close);
    auto *ways = new QHBoxLayout;
    ways->addWidget(m_unit, 1);
    ways->addWidget(m_colors, 1);
    auto *foot = new QHBoxLayout;
    foot->addWidget(m_value, 1);
    foot->addWidget(m_export);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    layout->addLayout(head);
    layout->addWidget(m_convention);
    layout->addLayout(ways);
    layout->addWidget(m_scale);
    layout->addLayout(foot);
    layout->addWidget(m_note);

    const auto ask = [this] {
        m_convention->setVisible(question().quantity == maps::Quantity::Displacement);
        m_help->setAnchor(helpOf(question().quantity));
        emit questionChanged();
    };
    for (QComboBox *box : {m_quantity, m_convention, m_unit})
        connect(box, &QComboBox::currentIndexChanged, this, ask);
    connect(m_colors, &QComboBox::currentIndexChanged, this, [this] {
        m_scale->setScale(m_shown, colors());
        emit colorsChanged();
    });
    connect(m_export, &QPushButton::clicked, this, &MapPanel::exportRequested);
    connect(close, &QToolButton::clicked, this, &MapPanel::closeRequested);
}

maps::Question MapPanel::question() const
{
    const auto place = [](const QComboBox *box) { return static_cast<std::size_t>(std::max(0, box->currentIndex())); };
    return {maps::kQuantities[place(m_quantity)], m_unit->currentIndex() == 1 ? maps::Unit::Ulps : maps::Unit::World,
            maps::namedConventions()[place(m_convention)].other};
}

ColorMap MapPanel::colors() const
{
    return m_colors->currentIndex() == 1 ? ColorMap::Cividis : ColorMap::Viridis;
}

QString MapPanel::title() const
{
    const QString what =
        m_convention->isHidden() ? m_quantity->currentText() : tr("Displacement: %1").arg(m_convention->currentText());
    return tr("%1, %2").arg(what, m_unit->currentText());
}

void MapPanel::setScale(const std::optional<LogScale> &scale)
{
    m_shown = scale;
    m_scale->setScale(scale, colors());
}

void MapPanel::setNote(const QString &text)
{
    m_note->setText(text);
}

void MapPanel::setValue(const QString &text)
{
    m_value->setText(text);
}

void MapPanel::setExportable(bool isExportable)
{
    m_export->setEnabled(isExportable);
}

} // namespace unprojector::gui
