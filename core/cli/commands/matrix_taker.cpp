#include "core/cli/commands/matrix_taker.h"

#include "core/base/translation.h"
#include "core/cli/rows/byte_stream.h"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace unprojector::cli {
using namespace geometry;
using namespace matrices;
using base::tr;
namespace {

/// The remedy for a finding, by an option or by hand.
/// @param hasConventions  an option names the matrices' API, which determines depths and y
std::string adviceFor(const MatrixFinding &finding, NumberOrder order, bool hasConventions)
{
    switch (finding.fault) {
    case MatrixFault::Transposed:
    case MatrixFault::OtherOrder:
    case MatrixFault::OrderOfOthers:
        return tr(order == NumberOrder::ByColumns ? "; read by columns, --order row reads it by rows"
                                                  : "; read by rows, --order column reads it by columns");
    case MatrixFault::OrderOpen: return tr("; give --order row or --order column");
    case MatrixFault::Inverse: return tr("; if it is, give its inverse");
    case MatrixFault::Exchanged: return tr("; give each behind its name, modelview and projection");
    case MatrixFault::DepthZeroToOne:
        return tr(hasConventions ? "; --conventions of an API with such depths reads it so"
                                 : "; --depth zero-to-one reads it so, --depth minus-one-to-one does not");
    case MatrixFault::DepthReversed: return tr("; the depths of clicks must be reversed too; give --reversed");
    case MatrixFault::YDown:
        return tr(hasConventions ? "; it is not changed: if it is unwanted, give --conventions of its API"
                                 : "; --y down flips it back, --y up keeps it");
    case MatrixFault::Rounded: return tr("; --orthonormal uses the nearest axes that are");
    case MatrixFault::Negated: return tr("; its signs are flipped");
    case MatrixFault::UnknownForm: return tr(": only the inverted matrix will answer");
    case MatrixFault::Mirrored:
    case MatrixFault::Scaled:
    case MatrixFault::FarAtInfinity:
    case MatrixFault::LeftHanded: break;
    }
    return {};
}

/// A matrix of a text, and its role in a scene.
struct Part {
    PastedMatrix *matrix;
    PastedPart part;
    MatrixRole role;
    bool isNeeded;
};

/// The matrices whose order matters; the model matrix is not used.
std::vector<Part> partsOf(PastedScene &pasted)
{
    const bool isWhole = pasted.projection && (pasted.view || pasted.modelView);
    std::vector<Part> parts;
    const auto add = [&parts](std::optional<PastedMatrix> &matrix, PastedPart part, MatrixRole role, bool isNeeded) {
        if (matrix && matrix->form != MatrixForm::Call) // a call has no order of numbers
            parts.push_back({&*matrix, part, role, isNeeded});
    };
    add(pasted.view, PastedPart::View, MatrixRole::View, isWhole);
    add(pasted.modelView, PastedPart::ModelView, MatrixRole::View, isWhole && !pasted.view);
    add(pasted.projection, PastedPart::Projection, MatrixRole::Projection, isWhole);
    add(pasted.product, PastedPart::Product, MatrixRole::Product, !isWhole);
    // Its last row is 0 0 0 1, as in a view.
    add(pasted.viewportMatrix, PastedPart::Viewport, MatrixRole::View, true);
    return parts;
}

} // namespace

MatrixTaker::MatrixTaker(const SceneOptions &options, std::string name) : m_options(options), m_name(std::move(name)) {}

bool MatrixTaker::tellOrders(PastedScene &pasted) const
{
    if (m_options.order)
        return true;
    const std::vector<Part> parts = partsOf(pasted);
    std::vector<BothOrders> both;
    for (const Part &part : parts) {
        const auto read = [&](const PastedMatrix &matrix) {
            return part.part == PastedPart::Viewport ? matrixAsGiven(matrix) : this->matrix(matrix, part.role);
        };
        PastedMatrix other = *part.matrix;
        other.order = opposite(order(*part.matrix));
        both.push_back({part.role, part.matrix->form, read(*part.matrix), read(other)});
    }
    const std::optional<double> aspect = pasted.viewport && pasted.viewport->height > 0.0
                                             ? std::optional(pasted.viewport->width / pasted.viewport->height)
                                             : std::nullopt;
    const std::vector<ToldOrder> told = toldOrders(both, aspect);
    bool isKnown = true;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const std::optional<MatrixFinding> finding = findingOf(told[i]);
        const bool isOpen = told[i] == ToldOrder::Open;
        if (!finding || (isOpen && !parts[i].isNeeded))
            continue;
        if (!isOpen)
            parts[i].matrix->order = opposite(order(*parts[i].matrix));
        isKnown = isKnown && !isOpen;
        say(parts[i].part, findingText(*finding, parts[i].role)
                               + adviceFor(*finding, order(*parts[i].matrix), m_options.conventions.has_value()));
    }
    return isKnown;
}

glm::dmat4 MatrixTaker::matrix(const PastedMatrix &pasted, MatrixRole role) const
{
    const glm::dmat4 given = matrixAsGiven(pasted);
    if (pasted.form == MatrixForm::Call) // it has OpenGL's eye already
        return given;
    switch (role) {
    case MatrixRole::View: return oursFromView(given, api());
    case MatrixRole::Projection: return oursFromApi({given, {}}, api()).clipFromEye;
    case MatrixRole::Product: break;
    }
    // The eye space between the two may look either way.
    return oursFromApi({given * viewFromOurs(glm::dmat4(1.0), api()), {}}, api()).clipFromEye;
}

ViewportAndDepths MatrixTaker::viewport(const PastedMatrix &pasted) const
{
    // The window's height is not known yet, so 0 is used.
    const ApiSpaces spaces = apiSpaces(Setup(), api());
    AxisChange window = spaces.window;
    window.scale.z = 1.0;
    window.shift.z = 0.0;
    const glm::dmat4 ours = window.inverse().matrix() * matrixAsGiven(pasted) * spaces.clip.matrix();
    ViewportAndDepths result =
        viewportOf(ours, conventionsOf(api()).hasOnlyThatDepth ? NdcDepth::MinusOneToOne : m_options.depth);
    if (conventionsOf(api()).isDepthReversed)
        std::swap(result.depthRange.atNear, result.depthRange.atFar);
    return result;
}

std::optional<NdcDepth> MatrixTaker::depthOf(const PastedMatrix &pasted) const
{
    return pasted.ndcDepth ? pasted.ndcDepth : depth();
}

std::optional<NdcDepth> MatrixTaker::depth() const
{
    return conventionsOf(api()).hasOnlyThatDepth ? conventionsOf(api()).ndcDepth : m_options.depth;
}

void MatrixTaker::say(PastedPart part, const std::string &what) const
{
    complain(m_name + ": " + nameOf(part) + ": " + what);
}

bool MatrixTaker::lookAt(const PastedMatrix &pasted, PastedPart part, MatrixRole role,
                         const std::optional<glm::dmat4> &clipFromEye) const
{
    bool isReversed = false;
    if (pasted.isInverse)
        say(part, inverseText(pasted));
    if (!pasted.call.empty())
        say(part, pasted.call);
    for (const MatrixFinding &finding : findings(matrix(pasted, role), role, depthOf(pasted), clipFromEye)) {
        const bool isAboutDepth = finding.fault == MatrixFault::DepthReversed;
        isReversed = isReversed || isAboutDepth;
        if ((isAboutDepth && m_options.isReversed) || (finding.fault == MatrixFault::YDown && m_options.isYDown))
            continue;
        if (finding.fault == MatrixFault::Rounded && m_options.isOrthonormal)
            continue;
        say(part,
            taken(findingText(finding, role)) + adviceFor(finding, order(pasted), m_options.conventions.has_value()));
        if (finding.fault == MatrixFault::Scaled && m_options.isOrthonormal)
            say(part, tr(finding.repair == MatrixRepair::None
                             ? "--orthonormal is for rounded axes and would change "
                               "this camera; give the view without the model's scale"
                             : "--orthonormal removes the model's scale; near, far and eye coordinates stay unchanged, "
                               "so world coordinates are in eye units"));
    }
    return isReversed;
}

std::string MatrixTaker::taken(const std::string &finding) const
{
    return api() == Api::OpenGl
               ? finding
               : tr("converted from %1's conventions to OpenGL's, it %2", conventionsOf(api()).name, finding);
}

NumberOrder MatrixTaker::order(const PastedMatrix &pasted) const
{
    if (pasted.form == MatrixForm::Call)
        return NumberOrder::ByColumns;
    // Rows of row vectors are columns.
    const NumberOrder usual = conventionsOf(api()).areVectorsRows ? NumberOrder::ByColumns : orderOf(pasted.form);
    return m_options.order.value_or(pasted.order.value_or(usual));
}

} // namespace unprojector::cli
