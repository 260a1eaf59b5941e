#pragma once

#include <QObject>
#include <QTextObjectInterface>

class QWidget;

namespace unprojector::gui {

/// Draws the figures of Help where the page has an image of that name, <img src="figure:frustum" alt="…">. They are drawn
/// with the page and not stored as pictures, in its size and colours as they are at the moment.
class FigureObject : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    /// @param page  whose palette is used; outlives this
    explicit FigureObject(const QWidget &page);

    QSizeF intrinsicSize(QTextDocument *text, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *text, int position,
                    const QTextFormat &format) override;

private:
    const QWidget &m_page;
};

} // namespace unprojector::gui
