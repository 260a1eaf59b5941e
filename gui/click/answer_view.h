#pragma once

#include "core/geometry/components.h"

#include <QWidget>

#include <optional>

class QLabel;
class QMenu;
class QToolButton;

namespace unprojector::gui {

class ElidedLabel;

/// The answer of a click in one line: the object, its world coordinate in large digits with the
/// uncertain ones in grey, and ±.
class AnswerView : public QWidget {
    Q_OBJECT
public:
    explicit AnswerView(QWidget *parent = nullptr);

    /// @param heading      names the clicked object
    /// @param point        world units; nothing: there is no point, only a ray
    /// @param uncertainty  of each coordinate
    void setAnswer(const QString &heading, const std::optional<geometry::Components<3>> &point,
                   const geometry::Components<3> &uncertainty);

    const QString &heading() const;
    /// Copies the coordinate with all its digits; without a point everything about the click.
    void copy();
    /// "(x, y, z) ± u" as shown; empty without a point.
    QString text() const { return m_plain; }

signals:
    /// Emitted when the user wants to copy everything about the click.
    void copyAllRequested();

protected:
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;

private:
    void showPoint();
    void fillMenu(QMenu &menu);

    ElidedLabel *m_heading;
    QLabel *m_point;
    QToolButton *m_copy;
    std::optional<geometry::Components<3>> m_at;
    geometry::Components<3> m_uncertainty;
    QString m_plain;
};

} // namespace unprojector::gui
