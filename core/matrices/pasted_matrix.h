#pragma once

#include "core/geometry/result.h"
#include "core/geometry/viewport.h"

#include <glm/mat4x4.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::matrices {

/// How the sixteen numbers of a matrix follow each other.
enum class NumberOrder { ByColumns, ByRows };

/// How a program writes a matrix; the order follows from it.
enum class MatrixForm {
    Flat,       ///< sixteen numbers in a row or in one pair of brackets: memory, C arrays, JSON, three.js: by columns
    Indexed,    ///< m[0] = 1 … m[15] = 1: by columns
    GlmColumns, ///< glm::to_string, GLM's and GLSL's constructors: by columns
    IndexPairs, ///< m(0,1) as Eigen counts, m01 as Unity does: row, column
    RowLines,   ///< four lines of four, or semicolons between the rows: Eigen, OpenCV, QMatrix4x4
    NestedRows, ///< four brackets of four: NumPy, JSON, C arrays of arrays
    Call        ///< no numbers of a matrix, but a call that makes one, see pastedCalls: by columns
};

/// A matrix as it was pasted.
struct PastedMatrix {
    std::array<double, 16> numbers{}; ///< as they stand in the text; those with indices, by these
    MatrixForm form = MatrixForm::Flat;
    bool isInverse = false;                       ///< it has the name of an inverse, as projectionMatrixInverse
    std::optional<NumberOrder> order{};           ///< where its numbers tell another than the usual one, see toldOrders
    std::optional<geometry::NdcDepth> ndcDepth{}; ///< of a projection, where the text tells
    std::string call{}; ///< how the call was read that made it, in the language of text::tr(), without a full stop
    friend bool operator==(const PastedMatrix &, const PastedMatrix &) = default;
};

/// The order that a form has.
NumberOrder orderOf(MatrixForm form);
NumberOrder opposite(NumberOrder order);

/// The matrix that sixteen numbers are in an order: column vectors.
glm::dmat4 matrixOf(const std::array<double, 16> &numbers, NumberOrder order);

/// What a matrix stands for, in an order: one with the name of an inverse, its own inverse. One that has none stays as it is.
glm::dmat4 meantMatrix(const PastedMatrix &matrix, NumberOrder order);

/// Whether it has the name of an inverse, and is singular.
bool lacksInverse(const PastedMatrix &matrix);
/// What is done with a matrix that has the name of an inverse, in the language of text::tr().
std::string inverseText(const PastedMatrix &matrix);

struct ViewportAndDepths {
    geometry::Viewport viewport;
    geometry::DepthRange depthRange;
};

/// Whether a window may have it: within [0, 1], but for what single precision leaves.
bool isWindowsOwn(const geometry::DepthRange &range);

/// What a matrix from NDC to the window stands for: column vectors, window positions in pixels from the bottom left.
/// @param depth  the NDC depths it goes by; unknown, those in [-1, 1], unless only those in [0, 1] make its depth range one
///               within [0, 1]
/// @return width and height less than 0 where the matrix turns x or y round
ViewportAndDepths viewportOf(const glm::dmat4 &windowFromNdc, const std::optional<geometry::NdcDepth> &depth);

/// What a text may say of a scene's matrices. Those behind a name are that part's; model is world from object, product the
/// projection times the view, or times the modelview. ToWindow, the viewport's matrix times that, and what else is said of a
/// window, follows from the others.
enum class PastedPart { ModelView, View, Model, Projection, Product, Viewport, ToWindow };
const char *nameOf(PastedPart part);

struct PastedScene {
    std::optional<PastedMatrix> modelView, view, model, projection, product;
    std::optional<geometry::Viewport> viewport;
    std::optional<PastedMatrix> viewportMatrix; ///< window from NDC, where the viewport is given as that
    std::vector<PastedPart> more; ///< of which there are several, as of several objects: only the first is taken
    std::vector<PastedPart> inversesLeft; ///< whose inverse stands beside them, and is left out
};

/// What is wrong with a call, see pastedCalls.
enum class CallFault {
    NoNumber,  ///< an argument
    NoVector,  ///< an argument
    Count,     ///< found, wanted: arguments
    Radians,   ///< argument: an angle that can only be in degrees
    Parameters ///< parameters: no projection or view has them
};

struct PasteError {
    std::string word;                 ///< the number that is not finite; empty where their count is wrong
    std::size_t line = 0, column = 0; ///< of the word, from 1
    PastedPart part = PastedPart::ModelView;
    std::size_t found = 0, wanted = 16;
    std::size_t all = 0; ///< numbers in the text
    std::string call{};  ///< that cannot be read, "glm::perspective"; empty where it is about no call
    CallFault fault = CallFault::NoNumber;
    std::string argument{}; ///< of the call, as written
    geometry::Error parameters{geometry::ErrorCode::NotFinite};
};
/// What is wrong, in the language of text::tr(), without the place and the part.
std::string reasonText(const PasteError &error);

/// One matrix. Brackets, commas, quotes and words are passed over, and so are subscripts (m[3], m(0,1), "3":) and the
/// numbers in comments, lines that begin with #, % or //.
/// @return 16 numbers; what is wrong with them
geometry::Result<PastedMatrix, PasteError> pastedMatrix(std::string_view text);

/// The matrices and the viewport of a scene: numbers behind a name (modelview, view, model, projection, MVP, viewport)
/// are that part's, whatever their order; behind that of an inverse (viewInverse,
/// cameraToWorld) too, where the part itself is not there; those behind none are modelview, projection and viewport, in this order, or,
/// where there are twenty altogether, the product and the viewport.
/// @return the viewport, the projection and the modelview or the view; or the product; whatever else was there
geometry::Result<PastedScene, PasteError> pastedScene(std::string_view text);

/// What of all that a text has; none of it need be there. Sixteen numbers alone are the modelview's.
geometry::Result<PastedScene, PasteError> pastedParts(std::string_view text);

} // namespace unprojector::matrices
