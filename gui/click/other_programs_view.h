#pragma once

#include "core/unproject/other_programs.h"

#include <QWidget>

#include <optional>

class QLabel;

namespace unprojector::gui {

class WholeTable;

/// The answers of other programs to a click, a row each: the distance of their point from the
/// formulas', and why. Point and reason of the current row are shown in full below; a menu copies
/// the point.
class OtherProgramsView : public QWidget {
    Q_OBJECT
public:
    explicit OtherProgramsView(QWidget *parent = nullptr);

    /// @param formula      the formulas' point; nothing: there is no hit, or it is not known yet
    /// @param uncertainty  of its coordinates; determines the digits of the others
    /// @param notAnswered  why the answers are not known yet; empty: no surface was clicked
    void setAnswers(const std::optional<unproject::OtherAnswers> &answers,
                    const std::optional<geometry::WorldPoint> &formula, const geometry::WorldVector &uncertainty,
                    const QString &notAnswered = {});
    /// The whole table with all digits, a program a line, tab-separated.
    QString text() const { return m_plain; }

private:
    void showReason(int row);
    void showMenu(const QPoint &position);

    WholeTable *m_table;
    QLabel *m_reason;
    QString m_plain;
};

} // namespace unprojector::gui
