#pragma once

#include <QObject>
#include <QSize>
#include <QTimer>

#include <optional>

namespace unprojector::gui {

class Window;

/// Gives the view the size that the numbers of a lesson's step need: panels beside it shrink. Only
/// for a link that asks for a size the window grows; a message reports if that is not enough.
class ViewResizer : public QObject {
    Q_OBJECT
public:
    ViewResizer(Window &window, QObject *parent);

    /// @param size        device pixels; invalid: as large as the window allows
    /// @param isAskedFor  by a link
    void want(const QSize &size, bool isAskedFor);
    /// Tries again, after panels were hidden or shown.
    void wantAgain() { want(m_size, m_isAskedFor); }
    /// Returns whether the view has reached its final size.
    bool isSettled() const { return !m_timer.isActive(); }
    /// Restores the former size of a window that has grown, unless the user has resized it
    /// meanwhile.
    void shrinkBack();

private:
    void fit();
    /// Shows a message if the view's size differs from the size in the link.
    /// @param isFitted  true if the view has the nearest size in whole logical pixels
    void tell(bool isFitted);

    /// The sizes of the window before and after a link has enlarged it.
    struct Grown {
        QSize before;
        QSize given; ///< the resulting size; invalid: not known yet
    };

    Window &m_window;
    QSize m_size;
    bool m_isAskedFor = false;
    QTimer m_timer; ///< until the size is checked again
    int m_trials = 0;
    std::optional<Grown> m_grown;
};

} // namespace unprojector::gui
