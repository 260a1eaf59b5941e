import pickle
import subprocess
import threading
import time

import numpy as np
import pytest
import unprojector as up

SIZE = (800, 600)


@pytest.fixture
def setup():
    return up.Setup.perspective(fovy=45, near=0.1, far=100, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)


def random_pixels(count, seed=1):
    generator = np.random.default_rng(seed)
    return generator.uniform(0, SIZE[0], count), generator.uniform(0, SIZE[1], count), generator.uniform(0, 1, count)


def numpy_unprojected(setup, px, py, depth):
    """The usual code of NumPy users, written apart from the module."""
    ndc = np.stack([2 * px / SIZE[0] - 1, 1 - 2 * py / SIZE[1], 2 * depth - 1, np.ones_like(depth)], axis=-1)
    world = ndc @ np.linalg.inv(setup.projection @ setup.view).T
    return world[..., :3] / world[..., 3:]


SHAPES = {
    "scalars": (400.5, 300.5, 0.5, (3,)),
    "0-d": (np.array(400.5), 300.5, np.array(0.5), (3,)),
    "lists": ([400.5, 10], [300.5, 20], [0.5, 0.25], (2, 3)),
    "whole numbers": (np.arange(5), np.arange(5), 0.5, (5, 3)),
    "image": (np.arange(7) + 0.5, np.arange(4)[:, None] + 0.5, np.full((4, 7), 0.5), (4, 7, 3)),
    "repeated depth": (np.arange(7) + 0.5, np.arange(4)[:, None] + 0.5, 0.5, (4, 7, 3)),
    "stack": (np.arange(7) + 0.5, np.arange(4)[:, None] + 0.5, np.full((2, 4, 7), 0.5), (2, 4, 7, 3)),
    "nothing": (np.empty(0), 1.0, 0.5, (0, 3)),
    "nothing, two axes": (np.empty((2, 0)), 1.0, 0.5, (2, 0, 3)),
}


@pytest.mark.parametrize("px, py, depth, shape", SHAPES.values(), ids=SHAPES)
def test_shapes_broadcast(setup, px, py, depth, shape):
    points = setup.unproject(px, py, depth)
    assert points.shape == shape and points.dtype == np.float64
    flat = [np.broadcast_to(a, shape[:-1]).ravel() for a in (px, py, depth)]
    each = np.array([setup.unproject(*pixel) for pixel in zip(*flat)]).reshape(shape)
    assert np.array_equal(points, each)


LAYOUTS = {
    "every other": lambda a: np.repeat(a, 2)[::2],
    "backwards": lambda a: a[::-1].copy()[::-1],
    "float32": lambda a: a.astype(np.float32),
    "float32, every third": lambda a: np.repeat(a.astype(np.float32), 3)[::3],
    "other byte order": lambda a: a.astype(">f8"),
    "two axes, columns first": lambda a: np.asfortranarray(a.reshape(40, -1)),
    "unaligned": lambda a: np.frombuffer(b"x" + a.tobytes(), np.uint8)[1:].view(np.float64),
}


@pytest.mark.parametrize("layout", LAYOUTS.values(), ids=LAYOUTS)
def test_every_layout_gives_the_same_digits(setup, layout):
    numbers = [a.astype(np.float32).astype(np.float64) for a in random_pixels(4000)]
    expected = setup.unproject(*numbers)
    given = [layout(a) for a in numbers]
    for a in given:
        a.flags.writeable = False
    points = setup.unproject(*given)
    assert np.array_equal(points.reshape(-1, 3), expected)


@pytest.mark.parametrize("exact", [True, False])
@pytest.mark.parametrize("method", ["formula", "matrix"])
def test_points_are_where_numpy_has_them(setup, method, exact):
    pixels = random_pixels(1000)
    points = setup.unproject(*pixels, method=method, exact=exact)
    assert np.allclose(points, numpy_unprojected(setup, *pixels), rtol=0, atol=1e-8)
    eye = setup.unproject(*pixels, method=method, exact=exact, space="eye")
    assert np.allclose(eye, points @ setup.view[:3, :3].T + setup.view[:3, 3], rtol=0, atol=1e-9)


def test_pixels_without_an_answer_are_nan(setup):
    points = setup.unproject([1, 1, 1, np.nan, np.inf, 1], 1, [-0.1, 1.1, np.nan, 0.5, 0.5, 0.5])
    assert np.isnan(points[:5]).all() and np.isfinite(points[5]).all()
    points, bounds = setup.unproject(1, 1, [2, 1], uncertainty=True)
    assert np.isnan(bounds[0]).all() and np.isfinite(bounds[1]).all()


def test_out_receives_the_points(setup):
    pixels = random_pixels(2000)
    expected = setup.unproject(*pixels)
    for out in (np.empty((2000, 3)), np.empty((3, 2000)).T, np.empty((2000, 6))[:, ::2]):
        assert setup.unproject(*pixels, out=out) is out
        assert np.array_equal(out, expected)
    out = np.empty((2000, 3), np.float32)
    setup.unproject(*pixels, out=out)
    assert np.array_equal(out, expected.astype(np.float32))


def test_wrong_arguments_are_named(setup):
    shared = np.zeros((4, 3))
    read_only = np.zeros((4, 3))
    read_only.flags.writeable = False
    for arguments, options, kind, message in [
        ((np.zeros(3), np.zeros(4), 0), {}, ValueError, r"these shapes do not broadcast: px \(3,\), py \(4,\), depth \(\)"),
        ((1, 1, 0.5), {"method": "matirx"}, ValueError, 'method is "matirx"'),
        ((1, 1, 0.5), {"space": "clip"}, ValueError, 'space is "clip"'),
        ((1, 1, 0.5), {"depth_bits": 0}, ValueError, "depth buffer of 0 bits"),
        ((1, 1, 0.5), {"depth_bits": "double"}, ValueError, 'depth_bits is "double"'),
        ((1, 1, 0.5), {"depth_bits": 2**40}, ValueError, "depth_bits is 1099511627776"),
        ((1, 1, 0.5), {"depth_bits": 24.5}, TypeError, 'depth_bits is 24.5; give 1 to 32, or "float"'),
        ((1, 1, 0.5), {"threads": 0}, ValueError, "threads is 0"),
        ((1, 1, 0.5), {"threads": -(2**70)}, ValueError, f"threads is -{2**70}"),
        ((1, 1, 0.5), {"threads": "2"}, TypeError, "threads is '2'; give 1 or more"),
        (("a", 1, 0.5), {}, TypeError, "px has the type"),
        ((1, 1j, 0.5), {}, TypeError, "py has the type complex128"),
        ((1, 1, [[1], [1, 2]]), {}, TypeError, "depth is no array of numbers|depth has the type object"),
        ((np.zeros(4), 1, 0.5), {"out": np.zeros((3, 3))}, ValueError, r"out has the shape \(3, 3\); give \(4, 3\)"),
        ((np.zeros(4), 1, 0.5), {"out": np.zeros((4, 3), int)}, ValueError, "out has the type int64"),
        ((np.zeros(4), 1, 0.5), {"out": read_only}, ValueError, "out is read-only"),
        ((shared[:, 0], 1, 0.5), {"out": shared}, ValueError, "out shares memory with px"),
    ]:
        with pytest.raises(kind, match=message):
            setup.unproject(*arguments, **options)


def test_uncertainty_holds_the_rounding_of_the_depth(setup):
    px, py, depth = random_pixels(2000)
    depth = 0.9 + 0.1 * depth
    for bits, steps in ((16, 2**16 - 1), (24, 2**24 - 1), ("float", None)):
        kept = depth.astype(np.float32).astype(float) if steps is None else np.round(depth * steps) / steps
        points, bounds = setup.unproject(px, py, kept, uncertainty=True, depth_bits=bits)
        true = setup.unproject(px, py, depth)
        assert np.array_equal(points, setup.unproject(px, py, kept))
        assert (np.abs(points - true) <= bounds).all()
        # They are not needlessly large: some true point lies near the bound.
        assert np.max(np.abs(points - true) / bounds) > 0.9
    eye, bounds = setup.unproject(px, py, kept, uncertainty=True, depth_bits="float", space="eye")
    assert (np.abs(eye - setup.unproject(px, py, depth, space="eye")) <= bounds).all()


def command_rows(command, scene, arguments, header, rows, tmp_path):
    text = header + "\n" + "\n".join(",".join(repr(float(v)) for v in row) for row in rows) + "\n"
    (tmp_path / "rows.csv").write_text(text)
    result = subprocess.run([command, *arguments, str(scene), str(tmp_path / "rows.csv")], capture_output=True, check=True, text=True)
    lines = result.stdout.splitlines()
    return lines[0].split(","), [[float(cell or "nan") for cell in line.split(",")] for line in lines[1:]]


def test_digits_are_those_of_the_commands(setup, tmp_path, unproject_command):
    scene = tmp_path / "scene.json"
    scene.write_text(
        '{"unprojector": 1, "window": {"width": 800, "height": 600}, "projection": {"type": "perspective", "fovy": 45,'
        ' "near": 0.1, "far": 100}, "view": {"eye": [3, 2, 5], "center": [0, 0, 0], "up": [0, 1, 0]}}'
    )
    pixels = np.stack(random_pixels(500), axis=-1)
    for space in ("world", "eye"):
        names, rows = command_rows(unproject_command, scene, ["points", "--space", space], "px,py,depth", pixels, tmp_path)
        for method in ("formula", "matrix"):
            columns = [i for i, name in enumerate(names) if name.startswith(method)][:3]
            expected = np.array(rows)[:, columns]
            assert np.array_equal(setup.unproject(*pixels.T, method=method, space=space), expected)
    points = setup.unproject(*pixels.T)
    names, rows = command_rows(unproject_command, scene, ["project"], "x,y,z", points, tmp_path)
    rows = np.array(rows)
    stages = setup.project(points, stages=True)
    for name, labels in {
        "eye": ["eye_x", "eye_y", "eye_z"],
        "clip": ["clip_x", "clip_y", "clip_z", "clip_w"],
        "ndc": ["ndc_x", "ndc_y", "ndc_z"],
        "window": ["window_x", "window_y", "window_z"],
        "pixel": ["px", "py", "depth"],
    }.items():
        expected = rows[:, [names.index(label) for label in labels]]
        assert np.array_equal(getattr(stages, name), expected), name
    assert np.array_equal(setup.project(points), stages.window)


def test_projecting_undoes_unprojecting(setup):
    pixels = np.stack(random_pixels(1000), axis=-1)
    points = setup.unproject(*pixels.T)
    back = setup.project(points, stages=True).pixel
    assert np.allclose(back[:, :2], pixels[:, :2], rtol=0, atol=1e-9)
    assert np.allclose(back[:, 2], pixels[:, 2], rtol=0, atol=1e-12)
    eye = setup.unproject(*pixels.T, space="eye")
    assert np.allclose(setup.project(eye, space="eye"), setup.project(points), rtol=0, atol=1e-9)
    image = points.reshape(10, 100, 3)
    assert np.array_equal(setup.project(image), setup.project(points).reshape(10, 100, 3))
    assert np.array_equal(setup.project(np.asfortranarray(image)), setup.project(image))
    assert setup.project([0, 0, 0]).shape == (3,)
    with pytest.raises(ValueError, match=r"points has the shape \(2,\); give \(\.\.\., 3\)"):
        setup.project([1, 2])


def test_stages_survive_pickling(setup):
    stages = setup.project([[0, 0, 0], [1, 0, 0]], stages=True)
    again = pickle.loads(pickle.dumps(stages))
    assert type(again) is up.Stages
    assert all(np.array_equal(a, b) for a, b in zip(again, stages))


def test_a_point_in_the_plane_of_the_eye_has_no_window_position(setup):
    stages = setup.project([3, 2, 5], stages=True)
    assert np.isfinite(stages.eye).all() and np.isfinite(stages.clip).all()
    assert np.isnan(stages.ndc).all() and np.isnan(stages.window).all() and np.isnan(stages.pixel).all()


def test_any_number_of_threads_gives_the_same_bytes(setup):
    pixels = random_pixels(300_000)
    expected = setup.unproject(*pixels, threads=1)
    assert np.array_equal(setup.unproject(*pixels), expected)
    assert np.array_equal(setup.unproject(*pixels, threads=7), expected)
    results = [None] * 6

    def compute(i):
        results[i] = setup.unproject(*pixels)

    threads = [threading.Thread(target=compute, args=(i,)) for i in range(len(results))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, expected) for result in results)


def test_other_threads_run_meanwhile(setup):
    pixels = random_pixels(2_000_000)
    is_done = threading.Event()
    ticks = 0

    def compute():
        for _ in range(5):
            setup.unproject(*pixels, threads=1)
        is_done.set()

    thread = threading.Thread(target=compute)
    thread.start()
    while not is_done.is_set():
        ticks += 1
        time.sleep(0.001)
    thread.join()
    # With the GIL held, this thread would wake once a call.
    assert ticks > 10


def test_calls_keep_no_references_and_no_memory(setup):
    import sys
    import tracemalloc

    pixels = random_pixels(1000)
    out = np.empty((1000, 3))
    before = [sys.getrefcount(a) for a in (*pixels, out, setup)]
    tracemalloc.start()

    def call():
        for _ in range(200):
            setup.unproject(*pixels, out=out)
            setup.unproject(*pixels, uncertainty=True)
            setup.project(out, stages=True)
            with pytest.raises(ValueError):
                setup.unproject(*pixels, method="x")

    call()
    first = tracemalloc.get_traced_memory()[0]
    call()
    grown = tracemalloc.get_traced_memory()[0] - first
    tracemalloc.stop()
    assert [sys.getrefcount(a) for a in (*pixels, out, setup)] == before
    # Python keeps some freed objects for later use. A result a call would be 4.8 million bytes.
    assert grown < 1_000_000
