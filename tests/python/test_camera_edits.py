"""Camera texts in the notations of many languages, edited at random: an edit that keeps the meaning keeps the pixels, one of
a digit gives the pixels of the new numbers, and a damaged text is refused, or a sentence names what is missing."""

import random
import re

import numpy as np
import pytest

import unprojector as up

TO_WORLD = ("T_world_cam", "cam2world", "c2w", "camera_to_world", "world_T_cam", "T_wc")
TO_CAMERA = ("T_cam_world", "world2cam", "w2c", "world_to_camera", "cam_T_world", "T_cw")
LENS = ("K", "camera_matrix", "cam_K", "intrinsic_matrix", "cameraMatrix", "mtx")
HARMLESS = (("serial", "12"), ("gain", "1.5"), ("iso", "200"))
# What a text says of a part that is missing or not read.
TELLS = re.compile("Not used|No pose|There is no|ends before|bracket closes|assumed to be|The first of")


def rotation(rnd):
    q = np.array([rnd.gauss(0, 1) for _ in range(4)])
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Camera:
    """K, a pose and a size, and the text of them."""

    def __init__(self, rnd):
        self.rnd = rnd
        self.lens = np.array([[rnd.uniform(300, 900), 0, rnd.uniform(310, 330)],
                              [0, rnd.uniform(300, 900), rnd.uniform(230, 250)], [0, 0, 1.0]])
        to_world = np.eye(4)
        to_world[:3, :3] = rotation(rnd)
        to_world[:3, 3] = [rnd.uniform(-5, 5) for _ in range(3)]
        self.is_to_world = rnd.random() < 0.5
        self.pose = to_world if self.is_to_world else np.linalg.inv(to_world)
        self.pose[3] = 0, 0, 0, 1
        self.points = [to_world[:3, :3] @ [rnd.uniform(-0.4, 0.4), rnd.uniform(-0.3, 0.3), rnd.uniform(1, 5)] + to_world[:3, 3]
                       for _ in range(3)]
        self.language = rnd.choice(("json", "yaml", "python", "matlab", "c++", "r", "text"))
        self.names = rnd.choice(LENS), rnd.choice(TO_WORLD if self.is_to_world else TO_CAMERA)
        self.digits = rnd.choice(("%r", "%.17g", "%.16e"))

    def pixels(self):
        world_to_camera = np.linalg.inv(self.pose) if self.is_to_world else self.pose
        eye = np.array(self.points) @ world_to_camera[:3, :3].T + world_to_camera[:3, 3]
        image = eye @ self.lens.T
        return image[:, :2] / image[:, 2:] + 0.5

    def matrix(self, m):
        rows = [[self.digits % float(v) for v in row] for row in m]
        flat = ", ".join(", ".join(row) for row in rows)
        nested = "[" + ", ".join("[" + ", ".join(row) + "]" for row in rows) + "]"
        return {"json": nested, "yaml": "[" + flat + "]", "python": "np.array(" + nested + ")",
                "matlab": "[" + "; ".join(" ".join(row) for row in rows) + "]", "c++": "{" + flat + "}",
                "r": f"matrix(c({flat}), nrow = {len(rows)}, byrow = TRUE)",
                "text": "\n" + "\n".join("  ".join(row) for row in rows)}[self.language]

    def items(self):
        lens, pose = self.names
        items = [(lens, self.matrix(self.lens)), (pose, self.matrix(self.pose)), ("width", "640"), ("height", "480")]
        self.rnd.shuffle(items)
        return items

    def joined(self, items):
        if self.language == "json":
            return "{\n" + ",\n".join(f'  "{name}": {value}' for name, value in items) + "\n}\n"
        form = {"yaml": "{}: {}\n", "python": "{} = {}\n", "matlab": "{} = {};\n", "r": "{} <- {}\n", "text": "{}: {}\n",
                "c++": "double {}[] = {};\n"}[self.language]
        one = "int {} = {};\n" if self.language == "c++" else form
        return "".join((form if "," in value else one).format(name, value) for name, value in items)

    def text(self):
        return self.joined(self.items())


def answer(text, points):
    """The pixels and what was said; None and the reason for a text that is refused."""
    try:
        setup = up.Setup.from_camera(text=text, near=0.1, far=100)
    except ValueError as error:
        return None, [str(error)]
    return np.array([setup.project(p, stages=True).pixel[:2] for p in points]), setup.findings


def is_same(pixels, wanted):
    return pixels is not None and np.allclose(pixels, wanted, rtol=1e-6, atol=1e-6)


COMMENTS = {"yaml": "# a line 1 2 3\n", "python": "# a line 1 2 3\n", "matlab": "% a line 1 2 3\n", "c++": "// a line 1 2 3\n",
            "r": "# a line 1 2 3\n", "text": "", "json": ""}
KEEP = {
    "nothing": lambda camera, text: text,
    "line ends": lambda camera, text: text.replace("\n", "\r\n"),
    "a byte order mark": lambda camera, text: "\ufeff" + text,
    "blank lines": lambda camera, text: "\n\n" + text + "\n\n",
    "blanks": lambda camera, text: text if camera.language == "yaml" else re.sub(r"(?<=[\d,]) ", "  \t", text),
    "a comment": lambda camera, text: COMMENTS[camera.language] + text,
    "a harmless number": lambda camera, text: camera.joined([*camera.items(), camera.rnd.choice(HARMLESS)]),
}


@pytest.mark.parametrize("edit", KEEP)
@pytest.mark.parametrize("seed", range(40))
def test_edits_that_keep_the_meaning_keep_the_pixels(edit, seed):
    camera = Camera(random.Random(f"{edit} {seed}"))
    text = KEEP[edit](camera, camera.text())
    pixels, said = answer(text, camera.points)
    assert is_same(pixels, camera.pixels()), (said, text)


@pytest.mark.parametrize("seed", range(60))
def test_another_digit_gives_the_pixels_of_its_number(seed):
    camera = Camera(random.Random(seed))
    if seed % 2:
        camera.lens[0, 0] += 10
    else:
        camera.pose[seed % 3, 3] += 0.25
    pixels, said = answer(camera.text(), camera.points)
    assert is_same(pixels, camera.pixels()), (said, camera.text())


def numbers(text):
    return list(re.finditer(r"-?\d+\.\d+(?:e[+-]?\d+)?", text))


def without(text, match):
    return text[:match.start()] + text[match.end():]


def bracket(camera, text):
    at = camera.rnd.choice([i for i, c in enumerate(text) if c in "[](){}"] or [0])
    return text[:at] + text[at + 1:]


def cut(camera, text):
    return text[:camera.rnd.randrange(len(text) // 4, len(text))]


def instead(form):
    def edit(camera, text):
        match = camera.rnd.choice(numbers(text))
        return text[:match.start()] + form(match.group()) + text[match.end():]
    return edit


DAMAGE = {
    "a number dropped": lambda camera, text: without(text, camera.rnd.choice(numbers(text))),
    "a number twice": instead(lambda number: number + ", " + number),
    "a letter in a number": instead(lambda number: number[:-2] + "q" + number[-2:]),
    "a second point": instead(lambda number: number.replace(".", ".1.")),
    "two signs": instead(lambda number: "--" + number.lstrip("-")),
    "a word for a number": instead(lambda number: "null"),
    "another name": lambda camera, text: text.replace(camera.names[camera.rnd.randrange(2)], "blob_q"),
    "a bracket dropped": bracket,
    "cut off": cut,
}


@pytest.mark.parametrize("damage", DAMAGE)
@pytest.mark.parametrize("seed", range(60))
def test_damaged_texts_are_refused_or_named(damage, seed):
    camera = Camera(random.Random(f"{damage} {seed}"))
    whole = camera.text()
    text = DAMAGE[damage](camera, whole)
    pixels, said = answer(text, camera.points)
    assert pixels is None or is_same(pixels, camera.pixels()) or any(TELLS.search(one) for one in said), (said, text)
