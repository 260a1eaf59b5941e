#pragma once

#include <QMap>
#include <QObject>
#include <QString>

class QDockWidget;
class QMainWindow;
class QTabBar;

namespace unprojector::gui {

/// The "?" buttons of the panels. A click opens the panel's page of the manual. The button is at
/// the right of the panel's title bar, or at the end of the tab row if the panel is the current
/// tab.
class PanelHelp : public QObject {
    Q_OBJECT
public:
    explicit PanelHelp(QMainWindow &window);

    /// @param place  the address of the page and section in the manual: "pipeline.md#viewport"
    void add(QDockWidget &dock, const QString &place);
    /// Shows, hides and moves all buttons. Call it after panels were docked, floated or tabbed.
    void settle();

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// The panel of the current tab, found by its title; titles are unique.
    const QDockWidget *frontOf(const QTabBar &tabs) const;
    void placeInTitle(QDockWidget &dock);
    void placeInTabs(QTabBar &tabs);

    QMainWindow &m_window;
    QMap<const QDockWidget *, QString> m_places;
};

} // namespace unprojector::gui
