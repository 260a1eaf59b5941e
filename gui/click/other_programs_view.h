#pragma once

#include "core/unproject/other_programs.h"

#include <QWidget>

#include <optional>

class QLabel;
class QToolButton;

namespace unprojector::gui {
using namespace unproject;

/// What other programs give for a click: how far that is from the formulas' point, where it lies, and why. Folded at first.
class OtherProgramsView : public QWidget {
    Q_OBJECT
public:
    explicit OtherProgramsView(QWidget *parent = nullptr);

    /// @param formula    the formulas' point; nothing: there is no hit, or it is not known yet
    /// @param certainty  of its coordinates, by which the others are written
    void setAnswers(const std::optional<OtherAnswers> &answers, const std::optional<WorldPoint> &formula,
                    const WorldVector &certainty);
    /// All of it with all digits, a program a line, tab-separated.
    QString text() const { return m_plain; }

private:
    QToolButton *m_fold;
    QLabel *m_answers;
    QString m_plain;
};

} // namespace unprojector::gui
