import copy
import pickle
import subprocess

import numpy as np
import pytest
import unprojector as up

CAMERA = {"eye": (3, 2, 5), "center": (0, 0, 0), "size": (800, 600)}
PIXELS = np.random.default_rng(3).uniform((0, 0, 0.1), (800, 600, 0.9), (50, 3)).T


def perspective(**changes):
    return up.Setup.perspective(**{**CAMERA, "fovy": 45, "near": 0.1, "far": 100, **changes})


SETUPS = {
    "perspective": perspective(),
    "viewport": perspective(viewport=(100, 50, 300, 200), depth_range=(0.2, 0.8), aspect=2),
    "reversed": perspective(depth_range=(1, 0), fovy=33.3),
    "frustum": up.Setup.frustum(left=-1, right=2, bottom=-1, top=1, near=1, far=50, **CAMERA),
    "ortho": up.Setup.ortho(left=-4, right=4, bottom=-3, top=3, near=-1, far=50, **CAMERA),
    "oblique": up.Setup.oblique(left=-4, right=4, bottom=-3, top=3, theta=60, phi=75, near=1, far=50, **CAMERA),
}
SETUPS["matrices"] = up.Setup.from_matrices(SETUPS["frustum"].projection, SETUPS["frustum"].view, size=(800, 600))
each_setup = pytest.mark.parametrize("setup", SETUPS.values(), ids=SETUPS)


def gl_frustum(left, right, bottom, top, near, far):
    return np.array(
        [
            [2 * near / (right - left), 0, (right + left) / (right - left), 0],
            [0, 2 * near / (top - bottom), (top + bottom) / (top - bottom), 0],
            [0, 0, -(far + near) / (far - near), -2 * far * near / (far - near)],
            [0, 0, -1, 0],
        ]
    )


def test_matrices_are_opengls():
    assert np.allclose(SETUPS["frustum"].projection, gl_frustum(-1, 2, -1, 1, 1, 50), rtol=1e-15)
    top = 0.1 * np.tan(np.radians(22.5))
    expected = gl_frustum(-top * 4 / 3, top * 4 / 3, -top, top, 0.1, 100)
    assert np.allclose(SETUPS["perspective"].projection, expected, rtol=1e-14, atol=1e-16)
    assert np.allclose(SETUPS["ortho"].projection, [[0.25, 0, 0, 0], [0, 1 / 3, 0, 0], [0, 0, -2 / 51, -49 / 51], [0, 0, 0, 1]])
    x, y = 1 / np.tan(np.radians([60, 75]))  # what the shear adds to x and y per unit of z, before the projection
    expected = [[0.25, 0, x / 4, 0], [0, 1 / 3, y / 3, 0], [0, 0, -2 / 49, -51 / 49], [0, 0, 0, 1]]
    assert np.allclose(SETUPS["oblique"].projection, expected, rtol=1e-15, atol=0)
    view = SETUPS["perspective"].view
    assert np.allclose(view @ [3, 2, 5, 1], [0, 0, 0, 1]) and np.allclose(view @ [0, 0, 0, 1], [0, 0, -np.sqrt(38), 1])


def test_properties_are_what_was_given():
    setup = SETUPS["viewport"]
    assert setup.size == (800, 600) and setup.viewport == (100, 50, 300, 200) and setup.depth_range == (0.2, 0.8)
    assert np.array_equal(setup.camera, [(3, 2, 5), (0, 0, 0), (0, 1, 0)])
    assert SETUPS["matrices"].camera is None
    assert setup.findings == []


@each_setup
def test_a_setup_survives_pickling_copying_and_its_text(setup):
    for again in (pickle.loads(pickle.dumps(setup)), copy.deepcopy(setup), copy.copy(setup)):
        assert again == setup and hash(again) == hash(setup) and again.findings == setup.findings
        assert np.array_equal(again.unproject(*PIXELS), setup.unproject(*PIXELS), equal_nan=True)
    assert up.Setup.from_scene(setup.to_scene()) == setup


def test_different_setups_are_not_equal():
    setups = list(SETUPS.values())
    for i, setup in enumerate(setups):
        assert [other == setup for other in setups] == [j == i for j in range(len(setups))]
    assert setups[0] != "perspective"


def test_equal_setups_have_one_hash():
    negative = perspective(center=(0, 0, -0.0))
    assert negative == perspective() and hash(negative) == hash(perspective())


def test_the_representation_names_the_camera():
    assert repr(perspective()) == "<Setup: perspective fovy 45 near 0.1 far 100, eye (3, 2, 5) center (0, 0, 0), 800x600>"
    assert repr(SETUPS["matrices"]) == "<Setup: matrix, view matrix, 800x600>"
    assert "viewport 100 50 300 200, depth range 0.2 to 0.8" in repr(SETUPS["viewport"])
    assert "theta 60 phi 75" in repr(SETUPS["oblique"])


@pytest.mark.parametrize("conventions", [c for c in up.conventions() if c != "opencv"])
@each_setup
def test_matrices_of_every_api_come_back(setup, conventions):
    given = setup.matrices(conventions)
    again = up.Setup.from_matrices(
        given["projection"], given["view"], size=setup.size, conventions=conventions,
        viewport=setup.viewport, depth_range=setup.depth_range,
    )
    expected = setup.unproject(*PIXELS, method="matrix")
    # Depths from 0 to 1 round to less than those from -1 to 1 where near is small.
    assert np.allclose(again.unproject(*PIXELS, method="matrix"), expected, rtol=1e-8, atol=1e-8, equal_nan=True)


def glm_vulkan_perspective(fovy, aspect, near, far):
    f = 1 / np.tan(np.radians(fovy) / 2)
    return np.array([[f / aspect, 0, 0, 0], [0, -f, 0, 0], [0, 0, far / (near - far), near * far / (near - far)], [0, 0, -1, 0]])


def directx_perspective(fovy, aspect, near, far):
    f = 1 / np.tan(np.radians(fovy) / 2)
    return np.array([[f / aspect, 0, 0, 0], [0, f, 0, 0], [0, 0, far / (far - near), 1], [0, 0, -near * far / (far - near), 0]])


def test_vulkans_own_matrix_gives_the_same_points():
    setup = SETUPS["perspective"]
    vulkan = up.Setup.from_matrices(
        glm_vulkan_perspective(45, 4 / 3, 0.1, 100), setup.view, size=(800, 600), conventions="vulkan"
    )
    assert np.allclose(vulkan.unproject(*PIXELS), setup.unproject(*PIXELS), rtol=1e-9, atol=1e-9)
    assert vulkan.findings == []


def test_direct3ds_own_matrix_gives_the_same_points():
    setup = SETUPS["perspective"]
    view = (np.diag([1, 1, -1, 1]) @ setup.view).T  # the world stays right-handed, and row vectors
    direct3d = up.Setup.from_matrices(
        directx_perspective(45, 4 / 3, 0.1, 100), view, size=(800, 600), conventions="direct3d"
    )
    assert np.allclose(direct3d.unproject(*PIXELS), setup.unproject(*PIXELS), rtol=1e-9, atol=1e-9)


def test_opencvs_pinhole_gives_its_own_points():
    K = np.array([[500, 0, 319.5], [0, 510, 239.5], [0, 0, 1]])
    angle = np.array([0.3, -0.2, 0.1])
    t = np.array([0.1, 0.2, 3])
    setup = up.Setup.from_opencv(K, angle, t, size=(640, 480), near=0.1, far=10)
    theta = np.linalg.norm(angle)
    x, y, z = angle / theta
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    R = np.eye(3) + np.sin(theta) * skew + (1 - np.cos(theta)) * skew @ skew
    assert np.allclose(setup.unproject(*PIXELS[:, :5]), up.Setup.from_opencv(K, R, t[:, None], size=(640, 480), near=0.1, far=10).unproject(*PIXELS[:, :5]))
    world = np.random.default_rng(4).normal(size=(20, 3))
    camera = world @ R.T + t
    uv = camera @ K.T
    uv = uv[:, :2] / uv[:, 2:]
    pixel = setup.project(world, stages=True).pixel
    assert np.allclose(pixel[:, :2], uv + 0.5, rtol=0, atol=1e-9)
    assert np.allclose(setup.unproject(*pixel.T), world, atol=1e-9)
    assert np.allclose(setup.matrices("opencv")["K"], K)


def test_a_world_with_z_negated_is_told(tmp_path):
    setup = SETUPS["frustum"]
    told = []
    for conventions in up.conventions():
        if conventions != "opencv":
            given = setup.matrices(conventions)
            again = up.Setup.from_matrices(given["projection"], given["view"], size=setup.size, conventions=conventions)
            told += [conventions for finding in again.findings if "own world has z negated" in finding]
    assert told == ["unity"]
    given = up.Setup.from_matrices(setup.projection, setup.view, size=setup.size).to_scene()
    text = given.replace('"projection"', '"conventions": "unity",\n  "projection"', 1)
    (tmp_path / "scene.json").write_text(text)
    for again in (up.Setup.from_scene(text), up.Scene.load(tmp_path / "scene.json").setup):
        assert ["own world has z negated" in finding for finding in again.findings] == [True]


def test_findings_tell_what_is_odd():
    projection, view = SETUPS["frustum"].projection, SETUPS["frustum"].view
    infinite = gl_frustum(-1, 1, -1, 1, 0.1, 100)
    infinite[2, 2:] = -1, -0.2
    reversed_z = np.array([[1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 0.1], [0, 0, -1, 0.0]])

    def findings(projection, view):
        return " ".join(up.Setup.from_matrices(projection, view, size=(800, 600)).findings)

    assert findings(projection, view) == ""
    assert "view: looks transposed" in findings(projection, view.T)
    assert "projection: looks transposed" in findings(projection.T, view)
    assert "mirrored" in findings(projection, np.diag([-1, 1, 1, 1]) @ view)
    assert "infinity" in findings(infinite, view)
    assert "revers" in findings(reversed_z, view)


WRONG = {
    "size": (lambda: perspective(size=(0, 600)), "the window is 0 x 600 pixels; width and height must be greater than 0"),
    "huge size": (lambda: perspective(size=(70000, 600)), "70000x600 pixels; give at most 65536 a side"),
    "near": (lambda: perspective(near=0), "near is 0; it must be greater than 0"),
    "far": (lambda: perspective(far=0.1), r"near is 0\.1; it must be smaller than far"),
    "fovy": (lambda: perspective(fovy=180), "the vertical field of view is 180 degrees; it must lie between 0 and 180, both excluded"),
    "eye nan": (lambda: perspective(eye=(np.nan, 0, 0)), r"eye\[0\] is nan; give a finite number"),
    "fovy nan": (lambda: perspective(fovy=np.nan), "fovy is nan; give a finite number"),
    "far inf": (lambda: perspective(far=np.inf), "far is inf; give a finite number"),
    "viewport nan": (lambda: perspective(viewport=(0, 0, np.nan, 1)), r"viewport\[2\] is nan; give a finite number"),
    "depth range nan": (lambda: perspective(depth_range=(0, np.nan)), r"depth_range\[1\] is nan; give a finite number"),
    "theta nan": (lambda: up.Setup.oblique(left=-4, right=4, bottom=-3, top=3, theta=np.nan, phi=75, near=1, far=50, **CAMERA), "theta is nan; give a finite number"),
    "t nan": (lambda: up.Setup.from_opencv(np.eye(3), np.eye(3), (0, 0, np.nan), size=(8, 6), near=1, far=2), r"t\[2\] is nan; give a finite number"),
    "R nan": (lambda: up.Setup.from_opencv(np.eye(3), (np.nan, 0, 0), (0, 0, 0), size=(8, 6), near=1, far=2), r"R\[0\] is nan; give a finite number"),
    "eye": (lambda: perspective(eye=(0, 0, 0)), "eye and center are the same point; move one of them"),
    "up": (lambda: perspective(up=(3, 2, 5)), "up points along the view direction; choose another direction"),
    "shape": (lambda: perspective(eye=(1, 2)), r"eye has the shape \(2,\); give \(3,\)"),
    "viewport": (lambda: perspective(viewport=(0, 0, 0, 100)), "the viewport is 0 x 100 pixels; width and height must be greater than 0"),
    "depth range": (lambda: perspective(depth_range=(0.5, 0.5)), r"both ends of the depth range are 0\.5; they must differ"),
    "matrix": (lambda: up.Setup.from_matrices(np.zeros((4, 4)), np.eye(4), size=(8, 6)), "projection has no inverse"),
    "entry": (lambda: up.Setup.from_matrices(np.diag([1, 1, np.inf, 1]), np.eye(4), size=(8, 6)), r"projection\[2, 2\] is inf"),
    "entry of rows": (lambda: up.Setup.from_matrices(np.where(np.arange(16).reshape(4, 4) == 14, np.inf, np.eye(4)), np.eye(4), size=(8, 6), conventions="direct3d"), r"projection\[3, 2\] is inf"),
    "3x3": (lambda: up.Setup.from_matrices(np.eye(3), np.eye(4), size=(8, 6)), r"projection has the shape \(3, 3\); give \(4, 4\)"),
    "conventions": (lambda: up.Setup.from_matrices(np.eye(4), np.eye(4), size=(8, 6), conventions="gl"), 'no conventions "gl"; known: opengl, vulkan'),
    "K": (lambda: up.Setup.from_opencv(np.ones((3, 3)), np.eye(3), (0, 0, 0), size=(8, 6), near=1, far=2), r"K\[1, 0\] is 1"),
    "R": (lambda: up.Setup.from_opencv(np.eye(3), 2 * np.eye(3), (0, 0, 0), size=(8, 6), near=1, far=2), "R is no rotation"),
    "scene": (lambda: up.Setup.from_scene("{"), "scene:1:2: the file ends too early; a bracket or a value is missing"),
}


@pytest.mark.parametrize("make, message", WRONG.values(), ids=WRONG)
def test_a_wrong_value_is_named(make, message):
    with pytest.raises(ValueError, match=message):
        make()


def test_a_camera_file_makes_a_setup(tmp_path):
    file = tmp_path / "Kamera ä 相机.json"
    file.write_text('{"K": [[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]], "R": [[1,0,0],[0,1,0],[0,0,1]], "t": [0, 0, 2], "image_size": [640, 480]}')
    setup = up.Setup.from_camera(file, near=0.1, far=10)
    expected = up.Setup.from_opencv([[500, 0, 319.5], [0, 500, 239.5], [0, 0, 1]], np.eye(3), (0, 0, 2), size=(640, 480), near=0.1, far=10)
    assert setup == expected
    assert up.Setup.from_camera(text=file.read_text(), near=0.1, far=10) == expected
    wide = tmp_path / "wide.json"
    wide.write_text(file.read_text(), encoding="utf-16")  # as PowerShell's > writes it
    assert up.Setup.from_camera(wide, near=0.1, far=10) == expected
    with pytest.raises(OSError, match="this is a folder; give the name of a file"):
        up.Setup.from_camera(tmp_path)
    with pytest.raises(OSError, match="none.json: there is no such file"):
        up.Setup.from_camera(tmp_path / "none.json")
    with pytest.raises(ValueError, match="text: has no camera"):
        up.Setup.from_camera(text="hello")


def test_a_camera_is_told_the_names_of_arguments():
    lens = "K: [500, 0, 320, 0, 500, 240, 0, 0, 1]\nR: [1, 0, 0, 0, 1, 0, 0, 0, 1]\nt: [0, 0, 2]\n"
    setup = up.Setup.from_camera(text=lens, near=1)
    assert any("; pose says otherwise" in said for said in setup.findings)
    assert not any("--" in said for said in setup.findings)
    half = up.Setup.from_camera(text=lens, near=1, pixel_centers="half")
    point = (0.5, 0.5, 1)
    np.testing.assert_allclose(setup.project(point, stages=True).pixel - half.project(point, stages=True).pixel, (0.5, 0.5, 0))
    unnamed = lens.split("R")[0] + "T: [1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]"
    with pytest.raises(ValueError, match="Choose with pose camera-to-world or pose world-to-camera"):
        up.Setup.from_camera(text=unnamed)
    two = "[{%s, \"t\": [0, 0, 2]}, {%s, \"t\": [0, 0, 3]}]" % (('"K": [[500, 0, 320], [0, 500, 240], [0, 0, 1]], "R": [[1,0,0],[0,1,0],[0,0,1]]',) * 2)
    assert up.Setup.from_camera(text=two, near=1, far=9, image=1) == up.Setup.from_camera(text=two, near=1, far=9, image="1")
    with pytest.raises(TypeError, match="a file is no path"):
        up.Setup.from_camera(["a.json"])
    with pytest.raises(ValueError, match="width and height must be at least 1 pixel"):
        up.Setup.from_camera(text=lens, size=(0, 0))
    with pytest.raises(TypeError, match="text is not a str"):
        up.Setup.from_camera(text=[lens])
    with pytest.raises(TypeError, match="needs files or text=, not both"):
        up.Setup.from_camera("a.json", text=lens)
    with pytest.raises(ValueError, match='no pixel centers "third"; known: integer, half'):
        up.Setup.from_camera(text=lens, pixel_centers="third")


def test_sentences_are_those_of_the_command(tmp_path, unproject_command):
    scene = tmp_path / "scene.json"
    text = perspective().to_scene()
    for old, new in (('"fovy": 45', '"fovy": 200'), ('"near": 0.1', '"near": -1'), ('"width": 800', '"width": 0')):
        assert old in text
        scene.write_text(text.replace(old, new))
        said = subprocess.run(
            [unproject_command, "points", str(scene), "-"], capture_output=True, text=True, input="px,py,depth\n"
        ).stderr
        with pytest.raises(ValueError) as caught:
            up.Setup.from_scene(scene.read_text())
        assert said.strip().endswith(str(caught.value).removeprefix("scene")), said
