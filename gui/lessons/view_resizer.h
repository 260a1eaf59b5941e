#pragma once

#include <QObject>
#include <QSize>
#include <QTimer>

#include <optional>

namespace unprojector::gui {

class Window;

/// Gives the view the size that the numbers of a lesson's step need: panels beside it make room. Only for a link that asks for a
/// size the window grows; a message says where that does not suffice.
class ViewResizer : public QObject {
    Q_OBJECT
public:
    ViewResizer(Window &window, QObject *parent);

    /// @param size        device pixels; not valid: as large as the window allows
    /// @param isAskedFor  by a link
    void want(const QSize &size, bool isAskedFor);
    /// Tries again, after panels were hidden or shown.
    void wantAgain() { want(m_size, m_isAskedFor); }
    /// The view has the size that it can have.
    bool isSettled() const { return !m_timer.isActive(); }
    /// A window that grew has its former size again, unless the user has given it another one meanwhile.
    void shrinkBack();

private:
    void fit();
    /// Says that a view that a link has asked for has another size.
    /// @param isFitted  as near to it as whole logical pixels are
    void tell(bool isFitted);

    /// Sizes of the window, where a link has made it larger.
    struct Grown {
        QSize before;
        QSize given; ///< what came of it; not valid: not known yet
    };

    Window &m_window;
    QSize m_size;
    bool m_isAskedFor = false;
    QTimer m_timer; ///< until the size is looked at again
    int m_trials = 0;
    std::optional<Grown> m_grown;
};

} // namespace unprojector::gui
