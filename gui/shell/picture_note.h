#pragma once

#include <QLabel>

namespace unprojector::gui {

class SceneDocument;

/// The reason why the view is empty or incomplete although its numbers are valid. All objects are
/// hidden, the viewport lies outside the window, or no object lies between near and far. Or far /
/// near is so large that the depth buffer takes surfaces for background.
/// @return empty if there is no such reason
QString emptyPictureText(const SceneDocument &document);

/// Shows that reason over the view, transparent for the mouse.
class PictureNote : public QLabel {
    Q_OBJECT
public:
    /// @param document  outlives the note
    explicit PictureNote(const SceneDocument &document, QWidget *parent = nullptr);

    /// Wide enough for short lines.
    QSize sizeHint() const override;
    /// A small view can stay small.
    QSize minimumSizeHint() const override { return {1, 1}; }

private:
    void refresh();

    const SceneDocument &m_document;
};

} // namespace unprojector::gui
