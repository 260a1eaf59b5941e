#pragma once

#include <QDialog>

namespace unprojector::gui {

/// What the program is, and what it runs on, in lines that can be copied into a report.
class AboutDialog : public QDialog {
    Q_OBJECT
public:
    /// @param openGL  version and renderer, as OpenGL names them; empty before there is a view
    /// @param note  what is special on this machine, or nothing
    AboutDialog(const QString &openGL, const QString &note, QWidget *parent);

    /// What Copy copies.
    QString versions() const { return m_versions; }

private:
    QString m_versions;
};

} // namespace unprojector::gui
