// Files of landmarks: read, written, read again, in the format whose suffix the build names.

#include "core/landmark_files/landmark_file.h"
#include "tests/fuzz/curves_on_mesh.h"
#include "tests/fuzz/fuzzing.h"

#include <cmath>

using namespace unprojector::landmark_files;
using namespace unprojector::landmarks;

// The name is that which libFuzzer calls. NOLINTNEXTLINE(readability-identifier-naming)
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    const Format format = formatOfSuffix(UNPROJECTOR_FUZZ_SUFFIX).value();
    const auto read = parseLandmarks(fuzz::text(data, size), format, "file");
    if (!read) {
        fuzz::require(read.error().message().size() > std::string_view("file: ").size(), "an error says what is wrong");
        return 0;
    }
    fuzz::require(!read->sets.empty(), "there is a specimen");
    for (const LandmarkSet &set : read->sets) {
        for (const Landmark &landmark : set.landmarks) {
            for (int i = 0; landmark.world && i < 3; ++i)
                fuzz::require(std::isfinite((*landmark.world)[i]), "numbers are finite");
        }
        fuzz::leadCurves(set);
    }
    const auto written = landmarksText(read->sets, format);
    if (!written)
        return 0; // names that JSON cannot hold
    const auto again = parseLandmarks(written->text, format, "file");
    fuzz::require(again.hasValue(), "what was written can be read");
    fuzz::require(again->sets.size() == read->sets.size(), "no specimen is lost");
    for (std::size_t i = 0; i < read->sets.size(); ++i) {
        const auto &before = read->sets[i].landmarks, &after = again->sets[i].landmarks;
        fuzz::require(before.size() == after.size(), "no landmark is lost");
        for (std::size_t k = 0; k < before.size(); ++k)
            fuzz::require(before[k].world == after[k].world, "coordinates keep their digits");
        const auto &curves = read->sets[i].curves, &curvesAfter = again->sets[i].curves;
        fuzz::require(format != Format::Csv || curves.size() == curvesAfter.size(), "no curve is lost");
        for (std::size_t k = 0; format == Format::Csv && k < curves.size(); ++k)
            fuzz::require(curves[k].points == curvesAfter[k].points && curves[k].kind == curvesAfter[k].kind
                              && curves[k].count == curvesAfter[k].count
                              && curves[k].semilandmarks == curvesAfter[k].semilandmarks,
                          "curves stay what they are");
    }
    const auto writtenAgain = landmarksText(again->sets, format);
    fuzz::require(writtenAgain.hasValue() && writtenAgain->text == written->text,
                  "landmarks read and written again stay the same");
    return 0;
}
