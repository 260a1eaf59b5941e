#pragma once

#include "core/maps/pixel_map.h"
#include "gui/map/map_colors.h"

#include <QFrame>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace unprojector::gui {

class HelpLink;

/// A logarithmic scale in colours with its numbers below.
class ColorScale : public QWidget {
    Q_OBJECT
public:
    explicit ColorScale(QWidget *parent = nullptr);
    /// @param scale  nothing: there is no map
    void setScale(const std::optional<LogScale> &scale, ColorMap colors);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

    static void paint(QPainter &painter, const QRect &area, const LogScale &scale, ColorMap colors);

protected:
    void paintEvent(QPaintEvent *event) override;

private:
    std::optional<LogScale> m_scale;
    ColorMap m_colors = ColorMap::Viridis;
};

/// The options of the map over the view, its scale, and its number under the pointer.
class MapPanel : public QFrame {
    Q_OBJECT
public:
    explicit MapPanel(QWidget *parent = nullptr);

    maps::Question question() const;
    ColorMap colors() const;
    /// The question in words: "Displacement by MeshLab, world units".
    QString title() const;

    void setScale(const std::optional<LogScale> &scale);
    /// Shows a note on the map, or why there is none.
    void setNote(const QString &text);
    void setValue(const QString &text);
    void setExportable(bool isExportable);

signals:
    void questionChanged();
    void colorsChanged();
    void exportRequested();
    void closeRequested();

private:
    QComboBox *m_quantity, *m_convention, *m_unit, *m_colors;
    ColorScale *m_scale;
    QLabel *m_value, *m_note;
    QPushButton *m_export;
    HelpLink *m_help;
    std::optional<LogScale> m_shown;
};

} // namespace unprojector::gui
