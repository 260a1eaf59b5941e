#pragma once

#include <QByteArray>
#include <QScrollArea>

#include <vector>

namespace unprojector::gui {

class ParameterGroup;
class SceneDocument;

/// All numbers of the setup and the objects, each editable at once and undoably, in one column of
/// folding groups: view, projection, viewport and depth, model, clip planes. Folded or hidden
/// groups cost nothing.
///
/// Its least width depends on the font; no number, reason or name makes it wider.
class ParametersPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit ParametersPanel(SceneDocument &document, QWidget *parent = nullptr);

    /// Commits pending input, as Enter does. Skips texts that were rejected already.
    void applyTyped();

    /// The folded groups, saved with the window's layout.
    QByteArray saveState() const;
    /// @return false if the state is not the panel's; then nothing changes
    bool restoreState(const QByteArray &state);

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void changeEvent(QEvent *event) override;

private:
    void addGroup(ParameterGroup *group, const QString &objectName, bool isOpen);
    /// Aligns the columns of all rows, and sets the width that all of them need, folded or not.
    void alignRows();
    /// Makes Tab go through the column from top to bottom, including rows that were added later.
    void orderTabs();
    void bringUp(QWidget *widget);

    std::vector<ParameterGroup *> m_groups;
};

} // namespace unprojector::gui
