#pragma once

#include "gui/shell/contact_sheet.h"
#include "gui/shell/main_window.h"
#include "gui/shell/start_options.h"

#include <QObject>
#include <QString>

#include <cstddef>
#include <filesystem>
#include <memory>

namespace unprojector::gui {

/// Runs the program without a user: writes an image of each scan of a series with its landmarks,
/// and a contact sheet of all scans for checking. Changes no file of the series.
class SeriesPictures : public QObject {
    Q_OBJECT
public:
    /// @param options  with a series and a folder for the images
    explicit SeriesPictures(StartOptions options);
    ~SeriesPictures() override;

    /// Starts; `ended` follows with the exit code: 0; 1 if a scan could not be read; 2 after a
    /// message on stderr, if the images could not be written.
    void start();

signals:
    void ended(int exitCode);

private:
    /// Shows the next scan, or writes the contact sheet after the last one.
    void showNext();
    /// Called once a scan is shown or could not be read.
    void take();
    /// @return the error in words; empty on success
    QString write(const QImage &picture, const QString &name) const;
    void fail(const QString &reason);
    void finish();

    StartOptions m_options;
    std::filesystem::path m_folder; ///< of the images
    std::unique_ptr<MainWindow> m_window;
    ContactSheet m_sheet;
    std::size_t m_next = 0; ///< index of the scan to show next
    int m_bad = 0;          ///< number of scans that could not be read
    bool m_hasEnded = false;
};

} // namespace unprojector::gui
