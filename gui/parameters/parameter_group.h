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

/// What a number field stands for in the scene.
struct NumberBinding {
    QString name; ///< what the undo menu says: "Near"
    QString help; ///< what it is, with its unit
    /// Nothing where the scene has no such number: the near plane of no projection, a step that was removed.
    std::function<std::optional<double>(const scene::Scene &)> read;
    std::function<void(scene::Scene &, double)> write;
    /// Why a number is refused that core would take; empty where it is not. May be left out.
    std::function<QString(double)> refusal = {};
};

/// A folding group of the parameters: rows of fields bound to numbers of the scene.
///
/// An edit is tried together with all numbers that were refused before: from near 1, far 100 to near 200, far 300 the
/// near that came first is refused, then taken with the far. Where that fails, with as many of them as can be.
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
    /// The width that it needs, open or not.
    int leastWidth() const;
    /// What is being typed counts, on the screen or not. What was refused already is not asked for again.
    void applyTyped();
    /// All fields show the document's values again, whatever was typed into them.
    void restoreFields();

signals:
    /// This is to be scrolled into sight.
    void bringUpRequested(QWidget *widget);
    /// There are other rows than before.
    void rowsChanged();

protected:
    /// A row of its own, at the end of a layout.
    ParameterRow *addRow(QBoxLayout *layout, const QString &title);
    NumberField *addField(ParameterRow *row, const QString &letter, const QString &unit, NumberBinding binding);
    /// Puts a slider beside a field of a row. The group keeps its numbers and its place.
    /// @param within  brings a number to the nearest one that the scene takes
    NumberSlider *addSlider(ParameterRow *row, const NumberField *of, NumberSlider::Scale scale,
                            std::function<double(const scene::Scene &, double)> within);
    /// Forgets and deletes the fields inside a widget that is about to go.
    void removeFieldsIn(QWidget *container);

    /// Shows everything of the scene but the fields' numbers. Called while the group is on the screen, or before what was
    /// typed there counts.
    virtual void showScene() = 0;
    /// showScene and all numbers, now.
    void refresh();
    /// Puts this group's numbers to what they are at first.
    virtual void setDefaults(scene::Scene &scene) const = 0;
    /// Makes a change that no field made; its refusal is shown beneath the heading.
    bool change(const QString &text, const std::function<void(scene::Scene &)> &edit);

    SceneDocument &document() const { return m_document; }
    QVBoxLayout *content() const { return m_content; }
    /// What a button does. Before it what is being typed counts. A click leaves the keyboard where it is; `act` learns
    /// whether the button was pressed by the keyboard.
    void onClick(QAbstractButton *button, std::function<void(bool byKeyboard)> act);
    /// Scrolls to a field that was just made; by the keyboard the cursor goes there as well.
    void bringUp(NumberField *field, bool byKeyboard);
    /// A text that is wrapped rather than cut, and never widens the panel.
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
    /// Whoever hears of a change may remove fields: who goes on with one after it holds it.
    using FieldPointer = std::shared_ptr<Field>;

    bool isThere(const FieldPointer &field) const;
    void apply(const FieldPointer &field);
    /// Writes the numbers in these fields into the scene, as one change.
    geometry::Check changeTogether(const std::vector<FieldPointer> &fields, const EditLabel &label);
    void refuse(const FieldPointer &field);
    /// Why the number in this field would be refused as the scene is now; empty if it would not.
    QString refusalOf(const Field &field) const;
    /// Refused fields whose text is a number, without `other`.
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
