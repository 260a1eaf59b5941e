#include "gui/document/bundled_names.h"

#include "gui/document/object_names.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>

namespace unprojector::gui {
namespace {

constexpr char kContext[] = "BundledNames";
/// Of core/scene/bundled_scene and the models of the lessons.
constexpr std::array kNames{
    QT_TRANSLATE_NOOP("BundledNames", "Teapot"), QT_TRANSLATE_NOOP("BundledNames", "Cube"),
    QT_TRANSLATE_NOOP("BundledNames", "Torus"),  QT_TRANSLATE_NOOP("BundledNames", "Ball"),
    QT_TRANSLATE_NOOP("BundledNames", "Cone"),   QT_TRANSLATE_NOOP("BundledNames", "Cube of side 10")};

} // namespace

QString readName(const std::string &name)
{
    QString whole = QString::fromStdString(name);
    static const QRegularExpression numberBehind(QStringLiteral(" \\(\\d+\\)$"));
    const QString number = numberBehind.match(whole).captured();
    const QString key = whole.chopped(number.size());
    for (const char *bundled : kNames) {
        if (key == QLatin1String(bundled))
            return QCoreApplication::translate(kContext, bundled) + number;
    }
    return whole;
}

QString shownObjectName(const std::string &name)
{
    return shownName(readName(name).toStdString());
}

} // namespace unprojector::gui
