#pragma once

#include <QMap>
#include <QObject>
#include <QString>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace unprojector::gui {

/// The "?" of the panels: at the right of a panel's title bar, or at the end of the row of tabs that it is in front of.
/// It opens the panel's page of the manual.
class PanelHelp : public QObject {
    Q_OBJECT
public:
    explicit PanelHelp(QMainWindow &window);

    /// @param place  of the manual: "pipeline.md#viewport"
    void add(QDockWidget &dock, const QString &place);
    /// To be called when panels have got title bars or tabs, or lost them.
    void settle();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// The panel whose tab is the current one; the titles of panels differ.
    const QDockWidget *frontOf(const QTabBar &tabs) const;
    void placeInTitle(QDockWidget &dock);
    void placeInTabs(QTabBar &tabs);

    QMainWindow &m_window;
    QMap<const QDockWidget *, QString> m_places;
};

} // namespace unprojector::gui
