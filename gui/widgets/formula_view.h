#pragma once

#include "gui/text/formula_layout.h"
#include "gui/text/formula_text.h"

#include <QAbstractScrollArea>

#include <vector>

class QMenu;

namespace unprojector::gui {

/// Typeset formulas, each in symbols with its numbers below. A term under the pointer is marked at
/// all its occurrences, and a tooltip names it; other views can mark its quantity. The formulas are
/// laid out to the view's width; the view is as high as they are.
class FormulaView : public QAbstractScrollArea {
    Q_OBJECT
public:
    explicit FormulaView(QWidget *parent = nullptr);

    void setFormulas(PickFormulas formulas);
    const PickFormulas &formulas() const { return m_formulas; }

    /// The short name of the marked term.
    const QString &markedTerm() const { return m_marked; }
    /// Marks the term whose quantity is under the pointer in another view; empty: none.
    void setMarkedTerm(const QString &term);
    /// The rectangles of a term in the viewport.
    std::vector<QRectF> placesOf(const QString &term) const;
    /// The tooltip of a term: "n = 2" and its name.
    QString toolTipOf(const QString &term) const;
    /// The rectangle of a formula's number in the viewport: a link to its place in the help. Empty
    /// if there is no such number.
    QRectF placeOfNumber(const QString &number) const;
    /// The size of all formulas, logical pixels.
    QSizeF contentSize() const { return m_content.size; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    bool hasHeightForWidth() const override { return true; }
    int heightForWidth(int width) const override;

signals:
    /// The pointer is over a term, or over none (empty).
    void termPointed(const QString &term);

protected:
    void paintEvent(QPaintEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    bool viewportEvent(QEvent *event) override;
    void contextMenuEvent(QContextMenuEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;

private:
    struct Line {
        FormulaLayout layout;
        QPointF place; ///< top left in the content
        QString number;
        QRectF numberPlace; ///< in the content; empty if the line has none
    };
    struct Content {
        std::vector<Line> lines;
        QSizeF size;
    };
    /// The formulas wrapped to a width of the viewport, logical pixels.
    Content contentFor(double viewportWidth) const;
    void set();
    QString termAt(const QPoint &position) const;
    const Line *numberAt(const QPoint &position) const;
    void addHelpActions(QMenu &menu, const QPoint &position, bool isOfAll) const;
    /// Marks the term under the pointer.
    void mark(const QString &term);
    void copyAll() const;

    PickFormulas m_formulas;
    Content m_content;
    QString m_marked;
    QString m_pointed; ///< the term under the pointer; setMarkedTerm may mark another one
};

} // namespace unprojector::gui
