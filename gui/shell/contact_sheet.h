#pragma once

#include <QImage>
#include <QString>

#include <vector>

namespace unprojector::gui {

/// Many images on one, in a grid, each with a text below it.
class ContactSheet {
public:
    /// @param images  size of the images; each tile has their proportions
    /// @param most    most size of a tile on the sheet, pixels
    ContactSheet(const QSize &images, const QSize &most) : m_tile(images.scaled(most, Qt::KeepAspectRatio)) {}

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
