// The share of clicks whose reported uncertainty holds: random clicks on models, as OpenGL draws
// them here, against the hit of the exact ray of each pixel's centre:
//   bench_certainty [clicks] [model …], 100000 in all without any, on meshes of its own
#include "core/mesh/import/mesh_import.h"
#include "tests/gui/view/drawn_clicks.h"
#include "tests/support/cube_sphere.h"

#include <QGuiApplication>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

using namespace unprojector;

namespace {

void print(const char *name, const drawnclicks::Shares &shares)
{
    const auto part = [](const InsideShare &share) {
        std::printf("   %8.3f %% %8.2f", 100.0 * share.inside(), 1.0 / share.neededScale());
    };
    std::printf("%-40s %8zu", name, shares.byTriangle.count());
    part(shares.byTriangle);
    part(shares.byNeighbours);
    std::printf("\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char **argv)
{
    const QGuiApplication application(argc, argv);
    drawnclicks::Stage stage;
    const int clicks = argc > 1 ? std::max(1, std::atoi(argv[1])) : 100'000;
    std::vector<std::shared_ptr<mesh::Model>> models;
    for (int i = 2; i < argc; ++i) {
        if (const auto model = mesh::importModel(argv[i], {}))
            models.push_back(*model);
        else
            std::fprintf(stderr, "%s cannot be read.\n", argv[i]);
    }
    if (models.empty())
        models = {cubeSphere(60),
                  cubeSphere(1, 0.0),
                  cubeSphere(400),
                  drawnclicks::movedFarAway(*cubeSphere(60)),
                  drawnclicks::roughTerrain(200),
                  drawnclicks::roughTerrain(900),
                  drawnclicks::slivers(1500)};
    std::printf("%s\n%-40s %8s   %-19s   %-19s\n%-40s %8s   %10s %8s   %10s %8s\n", stage.rendererName().c_str(), "",
                "", "triangle known", "by neighbours", "model", "clicks", "inside", "/ needed", "inside", "/ needed");
    constexpr int kPictures = 60; // every projection with every pixel ratio and depth range
    const int each = clicks / (kPictures * static_cast<int>(models.size())) + 1;
    drawnclicks::Shares all;
    for (const auto &model : models) {
        drawnclicks::Shares of;
        for (int number = 0; number < kPictures; ++number) {
            if (const auto shares = stage.clicked(model, number, each))
                of.add(*shares);
        }
        print(model->name.c_str(), of);
        all.add(of);
    }
    print("all", all);
}
