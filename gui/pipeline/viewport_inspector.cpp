#include "gui/pipeline/viewport_inspector.h"

#include "core/geometry/proportions.h"
#include "gui/document/scene_document.h"
#include "gui/pipeline/corners_model.h"
#include "gui/pipeline/viewport_drawing.h"
#include "gui/text/number_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/digits_font.h"
#include "gui/widgets/help_link.h"
#include "gui/widgets/segmented_switch.h"
#include "gui/widgets/steady_label.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>

#include <algorithm>

namespace unprojector::gui {
using namespace geometry;
namespace {

constexpr int kCellPadding = 10;
constexpr int kSpacing = 16; ///< between drawing, proportions and table

/// Only window and projection are shown: a camera move costs nothing here.
bool isSameWindow(const Setup &a, const Setup &b)
{
    return a.surface == b.surface && a.viewport == b.viewport && a.depthRange == b.depthRange && a.lens == b.lens;
}

QString windowText(const Surface &surface)
{
    return ViewportInspector::tr("Window %1 × %2 device pixels, device pixel ratio %3")
        .arg(surface.widthPixels)
        .arg(surface.heightPixels)
        .arg(writtenText(surface.devicePixelRatio, 4));
}

QString viewportText(const Viewport &v)
{
    return QStringLiteral("glViewport(%1, %2, %3, %4)")
        .arg(writtenText(v.x, 6), writtenText(v.y, 6), writtenText(v.width, 6), writtenText(v.height, 6));
}

constexpr std::array kAxes{Axis::X, Axis::Y};

/// Both sides of a proportion with their numbers, one a line.
QString sidesOf(const ProportionText &text)
{
    return QStringLiteral("    ") + text.left + QStringLiteral("\n  = ") + text.right
           + (text.share.isEmpty() ? text.share : QStringLiteral(" = ") + text.share);
}

} // namespace

ViewportInspector::ViewportInspector(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_corners(new CornersModel(this)), m_drawing(new ViewportDrawing)
{
    m_page = new SegmentedSwitch(tr("Shown page"),
                                 {{tr("Proportions"), tr("The proportions (3) and (4) with their numbers")},
                                  {tr("Drawing"), tr("Window, viewport and projection window, drawn to scale")},
                                  {tr("Corners"), tr("The window's corners and centre in all coordinates")}});
    m_proportions = createProportions();
    createTable();

    m_contents = new QHBoxLayout;
    m_contents->setSpacing(kSpacing);
    m_contents->addWidget(m_drawing, 1);
    m_contents->addWidget(m_proportions, 2);
    m_contents->addWidget(m_table, 0, Qt::AlignTop);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    // The panel sets its own least size: the present contents must not prevent a narrower one.
    layout->setSizeConstraint(QLayout::SetNoConstraint);
    auto *head = new QHBoxLayout;
    head->addWidget(m_page);
    head->addStretch();
    head->addWidget(new HelpLink(QStringLiteral("near-window")));
    layout->addLayout(head);
    layout->addLayout(m_contents, 1);

    addCopyAction();
    connect(m_page, &SegmentedSwitch::chosen, this, &ViewportInspector::arrange);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Setup)
            refresh();
    });
    showSetup();
    arrange();
}

QWidget *ViewportInspector::createProportions()
{
    const auto label = [](const QString &accessibleName, const QString &toolTip = {}) {
        auto *made = new SteadyLabel;
        made->setAccessibleName(accessibleName);
        made->setToolTip(toolTip);
        return made;
    };
    m_window = label(tr("Window"), tr("The view's framebuffer in device pixels, and its pixel ratio"));
    m_window->setTextInteractionFlags(Qt::TextBrowserInteraction);
    connect(m_window, &QLabel::linkActivated, this, &ViewportInspector::sizeRequested);
    m_viewport = label(tr("Viewport"), tr("x, y, width, height in device pixels from the window's bottom-left corner"));
    const std::array names{std::pair(tr("Proportion (3)"), tr("Numbers of proportion (3)")),
                           std::pair(tr("Proportion (4)"), tr("Numbers of proportion (4)"))};
    const QString terms =
        tr("x_w, y_w: the pointer in the projection window, eye units, of a perspective on the near plane\n"
           "x_v, y_v: the centre of the pointer's pixel, device pixels from the window's bottom-left corner\n"
           "vx, vy, width, height: the viewport; left, right, bottom, top: the projection window");
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const QString symbols = proportionText(m_document.setup(), kAxes[i], {}).symbols;
        m_symbols[i] = label(names[i].first, terms);
        m_symbols[i]->setMarkup(proportionMarkup(symbols), symbols);
        m_symbols[i]->setFont(digitsFont(font()));
        m_numbers[i] = label(names[i].second, terms);
        m_numbers[i]->setFont(digitsFont(font()));
    }
    m_circle = label(tr("Shape of a circle"));

    auto *proportions = new QWidget;
    auto *layout = new QVBoxLayout(proportions);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    for (SteadyLabel *line : {m_window, m_viewport, m_symbols[0], m_numbers[0], m_symbols[1], m_numbers[1], m_circle})
        layout->addWidget(line);
    layout->addStretch();
    return proportions;
}

void ViewportInspector::createTable()
{
    m_table = new QTableView;
    m_table->setModel(m_corners);
    m_table->setAccessibleName(tr("Corners and centre of the window"));
    m_table->setFont(digitsFont(font()));
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(m_table, &QWidget::customContextMenuRequested, this, [this](const QPoint &position) {
        const QVariant value = m_table->indexAt(position).data(CornersModel::kValueRole);
        const QPointF pair = value.toPointF();
        if (value.isValid())
            showCopyMenu(*m_table, m_table->viewport()->mapToGlobal(position), {},
                         {QStringLiteral("position"), {pair.x(), pair.y()}});
    });
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    fixColumns();
}

/// The widths fit the longest expected texts, so that columns don't move with the pointer.
void ViewportInspector::fixColumns()
{
    QHeaderView *rows = m_table->verticalHeader(), *columns = m_table->horizontalHeader();
    const QFontMetrics metrics(m_table->font());
    rows->setFont(headsFont(font()));
    rows->setSectionResizeMode(QHeaderView::Fixed);
    rows->setMinimumSectionSize(0);
    rows->setDefaultSectionSize(std::max(metrics.height(), fontMetrics().height()) + 2);
    rows->setFixedWidth(rows->sizeHint().width() + 4);
    columns->setFont(headsFont(font()));
    columns->setSectionResizeMode(QHeaderView::Fixed);
    columns->setMinimumSectionSize(0);
    columns->setFixedHeight(fontMetrics().height() + 6);
    const std::pair<int, QString> widest[] = {{CornersModel::Widget, QStringLiteral("(8888.88, 8888.88)")},
                                              {CornersModel::Device, QStringLiteral("(8888, 8888)")},
                                              {CornersModel::Window, QStringLiteral("(8888.5, 8888.5)")},
                                              {CornersModel::Ndc, QStringLiteral("(-0.8888, -0.8888)")}};
    int width = rows->minimumWidth() + 2 * m_table->frameWidth();
    for (const auto &[column, text] : widest) {
        const int head = columns->fontMetrics().horizontalAdvance(
            m_corners->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
        m_table->setColumnWidth(column, std::max(metrics.horizontalAdvance(text), head) + kCellPadding);
        width += m_table->columnWidth(column);
    }
    m_table->setMaximumWidth(width);
    m_table->setMinimumHeight(columns->minimumHeight() + 3 * rows->defaultSectionSize());
    m_table->setMaximumHeight(columns->minimumHeight() + CornersModel::RowCount * rows->defaultSectionSize()
                              + 2 * m_table->frameWidth() + style()->pixelMetric(QStyle::PM_ScrollBarExtent));
}

void ViewportInspector::addCopyAction()
{
    auto *copy = new QAction(tr("Copy all"), this);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QAction::triggered, this, [this] { copyToClipboard(text()); });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

/// The width of the proportions' longest line with ordinary numbers; longer ones wrap.
int ViewportInspector::proportionsWidth() const
{
    constexpr int kCharacters = 60;
    return kCharacters * m_numbers[0]->fontMetrics().horizontalAdvance(u'0');
}

int ViewportInspector::leastWidth() const
{
    constexpr int kDigits = 43;
    return kDigits * fontMetrics().horizontalAdvance(u'0');
}

QSize ViewportInspector::sizeHint() const
{
    return {m_drawing->sizeHint().width() + proportionsWidth() + m_table->maximumWidth() + 2 * kSpacing,
            12 * fontMetrics().lineSpacing()};
}

QSize ViewportInspector::minimumSizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    return {std::max(leastWidth(), m_page->sizeHint().width() + margins.left() + margins.right()),
            layout()->minimumSize().height()};
}

/// Shows the chosen page, and others beside it if there is room.
void ViewportInspector::arrange()
{
    const QMargins margins = layout()->contentsMargins();
    const int room = width() - margins.left() - margins.right();
    const std::array<std::pair<QWidget *, int>, 3> parts{{{m_proportions, proportionsWidth()},
                                                          {m_drawing, m_drawing->minimumSizeHint().width()},
                                                          {m_table, m_table->maximumWidth()}}};
    std::array<bool, 3> isShown{};
    const auto chosen = static_cast<std::size_t>(m_page->choice());
    isShown[chosen] = true;
    int taken = parts[chosen].second;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        if (!isShown[i] && taken + kSpacing + parts[i].second <= room) {
            isShown[i] = true;
            taken += kSpacing + parts[i].second;
        }
    }
    for (std::size_t i = 0; i < parts.size(); ++i)
        parts[i].first->setVisible(isShown[i]);
    // The drawing and the proportions would otherwise get the room that the table needs.
    m_table->setMinimumWidth(std::clamp(room, 0, m_table->maximumWidth()));
    m_page->setVisible(isShown != std::array{true, true, true});
}

void ViewportInspector::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    arrange();
}

void ViewportInspector::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    refresh();
    showPointer();
}

void ViewportInspector::setPointer(const WidgetPoint &position)
{
    if (m_pointer && *m_pointer == position)
        return;
    m_pointer = position;
    if (isVisible())
        showPointer();
}

void ViewportInspector::clearPointer()
{
    m_pointer.reset();
    if (isVisible())
        showPointer();
}

void ViewportInspector::refresh()
{
    if (!isVisible() || (m_shown && isSameWindow(*m_shown, m_document.setup())))
        return;
    showSetup();
}

void ViewportInspector::showSetup()
{
    m_shown = m_document.setup();
    m_corners->setSetup(*m_shown);
    m_drawing->setSetup(*m_shown);
    const Viewport &v = m_shown->viewport;
    const QString window = windowText(m_shown->surface);
    m_window->setMarkup(QStringLiteral("%1 <a href=\"size\">%2</a>").arg(window.toHtmlEscaped(), tr("Change…")),
                        window);
    m_viewport->setText(viewportText(v));
    m_viewport->setValue({QStringLiteral("viewport"), {v.x, v.y, v.width, v.height}});
    m_window->setValue(
        {QStringLiteral("framebuffer"), {double(m_shown->surface.widthPixels), double(m_shown->surface.heightPixels)}});
    const double aspect = circleAspect(*m_shown);
    const ProjectionWindow w = projectionWindow(m_shown->projection());
    m_circle->setText(circleText(aspect));
    m_circle->setToolTip(
        tr("Shape of a circle parallel to the projection plane: the viewport is %1 : 1, the projection window %2 : 1")
            .arg(significantText(v.width / v.height, 4),
                 significantText(std::abs((w.right - w.left) / (w.top - w.bottom)), 4)));
    QFont font = m_circle->font();
    font.setBold(isDistorted(aspect));
    m_circle->setFont(font);
    showPointer();
}

void ViewportInspector::showPointer()
{
    m_corners->setPointer(m_pointer);
    m_drawing->setPointer(m_corners->pointerWindow());
    for (std::size_t i = 0; i < kAxes.size(); ++i) {
        const QString sides = sidesOf(proportionText(*m_shown, kAxes[i], m_corners->pointerWindow()));
        // Rich text is too slow for every move of the pointer; with a pointer no symbol is among
        // the numbers.
        if (m_corners->pointerWindow())
            m_numbers[i]->setText(sides);
        else
            m_numbers[i]->setMarkup(proportionMarkup(sides), sides);
    }
}

QString ViewportInspector::text() const
{
    QStringList lines{windowText(m_shown->surface), m_viewport->text()};
    for (const Axis axis : kAxes) {
        const ProportionText text = proportionText(*m_shown, axis, m_corners->pointerWindow());
        lines << text.symbols << text.line();
    }
    lines << m_circle->text();
    return lines.join(u'\n').replace(u'−', u'-') + u'\n' + m_corners->text();
}

} // namespace unprojector::gui
