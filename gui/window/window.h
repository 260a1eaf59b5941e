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

/// The window as its features know it: what all of them share.
class Window : public QMainWindow {
    Q_OBJECT
public:
    using QMainWindow::QMainWindow;

    virtual SceneDocument &document() = 0;
    virtual Session &session() = 0;
    virtual SceneView &view() = 0;
    /// The view with what stands over it.
    virtual ViewFrame &frame() = 0;
    /// @pre all features are made
    virtual Workspaces &workspaces() = 0;
    /// Whether choices of the user last from one start to the next: not where the window is only made for a picture.
    virtual bool remembers() const = 0;

    /// Shows a message over the view, until the user closes it.
    virtual void showMessage(const QString &text) = 0;
    /// The same of what could not be done, which fails a run that nobody looks at.
    virtual void showFailure(const QString &reason) = 0;
    /// Shows in the status bar for a moment what needs no answer.
    virtual void notice(const QString &text) = 0;
    /// Whether an export may go to a file; where it may not, a message gives the reason.
    virtual bool mayExportTo(const std::filesystem::path &file) = 0;

    /// Lets the feature that a link belongs to follow it.
    virtual void follow(const lessons::Link &link) = 0;
    /// Another step of a lesson, or none (null): the view and features show what it speaks of.
    virtual void showStep(const lessons::Step *step) = 0;
    /// Whether edges are drawn without steps.
    virtual bool hasSmoothEdges() const = 0;

    /// Everything that a lesson may change around the view.
    struct State {
        Workspaces::Layout layout;
        std::vector<QVariantMap> features;
    };
    virtual State state() = 0;
    virtual void restore(const State &state) = 0;

signals:
    /// The pointer is over a pixel of the view, or over none.
    void pointed(const std::optional<unprojector::unproject::PixelClick> &click);
    /// The pointer is over a term of the pick's formulas, or over none (empty): the views mark its quantity.
    void termPointed(const QString &term);
    /// The pointer is over a quantity in a view, or over none (empty): the formulas mark its term.
    void quantityPointed(const QString &term);
    /// The pipeline shall show the values at the click.
    void clickValuesWanted();
    void smoothEdgesChanged(bool isSmooth);
    /// The window closes for good, and is about to keep its layout.
    void closing();
    /// Whether the world coordinate under the pointer would give away the answer to a lesson's question.
    void coordinatesHidden(bool areHidden);
    /// See showStep.
    void stepShown(const unprojector::lessons::Step *step);
};

} // namespace unprojector::gui
