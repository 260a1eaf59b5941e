// The world coordinate under a clicked pixel, by both methods, with its uncertainty; and the way back.
#include <unprojector/unprojector.h>

#include <cstdio>
#include <cstdlib>
#include <utility>

namespace up = unprojector;

/// Ends the program with the library's sentence where there is no value.
template <class T>
T valueOf(up::Result<T> result)
{
    if (result)
        return std::move(result).value();
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::exit(1);
}

int main()
{
    up::Perspective perspective;
    perspective.verticalFovDegrees = 45.0;
    perspective.nearDistance = 0.1;
    perspective.farDistance = 100.0;
    const up::Camera camera{{3.0, 2.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    const auto setup = valueOf(up::Setup::of(perspective, camera, {800, 600, {}, {}}));
    std::printf("Unprojector %s, %s\n", up::version().c_str(), setup.description().c_str());

    const glm::dvec2 pixel(400.5, 300.5);
    const double depth = 0.985;
    for (const up::Method method : {up::Method::Formula, up::Method::Matrix}) {
        const auto unproject = valueOf(up::Unprojection::of(setup, {method}));
        const glm::dvec3 p = valueOf(unproject.at(pixel, depth)), u = valueOf(unproject.uncertaintyAt(pixel, depth));
        std::printf("%-8s %.12g %.12g %.12g  +- %.2g %.2g %.2g\n", method == up::Method::Formula ? "formula" : "matrix",
                    p.x, p.y, p.z, u.x, u.y, u.z);
        const up::Stages back = valueOf(valueOf(up::ForwardProjection::of(setup)).at(p));
        std::printf("         pixel %.9g %.9g, depth %.9g\n", back.pixel.x, back.pixel.y, back.pixel.z);
    }
}
