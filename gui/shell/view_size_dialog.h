#pragma once

#include "core/geometry/viewport.h"

#include <QDialog>

#include <array>

class QDoubleSpinBox;
class QHBoxLayout;
class QLabel;
class QSpinBox;

namespace unprojector::gui {

class SceneDocument;
class SceneView;

/// Asks for the size of the view, in logical or in device pixels with the pixel ratio between them, and keeps it in the scene. What
/// is larger than the view's room is drawn at that size and shown smaller.
class ViewSizeDialog : public QDialog {
    Q_OBJECT
public:
    /// @param document, view  outlive the dialog
    ViewSizeDialog(SceneDocument &document, const SceneView &view, QWidget *parent = nullptr);

    void accept() override;

private:
    QSpinBox *addNumber(QHBoxLayout &row, const QString &name, const QString &tip, const char *objectName);
    /// The size in the fields.
    geometry::Surface typed() const;
    /// Shows a size in all fields.
    void setSize(const geometry::Surface &surface);
    /// The user has typed logical pixels or the ratio.
    void takeLogical();
    /// The user has typed device pixels: those of the nearest whole number of logical ones.
    void takeDevice();
    void refresh();

    SceneDocument &m_document;
    const SceneView &m_view;
    std::array<QSpinBox *, 2> m_logical; ///< width, height
    std::array<QSpinBox *, 2> m_device;
    QDoubleSpinBox *m_ratio;
    QLabel *m_note;
    bool m_isRounded = false; ///< what was typed cannot be had, and the user may not have seen yet what can
};

/// The view's size follows the window again.
void fitWindow(SceneDocument &document);

} // namespace unprojector::gui
