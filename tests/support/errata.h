#pragma once

#include <array>

/// The errors in the originals, by their anchors in Help, in its order. Each is shown to be one in test_source_errors.
inline constexpr std::array kErrata{
    "error-weng-sign",
    "error-weng-row",
    "error-weng-x-axis",
    "error-weng-look-at",
    "error-weng-near",
    "error-weng-clip-plane",
    "error-weng-depth",
    "error-weng-figure",
    "error-weng-bottom",
    "error-weng-eye",
    "error-zhangci-product",
    "error-zhangci-cube",
    "error-zhangci-ortho",
    "error-zhangci-perspective",
    "error-zhangci-depth",
    "error-zhangci-height",
    "error-zhangci-object",
    "error-derivation-three",
    "error-derivation-translate",
    "error-opencascade-model-view",
    "error-opencascade-ortho",
    "error-opencascade-perspective",
    "error-opencascade-viewport",
    "error-opencascade-rows",
    "error-opencascade-depth",
    "error-parallel-range",
    "error-parallel-flip",
    "error-parallel-way",
    "error-parallel-size",
    "error-parallel-integers",
    "error-parallel-cot",
};
