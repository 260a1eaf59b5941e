#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

/// The texts in tests/data: what other programs write and print, and what this one must read in it.
namespace data_files {

inline std::string read(const std::filesystem::path &file)
{
    std::ifstream in(file, std::ios::binary);
    if (!in)
        throw std::runtime_error("there is no " + file.string());
    return {std::istreambuf_iterator<char>(in), {}};
}

/// The entries of a folder of tests/data, by name.
inline std::vector<std::filesystem::path> in(const std::filesystem::path &folder)
{
    std::vector<std::filesystem::path> entries;
    for (const auto &entry : std::filesystem::directory_iterator(std::filesystem::path(UNPROJECTOR_TEST_DATA) / folder))
        entries.push_back(entry.path());
    std::sort(entries.begin(), entries.end());
    return entries;
}

struct NamedText {
    std::string name, text;
};

/// A camera as another program writes it, and that program's own projections of some points: computed
/// by Blender (world_to_camera_view), three.js (Vector3.project), with the pose that COLMAP wrote for
/// Bundler, or with the formulas of the programs' documentation. A folder of tests/data/cameras:
/// its files, and expected.json.
struct CameraExample {
    struct Point {
        std::vector<double> world; ///< of the scene: right-handed
        std::vector<double> pixel; ///< as the program counts
    };
    std::string name;
    std::vector<NamedText> texts;
    std::string image; ///< chosen; empty: none
    int width, height; ///< chosen; 0: none
    double tolerance;  ///< relative to the image's size
    double corner;     ///< added to the program's pixels: from the image's corner
    std::vector<Point> points;
};

inline CameraExample cameraExample(const std::filesystem::path &folder)
{
    const nlohmann::json expected = nlohmann::json::parse(read(folder / "expected.json"));
    const std::vector<int> size = expected.value("size", std::vector<int>{0, 0});
    CameraExample example{expected.at("name"),
                          {},
                          expected.value("image", ""),
                          size.at(0),
                          size.at(1),
                          expected.at("tolerance"),
                          expected.value("corner", 0.0),
                          {}};
    for (const std::string name : expected.at("files"))
        example.texts.push_back({name, read(folder / name)});
    for (const nlohmann::json &point : expected.at("points"))
        example.points.push_back({point.at("world"), point.at("pixel")});
    return example;
}

inline const std::vector<CameraExample> &cameraExamples()
{
    static const std::vector<CameraExample> examples = [] {
        std::vector<CameraExample> all;
        for (const std::filesystem::path &folder : in("cameras"))
            all.push_back(cameraExample(folder));
        return all;
    }();
    return examples;
}

} // namespace data_files
