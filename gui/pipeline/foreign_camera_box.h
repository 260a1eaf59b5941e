#pragma once

#include "core/cameras/foreign_camera.h"

#include <QWidget>

#include <cstddef>
#include <optional>
#include <span>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;

namespace unprojector::gui {

/// A camera of another program that is being pasted: what was assumed, and the fields that say
/// otherwise.
class ForeignCameraBox : public QWidget {
    Q_OBJECT
public:
    using Camera = base::Expected<cameras::SceneCamera, base::Error>;

    explicit ForeignCameraBox(QWidget *parent = nullptr);

    /// Reads the camera in these texts with the choices in the fields. Another program's camera
    /// drops the choices.
    /// @param objects  see cameras::sceneCamera
    void read(std::span<const cameras::NamedText> texts, const std::optional<geometry::Box> &objects);
    /// The last camera read; nothing if the texts have no known program's form.
    const std::optional<Camera> &camera() const { return m_camera; }
    /// Returns whether the texts were read. The camera may still be unusable, as without a size.
    bool isRead() const { return m_isRead; }
    /// The reason why the camera cannot be used, with what to do; empty if it can.
    QString fault() const;
    /// Returns whether the view should get the image's size.
    bool isSizeWanted() const;

signals:
    /// Emitted when the user says otherwise: the texts must be read again.
    void choicesChanged();

private:
    void createFields();
    cameras::CameraChoices choices() const;
    void dropChoices();
    void showRead(const cameras::ForeignCamera &camera);
    void showFault();

    QString m_program;
    std::size_t m_textsHash = 0; ///< of the last texts
    std::optional<Camera> m_camera;
    bool m_isRead = false;
    QString m_fault; ///< of a camera that cannot be read
    QFormLayout *m_form;
    QLabel *m_title;
    QComboBox *m_image;
    QLineEdit *m_size;
    QCheckBox *m_takesSize;
    QLineEdit *m_near;
    QLineEdit *m_far;
    QComboBox *m_axes;
    QComboBox *m_direction;
    QComboBox *m_centres;
    QCheckBox *m_isUndistorted;
    QLabel *m_said;
};

} // namespace unprojector::gui
