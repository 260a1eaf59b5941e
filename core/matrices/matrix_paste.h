#pragma once

#include "core/geometry/matrix_projection.h"
#include "core/matrices/decomposition.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/pasted_matrix.h"
#include "core/matrices/told_order.h"

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// Matrices while they are being pasted: a text for each of the three, how it is read, what is to be seen of it, and the
/// repairs that were chosen. A text that has several matrices fills the places of those whose own text is empty.
class MatrixPaste {
public:
    /// Forgets the repairs of what the text gives.
    void setText(MatrixRole role, std::string_view text);

    /// Why the text of a role gives no matrix of it; nothing where it is blank.
    const std::optional<PasteError> &error(MatrixRole role) const { return place(role).error; }
    /// Where a text belongs by its names, if that is elsewhere: a product among projection and view, or the reverse.
    std::optional<MatrixRole> namedRole(MatrixRole role) const { return place(role).named; }
    /// As it was pasted, in its own text or in another one's.
    const PastedMatrix *pasted(MatrixRole role) const;
    /// Whether the inverse stands beside it, and is left out.
    bool leavesInverseOut(MatrixRole role) const;
    /// A viewport that stands beside the matrices. Only that of a call is taken, see camera().
    std::optional<geometry::Viewport> viewport() const;

    /// The order that is set, else told by the numbers, else that of the form.
    NumberOrder order(MatrixRole role) const;
    void setOrder(MatrixRole role, NumberOrder order);
    /// Says what the numbers of a projection or a product leave open; none: as they tell.
    void setNdcDepth(MatrixRole role, const std::optional<geometry::NdcDepth> &depth);
    /// Does what a finding offers, but Exchange, which is one of the texts.
    void repair(MatrixRole role, const MatrixFinding &finding);
    /// As it was pasted.
    void takeBack(MatrixRole role);
    /// What was done, in this order.
    const std::vector<MatrixFinding> &repairs(MatrixRole role) const { return place(role).repairs; }

    /// In the order and with the repairs chosen; nothing where there is none.
    std::optional<glm::dmat4> matrix(MatrixRole role) const;
    /// Of the matrix as it is now.
    std::vector<MatrixFinding> findings(MatrixRole role) const;
    /// Of the NDC of the projection or the product: as chosen, else those of the API whose call it is; none: as its numbers tell.
    std::optional<geometry::NdcDepth> ndcDepth(MatrixRole role) const;

    /// What a scene is to take.
    struct Camera {
        std::optional<geometry::MatrixProjection> projection;
        std::optional<glm::dmat4> eyeFromWorld;
        std::optional<geometry::Viewport> viewport; ///< of a call
        bool isAnything() const { return projection || eyeFromWorld || viewport; }
    };
    /// Projection and view, what there is of them.
    Camera camera() const;
    /// Those that the product is taken apart into; nothing where there is none, or it cannot be.
    std::optional<Decomposition> apart() const;

private:
    struct Place {
        bool isBlank = true;
        bool hasCalls = false;           ///< in the text
        std::optional<MatrixRole> named; ///< see namedRole
        std::optional<PasteError> error;
        PastedScene parts;
        std::optional<PastedMatrix> own;
        std::optional<NumberOrder> order;  ///< none: as told
        ToldOrder told = ToldOrder::Usual; ///< of the matrix of this role, wherever it was pasted
        std::vector<MatrixFinding> repairs;
        std::optional<geometry::NdcDepth> ndcDepth;
    };
    Place &place(MatrixRole role) { return m_places[std::size_t(role)]; }
    const Place &place(MatrixRole role) const { return m_places[std::size_t(role)]; }
    void take(MatrixRole role, std::string_view text);
    void takeNumbers(MatrixRole role, std::string_view text);
    /// @return whether the text has calls
    bool takeCalls(MatrixRole role, std::string_view text);
    void tellOrders();
    bool hasRepair(MatrixRole role, MatrixRepair repair) const;
    /// Without turning the eye, which takes projection and view together.
    std::optional<glm::dmat4> unturned(MatrixRole role) const;

    std::array<Place, 3> m_places;
};

} // namespace unprojector::matrices
