#pragma once

#include "core/cameras/reader_parts.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace unprojector::cameras {

enum class Format { Json, Xml, Print };

/// Where a form has a camera's parts.
struct Parts {
    bool isLax = false;     ///< the keys are other programs', too: a mistake in JSON's syntax is left to other readers
    bool mayBePart = false; ///< people paste the middle of an object, too
    PixelCentres centres = PixelCentres::AtIntegers;
    /// Of the cameras: a list, as "a|b" the first that is not empty, and "" the text's; elements of XML by their
    /// tag, named as themselves or the nearest around them. Those count that have a value under a key; a text
    /// without a list has the names "a b".
    const char *list = "", *name = "", *id = "", *having = "";
    const char *size = "", *planes = "", *lens = "";
    const char *pose = "";       ///< as for Reading::setPose()
    std::size_t count = 16;      ///< of the numbers of `pose`
    bool isByColumns = false;    ///< the matrix
    const char *at = "";         ///< the translation
    const char *centre = "";     ///< the camera's position
    const char *distortion = ""; ///< a list in OpenCV's order
    const char *note = "";       ///< an assumption, marked for translation
};

/// The form of a program's cameras: a row of the table of programs. A new program takes a row.
struct Form {
    const char *program = "";
    /// Words of the text, in JSON keys: all of them, "a|b" any. "" leaves it to cameras().
    const char *marks = "";
    Frame frame{};
    /// The cameras of a text, where no list has them; empty: it has another form.
    Cameras (*cameras)(Reading &reading, const Node &text) = nullptr;
    /// Reads what the parts do not tell.
    void (*quirk)(Reading &reading) = nullptr;
    Parts parts{};
    /// Reads texts that belong together, instead of all else.
    std::optional<ForeignCamera> (*readAll)(std::span<const NamedText> texts, const CameraChoices &choices) = nullptr;
    Format format = Format::Print; ///< that of its span below
};

/// Opens a text that has a form's marks; returns false for another text.
/// @param document  what reading.file then refers to
bool openDocument(Reading &reading, const Form &form, base::Json &document);

/// The cameras of a list.
Cameras listed(const Parts &parts, Format format, const Node &text);
/// The whole text as a camera, if it is one.
Cameras onlyIf(bool isIt, const Node &text);
/// The parts of a printed text that begin with a mark, each up to the next end and with a word in it, named by the
/// first text in quotes of their first lines; the whole text without any.
Cameras sections(const Reading &reading, const Node &text, std::string_view mark, std::string_view end,
                 std::string_view word = {});

/// The forms of COLMAP, of XML, of JSON, of files of numbers, of scene languages, and of prints.
std::span<const Form> colmapForms();
std::span<const Form> xmlForms();
std::span<const Form> jsonForms();
std::span<const Form> fileForms();
std::span<const Form> sceneForms();
std::span<const Form> printForms();
/// The form of a camera with an eye, a target and up, of any program.
std::span<const Form> lookAtForms();

/// K, R, t and distortion coefficients: text, JSON, the YAML and XML of cv::FileStorage, ROS's
/// camera_info.
std::optional<ForeignCamera> readNamedParts(std::span<const NamedText> texts, const CameraChoices &choices);
/// A lens with poses in a file of numbers: TUM, KITTI, Replica, 7-Scenes, ScanNet; DSO's camera.txt.
std::optional<ForeignCamera> readTables(std::span<const NamedText> texts, const CameraChoices &choices);

} // namespace unprojector::cameras
