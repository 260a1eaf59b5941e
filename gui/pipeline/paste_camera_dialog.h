#pragma once

#include "core/cameras/pasted_camera.h"
#include "gui/document/scene_edits.h"

#include <QDialog>

#include <filesystem>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QTextBrowser;
class QUrl;

namespace unprojector::gui {

class PasteChoicesForm;
class PlainTextBox;
class SceneDocument;

/// A dialog that sets the scene's camera from a text or files of another program. It reports how
/// they are read and what they mean during typing, and the scene shows the camera meanwhile; OK
/// changes the scene in one step.
class PasteCameraDialog : public QDialog {
    Q_OBJECT
public:
    explicit PasteCameraDialog(SceneDocument &document, QWidget *parent = nullptr);

    /// Replaces the text in the field.
    void setText(const QString &text);
    /// Reads the camera in these files, with those read before if only both together are a camera.
    void readFiles(const std::vector<std::filesystem::path> &files);

    /// Shows the dialog over a window; it deletes itself.
    static void open(SceneDocument &document, QWidget *parent, const QString &text);
    /// The same with the files or the text of the clipboard, if the text is a camera.
    static void open(SceneDocument &document, QWidget *parent);

    void accept() override;
    void done(int result) override;

protected:
    void dragEnterEvent(QDragEnterEvent *event) override;
    void dropEvent(QDropEvent *event) override;

private:
    QHBoxLayout *createHead();
    void placeBeside(const QWidget *parent);
    void askForFiles();
    /// These texts, and the earlier ones if only both together are a camera (COLMAP).
    std::vector<cameras::NamedText> withEarlier(std::vector<cameras::NamedText> texts) const;
    /// Reads other texts.
    void take(std::vector<cameras::NamedText> texts);
    /// Reads the texts with the choices, shows the camera in the scene, and reports.
    void refresh();
    void showReport(const QString &fault, bool isShown);
    /// Says why a text or file is not taken; the camera stays.
    void refuse(const QString &reason);
    void follow(const QUrl &link);
    /// The camera that OK would set.
    GivenCamera given() const;

    SceneDocument &m_document;
    std::vector<cameras::NamedText> m_texts; ///< without a name: typed
    QString m_refusal;                       ///< during refuse(): its reason
    std::vector<cameras::Correction> m_corrections;
    cameras::PastedCamera m_camera;
    PlainTextBox *m_text;
    QLabel *m_fileNames;
    QPushButton *m_dropsFiles;
    QTextBrowser *m_report;
    PasteChoicesForm *m_form;
    QPushButton *m_ok;
};

} // namespace unprojector::gui
