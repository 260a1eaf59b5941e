#pragma once

#include "core/base/json.h"
#include "core/lessons/lesson.h"
#include "core/scene/scene.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::lessons {

/// The scene of a step.
/// @return an error that names the key
base::Expected<scene::Scene, base::Error> sceneOf(const Step &step);

/// The view in which a step's numbers hold: of its own size, if the step gives one.
/// @param surface  of the view that shows it
geometry::Surface surfaceOf(const Step &step, const geometry::Surface &surface);

/// Every number that a step's texts can refer to, by a path. The numbers come from the program's
/// own computations.
///
///   scene.KEY                   the content of the scene's file, see scene_file.h:
///                               scene.projection.near
///   surface.width .height .ratio  the view: device pixels, and device pixels per logical one
///   model view projection viewport modelview whole
///                               the matrices of PipelineStage, [row][column] from 0, for column
///                               vectors: projection[2][3]
///   viewSteps projectionSteps   the factors of view and projection, see pipeline::factors:
///                               [i][row][column], in the order in which they act on a point. None
///                               where the matrices were given as sixteen numbers
///   object world eye clip ndc window device widget
///                               the followed point, the scene's "point", in each space:
///                               .x .y .z .w
///   formula inverse             the world point that its window point unprojects to, by the
///                               formulas and by the matrix
///   NAME.…                      of a point of the step: NAME.ndc.x, NAME.modelview[0][0];
///                               NAME.pixel[0], the pixel that contains it
///   set.NAME.…                  of a change by a link: set.other.point.coordinates
///   STEP:…                      in another step of the lesson, by its id:
///                               perspective:projection[0][0]
///
/// A path with several numbers means all of them, in their order: eye, scene.projection.
class StepNumbers {
public:
    /// @param surface  of the view that shows it
    /// @return an error if the scene has no valid setup, or if a point's object is missing, or if
    ///         nothing is visible at its pixel
    static base::Expected<StepNumbers, base::Error> of(const scene::Scene &scene, const geometry::Surface &surface,
                                                       const std::map<std::string, StepPoint> &points,
                                                       const std::map<std::string, base::JsonValue> &changes = {});

    /// @return empty if there is no such number
    std::vector<double> at(std::string_view path) const;

    /// The device pixel of a named point, where a click hits it.
    /// @return empty if the view contains no such point
    std::optional<geometry::DevicePixel> pixelOf(const std::string &point) const;

private:
    base::JsonValue m_tree;
};

/// The numbers of all steps of a lesson, so that one step can refer to another.
class LessonNumbers {
public:
    /// @param surface  of a view; a step with its own view size uses that, with the same pixel
    ///         ratio
    static base::Expected<LessonNumbers, base::Error> of(const Lesson &lesson, const geometry::Surface &surface);

    const StepNumbers &step(const std::string &id) const { return m_steps.at(id); }

    /// The numbers of a source: a path with several, an expression of single ones, "ndc.x * 2", or
    /// a number of the text's source, "quoted 4".
    /// @param step  id of the step
    /// @return empty if a path is unknown, or if the expression contains no path: a bare "2" would
    ///         test nothing
    std::vector<double> values(const std::string &step, std::string_view source) const;

private:
    std::vector<double> at(const std::string &step, std::string_view path) const;

    std::map<std::string, StepNumbers> m_steps;
};

} // namespace unprojector::lessons
