#pragma once

#include "core/unproject/depth_precision.h"

#include <QWidget>

class QBoxLayout;

namespace unprojector::gui {

class DepthPrecisionPlot;
class HelpLink;
class SceneDocument;
class SteadyLabel;

/// The depth buffer's uncertainty at every distance for this near, far and format, with the clicked
/// point. For comparison it shows a farther near plane and reversed float depths (1 at near). It
/// does nothing while hidden and catches up when shown.
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
    /// Puts the words beside the plot if there is room, else below it.
    void arrange();

    const SceneDocument &m_document;
    QBoxLayout *m_layout;
    DepthPrecisionPlot *m_plot;
    SteadyLabel *m_words;
    HelpLink *m_help;
};

} // namespace unprojector::gui
