#pragma once

#include "gui/parameters/parameter_group.h"

class QCheckBox;
class QComboBox;

namespace unprojector::gui {

/// The projection: its kind and the arguments of glFrustum, gluPerspective, glOrtho or the sheared
/// box.
class ProjectionGroup : public ParameterGroup {
    Q_OBJECT
public:
    explicit ProjectionGroup(SceneDocument &document, QWidget *parent = nullptr);

protected:
    void showScene() override;
    void setDefaults(scene::Scene &scene) const override;

private:
    enum class Number { Left, Right, Bottom, Top, Skew, Near, Far, Fovy, Aspect, Theta, Phi };
    /// A number of a projection, angles in degrees; empty if it has none.
    static std::optional<double> numberIn(const geometry::Projection &projection, Number number);
    /// Sets a number. An edge or the skew turns a pinhole into its frustum.
    static void setNumber(geometry::Projection &projection, Number number, double value);
    template <class AnyProjection, class Use>
    static void withNumber(AnyProjection &projection, Number number, const Use &use);
    static bool isAngle(Number number);

    struct Row {
        Number number;
        ParameterRow *row;
        NumberSlider *slider; ///< or null
    };
    void addNumber(Number number, const QString &name, const QString &objectName, const QString &help);
    /// Adds a slider for the field of view, near or far; returns null for other numbers.
    NumberSlider *sliderFor(Number number, ParameterRow *row, const NumberField *field);
    void rangeSliders();
    void choose(geometry::ProjectionKind kind);

    QComboBox *m_kind;
    std::vector<Row> m_rows;
    double m_sliderUnit = 0.0;
    bool m_areBoxSliders = false; ///< near and far of a box may be any number
    QCheckBox *m_followsViewport;
    QCheckBox *m_fitsObjects;
    std::optional<geometry::ProjectionKind> m_shownKind;
    bool m_hasSkew = false; ///< as shown
};

} // namespace unprojector::gui
