#include "core/cameras/pasted_camera.h"

#include "core/base/text_scanner.h"
#include "core/base/translation.h"
#include "core/cameras/camera_matrices.h"
#include "core/cameras/camera_reader.h"
#include "core/cameras/pasted_calls.h"
#include "core/cameras/pasted_numbers.h"
#include "core/cameras/program_text.h"
#include "core/cameras/told_order.h"
#include "core/geometry/condition_number.h"
#include "core/pipeline/matrix_format.h"

#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace unprojector::cameras {
using namespace geometry;
using namespace pipeline;
using base::tr;

namespace {

constexpr std::size_t kEntries = 16;

/// The parts of a text: its calls with the matrices beside them, or its matrices.
/// @param isViewportSet  becomes whether a call sets the viewport
Result<PastedScene, PasteError> partsOf(const std::string &text, const std::optional<ImageSize> &size,
                                        bool &isViewportSet)
{
    const Result<PastedCalls, PasteError> calls =
        pastedCalls(text, size ? std::optional(double(size->width) / size->height) : std::nullopt);
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
            return isAffine(m) && areOrthonormal(axes / scale);
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

/// Returns whether a matrix only scales and moves, as one from NDC to the window does, in one of its orders.
bool isOfViewport(const PastedMatrix &given)
{
    const auto isIt = [&](NumberOrder order) {
        const glm::dmat4 m = meantMatrix(given, order);
        bool isDiagonal = isAffine(m);
        for (int i = 0; i < 9; ++i)
            isDiagonal = isDiagonal && (i / 3 == i % 3 || m[i / 3][i % 3] == 0.0);
        return isDiagonal;
    };
    return isIt(NumberOrder::ByRows) || isIt(NumberOrder::ByColumns);
}

/// The deviation of a matrix from any multiple of another one, relative to its largest entry; 1 where either is 0 or
/// beyond doubles.
double offUpToScale(const glm::dmat4 &given, const glm::dmat4 &other)
{
    const double ofGiven = largestEntry(given), ofOther = largestEntry(other);
    if (!(ofGiven > 0.0 && ofOther > 0.0 && std::isfinite(ofGiven) && std::isfinite(ofOther)))
        return 1.0;
    const glm::dmat4 a = given / ofGiven, b = other / ofOther;
    double ab = 0.0, bb = 0.0, off = 0.0;
    for (int i = 0; i < 16; ++i) {
        ab += a[i / 4][i % 4] * b[i / 4][i % 4];
        bb += b[i / 4][i % 4] * b[i / 4][i % 4];
    }
    for (int i = 0; i < 16; ++i)
        off = std::max(off, std::abs(a[i / 4][i % 4] - ab / bb * b[i / 4][i % 4]));
    return off;
}

constexpr double kSame = 1e-3; // the error of three printed digits

class Reader {
public:
    Reader(PastedCamera &camera, const PasteChoices &choices) : m_camera(camera), m_choices(choices) {}

    /// @return the error of a text without a matrix, or of one that is needed and missing
    std::optional<PasteError> read(const std::string &text)
    {
        const auto read = partsOf(text, m_choices.camera.size, m_camera.isViewportSet);
        if (!read) {
            m_camera.hasNumbers = read.error().all > 0 || read.error().line > 0 || read.error().isOfCall;
            return read.error();
        }
        const PastedScene &parts = *read;
        for (const auto &[given, part] :
             {std::pair(&parts.projection, PastedPart::Projection), std::pair(&parts.view, PastedPart::View),
              std::pair(&parts.modelView, PastedPart::ModelView), std::pair(&parts.product, PastedPart::Product),
              std::pair(&parts.model, PastedPart::Model)})
            add(*given, part);
        const bool isViewport =
            !parts.viewportMatrix || parts.viewportMatrix->part || isOfViewport(*parts.viewportMatrix);
        if (!isViewport)
            addThird(*parts.viewportMatrix);
        if (m_choices.isScene && !m_choices.areMatrices && areAnyNumbers()) {
            m_camera.matrices.clear();
            return PasteError{.text = tr("the numbers have no names, and none of their matrices is a view or a "
                                         "projection; write modelview, projection and viewport before the numbers")};
        }
        choose();
        m_camera.aside = parts.aside;
        readViewport(parts, isViewport);
        if (m_choices.isScene) {
            if (const auto missing = missingPart())
                return countError(*missing, 0, *missing == PastedPart::Viewport ? 4 : kEntries, 0);
        }
        tellOrders();
        correct();
        find();
        for (const ReadMatrix &one : m_camera.matrices)
            take(one);
        noteIgnored(parts);
        noteAspect();
        if (m_camera.matrices.empty() && !m_camera.isViewportSet)
            return countError(PastedPart::ModelView, 0, kEntries, 0);
        return std::nullopt;
    }

private:
    void add(const std::optional<PastedMatrix> &given, PastedPart part)
    {
        if (!given)
            return;
        const MatrixRole role = part == PastedPart::Projection ? MatrixRole::Projection
                                : part == PastedPart::Product  ? MatrixRole::Product
                                                               : MatrixRole::View;
        const bool isGiven = isNamed(*given) || (m_choices.isScene && part == PastedPart::Product);
        m_camera.matrices.push_back({part, isGiven ? role : roleByForm(*given), *given});
    }

    static bool isNamed(const PastedMatrix &given)
    {
        return given.form == MatrixForm::Call || (given.part && given.part != PastedPart::Model);
    }

    /// Returns whether neither a name nor a form tells that the numbers are matrices of a camera.
    bool areAnyNumbers() const
    {
        return std::ranges::none_of(m_camera.matrices, [](const ReadMatrix &one) {
            return isNamed(one.given) || hasFormOf(one.given, MatrixRole::View)
                   || hasFormOf(one.given, MatrixRole::Projection) || hasFormOf(one.given, MatrixRole::Product);
        });
    }

    void note(PastedPart part, const std::string &what) { m_camera.notes.push_back(nameOf(part) + (": " + what)); }

    /// Moves a matrix to those that are ignored.
    void leave(const ReadMatrix *one)
    {
        m_ignored.push_back(*one);
        m_camera.matrices.erase(m_camera.matrices.begin() + (one - m_camera.matrices.data()));
    }

    ReadMatrix *of(PastedPart part)
    {
        const auto found = std::ranges::find(m_camera.matrices, part, &ReadMatrix::part);
        return found == m_camera.matrices.end() ? nullptr : &*found;
    }

    ReadMatrix *of(MatrixRole role)
    {
        const auto found = std::ranges::find(m_camera.matrices, role, &ReadMatrix::role);
        return found == m_camera.matrices.end() ? nullptr : &*found;
    }

    /// Keeps the matrices that count, each in its role.
    void choose()
    {
        std::vector<ReadMatrix> &all = m_camera.matrices;
        const ReadMatrix *model = of(PastedPart::Model);
        if (model && (m_choices.isScene || of(PastedPart::View) || of(PastedPart::ModelView)))
            leave(model);
        if (of(PastedPart::View) && of(PastedPart::ModelView))
            leave(of(PastedPart::ModelView));
        if (all.size() == 2 && all[0].role == all[1].role) { // as glGet gives them
            if (hasFormOf(all[0].given, MatrixRole::View) && !hasFormOf(all[0].given, MatrixRole::Projection)) {
                leave(all.data());
            } else {
                all[0].role = MatrixRole::Projection;
                all[1].role = MatrixRole::View;
            }
        }
        for (const ReadMatrix &one : all) {
            if (all.size() > 1 && one.part == PastedPart::ModelView && one.role == MatrixRole::Projection)
                note(one.part, tr("it has no name and the form of a projection, and is read as the projection"));
        }
        if (all.size() == 1 && !isNamed(all[0].given)) {
            ReadMatrix &one = all[0];
            m_camera.isRoleByForm = true;
            m_camera.isRoleOpen = one.role != MatrixRole::Product && hasFormOf(one.given, MatrixRole::View)
                                  && hasFormOf(one.given, MatrixRole::Projection);
        }
        if (all.size() == 1)
            all[0].role = m_choices.role.value_or(all[0].role);
        if (m_choices.isScene && all.size() == 1 && all[0].part == PastedPart::ModelView
            && !hasFormOf(all[0].given, MatrixRole::Product))
            all[0].role = MatrixRole::View;
        if (const ReadMatrix *product = of(PastedPart::Product); product && all.size() > 1) {
            const bool isProduct =
                all.size() == 2 && (m_choices.isScene || hasFormOf(product->given, MatrixRole::Product));
            if (isProduct)
                leave(product == all.data() ? &all[1] : all.data());
            else
                leave(product);
        }
        if (has(MatrixRepair::Exchange)) {
            for (ReadMatrix &one : all)
                one.role = one.role == MatrixRole::View ? MatrixRole::Projection : MatrixRole::View;
        }
    }

    /// Adds an unnamed matrix behind two others: the projection if the second has no form of one, else a product.
    void addThird(const PastedMatrix &given)
    {
        ReadMatrix *second = of(PastedPart::Projection);
        const bool isLens = second && !isNamed(second->given) && second->role == MatrixRole::View
                            && roleByForm(given) == MatrixRole::Projection;
        if (isLens) {
            m_ignored.push_back(*second);
            m_ignored.back().part = PastedPart::ModelView;
            *second = {PastedPart::Projection, MatrixRole::Projection, given};
        } else {
            m_camera.matrices.push_back({PastedPart::Product, MatrixRole::Product, given});
        }
    }

    void readViewport(const PastedScene &parts, bool isViewport)
    {
        m_camera.viewport = parts.viewport;
        if (parts.viewportMatrix && isViewport)
            m_camera.viewportMatrix = ReadMatrix{PastedPart::Viewport, MatrixRole::View, *parts.viewportMatrix};
        const auto &size = m_choices.camera.size;
        if (m_choices.isScene && size && !m_camera.viewport && !m_camera.viewportMatrix)
            m_camera.viewport = Viewport{0.0, 0.0, double(size->width), double(size->height)};
    }

    std::optional<PastedPart> missingPart()
    {
        if (!of(MatrixRole::Product)) {
            if (!of(MatrixRole::View))
                return PastedPart::ModelView;
            if (!of(MatrixRole::Projection))
                return PastedPart::Projection;
        }
        return m_camera.viewport || m_camera.viewportMatrix ? std::nullopt : std::optional(PastedPart::Viewport);
    }

    /// Returns whether a correction counts that undoes itself, chosen again.
    bool has(MatrixRepair repair) const
    {
        const auto &all = m_choices.corrections;
        return std::ranges::count_if(all, [&](const Correction &c) { return c.finding.repair == repair; }) % 2 == 1;
    }

    /// The matrix in an order, in OpenGL's conventions.
    glm::dmat4 converted(const ReadMatrix &one, NumberOrder order) const
    {
        const Api api = m_choices.conventions;
        const glm::dmat4 given = meantMatrix(one.given, order);
        if (one.given.form == MatrixForm::Call || one.part == PastedPart::Viewport) // a call has OpenGL's eye already
            return given;
        switch (one.role) {
        case MatrixRole::View: return oursFromView(given, api);
        case MatrixRole::Projection: return oursFromApi({given, {}}, api).clipFromEye;
        case MatrixRole::Product: break;
        }
        // The eye space between the two may look either way.
        return oursFromApi({given * viewFromOurs(glm::dmat4(1.0), api), {}}, api).clipFromEye;
    }

    /// Sets the order of each matrix, and tells where the numbers give it.
    void tellOrders()
    {
        std::vector<BothOrders> both;
        std::vector<ReadMatrix *> numbers; // a call has no order
        const auto look = [&](ReadMatrix &one) {
            // Rows of row vectors are columns.
            const bool areRows = conventionsOf(m_choices.conventions).areVectorsRows;
            one.order = areRows ? NumberOrder::ByColumns : orderOf(one.given.form);
            if (one.given.form == MatrixForm::Call)
                return;
            one.order = m_choices.order.value_or(one.order);
            numbers.push_back(&one);
            both.push_back({one.role, one.given.form, converted(one, one.order), converted(one, opposite(one.order))});
        };
        std::ranges::for_each(m_camera.matrices, look);
        std::ranges::for_each(m_ignored, look);
        if (m_camera.viewportMatrix)
            look(*m_camera.viewportMatrix);
        std::optional<Viewport> size = m_camera.viewport;
        if (m_camera.viewportMatrix)
            size = viewportOf(*m_camera.viewportMatrix).viewport;
        const std::vector<ToldOrder> told = toldOrders(
            both, size && size->height != 0.0 ? std::optional(size->width / std::abs(size->height)) : std::nullopt);
        for (std::size_t i = 0; i < numbers.size() && !m_choices.order; ++i) {
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
        if (m_camera.viewportMatrix) {
            const auto &[viewport, depthRange] = viewportOf(*m_camera.viewportMatrix);
            m_camera.viewport = viewport;
            m_camera.depthRange = depthRange;
        }
    }

    /// The viewport and the depth range of a matrix from NDC to the window. Where pixels count from the top, y is 0 at
    /// the top.
    ViewportAndDepths viewportOf(const ReadMatrix &one) const
    {
        const ApiConventions &api = conventionsOf(m_choices.conventions);
        const ApiSpaces spaces = apiSpaces(Setup(), m_choices.conventions); // the window's height is not known: 0
        AxisChange window = spaces.window;
        window.scale.z = 1.0;
        window.shift.z = 0.0;
        ViewportAndDepths result =
            cameras::viewportOf(window.inverse().matrix() * meantMatrix(one.given, one.order) * spaces.clip.matrix(),
                                api.hasOnlyThatDepth ? NdcDepth::MinusOneToOne : m_choices.ndcDepth);
        if (api.isDepthReversed)
            std::swap(result.depthRange.atNear, result.depthRange.atFar);
        return result;
    }

    void correct()
    {
        const ApiConventions &api = conventionsOf(m_choices.conventions);
        for (ReadMatrix &one : m_camera.matrices) {
            one.matrix = converted(one, one.order);
            if (m_camera.isRoleByForm && one.role == MatrixRole::View && !isSingular(one.matrix)) {
                const CameraChoices &chosen = m_choices.camera;
                m_camera.openDirection = chosen.direction.value_or(PoseDirection::WorldToCamera);
                if (m_camera.openDirection == PoseDirection::CameraToWorld)
                    one.matrix = glm::inverse(one.matrix);
                one.matrix = glm::dmat4(eyeFromCamera(chosen.axes.value_or(EyeAxes::RightUpBack))) * one.matrix;
            }
            one.ndcDepth = one.given.ndcDepth;
            if (!one.ndcDepth && api.hasOnlyThatDepth)
                one.ndcDepth = api.ndcDepth;
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
        } else if (m_choices.isScene) {
            m_camera.projection = MatrixProjection{one.matrix, one.ndcDepth};
            m_camera.eyeFromWorld = glm::dmat4(1.0);
        } else {
            m_camera.fault = base::Error{tr("it cannot be decomposed; give projection and view"), "product"};
        }
    }

    /// Says where the projection of a call stretches the picture.
    void noteAspect()
    {
        const ReadMatrix *one = of(MatrixRole::Projection);
        const auto &viewport = m_camera.viewport;
        if (!one || one->given.form != MatrixForm::Call || !viewport || !(viewport->height > 0.0)
            || one->matrix[0][0] == 0.0)
            return;
        constexpr double kVisible = 0.01;
        const double aspect = std::abs(one->matrix[1][1] / one->matrix[0][0]),
                     ofSize = viewport->width / viewport->height;
        if (std::abs(aspect / ofSize - 1.0) > kVisible)
            note(one->part, tr("its aspect is %1, and that of the size is %2: the picture is stretched",
                               numberText(aspect, Digits::Double, 4), numberText(ofSize, Digits::Double, 4)));
    }

    /// Says which matrices of the text do not count, and whether they contradict those that do.
    void noteIgnored(const PastedScene &parts)
    {
        for (const ReadMatrix &one : m_ignored) {
            const ReadMatrix *view = of(MatrixRole::View);
            if (one.part == PastedPart::Model)
                note(one.part, tr("ignored: world coordinates do not need it"));
            else if (one.part == PastedPart::Product && view && of(MatrixRole::Projection))
                note(one.part, tr("ignored, because the projection and the %1 are given", nameOf(view->part))
                                   + contradiction(one));
            else if (one.part == PastedPart::Product)
                note(one.part, tr("ignored: it does not have the form of a product"));
            else if (one.role == MatrixRole::View && view)
                note(one.part, tr("ignored, because the view is given"));
            else
                noteBesideProduct(one);
        }
        for (const PastedPart part : parts.inversesLeft)
            note(part, tr("its inverse is ignored, because the needed matrices are given"));
        for (const PastedPart part : parts.more)
            note(part, tr("there are several; the first one is used"));
    }

    void noteBesideProduct(const ReadMatrix &one)
    {
        const bool isProjection = one.role == MatrixRole::Projection;
        const auto &apart = m_camera.apart;
        const bool isSame =
            apart
            && offUpToScale(isProjection ? apart->clipFromEye : apart->eyeFromWorld, converted(one, one.order))
                   <= kSame;
        note(one.part, tr(isProjection ? "ignored without a view: only the product counts"
                                       : "ignored without a projection: only the product counts")
                           + (isSame || !apart ? "" : tr(", and it differs from the product's")));
    }

    /// The contradiction between an ignored product and the given projection and view; empty if they agree.
    std::string contradiction(const ReadMatrix &ofProduct)
    {
        const auto asGiven = [](const ReadMatrix &one) { return meantMatrix(one.given, one.order); };
        const glm::dmat4 product = asGiven(ofProduct), lens = asGiven(*of(MatrixRole::Projection));
        if (largestEntry(product) == 0.0)
            return tr(", and it is not their product, but all zeros");
        glm::dmat4 model(1.0);
        std::vector<glm::dmat4> views{asGiven(*of(MatrixRole::View))};
        for (const ReadMatrix &one : m_ignored) {
            if (one.part == PastedPart::Model)
                model = asGiven(one);
            else if (one.part == PastedPart::ModelView)
                views.push_back(asGiven(one));
        }
        double off = std::numeric_limits<double>::infinity();
        for (const glm::dmat4 &view : views) { // any of them may be in the wrong order, which another message reports
            for (const glm::dmat4 &other : {lens * view, view * lens, lens * view * model, model * view * lens})
                off = std::min(off, offUpToScale(product, other));
        }
        return off <= kSame ? ""
                            : tr(", and it differs from their product by %1 of its largest entry: one of them is of "
                                 "another setup, or contains an object's matrix",
                                 numberText(off, Digits::Double, 2));
    }

    PastedCamera &m_camera;
    const PasteChoices &m_choices;
    std::vector<ReadMatrix> m_ignored;
};

/// The error of texts that are none.
std::optional<base::Error> faultOfBytes(std::span<const NamedText> texts)
{
    for (const NamedText &one : texts) {
        if (base::trimmed(one.text).empty())
            return base::Error{.text = tr("it is empty"), .file = one.name};
        if (one.text.find('\0') != one.text.npos)
            return base::Error{.text = tr("it has zero bytes, which no text has; save it as UTF-8"), .file = one.name};
    }
    return std::nullopt;
}

} // namespace

PastedCamera pastedCamera(std::span<const NamedText> given, const PasteChoices &choices,
                          const std::optional<Box> &objects)
{
    PastedCamera camera;
    std::vector<NamedText> texts(given.begin(), given.end());
    for (NamedText &one : texts)
        one.text = withValues(std::move(one.text));
    const auto read = choices.areMatrices ? std::nullopt : readCamera(texts, choices.camera);
    camera.isProgram = read.has_value();
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
    if (const auto fault = faultOfBytes(texts)) {
        camera.fault = *fault;
        return camera;
    }
    std::string text;
    for (const NamedText &one : texts)
        text += (text.empty() ? "" : "\n") + one.text;
    const auto error = Reader(camera, choices).read(text);
    if (error)
        camera.fault = errorOf(*error);
    // Numbers without a name are of no part.
    if (error && error->found == error->all && camera.matrices.empty())
        camera.fault->subject.clear();
    return camera;
}

} // namespace unprojector::cameras
