#pragma once

#include "gui/parameters/parameter_group.h"

namespace unprojector::gui {

/// The nine arguments of gluLookAt.
class ViewGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ViewGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    void setDefaults(scene::Scene &scene) const override;

private:
    enum class Sliders { Yes, No };
    void addPoint(const QString &title, const QString &name, const QString &objectName, const QString &unit,
                  const QString &help, Sliders sliders,
                  const std::function<double *(geometry::LookAt &, int)> &component);

    /// One coordinate of the eye or of the centre.
    struct Slide {
        NumberSlider *slider;
        int axis;
    };
    void rangeSliders();

    QList<NumberField *> m_lengths;
    std::vector<Slide> m_slides;
    double m_step = 0.0;
    geometry::WorldPoint m_slidesMiddle{0.0, 0.0, 0.0};
    double m_slidesReach = 0.0;
};

} // namespace unprojector::gui
