#pragma once

#include "gui/view/picture_options.h"

#include <QDialog>
#include <QSize>
#include <QString>

#include <filesystem>

class QCheckBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;
class QSpinBox;
class QVBoxLayout;

namespace unprojector::gui {

class SceneView;
class Window;

/// Asks for the size and the content of an image of the view. The defaults are the view's.
class ExportPictureDialog : public QDialog {
    Q_OBJECT
public:
    explicit ExportPictureDialog(const SceneView &view, QWidget *parent = nullptr);

    PictureOptions options() const;
    /// The reason why there is no such image, and what to do; empty if there is none.
    QString problem() const;

private:
    void addSize(QFormLayout &form);
    void addMarks(QVBoxLayout &layout, bool hasMap);
    /// Adapts the other side and the pixel ratio to one side, if the proportions are kept.
    void followSide(const QSpinBox &changed, QSpinBox &other, int changedOfView, int otherOfView);
    void showProblem();

    geometry::Surface m_view; ///< the view's own size
    int m_largest;            ///< longest side that OpenGL can draw here, pixels
    QSpinBox *m_width;
    QSpinBox *m_height;
    QDoubleSpinBox *m_ratio;
    QCheckBox *m_keepsProportions;
    QCheckBox *m_pick;
    QCheckBox *m_landmarks;
    QCheckBox *m_curves;
    QCheckBox *m_grid;
    QCheckBox *m_axes;
    QCheckBox *m_map;
    QCheckBox *m_isTransparent;
    QLabel *m_problem;
    QPushButton *m_export;
};

/// Draws an image and writes it as PNG.
/// @return the error in words; empty on success
QString writePicture(SceneView &view, const PictureOptions &options, const std::filesystem::path &file);

/// Asks for an image and for its file, and writes it.
void exportPicture(Window &window);

} // namespace unprojector::gui
