#include "unprojector/landmarks.h"

#include "core/base/path_text.h"
#include "core/base/replace_file.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmark_files/landmark_folder.h"
#include "core/landmark_files/specimen_table.h"
#include "core/library/internal.h"

#include <utility>

namespace unprojector {
static_assert(int(Absence::Missing) == int(landmarks::Absence::Missing));
namespace {

std::vector<std::string> sentences(const std::filesystem::path &file, const std::vector<base::Note> &notes)
{
    std::vector<landmark_files::FileNote> named;
    named.reserve(notes.size());
    for (const base::Note &note : notes)
        named.push_back({base::utf8FromPath(file), note});
    return landmark_files::noteLines(named);
}

Specimen publicSpecimen(const landmarks::LandmarkSet &set)
{
    Specimen specimen{set.name, set.unit, set.placing, {}, {}};
    for (const landmarks::Landmark &landmark : set.landmarks) {
        Landmark &one = specimen.landmarks.emplace_back();
        one.name = landmark.name;
        if (landmark.world)
            one.world = landmark.world->coordinates();
        one.absence = sameOf<Absence>(landmark.absence);
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
            one.absence = sameOf<landmarks::Absence>(landmark.absence);
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
        return publicError(read.error(), file);
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
    const auto format = landmark_files::writtenFormatOf(file);
    if (!format)
        return publicError(format.error(), file);
    auto text = landmark_files::convertedText(m_data->sets, *format, m_data->source);
    if (!text)
        return publicError(text.error(), file);
    if (const base::Done written = base::replaceFile(file, text->text); !written)
        return publicError(written.error(), file);
    return sentences(file, text->notes);
}

} // namespace unprojector
