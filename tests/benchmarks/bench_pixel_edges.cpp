// Edges inside pixels: how many of them the search finds, by the judgement of 65 × 65 rays a pixel,
// and its time a pixel.
//   bench_pixel_edges [model files …]; the bundled head and a sphere without any

#include "core/examples/examples.h"
#include "core/opening/models.h"
#include "tests/support/cube_sphere.h"
#include "tests/support/edge_rates.h"

#include <cstdio>
#include <string>

namespace {

void measure(const std::string &name, const std::shared_ptr<const unprojector::mesh::Model> &model)
{
    const EdgeRates rates = edgeRates(model, 20, 25, 1);
    std::printf("%-12s %9zu triangles: %4d of %4d edges found, %d of %d plain pixels wrongly flagged, %d wrong "
                "distances, %.0f us a pixel\n",
                name.c_str(), model->triangleCount(), rates.found, rates.withEdge, rates.wronglyFound, rates.plain,
                rates.wrongDistance, 1e6 * rates.seconds / rates.searched);
}

} // namespace

int main(int argc, char **argv)
{
    if (argc < 2) {
        measure("Head", unprojector::examples::bundledModels().at("Head"));
        measure("sphere", cubeSphere(200, 0.0));
    }
    for (int i = 1; i < argc; ++i) {
        const auto model = unprojector::opening::ModelFiles().read(argv[i]);
        if (!model) {
            std::fprintf(stderr, "%s cannot be read\n", argv[i]);
            return 1;
        }
        measure(std::filesystem::path(argv[i]).stem().string(), *model);
    }
    return 0;
}
