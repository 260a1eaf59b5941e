#pragma once

#include "gui/panels/parameters/parameter_tab.h"

namespace unprojector::gui {

/// The nine arguments of gluLookAt.
class ViewTab : public ParameterTab {
    Q_OBJECT
public:
    explicit ViewTab(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    Check edit(const Scene &next, const Deed &deed) override;

private:
    void addPoint(const QString &title, const QString &name, const QString &objectName, const QString &help,
                  std::function<double *(LookAt &, int)> component);

    std::vector<NumberField *> m_lengths;
    double m_step = 0.0;
};

} // namespace unprojector::gui
