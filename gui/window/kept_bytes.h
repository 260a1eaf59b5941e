#pragma once

#include <QByteArray>
#include <QVariant>

namespace unprojector::gui {

// Seals Qt's layouts with a checksum: Qt reads their bytes without checks, and damaged ones can
// crash the program. Only bytes are read back that were written here, complete, and for this
// purpose.

/// The bytes with their checksum.
/// @param purpose  of these bytes: bytes of another purpose are rejected
QByteArray sealed(const QByteArray &bytes, const QByteArray &purpose);

/// The bytes that were sealed for this purpose.
/// @param kept  as read from a file, possibly damaged
/// @return empty if it is damaged, not sealed, or for another purpose
QByteArray unsealed(const QVariant &kept, const QByteArray &purpose);

} // namespace unprojector::gui
