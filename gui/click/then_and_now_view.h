#pragma once

#include <QWidget>

class QLabel;

namespace unprojector::gui {

class SceneDocument;
class WholeTable;

/// The picked point at the click and in the view as it is now, side by side, and below it the changes of the setup.
/// Rows that differ are bold and have a "≠" behind their name. Hidden, it does nothing; shown again, it catches up.
class ThenAndNowView : public QWidget {
    Q_OBJECT
public:
    explicit ThenAndNowView(const SceneDocument &document, QWidget *parent = nullptr);

    /// Takes over the document as it is now.
    void refresh();
    const WholeTable &table() const { return *m_table; }
    /// All of it with all digits, a row a line, tab-separated, of the document as it is now.
    QString text() const;

protected:
    void showEvent(QShowEvent *event) override;

private:
    const SceneDocument &m_document;
    WholeTable *m_table;
    QLabel *m_changes; ///< the point's place and the setup, in words
};

} // namespace unprojector::gui
