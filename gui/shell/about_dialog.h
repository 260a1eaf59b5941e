#pragma once

#include <QDialog>

namespace unprojector::gui {

/// A dialog with the program's name and version and its platform, in lines that can be copied into
/// a report.
class AboutDialog : public QDialog {
    Q_OBJECT
public:
    /// @param openGL  version and renderer, as OpenGL names them; empty before there is a view
    /// @param note  a peculiarity of this machine, or empty
    AboutDialog(const QString &openGL, const QString &note, QWidget *parent);

    /// The text that Copy copies.
    QString versions() const { return m_versions; }

private:
    QString m_versions;
};

} // namespace unprojector::gui
