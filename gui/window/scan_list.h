#pragma once

#include <QString>

#include <cstddef>
#include <filesystem>

namespace unprojector::gui {

/// The window's interface to a series of scans: what the start of the program needs, with a user or
/// without one.
class ScanList {
public:
    /// A scan, in words.
    struct Report {
        QString name;     ///< of its file
        QString problem;  ///< why it or its landmarks could not be read; empty: no error
        QString progress; ///< "9 of 10"
    };

    ScanList() = default;
    virtual ~ScanList() = default;
    ScanList(const ScanList &) = delete;
    ScanList &operator=(const ScanList &) = delete;

    /// Opens a folder of scans and shows the first that lacks a landmark.
    /// @return false after a message with the reason
    virtual bool open(const std::filesystem::path &folder) = 0;
    /// Opens a folder only to look at its scans: changes no file.
    /// @param problem  gets what could not be read
    /// @return false if there is no scan
    virtual bool openReadOnly(const std::filesystem::path &folder, QString &problem) = 0;
    virtual std::size_t count() const = 0;
    /// @pre index < count()
    virtual void show(std::size_t index) = 0;
    /// @pre index < count()
    virtual Report report(std::size_t index) const = 0;
};

} // namespace unprojector::gui
