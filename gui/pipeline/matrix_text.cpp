#include "gui/pipeline/matrix_text.h"

#include "core/geometry/numbers.h"
#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace cameras;
using namespace pipeline;
namespace {

struct MatrixText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MatrixText)
};

/// The remaining digits of near in a single-precision matrix.
constexpr int kDigits = 5;

QString number(double value)
{
    return writtenText(value, kDigits);
}

QString tripleText(const glm::dvec3 &p)
{
    return QStringLiteral("(%1, %2, %3)").arg(number(p.x), number(p.y), number(p.z));
}

QString partName(PastedPart part)
{
    switch (part) {
    case PastedPart::ModelView:
    case PastedPart::View: return roleName(MatrixRole::View);
    case PastedPart::Projection: return roleName(MatrixRole::Projection);
    case PastedPart::Product: return roleName(MatrixRole::Product);
    case PastedPart::Viewport: return MatrixText::tr("Viewport");
    case PastedPart::Model:
    case PastedPart::ToWindow: break;
    }
    return MatrixText::tr("Model");
}

/// The window's action or advice about a finding, beside the button that repairs it.
QString adviceFor(const MatrixFinding &finding, MatrixRole role)
{
    switch (finding.fault) {
    case MatrixFault::DepthReversed: return MatrixText::tr("The depth range is reversed to match.");
    case MatrixFault::FarAtInfinity: return MatrixText::tr("It is drawn up to one million times near.");
    case MatrixFault::UnknownForm:
        return MatrixText::tr("The window cannot show it; only the inverted matrix can answer.");
    case MatrixFault::OrderOpen: return MatrixText::tr("Choose the order in which your program prints it.");
    case MatrixFault::Mirrored:
        return role == MatrixRole::View
                   ? MatrixText::tr("The program's world may be left-handed. “Flip x” keeps the coordinates of that "
                                    "world and mirrors the image; it is then not the program's camera.")
                   : QString();
    case MatrixFault::Scaled:
        return finding.repair == MatrixRepair::None ? MatrixText::tr("Paste only the view.") : QString();
    default: return {};
    }
}

} // namespace

QString roleName(MatrixRole role)
{
    switch (role) {
    case MatrixRole::View: return MatrixText::tr("View or modelview");
    case MatrixRole::Projection: return MatrixText::tr("Projection");
    case MatrixRole::Product: break;
    }
    return MatrixText::tr("Product (MVP)");
}

QString formName(MatrixForm form)
{
    switch (form) {
    case MatrixForm::Flat: return MatrixText::tr("sixteen numbers in a row");
    case MatrixForm::Indexed: return MatrixText::tr("numbers with an index, m[0] to m[15]");
    case MatrixForm::GlmColumns: return MatrixText::tr("GLM's or GLSL's columns");
    case MatrixForm::IndexPairs: return MatrixText::tr("numbers with row and column, m(0,1)");
    case MatrixForm::RowLines: return MatrixText::tr("four lines");
    case MatrixForm::Call: return MatrixText::tr("a call");
    case MatrixForm::NestedRows: break;
    }
    return MatrixText::tr("four brackets");
}

QString findingSentence(const MatrixFinding &finding, MatrixRole role)
{
    const QString found = QString::fromStdString(findingText(finding, role));
    return joinSentences(
        {MatrixText::tr("It %1.", "a matrix: the finding about it").arg(found), adviceFor(finding, role)});
}

QString repairName(const MatrixFinding &finding, NumberOrder order)
{
    switch (finding.repair) {
    case MatrixRepair::None: return {};
    case MatrixRepair::OtherOrder:
        return order == NumberOrder::ByColumns ? MatrixText::tr("Read as Row-major")
                                               : MatrixText::tr("Read as Column-major");
    case MatrixRepair::Invert: return MatrixText::tr("Invert");
    case MatrixRepair::Exchange: return MatrixText::tr("Swap Them");
    case MatrixRepair::DepthZeroToOne:
        return std::isnan(finding.other) ? MatrixText::tr("Keep 0 to 1") : MatrixText::tr("Read as 0 to 1");
    case MatrixRepair::TurnY: return MatrixText::tr("Flip y");
    case MatrixRepair::TurnX: return MatrixText::tr("Flip x");
    case MatrixRepair::WithoutScale: return MatrixText::tr("Remove the Scale");
    case MatrixRepair::Orthonormal: return MatrixText::tr("Make Perpendicular");
    case MatrixRepair::Negate: return MatrixText::tr("Negate");
    case MatrixRepair::TurnEye: break;
    }
    return MatrixText::tr("Turn to −z");
}

QString errorText(const PasteError &error, MatrixRole role)
{
    const std::string &reason = error.text;
    if (error.isOfCall)
        return ended(reason);
    if (error.line > 0)
        return MatrixText::tr("In line %1, column %2: %3").arg(error.line).arg(error.column).arg(ended(reason));
    if (error.all > error.wanted && error.found == 0)
        return MatrixText::tr("There is no matrix of this kind among these %1 numbers: %2.")
            .arg(error.all)
            .arg(roleName(role));
    if (error.part != PastedPart::Viewport && error.all > error.found)
        return MatrixText::tr("%1: %2 of the %3 numbers in the text belong to it; a matrix has %4.")
            .arg(partName(error.part))
            .arg(error.found)
            .arg(error.all)
            .arg(error.wanted);
    return error.part == PastedPart::Viewport ? MatrixText::tr("%1: %2", "a part of the text: what is wrong with it")
                                                    .arg(partName(error.part), ended(reason))
                                              : sentence(reason);
}

QString cameraText(const Setup &setup, const std::optional<Lens> &lens)
{
    const LookAt &camera = setup.camera();
    const WorldVector forward = camera.center - camera.eye;
    const WorldVector direction = forward * (1.0 / length(forward));
    QStringList said{MatrixText::tr("Eye at %1, looking along %2.")
                         .arg(tripleText(camera.eye.coordinates()), tripleText(direction.coordinates()))};
    const ProjectionWindow w = projectionWindow(setup.projection());
    const QString planes = MatrixText::tr("near %1, far %2").arg(number(w.nearDistance), number(w.farDistance));
    const double width = std::abs(w.right - w.left), height = std::abs(w.top - w.bottom);
    if (isPerspective(setup.projection())) {
        const double up = std::atan2(w.top, w.nearDistance), down = std::atan2(w.bottom, w.nearDistance);
        said << MatrixText::tr("Perspective: field of view %1° high, width to height %2, %3.")
                    .arg(number(degreesFromRadians(std::abs(up - down))), number(width / height), planes);
    } else {
        said << MatrixText::tr("Orthographic: %1 wide, %2 high, %3.").arg(number(width), number(height), planes);
    }
    const auto *matrix = lens ? std::get_if<MatrixProjection>(&*lens) : nullptr;
    const auto form = matrix ? recognised(*matrix) : Error{};
    if (form)
        said << (form->ndcDepth == NdcDepth::ZeroToOne
                     ? MatrixText::tr("Right-handed eye space, NDC depths from 0 to 1.")
                     : MatrixText::tr("Right-handed eye space, NDC depths from −1 to 1."));
    return joinSentences(said);
}

} // namespace unprojector::gui
