#include "core/cameras/pasted_camera.h"

#include "core/base/translation.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/pasted_calls.h"
#include "core/cameras/pasted_numbers.h"
#include "core/cameras/told_order.h"
#include "core/geometry/condition_number.h"
#include "core/pipeline/printed_digits.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace unprojector::cameras {
using namespace geometry;
using namespace pipeline;

namespace {

constexpr std::size_t kEntries = 16;

PastedPart partOf(MatrixRole role)
{
    return role == MatrixRole::View         ? PastedPart::View
           : role == MatrixRole::Projection ? PastedPart::Projection
                                            : PastedPart::Product;
}

/// The parts of a text: its calls with the matrices beside them, or its matrices.
/// @param isViewportSet  becomes whether a call sets the viewport
Result<PastedScene, PasteError> partsOf(const std::string &text, bool &isViewportSet)
{
    const Result<PastedCalls, PasteError> calls = pastedCalls(text);
    if (!calls)
        return calls.error();
    if (calls->hasAny) {
        // Fewer numbers than a matrix has belong to other statements.
        const auto numbers = pastedNumbers(calls->rest);
        const bool hasMatrices = numbers && numbers->numbers.size() >= kEntries;
        const auto beside = hasMatrices ? pastedParts(calls->rest) : Result<PastedScene, PasteError>(PastedScene());
        if (!beside)
            return beside.error();
        PastedScene parts = *beside;
        isViewportSet = calls->parts.viewport.has_value();
        if (calls->parts.view)
            parts.view = calls->parts.view;
        if (calls->parts.projection)
            parts.projection = calls->parts.projection;
        if (isViewportSet)
            parts.viewport = calls->parts.viewport;
        return parts;
    }
    auto parts = pastedParts(text);
    if (parts && (parts->view || parts->modelView || parts->model || parts->projection || parts->product))
        return parts;
    const auto one = pastedMatrix(text);
    if (!one)
        return parts ? one.error() : parts.error();
    PastedScene alone;
    alone.modelView = *one;
    return alone;
}

/// Returns whether the last row is 0 0 0 w, up to rounding.
bool isAffine(const glm::dmat4 &m)
{
    constexpr double kZero = 1e-6;
    return std::max({std::abs(m[0][3]), std::abs(m[1][3]), std::abs(m[2][3])}) <= kZero * std::abs(m[3][3]);
}

/// Returns whether the matrix has a role's form in one of the orders of its numbers.
bool hasFormOf(const PastedMatrix &given, MatrixRole role)
{
    const auto fits = [&](NumberOrder order) {
        const glm::dmat4 m = meantMatrix(given, order);
        if (isSingular(m))
            return false;
        if (role == MatrixRole::View) {
            const glm::dmat3 axes(m / m[3][3]);
            const double scale = std::cbrt(std::abs(glm::determinant(axes)));
            constexpr double kPrinted = 0.02; // two printed decimals
            const glm::dmat3 squared = axes * glm::transpose(axes) / (scale * scale);
            return isAffine(m) && largestDifference(squared, glm::dmat3(1.0)) < kPrinted;
        }
        const std::vector<MatrixFinding> found = findings(m, role);
        return std::none_of(found.begin(), found.end(), [](const MatrixFinding &one) {
            return one.fault == MatrixFault::Transposed || one.fault == MatrixFault::UnknownForm
                   || one.fault == MatrixFault::Exchanged;
        });
    };
    const NumberOrder usual = orderOf(given.form);
    return fits(usual) || fits(opposite(usual));
}

/// The role of a matrix without a name.
MatrixRole roleByForm(const PastedMatrix &given)
{
    if (hasFormOf(given, MatrixRole::View)) {
        // An orthographic projection mirrors z, which no view does.
        const glm::dmat4 m = meantMatrix(given, orderOf(given.form));
        const bool isMirrored = glm::determinant(glm::dmat3(m)) < 0.0;
        return isMirrored && hasFormOf(given, MatrixRole::Projection) ? MatrixRole::Projection : MatrixRole::View;
    }
    for (const MatrixRole role : {MatrixRole::Projection, MatrixRole::Product}) {
        if (hasFormOf(given, role))
            return role;
    }
    const glm::dmat4 m = meantMatrix(given, orderOf(given.form));
    return isAffine(m) || isAffine(glm::transpose(m)) ? MatrixRole::View : MatrixRole::Product;
}

std::optional<Viewport> viewportIn(const PastedScene &parts)
{
    if (parts.viewport || !parts.viewportMatrix)
        return parts.viewport;
    const PastedMatrix &given = *parts.viewportMatrix;
    Viewport viewport = viewportOf(meantMatrix(given, orderOf(given.form)), {}).viewport;
    viewport.height = std::abs(viewport.height); // pixels may count from the top
    return viewport;
}

class Reader {
public:
    Reader(PastedCamera &camera, const PasteChoices &choices) : m_camera(camera), m_choices(choices) {}

    /// @return the error of a text without a matrix
    std::optional<PasteError> read(const std::string &text)
    {
        const auto read = partsOf(text, m_camera.isViewportSet);
        if (!read)
            return read.error();
        const PastedScene &parts = *read;
        choose(parts);
        m_camera.viewport = viewportIn(parts);
        m_camera.aside = parts.aside;
        tellOrders();
        correct();
        find();
        for (ReadMatrix &one : m_camera.matrices) {
            const auto &left = parts.inversesLeft;
            one.leavesInverse = std::any_of(left.begin(), left.end(), [&](PastedPart part) {
                return part == partOf(one.role) || (part == PastedPart::ModelView && one.role == MatrixRole::View);
            });
            take(one);
        }
        if (m_camera.matrices.empty() && !m_camera.isViewportSet)
            return countError(PastedPart::ModelView, 0, kEntries, 0);
        return std::nullopt;
    }

private:
    /// Takes the matrices that count, each in its role.
    void choose(const PastedScene &parts)
    {
        const auto &view = parts.view ? parts.view : parts.modelView ? parts.modelView : parts.model;
        add(parts.projection, MatrixRole::Projection);
        add(view, MatrixRole::View);
        add(parts.product, MatrixRole::Product);
        std::vector<ReadMatrix> &all = m_camera.matrices;
        if (all.size() == 2 && all[0].role == all[1].role) { // as glGet gives them
            all[0].role = MatrixRole::Projection;
            all[1].role = MatrixRole::View;
        }
        if (all.size() == 1 && !isNamed(all[0].given)) {
            ReadMatrix &one = all[0];
            m_camera.isRoleByForm = true;
            m_camera.isRoleOpen = one.role != MatrixRole::Product && hasFormOf(one.given, MatrixRole::View)
                                  && hasFormOf(one.given, MatrixRole::Projection);
        }
        if (all.size() == 1)
            all[0].role = m_choices.role.value_or(all[0].role);
        if (all.size() > 1 && parts.product) {
            const bool isProduct = all.size() == 2 && hasFormOf(*parts.product, MatrixRole::Product);
            std::erase_if(all, [&](const ReadMatrix &one) {
                const bool isLeft = (one.role == MatrixRole::Product) != isProduct;
                if (isLeft)
                    m_camera.unused.push_back(partOf(one.role));
                return isLeft;
            });
        }
        if (parts.model && view != parts.model)
            m_camera.unused.push_back(PastedPart::Model);
        if (has(MatrixRepair::Exchange)) {
            for (ReadMatrix &one : all)
                one.role = one.role == MatrixRole::View ? MatrixRole::Projection : MatrixRole::View;
        }
    }

    static bool isNamed(const PastedMatrix &given)
    {
        return given.form == MatrixForm::Call || (given.part && given.part != PastedPart::Model);
    }

    void add(const std::optional<PastedMatrix> &given, MatrixRole role)
    {
        if (given)
            m_camera.matrices.push_back({isNamed(*given) ? role : roleByForm(*given), *given});
    }

    /// Returns whether a correction counts that undoes itself, chosen again.
    bool has(MatrixRepair repair) const
    {
        const auto &all = m_choices.corrections;
        return std::count_if(all.begin(), all.end(), [&](const Correction &c) { return c.finding.repair == repair; })
                   % 2
               == 1;
    }

    ReadMatrix *of(MatrixRole role)
    {
        auto &all = m_camera.matrices;
        const auto found =
            std::find_if(all.begin(), all.end(), [&](const ReadMatrix &one) { return one.role == role; });
        return found == all.end() ? nullptr : &*found;
    }

    /// Sets the order of each matrix, and tells where the numbers give it.
    void tellOrders()
    {
        std::vector<BothOrders> both;
        std::vector<ReadMatrix *> numbers; // a call has no order
        for (ReadMatrix &one : m_camera.matrices) {
            one.order = orderOf(one.given.form);
            if (one.given.form == MatrixForm::Call)
                continue;
            numbers.push_back(&one);
            both.push_back({one.role, one.given.form, meantMatrix(one.given, one.order),
                            meantMatrix(one.given, opposite(one.order))});
        }
        const auto &size = m_camera.viewport;
        const std::vector<ToldOrder> told =
            toldOrders(both, size && size->height > 0.0 ? std::optional(size->width / size->height) : std::nullopt);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            ReadMatrix &one = *numbers[i];
            if (told[i] == ToldOrder::Other || told[i] == ToldOrder::OtherAsOthers)
                one.order = opposite(one.order);
            bool isChosen = false;
            for (const Correction &correction : m_choices.corrections) {
                if (correction.role != one.role || correction.finding.repair != MatrixRepair::OtherOrder)
                    continue;
                one.order = opposite(one.order);
                isChosen = true;
            }
            if (const auto finding = findingOf(told[i]); finding && !isChosen)
                one.findings.push_back(*finding);
        }
    }

    void correct()
    {
        for (ReadMatrix &one : m_camera.matrices) {
            one.matrix = meantMatrix(one.given, one.order);
            if (m_camera.isRoleByForm && one.role == MatrixRole::View && !isSingular(one.matrix)) {
                const CameraChoices &chosen = m_choices.camera;
                m_camera.openDirection = chosen.direction.value_or(PoseDirection::WorldToCamera);
                if (m_camera.openDirection == PoseDirection::CameraToWorld)
                    one.matrix = glm::inverse(one.matrix);
                one.matrix = glm::dmat4(eyeFromCamera(chosen.axes.value_or(EyeAxes::RightUpBack))) * one.matrix;
            }
            one.ndcDepth = one.given.ndcDepth;
            for (const auto &[role, finding] : m_choices.corrections) {
                if (finding.repair == MatrixRepair::DepthZeroToOne)
                    one.ndcDepth = NdcDepth::ZeroToOne;
                if (role == one.role && finding.repair != MatrixRepair::OtherOrder
                    && finding.repair != MatrixRepair::TurnEye)
                    one.matrix = repaired(one.matrix, finding);
            }
            if (m_choices.ndcDepth)
                one.ndcDepth = m_choices.ndcDepth;
        }
        ReadMatrix *projection = of(MatrixRole::Projection), *view = of(MatrixRole::View);
        if (projection && view && has(MatrixRepair::TurnEye))
            turnEye(projection->matrix, view->matrix);
        else if (projection && has(MatrixRepair::TurnEye))
            projection->matrix = repaired(projection->matrix, {MatrixFault::LeftHanded, MatrixRepair::TurnEye});
    }

    void find()
    {
        const ReadMatrix *projection = of(MatrixRole::Projection);
        for (ReadMatrix &one : m_camera.matrices) {
            const bool isBesideProjection = one.role == MatrixRole::View && projection;
            const std::vector<MatrixFinding> found =
                findings(one.matrix, one.role, one.role == MatrixRole::View ? std::nullopt : one.ndcDepth,
                         isBesideProjection ? std::optional(projection->matrix) : std::nullopt);
            one.findings.insert(one.findings.end(), found.begin(), found.end());
        }
    }

    void take(const ReadMatrix &one)
    {
        if (one.role == MatrixRole::View)
            m_camera.eyeFromWorld = one.matrix;
        else if (one.role == MatrixRole::Projection)
            m_camera.projection = MatrixProjection{one.matrix, one.ndcDepth};
        else if ((m_camera.apart = decomposed(one.matrix))) {
            m_camera.projection = MatrixProjection{m_camera.apart->clipFromEye, one.ndcDepth};
            m_camera.eyeFromWorld = m_camera.apart->eyeFromWorld;
        } else {
            m_camera.fault = base::Error{base::tr("it cannot be decomposed; give projection and view"), "product"};
        }
    }

    PastedCamera &m_camera;
    const PasteChoices &m_choices;
};

} // namespace

PastedCamera pastedCamera(std::span<const NamedText> texts, const PasteChoices &choices,
                          const std::optional<Box> &objects)
{
    PastedCamera camera;
    const auto read = readCamera(texts, choices.camera);
    if (read && *read) {
        camera.foreign = **read;
        const auto scene = sceneCamera(*camera.foreign, choices.camera, objects);
        if (!scene) {
            camera.fault = scene.error();
            return camera;
        }
        camera.scene = *scene;
        camera.projection = camera.scene->projection;
        camera.eyeFromWorld = camera.scene->eyeFromWorld;
        return camera;
    }
    if (read) {
        camera.fault = read->error();
        return camera;
    }
    std::string text;
    for (const NamedText &one : texts)
        text += (text.empty() ? "" : "\n") + one.text;
    const auto error = Reader(camera, choices).read(text);
    if (error)
        camera.fault = errorOf(*error);
    // Numbers without a name are of no part.
    if (error && error->found == error->all)
        camera.fault->subject.clear();
    return camera;
}

} // namespace unprojector::cameras
