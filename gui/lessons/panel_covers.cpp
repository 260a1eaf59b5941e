#include "gui/lessons/panel_covers.h"

#include <QDockWidget>
#include <QLabel>

#include <vector>

namespace unprojector::gui {
namespace {

constexpr int kMargin = 12;

/// A text that takes over the size of the panel it replaces.
class CoverLabel : public QLabel {
public:
    explicit CoverLabel(const QWidget &panel) : m_panel(panel)
    {
        setTextFormat(Qt::PlainText);
        setWordWrap(true);
        setMargin(kMargin);
        setAlignment(Qt::AlignTop | Qt::AlignLeft);
        setForegroundRole(QPalette::PlaceholderText);
        setSizePolicy(panel.sizePolicy());
        setMinimumSize(panel.minimumSize());
    }

    QSize sizeHint() const override { return m_panel.sizeHint(); }
    QSize minimumSizeHint() const override { return m_panel.minimumSizeHint(); }
    bool hasHeightForWidth() const override { return m_panel.hasHeightForWidth(); }
    int heightForWidth(int width) const override { return m_panel.heightForWidth(width); }

private:
    const QWidget &m_panel;
};

} // namespace

void PanelCovers::set(const std::map<Panel, QString> &texts)
{
    std::vector<Panel> opened;
    for (const auto &[panel, cover] : m_covers) {
        if (!texts.contains(panel))
            opened.push_back(panel);
    }
    for (const Panel panel : opened)
        open(panel);
    for (const auto &[panel, text] : texts) {
        QDockWidget &dock = m_workspaces.dock(panel);
        if (!m_covers.contains(panel)) {
            QWidget *covered = dock.widget();
            auto *label = new CoverLabel(*covered);
            label->setObjectName(QStringLiteral("cover"));
            label->setAccessibleName(dock.windowTitle());
            dock.setWidget(label); // the panel stays a child of the dock, hidden
            label->show();
            m_covers.emplace(panel, Cover{covered, label});
        }
        static_cast<QLabel *>(m_covers.at(panel).widget)->setText(text);
    }
}

void PanelCovers::open(Panel panel)
{
    const auto found = m_covers.find(panel);
    QDockWidget &dock = m_workspaces.dock(panel);
    dock.setWidget(found->second.panel);
    found->second.panel->show();
    delete found->second.widget;
    m_covers.erase(found);
}

} // namespace unprojector::gui
