#pragma once

#include "core/cameras/foreign_camera.h"
#include "core/cameras/matrix_paste.h"
#include "core/geometry/setup.h"

#include <QDialog>

#include <array>
#include <filesystem>
#include <vector>

class QBoxLayout;
class QHBoxLayout;
class QLabel;
class QPushButton;
class QScrollArea;

namespace unprojector::gui {

class ForeignCameraBox;
class PastedMatrixBox;
class SceneDocument;
class SegmentedSwitch;

/// A dialog that sets the scene's camera from that of another program. It reads projection and view,
/// one of them, or their product, and the texts and files of the programs that core/cameras knows.
/// It shows findings, assumptions and the meaning during typing; OK changes the scene in one step.
class PasteCameraDialog : public QDialog {
    Q_OBJECT
public:
    explicit PasteCameraDialog(SceneDocument &document, QWidget *parent = nullptr);

    /// Sets the text of a matrix, and shows its field.
    void setText(pipeline::MatrixRole role, const QString &text);

    /// Reads the camera in these files, with those read before if only both together are a camera.
    /// A single file that is no known program's is read as matrices.
    void readFiles(const std::vector<std::filesystem::path> &files);

    /// Shows the dialog over a window; it deletes itself.
    static void open(SceneDocument &document, QWidget *parent,
                     pipeline::MatrixRole role = pipeline::MatrixRole::Projection, const QString &text = {});

    void accept() override;

protected:
    void showEvent(QShowEvent *event) override;
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    PastedMatrixBox *box(pipeline::MatrixRole role) const { return m_boxes[std::size_t(role)]; }
    bool isProduct() const;
    QHBoxLayout *createHead();
    void connectBox(pipeline::MatrixRole role);
    void askForFiles();
    /// These texts, and the earlier files if only both together are a camera (COLMAP).
    std::vector<cameras::NamedText> withEarlier(std::vector<cameras::NamedText> texts) const;
    /// Reads the typed texts again instead of the files.
    void dropFiles();
    /// The texts in which another program's camera may be: the files, else the typed ones.
    std::vector<cameras::NamedText> cameraTexts() const;
    /// Reads these texts as another program's camera.
    void readForeign();
    /// Returns whether the camera is that of a known program, not of matrices.
    bool isForeign() const;
    void repair(pipeline::MatrixRole role, const pipeline::MatrixFinding &finding);
    /// Moves a text to the field that its names indicate, see MatrixPaste::namedRole.
    void moveText(pipeline::MatrixRole role);
    /// Updates all fields.
    void refresh();
    /// Grows to show all content, as far as the screen allows.
    void growToContent();
    /// The camera that OK would apply.
    cameras::MatrixPaste::Camera camera() const;
    /// Says that near and far hide all objects; empty if they don't.
    QString emptyText(const geometry::Setup &setup) const;
    /// Describes the camera, or why it cannot be used.
    QString meaning(const cameras::MatrixPaste::Camera &camera, bool &isUsable) const;
    /// The size that the view gets from the camera's image.
    std::optional<geometry::Surface> viewSize() const;

    SceneDocument &m_document;
    cameras::MatrixPaste m_paste;
    std::vector<cameras::NamedText> m_files; ///< instead of typed texts
    SegmentedSwitch *m_kind;
    QLabel *m_fileNames;
    QPushButton *m_dropsFiles;
    ForeignCameraBox *m_foreign;
    std::array<PastedMatrixBox *, 3> m_boxes{};
    QScrollArea *m_scrolled;
    QBoxLayout *m_texts; ///< matrices side by side, or a camera's texts above each other
    QLabel *m_meaning;
    QPushButton *m_ok;
};

} // namespace unprojector::gui
