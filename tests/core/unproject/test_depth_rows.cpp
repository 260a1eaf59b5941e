// Rows of a depth image: the points of a batch, one after the other, where there is a surface.

#include "tests/support/test.h"

#include "core/unproject/batch/batch_unproject.h"
#include "tests/support/batch_arrays.h"
#include "tests/support/core_scene.h"
#include "tests/support/instruction_sets.h"
#include "tests/support/random_kinds.h"

#include <limits>
#include <utility>
#include <vector>

using namespace unprojector;
using namespace unprojector::geometry;
using namespace unprojector::unproject;
using oracle::RandomKind;
using oracle::SceneLimits;

class TestDepthRows : public QObject {
    Q_OBJECT

private slots:
    void rowsAreTheSurfacesOfABatch_data()
    {
        addColumn<InstructionSet>("set");
        addColumn<RandomKind>("kind");
        for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512}) {
            addRow("%s, frustum, off-centre and mirrored too", name(set)) << set << RandomKind::Frustum;
            addRow("%s, perspective", name(set)) << set << RandomKind::Perspective;
            addRow("%s, ortho, around the eye too", name(set)) << set << RandomKind::Ortho;
            addRow("%s, oblique", name(set)) << set << RandomKind::Oblique;
        }
    }

    /// Surfaces everywhere, nowhere and here and there, over more than some packs and a rest.
    void rowsAreTheSurfacesOfABatch()
    {
        QFETCH(InstructionSet, set);
        QFETCH(RandomKind, kind);
        SKIP_WITHOUT(set);
        constexpr std::size_t kWidth = 83;
        oracle::Random random(8);
        for (int count = 0; count < 20; ++count) {
            SceneLimits limits;
            limits.plainTarget = true;
            const oracle::Scene s = oracle::randomScene(random, kind, limits);
            Triples<float> pixels(kWidth);
            for (std::size_t i = 0; i < kWidth; ++i) {
                pixels.of[0][i] = static_cast<float>(i) + 0.5f;
                pixels.of[1][i] = 7.5f;
                pixels.of[2][i] = static_cast<float>(i * 37 % kWidth) / float(kWidth);
            }
            pixels.of[2][3] = std::numeric_limits<float>::quiet_NaN();
            for (const auto &[lowest, highest] :
                 {std::pair(0.0f, 1.0f), std::pair(0.25f, 0.5f), std::pair(2.0f, 3.0f)}) {
                for (const auto &unprojection : {BatchUnprojection::byFormula(oracle::corePicture(s), {}),
                                                 BatchUnprojection::byMatrix(oracle::corePicture(s), {})}) {
                    const Triples<float> all = unprojected(*unprojection, pixels, InstructionSet::Baseline);
                    std::vector<float> expected;
                    for (std::size_t i = 0; i < kWidth; ++i) {
                        const float depth = pixels.of[2][i];
                        if (depth >= lowest && depth <= highest)
                            expected.insert(expected.end(), {all.of[0][i], all.of[1][i], all.of[2][i]});
                    }
                    std::vector<float> points(3 * kWidth);
                    const batch::DepthRow row{pixels.of[2].data(), kWidth, 0.5, 7.5, lowest, highest, false};
                    points.resize(3 * (*unprojection)(row, points.data(), set));
                    QCOMPARE(points, expected);
                }
            }
        }
    }

    void rowsLeaveOutWhatNoFloatHolds_data()
    {
        addColumn<InstructionSet>("set");
        for (const InstructionSet set : {InstructionSet::Baseline, InstructionSet::Avx2, InstructionSet::Avx512})
            newRow(name(set)) << set;
    }

    void rowsLeaveOutWhatNoFloatHolds()
    {
        QFETCH(InstructionSet, set);
        SKIP_WITHOUT(set);
        Setup g;
        g.surface = {40, 1, 1.0};
        g.viewport = wholeSurface(g.surface);
        g.lens = Ortho{0.0, 4e39, -1.0, 1.0, 1.0, 3.0}; // pixel i at x = (i + 1/2) 1e38; floats end at 3.4e38
        g.pose = LookAt{WorldPoint(0, 0, 0), WorldPoint(0, 0, -1), {0, 1, 0}};
        const std::vector<float> depths(40, 0.5f);
        const auto unprojection = BatchUnprojection::byFormula(g, {});
        std::vector<float> points(120);
        QCOMPARE((*unprojection)({depths.data(), 40, 0.5, 0.5, 0.0f, 1.0f, true}, points.data(), set), std::size_t(3));
        QCOMPARE(points[0], 0.5e38f);
        QCOMPARE(points[6], 2.5e38f);
        QCOMPARE(points[8], -2.0f);
        QCOMPARE((*unprojection)({depths.data(), 40, 0.5, 0.5, 0.0f, 1.0f, false}, points.data(), set),
                 std::size_t(40));
    }
};

UNPROJECTOR_TEST(TestDepthRows)
#include "test_depth_rows.moc"
