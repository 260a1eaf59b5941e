#pragma once

#include "core/matrices/matrix_paste.h"

#include <QDialog>

#include <array>

class QLabel;
class QPushButton;
class QScrollArea;

namespace unprojector::gui {

class PastedMatrixBox;
class SceneDocument;
class SegmentedSwitch;

/// A dialog that sets the scene's camera from pasted matrices of another program: projection and
/// view, one of them, or their product. Shows findings and the meaning during typing; OK changes
/// the scene in one step.
class PasteCameraDialog : public QDialog {
    Q_OBJECT
public:
    explicit PasteCameraDialog(SceneDocument &document, QWidget *parent = nullptr);

    /// Sets the text of a matrix, and shows its field.
    void setText(matrices::MatrixRole role, const QString &text);

    /// Shows the dialog over a window; it deletes itself.
    static void open(SceneDocument &document, QWidget *parent,
                     matrices::MatrixRole role = matrices::MatrixRole::Projection, const QString &text = {});

    void accept() override;

protected:
    void showEvent(QShowEvent *event) override;

private:
    PastedMatrixBox *box(matrices::MatrixRole role) const { return m_boxes[std::size_t(role)]; }
    bool isProduct() const;
    void repair(matrices::MatrixRole role, const matrices::MatrixFinding &finding);
    /// Moves a text to the field that its names indicate, see MatrixPaste::namedRole.
    void moveText(matrices::MatrixRole role);
    /// Updates all fields.
    void refresh();
    /// Grows to show all content, as far as the screen allows.
    void growToContent();
    /// The camera that OK would apply.
    matrices::MatrixPaste::Camera camera() const;
    /// Describes the camera, or why it cannot be used.
    QString meaning(const matrices::MatrixPaste::Camera &camera, bool &isUsable) const;

    SceneDocument &m_document;
    matrices::MatrixPaste m_paste;
    SegmentedSwitch *m_kind;
    std::array<PastedMatrixBox *, 3> m_boxes{};
    QScrollArea *m_scrolled;
    QLabel *m_meaning;
    QPushButton *m_ok;
};

} // namespace unprojector::gui
