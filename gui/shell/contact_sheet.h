#pragma once

#include <QImage>
#include <QString>

#include <vector>

namespace unprojector::gui {

/// Many images on one, in a grid, each with a text below it.
class ContactSheet {
public:
    /// @param tile  size of an image on the sheet, pixels
    explicit ContactSheet(const QSize &tile) : m_tile(tile) {}

    void add(const QImage &picture, const QString &text);
    /// Adds a reason in place of an image.
    void addProblem(const QString &reason, const QString &text);
    QImage image() const;

private:
    struct Entry {
        QImage picture; ///< null: the problem is written instead
        QString problem, text;
    };
    QSize m_tile;
    std::vector<Entry> m_entries;
};

} // namespace unprojector::gui
