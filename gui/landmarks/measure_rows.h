#pragma once

#include "core/landmarks/landmark.h"
#include "gui/document/scene_curves.h"

#include <QFontMetrics>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <optional>
#include <vector>

namespace unprojector::gui {

/// One measure of landmarks, in words.
struct MeasureRow {
    QString kind;                      ///< "Distance"
    QString points;                    ///< "nasion – pronasale"
    QString value;                     ///< "12.34 ± 0.05 mm", or why there is none
    std::optional<double> number = {}; ///< in the scene's unit, or degrees
    std::optional<double> error = {};
    /// The measure for the view, without its text; nothing if the view cannot show it.
    std::optional<ShownMeasure> shown = {};
    QString copied = {}; ///< `points` with all digits; empty: the same
    bool isComputing = false;
    /// `value` and `points` in ever less room, see fittedText; empty: without numbers.
    QStringList valueTexts = {}, pointsTexts = {};
};

/// The names of a row, shortened so that each keeps a part: else the row would not show their order.
/// @param width  logical pixels
QString namesFitted(const QString &names, const QFontMetrics &metrics, int width);

/// The measures of some landmarks, in the order of their selection: the distance of two; the angles
/// of three and their distances; the height of the fourth over the plane of the first three; the
/// length along all of them.
/// @param indices  of the landmarks, in that order
std::vector<MeasureRow> measuresOf(const landmarks::LandmarkSet &set, const std::vector<std::size_t> &indices);

/// The length along the surface through these landmarks.
/// @param line  of SceneCurves
MeasureRow surfaceLengthOf(const landmarks::LandmarkSet &set, const std::vector<std::size_t> &indices,
                           const SceneCurves::Line &line);
/// The length of a curve, "12.34 ± 0.05 mm", or why there is none.
QString curveLengthText(const SceneCurves::Line &line, const QString &unit);
/// The same in ever less room, see fittedText; empty without a length.
QStringList curveLengthTexts(const SceneCurves::Line &line, const QString &unit);

/// Rows for the plane that best mirrors left landmarks to right ones: its landmarks and those
/// without an uncertainty. Then for each pair the asymmetry, and for each landmark of the middle the
/// distance from the plane, or why it is left out: it is hidden, or has a side but no partner. The
/// last rows count the pairs without both positions. Empty without a pair.
std::vector<MeasureRow> sidesOf(const landmarks::LandmarkSet &set);

/// The rows as a table: kind, points, value and error with all their digits, unit.
QString csvOf(const std::vector<MeasureRow> &rows, const QString &unit);

} // namespace unprojector::gui
