#pragma once

#include "core/unproject/pick.h"

#include <QWidget>

#include <optional>

class QCheckBox;
class QLabel;
class QPlainTextEdit;
class QPushButton;
class QTableView;

namespace unprojector::gui {
using namespace unproject;

class ComparisonModel;

/// The picked point, computed twice: the chain of the click, the table of both methods, how certain the coordinate is,
/// and the formula with its numbers put in.
class ComparisonPanel : public QWidget {
    Q_OBJECT
public:
    explicit ComparisonPanel(QWidget *parent = nullptr);

    void setPick(const std::optional<Pick> &pick);
    bool showsFloat() const;
    void setShowsFloat(bool shows);

    /// Everything the panel shows, with all digits.
    QString text() const;
    const ComparisonModel &model() const { return *m_model; }

signals:
    void showsFloatChanged(bool shows);

protected:
    void resizeEvent(QResizeEvent *event) override;
    bool eventFilter(QObject *watched, QEvent *event) override;

private:
    void copySelection() const;
    void fitTable();
    void showFormula();

    QLabel *m_heading;
    QLabel *m_widget;
    QLabel *m_devicePixel;
    QLabel *m_window;
    QLabel *m_depth;
    QTableView *m_table;
    ComparisonModel *m_model;
    QLabel *m_certainty;
    QLabel *m_cause;
    QPlainTextEdit *m_formula;
    QString m_formulaText; ///< as it is copied: a formula a line
    QCheckBox *m_showsFloat;
    QPushButton *m_copy;
};

} // namespace unprojector::gui
