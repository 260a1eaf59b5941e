#pragma once

#include "core/cli/commands/scene_command.h"
#include "core/matrices/matrix_findings.h"
#include "core/matrices/told_order.h"

#include <glm/mat4x4.hpp>

#include <optional>
#include <string>

namespace unprojector::cli {

/// Takes pasted matrices in the order and conventions that the options or their numbers name. Reports on stderr what the numbers
/// show, such as an inverse or reversed depths.
class MatrixTaker {
public:
    /// @param options  must outlive this
    /// @param name     of the text; messages begin with it
    MatrixTaker(const SceneOptions &options, std::string name);

    /// Sets the order of the matrices where no option says it and their numbers tell another one than their forms have, and says so.
    /// @return whether the order of all matrices of a scene is known. If not, a message asks for the option
    bool tellOrders(matrices::PastedScene &pasted) const;

    /// The matrix in the order that is asked for, or told, or in that of its form.
    glm::dmat4 matrixAsGiven(const matrices::PastedMatrix &pasted) const { return meantMatrix(pasted, order(pasted)); }
    /// The same in OpenGL's conventions, whosever it was.
    glm::dmat4 matrix(const matrices::PastedMatrix &pasted, matrices::MatrixRole role) const;
    /// What a matrix from NDC to the window says of viewport and depth range. Where pixels count from the top, y is 0 there.
    matrices::ViewportAndDepths viewport(const matrices::PastedMatrix &pasted) const;
    /// NDC depths that are known.
    std::optional<geometry::NdcDepth> depth() const;

    void say(matrices::PastedPart part, const std::string &what) const;
    /// Says what is to be seen of a matrix, but for what an option has an answer to.
    /// @return whether depths are reversed by it
    bool lookAt(const matrices::PastedMatrix &pasted, matrices::PastedPart part, matrices::MatrixRole role,
                const std::optional<glm::dmat4> &clipFromEye = std::nullopt) const;

private:
    geometry::Api api() const { return m_options.conventions.value_or(geometry::Api::OpenGl); }
    matrices::NumberOrder order(const matrices::PastedMatrix &pasted) const;
    /// What is to be seen is that of the matrix in OpenGL's conventions.
    std::string taken(const std::string &finding) const;

    const SceneOptions &m_options;
    std::string m_name;
};

} // namespace unprojector::cli
