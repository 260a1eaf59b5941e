#include "gui/window/kept_bytes.h"

#include <QCryptographicHash>

namespace unprojector::gui {
namespace {

QByteArray checkSum(const QByteArray &bytes, const QByteArray &purpose)
{
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(purpose);
    hash.addData(QByteArrayView("\0", 1)); // separates the purpose from the bytes
    hash.addData(bytes);
    return hash.result();
}

} // namespace

QByteArray sealed(const QByteArray &bytes, const QByteArray &purpose)
{
    return checkSum(bytes, purpose) + bytes;
}

QByteArray unsealed(const QVariant &kept, const QByteArray &purpose)
{
    if (kept.typeId() != QMetaType::QByteArray)
        return {};
    const QByteArray whole = kept.toByteArray();
    const qsizetype sum = QCryptographicHash::hashLength(QCryptographicHash::Sha256);
    if (whole.size() < sum)
        return {};
    const QByteArray bytes = whole.mid(sum);
    return whole.left(sum) == checkSum(bytes, purpose) ? bytes : QByteArray();
}

} // namespace unprojector::gui
