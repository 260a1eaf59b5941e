#pragma once

#include "gui/document/scene_document.h"
#include "gui/parameters/number_field.h"
#include "gui/parameters/number_slider.h"
#include "gui/parameters/parameter_row.h"

#include <QBoxLayout>
#include <QPointer>
#include <QWidget>

#include <functional>
#include <memory>
#include <optional>
#include <vector>

class QAbstractButton;
class QLabel;

namespace unprojector::gui {

class GroupHeading;

/// The binding of a number field to the scene.
struct NumberBinding {
    QString name; ///< its name in the undo menu: "Near"
    QString help; ///< its meaning, with its unit
    /// Returns nothing if the scene has no such number: the near plane of no projection, a removed
    /// step.
    std::function<std::optional<double>(const scene::Scene &)> read;
    std::function<void(scene::Scene &, double)> write;
    /// Returns why the group rejects a number that core would accept; empty if it doesn't.
    /// Optional.
    std::function<QString(double)> refusal = {};
};

/// A folding group of the parameters: rows of fields bound to numbers of the scene.
///
/// An edit is tried together with all numbers rejected before. For example from near 1, far 100 to
/// near 200, far 300: near is rejected first, then accepted with far. If that fails, with as many
/// of them as possible.
class ParameterGroup : public QWidget {
    Q_OBJECT
public:
    struct Title {
        QString text;
        QString help;
        QString resetHelp; ///< what Reset does
    };
    /// @param shown  the changes of the document that the group follows
    ParameterGroup(SceneDocument &document, Changes shown, const Title &title, QWidget *parent = nullptr);
    ~ParameterGroup() override;

    GroupHeading &heading() const { return *m_heading; }
    bool isOpen() const;
    void setOpen(bool isOpen);
    /// The least width, folded or not.
    int leastWidth() const;
    /// Commits pending input, even if hidden. Skips texts that were rejected already.
    void applyTyped();
    /// Restores the document's values in all fields, and discards pending input.
    void restoreFields();

signals:
    /// Emitted when this widget should be scrolled into view.
    void bringUpRequested(QWidget *widget);
    /// Emitted when rows were added or removed.
    void rowsChanged();

protected:
    /// Appends a row to a layout.
    ParameterRow *addRow(QBoxLayout *layout, const QString &title);
    NumberField *addField(ParameterRow *row, const QString &letter, const QString &unit, NumberBinding binding);
    /// Adds a slider for a field of a row, and keeps both in sync. The caller sets its range.
    /// @param within  returns the nearest number that the scene accepts
    NumberSlider *addSlider(ParameterRow *row, const NumberField *of, NumberSlider::Scale scale,
                            std::function<double(const scene::Scene &, double)> within);
    /// Unbinds and deletes the fields inside a widget that is about to be removed.
    void removeFieldsIn(QWidget *container);

    /// Shows everything of the scene but the fields' numbers. Called while the group is visible, or
    /// before its pending input is committed.
    virtual void showScene() = 0;
    /// Calls showScene and updates all numbers, at once.
    void refresh();
    /// Resets this group's numbers to their defaults.
    virtual void setDefaults(scene::Scene &scene) const = 0;
    /// Applies a change that no field made; shows a rejection beneath the heading.
    bool change(const QString &text, const std::function<void(scene::Scene &)> &edit);

    SceneDocument &document() const { return m_document; }
    QVBoxLayout *content() const { return m_content; }
    /// Sets a button's action. Pending input is committed first. A click keeps the keyboard focus;
    /// `act` learns whether the keyboard pressed the button.
    void onClick(QAbstractButton *button, std::function<void(bool byKeyboard)> act);
    /// Scrolls to a new field; if the keyboard created it, the field gets the focus.
    void bringUp(NumberField *field, bool byKeyboard);
    /// A text that wraps instead of being cut, and never widens the panel.
    static QLabel *wrappedLabel(const QString &text = {});

    // The units beside the fields.
    static QString worldUnits() { return tr("world units"); }
    static QString eyeUnits() { return tr("eye units"); }
    static QString degrees() { return tr("degrees"); }
    static QString devicePixels() { return tr("device px"); }
    static QString ratio() { return tr("w : h"); }
    static QString ofAnyLength() { return tr("direction"); }
    static QString depth() { return QStringLiteral("0 … 1"); }

    void showEvent(QShowEvent *event) override;

private:
    struct Field {
        QPointer<NumberField> widget;
        NumberBinding binding;
        NumberSlider *slider = nullptr;
    };
    /// Receivers of a change may remove fields: code that uses a field afterwards holds it.
    using FieldPointer = std::shared_ptr<Field>;

    bool isThere(const FieldPointer &field) const;
    void apply(const FieldPointer &field);
    /// Writes the numbers of these fields into the scene, as one change.
    geometry::Check changeTogether(const std::vector<FieldPointer> &fields, const EditLabel &label);
    void refuse(const FieldPointer &field);
    /// The reason why this field's number would be rejected in the present scene; empty if it would
    /// not.
    QString refusalOf(const Field &field) const;
    /// The rejected fields with a number, without `other`.
    std::vector<FieldPointer> refusedBut(const FieldPointer &other) const;
    void updateReasons();
    void setReason(const QString &reason);

    SceneDocument &m_document;
    std::vector<FieldPointer> m_fields;
    GroupHeading *m_heading;
    QWidget *m_body;
    QVBoxLayout *m_content;
    QLabel *m_reason; ///< of a change that no field made
    bool m_isStale = true;
};

} // namespace unprojector::gui
