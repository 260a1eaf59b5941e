#pragma once

#include "core/base/csv.h"
#include "core/landmark_files/landmark_file.h"
#include "core/landmarks/landmark.h"
#include "core/landmarks/repeatability.h"

#include <span>
#include <string>
#include <vector>

namespace unprojector::landmark_files {

/// A specimen whose landmarks were placed several times, or by several observers.
struct RepeatedSpecimen {
    std::string name; ///< UTF-8
    std::vector<landmarks::LandmarkSet> placings;
    std::vector<std::string> files; ///< files of the placings, UTF-8; one per placing
};

/// A table of comma-separated values with one row per landmark:
/// specimen,name,placings,x,y,z,error,farthest. It has the mean of the placings, the standard
/// deviation of one, and the distance of the farthest from the mean, see landmarks::repeatsOf.
/// Values that too few placings cannot give stay empty. Placings without a unit get a note, and are
/// assumed to have the others' unit.
/// @return an error: placings of one specimen in several units
base::Expected<WrittenLandmarks, base::Error> repeatsTable(std::span<const RepeatedSpecimen> specimens,
                                                           base::CellTexts texts = base::CellTexts::ReadBack);

/// A table of the error of measurement over all specimens, one row a landmark and a last one, "(all)":
/// landmark,specimens,placings,error,icc1,icc2, then error_N and bias_N for each placing. NA: too few
/// placings or specimens.
/// @return an error: placings in several units
base::Expected<WrittenLandmarks, base::Error> errorsTable(std::span<const RepeatedSpecimen> specimens,
                                                          base::CellTexts texts = base::CellTexts::ReadBack);

/// Warnings about an error of measurement, without a full stop: no repeated placing, or specimens that
/// cannot be aligned.
std::vector<std::string> errorRemarks(const landmarks::MeasurementError &error);
landmarks::MeasurementError measurementErrorOf(std::span<const RepeatedSpecimen> specimens);

} // namespace unprojector::landmark_files
