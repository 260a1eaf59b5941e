import json
import subprocess

import numpy as np
import pytest
import unprojector as up

SIZE = (400, 300)


def obj_text(vertices, triangles):
    lines = ["v " + " ".join(repr(float(c)) for c in v) for v in vertices]
    return "\n".join(lines + ["f " + " ".join(str(i + 1) for i in t) for t in triangles]) + "\n"


def terrain(n=20):
    """A bumpy square of 2 n n triangles."""
    x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))
    vertices = np.stack([x, y, 0.2 * np.sin(5 * x) * np.cos(4 * y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    triangles = np.concatenate(
        [np.stack([corner, corner + 1, corner + n + 2], axis=-1), np.stack([corner, corner + n + 2, corner + n + 1], axis=-1)]
    )
    return vertices, triangles


@pytest.fixture
def folder(tmp_path):
    """A scene with a terrain, a hidden triangle before it, and a clip plane."""
    (tmp_path / "terrain ä 地形.obj").write_text(obj_text(*terrain()))
    (tmp_path / "triangle.obj").write_text(obj_text([(-1, -1, 0), (1, -1, 0), (0, 1, 0)], [(0, 1, 2)]))
    scene = {
        "unprojector": 1,
        "window": {"width": SIZE[0], "height": SIZE[1]},
        "projection": {"type": "perspective", "fovy": 45, "near": 0.1, "far": 100},
        "view": {"eye": [0.5, -2, 3], "center": [0, 0, 0], "up": [0, 1, 0]},
        "objects": [
            {"name": "ground", "file": "terrain ä 地形.obj", "transform": [{"translate": [0.1, 0, 0]}]},
            {"name": "veil", "file": "triangle.obj", "transform": [{"translate": [0, 0, 1]}], "hidden": True},
        ],
        "clipPlanes": [[1, 0, 0, 0.7]],
        "author": "somebody",
    }
    (tmp_path / "scene.json").write_text(json.dumps(scene), encoding="utf-8")
    return tmp_path


def pixels(count=200):
    return np.random.default_rng(5).uniform((-10, -10), (SIZE[0] + 10, SIZE[1] + 10), (count, 2)).T


@pytest.mark.parametrize("snap", ["surface", "vertex", "edge", "face"])
def test_digits_are_those_of_the_command(folder, snap, unproject_command):
    scene = up.Scene.load(folder / "scene.json")
    px, py = pixels()
    rows = "px,py\n" + "".join(f"{x!r},{y!r}\n" for x, y in zip(px.tolist(), py.tolist()))
    result = subprocess.run(
        [unproject_command, "pick", str(folder / "scene.json"), "-", "--snap", snap], input=rows, capture_output=True, text=True, encoding="utf-8"
    )
    names, *lines = [line.split(",") for line in result.stdout.splitlines()]

    def column(*labels):
        numbers = [[float(line[names.index(label)] or "nan") for line in lines] for label in labels]
        return np.array(numbers).T.squeeze()

    hits = scene.pick(px, py, snap=snap)
    assert hits["hit"].sum() > 30 and (~hits["hit"]).sum() > 50
    assert hits.shape == px.shape
    for field, labels in {
        "world": "xyz",
        "uncertainty": ("dx", "dy", "dz"),
        "distance": ("distance",),
        "object_point": ("object_x", "object_y", "object_z"),
        "barycentric": "uvw",
        "normal": ("normal_x", "normal_y", "normal_z"),
    }.items():
        assert np.array_equal(hits[field], column(*labels), equal_nan=True), field
    for field, labels in {"triangle": ("triangle",), "vertex": ("vertex",), "edge": ("edge_from", "edge_to")}.items():
        assert np.array_equal(hits[field], np.nan_to_num(column(*labels), nan=-1)), field
    outside = (px < 0) | (py < 0) | (px > SIZE[0]) | (py > SIZE[1])
    assert np.array_equal(hits["outside"], outside)
    assert f"{outside.sum()} pixels lie outside" in result.stderr


def test_a_hit_lies_on_its_triangle(folder):
    vertices, triangles = terrain()
    scene = up.Scene.load(folder / "scene.json")
    hits = scene.pick(*pixels())
    hits = hits[hits["hit"]]
    corners = vertices[triangles[hits["triangle"]]]
    assert np.array_equal(np.sort(hits["vertices"]), np.sort(triangles[hits["triangle"]]))
    assert np.allclose(np.einsum("ij,ijk->ik", hits["barycentric"], corners), hits["object_point"], atol=1e-12)
    assert np.allclose(hits["object_point"] + [0.1, 0, 0], hits["world"], atol=1e-12)
    assert (hits["object"] == 0).all() and (hits["world"][:, 0] >= -0.7).all()
    assert np.allclose(hits["vertex_world"], vertices[hits["vertex"]] + [0.1, 0, 0], atol=1e-12)


def test_arrays_make_the_same_mesh(folder):
    loaded = up.Scene.load(folder / "terrain ä 地形.obj")
    vertices, triangles = terrain()
    for kinds in ((float, np.int64), (float, np.uint32), (np.float32, np.int16)):
        made = up.Scene.from_arrays(loaded.setup, vertices.astype(kinds[0]), triangles.astype(kinds[1]))
        assert made.objects[0].triangles == 800 and made.objects[0].vertices == 441
    made = up.Scene.from_arrays(loaded.setup, vertices, triangles)
    px, py = np.random.default_rng(6).uniform((0, 0), (800, 600), (300, 2)).T
    a, b = loaded.pick(px, py), made.pick(px, py)
    assert a["hit"].sum() > 50
    for name in a.dtype.names:
        assert np.array_equal(a[name], b[name], equal_nan=a[name].dtype.kind == "f"), name


def test_any_number_of_threads_and_any_shape_give_the_same(folder):
    scene = up.Scene.load(str(folder / "scene.json"))
    x, y = np.arange(0, 400, 7) + 0.5, (np.arange(0, 300, 7) + 0.5)[:, None]
    image = scene.pick(x, y)
    assert image.shape == (43, 58)
    flat = scene.pick(*(a.ravel() for a in np.broadcast_arrays(x, y)), threads=1)
    assert image.tobytes() == flat.tobytes()
    one = scene.pick(200.5, 150.5)
    assert one.shape == () and one["hit"]
    assert scene.pick([], []).shape == (0,)


def test_another_setup_sees_the_scene_from_elsewhere(folder):
    scene = up.Scene.load(folder / "scene.json")
    above = up.Setup.ortho(left=-1, right=1, bottom=-1, top=1, near=1, far=9, eye=(0, 0, 5), center=(0, 0, 0), size=(200, 200))
    hits = scene.pick(100.5, 100.5, setup=above)
    assert np.allclose(hits["world"][:2], [0.005, -0.005]) and hits["distance"] > 4 - 0.3


def test_a_scene_of_arrays_keeps_its_camera_at_another_size():
    view = {"near": 1, "far": 9, "eye": (0, 3, 5), "center": (0, 0, 0)}
    made = up.Scene.from_arrays(up.Setup.perspective(fovy=30, size=(80, 60), **view), *terrain())
    assert made.setup_at(80, 60) == made.setup
    assert made.setup_at(200, 100) == up.Setup.perspective(fovy=30, size=(200, 100), **view)
    squeezed = up.Setup.perspective(fovy=30, aspect=2, size=(80, 60), **view)
    assert np.array_equal(up.Scene.from_arrays(squeezed, *terrain()).setup_at(200, 200).projection, squeezed.projection)
    matrices = up.Setup.from_matrices(squeezed.projection, squeezed.view, size=(80, 60))
    # The window finds the camera in the matrix, to its last digits.
    assert np.allclose(up.Scene.from_arrays(matrices, *terrain()).setup_at(200, 200).view, squeezed.view, atol=1e-13)


@pytest.mark.parametrize("snap", ["surface", "vertex", "edge", "face"])
def test_a_scene_without_objects_is_never_hit(snap):
    empty = up.Scene.parse(
        '{"unprojector": 1, "window": {"width": 80, "height": 60}, "projection": {"type": "perspective", "fovy": 45, "near": 1, "far": 90},'
        ' "view": {"eye": [0, 0, 15], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": []}'
    )
    hits = empty.pick([40, -3, np.nan], 30, snap=snap)
    assert hits["outside"].tolist() == [False, True, True] and not hits["hit"].any()
    assert (hits["object"] == -1).all() and np.isnan(hits["world"]).all()
    assert repr(empty).startswith("<Scene: no objects, perspective")


def test_objects_and_texts(folder):
    scene = up.Scene.load(folder / "scene.json")
    ground, veil = scene.objects
    assert (ground.name, ground.triangles, ground.vertices, ground.hidden, veil.hidden) == ("ground", 800, 441, False, True)
    assert ground.file.name == "terrain ä 地形.obj"
    assert np.allclose(ground.bounds, [[-0.9, -1, -0.2], [1.1, 1, 0.2]], atol=0.01)
    assert np.allclose(ground.matrix, [[1, 0, 0, 0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])
    assert repr(scene).startswith("<Scene: ground (800 triangles), veil (1 triangles, hidden), perspective fovy 45")
    assert repr(ground) == "<SceneObject: ground, 441 vertices, 800 triangles, 0 points>"
    assert scene.setup.size == SIZE and scene.setup_at(80, 60).size == (80, 60)


def test_a_saved_scene_is_the_same(folder):
    scene = up.Scene.load(folder / "scene.json")
    (folder / "sub").mkdir()
    scene.save(folder / "sub" / "again.json")
    again = up.Scene.load(folder / "sub" / "again.json")
    assert again.setup == scene.setup
    assert json.loads((folder / "sub" / "again.json").read_text())["author"] == "somebody"
    assert again.pick(*pixels()).tobytes() == scene.pick(*pixels()).tobytes()
    model = up.Scene.load(folder / "triangle.obj")
    model.save(folder / "model.json")
    assert up.Scene.load(folder / "model.json").pick(400.5, 300.5).tobytes() == model.pick(400.5, 300.5).tobytes()
    made = up.Scene.from_arrays(scene.setup, *terrain())
    with pytest.raises(ValueError, match="mesh: the mesh comes from arrays"):
        made.save(folder / "made.json")


def test_bundled_models_need_no_file():
    scene = up.Scene.parse(
        '{"unprojector": 1, "window": {"width": 80, "height": 60}, "projection": {"type": "perspective", "fovy": 45, "near": 1, "far": 90},'
        ' "view": {"eye": [0, 0, 15], "center": [0, 0, 0], "up": [0, 1, 0]}, "objects": [{"name": "cube", "bundled": "Cube of side 10"}]}'
    )
    assert scene.pick(40, 30)["hit"]


def test_clicks_on_one_scene_are_that_scene(folder, unproject_command):
    scene = json.loads((folder / "scene.json").read_text(encoding="utf-8"))
    click = {"window": [200, 150, 0.9], "scene": scene}
    other = {"window": [200, 150, 0.9], "scene": {**scene, "window": {"width": 80, "height": 60}}}
    (folder / "clicks.json").write_text(json.dumps([click, click]))
    assert up.Scene.load(folder / "clicks.json").setup == up.Scene.load(folder / "scene.json").setup
    for clicks, message in (([], "it has no click"), ([click, other], "its clicks have different scenes")):
        (folder / "clicks.json").write_text(json.dumps(clicks))
        with pytest.raises(ValueError, match=message) as caught:
            up.Scene.load(folder / "clicks.json")
        said = subprocess.run([unproject_command, "pick", str(folder / "clicks.json"), "--at", "1,1"], capture_output=True, text=True)
        assert said.stderr.strip() == str(caught.value)


def test_wrong_files_and_arguments_are_named(folder, unproject_command):
    with pytest.raises(FileNotFoundError, match="none.json"):
        up.Scene.load(folder / "none.json")
    with pytest.raises(FileNotFoundError, match="none.ply"):
        up.Scene.load(folder / "none.ply")
    with pytest.raises(OSError, match="."):
        up.Scene.load(folder)
    (folder / "triangle.obj").unlink()
    with pytest.raises(FileNotFoundError, match="veil.*triangle.obj") as caught:
        up.Scene.load(folder / "scene.json")
    said = subprocess.run([unproject_command, "pick", str(folder / "scene.json"), "--at", "1,1"], capture_output=True, text=True, encoding="utf-8").stderr
    assert str(caught.value) in said
    (folder / "triangle.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 nonsense\nf 1 2 3\n")
    with pytest.raises(ValueError, match="triangle.obj.*3"):
        up.Scene.load(folder / "scene.json")
    (folder / "scene.json").write_text('{"unprojector": 1, "window": 3}')
    with pytest.raises(ValueError, match="scene.json:1:30: window"):
        up.Scene.load(folder / "scene.json")
    setup = up.Setup.perspective(fovy=45, near=1, far=9, eye=(0, 0, 5), center=(0, 0, 0), size=(80, 60))
    good = np.eye(3), [[0, 1, 2]]
    for vertices, triangles, kind, message in [
        (np.eye(3) * np.nan, good[1], ValueError, "vertex 0 has the coordinate nan"),
        (good[0], [[0, 1, 3]], ValueError, "triangle 0 has the vertex 3; there are 3 vertices"),
        (good[0], [[0, 1, -1]], ValueError, "triangle 0 has the vertex -1"),
        (good[0], np.array([[0, 1, 2**64 - 1]], np.uint64), ValueError, "triangle 0 has the vertex 18446744073709551615"),
        (np.eye(4), good[1], ValueError, r"vertices has the shape \(4, 4\); give \(n, 3\)"),
        (good[0], [0, 1, 2], ValueError, r"triangles has the shape \(3,\); give \(n, 3\)"),
        (good[0], np.empty((0, 3), int), ValueError, "no triangle"),
        (good[0], [[0.5, 1, 2]], TypeError, "triangles is no array of whole numbers"),
    ]:
        with pytest.raises(kind, match=message):
            up.Scene.from_arrays(setup, vertices, triangles)
    with pytest.raises(ValueError, match='snap is "corner"'):
        up.Scene.from_arrays(setup, *good).pick(1, 1, snap="corner")
    for threads, kind in [(0, ValueError), ("all", TypeError), (2.5, TypeError)]:
        with pytest.raises(kind, match="threads is"):
            up.Scene.from_arrays(setup, *good).pick(1, 1, threads=threads)
    assert up.Scene.from_arrays(setup, *good).pick(1, 1, threads=2**70).shape == ()
