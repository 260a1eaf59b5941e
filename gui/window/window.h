#pragma once

#include "core/lessons/lesson.h"
#include "core/unproject/pick.h"
#include "gui/window/workspaces.h"

#include <QMainWindow>
#include <QString>
#include <QVariantMap>

#include <filesystem>
#include <optional>
#include <vector>

namespace unprojector::gui {

class SceneDocument;
class SceneView;
class Session;
class ViewFrame;

/// The window's interface to its features: everything they share.
class Window : public QMainWindow {
    Q_OBJECT
public:
    using QMainWindow::QMainWindow;

    virtual SceneDocument &document() = 0;
    virtual Session &session() = 0;
    virtual SceneView &view() = 0;
    /// The view with the widgets over it.
    virtual ViewFrame &frame() = 0;
    /// @pre all features exist
    virtual Workspaces &workspaces() = 0;
    /// Returns whether choices of the user last from one start to the next: false if the window
    /// only renders an image.
    virtual bool remembers() const = 0;

    /// Shows a message over the view, until the user closes it.
    virtual void showMessage(const QString &text) = 0;
    /// The same for a failure; it also fails an unattended run.
    virtual void showFailure(const QString &reason) = 0;
    /// Shows a message briefly in the status bar; it needs no answer.
    virtual void notice(const QString &text) = 0;
    /// Returns whether an export may write to a file; otherwise a message gives the reason.
    virtual bool mayExportTo(const std::filesystem::path &file) = 0;

    /// Passes a link to the feature that it belongs to.
    virtual void follow(const lessons::Link &link) = 0;
    /// Sets the step of a lesson, or none (null): the view and features show what it refers to.
    virtual void showStep(const lessons::Step *step) = 0;
    /// Returns whether edges are smoothed.
    virtual bool hasSmoothEdges() const = 0;

    /// Everything around the view that a lesson may change.
    struct State {
        Workspaces::Layout layout;
        std::vector<QVariantMap> features;
    };
    virtual State state() = 0;
    virtual void restore(const State &state) = 0;

signals:
    /// Emitted when the pointer is over another pixel of the view, or over none.
    void pointed(const std::optional<unprojector::unproject::PixelClick> &click);
    /// Emitted when the pointer is over another term of the pick's formulas, or over none (empty).
    /// The views mark its quantity.
    void termPointed(const QString &term);
    /// Emitted when the pointer is over another quantity in a view, or over none (empty). The
    /// formulas mark its term.
    void quantityPointed(const QString &term);
    /// Emitted when the pipeline must show the values at the click.
    void clickValuesWanted();
    void smoothEdgesChanged(bool isSmooth);
    /// Emitted when the window closes for good, before it saves its layout.
    void closing();
    /// Emitted when the world coordinate under the pointer must be hidden, because it would reveal
    /// the answer to a lesson's question, or shown again.
    void coordinatesHidden(bool areHidden);
    /// Emitted by showStep.
    void stepShown(const unprojector::lessons::Step *step);
};

} // namespace unprojector::gui
