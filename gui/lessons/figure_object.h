#pragma once

#include <QObject>
#include <QTextObjectInterface>

class QWidget;

namespace unprojector::gui {

/// Draws a figure of the help for an image of that name in the page, <img src="figure:frustum"
/// alt="…">. It is drawn with the page and not stored as an image, in the page's present size and
/// colours.
class FigureObject : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)
public:
    /// @param page  supplies the palette; outlives this
    explicit FigureObject(const QWidget &page);

    QSizeF intrinsicSize(QTextDocument *text, int position, const QTextFormat &format) override;
    void drawObject(QPainter *painter, const QRectF &rect, QTextDocument *text, int position,
                    const QTextFormat &format) override;

private:
    const QWidget &m_page;
};

} // namespace unprojector::gui
