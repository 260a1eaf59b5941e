#pragma once

#include "core/doctor/diagnosis.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;

namespace unprojector::gui {

/// What core/doctor says of wrong points: its verdict, what speaks for it, and the click that would tell more.
class DiagnosisView : public QWidget {
    Q_OBJECT
public:
    explicit DiagnosisView(QWidget *parent = nullptr);

    /// Says something else instead: what is still to be given, or why there is no answer.
    void setMessage(const QString &text);
    /// @param first  of the points, by whose digits the others are written
    void setDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);
    /// All of it, a line each.
    QString text() const;

signals:
    void clickRequested(const unprojector::geometry::DevicePoint &pixel);

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Shown {
        doctor::Diagnosis diagnosis;
        doctor::WrongPoint first;
    };

    void showAnswer(const Shown &shown);
    void enlargeVerdict();
    /// The point that was got, what is explained of it in the text's colour and the rest in grey.
    QString gotMarkup(const Shown &shown) const;

    std::optional<Shown> m_shown;
    QLabel *m_verdict;
    QLabel *m_facts;
    QPushButton *m_click;
    QString m_text;
};

} // namespace unprojector::gui
