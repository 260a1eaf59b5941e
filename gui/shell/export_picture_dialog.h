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

/// Asks for the size of a picture of the view and for what it shows. At first as the view is.
class ExportPictureDialog : public QDialog {
    Q_OBJECT
public:
    explicit ExportPictureDialog(const SceneView &view, QWidget *parent = nullptr);

    PictureOptions options() const;
    /// Why there is no such picture and what to do; empty where there is one.
    QString problem() const;

private:
    void addSize(QFormLayout &form);
    void addMarks(QVBoxLayout &layout, bool hasMap);
    /// Changes the other side and the pixel ratio with one side, where the proportions are kept.
    void followSide(const QSpinBox &changed, QSpinBox &other, int changedOfView, int otherOfView);
    void showProblem();

    geometry::Surface m_view; ///< the view's own size
    int m_largest;            ///< side that OpenGL draws here, pixels
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

/// Draws a picture and writes it as PNG.
/// @return what went wrong, in words; empty where nothing did
QString writePicture(SceneView &view, const PictureOptions &options, const std::filesystem::path &file);

/// Asks for a picture and for its file, and writes it.
void exportPicture(Window &window);

} // namespace unprojector::gui
