#pragma once

#include "core/lessons/lesson.h"
#include "core/scene/scene.h"
#include "core/text/json_value.h"

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::lessons {

/// The scene that a step shows.
/// @return an error that names the key
geometry::Result<scene::Scene, LessonError> sceneOf(const Step &step);

/// The view that a step's numbers hold in: its own size, where it says one.
/// @param surface  of the view that shows it
geometry::Surface surfaceOf(const Step &step, const geometry::Surface &surface);

/// Every number that a step's texts can speak of, by a path. They are those that the program shows, on its own way to them.
///
///   scene.KEY                   what the scene's file would hold, see scene_file.h: scene.projection.near
///   surface.width .height .ratio  the view: device pixels, and how many of them there are to a logical one
///   model view projection viewport modelview whole
///                               the matrices of PipelineStage, [row][column] from 0, column vectors: projection[2][3]
///   viewSteps projectionSteps   what view and projection are taken apart into, see matrices::factors: [i][row][column], in the
///                               order in which they act on a point. None where they were given as sixteen numbers
///   object world eye clip ndc window device widget
///                               the followed point (the scene's "point") in each space: .x .y .z .w
///   formula inverse             what its window point is unprojected to, in the world, by the formulas and by the matrix
///   NAME.…                      of a point of the step: NAME.ndc.x, NAME.modelview[0][0]; NAME.pixel[0], the pixel that it lies in
///   set.NAME.…                  of a change that a link makes: set.other.point.coordinates
///   STEP:…                      in another step of the lesson, by its id: perspective:projection[0][0]
///
/// A path that has several numbers stands for all of them, in their order: eye, scene.projection.
class StepNumbers {
public:
    /// @param surface  of the view that shows it
    /// @return where the scene has no picture, or a point's object is not there, or its pixel shows nothing
    static geometry::Result<StepNumbers, LessonError> of(const scene::Scene &scene, const geometry::Surface &surface,
                                                         const std::map<std::string, StepPoint> &points,
                                                         const std::map<std::string, text::JsonValue> &changes = {});

    /// @return none where there is no such number
    std::vector<double> at(std::string_view path) const;

    /// In pixels of the device: where a click meets a named point.
    /// @return nothing where there is none in the picture
    std::optional<geometry::DevicePixel> pixelOf(const std::string &point) const;

private:
    text::JsonValue m_tree;
};

/// The numbers of a lesson's steps, so that one can speak of another.
class LessonNumbers {
public:
    /// @param surface  of a view; a step that says its view's size has that one, of the same pixel ratio
    static geometry::Result<LessonNumbers, LessonError> of(const Lesson &lesson, const geometry::Surface &surface);

    const StepNumbers &step(const std::string &id) const { return m_steps.at(id); }

    /// A list of numbers: a path that has several, an expression of single ones, "ndc.x * 2", or a number of the source,
    /// "quoted 4".
    /// @param step  whose
    /// @return an error where a path is none, and of an expression without any, "2", which the program has no part in
    geometry::Result<std::vector<double>, LessonError> values(const std::string &step, std::string_view source) const;

    /// What is wrong with the statements of a step, its question's included; each names the step, what the text says and what
    /// the program computes.
    std::vector<std::string> faults(const Step &step) const;

private:
    std::vector<double> at(const std::string &step, std::string_view path) const;

    std::map<std::string, StepNumbers> m_steps;
};

} // namespace unprojector::lessons
