#include "gui/landmarks/landmark_looks.h"

#include "gui/landmarks/landmark_marks.h"
#include "gui/landmarks/landmark_tool.h"
#include "gui/window/actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSettings>

#include <algorithm>
#include <functional>
#include <utility>

namespace unprojector::gui {
namespace {

constexpr char kLabelsKey[] = "landmarks/hasLabels", kSizeKey[] = "landmarks/markSize",
               kEdgesKey[] = "landmarks/loupeEdges";

/// The choice of this index; a damaged file may have any number.
QAction *choiceOf(const QActionGroup &group, int index)
{
    return group.actions().at(std::clamp(index, 0, static_cast<int>(group.actions().size()) - 1));
}

} // namespace

double radiusOf(MarkSize size)
{
    switch (size) {
    case MarkSize::Small: return 3.0;
    case MarkSize::Medium: return kMarkRadius;
    case MarkSize::Large: return 6.5;
    }
    return kMarkRadius;
}

LandmarkLooksMenu::LandmarkLooksMenu(LandmarkTool &tool) : QObject(&tool), m_tool(tool) {}

void LandmarkLooksMenu::addTo(QMenu &menu)
{
    QMenu &own = *menu.addMenu(tr("Landmar&ks"));
    own.setToolTipsVisible(true);
    m_labels = addSwitch(own, tr("&Labels"), Qt::Key_H, tr("Show the names of the landmarks in the view"));
    m_labels->setChecked(m_tool.looks().hasLabels);
    connect(m_labels, &QAction::toggled, this, [this](bool hasLabels) {
        LandmarkLooks looks = m_tool.looks();
        looks.hasLabels = hasLabels;
        m_tool.setLooks(looks);
    });
    const auto addChoice = [&own](QActionGroup &group, const QString &text, const QString &tip, bool isChosen,
                                  std::function<void()> choose) {
        QAction *action = addSwitch(own, text, {}, tip);
        action->setActionGroup(&group);
        action->setChecked(isChosen);
        connect(action, &QAction::toggled, &group, [choose = std::move(choose)](bool isOn) {
            if (isOn)
                choose();
        });
    };
    own.addSection(tr("Markers"));
    m_sizes = new QActionGroup(&own);
    const auto addSize = [&](MarkSize size, const QString &text, const QString &tip) {
        addChoice(*m_sizes, text, tip, size == m_tool.looks().size, [this, size] {
            LandmarkLooks looks = m_tool.looks();
            looks.size = size;
            m_tool.setLooks(looks);
        });
    };
    addSize(MarkSize::Small, tr("&Small"), tr("Small markers, for many landmarks"));
    addSize(MarkSize::Medium, tr("&Medium"), tr("Markers of medium size"));
    addSize(MarkSize::Large, tr("Lar&ge"), tr("Large markers, for a large screen"));
    own.addSection(tr("Mesh edges in the loupe"));
    m_edges = new QActionGroup(&own);
    const auto addEdges = [&](LoupeEdges edges, const QString &text, const QString &tip) {
        addChoice(*m_edges, text, tip, edges == m_tool.looks().loupeEdges, [this, edges] {
            LandmarkLooks looks = m_tool.looks();
            looks.loupeEdges = edges;
            m_tool.setLooks(looks);
        });
    };
    addEdges(LoupeEdges::WhereLong, tr("&Where They Are Long"),
             tr("Show the edges in the loupe only where most are longer than 6 pixels"));
    addEdges(LoupeEdges::Always, tr("&Always"), tr("Always show the edges in the loupe"));
    addEdges(LoupeEdges::Never, tr("&Never"), tr("Show only the surface in the loupe"));
}

void LandmarkLooksMenu::keep(QSettings &settings) const
{
    const LandmarkLooks &looks = m_tool.looks();
    settings.setValue(QLatin1String(kLabelsKey), looks.hasLabels);
    settings.setValue(QLatin1String(kSizeKey), static_cast<int>(looks.size));
    settings.setValue(QLatin1String(kEdgesKey), static_cast<int>(looks.loupeEdges));
}

void LandmarkLooksMenu::restore(const QSettings &settings)
{
    const LandmarkLooks looks = m_tool.looks();
    m_labels->setChecked(settings.value(QLatin1String(kLabelsKey), looks.hasLabels).toBool());
    choiceOf(*m_sizes, settings.value(QLatin1String(kSizeKey), static_cast<int>(looks.size)).toInt())->setChecked(true);
    choiceOf(*m_edges, settings.value(QLatin1String(kEdgesKey), static_cast<int>(looks.loupeEdges)).toInt())
        ->setChecked(true);
}

} // namespace unprojector::gui
