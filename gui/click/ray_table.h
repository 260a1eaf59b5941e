#pragma once

#include "gui/click/coordinates_table.h"

namespace unprojector::gui {

class RayModel;

/// The table of what a click's ray meets.
class RayTable : public CoordinatesTable {
    Q_OBJECT
public:
    explicit RayTable(RayModel *model, QWidget *parent = nullptr);

protected:
    void shareWidth(int available) override;
    int leastWidth() const override;

private:
    int leastWidthOf(int column) const;

    RayModel *m_model;
};

} // namespace unprojector::gui
