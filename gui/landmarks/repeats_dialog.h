#pragma once

#include "core/landmarks/repeatability.h"

#include <QDialog>
#include <QString>
#include <QStringList>

class QTreeWidget;

namespace unprojector::gui {

/// The error of measurement of the landmarks of a series: a row a landmark and one for all, with the
/// error, the intraclass correlations, and each placing's error and bias.
class RepeatsDialog : public QDialog {
    Q_OBJECT
public:
    /// @param unit     of the coordinates; may be empty
    /// @param remarks  sentences shown above the table
    RepeatsDialog(const landmarks::MeasurementError &error, const QString &unit, const QStringList &remarks,
                  QWidget *parent = nullptr);

    const QTreeWidget &table() const { return *m_table; }

signals:
    /// Emitted when the user wants the shown numbers as a file.
    void errorsRequested();
    /// Emitted when the user wants the means of each scan as a file.
    void meansRequested();

private:
    QTreeWidget *m_table;
};

} // namespace unprojector::gui
