import subprocess
import warnings

import numpy as np
import pytest
import unprojector as up

SIZE = (67, 45)


@pytest.fixture
def setup():
    return up.Setup.perspective(fovy=45, near=0.5, far=20, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)


def z_image(seed=7):
    z = np.random.default_rng(seed).uniform(0.6, 19, SIZE[::-1])
    z[3, 4:9] = 0, np.nan, np.inf, -1, 0.3
    z[5, 5:7] = 20, 25
    return z


def window_depths(setup, z):
    n, f = 0.5, 20
    with np.errstate(all="ignore"):
        return f * (z - n) / (z * (f - n))


def ply_points(file):
    data = file.read_bytes()
    header, body = data.split(b"end_header\n", 1)
    kind = "<f8" if b"property double" in header else "<f4"
    return np.frombuffer(body, kind).reshape(-1, 3)


IMAGES = {
    "z, float32": (lambda s: z_image().astype(np.float32), {"depth_is": "z"}),
    "z, float64": (lambda s: z_image(), {"depth_is": "z"}),
    "z, millimetres": (lambda s: np.nan_to_num(1000 * z_image(), posinf=0).clip(0, 65535).astype(np.uint16), {"depth_is": "z", "scale": 1000}),
    "distance": (lambda s: z_image().astype(np.float32), {"depth_is": "distance"}),
    "disparity": (lambda s: (30 / z_image()).astype(np.float32), {"depth_is": "disparity", "baseline": 0.5}),
    "buffer, float32": (lambda s: window_depths(s, z_image()).astype(np.float32), {"depth_is": "buffer"}),
    "buffer, float64": (lambda s: window_depths(s, z_image()), {"depth_is": "buffer"}),
    "buffer, uint16": (lambda s: (65535 * np.nan_to_num(window_depths(s, z_image()), posinf=1, neginf=0).clip(0, 1)).astype(np.uint16), {"depth_is": "buffer"}),
    "range, float32": (lambda s: window_depths(s, z_image()).astype(np.float32), {"depth_is": "range"}),
}


@pytest.mark.parametrize("precision", ["double", "float"])
@pytest.mark.parametrize("method", ["formula", "matrix"])
@pytest.mark.parametrize("image, options", IMAGES.values(), ids=IMAGES)
def test_digits_are_those_of_the_command(setup, image, options, method, precision, tmp_path, unproject_command):
    depth = image(setup)
    np.save(tmp_path / "depth.npy", depth)
    (tmp_path / "scene.json").write_text(setup.to_scene())
    words = ["--depth-is", options["depth_is"]]
    if "scale" in options:
        words += ["--depth-scale", str(options["scale"])]
    if "baseline" in options:
        words += ["--baseline", str(options["baseline"])]
    subprocess.run(
        [unproject_command, "cloud", str(tmp_path / "scene.json"), str(tmp_path / "depth.npy"), *words, "--method", method,
         "--precision", precision, "-o", str(tmp_path / "cloud.ply")],
        check=True, capture_output=True,
    )
    points = setup.cloud(depth, method=method, dtype=np.float32 if precision == "float" else None, **options)
    kept = points[~np.isnan(points[..., 0])]
    expected = ply_points(tmp_path / "cloud.ply")
    assert kept.dtype == expected.dtype and len(expected) > 1000
    assert np.array_equal(kept, expected)


@pytest.mark.parametrize("depth_range", [(1, 0), (0.2, 0.8), (0.9, 0.3)])
@pytest.mark.parametrize("box", [False, True])
@pytest.mark.parametrize("depth_is", ["buffer", "range", "z", "distance"])
def test_other_depth_ranges_and_a_box_have_the_commands_digits(depth_is, box, depth_range, tmp_path, unproject_command):
    camera = {"near": 0.5, "far": 20, "eye": (3, 2, 5), "center": (0, 0, 0), "size": SIZE, "depth_range": depth_range}
    if box:
        setup = up.Setup.ortho(left=-2, right=2, bottom=-1, top=1, **camera)
    else:
        setup = up.Setup.perspective(fovy=45, **camera)
    (tmp_path / "scene.json").write_text(setup.to_scene())
    share = np.random.default_rng(1).uniform(0, 1, SIZE[::-1])
    share[0, :5] = 0, 1, np.nan, np.inf, -0.1
    z = z_image()
    z[0, :2] = 0.5, 20
    numbers = {"buffer": depth_range[0] + (depth_range[1] - depth_range[0]) * share, "range": share}.get(depth_is, z)
    for depth in (numbers, numbers.astype(np.float32)):
        np.save(tmp_path / "depth.npy", depth)
        subprocess.run(
            [unproject_command, "cloud", str(tmp_path / "scene.json"), str(tmp_path / "depth.npy"), "--depth-is", depth_is,
             "--precision", "double", "-o", str(tmp_path / "cloud.ply")],
            check=True, capture_output=True,
        )
        points, counts = setup.cloud(depth, depth_is=depth_is, counts=True)
        kept = points[~np.isnan(points[..., 0])]
        assert len(kept) == counts["kept"] > 1000
        assert np.array_equal(kept, ply_points(tmp_path / "cloud.ply"))


def test_points_are_where_a_pinhole_sees_them(setup):
    z = np.random.default_rng(1).uniform(1, 15, SIZE[::-1])
    points = setup.cloud(z, depth_is="z")
    pixel = setup.project(points, stages=True)
    assert np.allclose(-pixel.eye[..., 2], z, rtol=1e-12)
    x, y = np.meshgrid(np.arange(SIZE[0]) + 0.5, np.arange(SIZE[1]) + 0.5)
    assert np.allclose(pixel.pixel[..., 0], x, atol=1e-9) and np.allclose(pixel.pixel[..., 1], y, atol=1e-9)
    ray = setup.cloud(z, depth_is="distance")
    assert np.allclose(np.linalg.norm(ray - [3, 2, 5], axis=-1), z, rtol=1e-12)
    box = up.Setup.ortho(left=-2, right=2, bottom=-1, top=1, near=-5, far=20, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)
    assert np.allclose(-box.project(box.cloud(z, depth_is="z"), stages=True).eye[..., 2], z, rtol=1e-12)


def test_layouts_stacks_and_out(setup):
    z = z_image().astype(np.float32)
    expected = setup.cloud(z, depth_is="z")
    wide = np.zeros((SIZE[1], 3 * SIZE[0]), np.float32)
    wide[:, ::3] = z
    for same in (np.asfortranarray(z), wide[:, ::3], z[::-1].copy()[::-1], z.astype(">f4")):
        assert np.array_equal(setup.cloud(same, depth_is="z"), expected, equal_nan=True)
    stack = np.stack([z, z[::-1], z * 2])
    clouds = setup.cloud(stack, depth_is="z", threads=3)
    assert clouds.shape == (3, *SIZE[::-1], 3)
    for image, cloud in zip(stack, clouds):
        assert np.array_equal(setup.cloud(image, depth_is="z", threads=1), cloud, equal_nan=True)
    for out in (np.empty_like(expected), np.empty((3, *SIZE[::-1])).transpose(1, 2, 0), np.empty(expected.shape, np.float32)):
        assert setup.cloud(z, depth_is="z", out=out) is out
        assert np.array_equal(out, expected.astype(out.dtype), equal_nan=True)
    z.flags.writeable = False
    assert np.array_equal(setup.cloud(z, depth_is="z"), expected, equal_nan=True)


def test_pixels_without_a_point_are_counted(setup):
    points, counts = setup.cloud(z_image(), depth_is="z", counts=True)
    assert counts == {
        "kept": SIZE[0] * SIZE[1] - 7, "zero": 1, "nan": 1, "infinite": 1, "negative": 1, "before near": 1, "at far": 2, "outside range": 0, "no data": 0,
    }
    assert np.isnan(points).all(axis=-1).sum() == 7 and np.isnan(points[3, 4:9]).all()


def test_numbers_without_a_measurement_have_no_point(setup):
    millimetres = (1000 * z_image().clip(1, 15)).astype(np.uint16)
    millimetres[3, 4:9] = 2000
    millimetres[7, 1:4] = 65535
    millimetres[8, 1:3] = 9999
    far = up.Setup.perspective(fovy=45, near=0.5, far=200, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)
    whole = far.cloud(millimetres, depth_is="z", scale=1000)
    assert not np.isnan(whole).any()
    for no_data, count in ((65535, 3), ([65535], 3), (np.array([9999, 65535]), 5), (np.uint16(9999), 2), ([], 0), (None, 0)):
        points, counts = far.cloud(millimetres, depth_is="z", scale=1000, no_data=no_data, counts=True)
        left_out = np.isnan(points).all(axis=-1)
        assert counts["no data"] == left_out.sum() == count and counts["kept"] == millimetres.size - count
        assert np.array_equal(points[~left_out], whole[~left_out])
        single = far.cloud(millimetres, depth_is="z", scale=1000, no_data=no_data, dtype=np.float32)
        assert np.array_equal(single, points.astype(np.float32), equal_nan=True)
    tenths = np.full(SIZE[::-1], np.float32(0.1))
    with pytest.warns(UserWarning, match="no pixel has a point"):
        assert np.isnan(far.cloud(tenths, depth_is="buffer", no_data=0.1)).all()


def test_an_offset_is_added_to_disparities(setup):
    with np.errstate(divide="ignore"):
        disparity = 30 / z_image() - 2.5
    points = setup.cloud(disparity, depth_is="disparity", baseline=0.5, disparity_offset=2.5)
    expected = setup.cloud(disparity + 2.5, depth_is="disparity", baseline=0.5)
    assert np.array_equal(points, expected, equal_nan=True) and (disparity < 0).any()


def test_no_point_at_all_is_a_warning(setup):
    with pytest.warns(UserWarning, match="no pixel has a point; check depth_is"):
        assert np.isnan(setup.cloud(np.full(SIZE[::-1], 5000.0), depth_is="z")).all()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        setup.cloud(np.full(SIZE[::-1], 5.0), depth_is="z")


@pytest.mark.parametrize(
    "depth, options, kind, message",
    [
        (np.zeros((4, 5)), {"depth_is": "z"}, ValueError, r"depth has the shape \(4, 5\); the setup's window has 45 rows and 67 columns"),
        (np.zeros(5), {"depth_is": "z"}, ValueError, r"depth has the shape \(5,\)"),
        (np.zeros((45, 67)), {"depth_is": "depth"}, ValueError, 'depth_is is "depth"'),
        (np.zeros((45, 67)), {}, TypeError, "depth_is"),
        (np.zeros((45, 67)), {"depth_is": "buffer", "scale": 1000}, ValueError, "scale goes with depth_is z"),
        (np.zeros((45, 67)), {"depth_is": "z", "scale": 0}, ValueError, "scale is 0; it must be greater than 0"),
        (np.zeros((45, 67)), {"depth_is": "disparity"}, ValueError, "depth_is disparity needs baseline"),
        (np.zeros((45, 67)), {"depth_is": "z", "disparity_offset": 1}, ValueError, "disparity_offset goes with depth_is disparity"),
        (np.zeros((45, 67)), {"depth_is": "disparity", "baseline": 1, "disparity_offset": np.nan}, ValueError, "disparity_offset is nan; it must be a finite number"),
        (np.zeros((45, 67)), {"depth_is": "z", "no_data": "65535"}, TypeError, "no_data"),
        (np.zeros((45, 67), int), {"depth_is": "buffer"}, ValueError, "window depths as whole numbers have 8 or 16 bits"),
        (np.zeros((45, 67), complex), {"depth_is": "z"}, TypeError, "depth has the type complex128"),
        (np.zeros((45, 67)), {"depth_is": "z", "dtype": int}, ValueError, "dtype is int64; give float64 or float32"),
        (np.zeros((45, 67)), {"depth_is": "z", "out": np.zeros((45, 67, 2))}, ValueError, r"out has the shape \(45, 67, 2\)"),
    ],
)
def test_wrong_arguments_are_named(setup, depth, options, kind, message):
    with pytest.raises(kind, match=message):
        setup.cloud(depth, **options)


def test_depth_files_are_read(tmp_path):
    for name, image in (("a.npy", z_image()), ("b.npy", z_image().astype(np.float32)), ("c.npy", np.arange(12, dtype=np.uint16).reshape(3, 4))):
        np.save(tmp_path / name, image)
        read = up.read_depth(tmp_path / name)
        assert read.dtype == image.dtype and np.array_equal(read, image, equal_nan=True)
    (tmp_path / "ä.pgm").write_bytes(b"P5 3 2 65535\n" + np.arange(6, dtype=">u2").tobytes())
    assert np.array_equal(up.read_depth(tmp_path / "ä.pgm"), np.arange(6).reshape(2, 3))
    (tmp_path / "up.pfm").write_bytes(b"Pf\n3 2\n-1\n" + np.arange(6, dtype="<f4").tobytes())
    assert np.array_equal(up.read_depth(tmp_path / "up.pfm"), [[3, 4, 5], [0, 1, 2]])
    (tmp_path / "depth.bin").write_bytes(b"3&2&1&" + np.arange(6, dtype="<f4").tobytes())
    assert np.array_equal(up.read_depth(tmp_path / "depth.bin"), [[0, 1, 2], [3, 4, 5]])
    (tmp_path / "nyu.pgm").write_bytes(b"P5 3 2 65535\n" + np.arange(6, dtype="<u2").tobytes())
    assert np.array_equal(up.read_depth(tmp_path / "nyu.pgm", byte_order="little"), np.arange(6).reshape(2, 3))
    with pytest.raises(ValueError, match="byte_order"):
        up.read_depth(tmp_path / "nyu.pgm", byte_order="middle")
    (tmp_path / "low.pgm").write_bytes(b"P5 3 2 255\n" + bytes(range(6)))
    with pytest.raises(ValueError, match="byte_order is for PGM of 16 bits"):
        up.read_depth(tmp_path / "low.pgm", byte_order="little")
    with pytest.raises(FileNotFoundError, match="none.png: there is no such file"):
        up.read_depth(tmp_path / "none.png")
    (tmp_path / "text.png").write_text("hello")
    with pytest.raises(ValueError, match="text.png"):
        up.read_depth(tmp_path / "text.png")
