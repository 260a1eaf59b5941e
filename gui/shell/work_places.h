#pragma once

#include <QKeySequence>
#include <QList>
#include <QMap>
#include <QObject>
#include <QSize>

#include <vector>

class QAction;
class QActionGroup;
class QDockWidget;
class QMainWindow;
class QSettings;

namespace unprojector::gui {

/// The panels around the view, and the work places: which of them are there while one does one kind of work.
///
/// Each place remembers how it was left: what is shown, where it stands and how large it is. A window that gets smaller and
/// then larger again has its old sizes back.
class WorkPlaces : public QObject {
    Q_OBJECT
public:
    struct Panel {
        const char *id; ///< by which layouts are kept
        QString title;
        QWidget *widget;
        /// In a window that is wide and high enough; else all stand on the right. Those of one area are tabs of one dock.
        Qt::DockWidgetArea area;
        QKeySequence key;            ///< shows and hides it
        bool standsAlone = false;    ///< never a tab of another: it is read while something is done there
        QDockWidget *dock = nullptr; ///< made here
    };
    struct Place {
        const char *id;
        QString title;
        QString tip;
        QKeySequence key;
        QList<const char *> panels; ///< shown at first, those in front first
        QAction *action = nullptr;  ///< made here: goes there
    };
    WorkPlaces(QMainWindow &window, std::vector<Panel> panels, std::vector<Place> places);

    const std::vector<Panel> &panels() const { return m_panels; }
    const std::vector<Place> &places() const { return m_places; }
    QDockWidget *dock(const char *panel) const;
    /// Whether a dock stands in the window, in front where others share its place: it is seen.
    bool isFront(const QDockWidget &dock) const;
    /// The id of the place one is at.
    const char *current() const { return m_places[m_current].id; }
    /// Goes to a place and leaves the one before as it is. A panel that has no place there is not shown.
    void enter(const char *place);
    /// Shows a panel here, in front.
    void show(const char *panel);

    /// The current place as it is at first, in the size that the window has now.
    void reset();
    bool arePanelsHidden() const { return m_arePanelsHidden; }
    /// Gives the view the whole window, or the panels back.
    void hidePanels(bool isHidden);

    /// How much of the window the panels leave to the view where they can become so small, logical pixels; what the user gave
    /// them is not forgotten. Nothing: as they are.
    void setLeastForView(const QSize &size);
    /// To be called when the window has got another size, its layout included.
    void windowResized();
    /// @return whether there was something kept that fits this window
    bool restore(const QSettings &settings);
    void keep(QSettings &settings);

signals:
    /// The panels are where they are at first in a place, or where they were when it was left. Whether those that stand
    /// alone are shown is not the place's to say: now is the time to show or hide them.
    void laidOut();
    /// The user closed this panel by the button of its frame or by its key.
    void closed(const char *panel);
    void panelsHidden(bool isHidden);
    /// A panel has got a title bar, which closes it, or has lost it to a tab, which does not.
    void titled(const char *panel, bool hasTitleBar);

protected:
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    /// Of the areas around the view: widths on the left and right, heights above and below, logical pixels.
    using Sizes = QMap<Qt::DockWidgetArea, int>;

    void arrange();
    void leave();
    Sizes firstSizes(bool isWide) const;
    /// Of the areas where a panel is seen, as they are now.
    Sizes sizesNow() const;
    void applySizes();
    /// Title bars and sizes after panels came, went or were put elsewhere.
    void settle();
    void setTitleBars();

    QMainWindow &m_window;
    std::vector<Panel> m_panels;
    std::vector<Place> m_places;
    std::size_t m_current = 0;
    QMap<QByteArray, QByteArray> m_layouts; ///< of the places that were left, by their id
    QMap<QByteArray, Sizes> m_wanted;       ///< of each place, as the user made them in whatever window
    QSize m_leastForView;
    Sizes m_pressed; ///< when the mouse was pressed, perhaps onto a separator
    bool m_isArranged = false;
    bool m_arePanelsHidden = false;
    QByteArray m_layoutWithPanels;
};

} // namespace unprojector::gui
