#pragma once

#include "core/pipeline/pipeline.h"
#include "gui/document/kept_pick.h"

#include <QString>
#include <QWidget>

#include <array>
#include <functional>
#include <optional>

class QLabel;
class QStackedLayout;
class QToolButton;

namespace unprojector::gui {

/// A pick in every space, in one line: pixel › window › NDC › clip › eye › world › object. A click
/// on a space requests the matrix that leads there. All values are from the moment of the click;
/// the line reports if the view has changed since.
class PickStrip : public QWidget {
    Q_OBJECT
public:
    explicit PickStrip(QWidget *parent = nullptr);

    /// @param point        the picked point; nothing on the background
    /// @param uncertainty  of the point
    void setPick(const KeptPick &kept, const std::optional<geometry::WorldPoint> &point,
                 const geometry::WorldVector &uncertainty);

    /// Sets whether the current numbers differ from the click's; then shows a label for it.
    void setStale(bool isStale);

    QSize minimumSizeHint() const override { return {0, sizeHint().height()}; }

signals:
    void stageRequested(unprojector::pipeline::PipelineStage stage);

protected:
    void resizeEvent(QResizeEvent *event) override;

private:
    enum Space { Pixel, Window, Ndc, Clip, Eye, World, Object, SpaceCount };

    void showTexts();

    QStackedLayout *m_pages;
    QWidget *m_spaces;
    QLabel *m_atClick; ///< shown while the current numbers differ
    QString m_names[SpaceCount];
    std::array<QToolButton *, SpaceCount> m_buttons;
    /// Returns a coordinate with at most so many significant digits; empty before the first pick.
    std::array<std::function<QString(int digits)>, SpaceCount> m_texts;
};

} // namespace unprojector::gui
