#pragma once

#include "core/doctor/diagnosis.h"

#include <QWidget>

#include <optional>

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace unprojector::gui {

/// The diagnosis of wrong points: its verdict, the evidence, and a click that would add
/// information.
class DiagnosisView : public QWidget {
    Q_OBJECT
public:
    explicit DiagnosisView(QWidget *parent = nullptr);

    /// Shows a message instead: the missing input, or why there is no answer.
    void setMessage(const QString &text);
    /// @param first  of the points; determines the digits of the others
    void setDiagnosis(const doctor::Diagnosis &diagnosis, const doctor::WrongPoint &first);
    /// Puts a widget directly below the verdict.
    void setBelowVerdict(QWidget *widget);
    /// The whole text, a line each.
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

    /// Puts the button directly below the verdict, or after the widget below it.
    /// @param isOfSeveral  the verdict names several mistakes
    void placeClick(bool isOfSeveral);
    void showAnswer(const Shown &shown);
    void enlargeVerdict();
    /// The wrong point, its explained digits in the text's colour and the rest in grey.
    QString gotMarkup(const Shown &shown) const;

    std::optional<Shown> m_shown;
    QVBoxLayout *m_layout = nullptr;
    QWidget *m_below = nullptr; ///< of the verdict
    QLabel *m_verdict;
    QLabel *m_facts;
    QPushButton *m_click;
    QString m_text;
};

} // namespace unprojector::gui
