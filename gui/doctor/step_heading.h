#pragma once

#include <QLabel>

namespace unprojector::gui {

/// The heading of a step of the doctor's panel: "2  Your click", in bold. A long one wraps.
inline QLabel *stepHeading(int number, const QString &title)
{
    auto *heading = new QLabel(QStringLiteral("%1  %2").arg(number).arg(title));
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    heading->setTextFormat(Qt::PlainText);
    heading->setWordWrap(true);
    return heading;
}

} // namespace unprojector::gui
