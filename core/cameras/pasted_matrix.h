#pragma once

#include "core/base/error.h"
#include "core/geometry/result.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::cameras {

/// The order of the sixteen numbers of a matrix.
enum class NumberOrder { ByColumns, ByRows };

/// The notation in which a program writes a matrix; it determines the order.
enum class MatrixForm {
    Flat,       ///< sixteen numbers in a row or in one pair of brackets: memory, C arrays, JSON, three.js: by columns
    Indexed,    ///< m[0] = 1 … m[15] = 1: by columns
    GlmColumns, ///< glm::to_string, GLM's and GLSL's constructors: by columns
    IndexPairs, ///< m(0,1) as in Eigen, m01 as in Unity: row, column
    RowLines,   ///< four lines of four, or semicolons between the rows: Eigen, OpenCV, QMatrix4x4
    NestedRows, ///< four brackets of four: NumPy, JSON, C arrays of arrays
    Call        ///< not the numbers of a matrix but a call that makes one, see pastedCalls: by columns
};

/// The matrices and the viewport that a text may contain. Numbers after a part's name belong to it.
/// Model is world from object; product is the projection times the view, or times the modelview.
/// ToWindow is the viewport's matrix times the product; like everything else about a window, it
/// follows from the others.
enum class PastedPart { ModelView, View, Model, Projection, Product, Viewport, ToWindow };
const char *nameOf(PastedPart part);

/// A matrix as pasted.
struct PastedMatrix {
    std::array<double, 16> numbers{}; ///< in text order; numbers with indices are sorted by them
    MatrixForm form = MatrixForm::Flat;
    bool isInverse = false;                       ///< the name says that it is an inverse: projectionMatrixInverse
    std::optional<NumberOrder> order{};           ///< set if the numbers show the unusual order, see toldOrders
    std::optional<geometry::NdcDepth> ndcDepth{}; ///< of a projection, if the text determines it
    std::optional<PastedPart> part{};             ///< that its name tells
    std::string name{};                           ///< this name
    std::size_t line = 0;                         ///< of its first number, from 1
    std::string call{}; ///< how the call that made it was read, in the language of base::tr(), without a full stop
    friend bool operator==(const PastedMatrix &, const PastedMatrix &) = default;
};

/// The order of a form.
NumberOrder orderOf(MatrixForm form);
NumberOrder opposite(NumberOrder order);

/// The matrix, for column vectors, of sixteen numbers in the given order.
glm::dmat4 matrixOf(const std::array<double, 16> &numbers, NumberOrder order);

/// The matrix in the given order. If the name says it is an inverse, the result is inverted; a
/// singular matrix is returned unchanged.
glm::dmat4 meantMatrix(const PastedMatrix &matrix, NumberOrder order);

/// Describes the handling of a matrix whose name says it is an inverse, in the language of base::tr().
std::string inverseText(const PastedMatrix &matrix);

struct ViewportAndDepths {
    geometry::Viewport viewport;
    geometry::DepthRange depthRange;
};

/// Returns whether a window can have this depth range: within [0, 1], apart from single-precision
/// rounding.
bool isWindowsOwn(const geometry::DepthRange &range);

/// Interprets a matrix from NDC to the window: column vectors, window positions in pixels from the
/// bottom left.
/// @param depth  the NDC depths; if unknown, [-1, 1], unless only [0, 1] gives a depth range within
///         [0, 1]
/// @return width or height is negative if the matrix flips x or y
ViewportAndDepths viewportOf(const glm::dmat4 &windowFromNdc, const std::optional<geometry::NdcDepth> &depth);

struct PastedScene {
    std::optional<PastedMatrix> modelView, view, model, projection, product;
    std::optional<geometry::Viewport> viewport;
    std::optional<PastedMatrix> viewportMatrix; ///< window from NDC, if the viewport is given as a matrix
    std::vector<PastedPart> more;   ///< parts that occur several times, as for several objects: only the first is used
    std::vector<std::string> aside; ///< names whose numbers belong to no part: "near", "Mouse"
    std::vector<PastedPart> inversesLeft; ///< parts whose inverse is also in the text; the inverse is ignored
};

/// Why a text gives no matrices.
struct PasteError {
    std::string text; ///< in the language of base::tr(), without position and part
    std::size_t line = 0,
                column = 0; ///< of a number that is not finite, or of one name too many, from 1; 0: another error
    PastedPart part = PastedPart::ModelView;
    std::size_t found = 0, wanted = 16;
    std::size_t all = 0;   ///< numbers in the text
    bool isOfCall = false; ///< the error is about a call, which the text names; see pastedCalls
};
/// The error as every reader gives it; its subject is the part.
base::Error errorOf(const PasteError &error);
/// The error of a part with another count of numbers than it needs.
/// @param all  numbers in the text
PasteError countError(PastedPart part, std::size_t found, std::size_t wanted, std::size_t all);

/// Reads one matrix. Skips brackets, commas, quotes and words, as well as subscripts (m[3], m(0,1),
/// "3":) and the numbers in comments, that is lines that begin with #, % or //.
/// Three rows of four get the row 0 0 0 1.
/// @return 16 numbers; the error
geometry::Result<PastedMatrix, PasteError> pastedMatrix(std::string_view text);

/// Reads the matrices and the viewport that a text has. Numbers after a name (modelview, view, model,
/// projection, MVP, viewport) belong to that part, in any order. Numbers after the name of an
/// inverse (viewInverse, cameraToWorld) count too if the part itself is missing. Unnamed numbers
/// are modelview, projection and viewport, in this order; twenty unnamed numbers in all are the
/// product and the viewport, sixteen the modelview.
/// @return the parts, none of which is required; the error of one with another count of numbers than it needs
geometry::Result<PastedScene, PasteError> pastedParts(std::string_view text);

} // namespace unprojector::cameras
