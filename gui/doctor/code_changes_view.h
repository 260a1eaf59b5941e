#pragma once

#include <QWidget>

#include <string>

class QLabel;
class QPushButton;

namespace unprojector::gui {

class SegmentedSwitch;

/// The lines of code to change for a mistake, in the chosen library: the present and the corrected
/// ones.
class CodeChangesView : public QWidget {
    Q_OBJECT
public:
    explicit CodeChangesView(QWidget *parent = nullptr);

    /// @param id  of core/doctor, for two mistakes "a+b"; empty: there is nothing to change
    void setMistake(const std::string &id);
    /// Its name in core/doctor.
    QString library() const;
    void setLibrary(const QString &library);
    /// The shown lines, with "- " and "+ " before them.
    QString text() const { return m_text; }

protected:
    void changeEvent(QEvent *event) override;

private:
    void showLines();

    std::string m_id;
    QLabel *m_title;
    SegmentedSwitch *m_library;
    QPushButton *m_copy;
    QLabel *m_lines;
    QString m_text;
};

} // namespace unprojector::gui
