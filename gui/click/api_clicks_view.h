#pragma once

#include "core/geometry/api_conventions.h"
#include "core/unproject/pick.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace unprojector::gui {

class WholeTable;

/// A click in the conventions of every API: a row each, with the API's differences in its tooltip.
class ApiClicksView : public QWidget {
    Q_OBJECT
public:
    explicit ApiClicksView(QWidget *parent = nullptr);

    /// @param pick  of a surface, else the cells are empty
    void setPick(const std::optional<unproject::Pick> &pick);
    /// Highlights the API of the scene.
    void setScenes(geometry::Api api);
    const WholeTable &table() const { return *m_table; }
    /// The whole table with all digits, an API a line, tab-separated; empty without a point.
    QString text() const { return m_plain; }

private:
    void showMenu(const QPoint &position);

    WholeTable *m_table;
    QLabel *m_none; ///< shown instead of the table
    QString m_plain;
};

} // namespace unprojector::gui
