#pragma once

#include <QByteArray>
#include <QScrollArea>

#include <vector>

namespace unprojector::gui {

class ParameterGroup;
class SceneDocument;

/// All numbers that make the picture, each editable at once and undoably, in one column of folding groups: view,
/// projection, viewport and depth, model, clip planes. What is folded or not on the screen costs nothing.
///
/// Its least width comes from the font; no number, reason or name in it makes it wider.
class ParametersPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit ParametersPanel(SceneDocument &document, QWidget *parent = nullptr);

    /// What is being typed counts, as if Enter were pressed. What was refused already is not asked for again.
    void applyTyped();

    /// Which groups are folded, to be kept with the window's layout.
    QByteArray saveState() const;
    /// @return false where this is no state of the panel's; then nothing changes
    bool restoreState(const QByteArray &state);

    QSize minimumSizeHint() const override;
    QSize sizeHint() const override;

protected:
    void changeEvent(QEvent *event) override;

private:
    void addGroup(ParameterGroup *group, const QString &objectName, bool isOpen);
    /// The same columns in all rows, and the width that all of them need, folded or not.
    void alignRows();
    /// Tab goes through the column from above to below, also through rows that were made later.
    void orderTabs();
    void bringUp(QWidget *widget);

    std::vector<ParameterGroup *> m_groups;
};

} // namespace unprojector::gui
