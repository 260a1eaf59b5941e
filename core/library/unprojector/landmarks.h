#pragma once

#include "unprojector/export.h"
#include "unprojector/result.h"

#include <glm/vec3.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace unprojector {

/// Why a landmark has no position.
enum class Absence {
    NotPlaced, ///< not yet placed
    Skipped,   ///< passed over; still to be placed
    Missing    ///< marked as missing on this specimen
};

struct Landmark {
    std::string name;                ///< UTF-8; need not be unique
    std::optional<glm::dvec3> world; ///< empty: see `absence`
    Absence absence = Absence::NotPlaced;
    std::optional<glm::dvec3> uncertainty; ///< the largest error of each coordinate, if the file has it
    std::string object;                    ///< name of the object that it lies on; may be empty
    std::string note;                      ///< UTF-8
};

/// A line through landmarks with semilandmarks in equal steps.
struct Curve {
    std::string name;
    std::vector<std::string> landmarks;    ///< names of the landmarks, in order
    std::vector<glm::dvec3> semilandmarks; ///< world space
};

struct Specimen {
    std::string name; ///< UTF-8; may be empty
    std::string unit; ///< "mm"; empty: unknown
    int placing = 1;  ///< from 1: which of the specimen's repeated placings
    std::vector<Landmark> landmarks;
    std::vector<Curve> curves;
};

/// The landmarks of a file: of one or several specimens. They do not change; copies share their
/// data, and with it all that the file has beyond these members.
class UNPROJECTOR_PUBLIC Landmarks {
public:
    /// Reads CSV, MeshLab (.pp, .pptpl), 3D Slicer (.mrk.json, .fcsv), IDAV (.pts), TPS, NTSYS (.nts,
    /// .dta), Amira (.landmarkAscii) and landmarker.io (.ljson), by the file's suffix.
    /// @return MissingFile, File; Value: an unknown suffix, the line that is wrong
    static Result<Landmarks> read(const std::filesystem::path &file);
    static Landmarks of(const std::vector<Specimen> &specimens);

    const std::vector<Specimen> &specimens() const;
    /// Sentences about what reading changed or dropped.
    const std::vector<std::string> &notes() const;

    /// Writes a file by its suffix. An existing file is replaced in one step. Several specimens go
    /// into CSV, TPS and NTSYS.
    /// @return what the format cannot hold, one sentence each. File; Value: a suffix that is not
    ///         written, landmarks that the format cannot hold at all
    Result<std::vector<std::string>> write(const std::filesystem::path &file) const;

private:
    struct Data;
    explicit Landmarks(std::shared_ptr<const Data> data) : m_data(std::move(data)) {}

    std::shared_ptr<const Data> m_data;
};

} // namespace unprojector
