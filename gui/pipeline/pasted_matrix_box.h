#pragma once

#include "core/matrices/matrix_paste.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPlainTextEdit;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

class MatrixFindingsView;
class MatrixModel;
class NumberGrid;
class SegmentedSwitch;

/// One of the matrices that are being pasted: its text, the matrix as it is read from it, and what is to be seen of that.
class PastedMatrixBox : public QWidget {
    Q_OBJECT
public:
    explicit PastedMatrixBox(matrices::MatrixRole role, QWidget *parent = nullptr);

    QString text() const;
    void setText(const QString &text);
    /// Shows what came of the texts.
    void showPaste(const matrices::MatrixPaste &paste);

signals:
    void textChanged(const QString &text);
    void orderChosen(unprojector::matrices::NumberOrder order);
    void ndcDepthChosen(const std::optional<unprojector::geometry::NdcDepth> &depth);
    void repairWanted(const unprojector::matrices::MatrixFinding &finding);
    /// The text is to stand where it belongs by its names.
    void moveWanted();
    /// All repairs are to be forgotten.
    void asPastedWanted();

private:
    /// What the text was read as.
    QStringList saidOf(const matrices::MatrixPaste &paste) const;

    matrices::MatrixRole m_role;
    QPlainTextEdit *m_text;
    QLabel *m_said;
    QPushButton *m_move;
    SegmentedSwitch *m_order;
    SegmentedSwitch *m_ndcDepth;
    QToolButton *m_asPasted;
    MatrixModel *m_model;
    NumberGrid *m_grid;
    MatrixFindingsView *m_findings;
};

} // namespace unprojector::gui
