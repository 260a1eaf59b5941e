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
    void addPoint(const QString &title, const QString &name, const QString &objectName, const QString &unit,
                  const QString &help, const std::function<double *(geometry::LookAt &, int)> &component);

    QList<NumberField *> m_lengths;
    double m_step = 0.0;
};

} // namespace unprojector::gui
