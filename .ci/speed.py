#!/usr/bin/env python3
"""speed.py OLD NEW: the speed of two builds of the preset "bench", in the same run.

Runs loading, rays, turning and panels three times in each build, in turns, on models that it makes (a
million triangles), and takes the least of each time. Prints a line for each line of a benchmark's
output that has times: NEW's, and their ratios to OLD's. Returns 1 if a time of NEW is more than a
quarter above OLD's, or a line is missing."""
import collections
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
NUMBER = re.compile(r"(?<![\w.])\d+(?:\.\d+)?")
TIME = re.compile(NUMBER.pattern + r"(?= *(?:ns|us|µs|ms|s)\b)")
BENCHMARKS = {"bench_loading": True, "bench_ray": False, "bench_orbit": True, "bench_panels": False}


def times(build: pathlib.Path, name: str, models: list[str]) -> dict[str, list[float]]:
    """The times of each line of the output, by the line's words."""
    done = subprocess.run(["sh", ROOT / "tests/launch.sh", "--display", "--", build / "tests/benchmarks" / name, *models],
                          capture_output=True, text=True, check=True)
    found, seen = {}, collections.Counter()
    for line in filter(TIME.search, done.stdout.splitlines()):
        words = " ".join(NUMBER.sub("#", line).split())
        seen[words] += 1
        found[f"{words} ({seen[words]})"] = [float(time) for time in TIME.findall(line)]
    return found


def least(runs: list[dict[str, list[float]]]) -> dict[str, list[float]]:
    return {line: [min(column) for column in zip(*(run[line] for run in runs))] for line in runs[0] if all(line in run for run in runs)}


def main(old: pathlib.Path, new: pathlib.Path) -> int:
    faults = []
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([new / "tests/benchmarks/make_models", folder, "288"], check=True)
        models = sorted(map(str, pathlib.Path(folder).iterdir()))
        for name, opens in BENCHMARKS.items():
            runs = [[times(build, name, models if opens else []) for build in (old, new)] for _ in range(3)]
            before, after = (least([pair[which] for pair in runs]) for which in (0, 1))
            faults += [f"{name}: {line}: not in both builds" for line in before.keys() ^ after.keys()] or ([] if after else [f"{name}: no times"])
            for line in before.keys() & after.keys():
                pairs = list(zip(after[line], before[line]))
                print(f"{name}: {line}:", *(f"{now:g} ({now / was:.2f})" for now, was in pairs if was))
                faults += [f"{name}: {line}: {now:g}, before {was:g}" for now, was in pairs if now > 1.25 * was]
    print(*faults, "Slower, or not measured" if faults else "Not slower than the old build", sep="\n")
    return int(bool(faults))


if __name__ == "__main__":
    sys.exit(main(*(pathlib.Path(build).resolve() for build in sys.argv[1:3])))
