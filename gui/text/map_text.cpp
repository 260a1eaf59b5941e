#include "gui/text/map_text.h"

#include <QCoreApplication>

#include <array>
#include <string_view>
#include <utility>

namespace unprojector::gui {
using namespace maps;
using namespace unproject;
namespace {

struct MapText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MapText)
};

/// By the names that maps::namedConventions() has.
constexpr std::array<std::pair<std::string_view, const char *>, 23> kMistakes{{
    {"y-not-flipped", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "y not flipped")},
    {"flipped-with-viewport-height",
     QT_TRANSLATE_NOOP("unprojector::gui::MapText", "y flipped with the viewport's height")},
    {"row-above", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the row of pixels above")},
    {"pixel-corner", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the pixel's corner, no half added")},
    {"ratio-logical-in-device",
     QT_TRANSLATE_NOOP("unprojector::gui::MapText", "logical pixels taken for device pixels")},
    {"ratio-logical-both",
     QT_TRANSLATE_NOOP("unprojector::gui::MapText", "logical pixels, flipped with the logical height")},
    {"viewport-origin-ignored", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the viewport's origin ignored")},
    {"viewport-is-window", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the window taken for the viewport")},
    {"depth-not-remapped", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the depth taken for NDC z")},
    {"depth-remapped-twice", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "a depth from 0 to 1 remapped again")},
    {"depth-reversed", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the depth reversed")},
    {"fov-degrees-as-radians", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "degrees taken for radians")},
    {"fov-horizontal", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the field of view across, not up")},
    {"projection-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the projection transposed")},
    {"view-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the view matrix transposed")},
    {"both-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "both matrices transposed")},
    {"product-transposed", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the product transposed")},
    {"inverse-order", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the inverses in the wrong order")},
    {"not-inverted", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "nothing inverted")},
    {"view-inverse-as-view", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the camera's matrix taken for the view")},
    {"no-w-divide", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "not divided by w")},
    {"model-left-in", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "the model matrix left in")},
    {"single-precision", QT_TRANSLATE_NOOP("unprojector::gui::MapText", "single precision")},
}};

} // namespace

QString quantityName(Quantity quantity)
{
    switch (quantity) {
    case Quantity::FormulaMatrix: return MapText::tr("Formula − matrix");
    case Quantity::FormulaRay: return MapText::tr("Formula − ray on the mesh");
    case Quantity::MatrixRay: return MapText::tr("Matrix − ray on the mesh");
    case Quantity::Uncertainty: return MapText::tr("Uncertainty");
    case Quantity::Displacement: return MapText::tr("Displacement by…");
    }
    return {};
}

QString quantityText(Quantity quantity)
{
    switch (quantity) {
    case Quantity::FormulaMatrix: return MapText::tr("How far the formulas' point is from the inverted matrix's");
    case Quantity::FormulaRay:
        return MapText::tr("How far the formulas' point is from where the pixel's ray meets the mesh");
    case Quantity::MatrixRay:
        return MapText::tr("How far the inverted matrix's point is from where the pixel's ray meets the mesh");
    case Quantity::Uncertainty:
        return MapText::tr(
            "How far the surface may be from the point of a click: the length of its ± in the comparison. A "
            "placed point's ± has half a pixel to the side besides");
    case Quantity::Displacement:
        return MapText::tr("How far what another program answers, or a program with a mistake, is from the formulas' "
                           "point");
    }
    return {};
}

QString unitName(Unit unit)
{
    switch (unit) {
    case Unit::World: return MapText::tr("world units");
    case Unit::Ulps: return MapText::tr("ulps");
    }
    return {};
}

QString programName(OtherProgram program)
{
    switch (program) {
    case OtherProgram::Paper: return MapText::tr("The paper, literally");
    case OtherProgram::Screen2World: return QStringLiteral("screen2world");
    case OtherProgram::MeshLab: return QStringLiteral("MeshLab");
    case OtherProgram::Polyscope: return QStringLiteral("Polyscope");
    case OtherProgram::CloudCompare: return QStringLiteral("CloudCompare");
    case OtherProgram::Open3D: return QStringLiteral("Open3D");
    case OtherProgram::Vtk: return QStringLiteral("VTK");
    }
    return {};
}

QString programReason(OtherProgram program)
{
    switch (program) {
    case OtherProgram::Paper:
        return MapText::tr("(7) and (8) with whole pixels: the pixel's upper left corner, half a pixel left and up of "
                           "its centre");
    case OtherProgram::Screen2World:
        return MapText::tr("The tutorial's function flips y with the viewport's height, unprojects the pixel's corner, "
                           "and reads the depth of the row above");
    case OtherProgram::MeshLab:
    case OtherProgram::Polyscope:
        return MapText::tr("Height − y without the 1: unprojects the pixel's upper left corner with the depth of the "
                           "row above");
    case OtherProgram::CloudCompare:
        return MapText::tr("Unprojects the pixel's lower left corner, half a pixel left and down of its centre");
    case OtherProgram::Open3D:
        return MapText::tr("Unprojects the pixel's upper left corner, half a pixel left and up of its centre");
    case OtherProgram::Vtk:
        return MapText::tr("Divides by the size less one: right in the middle of the viewport, half a pixel off at its "
                           "edges");
    }
    return {};
}

QString conventionName(const NamedConvention &convention)
{
    if (const auto *program = std::get_if<OtherProgram>(&convention.other))
        return programName(*program);
    for (const auto &[key, text] : kMistakes) {
        if (key == convention.key)
            return MapText::tr(text);
    }
    return QString::fromUtf8(convention.key.data(), static_cast<qsizetype>(convention.key.size()));
}

} // namespace unprojector::gui
