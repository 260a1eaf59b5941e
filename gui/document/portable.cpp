#include "gui/document/portable.h"

#include <QFile>

namespace unprojector::gui {

bool isPortable(const QString &programFolder)
{
    return QFile::exists(programFolder + QStringLiteral("/portable"));
}

} // namespace unprojector::gui
