#pragma once

#include <QWidget>

class QLabel;

namespace unprojector::gui {

class SceneDocument;
class WholeTable;

/// The picked point at the click and in the current view, side by side, and below it the changes of
/// the setup. Rows with a difference are bold and have a "≠" after their name. It does nothing
/// while hidden and catches up when shown.
class ThenAndNowView : public QWidget {
    Q_OBJECT
public:
    explicit ThenAndNowView(const SceneDocument &document, QWidget *parent = nullptr);

    /// Reads the current document.
    void refresh();
    const WholeTable &table() const { return *m_table; }
    /// The current table and changes with all digits, one row per line, tab-separated.
    QString text() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    const SceneDocument &m_document;
    WholeTable *m_table;
    QLabel *m_changes; ///< the point's clip test and the changes of the setup
};

} // namespace unprojector::gui
