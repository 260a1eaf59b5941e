#pragma once

#include "core/unproject/pick.h"

#include <QString>
#include <QWidget>

#include <vector>

class QLabel;
class QToolButton;

namespace unprojector::gui {

class SteadyLabel;

/// The agreement of the two methods, in one line with a sign; "Why?" opens the reasons.
class VerdictView : public QWidget {
    Q_OBJECT
public:
    explicit VerdictView(QWidget *parent = nullptr);

    /// @param accuracy      a sentence on the coordinate's uncertainty
    /// @param uncertainty   its numbers, for the copy menu
    void setPick(const unproject::Pick &pick, const QString &accuracy, const QString &name,
                 const std::vector<double> &uncertainty);
    /// The verdict and the reasons, a line each.
    QString text() const;

protected:
    void changeEvent(QEvent *event) override;

private:
    enum class Sign { Agree, Differ, Beyond };
    void showSign();

    Sign m_sign = Sign::Agree;
    QLabel *m_mark;
    SteadyLabel *m_verdict;
    QToolButton *m_why;
    SteadyLabel *m_accuracy;
    SteadyLabel *m_cause;
    QWidget *m_causeLine; ///< the cause with its link; hidden if there is none
};

} // namespace unprojector::gui
