#include "gui/panels/viewport_inspector.h"

#include "core/geometry/proportions.h"
#include "gui/document/scene_document.h"
#include "gui/panels/corners_model.h"
#include "gui/panels/segmented_switch.h"
#include "gui/panels/viewport_drawing.h"
#include "gui/text/number_text.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QFontDatabase>
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

/// The window and its projection are all that is shown: the camera may move without any work here.
bool isSameWindow(const Picture &a, const Picture &b)
{
    return a.surface == b.surface && a.viewport == b.viewport && a.depthRange == b.depthRange && a.lens == b.lens;
}

/// The panel's own font, for headers inside a table that has another: every property is set, none inherited.
QFont ownFont(const QWidget &widget)
{
    QFont font = widget.font();
    font.setFamilies({widget.fontInfo().family()});
    font.setPointSizeF(widget.font().pointSizeF());
    return font;
}

QFont digitsFont(const QWidget &widget)
{
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(widget.font().pointSizeF() * 0.92);
    return font;
}

/// Wide enough for every line, and never narrower again: nothing beside it moves. A fixed size also keeps new texts
/// from laying out the panel anew.
void fitLabel(QLabel &label, const QString &text)
{
    const QSize needed = label.fontMetrics().size(0, text) + QSize(2, 0);
    label.setFixedSize(needed.expandedTo(label.minimumSize()));
}

} // namespace

ViewportInspector::ViewportInspector(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document), m_corners(new CornersModel(this)), m_drawing(new ViewportDrawing)
{
    m_page = new SegmentedSwitch(tr("What is shown"),
                                 {{tr("Proportions"), tr("The proportions (3) and (4) with their numbers")},
                                  {tr("Corners"), tr("The window's corners and centre in all coordinates")}});
    m_proportions = createProportions();
    createTable();

    auto *contents = new QHBoxLayout;
    contents->setSpacing(kSpacing);
    contents->addWidget(m_drawing, 1);
    contents->addWidget(m_proportions, 0, Qt::AlignTop);
    contents->addWidget(m_table, 0, Qt::AlignTop | Qt::AlignLeft);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 6, 8, 6);
    layout->setSpacing(4);
    // The panel says itself how small it can be: the wide arrangement must not keep it from becoming narrow.
    layout->setSizeConstraint(QLayout::SetNoConstraint);
    layout->addWidget(m_page, 0, Qt::AlignLeft);
    layout->addLayout(contents, 1);

    addCopyAction();
    connect(m_page, &SegmentedSwitch::chosen, this, &ViewportInspector::arrange);
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Picture)
            refresh();
    });
    showPicture();
    arrange();
}

QWidget *ViewportInspector::createProportions()
{
    const auto label = [](const QString &accessibleName, const QString &toolTip) {
        auto *made = new QLabel;
        made->setTextFormat(Qt::PlainText);
        made->setAlignment(Qt::AlignLeft | Qt::AlignTop);
        made->setAccessibleName(accessibleName);
        made->setToolTip(toolTip);
        return made;
    };
    m_window =
        label(tr("Window"), tr("The view's framebuffer in device pixels, and how many of them make a logical pixel"));
    m_viewport = label(tr("Viewport"), tr("x, y, width, height in device pixels from the window's bottom-left corner"));
    m_formulas =
        label(tr("Proportions (3) and (4)"),
              tr("x_w, y_w: the pointer in the projection window, eye units, of a perspective on the near plane\n"
                 "x_v, y_v: the centre of the pointer's pixel, device pixels from the window's bottom-left corner\n"
                 "vx, vy, width, height: the viewport; left, right, bottom, top: the projection window"));
    m_formulas->setFont(digitsFont(*this));
    m_circle = label(tr("Shape of a circle"), {});

    auto *proportions = new QWidget;
    auto *lines = new QVBoxLayout(proportions);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(2);
    for (QLabel *line : {m_window, m_viewport, m_formulas, m_circle})
        lines->addWidget(line);
    return proportions;
}

void ViewportInspector::createTable()
{
    m_table = new QTableView;
    m_table->setModel(m_corners);
    m_table->setAccessibleName(tr("Corners and centre of the window"));
    m_table->setFont(digitsFont(*this));
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_table->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
    fixColumns();
}

/// The widths are those of the longest texts to expect, so that the columns stand still as the pointer moves.
void ViewportInspector::fixColumns()
{
    QHeaderView *rows = m_table->verticalHeader(), *columns = m_table->horizontalHeader();
    const QFontMetrics metrics(m_table->font());
    rows->setFont(ownFont(*this));
    rows->setSectionResizeMode(QHeaderView::Fixed);
    rows->setMinimumSectionSize(0);
    rows->setDefaultSectionSize(std::max(metrics.height(), fontMetrics().height()) + 2);
    rows->setFixedWidth(rows->sizeHint().width() + 4);
    columns->setFont(ownFont(*this));
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
    m_table->setFixedWidth(width);
    m_table->setMinimumHeight(columns->minimumHeight() + 3 * rows->defaultSectionSize());
    m_table->setMaximumHeight(columns->minimumHeight() + CornersModel::RowCount * rows->defaultSectionSize()
                              + 2 * m_table->frameWidth());
}

void ViewportInspector::addCopyAction()
{
    auto *copy = new QAction(tr("Copy all"), this);
    copy->setShortcut(QKeySequence::Copy);
    copy->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    connect(copy, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(text()); });
    addAction(copy);
    setContextMenuPolicy(Qt::ActionsContextMenu);
}

int ViewportInspector::widthForAll() const
{
    return widthWithDrawing(m_proportions->layout()->minimumSize().width() + kSpacing + m_table->maximumWidth());
}

int ViewportInspector::widthWithDrawing(int others) const
{
    const QMargins margins = layout()->contentsMargins();
    return margins.left() + m_drawing->minimumSizeHint().width() + kSpacing + others + margins.right();
}

QSize ViewportInspector::sizeHint() const
{
    return {widthForAll() + m_drawing->sizeHint().width() - m_drawing->minimumSizeHint().width(), 180};
}

QSize ViewportInspector::minimumSizeHint() const
{
    const QMargins margins = layout()->contentsMargins();
    const QSize proportions = m_proportions->layout()->minimumSize();
    return {std::max(widthWithDrawing(proportions.width()), margins.left() + m_table->maximumWidth() + margins.right()),
            margins.top() + m_page->sizeHint().height() + layout()->spacing() + proportions.height()
                + margins.bottom()};
}

void ViewportInspector::arrange()
{
    const bool isWide = width() >= widthForAll();
    const bool showsProportions = isWide || m_page->choice() == 0;
    m_page->setVisible(!isWide);
    m_drawing->setVisible(showsProportions || width() >= widthWithDrawing(m_table->maximumWidth()));
    m_proportions->setVisible(showsProportions);
    m_table->setVisible(isWide || !showsProportions);
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
    if (!isVisible() || (m_shown && isSameWindow(*m_shown, m_document.geometry())))
        return;
    showPicture();
}

void ViewportInspector::showPicture()
{
    m_shown = m_document.geometry();
    const Surface &s = m_shown->surface;
    const Viewport &v = m_shown->viewport;
    m_corners->setPicture(*m_shown);
    m_drawing->setPicture(*m_shown);
    m_window->setText(tr("Window %1 × %2 device pixels, device pixel ratio %3")
                          .arg(s.widthPixels)
                          .arg(s.heightPixels)
                          .arg(significantText(s.devicePixelRatio, 4)));
    m_viewport->setText(QStringLiteral("glViewport(%1, %2, %3, %4)")
                            .arg(significantText(v.x, 6), significantText(v.y, 6), significantText(v.width, 6),
                                 significantText(v.height, 6)));
    const double aspect = circleAspect(*m_shown);
    const ProjectionWindow w = projectionWindow(m_shown->projection());
    m_circle->setText(circleText(aspect));
    m_circle->setToolTip(
        tr("Of a circle parallel to the projection plane: the viewport is %1 : 1, the projection window %2 : 1")
            .arg(significantText(v.width / v.height, 4),
                 significantText(std::abs((w.right - w.left) / (w.top - w.bottom)), 4)));
    QFont font = m_circle->font();
    font.setBold(isDistorted(aspect));
    m_circle->setFont(font);
    showPointer();
    for (QLabel *label : {m_window, m_viewport, m_formulas, m_circle})
        fitLabel(*label, label->text());
}

void ViewportInspector::showPointer()
{
    m_corners->setPointer(m_pointer);
    m_drawing->setPointer(m_corners->pointerWindow());
    m_formulas->setText(proportionLines());
}

std::array<ProportionText, 2> ViewportInspector::proportionTexts() const
{
    const std::optional<WindowPoint> pointer = m_corners->pointerWindow();
    return {proportionText(*m_shown, Axis::X, pointer), proportionText(*m_shown, Axis::Y, pointer)};
}

/// Each proportion in symbols, then a side a line with its numbers.
QString ViewportInspector::proportionLines() const
{
    QStringList lines;
    for (const ProportionText &text : proportionTexts()) {
        lines << text.symbols << QStringLiteral("    ") + text.left
              << QStringLiteral("  = ") + text.right
                     + (text.share.isEmpty() ? text.share : QStringLiteral(" = ") + text.share);
    }
    return lines.join(u'\n');
}

QString ViewportInspector::text() const
{
    QStringList lines{m_window->text(), m_viewport->text()};
    for (const ProportionText &text : proportionTexts())
        lines << text.symbols << text.line();
    lines << m_circle->text();
    return lines.join(u'\n').replace(u'−', u'-') + u'\n' + m_corners->text();
}

} // namespace unprojector::gui
