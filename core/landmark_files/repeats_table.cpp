#include "core/landmark_files/repeats_table.h"

#include "core/landmark_files/lines.h"
#include "core/landmarks/repeats.h"
#include "core/text/number_text.h"

#include <cmath>

namespace unprojector::landmark_files {
using landmarks::RepeatedLandmark;

std::string repeatsTable(std::span<const RepeatedSpecimen> specimens, text::CellTexts texts)
{
    std::string text = "specimen,name,placings,x,y,z,error,farthest\n";
    for (const RepeatedSpecimen &specimen : specimens) {
        for (const RepeatedLandmark &repeated : landmarks::repeatsOf(specimen.placings)) {
            appendCell(text, specimen.name, texts);
            text += ',';
            appendCell(text, repeated.name, texts);
            text += ',' + std::to_string(repeated.count);
            for (int axis = 0; axis < 3; ++axis) {
                text += ',';
                if (repeated.mean)
                    text::appendNumber(text, (*repeated.mean)[axis]);
            }
            text += ',';
            if (repeated.error)
                text::appendNumber(text, *repeated.error);
            text += ',';
            if (repeated.mean && std::isfinite(repeated.farthest))
                text::appendNumber(text, repeated.farthest);
            text += '\n';
        }
    }
    return text;
}

} // namespace unprojector::landmark_files
