// The loops over many points, compared with moving the same bytes and with common alternatives.
// Compare only numbers of one run: the ratio to the memcpy of the same bytes counts.

#include "core/unproject/batch/batch_unproject.h"

#include <benchmark/benchmark.h>
#include <glm/gtc/matrix_transform.hpp>
#ifdef UNPROJECTOR_GLU
#include <GL/glu.h>
#endif

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;

namespace {

constexpr std::size_t kPoints = 10'000'000;

Setup setup()
{
    Setup g;
    g.surface = {3840, 2160, 1.0};
    g.viewport = wholeSurface(g.surface);
    g.lens = Frustum{-1.0, 1.2, -0.5, 0.7, 1.0, 100.0};
    g.pose = LookAt{WorldPoint(3, 4, 5), WorldPoint(0, 0, 0), {0, 1, 0}};
    return g;
}

/// Arrays of one kind of number: three each for input and output, filled and touched once.
template <class Scalar>
struct Arrays {
    std::vector<Scalar> in[3], out[3];

    Arrays()
    {
        std::mt19937_64 random(1);
        const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
        for (int k = 0; k < 3; ++k) {
            in[k].resize(kPoints);
            out[k].assign(kPoints, Scalar(1));
        }
        for (std::size_t i = 0; i < kPoints; ++i) {
            in[0][i] = static_cast<Scalar>(unit() * 3840);
            in[1][i] = static_cast<Scalar>(unit() * 2160);
            in[2][i] = static_cast<Scalar>(unit());
        }
    }

    BatchInput<Scalar> input() const { return {in[0].data(), in[1].data(), in[2].data()}; }
    BatchOutput<Scalar> output() { return {out[0].data(), out[1].data(), out[2].data()}; }
};

template <class Scalar>
Arrays<Scalar> &arrays()
{
    static Arrays<Scalar> shared;
    return shared;
}

void finish(benchmark::State &state)
{
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kPoints));
}

template <class Scalar>
void copying(benchmark::State &state)
{
    Arrays<Scalar> &a = arrays<Scalar>();
    for (auto _ : state) {
        for (int k = 0; k < 3; ++k)
            std::memcpy(a.out[k].data(), a.in[k].data(), kPoints * sizeof(Scalar));
        benchmark::ClobberMemory();
    }
    finish(state);
}

template <class Scalar>
void batch(benchmark::State &state, const Result<BatchUnprojection> &unprojection, InstructionSet set)
{
    Arrays<Scalar> &a = arrays<Scalar>();
    for (auto _ : state) {
        (*unprojection)(a.input(), a.output(), kPoints, set);
        benchmark::ClobberMemory();
    }
    finish(state);
}

/// Unprojects as many points, the same few again and again: the cost of computing without waiting
/// for memory.
template <class Scalar>
void batchInCache(benchmark::State &state, const Result<BatchUnprojection> &unprojection, InstructionSet set)
{
    constexpr std::size_t kFew = 512;
    Arrays<Scalar> &a = arrays<Scalar>();
    for (auto _ : state) {
        for (std::size_t done = 0; done < kPoints; done += kFew) {
            (*unprojection)(a.input(), a.output(), std::min(kFew, kPoints - done), set);
            benchmark::ClobberMemory();
        }
    }
    finish(state);
}

/// Calls glm::unProject once a point, as most programs do.
void glmUnProject(benchmark::State &state)
{
    const Setup g = setup();
    Arrays<double> &a = arrays<double>();
    const glm::dmat4 view = eyeFromWorld(g).value(), projection = clipFromEye(g).value();
    const glm::dvec4 viewport(g.viewport.x, g.viewport.y, g.viewport.width, g.viewport.height);
    for (auto _ : state) {
        for (std::size_t i = 0; i < kPoints; ++i) {
            const glm::dvec3 p =
                glm::unProject(glm::dvec3(a.in[0][i], 2160.0 - a.in[1][i], a.in[2][i]), view, projection, viewport);
            a.out[0][i] = p.x;
            a.out[1][i] = p.y;
            a.out[2][i] = p.z;
        }
        benchmark::ClobberMemory();
    }
    finish(state);
}

#ifdef UNPROJECTOR_GLU
void gluUnProjectEach(benchmark::State &state)
{
    const Setup g = setup();
    Arrays<double> &a = arrays<double>();
    const glm::dmat4 view = eyeFromWorld(g).value(), projection = clipFromEye(g).value();
    const GLint viewport[4] = {0, 0, GLint(g.viewport.width), GLint(g.viewport.height)};
    for (auto _ : state) {
        for (std::size_t i = 0; i < kPoints; ++i) {
            gluUnProject(a.in[0][i], 2160.0 - a.in[1][i], a.in[2][i], &view[0][0], &projection[0][0], viewport,
                         &a.out[0][i], &a.out[1][i], &a.out[2][i]);
        }
        benchmark::ClobberMemory();
    }
    finish(state);
}
#endif

void glmInverseOnce(benchmark::State &state)
{
    const Setup g = setup();
    Arrays<double> &a = arrays<double>();
    const glm::dmat4 inverse = glm::inverse(clipFromEye(g).value() * eyeFromWorld(g).value());
    for (auto _ : state) {
        for (std::size_t i = 0; i < kPoints; ++i) {
            glm::dvec4 ndc(a.in[0][i] / 3840.0, (2160.0 - a.in[1][i]) / 2160.0, a.in[2][i], 1.0);
            ndc = ndc * 2.0 - 1.0;
            const glm::dvec4 p = inverse * glm::dvec4(glm::dvec3(ndc), 1.0);
            a.out[0][i] = p.x / p.w;
            a.out[1][i] = p.y / p.w;
            a.out[2][i] = p.z / p.w;
        }
        benchmark::ClobberMemory();
    }
    finish(state);
}

const char *name(InstructionSet set)
{
    switch (set) {
    case InstructionSet::Baseline: return "baseline";
    case InstructionSet::Avx2: return "AVX2";
    case InstructionSet::Avx512: return "AVX-512";
    }
    return "";
}

template <class Scalar>
void registerBatches(const std::string &scalar)
{
    Setup box = setup();
    box.lens = Ortho{-10, 10, -7, 9, 1, 100};
    const auto add = [&](const std::string &what, const Result<BatchUnprojection> &unprojection, InstructionSet set) {
        benchmark::RegisterBenchmark((what + '/' + scalar + '/' + name(set)).c_str(),
                                     [=](benchmark::State &state) { batch<Scalar>(state, unprojection, set); });
    };
    benchmark::RegisterBenchmark(("memcpy/" + scalar).c_str(), copying<Scalar>);
    for (const InstructionSet set : availableInstructionSets()) {
        add("closed form, perspective", BatchUnprojection::byFormula(setup(), {}), set);
        add("closed form, box", BatchUnprojection::byFormula(box, {}), set);
        add("matrix", BatchUnprojection::byMatrix(setup(), {}), set);
    }
    const InstructionSet best = availableInstructionSets().back();
    benchmark::RegisterBenchmark(
        ("closed form, perspective/" + scalar + '/' + name(best) + ", in cache").c_str(),
        [=](benchmark::State &state) { batchInCache<Scalar>(state, BatchUnprojection::byFormula(setup(), {}), best); });
}

} // namespace

int main(int argc, char **argv)
{
    registerBatches<double>("double");
    registerBatches<float>("float");
    benchmark::RegisterBenchmark("glm::unProject/double", glmUnProject);
    benchmark::RegisterBenchmark("glm inverse once/double", glmInverseOnce);
#ifdef UNPROJECTOR_GLU
    benchmark::RegisterBenchmark("gluUnProject/double", gluUnProjectEach);
#endif
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
