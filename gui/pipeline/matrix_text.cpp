#include "gui/pipeline/matrix_text.h"

#include "gui/text/number_text.h"
#include "gui/text/sentences.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace unprojector::gui {
using namespace geometry;
using namespace matrices;
namespace {

struct MatrixText {
    Q_DECLARE_TR_FUNCTIONS(unprojector::gui::MatrixText)
};

/// Of near in a matrix of single precision so many digits are left.
constexpr int kDigits = 5;
constexpr double kDegrees = 57.295779513082323;

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
    case PastedPart::Model:
    case PastedPart::Viewport:
    case PastedPart::ToWindow: break;
    }
    return MatrixText::tr("Model");
}

QString scaleText(const MatrixFinding &finding)
{
    if (finding.repair == MatrixRepair::None)
        return MatrixText::tr("The axes have unlike lengths or no right angles, the longest %1: what comes out are the "
                              "object's coordinates, not the world's. Paste the view alone.")
            .arg(number(finding.value));
    return MatrixText::tr("It scales by %1: a model's scale is in it, and what comes out are the object's "
                          "coordinates, not the world's.")
        .arg(number(finding.value));
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
    case MatrixForm::NestedRows: break;
    }
    return MatrixText::tr("four brackets");
}

QString findingSentence(const MatrixFinding &finding, MatrixRole role)
{
    const bool isView = role == MatrixRole::View;
    switch (finding.fault) {
    case MatrixFault::Transposed:
        return isView ? MatrixText::tr("It looks transposed: its last column, not its last row, is 0 0 0 1.")
                      : MatrixText::tr("It looks transposed: only with rows for columns has it a projection's form.");
    case MatrixFault::Inverse:
        return isView
                   ? MatrixText::tr("It may be the camera's own matrix, world from eye: as a view it has the world's "
                                    "origin out of sight, its inverse has it in sight.")
                   : MatrixText::tr("It is an inverse: its own inverse has a projection's form.");
    case MatrixFault::Exchanged:
        return isView ? MatrixText::tr("It has a projection's form: view and projection seem to be exchanged.")
                      : MatrixText::tr("It has a view's form: view and projection seem to be exchanged.");
    case MatrixFault::UnknownForm:
        return MatrixText::tr("It has no form that formulas are known for, and no camera of this window's.");
    case MatrixFault::DepthZeroToOne:
        if (std::isnan(finding.other))
            return MatrixText::tr("It goes by NDC depths from 0 to 1 (Direct3D, Vulkan) and is read so: near is %1.")
                .arg(number(finding.value));
        return MatrixText::tr("It is read by NDC depths from −1 to 1, near %1, but seems to go by 0 to 1 (Direct3D, "
                              "Vulkan): near is then %2.")
            .arg(number(finding.other), number(finding.value));
    case MatrixFault::DepthReversed:
        return MatrixText::tr("Its depths are reversed: near, %1, is at 1. The depth range is turned round for it.")
            .arg(number(finding.value));
    case MatrixFault::FarAtInfinity:
        return MatrixText::tr("Its far plane is at infinity: it is drawn up to a million times near.");
    case MatrixFault::YDown:
        return MatrixText::tr("It turns y round, as is done for Vulkan: the picture is upside down for OpenGL.");
    case MatrixFault::Mirrored:
        return isView ? MatrixText::tr("It is mirrored: its axes are left-handed.") : MatrixText::tr("It mirrors x.");
    case MatrixFault::LeftHanded:
        return MatrixText::tr("It is for an eye space that looks along +z (Direct3D, OpenCV).");
    case MatrixFault::Negated:
        return MatrixText::tr("Every entry has the other sign: the same points, but w < 0 in front of the eye, which "
                              "OpenGL cuts off.");
    case MatrixFault::Rounded:
        return MatrixText::tr(
                   "Its axes are %1 off being perpendicular and of length 1, as few digits or many turns leave them. "
                   "The formulas need them within 0.00001; more decimals are better.")
            .arg(readableText(finding.value));
    case MatrixFault::OtherOrder:
        return isView ? MatrixText::tr("It is read in the order that makes 0 0 0 1 its last row.")
                      : MatrixText::tr("It is read in the order that gives it a projection's form.");
    case MatrixFault::OrderOfOthers:
        return MatrixText::tr("It has the same form in both orders, and is read in that of the other matrix.");
    case MatrixFault::OrderOpen:
        return MatrixText::tr("It is a camera's by rows and by columns, a different one in each order. Choose the "
                              "order in which your program prints it.");
    case MatrixFault::Scaled: break;
    }
    return scaleText(finding);
}

QString repairName(const MatrixFinding &finding, NumberOrder order)
{
    switch (finding.repair) {
    case MatrixRepair::None: return {};
    case MatrixRepair::OtherOrder:
        return order == NumberOrder::ByColumns ? MatrixText::tr("Read as Row-major")
                                               : MatrixText::tr("Read as Column-major");
    case MatrixRepair::Invert: return MatrixText::tr("Take Its Inverse");
    case MatrixRepair::Exchange: return MatrixText::tr("Exchange Them");
    case MatrixRepair::DepthZeroToOne:
        return std::isnan(finding.other) ? MatrixText::tr("Keep 0 to 1") : MatrixText::tr("Read as 0 to 1");
    case MatrixRepair::TurnY: return MatrixText::tr("Turn y Back");
    case MatrixRepair::TurnX: return MatrixText::tr("Turn x Back");
    case MatrixRepair::WithoutScale: return MatrixText::tr("Take the Scale Out");
    case MatrixRepair::Orthonormal: return MatrixText::tr("Make Perpendicular");
    case MatrixRepair::Negate: return MatrixText::tr("Turn the Signs");
    case MatrixRepair::TurnEye: break;
    }
    return MatrixText::tr("Turn to −z");
}

QString errorText(const PasteError &error, MatrixRole role)
{
    if (!error.word.empty())
        return MatrixText::tr("Line %1, column %2: “%3” is not a finite number.")
            .arg(error.line)
            .arg(error.column)
            .arg(QString::fromStdString(error.word));
    if (error.all > error.wanted && error.found == 0)
        return MatrixText::tr("There is no matrix of this kind among these %1 numbers: %2.")
            .arg(error.all)
            .arg(roleName(role));
    if (error.part == PastedPart::Viewport)
        return error.found == 1 ? MatrixText::tr("Viewport: 1 number; it has 4, x y width height, or as a matrix 16.")
                                : MatrixText::tr("Viewport: %1 numbers; it has 4, x y width height, or as a matrix 16.")
                                      .arg(error.found);
    if (error.all > error.found) // of several
        return (error.found == 1
                    ? MatrixText::tr("%1: 1 number; a matrix has 16.").arg(partName(error.part))
                    : MatrixText::tr("%1: %2 numbers; a matrix has 16.").arg(partName(error.part)).arg(error.found));
    if (error.found == 0)
        return MatrixText::tr("There is no number in it; a matrix has 16.");
    return error.found == 1 ? MatrixText::tr("1 number; a matrix has 16.")
                            : MatrixText::tr("%1 numbers; a matrix has 16.").arg(error.found);
}

QString cameraText(const Picture &picture, const std::optional<MatrixProjection> &lens)
{
    const LookAt &camera = picture.camera();
    const WorldVector forward = camera.center - camera.eye;
    const WorldVector direction = forward * (1.0 / length(forward));
    QStringList said{MatrixText::tr("Eye at %1, looking along %2.")
                         .arg(tripleText(camera.eye.coordinates()), tripleText(direction.coordinates()))};
    const ProjectionWindow w = projectionWindow(picture.projection());
    const QString planes = MatrixText::tr("near %1, far %2").arg(number(w.nearDistance), number(w.farDistance));
    const double width = std::abs(w.right - w.left), height = std::abs(w.top - w.bottom);
    if (isPerspective(picture.projection())) {
        const double up = std::atan2(w.top, w.nearDistance), down = std::atan2(w.bottom, w.nearDistance);
        said << MatrixText::tr("Perspective: field of view %1° high, width to height %2, %3.")
                    .arg(number(std::abs(up - down) * kDegrees), number(width / height), planes);
    } else {
        said << MatrixText::tr("Box: %1 wide, %2 high, %3.").arg(number(width), number(height), planes);
    }
    const auto form = lens ? recognised(*lens) : Error{};
    if (form)
        said << (form->ndcDepth == NdcDepth::ZeroToOne
                     ? MatrixText::tr("Right-handed eye space, NDC depths from 0 to 1.")
                     : MatrixText::tr("Right-handed eye space, NDC depths from −1 to 1."));
    return inARow(said);
}

} // namespace unprojector::gui
