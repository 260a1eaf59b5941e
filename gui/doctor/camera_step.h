#pragma once

#include "core/geometry/setup.h"
#include "core/scene/scene.h"

#include <QWidget>

#include <optional>

class QLabel;
class QLineEdit;
class QPushButton;

namespace unprojector::gui {

/// The doctor's first step: the camera that counts, the setup that the pixels belong to, and the
/// sizes that the program uses.
class CameraStep : public QWidget {
    Q_OBJECT
public:
    explicit CameraStep(QWidget *parent = nullptr);

    /// The size of the program's window, if it is not the view's.
    std::optional<geometry::Surface> window() const;
    /// Another size that the program may use by mistake.
    std::optional<geometry::Surface> otherSize() const;

    /// Says which camera counts: the scene's own, one given as matrices, or that of an earlier view.
    /// @param setup  that counts
    void showCamera(const scene::Scene &scene, const geometry::Setup &setup, bool isPast);
    /// Says which setup the pixels belong to.
    /// @param own   of the points; none: the scene cannot be drawn in the program's window
    /// @param now   of the present scene in the program's window
    /// @param view  size of the view
    void showSetup(const std::optional<geometry::Setup> &own, const std::optional<geometry::Setup> &now,
                   const geometry::Surface &view);
    /// Says why a click was not used, until the next showSetup.
    void showUnused(const QString &why);

signals:
    /// Emitted when another camera should be pasted.
    void pasteWanted();
    /// Emitted when the pixels should belong to the current view.
    void currentViewWanted();
    /// Emitted when the size of the program's window was entered. @param isNew  it is another text
    void windowEntered(bool isNew);
    void otherSizeEntered();

private:
    QWidget *createSizes();

    QLabel *m_camera;
    QPushButton *m_paste;
    QLabel *m_setup;
    QPushButton *m_currentView;
    QLineEdit *m_window;
    QLineEdit *m_otherSize;
    QLabel *m_fault;
};

} // namespace unprojector::gui
