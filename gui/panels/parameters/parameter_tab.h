#pragma once

#include "gui/document/scene_document.h"
#include "gui/panels/parameters/number_field.h"

#include <QPointer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QScrollArea;
class QVBoxLayout;

namespace unprojector::gui {

/// What a number field stands for in the scene.
struct NumberBinding {
    QString name; ///< what the undo menu says: "Near"
    QString help; ///< what it is, with its unit
    /// Nothing where the scene has no such number: the near plane of no projection, a step that was removed.
    std::function<std::optional<double>(const Scene &)> read;
    std::function<void(Scene &, double)> write;
    /// Why a number is refused that core would take; empty where it is not. May be left out.
    std::function<QString(double)> refusal = {};
};

/// One tab of the parameters: fields bound to numbers of the scene, in a scrolled area, and one place for reasons beneath
/// it, so that nothing moves when one appears.
///
/// An edit is tried together with all numbers that were refused before: from near 1, far 100 to near 200, far 300 the
/// near that came first is refused, then taken with the far. Where that fails, with as many of them as can be.
class ParameterTab : public QWidget {
    Q_OBJECT
public:
    /// @param shown  the changes of the document that the tab follows
    ParameterTab(SceneDocument &document, Changes shown, QWidget *parent = nullptr);
    ~ParameterTab() override;

    /// What the tab says under its fields; empty while all are good.
    QString reason() const;

protected:
    NumberField *addField(NumberBinding binding);
    /// Forgets and deletes the fields inside a widget that is about to go.
    void removeFieldsIn(QWidget *container);
    /// Red fields show the document's values again.
    void restoreFields();

    /// Shows everything of the scene but the fields' numbers. Called only while the tab is on the screen.
    virtual void showScene() = 0;
    /// showScene and all numbers, now.
    void refresh();
    /// Asks the document for what of this scene is this tab's to change.
    virtual Check edit(const Scene &next, const Deed &deed) = 0;
    /// Makes a change that no field made; its refusal is shown beneath the fields.
    bool change(const Scene &next, const QString &text);

    SceneDocument &document() const { return m_document; }
    QVBoxLayout *content() const { return m_content; }
    /// Puts the cursor into a field that was just made, and scrolls there.
    void bringUp(NumberField *field);
    /// Keeps the wheel from changing a combo box that it only scrolls past.
    void ignoreWheelWithoutFocus(QWidget *widget);
    static QLabel *heading(const QString &text);

    void showEvent(QShowEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    struct Field {
        QPointer<NumberField> widget;
        NumberBinding binding;
    };
    /// Whoever hears of a change may remove fields: who goes on with one after it holds it.
    using FieldPointer = std::shared_ptr<Field>;

    bool isThere(const FieldPointer &field) const;
    void apply(const FieldPointer &field);
    /// Writes the numbers in these fields into the scene, as one change.
    Check changeTogether(const std::vector<FieldPointer> &fields, const Deed &deed);
    /// Why the number in this field would be refused as the scene is now; empty if it would not.
    QString refusalOf(const Field &field) const;
    /// Refused fields whose text is a number, without `other`.
    std::vector<FieldPointer> refusedBut(const FieldPointer &other) const;
    void updateReasons();
    void showReason();

    SceneDocument &m_document;
    std::vector<FieldPointer> m_fields;
    QVBoxLayout *m_content;
    QScrollArea *m_scroll;
    QLabel *m_reasonLabel;
    QString m_otherReason; ///< of a change that no field made
    bool m_isStale = true;
};

} // namespace unprojector::gui
