#pragma once

#include "gui/click/coordinates_table.h"

namespace unprojector::gui {

class ComparisonModel;

/// The table of a pick by both methods.
class ComparisonTable : public CoordinatesTable {
    Q_OBJECT
public:
    explicit ComparisonTable(ComparisonModel *model, QWidget *parent = nullptr);

    bool showsFloat() const;
    void setShowsFloat(bool shows);

protected:
    void shareWidth(int available) override;
    int leastWidth() const override;

private:
    ComparisonModel *m_model;
};

} // namespace unprojector::gui
