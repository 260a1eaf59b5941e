#!/usr/bin/env python3
"""speed.py OLD NEW: the speed of two builds of the preset "bench", in the same run.

Runs loading, rays, turning and panels three times in each build, in turns, on models that it makes (a
million triangles), and takes the least of each number. Prints a line for each line of a benchmark's
output that has other numbers: NEW's number, and its ratio to OLD's. Returns 1 if a time of NEW is more
than a quarter above OLD's."""
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
NUMBER = re.compile(r"(?<![\w.])\d+\.\d+|(?<![\w.])\d+(?= *(?:ns|us|ms|s)\b)")
BENCHMARKS = {"bench_loading": True, "bench_ray": False, "bench_orbit": True, "bench_panels": False}


def numbers(build: pathlib.Path, name: str, models: list[str]) -> dict[str, list[float]]:
    """The numbers of each line of the output, by the line's words."""
    done = subprocess.run(["sh", ROOT / "tests/launch.sh", "--display", "--", build / "tests/benchmarks" / name, *models],
                          capture_output=True, text=True, check=True)
    return {" ".join(NUMBER.sub("", line).split()[:3]): [float(number) for number in NUMBER.findall(line)]
            for line in done.stdout.splitlines() if NUMBER.search(line)}


def least(runs: list[dict[str, list[float]]]) -> dict[str, list[float]]:
    return {line: [min(column) for column in zip(*(run[line] for run in runs))] for line in runs[0] if all(line in run for run in runs)}


def main(old: pathlib.Path, new: pathlib.Path) -> int:
    slower = 0
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([new / "tests/benchmarks/make_models", folder, "288"], check=True)
        models = sorted(map(str, pathlib.Path(folder).iterdir()))
        for name, opens in BENCHMARKS.items():
            runs = [[numbers(build, name, models if opens else []) for build in (old, new)] for _ in range(3)]
            before, after = (least([pair[which] for pair in runs]) for which in (0, 1))
            for line in after:
                pairs = list(zip(after[line], before.get(line, [])))
                print(f"{name}: {line}:", *(f"{now:g} ({now / was:.2f})" for now, was in pairs if was))
                slower += sum(now > 1.25 * was for now, was in pairs[:1])
    print(f"{slower} times are more than a quarter above the old build's" if slower else "Not slower than the old build")
    return int(slower > 0)


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(build).resolve() for build in sys.argv[1:3])))
