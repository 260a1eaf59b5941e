#pragma once

#include "core/unproject/pick.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QPushButton;

namespace unprojector::gui {
using namespace unproject;

class ComparisonModel;
class ComparisonTable;
class ElidedLabel;
class FormulaView;
class SceneDocument;
class SteadyLabel;

/// The picked point, computed twice: the chain of the click, the table of both methods, how certain the coordinate is,
/// and the formula with its numbers put in. All of it is of the moment of the click; when the document is another one since,
/// the panel says so and offers to pick the same position anew.
class ComparisonPanel : public QWidget {
    Q_OBJECT
public:
    explicit ComparisonPanel(SceneDocument &document, QWidget *parent = nullptr);

    bool showsFloat() const;
    void setShowsFloat(bool shows);

    /// Everything the panel shows, with all digits.
    QString text() const;
    const ComparisonModel &model() const { return *m_model; }

signals:
    void showsFloatChanged(bool shows);
    /// The position of the pick shall be picked anew, in the view as it is now.
    void pickRequested(const unprojector::geometry::WidgetPoint &position);

private:
    void showPick();
    void showSinceClick();

    SceneDocument &m_document;
    ElidedLabel *m_heading;
    SteadyLabel *m_sinceClick;
    QPushButton *m_again;
    SteadyLabel *m_widget;
    SteadyLabel *m_devicePixel;
    SteadyLabel *m_window;
    SteadyLabel *m_depth;
    ComparisonTable *m_table;
    ComparisonModel *m_model;
    SteadyLabel *m_certainty;
    SteadyLabel *m_cause;
    FormulaView *m_formula;
    QCheckBox *m_showsFloat;
    QPushButton *m_copy;
};

} // namespace unprojector::gui
