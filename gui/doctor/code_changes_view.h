#pragma once

#include "core/doctor/diagnosis.h"

#include <QWidget>

#include <string>
#include <vector>

class QLabel;
class QPushButton;

namespace unprojector::gui {

class SegmentedSwitch;

/// The lines of code to change for a mistake in a library: the present and the corrected ones. It
/// shows the library that the user chose, or the first one that has lines, if the user's has none.
class CodeChangesView : public QWidget {
    Q_OBJECT
public:
    explicit CodeChangesView(QWidget *parent = nullptr);

    /// @param id  of core/doctor, for two mistakes "a+b"; empty: there is nothing to change
    /// @param values  solved values, which the lines then have
    void setMistake(const std::string &id, const std::vector<doctor::SolvedValue> &values = {});
    /// The shown library's name in core/doctor.
    QString library() const;
    /// The library that the user chose, whether or not it has lines for this mistake.
    QString chosenLibrary() const;
    /// Chooses a library as the user does; ignores an unknown name.
    void setLibrary(const QString &library);
    /// The shown lines, with "- " and "+ " before them.
    QString text() const { return m_text; }

protected:
    void changeEvent(QEvent *event) override;

private:
    /// Enables the libraries that have lines, and shows the user's or another one of them.
    void showLibrary();
    void showLines();

    std::string m_id;
    std::vector<doctor::SolvedValue> m_values;
    int m_chosen = 0; ///< the user's library
    QLabel *m_title;
    SegmentedSwitch *m_library;
    QPushButton *m_copy;
    QLabel *m_lines;
    QString m_text;
};

} // namespace unprojector::gui
