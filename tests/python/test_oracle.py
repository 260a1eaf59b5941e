"""Points against arithmetic with 60 digits that shares no code with the program."""

import numpy as np
import pytest
import unprojector as up

mpmath = pytest.importorskip("mpmath")
mp = mpmath.mp

COUNT = 40


def unit(v):
    length = mp.sqrt(sum(x * x for x in v))
    return [x / length for x in v]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def true_point(camera, px, py, depth):
    """By the rays of a pinhole, as in a textbook."""
    eye, center, up_, fovy, near, far, (width, height) = camera
    eye, center, up_ = ([mp.mpf(float(x)) for x in v] for v in (eye, center, up_))
    forward = unit([c - e for c, e in zip(center, eye)])
    side = unit(cross(forward, up_))
    upward = cross(side, forward)
    top = mp.tan(mp.radians(mp.mpf(fovy)) / 2)
    near, far, depth = mp.mpf(near), mp.mpf(far), mp.mpf(float(depth))
    z = near * far / (far * (1 - depth) + near * depth)
    x = (2 * mp.mpf(float(px)) / width - 1) * top * mp.mpf(width) / height
    y = (1 - 2 * mp.mpf(float(py)) / height) * top
    return [e + z * (f + x * s + y * u) for e, f, s, u in zip(eye, forward, side, upward)]


def cameras():
    generator = np.random.default_rng(31)
    for near, far in ((1, 100), (0.1, 10000), (0.001, 1000)):
        for _ in range(4):
            eye, center = generator.normal(scale=10, size=3), generator.normal(size=3)
            yield tuple(eye), tuple(center), (0, 1, 0), float(generator.uniform(20, 120)), near, far, (1920, 1080)


@pytest.mark.parametrize("camera", cameras(), ids=lambda c: f"{c[4]} to {c[5]}, {c[3]} degrees")
def test_points_are_the_doubles_nearest_to_the_truth(camera):
    eye, center, up_, fovy, near, far, size = camera
    setup = up.Setup.perspective(fovy=fovy, near=near, far=far, eye=eye, center=center, up=up_, size=size)
    generator = np.random.default_rng(int(fovy))
    px, py = generator.uniform(0, size[0], COUNT), generator.uniform(0, size[1], COUNT)
    depth = 1 - 10 ** generator.uniform(-7, 0, COUNT)
    points, quick = setup.unproject(px, py, depth), setup.unproject(px, py, depth, exact=False)
    with mp.workdps(60):
        for i in range(COUNT):
            true = true_point(camera, px[i], py[i], depth[i])
            ulp = np.spacing(max(abs(float(t)) for t in true))
            for k in range(3):
                assert abs(mp.mpf(float(points[i, k])) - true[k]) <= mp.mpf("0.5000001") * mp.mpf(float(ulp))
                assert abs(mp.mpf(float(quick[i, k])) - true[k]) <= 100 * mp.mpf(float(ulp))
