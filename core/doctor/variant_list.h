#pragma once

#include "core/doctor/mistakes.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace unprojector::doctor {

/// Collects the variants of mistakes, each under its mistake.
class VariantList {
public:
    using Apply = void (*)(Run &, const Variant &);

    /// @param name  needed if there are several
    void add(std::string_view id, Stage stage, Apply apply, double parameter = 0.0, VariantName name = {});
    /// Adds a variant with another size of the window; its parameters are width and height.
    void add(std::string_view id, Stage stage, Apply apply, const geometry::Surface &size, VariantName name = {});
    /// Adds a variant with its values; sets its mistake.
    void add(std::string_view id, Variant variant);
    /// Adds a variant that is not tried in pairs.
    void addAlone(std::string_view id, Stage stage, Apply apply, VariantName name, double parameter = 0.0,
                  double second = 0.0);
    /// Adds a variant with a model's matrix.
    /// @param isAlone  it is not tried in pairs
    void add(std::string_view id, Apply apply, const PlacedModel &model, bool isAlone);

    /// The variants sorted by mistake; variants of one mistake stay in the order of addition.
    std::vector<Variant> sorted() &&;

private:
    std::vector<Variant> m_variants;
};

// Each adds the variants of one family that are possible with the input.
void addPixelMistakes(VariantList &list, const Given &given, const std::optional<geometry::Surface> &otherSize);
void addDepthMistakes(VariantList &list, const Given &given);
void addLensMistakes(VariantList &list, const Given &given, const std::optional<geometry::Surface> &otherSize);
void addMatrixMistakes(VariantList &list);
void addCameraMistakes(VariantList &list, const Given &given, const std::optional<geometry::Surface> &otherSize);
void addPointMistakes(VariantList &list, std::span<const PlacedModel> models);

} // namespace unprojector::doctor
