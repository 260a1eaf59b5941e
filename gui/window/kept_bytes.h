#pragma once

#include <QByteArray>
#include <QVariant>

namespace unprojector::gui {

// Qt's layouts are kept as bytes that Qt reads back without doubt: damaged ones can end the program. With a check sum before
// them only bytes are read back that were written here, whole, and for this purpose.

/// The bytes as they are kept.
/// @param purpose  of these bytes: what is kept for one purpose is not taken for another
QByteArray sealed(const QByteArray &bytes, const QByteArray &purpose);

/// What was sealed for this purpose.
/// @param kept  as read from a file that anything may have happened to
/// @return empty where it is damaged, not sealed at all, or for another purpose
QByteArray unsealed(const QVariant &kept, const QByteArray &purpose);

} // namespace unprojector::gui
