#!/usr/bin/env python3
"""compare.py OLD NEW: checks that two builds give the same digits, words and pixels.

OLD and NEW are build folders; NEW's tests are built. Both commands read the same scenes, camera
files, printed matrices, models, landmarks and images (scenes below, and tests/data and the fuzzers'
kept inputs), and both windows take pictures of their views and write what their panels show. Prints the
differences, those in numbers and those in words apart (differences.py); returns 1 if there are any.

A change of the structure must have none. A change that is meant to alter digits shows them.
The build of an earlier commit: git worktree add FOLDER COMMIT && cmake --preset dev -S FOLDER &&
cmake --build FOLDER/build/dev --target unproject unprojector."""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tarfile
import tempfile

import differences

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLICKS = ["--click", "320,240", "--click", "200,260"]
PERSPECTIVE = {"type": "perspective", "fovy": 45, "near": 0.5, "far": 50}
MATRIX = [1.5, 0, 0, 0, 0, 2, 0, 0, 0.1, 0.05, -1.01, -1, 0, 0, -0.201, 0]
SCENES = {
    "perspective": (PERSPECTIVE, {}),
    "frustum": ({"type": "frustum", "left": -0.3, "right": 0.5, "bottom": -0.2, "top": 0.35, "near": 0.5, "far": 80}, {}),
    "ortho": ({"type": "ortho", "left": -5, "right": 4, "bottom": -3, "top": 3.5, "near": 1, "far": 30}, {}),
    "oblique": ({"type": "oblique", "left": -5, "right": 5, "bottom": -4, "top": 4, "near": 1, "far": 30,
                 "theta": 70, "phi": 80}, {}),
    "reversed": ({"type": "perspective", "fovy": 50, "near": 0.1, "far": 1000}, {"depthRange": [1, 0]}),
    "part": ({"type": "perspective", "fovy": 50, "aspect": 1.5, "near": 0.1, "far": 100},
             {"viewport": {"x": 20, "y": 30, "width": 500, "height": 400}, "depthRange": [0.25, 0.75]}),
    "ratio": (PERSPECTIVE, {"window": {"width": 640, "height": 480, "devicePixelRatio": 1.5}}),
    "planes": (PERSPECTIVE, {"clipPlanes": [[0, 1, 0.5, 0.2]]}),
    "matrix": ({"type": "matrix", "matrix": MATRIX, "ndcDepth": [0, 1]}, {}),
}
LANDMARKS = "name,x,y,z\nnose,1.25,2.5,3.125\nchin,0.1,0.2,0.3\nlost,,,\n"
LANDMARK_FORMATS = ["csv", "pp", "pptpl", "mrk.json", "fcsv", "pts", "tps", "nts", "landmarkAscii", "ljson"]
# Other tests read these: texts that hold many cases, runs of the command with their outputs, images of models.
NOT_RUN = {"texts", "commands", "texture", "scenes", "small.json", "points.csv", "again.csv"}
# The commands know these by their names; corpora have none.
SUFFIXES = {kind: "." + kind for kind in ("obj", "off", "ply", "stl", "gltf", "glb")} | {"scene": ".json", "clicks": ".json"}
ROWS = [(i + 0.5, j + 0.5, (i * 7919 % 997 + 1) / 1000) for j in range(0, 480, 37) for i in range(0, 640, 41)]


def table(header: str, rows) -> str:
    return "\n".join([header, *(",".join(map(str, row)) for row in rows)]) + "\n"


PIXELS, DEPTHS = table("px,py", [row[:2] for row in ROWS]), table("px,py,depth", ROWS)
POINTS = table("x,y,z", ROWS)
FEW = table("px,py", [row[:2] for row in ROWS[::40]])
WRONG = table("px,py,depth,x,y,z", [(310.5, 200.5, "", 0.1234, 0.5678, -0.9012), (100.5, 99.5, "", 1.1, 0.5, -1.25),
                                    (400.5, 300.5, "", 0.7, -0.4, 0.1)])


def write_inputs(folder: pathlib.Path) -> None:
    """The folder that all commands run in: scenes/, and a folder for each kind of kept inputs."""
    (folder / "scenes").mkdir(parents=True)
    for name, (projection, more) in SCENES.items():
        scene = {"unprojector": 1, "window": {"width": 640, "height": 480}, "projection": projection,
                 "view": {"eye": [3.1, 2.3, 7.7], "center": [0.1, 0.2, 0], "up": [0, 1, 0]},
                 "objects": [{"name": "pot", "bundled": "Teapot",
                              "transform": [{"translate": [0.5, 0.25, -1]}, {"rotate": [30, 1, 2, 3]}]},
                             {"name": "ball", "bundled": "Torus", "transform": [{"scale": [1.5, 1, 0.75]}]}]} | more
        (folder / "scenes" / f"{name}.json").write_text(json.dumps(scene))
    scene |= {"window": {"width": 3, "height": 2}, "projection": PERSPECTIVE | {"far": 1e6}} # of the images
    (folder / "small.json").write_text(json.dumps(scene))
    (folder / "points.csv").write_text(LANDMARKS)
    (folder / "again.csv").write_text(LANDMARKS.replace("1.25,2.5", "1.5,2.5"))
    corpora = folder.parent / "corpora"
    with tarfile.open(ROOT / "tests/fuzz/corpora.tar.xz") as archive:
        archive.extractall(corpora)
    for kept in (ROOT / "tests/data", ROOT / "tests/fuzz/findings", corpora):
        for file in kept.rglob("*"):
            to = folder / file.relative_to(kept)
            if file.is_file():
                to.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, to.with_suffix(SUFFIXES.get(file.relative_to(kept).parts[0], file.suffix)))
    shutil.copytree(ROOT / "tests" / "scene_code", folder / "scene", dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.[!j]*"))


def scene_jobs(name: str, file: str, mistakes: list[str]):
    """(name, arguments, standard input) of the command for one of the scenes above; OUT is a file of the job's own."""
    yield "points", ["points", "--method", "all", file, "-"], DEPTHS
    yield "object", ["points", "--space", "object:pot", file, "-"], DEPTHS
    yield "pick", ["pick", file, "-"], PIXELS
    for snap in ("edge", "face", "vertex"):
        yield snap, ["pick", "--snap", snap, file, "-"], PIXELS
    yield "project", ["project", file, "-"], POINTS
    for form in ("text", "json", "numpy", "latex", "c"):
        yield form, ["matrices", "--format", form, file], None
    for conventions in ("direct3d", "metal", "opencascade", "opencv", "threejs", "unity", "vulkan", "webgpu"):
        yield conventions, ["matrices", "--conventions", conventions, file], None
    for form in ("glm", "glu", "qt", "three", "numpy"):
        yield "code." + form, ["code", "--for", form, file], None
    for what in ("formula-matrix", "formula-ray", "uncertainty"):
        yield what, ["map", "--json", "--size", "160x120", "--what", what, "-o", "OUT.pfm", file], None
    for mistake in mistakes:
        yield mistake, ["map", "--json", "--size", "80x60", "--what", "displacement", "--convention", mistake,
                        "-o", "OUT.pfm", file], None
    yield "doctor", ["doctor", "--json", "--pixel", "310.5,200.5", "--got", "0.1234,0.5678,-0.9012", file], None
    yield "doctor.text", ["doctor", "--pixel", "310.5,200.5", "--got", "0.1234,0.5678,-0.9012", file], None
    yield "doctor.three", ["doctor", "--points", "-", file], WRONG
    yield "compare", ["compare", "--json", "--pixels", "4", "--depths", "3", file], None


def file_jobs(kind: str, file: str):
    """The same for a kept input of this kind."""
    if file.endswith("expected.json"):
        expected = json.loads(pathlib.Path(ROOT, "tests/data", file).read_text())
        files = [str(pathlib.Path(file).with_name(name)) for name in expected["files"]]
        size = ["--size", "{}x{}".format(*expected["size"])] if "size" in expected else []
        yield "camera", ["scene", *files, "--near", "0.1", "--far", "100", "--image", expected.get("image", "0"), *size], None
    elif kind in ("cameras", "matrices", "printed"):
        yield "from", ["scene", "--from", file, "--near", "0.1", "--far", "100"], None
        yield "from-matrices", ["scene", "--from-matrices", file], None
    elif kind in ("scene", "clicks"):
        for command in ("info", "matrices", "code"):
            yield command, [command, file, *(["--for", "glm"] if command == "code" else [])], None
        yield "points", ["points", "--method", "all", file, "-"], DEPTHS[:400]
        yield "pick", ["pick", file, "-"], FEW
        yield "project", ["project", file, "-"], POINTS[:400]
    elif kind in ("obj", "off", "ply", "stl", "gltf", "glb"):
        yield "info", ["info", file], None
        yield "pick", ["pick", file, "-"], FEW
    elif kind in LANDMARK_FORMATS:
        for form in ("csv", "mrk.json", "tps"):
            yield "to-" + form, ["landmarks", "--from", kind, "--to", form, file, "-"], None
    elif kind == "depth_image":
        for meaning in ("buffer", "z", "range"):
            yield meaning, ["cloud", "small.json", file, "--size", "3x2", "--depth-is", meaning, "-o", "-"], None
    elif kind == "rows":
        yield "points", ["points", "scenes/frustum.json", file], None
        yield "project", ["project", "scenes/frustum.json", file], None
    elif kind not in NOT_RUN:
        sys.exit(f"{file}: which command reads this kind?")


def jobs(folder: pathlib.Path, mistakes: list[str]):
    """(name of the output, arguments, standard input) of all runs of the command."""
    for name in SCENES:
        for what, arguments, text in scene_jobs(name, f"scenes/{name}.json", mistakes):
            yield f"{name}.{what}", arguments, text
        yield name + ".info", ["info", f"scenes/{name}.json"], None
    for form in ("csv", "pp", "mrk.json", "fcsv", "pts", "tps", "nts"):
        yield "landmarks." + form, ["landmarks", "--to", form, "points.csv", "-"], None
    yield "repeats", ["landmarks", "--repeats", "points.csv", "again.csv", "-o", "-"], None
    for file in sorted(path.relative_to(folder) for path in folder.rglob("*") if path.is_file()):
        for what, arguments, text in file_jobs(file.parts[0], str(file)):
            yield f"{file}.{what}", arguments, text


def run_command(program: pathlib.Path, folder: pathlib.Path, out: pathlib.Path, job) -> None:
    name, arguments, text = job
    file = out / name
    file.parent.mkdir(parents=True, exist_ok=True)
    arguments = [argument.replace("OUT", f"../{out.name}/{name}") for argument in arguments]
    done = subprocess.run([program, *arguments], cwd=folder, input=(text or "").encode(), capture_output=True, check=False)
    file.write_bytes(done.stdout + done.stderr + b"\nexit code %d\n" % done.returncode)


def run_window(build: pathlib.Path, folder: pathlib.Path, out: pathlib.Path, name: str, plugins: pathlib.Path,
               arguments: list[str]) -> None:
    """Takes a picture, and writes the clicks and the texts of the panels."""
    done = subprocess.run(
        ["sh", ROOT / "tests" / "launch.sh", "--display", f"QT_PLUGIN_PATH={plugins}",
         f"QT_QPA_GENERIC_PLUGINS=panel_texts:{out / name}.panels", "--", build / "gui" / "unprojector", "--view-size", "640x480",
         "--no-panels", *arguments, "--screenshot", f"{out / name}.png"], cwd=folder, capture_output=True, check=False)
    (out / (name + ".clicks")).write_bytes(done.stdout + done.stderr + b"\nexit code %d\n" % done.returncode)


def window_jobs():
    scenes = {"bundled": [], "landmarks": ["scenes/perspective.json", "points.csv"]}
    scenes |= {name: [f"scenes/{name}.json"] for name in SCENES}
    for name, files in scenes.items():
        yield "window." + name, files
        yield f"window.{name}-clicked", [*CLICKS, *files]
    for place in ("click", "pipeline", "points", "doctor"):
        yield "window.bundled-" + place, ["--place", place]


def check(out: pathlib.Path) -> None:
    """Ends the program if a run failed that has to succeed: two builds that fail alike would be the same."""
    for name, _ in window_jobs():
        for file in (out / f"{name}.png", out / f"{name}.panels"):
            if not file.exists() or not file.stat().st_size:
                sys.exit(f"The {out.name} build wrote no {file.name}:\n" + (out / f"{name}.clicks").read_text(errors="replace"))
    for file in (file for name in SCENES for file in out.glob(f"{name}.*") if file.suffix != ".pfm"):
        if int((text := file.read_bytes()).rsplit(b" ", 1)[-1]) not in (0, 1): # 1: rows that have no answer, a wrong point
            sys.exit(f"The {out.name} build failed in {file.name}:\n" + text.decode(errors="replace"))


def main(old: pathlib.Path, new: pathlib.Path) -> int:
    plugins = new / "tests" / "panel_texts"
    for needed in (old / "core/cli/unproject", new / "core/cli/unproject", old / "gui/unprojector", new / "gui/unprojector",
                   plugins / "generic"):
        if not needed.exists():
            sys.exit(f"There is no {needed}")
    with tempfile.TemporaryDirectory() as work:
        folder = pathlib.Path(work, "inputs")
        write_inputs(folder)
        said = subprocess.run([old / "core/cli/unproject", "map", "--what", "displacement", "--convention", "?", "-o", "none.pfm",
                               "scenes/ortho.json"], cwd=folder, capture_output=True, text=True, check=False).stderr
        mistakes = said.partition(" is not one of ")[2].replace(",", "").split() or sys.exit("The old build lists no mistakes")
        outputs = []
        for which, build in (("old", old), ("new", new)):
            out = pathlib.Path(work, which)
            out.mkdir()
            outputs.append(out)
            with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
                runs = [pool.submit(run_command, build / "core/cli/unproject", folder, out, job) for job in jobs(folder, mistakes)]
                runs += [pool.submit(run_window, build, folder, out, name, plugins, arguments) for name, arguments in window_jobs()]
            for run in runs:
                run.result()
            check(out)
        files = [path for path in outputs[0].rglob("*") if path.is_file()]
        print(f"{len(files)} outputs of the old build, {sum(path.suffix == '.png' for path in files)} of them pictures")
        return differences.main(*outputs)


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(build).resolve() for build in sys.argv[1:3])))
