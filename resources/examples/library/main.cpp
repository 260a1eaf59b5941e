// The world coordinate under a clicked pixel, by both methods.
#include <unprojector/unprojector.h>

#include <cstdio>

int main()
{
    namespace up = unprojector;
    const up::Perspective perspective{45.0, {}, 0.1, 100.0};
    const up::Camera camera{{3.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const auto setup = up::Setup::of(perspective, camera, {800, 600, {}, {}});
    if (!setup) {
        std::fprintf(stderr, "%s\n", setup.error().message.c_str());
        return 1;
    }
    std::printf("Unprojector %s, %d x %d pixels\n", up::version().c_str(), setup->width(), setup->height());

    const double px = 400.5, py = 300.5, depth = 0.985;
    for (const up::Method method : {up::Method::Formula, up::Method::Matrix}) {
        const auto unproject = up::Unprojection::of(*setup, method);
        if (!unproject) {
            std::fprintf(stderr, "%s\n", unproject.error().message.c_str());
            return 1;
        }
        double point[3];
        (*unproject)(&px, &py, &depth, point, 1);
        std::printf("%-8s %.12g %.12g %.12g\n", method == up::Method::Formula ? "formula" : "matrix", point[0],
                    point[1], point[2]);
    }
}
