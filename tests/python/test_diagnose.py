import html
import json
import subprocess

import numpy as np
import pytest
import unprojector as up

SIZE = (800, 600)
PIXELS = np.array([[568.5, 274.5], [200.5, 400.5], [401.5, 77.5]])
DEPTHS = np.array([0.8383, 0.61, 0.9125])


@pytest.fixture
def setup():
    return up.Setup.perspective(fovy=45, near=1, far=20, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)


def program(setup, px, py, depth, *, flips=True, transposed=False, depth_to_ndc=True, divides=True):
    """The usual code, with one mistake on request."""
    x = 2 * px / SIZE[0] - 1
    y = 1 - 2 * py / SIZE[1] if flips else 2 * py / SIZE[1] - 1
    z = 2 * depth - 1 if depth_to_ndc else depth
    inverse = np.linalg.inv(setup.projection @ setup.view)
    inverse = inverse.T if transposed else inverse
    p = inverse @ [x, y, z, 1]
    return p[:3] / p[3] if divides else p[:3]


MISTAKES = {
    "y-not-flipped": {"flips": False},
    "product-transposed": {"transposed": True},
    "no-w-divide": {"divides": False},
    "depth-not-remapped": {"depth_to_ndc": False},
}


@pytest.mark.parametrize("name, mistake", MISTAKES.items(), ids=MISTAKES)
def test_a_mistake_of_a_numpy_program_is_found(setup, name, mistake, tmp_path, unproject_command):
    got = np.array([program(setup, *pixel, depth, **mistake) for pixel, depth in zip(PIXELS, DEPTHS)])
    diagnosis = up.diagnose(setup, PIXELS, DEPTHS, got)
    assert diagnosis.verdict == name, str(diagnosis)
    # The command says the same of the same numbers.
    (tmp_path / "scene.json").write_text(setup.to_scene())
    rows = "px,py,depth,x,y,z\n" + "".join(
        ",".join(map(repr, [*p.tolist(), float(d), *g.tolist()])) + "\n" for p, d, g in zip(PIXELS, DEPTHS, got)
    )
    (tmp_path / "points.csv").write_text(rows)
    command = [unproject_command, "doctor", str(tmp_path / "scene.json"), "--points", str(tmp_path / "points.csv")]
    said = subprocess.run(command, capture_output=True, check=True, text=True, encoding="utf-8").stdout
    assert said.rstrip("\n") == str(diagnosis)
    page = diagnosis._repr_html_()
    assert f"<h3>{name}" in page and f"<p>{diagnosis.sentence}" in html.unescape(page)
    written = json.loads(subprocess.run([*command, "--json"], capture_output=True, check=True, text=True).stdout)
    assert [c["id"] for c in written["candidates"]] == [c.id for c in diagnosis.candidates]
    assert np.array_equal([c["point"] for c in written["candidates"]], [c.point for c in diagnosis.candidates])
    assert [c["library"] for c in written["code"]] == [c.library for c in diagnosis.changes]
    assert written["sentence"] == diagnosis.sentence and written["verdict"] == diagnosis.verdict
    assert np.allclose(diagnosis.right, setup.unproject(*PIXELS[0], DEPTHS[0]), rtol=1e-15, atol=0)


def test_the_corrected_code_gives_the_right_point(setup):
    px, py, depth = 568.5, 274.5, 0.8383
    got = program(setup, px, py, depth, flips=False)
    diagnosis = up.diagnose(setup, (px, py), depth, got)
    assert diagnosis.verdict == "y-not-flipped"
    wrong, right = diagnosis.code["numpy"].splitlines()
    names = {"np": np, "x": px, "y": py, "W": SIZE[0], "H": SIZE[1], "vx": 0, "vy": 0, "w": SIZE[0], "h": SIZE[1]}
    expected = program(setup, px, py, depth)
    for line, is_right in ((wrong, False), (right, True)):
        given = dict(names)
        exec(line[2:], given)
        p = np.linalg.inv(setup.projection @ setup.view) @ [2 * px / SIZE[0] - 1, given["y_n"], 2 * depth - 1, 1]
        assert np.allclose(p[:3] / p[3], expected) == is_right, line


def test_right_points_and_unknown_points(setup):
    right = setup.unproject(*PIXELS.T, DEPTHS)
    assert up.diagnose(setup, PIXELS, DEPTHS, right).verdict == "right"
    assert up.diagnose(setup, PIXELS, None, right).verdict == "right"
    diagnosis = up.diagnose(setup, PIXELS, DEPTHS, [[0.31, 5.77, -2.92], [11.3, 0.04, 4.4], [-3.3, 0.62, 1.234]])
    assert diagnosis.verdict == "unknown" and diagnosis.code == {} and diagnosis.sentence
    assert up.diagnose(setup, PIXELS[0], DEPTHS[0], setup.unproject(*PIXELS[0], DEPTHS[0], space="eye"), space="eye").verdict == "right"


def test_written_digits_count(setup):
    got = program(setup, *PIXELS[0], DEPTHS[0], flips=False)
    texts = [f"{c:.4f}" for c in got]
    for given in (" ".join(texts), f"vec3({', '.join(texts)})", texts, tuple(float(t) for t in texts)):
        assert up.diagnose(setup, PIXELS[0], 0.8383, given).verdict == "y-not-flipped"
    single = got.astype(np.float32)
    assert up.diagnose(setup, PIXELS[0], 0.8383, single).verdict == "y-not-flipped"


def test_a_scene_knows_its_depths():
    triangle = np.array([[-9.0, -9, 0], [9, -9, 0], [0, 9, 0]])
    setup = up.Setup.perspective(fovy=45, near=1, far=20, eye=(3, 2, 5), center=(0, 0, 0), size=SIZE)
    scene = up.Scene.from_arrays(setup, triangle, [[0, 1, 2]])
    hits = scene.pick(*PIXELS.T)
    depths = setup.project(hits["world"])[:, 2]
    got = np.array([program(setup, *p, d, flips=False) for p, d in zip(PIXELS, depths)])
    assert up.diagnose(scene, PIXELS, None, got).verdict == "y-not-flipped"


def test_texts(setup):
    diagnosis = up.diagnose(setup, PIXELS[0], DEPTHS[0], program(setup, *PIXELS[0], DEPTHS[0], flips=False))
    assert repr(diagnosis).startswith("<Diagnosis: y-not-flipped: ")
    assert repr(diagnosis.candidates[0]) == "<Candidate: y-not-flipped, explains all digits>"
    assert set(diagnosis.code) >= {"numpy", "glm"}
    assert diagnosis.changes[0].mistake == "y-not-flipped"


@pytest.mark.parametrize(
    "arguments, message",
    [
        (((900, 1), 0.5, (1, 2, 3)), "pixel: 900,1 lies outside the view of 800x600"),
        (((1, 1), 2, (1, 2, 3)), "depth: 2 lies outside|depth: .*2"),
        (((1, 1), 0.5, (1, 2)), "got has 2 numbers; give 3"),
        (((1, 1), 0.5, "1 2 x"), "got 1 2 x"),
        (((1, 1), 0.5, (1, 2, float("nan"))), "got 1,2,nan"),
        (([(1, 1), (2, 2)], 0.5, (1, 2, 3)), "2 pixels, 1 depths and 1 coordinates"),
        (([(1, 1), (2, 2)], [0.5, 0.5], [(1, 2, 3), "1 2 x"]), "point 1: got 1 2 x"),
        (([(1, 1)] * 101, [0.5] * 101, [(1, 2, 3)] * 101), "there are 101 points; give at most 100"),
    ],
)
def test_wrong_arguments_are_named(setup, arguments, message):
    with pytest.raises(ValueError, match=message):
        up.diagnose(setup, *arguments)
