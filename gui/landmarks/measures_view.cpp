#include "gui/landmarks/measures_view.h"

#include "core/base/replace_file.h"
#include "core/landmark_files/measures_file.h"
#include "gui/document/scene_curves.h"
#include "gui/document/scene_document.h"
#include "gui/document/scene_edits.h"
#include "gui/landmarks/computing_button.h"
#include "gui/landmarks/measure_rows.h"
#include "gui/landmarks/protocol_rows.h"
#include "gui/text/error_text.h"
#include "gui/widgets/copy_menu.h"
#include "gui/widgets/file_dialogs.h"
#include "gui/widgets/number_delegate.h"
#include "gui/widgets/save_name.h"
#include "gui/widgets/segmented_switch.h"

#include <QApplication>
#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QStyle>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {

namespace {

/// Shortens each name of a row instead of the row: its order stays visible.
class NamesDelegate : public NumberDelegate {
public:
    using NumberDelegate::NumberDelegate;

protected:
    void initStyleOption(QStyleOptionViewItem *option, const QModelIndex &index) const override
    {
        NumberDelegate::initStyleOption(option, index);
        const QStyle &style = option->widget ? *option->widget->style() : *QApplication::style();
        const int margin = style.pixelMetric(QStyle::PM_FocusFrameHMargin, option, option->widget) + 1;
        if (const int width = option->rect.width() - 2 * margin; width > 0) // else the wanted size is asked for
            option->text = namesFitted(option->text, option->fontMetrics, width);
    }
};

} // namespace

MeasuresView::MeasuresView(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document),
      m_what(new SegmentedSwitch(
          tr("Measured quantity"),
          {{tr("Selected"), tr("Distances, angles and heights of the selected landmarks")},
           {tr("Left and Right"),
            tr("Landmarks whose names differ only in left and right, and the plane that mirrors them best")},
           {tr("Protocol"), tr("Kept measures: each is measured on every scan of a series, and a column of its "
                               "tables")}})),
      m_keep(new QToolButton), m_remove(new QToolButton), m_unit(new QComboBox), m_rows(new QTreeWidget),
      m_empty(new QLabel)
{
    m_rows->setAccessibleName(tr("Measures"));
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setHeaderLabels({tr("Measure"), tr("Landmarks"), tr("Value")});
    m_rows->setTextElideMode(Qt::ElideMiddle);
    m_rows->setItemDelegateForColumn(1, new NamesDelegate(m_rows));
    m_rows->setItemDelegateForColumn(2, new NumberDelegate(m_rows));
    m_rows->setSelectionMode(QAbstractItemView::SingleSelection);
    m_rows->setToolTip(tr("Select a measure to show it in the view; select it again to hide it"));
    connect(m_rows, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem *item) {
        const QString kind = item->text(0);
        const int row = m_rows->indexOfTopLevelItem(item);
        const bool isAgain = m_chosen == row;
        if (m_what->choice() == OfProtocol)
            selectLandmarksOf(static_cast<std::size_t>(row)); // replaces the items
        m_chosenKind = isAgain ? QString() : kind;
        m_chosen = isAgain ? std::nullopt : std::optional(row);
        showChosen();
    });
    connect(m_rows, &QTreeWidget::itemActivated, this, [this](QTreeWidgetItem *item) { // Enter
        m_chosenKind = item->text(0);
        m_chosen = m_rows->indexOfTopLevelItem(item);
        showChosen();
    });
    m_rows->setFocusPolicy(Qt::StrongFocus);
    m_rows->setContextMenuPolicy(Qt::CustomContextMenu);
    m_rows->header()->setStretchLastSection(false);
    m_rows->header()->setSectionResizeMode(QHeaderView::Fixed);
    m_rows->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_rows->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    connect(m_rows, &QWidget::customContextMenuRequested, this, &MeasuresView::showMenu);
    m_empty->setWordWrap(true);
    m_unit->setAccessibleName(tr("Unit of the scene"));
    m_unit->setToolTip(tr("Length of a world unit of this scene; coordinates are not converted"));
    connect(m_unit, &QComboBox::activated, this, &MeasuresView::setUnit);
    connect(m_what, &SegmentedSwitch::chosen, this, [this] { showRows(); });
    m_rows->setEditTriggers(QAbstractItemView::NoEditTriggers);
    connect(m_rows, &QTreeWidget::itemDoubleClicked, this, [this](QTreeWidgetItem *item, int column) {
        if (m_what->choice() == OfProtocol && column == 0)
            m_rows->editItem(item, 0);
    });
    connect(m_rows, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem *item) { rename(*item); });
    m_keep->setText(tr("Keep"));
    m_keep->setToolTip(tr("Keep the chosen measure in the protocol"));
    m_remove->setText(tr("Remove"));
    m_remove->setToolTip(tr("Remove the chosen measure from the protocol"));
    auto *files = new QMenu(this);
    files->addAction(tr("&Load Protocol…"), this, &MeasuresView::loadProtocol);
    files->addAction(tr("&Save Protocol…"), this, &MeasuresView::saveProtocol);
    for (QToolButton *button : {m_keep, m_remove}) {
        button->setFocusPolicy(Qt::StrongFocus);
        button->setPopupMode(QToolButton::MenuButtonPopup);
        button->setMenu(files);
    }
    connect(m_keep, &QToolButton::clicked, this, &MeasuresView::keep);
    connect(m_remove, &QToolButton::clicked, this, &MeasuresView::removeFromProtocol);
    m_remove->hide(); // both side by side would widen the panel
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Landmarks)
            showUnit();
        if (changes & Change::LandmarkSelection)
            m_chosen.reset();
        if ((changes & (Change::Landmarks | Change::LandmarkSelection | Change::Objects | Change::Placement))
            || ((changes & Change::Curves) && !m_isShowing))
            showRows();
    });

    auto *line = new QHBoxLayout;
    line->addWidget(m_what);
    line->addStretch();
    line->addWidget(m_keep);
    line->addWidget(m_unit);
    line->addWidget(m_remove);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(line);
    layout->addWidget(m_empty);
    layout->addWidget(m_rows, 1);
    layout->addStretch(); // less than a row
    showUnit();
    showRows();
}

void MeasuresView::showUnit()
{
    const QSignalBlocker blocker(m_unit);
    const QString unit = QString::fromStdString(m_document.scene().landmarks.unit);
    m_unit->clear();
    m_unit->addItem(tr("world units"), QString());
    for (const char *known : {"mm", "cm", "m", "in"})
        m_unit->addItem(QLatin1String(known), QLatin1String(known));
    if (m_unit->findData(unit) < 0)
        m_unit->addItem(unit, unit);
    m_unit->setCurrentIndex(m_unit->findData(unit));
}

void MeasuresView::setUnit(int index)
{
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    set.unit = m_unit->itemData(index).toString().toStdString();
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {tr("Unit")}));
}

std::vector<MeasureRow> MeasuresView::rows() const
{
    const landmarks::LandmarkSet &set = m_document.scene().landmarks;
    if (m_what->choice() == OfSides)
        return sidesOf(set);
    const std::vector<std::size_t> &selection = m_document.sceneLandmarks().selectionInOrder();
    if (m_what->choice() == OfProtocol)
        return protocolRows(set, selection, m_document.curves().throughSelected());
    std::vector<MeasureRow> rows = measuresOf(set, selection);
    if (const SceneCurves::Line *line = m_document.curves().throughSelected())
        rows.push_back(surfaceLengthOf(set, selection, *line));
    return rows;
}

void MeasuresView::showRows()
{
    const bool isSides = m_what->choice() == OfSides;
    const bool isProtocol = m_what->choice() == OfProtocol;
    const QSignalBlocker blocker(m_rows);
    constexpr int kPlaneRows = 2; // the plane, and its landmarks
    m_listed = rows();
    m_rows->clear();
    for (const MeasureRow &row : m_listed) {
        auto *item = new QTreeWidgetItem(m_rows, {row.kind, row.points, row.value});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setData(1, NumberDelegate::kTextsRole, row.pointsTexts);
        item->setData(2, NumberDelegate::kTextsRole, row.valueTexts);
        if (row.isComputing)
            showComputing(*m_rows, *item, 2, m_document.curves(), true);
        if (isProtocol)
            item->setFlags(item->flags() | Qt::ItemIsEditable);
        QString tip =
            row.value.isEmpty()
                ? tr("%1 %2", "what is shown, of which landmarks").arg(row.kind, row.points)
                : tr("%1 %2: %3", "what is measured, of which points, its value").arg(row.kind, row.points, row.value);
        if (row.shown && row.shown->shape == ShownMeasure::Shape::Surface)
            tip += QStringLiteral(". ")
                   + tr("Geodesic of the mesh from landmark to landmark, like a thread pulled tight, exact to rounding "
                        "for the triangles. Around a hole or a hill it follows the shortest of the paths over sample "
                        "points on the edges.");
        if (isSides && row.shown && row.shown->points.size() == 2)
            tip += QStringLiteral(". ")
                   + (row.shown->points[0] == row.shown->points[1]
                          ? tr("The distance of a landmark of the middle from the mirror plane. Its mirror image is "
                               "twice as far.")
                          : tr("The distance of a landmark's mirror image from its partner."));
        if (isSides && m_rows->topLevelItemCount() <= kPlaneRows)
            tip += QStringLiteral(". ")
                   + tr("A landmark without left or right in its name counts as in the middle. A hidden landmark is "
                        "left out.");
        for (int column = 0; column < 3; ++column)
            item->setToolTip(column, plainToolTip(tip));
    }
    m_empty->setText(
        isSides ? tr(
            "No pairs. Give landmarks names that differ only in “left” and “right”, as “eye left” and “eye right”.")
        : isProtocol ? tr("No measures kept yet. Select landmarks, choose a measure under Selected, and press Keep.")
                     : tr("Select two or more landmarks to measure between them."));
    m_empty->setVisible(m_listed.empty());
    m_rows->setVisible(!m_listed.empty());
    layout()->activate();
    showWholeRows();
    fitColumns();
    showChosen();
}

void MeasuresView::showWholeRows()
{
    const int row = m_rows->sizeHintForRow(0);
    if (row <= 0)
        return;
    const int around = m_rows->header()->sizeHint().height() + 2 * m_rows->frameWidth();
    const int room = height() - m_rows->y() - around;
    m_rows->setMaximumHeight(around + std::max(1, room / row) * row);
}

void MeasuresView::resizeEvent(QResizeEvent *event)
{
    QWidget::resizeEvent(event);
    showWholeRows();
    fitColumns();
}

void MeasuresView::fitColumns()
{
    constexpr double kMostOfKinds = 0.35, kMostOfValues = 0.45;
    const int width = m_rows->viewport()->width();
    QHeaderView &header = *m_rows->header();
    const auto wanted = [this, &header](int column) {
        return std::max(static_cast<QAbstractItemView *>(m_rows)->sizeHintForColumn(column),
                        header.sectionSizeHint(column));
    };
    const int kinds = std::min(wanted(0), static_cast<int>(kMostOfKinds * width));
    const int values = std::min(wanted(2), static_cast<int>(kMostOfValues * width));
    header.resizeSection(0, kinds);
    header.resizeSection(2, values);
}

void MeasuresView::showChosen()
{
    const auto count = static_cast<int>(m_listed.size());
    if (m_chosen && (*m_chosen >= count || m_listed[static_cast<std::size_t>(*m_chosen)].kind != m_chosenKind))
        m_chosen.reset();
    for (int i = 0; i < count && !m_chosen && !m_chosenKind.isEmpty(); ++i) { // the first of that kind
        if (m_listed[static_cast<std::size_t>(i)].kind == m_chosenKind)
            m_chosen = i;
    }
    std::optional<ShownMeasure> shown;
    if (m_chosen) {
        const MeasureRow &row = m_listed[static_cast<std::size_t>(*m_chosen)];
        shown = row.shown;
        if (shown && shown->text.isEmpty())
            shown->text = row.value;
    }
    showProtocolButton();
    m_rows->clearSelection();
    if (m_chosen)
        m_rows->topLevelItem(*m_chosen)->setSelected(true);
    m_isShowing = true; // selecting it here is not the user's choice
    m_document.curves().showMeasure(std::move(shown));
    m_isShowing = false;
}

QString MeasuresView::csv() const
{
    return csvOf(rows(), QString::fromStdString(m_document.scene().landmarks.unit));
}

void MeasuresView::showMenu(const QPoint &place)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (QTreeWidgetItem *item = m_rows->itemAt(place); item && m_what->choice() == OfProtocol)
        menu->addAction(tr("&Rename"), m_rows, [rows = m_rows, index = m_rows->indexOfTopLevelItem(item)] {
            if (QTreeWidgetItem *named = rows->topLevelItem(index))
                rows->editItem(named, 0);
        });
    menu->addAction(tr("Copy as C&SV"), this, [this] { copyToClipboard(csv()); });
    const SceneCurves::Line *line = m_document.curves().throughSelected();
    if (line && line->isCancelled)
        menu->addAction(tr("&Compute Again"), this, [this] { m_document.curves().computeAgain(); });
    menu->popup(m_rows->viewport()->mapToGlobal(place));
}

// ---- the protocol -------------------------------------------------------------------------------

const std::vector<landmarks::KeptMeasure> &MeasuresView::protocol() const
{
    return m_document.scene().landmarks.measures;
}

void MeasuresView::editProtocol(std::vector<landmarks::KeptMeasure> measures, const QString &text)
{
    landmarks::LandmarkSet set = m_document.scene().landmarks;
    set.measures = std::move(measures);
    static_cast<void>(editLandmarkSet(m_document, std::move(set), {text}));
}

void MeasuresView::showProtocolButton()
{
    m_keep->setVisible(m_what->choice() != OfSides && m_what->choice() != OfProtocol);
    m_remove->setVisible(m_what->choice() == OfProtocol);
}

void MeasuresView::removeFromProtocol()
{
    std::vector<landmarks::KeptMeasure> measures = protocol();
    if (!m_chosen) {
        emit warned(tr("Choose a measure in the list first."));
        return;
    }
    const auto removed = measures.begin() + *m_chosen;
    const QString name = QString::fromStdString(removed->name);
    measures.erase(removed);
    editProtocol(std::move(measures), tr("Remove measure %1").arg(name));
}

void MeasuresView::keep()
{
    std::vector<landmarks::KeptMeasure> measures = protocol();
    if (!m_chosen) {
        emit warned(tr("Choose a measure in the list first."));
        return;
    }
    const std::optional<ShownMeasure> &shown = m_listed[static_cast<std::size_t>(*m_chosen)].shown;
    std::optional<landmarks::KeptMeasure> kept =
        shown ? keptMeasureOf(*shown, m_document.scene().landmarks) : std::nullopt;
    if (!kept) {
        emit warned(shown ? tr("A kept measure knows its landmarks by name. Give each of them a name of its own.")
                          : tr("This measure has no value yet, so it cannot be kept."));
        return;
    }
    const QString name = QString::fromStdString(kept->name);
    measures.push_back(std::move(*kept));
    editProtocol(std::move(measures), tr("Keep measure %1").arg(name));
}

void MeasuresView::rename(QTreeWidgetItem &item)
{
    std::vector<landmarks::KeptMeasure> measures = protocol();
    const auto index = static_cast<std::size_t>(m_rows->indexOfTopLevelItem(&item));
    if (m_what->choice() != OfProtocol || index >= measures.size())
        return;
    const std::string name = item.text(0).trimmed().toStdString();
    const bool isTaken = std::any_of(measures.begin(), measures.end(),
                                     [&name](const landmarks::KeptMeasure &other) { return other.name == name; });
    if (name.empty() || isTaken) {
        if (isTaken && name != measures[index].name)
            emit warned(tr("There is a measure of this name already."));
        showRows();
        return;
    }
    measures[index].name = name;
    m_chosenKind = QString::fromStdString(name);
    editProtocol(std::move(measures), tr("Rename measure"));
}

void MeasuresView::loadProtocol()
{
    const std::filesystem::path file =
        askFileName(*this, FileKind::Table, tr("Load Protocol"), tr("Protocol (%1)").arg(QStringLiteral("*.csv")));
    if (file.empty())
        return;
    auto read = landmark_files::readMeasures(file);
    if (!read) {
        emit warned(QString::fromStdString(read.error().message()));
        return;
    }
    m_what->setChoice(OfProtocol);
    editProtocol(std::move(read).value(), tr("Load protocol"));
}

void MeasuresView::saveProtocol()
{
    const std::filesystem::path file =
        askSaveName(*this, tr("Save Protocol"), {tr("Protocol (%1)").arg(QStringLiteral("*.csv"))},
                    QStringLiteral("protocol.measures.csv"))
            .file;
    if (file.empty())
        return;
    if (const base::Done written = base::replaceFile(file, landmark_files::measuresText(protocol())); !written)
        emit warned(QStringLiteral("%1: %2").arg(pathText(file), QString::fromStdString(written.error().text)));
}

void MeasuresView::selectLandmarksOf(std::size_t row)
{
    if (row >= protocol().size())
        return;
    std::vector<std::size_t> order;
    for (const std::size_t index : indicesOf(protocol()[row], m_document.scene().landmarks)) {
        if (std::find(order.begin(), order.end(), index) == order.end())
            order.push_back(index);
    }
    if (!order.empty())
        m_document.sceneLandmarks().selectInOrder(std::move(order));
}

} // namespace unprojector::gui
