#!/usr/bin/env python3
"""The Python module beside NumPy, OpenCV, the C++ library and the command, in one run.

    PYTHONPATH=build/bench/core/python python3 tests/benchmarks/bench_python.py \
        --library build/bench/tests/benchmarks/bench_library --command build/bench/core/cli/unproject

Each row has the median of some runs; runs of compared functions alternate.
"""

import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
import unprojector as up

RUNS = 7
COUNT = 10_000_000


class Times(dict):
    """The median time of each function in ms; `best` has the shortest ones."""

    def __init__(self, functions):
        times = {name: [] for name in functions}
        for _ in range(RUNS):
            for name, function in functions.items():
                begin = time.perf_counter()
                function()
                times[name].append(1000 * (time.perf_counter() - begin))
        super().__init__({name: float(np.median(of)) for name, of in times.items()})
        self.best = {name: min(of) for name, of in times.items()}


def unproject_rows(library):
    """unproject of ten million points: NumPy's idiom with its error, and the C++ batch."""
    setup = up.Setup.perspective(fovy=45, near=0.1, far=10000, eye=(3, 2, 5), center=(0, 0, 0), size=(800, 600))
    random = np.random.default_rng(1)
    px, py, depth = random.uniform(0, 800, COUNT), random.uniform(0, 600, COUNT), random.uniform(0, 1, COUNT)
    out = np.empty((COUNT, 3))
    product = setup.projection @ setup.view

    def idiom(x=px, y=py, d=depth):
        ndc = np.stack([2 * x / 800 - 1, 1 - 2 * y / 600, 2 * d - 1, np.ones_like(d)], axis=-1)
        world = ndc @ np.linalg.inv(product).T
        return world[..., :3] / world[..., 3:]

    numpy = Times({"NumPy's idiom": idiom, "exact": lambda: setup.unproject(px, py, depth),
                   "exact=False": lambda: setup.unproject(px, py, depth, exact=False)})
    # NumPy's large intermediate arrays would disturb these.
    times = Times(
        {
            "exact, out=": lambda: setup.unproject(px, py, depth, out=out),
            "exact=False, out=": lambda: setup.unproject(px, py, depth, exact=False, out=out),
            "exact, out=, one thread": lambda: setup.unproject(px, py, depth, out=out, threads=1),
            "exact=False, out=, one thread": lambda: setup.unproject(px, py, depth, exact=False, out=out, threads=1),
        }
    )
    few = slice(0, 200_000)
    far = 1 - 10 ** random.uniform(-7, 0, 200_000)  # as many points at each scale of distance
    true = setup.unproject(px[few], py[few], far)
    ulp = np.spacing(np.abs(true).max(axis=-1))
    errors = {
        "NumPy's idiom": idiom(px[few], py[few], far),
        "exact=False": setup.unproject(px[few], py[few], far, exact=False),
    }
    idiom_time, idiom_best = numpy["NumPy's idiom"], numpy.best["NumPy's idiom"]
    for of in (numpy, times):
        for name, ms in of.items():
            kind = name.split(",")[0]
            error = "0.5 ulp at most" if kind == "exact" else "{:.3g} ulp, 99.9 %".format(
                np.quantile(np.abs(errors[kind] - true).max(axis=-1) / ulp, 0.999)
            )
            ratios = f"{idiom_time / ms:.1f} times as fast as NumPy, best runs {idiom_best / of.best[name]:.1f}"
            yield f"unproject, {name}", ms, f"{ratios}; error {error}"
    if library:
        printed = subprocess.run(
            [library, "--benchmark_format=json", f"--benchmark_repetitions={RUNS}", "--benchmark_report_aggregates_only=true"],
            capture_output=True, check=True, text=True,
        ).stdout
        of = {row["name"]: row["real_time"] for row in json.loads(printed)["benchmarks"] if row["aggregate_name"] == "median"}
        for digits, name in (("exact", "exact"), ("double", "exact=False")):
            for threads, suffix in ((1, ", one thread"), (0, "")):
                cpp = of[f"unprojectBatch/{digits}/{threads}/real_time_median"]
                python = times[f"{name}, out={suffix}"]
                yield f"C++ batch, {digits}, {threads or 'all'} threads", cpp, f"Python takes {python / cpp:.3f} of it"


def cloud_rows():
    """A depth image of 3840x2160 beside OpenCV."""
    try:
        import cv2

        cv2.rgbd.depthTo3d
    except (ImportError, AttributeError):
        yield "cloud", float("nan"), "OpenCV with rgbd is not installed"
        return
    width, height = 3840, 2160
    K = np.array([[3000.0, 0, width / 2 - 0.5], [0, 3000, height / 2 - 0.5], [0, 0, 1]])
    R, t = cv2.Rodrigues(np.array([0.1, 0.2, 0.3]))[0], np.array([0.1, 0.2, 0.3])
    setup = up.Setup.from_opencv(K, R, t, size=(width, height), near=0.1, far=100)
    z = np.random.default_rng(1).uniform(1, 50, (height, width)).astype(np.float32)
    millimetres = (1000 * z).astype(np.uint16)
    out, camera, world = (np.empty((height, width, 3), np.float32) for _ in range(3))
    K32, pose = K.astype(np.float32), np.hstack([R.T, (-R.T @ t)[:, None]]).astype(np.float32)

    def opencv():
        cv2.rgbd.depthTo3d(z, K32, camera)
        cv2.transform(camera, pose, world)

    opencv()
    setup.cloud(z, depth_is="z", out=out)
    assert np.abs(out - world).max() < 1e-4
    depths = setup.project(out)[..., 2].astype(np.float32)
    times = Times(
        {
            "OpenCV's depthTo3d and transform": opencv,
            "z, float32": lambda: setup.cloud(z, depth_is="z", out=out),
            "z, float32, one thread": lambda: setup.cloud(z, depth_is="z", out=out, threads=1),
            "z, uint16": lambda: setup.cloud(millimetres, depth_is="z", scale=1000, out=out),
            "window depths, float32": lambda: setup.cloud(depths, depth_is="buffer", out=out),
        }
    )
    opencv_time = times["OpenCV's depthTo3d and transform"]
    for name, ms in times.items():
        yield f"cloud, {name}", ms, f"{ms / opencv_time:.3f} of OpenCV"


def pick_rows(command):
    """A million rays on a million triangles beside the command."""
    n = 708
    x, y = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1))
    vertices = np.stack([x, y, 0.1 * np.sin(9 * x) * np.cos(7 * y)], axis=-1).reshape(-1, 3)
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    triangles = np.concatenate(
        [np.stack([corner, corner + 1, corner + n + 2], -1), np.stack([corner, corner + n + 2, corner + n + 1], -1)]
    )
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        header = f"ply\nformat binary_little_endian 1.0\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\nproperty float z\nelement face {len(triangles)}\nproperty list uchar int vertex_indices\nend_header\n"
        faces = np.empty(len(triangles), [("n", "u1"), ("v", "<i4", 3)])
        faces["n"], faces["v"] = 3, triangles
        (folder / "mesh.ply").write_bytes(header.encode() + vertices.astype("<f4").tobytes() + faces.tobytes())
        px, py = np.random.default_rng(2).uniform((0, 0), (800, 600), (1_000_000, 2)).T
        scene = up.Scene.load(folder / "mesh.ply")
        begin = time.perf_counter()
        scene.pick(400, 300)
        yield "pick, building the search tree", 1000 * (time.perf_counter() - begin), f"{len(triangles)} triangles"
        functions = {"a million rays": lambda: scene.pick(px, py)}
        if command:
            np.savetxt(folder / "rays.csv", np.stack([px, py], -1), "%.17g", ",", header="px,py", comments="")
            (folder / "none.csv").write_text("px,py\n")

            def run(rows):
                subprocess.run([command, "pick", str(folder / "mesh.ply"), str(folder / rows)], check=True, stdout=subprocess.DEVNULL)

            functions["the command"] = lambda: run("rays.csv")
            functions["the command without rays"] = lambda: run("none.csv")
        times = Times(functions)
        yield "pick, a million rays", times["a million rays"], ""
        if command:
            rays = times["the command"] - times["the command without rays"]
            yield "pick, the command, less opening the model", rays, f"Python takes {times['a million rays'] / rays:.3f} of it"


def import_rows():
    def run(code):
        return float(subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True).stdout)

    alone = "import time; t = time.perf_counter(); import unprojector; print(1000 * (time.perf_counter() - t))"
    after = "import time, numpy; t = time.perf_counter(); import unprojector; print(1000 * (time.perf_counter() - t))"
    yield "import", float(np.median([run(alone) for _ in range(RUNS)])), ""
    yield "import, NumPy imported before", float(np.median([run(after) for _ in range(RUNS)])), ""


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--library", help="the benchmark of the C++ library")
    parser.add_argument("--command", help="the command unproject")
    arguments = parser.parse_args()
    print(f"{os.cpu_count()} cores; medians of {RUNS} runs")
    for rows in (import_rows(), unproject_rows(arguments.library), cloud_rows(), pick_rows(arguments.command)):
        for name, ms, remark in rows:
            print(f"{name:48} {ms:10.2f} ms  {remark}", flush=True)


if __name__ == "__main__":
    main()
