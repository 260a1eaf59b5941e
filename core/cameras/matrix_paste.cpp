#include "core/cameras/matrix_paste.h"

#include "core/cameras/pasted_calls.h"
#include "core/cameras/pasted_numbers.h"

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using namespace geometry;
using namespace pipeline;

namespace {

constexpr std::size_t kEntries = 16;
constexpr std::array kRoles{MatrixRole::View, MatrixRole::Projection, MatrixRole::Product};

const std::optional<PastedMatrix> &partOf(const PastedScene &parts, MatrixRole role)
{
    switch (role) {
    case MatrixRole::View: return parts.view ? parts.view : parts.modelView;
    case MatrixRole::Projection: return parts.projection;
    case MatrixRole::Product: break;
    }
    return parts.product;
}

/// The role that a text's parts belong to, if `role` has none of them.
std::optional<MatrixRole> roleElsewhere(const PastedScene &parts, MatrixRole role)
{
    const bool hasProjection = bool(parts.projection), hasView = bool(partOf(parts, MatrixRole::View));
    if (role != MatrixRole::Product)
        return parts.product && !hasProjection && !hasView ? std::optional(MatrixRole::Product) : std::nullopt;
    if (parts.product || (!hasProjection && !hasView))
        return std::nullopt;
    return hasProjection ? MatrixRole::Projection : MatrixRole::View;
}

} // namespace

void MatrixPaste::setText(MatrixRole role, std::string_view text)
{
    take(role, text);
    tellOrders();
}

void MatrixPaste::tellOrders()
{
    std::vector<MatrixRole> roles;
    std::vector<BothOrders> both;
    for (const MatrixRole role : kRoles) {
        place(role).told = ToldOrder::Usual;
        const PastedMatrix *matrix = pasted(role);
        if (!matrix || matrix->form == MatrixForm::Call) // a call has no order of numbers
            continue;
        const NumberOrder usual = orderOf(matrix->form);
        roles.push_back(role);
        both.push_back({role, matrix->form, meantMatrix(*matrix, usual), meantMatrix(*matrix, opposite(usual))});
    }
    const std::optional<Viewport> size = viewport();
    const std::vector<ToldOrder> told =
        toldOrders(both, size && size->height > 0.0 ? std::optional(size->width / size->height) : std::nullopt);
    for (std::size_t i = 0; i < roles.size(); ++i)
        place(roles[i]).told = told[i];
}

void MatrixPaste::take(MatrixRole role, std::string_view text)
{
    Place &here = place(role);
    here = {};
    // Another role took its matrix from the old text; its repairs no longer apply.
    for (const MatrixRole other : kRoles) {
        if (place(other).isBlank)
            place(other) = {};
    }
    here.isBlank = text.find_first_not_of(" \t\r\n") == text.npos;
    if (here.isBlank)
        return;
    if (!takeCalls(role, text))
        takeNumbers(role, text);
    if (!here.named)
        here.named = roleElsewhere(here.parts, role);
}

void MatrixPaste::takeNumbers(MatrixRole role, std::string_view text)
{
    Place &here = place(role);
    if (const auto one = pastedMatrix(text)) {
        here.own = *one;
        const auto numbers = pastedNumbers(text);
        if (numbers)
            here.parts.aside = numbers->aside;
        const bool isProduct = numbers && numbers->numbers.front().part == PastedPart::Product;
        if (isProduct && role != MatrixRole::Product)
            here.named = MatrixRole::Product;
        return;
    }
    const PasteError error = pastedMatrix(text).error();
    if (error.all <= error.wanted) {
        here.error = error;
        return;
    }
    const auto parts = pastedParts(text);
    if (!parts) {
        here.error = parts.error();
        return;
    }
    here.parts = *parts;
    here.own = partOf(*parts, role);
    // A single matrix beside a viewport takes the role that it was pasted into.
    const bool isAlone =
        std::count_if(kRoles.begin(), kRoles.end(), [&](MatrixRole r) { return bool(partOf(*parts, r)); }) == 1;
    if (!here.own && isAlone && !parts->model)
        here.own = parts->product      ? parts->product
                   : parts->projection ? parts->projection
                                       : partOf(*parts, MatrixRole::View);
    if (!here.own) {
        here.error = countError(role == MatrixRole::View         ? PastedPart::View
                                : role == MatrixRole::Projection ? PastedPart::Projection
                                                                 : PastedPart::Product,
                                0, kEntries, error.all);
    }
}

bool MatrixPaste::takeCalls(MatrixRole role, std::string_view text)
{
    const Result<PastedCalls, PasteError> calls = pastedCalls(text);
    Place &here = place(role);
    if (!calls) {
        here.error = calls.error();
        return true;
    }
    if (!calls->hasAny)
        return false;
    here.parts = calls->parts;
    here.hasCalls = true;
    // Matrices may accompany the calls; fewer numbers belong to other statements.
    if (const auto numbers = pastedNumbers(calls->rest); numbers && numbers->numbers.size() >= kEntries) {
        const auto beside = pastedParts(calls->rest);
        if (!beside) {
            here.error = beside.error();
            return true;
        }
        PastedScene parts = *beside;
        if (here.parts.view)
            parts.view = here.parts.view;
        if (here.parts.projection)
            parts.projection = here.parts.projection;
        if (here.parts.viewport)
            parts.viewport = here.parts.viewport;
        here.parts = parts;
    }
    here.own = partOf(here.parts, role);
    return true;
}

const PastedMatrix *MatrixPaste::pasted(MatrixRole role) const
{
    const Place &here = place(role);
    if (!here.isBlank && (here.own || !here.hasCalls))
        return here.own ? &*here.own : nullptr;
    for (const MatrixRole other : kRoles) {
        // A product is only used if it is requested.
        const bool isOther = other != role && (other == MatrixRole::Product) == (role == MatrixRole::Product);
        if (isOther && partOf(place(other).parts, role))
            return &*partOf(place(other).parts, role);
    }
    return nullptr;
}

bool MatrixPaste::leavesInverseOut(MatrixRole role) const
{
    const auto isOfRole = [role](PastedPart part) {
        return role == MatrixRole::View         ? part == PastedPart::View || part == PastedPart::ModelView
               : role == MatrixRole::Projection ? part == PastedPart::Projection
                                                : part == PastedPart::Product;
    };
    return pasted(role) && std::any_of(m_places.begin(), m_places.end(), [&](const Place &one) {
               const bool isSource = &one == &place(role) || (place(role).isBlank && partOf(one.parts, role));
               return isSource && std::any_of(one.parts.inversesLeft.begin(), one.parts.inversesLeft.end(), isOfRole);
           });
}

std::optional<Viewport> MatrixPaste::viewport() const
{
    for (const Place &one : m_places) {
        if (one.parts.viewport)
            return one.parts.viewport;
        if (const auto &given = one.parts.viewportMatrix) {
            Viewport viewport = viewportOf(meantMatrix(*given, orderOf(given->form)), {}).viewport;
            viewport.height = std::abs(viewport.height); // pixels may count from the top
            return viewport;
        }
    }
    return std::nullopt;
}

NumberOrder MatrixPaste::order(MatrixRole role) const
{
    const PastedMatrix *matrix = pasted(role);
    const NumberOrder usual = matrix ? orderOf(matrix->form) : NumberOrder::ByColumns;
    const ToldOrder told = place(role).told;
    const bool isOther = told == ToldOrder::Other || told == ToldOrder::OtherAsOthers;
    return place(role).order.value_or(isOther ? opposite(usual) : usual);
}

void MatrixPaste::setOrder(MatrixRole role, NumberOrder order)
{
    place(role).order = order;
}

void MatrixPaste::setNdcDepth(MatrixRole role, const std::optional<NdcDepth> &depth)
{
    place(role).ndcDepth = depth;
    std::erase_if(place(role).repairs,
                  [](const MatrixFinding &done) { return done.repair == MatrixRepair::DepthZeroToOne; });
}

void MatrixPaste::repair(MatrixRole role, const MatrixFinding &finding)
{
    if (finding.repair == MatrixRepair::OtherOrder)
        setOrder(role, opposite(order(role)));
    else if (finding.repair == MatrixRepair::DepthZeroToOne)
        place(role).ndcDepth = NdcDepth::ZeroToOne;
    else if (finding.repair == MatrixRepair::None || finding.repair == MatrixRepair::Exchange)
        return;
    place(role).repairs.push_back(finding);
}

void MatrixPaste::takeBack(MatrixRole role)
{
    place(role).order.reset();
    place(role).ndcDepth.reset();
    place(role).repairs.clear();
}

bool MatrixPaste::hasRepair(MatrixRole role, MatrixRepair repair) const
{
    const auto &repairs = place(role).repairs;
    return std::any_of(repairs.begin(), repairs.end(), [repair](const auto &done) { return done.repair == repair; });
}

std::optional<glm::dmat4> MatrixPaste::unturned(MatrixRole role) const
{
    const PastedMatrix *given = pasted(role);
    if (!given)
        return std::nullopt;
    glm::dmat4 matrix = meantMatrix(*given, order(role));
    for (const MatrixFinding &done : place(role).repairs) {
        if (done.repair != MatrixRepair::OtherOrder && done.repair != MatrixRepair::TurnEye)
            matrix = repaired(matrix, done);
    }
    return matrix;
}

std::optional<glm::dmat4> MatrixPaste::matrix(MatrixRole role) const
{
    std::optional<glm::dmat4> matrix = unturned(role);
    if (!matrix || role == MatrixRole::Product || !hasRepair(MatrixRole::Projection, MatrixRepair::TurnEye))
        return matrix;
    auto projection = unturned(MatrixRole::Projection), view = unturned(MatrixRole::View);
    if (!projection || !view)
        return role == MatrixRole::Projection ? repaired(*matrix, {MatrixFault::LeftHanded, MatrixRepair::TurnEye})
                                              : matrix;
    turnEye(*projection, *view);
    return role == MatrixRole::Projection ? projection : view;
}

std::vector<MatrixFinding> MatrixPaste::findings(MatrixRole role) const
{
    const auto here = matrix(role);
    if (!here)
        return {};
    std::vector<MatrixFinding> found = pipeline::findings(
        *here, role, ndcDepth(role), role == MatrixRole::View ? matrix(MatrixRole::Projection) : std::nullopt);
    const std::optional<MatrixFinding> told = place(role).order ? std::nullopt : findingOf(place(role).told);
    if (told)
        found.insert(found.begin(), *told);
    return found;
}

MatrixPaste::Camera MatrixPaste::camera() const
{
    Camera camera;
    if (const auto projection = matrix(MatrixRole::Projection))
        camera.projection = MatrixProjection{*projection, ndcDepth(MatrixRole::Projection)};
    camera.eyeFromWorld = matrix(MatrixRole::View);
    for (const MatrixRole role : {MatrixRole::Projection, MatrixRole::View}) {
        if (place(role).hasCalls && place(role).parts.viewport && !camera.viewport)
            camera.viewport = place(role).parts.viewport;
    }
    return camera;
}

std::optional<NdcDepth> MatrixPaste::ndcDepth(MatrixRole role) const
{
    const PastedMatrix *matrix = pasted(role);
    return place(role).ndcDepth || !matrix ? place(role).ndcDepth : matrix->ndcDepth;
}

std::optional<Decomposition> MatrixPaste::apart() const
{
    const auto product = matrix(MatrixRole::Product);
    return product ? decomposed(*product) : std::nullopt;
}

} // namespace unprojector::cameras
