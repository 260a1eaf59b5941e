#pragma once

#include "core/cameras/matrix_paste.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;
class QToolButton;

namespace unprojector::gui {

class MatrixFindingsView;
class MatrixModel;
class NumberGrid;
class PlainTextBox;
class SegmentedSwitch;

/// A matrix that is being pasted: its text, the parsed matrix, and the findings about it.
class PastedMatrixBox : public QWidget {
    Q_OBJECT
public:
    explicit PastedMatrixBox(pipeline::MatrixRole role, QWidget *parent = nullptr);

    QString text() const;
    /// Replaces the text unless it is too long.
    void setText(const QString &text);
    /// Shows the text and what it was read as.
    void showMatrix();
    /// Shows only the text, which has no matrix but another program's camera.
    /// @param isHalf  the other half of the camera is in another box
    void showTextOnly(bool isHalf);
    /// Shows the result of parsing the texts.
    void showPaste(const cameras::MatrixPaste &paste);

signals:
    void textChanged(const QString &text);
    /// Emitted instead of taking a text of so many characters.
    void textRefused(qsizetype characters);
    void orderChosen(unprojector::cameras::NumberOrder order);
    void ndcDepthChosen(const std::optional<unprojector::geometry::NdcDepth> &depth);
    void repairWanted(const unprojector::pipeline::MatrixFinding &finding);
    /// Emitted when the text must move to the field that its names indicate.
    void moveWanted();
    /// Emitted when the user discards all repairs.
    void asPastedWanted();

private:
    void setTextLines(int lines);
    /// The descriptions of how the text was interpreted.
    QStringList saidOf(const cameras::MatrixPaste &paste) const;

    pipeline::MatrixRole m_role;
    QLabel *m_title;
    QWidget *m_read; ///< all that the text was read as
    PlainTextBox *m_text;
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
