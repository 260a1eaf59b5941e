#pragma once

#include <QLabel>

namespace unprojector::gui {

class SceneDocument;

/// Why there is nothing to be seen, or not all of it, where the reason is no fault of the picture's numbers: all objects are
/// hidden, the viewport lies outside the window, none lies between near and far, or far is so many times near that the depth buffer takes surfaces for background.
/// @return nothing where there is no such reason
QString emptyPictureText(const SceneDocument &document);

/// Says so over the view, and lets the mouse through.
class PictureNote : public QLabel {
    Q_OBJECT
public:
    /// @param document  outlives the note
    explicit PictureNote(const SceneDocument &document, QWidget *parent = nullptr);

    /// In lines that are read at a glance.
    QSize sizeHint() const override;
    /// A small view stays small.
    QSize minimumSizeHint() const override { return {1, 1}; }

private:
    void refresh();

    const SceneDocument &m_document;
};

} // namespace unprojector::gui
