#pragma once

#include "core/scene_code/scene_code.h"

#include <QDialog>

class QLabel;

namespace unprojector::gui {

class PlainTextBox;
class SceneDocument;
class SegmentedSwitch;
class Session;

/// The present scene as source code, to be read, copied and saved. It does nothing while hidden and
/// catches up when shown.
class SceneCodeWindow : public QDialog {
    Q_OBJECT
public:
    SceneCodeWindow(const SceneDocument &document, const Session &session, QWidget *parent = nullptr);

    scene_code::CodeDialect dialect() const;
    void setDialect(scene_code::CodeDialect dialect);
    QString code() const;

    /// Writes the code to a file.
    /// @return the error in words; empty on success
    QString exportTo(const std::filesystem::path &file);

signals:
    /// Emitted when the user chooses a dialect.
    void dialectChosen(unprojector::scene_code::CodeDialect dialect);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void copy() const;
    void save();

    const SceneDocument &m_document;
    const Session &m_session;
    SegmentedSwitch *m_dialects;
    PlainTextBox *m_text;
    QLabel *m_said; ///< confirms that the code is saved
};

} // namespace unprojector::gui
