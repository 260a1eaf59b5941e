#include "unprojector/landmarks.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/specimen_table.h"

#include <utility>

namespace unprojector {
namespace {

using landmark_files::LandmarkFileError;
using landmark_files::LandmarkNote;

Error publicError(const LandmarkFileError &error)
{
    Error::Kind kind = Error::Kind::Value;
    switch (error.code) {
    case LandmarkFileError::Code::NotFound: kind = Error::Kind::MissingFile; break;
    case LandmarkFileError::Code::IsDirectory:
    case LandmarkFileError::Code::NotReadable:
    case LandmarkFileError::Code::NotWritable: kind = Error::Kind::File; break;
    case LandmarkFileError::Code::UnknownFormat:
    case LandmarkFileError::Code::NotWritten:
    case LandmarkFileError::Code::TooLarge:
    case LandmarkFileError::Code::Malformed:
    case LandmarkFileError::Code::CannotHold: break;
    }
    return {kind, landmark_files::errorText(error)};
}

std::vector<std::string> sentences(const std::filesystem::path &file, const std::vector<LandmarkNote> &notes)
{
    std::vector<landmark_files::FileNote> named;
    named.reserve(notes.size());
    for (const LandmarkNote &note : notes)
        named.push_back({base::utf8FromPath(file), note});
    return landmark_files::noteLines(named);
}

Absence publicAbsence(landmarks::Absence absence)
{
    switch (absence) {
    case landmarks::Absence::NotPlaced: return Absence::NotPlaced;
    case landmarks::Absence::Skipped: return Absence::Skipped;
    case landmarks::Absence::Missing: return Absence::Missing;
    }
    return Absence::NotPlaced;
}

landmarks::Absence internalAbsence(Absence absence)
{
    switch (absence) {
    case Absence::NotPlaced: return landmarks::Absence::NotPlaced;
    case Absence::Skipped: return landmarks::Absence::Skipped;
    case Absence::Missing: return landmarks::Absence::Missing;
    }
    return landmarks::Absence::NotPlaced;
}

Specimen publicSpecimen(const landmarks::LandmarkSet &set)
{
    Specimen specimen{set.name, set.unit, set.placing, {}, {}};
    for (const landmarks::Landmark &landmark : set.landmarks) {
        Landmark &one = specimen.landmarks.emplace_back();
        one.name = landmark.name;
        if (landmark.world)
            one.world = landmark.world->coordinates();
        one.absence = publicAbsence(landmark.absence);
        if (landmark.uncertainty)
            one.uncertainty = landmark.uncertainty->coordinates();
        one.object = landmark.object;
        one.note = landmark.note;
    }
    for (const landmarks::Curve &curve : set.curves) {
        Curve &one = specimen.curves.emplace_back(Curve{curve.name, curve.points, {}});
        for (const geometry::WorldPoint &point : curve.semilandmarks)
            one.semilandmarks.push_back(point.coordinates());
    }
    return specimen;
}

landmarks::LandmarkSet internalSet(const Specimen &specimen)
{
    landmarks::LandmarkSet set;
    set.name = specimen.name;
    set.unit = specimen.unit;
    set.placing = specimen.placing;
    for (const Landmark &landmark : specimen.landmarks) {
        landmarks::Landmark &one = set.landmarks.emplace_back();
        one.name = landmark.name;
        if (landmark.world)
            one.world = geometry::WorldPoint(*landmark.world);
        else
            one.absence = internalAbsence(landmark.absence);
        if (landmark.uncertainty)
            one.uncertainty = geometry::WorldVector(*landmark.uncertainty);
        one.object = landmark.object;
        one.note = landmark.note;
    }
    for (const Curve &curve : specimen.curves) {
        landmarks::Curve &one = set.curves.emplace_back();
        one.name = curve.name;
        one.points = curve.landmarks;
        for (const glm::dvec3 &point : curve.semilandmarks)
            one.semilandmarks.emplace_back(point);
        one.count = static_cast<std::uint32_t>(one.semilandmarks.size());
    }
    return set;
}

} // namespace

struct Landmarks::Data {
    std::vector<landmarks::LandmarkSet> sets;
    std::vector<Specimen> specimens;
    std::vector<std::string> notes;
    std::string source; ///< the specimen that the file's name tells
};

Result<Landmarks> Landmarks::read(const std::filesystem::path &file)
{
    auto read = landmark_files::readLandmarkFile(file);
    if (!read)
        return publicError(read.error());
    Data data{read->sets, {}, sentences(file, read->notes), landmark_files::specimenOf(file)};
    for (const landmarks::LandmarkSet &set : data.sets)
        data.specimens.push_back(publicSpecimen(set));
    return Landmarks(std::make_shared<const Data>(std::move(data)));
}

Landmarks Landmarks::of(const std::vector<Specimen> &specimens)
{
    Data data{{}, specimens, {}, {}};
    for (const Specimen &specimen : specimens)
        data.sets.push_back(internalSet(specimen));
    return Landmarks(std::make_shared<const Data>(std::move(data)));
}

const std::vector<Specimen> &Landmarks::specimens() const
{
    return m_data->specimens;
}

const std::vector<std::string> &Landmarks::notes() const
{
    return m_data->notes;
}

Result<std::vector<std::string>> Landmarks::write(const std::filesystem::path &file) const
{
    const std::string name = base::utf8FromPath(file);
    const auto format = landmark_files::formatOf(file);
    if (!format)
        return publicError({LandmarkFileError::Code::NotWritten, name, 0, {}});
    auto text = landmark_files::convertedText(m_data->sets, *format, m_data->source);
    if (!text) {
        LandmarkFileError error = text.error();
        error.file = name;
        return publicError(error);
    }
    if (const base::Done written = base::replaceFile(file, text->text); !written)
        return publicError({LandmarkFileError::Code::NotWritable, name, 0, written.error().text});
    return sentences(file, text->notes);
}

} // namespace unprojector
