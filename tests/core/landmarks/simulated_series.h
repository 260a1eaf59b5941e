#pragma once

#include "core/landmarks/procrustes.h"
#include "core/landmarks/symmetry.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <set>
#include <utility>
#include <vector>

/// Simulated series of faces: a symmetric set of landmarks, changed by smooth modes of shape and by
/// noise, then turned, moved and scaled; 1 landmark in 50 is displaced or swapped.
namespace simulated {

using unprojector::landmarks::Configuration;
using unprojector::landmarks::Pair;

/// Random numbers that are the same with every standard library.
class Random {
public:
    explicit Random(std::uint64_t seed) : m_engine(seed) {}
    double share() { return static_cast<double>(m_engine() >> 11U) * 0x1p-53; } ///< in [0, 1)
    double normal()
    {
        const double u = 1.0 - share(), v = share();
        return std::sqrt(-2.0 * std::log(u)) * std::cos(6.283185307179586 * v);
    }
    glm::dvec3 vector()
    {
        const double x = normal(), y = normal(), z = normal();
        return {x, y, z};
    }
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(m_engine() % count); }

private:
    std::mt19937_64 m_engine;
};

struct Kind {
    std::size_t scans = 12;
    double missing = 0.0;       ///< share of landmarks
    std::size_t modes = 8;      ///< of shape; each has 0.8 of the standard deviation of the one before
    double modeDeviation = 2.0; ///< of the first, in thousandths of a face of about 200
    double noise = 1.0;         ///< mean standard deviation of a landmark, all coordinates together
    bool hasMistakes = true;
};

using Place = std::pair<std::size_t, std::size_t>; ///< scan, landmark

struct Series {
    std::vector<Configuration> scans;
    std::vector<Pair> pairs;
    std::set<Place> wrong;                           ///< displaced or swapped
    std::vector<std::array<std::size_t, 3>> swapped; ///< scan, both landmarks
};

/// A symmetric face of 24 to 30 landmarks, each pair of left and right ones in a row, then the middle.
inline std::vector<glm::dvec3> face(Random &random, std::size_t pairs, std::size_t middle)
{
    std::vector<glm::dvec3> base;
    for (std::size_t i = 0; i < pairs; ++i) {
        const glm::dvec3 on = glm::normalize(random.vector()) * glm::dvec3(70.0, 100.0, 60.0);
        const glm::dvec3 left(std::abs(on.x) + 8.0, on.y, std::abs(on.z));
        base.push_back(left);
        base.push_back(left * glm::dvec3(-1.0, 1.0, 1.0));
    }
    for (std::size_t i = 0; i < middle; ++i) {
        const double angle = -1.4 + 2.8 * static_cast<double>(i) / static_cast<double>(middle - 1);
        base.emplace_back(0.0, 100.0 * std::sin(angle), 60.0 * std::cos(angle));
    }
    return base;
}

/// A smooth displacement of all landmarks, with a mean square of 1.
inline std::vector<glm::dvec3> mode(Random &random, const std::vector<glm::dvec3> &base)
{
    std::array<glm::dvec3, 9> factors;
    for (glm::dvec3 &factor : factors)
        factor = random.vector();
    std::vector<glm::dvec3> shifts;
    double squares = 0.0;
    for (const glm::dvec3 &point : base) {
        const glm::dvec3 b = point / 100.0;
        const std::array terms{b.x, b.y, b.z, b.x * b.y, b.y * b.z, b.x * b.z, b.x * b.x, b.y * b.y, b.z * b.z};
        glm::dvec3 shift(0.0);
        for (std::size_t i = 0; i < terms.size(); ++i)
            shift += factors[i] * terms[i];
        squares += glm::dot(shift, shift);
        shifts.push_back(shift);
    }
    for (glm::dvec3 &shift : shifts)
        shift /= std::sqrt(squares / static_cast<double>(base.size()));
    return shifts;
}

inline Series series(Random &random, const Kind &kind)
{
    Series result;
    const std::size_t pairs = 7 + random.below(4), middle = 24 + random.below(7) - 2 * pairs;
    const std::vector<glm::dvec3> base = face(random, pairs, middle);
    for (std::size_t i = 0; i < pairs; ++i)
        result.pairs.push_back({2 * i, 2 * i + 1});
    std::vector<std::vector<glm::dvec3>> modes;
    for (std::size_t i = 0; i < kind.modes; ++i)
        modes.push_back(mode(random, base));
    std::vector<double> noise;
    for (std::size_t j = 0; j < base.size(); ++j)
        noise.push_back(kind.noise * (0.5 + random.share()));
    for (std::size_t k = 0; k < kind.scans; ++k) {
        std::vector<double> weights;
        for (std::size_t i = 0; i < kind.modes; ++i)
            weights.push_back(random.normal() * kind.modeDeviation * std::pow(0.8, static_cast<double>(i)));
        const double w = random.normal();
        const glm::dvec3 xyz = random.vector();
        const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(w, xyz.x, xyz.y, xyz.z)));
        const double scale = 0.7 + 0.6 * random.share();
        const glm::dvec3 shift = 200.0 * random.vector();
        Configuration &scan = result.scans.emplace_back();
        for (std::size_t j = 0; j < base.size(); ++j) {
            glm::dvec3 point = base[j] + noise[j] * random.vector() / std::sqrt(3.0);
            for (std::size_t i = 0; i < kind.modes; ++i)
                point += weights[i] * modes[i][j];
            scan.emplace_back(scale * (turn * point) + shift);
        }
    }
    // The spread of each landmark without mistakes: its standard deviation about the classic mean.
    const auto clean = unprojector::landmarks::superimposed(result.scans);
    std::vector<double> spreads(base.size(), 0.0);
    for (std::size_t j = 0; j < base.size(); ++j) {
        for (const Configuration &scan : clean.aligned)
            spreads[j] += glm::dot(*scan[j] - *clean.mean[j], *scan[j] - *clean.mean[j]);
        spreads[j] = std::sqrt(spreads[j] / static_cast<double>(kind.scans - 1));
    }
    for (Configuration &scan : result.scans) {
        for (auto &point : scan) {
            if (random.share() < kind.missing)
                point.reset();
        }
    }
    for (std::size_t k = 0; kind.hasMistakes && k < kind.scans; ++k) {
        Configuration &scan = result.scans[k];
        for (std::size_t j = 0; j < base.size(); ++j) {
            if (random.share() >= 1.0 / 50.0 || !scan[j] || result.wrong.contains({k, j}))
                continue;
            if (random.share() < 0.5) {
                *scan[j] += 5.0 * spreads[j] / clean.meanFromSpecimen[k]->scale * glm::normalize(random.vector());
                result.wrong.insert({k, j});
                continue;
            }
            const std::size_t other = random.share() < 0.5 && j < 2 * pairs ? (j ^ 1U) : random.below(base.size());
            if (other == j || !scan[other] || result.wrong.contains({k, other}))
                continue;
            std::swap(scan[j], scan[other]);
            result.wrong.insert({k, j});
            result.wrong.insert({k, other});
            result.swapped.push_back({k, j, other});
        }
    }
    return result;
}

/// A series of a few landmarks, as an observer places them on faces: 4 in the middle, 3 pairs at
/// different distances from it, the widest pair first.
struct FewLandmarks {
    std::size_t scans = 3;
    std::vector<Pair> swapped; ///< on the first scan
    double deviation = 0.3;    ///< of a coordinate, in units of a face of about 14; nearby landmarks move together
};

inline const std::vector<Pair> kPairsOfFew{{4, 5}, {8, 9}, {6, 7}};

inline std::vector<Configuration> seriesOfFew(Random &random, const FewLandmarks &kind)
{
    const std::vector<glm::dvec3> base{{0.0, 10.0, 2.35}, {0.0, 6.0, 4.1},    {0.0, 4.6, 2.2},  {0.0, 0.0, 1.7},
                                       {4.46, 9.8, -0.1}, {-4.46, 9.8, -0.1}, {2.25, 9.6, 0.0}, {-2.25, 9.6, 0.0},
                                       {2.79, 2.6, 1.0},  {-2.79, 2.6, 1.0}};
    constexpr double kReach = 4.0, kOwn = 0.1; // landmarks within the reach move together; each has a part of its own
    const std::size_t count = base.size();
    std::vector<std::vector<double>> root(count, std::vector<double>(count, 0.0)); // of the covariance, by Cholesky
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            const double share = glm::distance(base[i], base[j]) / kReach;
            double sum = std::exp(-0.5 * share * share) + (i == j ? kOwn * kOwn : 0.0);
            for (std::size_t k = 0; k < j; ++k)
                sum -= root[i][k] * root[j][k];
            root[i][j] = i == j ? std::sqrt(sum) : sum / root[j][j];
        }
    }
    std::vector<Configuration> scans(kind.scans);
    for (Configuration &scan : scans) {
        std::vector<glm::dvec3> shifts;
        for (std::size_t i = 0; i < count; ++i)
            shifts.push_back(kind.deviation * random.vector());
        const double scale = 1.0 + 0.05 * random.normal(), w = random.normal();
        const glm::dvec3 xyz = random.vector(), shift = 20.0 * random.vector();
        const glm::dmat3 turn = glm::mat3_cast(glm::normalize(glm::dquat(w, xyz.x, xyz.y, xyz.z)));
        for (std::size_t i = 0; i < count; ++i) {
            glm::dvec3 point = base[i];
            for (std::size_t j = 0; j <= i; ++j)
                point += root[i][j] * shifts[j];
            scan.emplace_back(scale * (turn * point) + shift);
        }
    }
    for (const Pair &pair : kind.swapped)
        std::swap(scans.front()[pair.left], scans.front()[pair.right]);
    return scans;
}

} // namespace simulated
