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

/// Asks for the size of the view, in logical or in device pixels with the pixel ratio between them,
/// and saves it in the scene. A size larger than the available room is drawn in full and shown
/// scaled down.
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
    /// Sets all fields to a size.
    void setSize(const geometry::Surface &surface);
    /// Handles typed logical pixels or a typed ratio.
    void takeLogical();
    /// Handles typed device pixels: rounds to a whole number of logical ones.
    void takeDevice();
    void refresh();

    SceneDocument &m_document;
    const SceneView &m_view;
    std::array<QSpinBox *, 2> m_logical; ///< width, height
    std::array<QSpinBox *, 2> m_device;
    QDoubleSpinBox *m_ratio;
    QLabel *m_note;
    bool m_isRounded = false; ///< the typed size is impossible, and the user may not have seen the rounded one yet
};

/// Makes the view's size follow the window again.
void fitWindow(SceneDocument &document);

} // namespace unprojector::gui
