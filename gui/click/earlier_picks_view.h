#pragma once

#include "gui/document/pick_history.h"

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;

namespace unprojector::gui {

class SceneDocument;
class WholeTable;

/// The last picks of the scene, the newest first. One selected row is the pick that the document
/// shows; two are compared.
class EarlierPicksView : public QWidget {
    Q_OBJECT
public:
    explicit EarlierPicksView(SceneDocument &document, QWidget *parent = nullptr);

    const PickHistory &history() const { return *m_history; }
    WholeTable &table() { return *m_table; }
    /// The differences of the two selected picks, or how to select them.
    QString difference() const;

signals:
    /// Emitted when the first row is added or the last one removed.
    void filled(bool hasRows);

private:
    void showRows();
    void setRow(int row);
    void select(const std::vector<int> &numbers);
    /// The numbers of the selected picks, in the order of their clicks.
    std::vector<int> selected() const;
    void followSelection();
    void showDifference();
    void showMenu(const QPoint &position);

    SceneDocument &m_document;
    PickHistory *m_history;
    WholeTable *m_table;
    QLabel *m_difference;
    std::vector<EarlierPick> m_picks; ///< of the rows, the newest first
    int m_shown = 0;                  ///< see PickHistory::shownNumber
    bool m_isFilling = false;
};

} // namespace unprojector::gui
