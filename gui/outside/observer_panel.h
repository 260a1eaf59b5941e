#pragma once

#include <QWidget>

class QLabel;
class QPushButton;
class QSlider;
class QToolButton;
class QVariantAnimation;

namespace unprojector::gui {

class HelpLink;
class ObserverView;
class SceneDocument;

/// The view from outside with its tools: the slider that morphs it into the canonical view volume,
/// and a legend.
class ObserverPanel : public QWidget {
    Q_OBJECT
public:
    explicit ObserverPanel(SceneDocument &document, QWidget *parent = nullptr);

    ObserverView &view() { return *m_view; }
    /// Makes it small for use over another view: the legend needs a dock.
    void setIsInset(bool isInset);

signals:
    void dockRequested(bool isDocked);
    void closeRequested();

protected:
    void hideEvent(QHideEvent *event) override;

private:
    void showMorph(double t);
    void showDistances();
    void animate();
    void showAnimating(bool isAnimating);

    SceneDocument &m_document;
    ObserverView *m_view;
    QSlider *m_slider;
    QLabel *m_percent;
    QPushButton *m_animate;
    QVariantAnimation *m_animation;
    QLabel *m_nearDistance;
    QLabel *m_farDistance;
    QLabel *m_ray;
    QWidget *m_legend;
    HelpLink *m_help;
    QToolButton *m_toDock;
    QToolButton *m_close;
    QPushButton *m_outOfSight; ///< over the view
};

} // namespace unprojector::gui
