#pragma once

#include "core/cameras/pasted_matrix.h"
#include "core/cameras/told_order.h"
#include "core/geometry/setup.h"
#include "core/pipeline/decomposition.h"
#include "core/pipeline/matrix_findings.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// The state of pasting matrices: a text for each of the three roles, its interpretation, its
/// findings and the chosen repairs. A text with several matrices fills the roles whose own text is
/// empty.
class MatrixPaste {
public:
    /// Sets a role's text. Drops the repairs of the matrices that the text gives.
    void setText(pipeline::MatrixRole role, std::string_view text);

    /// The error of a role's text if it gives no matrix for it; nothing for a blank text.
    const std::optional<PasteError> &error(pipeline::MatrixRole role) const { return place(role).error; }
    /// The role that the names in a text point to, if it differs: a product among projection and
    /// view, or the reverse.
    std::optional<pipeline::MatrixRole> namedRole(pipeline::MatrixRole role) const { return place(role).named; }
    /// The matrix as pasted, from its own text or from another role's.
    const PastedMatrix *pasted(pipeline::MatrixRole role) const;
    /// Returns whether the text also has the inverse, which is ignored.
    bool leavesInverseOut(pipeline::MatrixRole role) const;
    /// Names in the role's own text whose numbers belong to no matrix: "near", "Mouse".
    const std::vector<std::string> &aside(pipeline::MatrixRole role) const { return place(role).parts.aside; }
    /// A viewport in the texts. A camera takes it only from a call, see camera().
    std::optional<geometry::Viewport> viewport() const;

    /// The order that the user chose, else the one derived from the numbers, else the form's.
    NumberOrder order(pipeline::MatrixRole role) const;
    void setOrder(pipeline::MatrixRole role, NumberOrder order);
    /// Sets the NDC depths that the numbers of a projection or a product leave open; none: derived
    /// from the numbers.
    void setNdcDepth(pipeline::MatrixRole role, const std::optional<geometry::NdcDepth> &depth);
    /// Applies the repair that a finding offers. Exchange is not applied here, since it affects the
    /// texts.
    void repair(pipeline::MatrixRole role, const pipeline::MatrixFinding &finding);
    /// Removes all repairs, so that the matrix is as pasted.
    void takeBack(pipeline::MatrixRole role);
    /// The applied repairs, in this order.
    const std::vector<pipeline::MatrixFinding> &repairs(pipeline::MatrixRole role) const { return place(role).repairs; }

    /// The matrix in the chosen order and with the chosen repairs; nothing without one.
    std::optional<glm::dmat4> matrix(pipeline::MatrixRole role) const;
    /// The findings of the matrix in its current state.
    std::vector<pipeline::MatrixFinding> findings(pipeline::MatrixRole role) const;
    /// The NDC depths of the projection or the product: the chosen ones, else the API's if it comes
    /// from a call; none: derived from the numbers.
    std::optional<geometry::NdcDepth> ndcDepth(pipeline::MatrixRole role) const;

    /// The camera that a scene takes from the paste.
    struct Camera {
        std::optional<geometry::Lens> projection;
        std::optional<glm::dmat4> eyeFromWorld;
        std::optional<geometry::Viewport> viewport; ///< of a call
        bool isAnything() const { return projection || eyeFromWorld || viewport; }
    };
    /// The available parts of projection and view.
    Camera camera() const;
    /// The decomposition of the product; nothing without a product, or if it cannot be decomposed.
    std::optional<pipeline::Decomposition> apart() const;

private:
    struct Place {
        bool isBlank = true;
        bool hasCalls = false;                     ///< in the text
        std::optional<pipeline::MatrixRole> named; ///< see namedRole
        std::optional<PasteError> error;
        PastedScene parts;
        std::optional<PastedMatrix> own;
        std::optional<NumberOrder> order;  ///< none: derived
        ToldOrder told = ToldOrder::Usual; ///< of the matrix of this role, whichever text it is in
        std::vector<pipeline::MatrixFinding> repairs;
        std::optional<geometry::NdcDepth> ndcDepth;
    };
    Place &place(pipeline::MatrixRole role) { return m_places[std::size_t(role)]; }
    const Place &place(pipeline::MatrixRole role) const { return m_places[std::size_t(role)]; }
    void take(pipeline::MatrixRole role, std::string_view text);
    void takeNumbers(pipeline::MatrixRole role, std::string_view text);
    /// @return whether the text has calls
    bool takeCalls(pipeline::MatrixRole role, std::string_view text);
    void tellOrders();
    bool hasRepair(pipeline::MatrixRole role, pipeline::MatrixRepair repair) const;
    /// The matrix before TurnEye, which changes projection and view together.
    std::optional<glm::dmat4> unturned(pipeline::MatrixRole role) const;

    std::array<Place, 3> m_places;
};

} // namespace unprojector::cameras
