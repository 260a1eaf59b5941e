#pragma once

#include "core/doctor/mistakes.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

/// Collects the ways to make mistakes, each under the mistake that it is one of.
class VariantList {
public:
    using Apply = void (*)(Run &, const Variant &);

    /// @param name  where there are several
    void add(std::string_view id, Stage stage, Apply apply, double parameter = 0.0, VariantName name = {});
    /// One of another size of the window; its parameters are width and height.
    void add(std::string_view id, Stage stage, Apply apply, const geometry::Surface &size, VariantName name = {});
    /// One of a model's matrix.
    void add(std::string_view id, Apply apply, const PlacedModel &model);

    /// By their mistakes, those of one in the order in which they were added.
    std::vector<Variant> sorted() &&;

private:
    std::vector<Variant> m_variants;
};

// Each family's, as they can be made on what was given.
void addPixelMistakes(VariantList &list, const Given &given, const std::optional<geometry::Surface> &otherSize);
void addDepthMistakes(VariantList &list, const Given &given);
void addLensMistakes(VariantList &list, const Given &given, const std::optional<geometry::Surface> &otherSize);
void addMatrixMistakes(VariantList &list);
void addPointMistakes(VariantList &list, std::span<const PlacedModel> models);

} // namespace unprojector::doctor
