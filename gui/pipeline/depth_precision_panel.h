#pragma once

#include "core/unproject/depth_precision.h"

#include <QWidget>

class QBoxLayout;

namespace unprojector::gui {

class DepthPrecisionPlot;
class HelpLink;
class SceneDocument;
class SteadyLabel;

/// What the depth buffer leaves open at every distance for this near, far and format, with the clicked point; and what a farther
/// near plane, or floats with the depth 1 at near, would make of it. Hidden, it does nothing; shown again, it catches up.
class DepthPrecisionPanel : public QWidget {
    Q_OBJECT
public:
    explicit DepthPrecisionPanel(const SceneDocument &document, QWidget *parent = nullptr);

    QSize minimumSizeHint() const override;

protected:
    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void changeEvent(QEvent *event) override;

private:
    void refresh();
    /// The words beside the plot where there is room, else below it.
    void arrange();

    const SceneDocument &m_document;
    QBoxLayout *m_layout;
    DepthPrecisionPlot *m_plot;
    SteadyLabel *m_words;
    HelpLink *m_help;
};

} // namespace unprojector::gui
