#pragma once

#include "core/scene_code/scene_code.h"

#include <QDialog>

class QLabel;
class QPlainTextEdit;

namespace unprojector::gui {

class SceneDocument;
class SegmentedSwitch;
class Session;

/// The scene as source code, as it is now, to be read, copied and saved. Hidden, it does nothing; shown again, it catches up.
class SceneCodeWindow : public QDialog {
    Q_OBJECT
public:
    SceneCodeWindow(const SceneDocument &document, const Session &session, QWidget *parent = nullptr);

    scene_code::CodeDialect dialect() const;
    void setDialect(scene_code::CodeDialect dialect);
    QString code() const;

    /// Writes the code to a file.
    /// @return what went wrong, in words; empty where nothing did
    QString exportTo(const std::filesystem::path &file);

protected:
    void showEvent(QShowEvent *event) override;

private:
    void refresh();
    void copy() const;
    void save();

    const SceneDocument &m_document;
    const Session &m_session;
    SegmentedSwitch *m_dialects;
    QPlainTextEdit *m_text;
    QLabel *m_said; ///< that the code is saved
};

} // namespace unprojector::gui
