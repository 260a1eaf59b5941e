#pragma once

#include "core/cameras/reader_parts.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::cameras {

/// A camera of a text, with the names that choose it and the nodes of its parts.
struct Found {
    std::string name, id; ///< the name is empty in a text of one camera
    Node pose, lens, own{};
    glm::dmat4 parent{1.0}; ///< the transform of what the pose is in
};

enum class Format {
    Json,
    LaxJson, ///< with keys that other programs have, too: a mistake in the syntax is left to a reader of texts
    Xml,
    Print
};

/// The form of a program's cameras: a row of the table of programs. A new program takes a row.
struct Form {
    const char *program = "";
    Format format = Format::Json;
    /// Words of the text, in JSON keys: all of them, "a|b" any. "" leaves it to cameras().
    const char *marks = "";
    PoseDirection direction = PoseDirection::WorldToCamera;
    EyeAxes axes = EyeAxes::RightDownAhead;
    PixelCentres centres = PixelCentres::AtIntegers;
    struct Parts {
        const char *size = "", *planes = "", *lens = "";
        const char *pose = "";       ///< as for Reading::setPose()
        std::size_t count = 16;      ///< of the numbers of `pose`
        bool isByColumns = false;    ///< the matrix
        const char *at = "";         ///< the translation
        const char *centre = "";     ///< the camera's position
        const char *distortion = ""; ///< a list in OpenCV's order
        const char *note = "";       ///< an assumption, marked for translation
    } parts{};
    /// Reads what the parts do not tell.
    void (*quirk)(Reading &reading, const Found &camera) = nullptr;
    /// The cameras of a text; empty: it has another form. Without this function, the text is one camera.
    std::vector<Found> (*cameras)(Reading &reading, const Node &text) = nullptr;
    /// Reads texts that belong together, instead of all else.
    std::optional<ForeignCamera> (*readAll)(std::span<const NamedText> texts, const CameraChoices &choices) = nullptr;
};

/// Opens a text that has these marks, as Form::marks; returns false for another text.
/// @param document  what reading.file then refers to
bool openDocument(Reading &reading, Format format, std::string_view marks, base::Json &document);

/// The whole text as a camera, if it is one.
std::vector<Found> onlyIf(bool isIt, const Node &text);
/// The parts of a printed text that begin with a mark, each up to the next end and with a word in it, named by the
/// first text in quotes of their first lines; the whole text without any.
std::vector<Found> sections(const Reading &reading, const Node &text, std::string_view mark, std::string_view end,
                            std::string_view word = {});

/// The forms of COLMAP, of XML, of JSON, of files of numbers, and of prints.
std::span<const Form> colmapForms();
std::span<const Form> xmlForms();
std::span<const Form> jsonForms();
std::span<const Form> fileForms();
std::span<const Form> printForms();

/// K, R, t and distortion coefficients: text, JSON, the YAML and XML of cv::FileStorage, ROS's
/// camera_info.
std::optional<ForeignCamera> readNamedParts(std::span<const NamedText> texts, const CameraChoices &choices);
/// A lens with poses in a file of numbers: TUM, KITTI, Replica, 7-Scenes, ScanNet; DSO's camera.txt.
std::optional<ForeignCamera> readTables(std::span<const NamedText> texts, const CameraChoices &choices);

} // namespace unprojector::cameras
