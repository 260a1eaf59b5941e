#include "gui/text/map_text.h"

#include "core/doctor/report_text.h"

#include <QCoreApplication>

#include <string_view>

namespace unprojector::gui {
using namespace maps;
using namespace unproject;
namespace {

struct MapText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MapText)
};

} // namespace

QString quantityName(Quantity quantity)
{
    switch (quantity) {
    case Quantity::FormulaMatrix: return MapText::tr("Formula − matrix");
    case Quantity::FormulaRay: return MapText::tr("Formula − exact hit");
    case Quantity::MatrixRay: return MapText::tr("Matrix − exact hit");
    case Quantity::Uncertainty: return MapText::tr("Uncertainty");
    case Quantity::Displacement: return MapText::tr("Displacement by…");
    }
    return {};
}

QString quantityText(Quantity quantity)
{
    switch (quantity) {
    case Quantity::FormulaMatrix:
        return MapText::tr("Distance between the points of the formulas and of the inverted matrix");
    case Quantity::FormulaRay:
        return MapText::tr("Distance from the formulas' point to the hit of the pixel's ray on the mesh");
    case Quantity::MatrixRay:
        return MapText::tr("Distance from the inverted matrix's point to the hit of the pixel's ray on the mesh");
    case Quantity::Uncertainty:
        return MapText::tr("Greatest distance of the surface from the point of a click: the length of its ± in the "
                           "Comparison panel. The ± of a landmark adds half a pixel to the side");
    case Quantity::Displacement:
        return MapText::tr(
            "Distance from the formulas' point to the answer of another program, or of a program with a mistake");
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

QString programReasonInShort(OtherProgram program)
{
    switch (program) {
    case OtherProgram::Paper:
    case OtherProgram::Open3D: return MapText::tr("takes the pixel's upper left corner");
    case OtherProgram::Screen2World: return MapText::tr("flips y by the viewport's height");
    case OtherProgram::MeshLab:
    case OtherProgram::Polyscope: return MapText::tr("forgets the 1 in height − 1 − y");
    case OtherProgram::CloudCompare: return MapText::tr("takes the pixel's lower left corner");
    case OtherProgram::Vtk: return MapText::tr("divides by the size less one");
    }
    return {};
}

QString conventionName(const NamedConvention &convention)
{
    if (const auto *program = std::get_if<OtherProgram>(&convention.other))
        return programName(*program);
    constexpr std::string_view kNoMistake = "single-precision"; // among the doctor's
    return convention.key == kNoMistake ? MapText::tr("single precision")
                                        : QString::fromStdString(doctor::mistakeName(convention.key));
}

} // namespace unprojector::gui
