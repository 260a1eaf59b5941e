#pragma once

#include "core/doctor/mistakes.h"
#include "core/doctor/program.h"

#include <span>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

/// Collects the variants of mistakes.
struct VariantList {
    using Apply = void (*)(Run &);

    /// @param name  needed if there are several
    /// @return the variant, valid until the next one is added
    Variant &add(std::string_view id, Stage stage, Apply apply, VariantName name = {}, double parameter = 0.0,
                 double second = 0.0);
    /// Adds a variant with its values; sets its mistake.
    Variant &add(std::string_view id, Variant variant);

    std::vector<Variant> all;
};

// Each adds the variants of one family that are possible with the input.
void addPixelMistakes(VariantList &list, const Given &given, const Case &scene);
void addDepthMistakes(VariantList &list, const Given &given, const Case &scene);
void addLensMistakes(VariantList &list, const Given &given, const Case &scene);
void addMatrixMistakes(VariantList &list, const Given &given, const Case &scene);
void addCameraMistakes(VariantList &list, const Given &given, const Case &scene);

/// All variants of all mistakes for this input, sorted by mistake; those of one mistake stay in the order of addition.
/// @param hasSolved  false: mistakes of fixed form only
std::vector<Variant> variants(const Given &given, const Case &scene, bool hasSolved = false);

} // namespace unprojector::doctor
