#include "gui/shell/contact_sheet.h"

#include <QFontMetrics>
#include <QGuiApplication>
#include <QPainter>
#include <QTextOption>

#include <cmath>

namespace unprojector::gui {
namespace {

constexpr int kGap = 8;
const QColor kPaper(255, 255, 255), kInk(32, 32, 32), kProblem(160, 24, 24), kEmpty(240, 240, 240);

} // namespace

void ContactSheet::add(const QImage &picture, const QString &text)
{
    m_entries.push_back({picture.scaled(m_tile, Qt::KeepAspectRatio, Qt::SmoothTransformation), {}, text});
}

void ContactSheet::addProblem(const QString &reason, const QString &text)
{
    m_entries.push_back({{}, reason, text});
}

QImage ContactSheet::image() const
{
    const auto count = static_cast<int>(m_entries.size());
    const int columns = std::max(1, static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count)))));
    const int rows = (count + columns - 1) / columns;
    const QFontMetrics metrics(QGuiApplication::font());
    const QSize cell = m_tile + QSize(kGap, kGap + metrics.lineSpacing());
    QImage sheet(columns * cell.width() + kGap, rows * cell.height() + kGap, QImage::Format_RGB32);
    if (sheet.isNull())
        return sheet;
    sheet.fill(kPaper);
    QPainter painter(&sheet);
    painter.setFont(QGuiApplication::font());
    for (int i = 0; i < count; ++i) {
        const Entry &entry = m_entries[static_cast<std::size_t>(i)];
        const QPoint corner(kGap + i % columns * cell.width(), kGap + i / columns * cell.height());
        const QRect tile(corner, m_tile);
        if (entry.picture.isNull()) {
            painter.fillRect(tile, kEmpty);
            painter.setPen(kProblem);
            QTextOption atWords(Qt::AlignCenter);
            atWords.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere); // a file's name may be too long
            painter.drawText(QRectF(tile.adjusted(kGap, kGap, -kGap, -kGap)), entry.problem, atWords);
        } else {
            painter.drawImage(corner
                                  + QPoint((m_tile.width() - entry.picture.width()) / 2,
                                           (m_tile.height() - entry.picture.height()) / 2),
                              entry.picture);
        }
        painter.setPen(entry.picture.isNull() ? kProblem : kInk);
        painter.drawText(QRect(tile.bottomLeft() + QPoint(0, 1), QSize(m_tile.width(), metrics.lineSpacing())),
                         Qt::AlignCenter, metrics.elidedText(entry.text, Qt::ElideMiddle, m_tile.width()));
    }
    return sheet;
}

} // namespace unprojector::gui
