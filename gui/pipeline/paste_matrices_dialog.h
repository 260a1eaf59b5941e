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

/// Takes the scene's camera from matrices of another program, pasted as text: projection and view, one of them, or their
/// product. Says as they are typed what is to be seen of them and what they mean; the scene changes with OK, in one step.
class PasteMatricesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PasteMatricesDialog(SceneDocument &document, QWidget *parent = nullptr);

    /// Puts a text into the place of a matrix, and shows that place.
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
    /// Puts a text where it belongs by its names, see MatrixPaste::namedRole.
    void moveText(matrices::MatrixRole role);
    /// Shows everything as it is now.
    void refresh();
    /// As high as shows all of it, as far as the screen allows.
    void growToContent();
    /// What OK would take.
    matrices::MatrixPaste::Camera camera() const;
    /// What the camera means, or why it cannot be taken.
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
