#include "gui/text/bundled_names.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <array>

namespace unprojector::gui {
namespace {

constexpr char kContext[] = "BundledNames";
/// The names of core/scene/bundled_scene and the models of the lessons.
constexpr std::array kNames{QT_TRANSLATE_NOOP("BundledNames", "Teapot"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cube"),
                            QT_TRANSLATE_NOOP("BundledNames", "Torus"),
                            QT_TRANSLATE_NOOP("BundledNames", "Ball"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cone"),
                            QT_TRANSLATE_NOOP("BundledNames", "Head"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cube of side 10"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cube at 5"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cube at 11"),
                            QT_TRANSLATE_NOOP("BundledNames", "Cube at 19"),
                            QT_TRANSLATE_NOOP("BundledNames", "MC, with the point (1, 1)"),
                            QT_TRANSLATE_NOOP("BundledNames", "MC, with the point (1, 1, 0)"),
                            QT_TRANSLATE_NOOP("BundledNames", "Plate and outline"),
                            QT_TRANSLATE_NOOP("BundledNames", "Triangle fan"),
                            QT_TRANSLATE_NOOP("BundledNames", "Circle of radius 5"),
                            QT_TRANSLATE_NOOP("BundledNames", "Line"),
                            QT_TRANSLATE_NOOP("BundledNames", "Quad"),
                            QT_TRANSLATE_NOOP("BundledNames", "Box"),
                            QT_TRANSLATE_NOOP("BundledNames", "Column"),
                            QT_TRANSLATE_NOOP("BundledNames", "Plate"),
                            QT_TRANSLATE_NOOP("BundledNames", "The point"),
                            QT_TRANSLATE_NOOP("BundledNames", "Its projection")};

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

QString readName(const std::string &name, const std::vector<scene::SceneObject> &objects)
{
    QString own = QString::fromStdString(name);
    QString read = readName(name);
    if (read == own)
        return own;
    const std::string other = read.toStdString();
    bool isBundled = false;
    for (const scene::SceneObject &object : objects) {
        if (object.name == other)
            return own;
        isBundled = isBundled || (object.name == name && object.file.empty());
    }
    return isBundled ? read : own;
}

} // namespace unprojector::gui
