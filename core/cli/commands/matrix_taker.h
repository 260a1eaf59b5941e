#pragma once

#include "core/cli/commands/scene_command.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/told_order.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

namespace unprojector::cli {

/// Reads pasted matrices in the order and conventions that the options give or the numbers reveal.
/// Reports findings on stderr, such as an inverse or reversed depths.
class MatrixTaker {
public:
    /// @param options  must outlive this
    /// @param name     of the text; messages begin with it
    MatrixTaker(const SceneOptions &options, std::string name);

    /// Sets the order of the matrices where no option gives it and the numbers contradict the order
    /// of the matrix's form. Reports each such change.
    /// @return whether the order of all matrices of a scene is known; if not, a message asks for
    ///         the option
    bool tellOrders(matrices::PastedScene &pasted) const;

    /// The matrix in the order of the option, of its numbers, or of its form, in this priority.
    glm::dmat4 matrixAsGiven(const matrices::PastedMatrix &pasted) const { return meantMatrix(pasted, order(pasted)); }
    /// The matrix converted from the option's conventions to OpenGL's.
    glm::dmat4 matrix(const matrices::PastedMatrix &pasted, matrices::MatrixRole role) const;
    /// Viewport and depth range from a matrix from NDC to the window. Where pixels count from the
    /// top, y is 0 at the top.
    matrices::ViewportAndDepths viewport(const matrices::PastedMatrix &pasted) const;
    /// The NDC depths, where the options determine them.
    std::optional<geometry::NdcDepth> depth() const;
    /// The same, or those of the call that made the projection.
    std::optional<geometry::NdcDepth> depthOf(const matrices::PastedMatrix &pasted) const;

    void say(matrices::PastedPart part, const std::string &what) const;
    /// Reports the findings about a matrix, unless an option already resolves them.
    /// @return whether the matrix reverses depths
    bool lookAt(const matrices::PastedMatrix &pasted, matrices::PastedPart part, matrices::MatrixRole role,
                const std::optional<glm::dmat4> &clipFromEye = std::nullopt) const;

private:
    geometry::Api api() const { return m_options.conventions.value_or(geometry::Api::OpenGl); }
    matrices::NumberOrder order(const matrices::PastedMatrix &pasted) const;
    /// The finding worded for the matrix converted to OpenGL's conventions.
    std::string taken(const std::string &finding) const;

    const SceneOptions &m_options;
    std::string m_name;
};

} // namespace unprojector::cli
