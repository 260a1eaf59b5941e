#include "gui/panels/measures_view.h"

#include "gui/document/scene_document.h"
#include "gui/panels/copy_menu.h"
#include "gui/panels/segmented_switch.h"
#include "gui/text/error_text.h"
#include "gui/text/measure_rows.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace unprojector::gui {

MeasuresView::MeasuresView(SceneDocument &document, QWidget *parent)
    : QWidget(parent), m_document(document),
      m_what(new SegmentedSwitch(tr("What is measured"),
                                 {{tr("Selected"), tr("Distances, angles and heights of the points that are selected")},
                                  {tr("Left and Right"), tr("Points whose names are the same but for left and right, "
                                                            "and the plane that mirrors them best")}})),
      m_unit(new QComboBox), m_rows(new QTreeWidget), m_empty(new QLabel)
{
    m_rows->setAccessibleName(tr("Measures"));
    m_rows->setRootIsDecorated(false);
    m_rows->setUniformRowHeights(true);
    m_rows->setHeaderLabels({tr("Measure"), tr("Points"), tr("Value")});
    m_rows->setTextElideMode(Qt::ElideMiddle);
    m_rows->setSelectionMode(QAbstractItemView::NoSelection);
    m_rows->setFocusPolicy(Qt::StrongFocus);
    m_rows->setContextMenuPolicy(Qt::CustomContextMenu);
    m_rows->header()->setStretchLastSection(false);
    m_rows->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    m_rows->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    m_rows->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    connect(m_rows, &QWidget::customContextMenuRequested, this, &MeasuresView::showMenu);
    m_empty->setWordWrap(true);
    m_unit->setAccessibleName(tr("Unit of the scene"));
    m_unit->setToolTip(tr("What a world unit of this scene is; nothing is converted"));
    connect(m_unit, &QComboBox::activated, this, &MeasuresView::setUnit);
    connect(m_what, &SegmentedSwitch::chosen, this, [this] { showRows(); });
    connect(&m_document, &SceneDocument::changed, this, [this](Changes changes) {
        if (changes & Change::Landmarks)
            showUnit();
        if (changes & (Change::Landmarks | Change::LandmarkSelection))
            showRows();
    });

    auto *line = new QHBoxLayout;
    line->addWidget(m_what);
    line->addStretch();
    line->addWidget(m_unit);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(line);
    layout->addWidget(m_empty);
    layout->addWidget(m_rows, 1);
    layout->addStretch(); // what is less than a row
    showUnit();
    showRows();
}

void MeasuresView::showUnit()
{
    const QSignalBlocker blocker(m_unit);
    const QString unit = QString::fromStdString(m_document.landmarkSet().unit);
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
    landmarks::LandmarkSet set = m_document.landmarkSet();
    set.unit = m_unit->itemData(index).toString().toStdString();
    static_cast<void>(m_document.editLandmarkSet(std::move(set), {tr("Unit")}));
}

void MeasuresView::showRows()
{
    const landmarks::LandmarkSet &set = m_document.landmarkSet();
    const bool isSides = m_what->choice() == OfSides;
    const std::vector<MeasureRow> rows = isSides ? sidesOf(set) : measuresOf(set, m_document.points().selection());
    m_rows->clear();
    for (const MeasureRow &row : rows) {
        auto *item = new QTreeWidgetItem(m_rows, {row.kind, row.points, row.value});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        for (int column = 0; column < 3; ++column)
            item->setToolTip(column, plainToolTip(row.kind + u' ' + row.points + QStringLiteral(": ") + row.value));
    }
    m_empty->setText(isSides
                         ? tr("No pairs: name points alike but for “left” and “right”, as “eye left” and “eye right”.")
                         : tr("Select two points or more to measure between them."));
    m_empty->setVisible(rows.empty());
    m_rows->setVisible(!rows.empty());
    layout()->activate();
    showWholeRows();
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
}

QString MeasuresView::csv() const
{
    const landmarks::LandmarkSet &set = m_document.landmarkSet();
    return csvOf(m_what->choice() == OfSides ? sidesOf(set) : measuresOf(set, m_document.points().selection()),
                 QString::fromStdString(set.unit));
}

void MeasuresView::showMenu(const QPoint &place)
{
    auto *menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    menu->addAction(tr("Copy as C&SV"), this, [this] { copyToClipboard(csv()); });
    menu->popup(m_rows->viewport()->mapToGlobal(place));
}

} // namespace unprojector::gui
