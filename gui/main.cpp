#include "gui/shell/program.h"

int main(int argc, char **argv)
{
    QCoreApplication::setApplicationName(QStringLiteral("Unprojector"));
    QCoreApplication::setOrganizationName(QStringLiteral("Unprojector"));
    QCoreApplication::setApplicationVersion(QStringLiteral(UNPROJECTOR_VERSION));
    return unprojector::gui::Program(argc, argv).run();
}
