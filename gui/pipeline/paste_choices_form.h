#pragma once

#include "core/cameras/pasted_camera.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLineEdit;

namespace unprojector::gui {

QString axesName(cameras::EyeAxes axes);
QString directionName(cameras::PoseDirection direction);
QString centresName(cameras::PixelCentres centres);

/// The fields in which the user says otherwise about a pasted camera. Only those are visible that
/// its text needs.
class PasteChoicesForm : public QWidget {
    Q_OBJECT
public:
    explicit PasteChoicesForm(QWidget *parent = nullptr);

    /// The choices in the fields.
    cameras::PasteChoices choices() const;
    /// Forgets what is chosen about a text: its image, its matrices.
    void forgetText();
    /// Forgets all choices.
    void forgetAll();
    /// Shows the fields of a camera, read with these choices.
    void showCamera(const cameras::PastedCamera &camera);
    /// Chooses the direction of the pose, as with its field.
    void chooseDirection(cameras::PoseDirection direction);
    /// The reason why a typed text is no size or no distance; empty if all are.
    QString fault() const;
    /// Returns whether the view should get the image's size.
    bool isSizeWanted() const;

signals:
    /// Emitted when the user says otherwise: the text must be read again.
    void choicesChanged();

private:
    void addFields();

    QFormLayout *m_form;
    QComboBox *m_image, *m_role, *m_ndcDepth, *m_axes, *m_direction, *m_centres;
    QWidget *m_sizes, *m_distances;
    QLineEdit *m_size, *m_near, *m_far;
    QCheckBox *m_takesSize, *m_isUndistorted;
};

} // namespace unprojector::gui
