#!/usr/bin/env python3
"""differences.py OLD NEW: compares two folders of outputs, numbers and words apart.

Prints a line a file that differs: how many of its numbers differ and by how much of the larger one
at most, and the first line whose words differ, with its numbers blanked. A file that is no text
either differs or does not. Returns 1 if any file differs."""
import pathlib
import re
import sys

NUMBER = re.compile(r"[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


def compared(old: bytes, new: bytes) -> list[str]:
    """What differs between two files."""
    try:
        texts = old.decode(), new.decode()
    except UnicodeDecodeError:
        return ["other bytes"]
    numbers = [[float(number.replace("−", "-")) for number in NUMBER.findall(text)] for text in texts]
    words = [NUMBER.sub("#", text).splitlines() for text in texts]
    found = []
    if len(numbers[0]) != len(numbers[1]):
        found.append(f"{len(numbers[0])} numbers, now {len(numbers[1])}")
    else:
        off = [abs(a - b) / max(abs(a), abs(b)) for a, b in zip(*numbers) if a != b]
        if off:
            found.append(f"{len(off)} of {len(numbers[0])} numbers, by {max(off):.1e}")
    if words[0] != words[1]:
        lines = next(((a, b) for a, b in zip(*words) if a != b), None)
        found.append(f"words: {lines[0].strip()!r}, now {lines[1].strip()!r}" if lines else "another number of lines")
    return found


def main(old: pathlib.Path, new: pathlib.Path) -> int:
    names = sorted({path.relative_to(folder) for folder in (old, new) for path in folder.rglob("*") if path.is_file()})
    differs = False
    for name in names:
        if not (old / name).exists() or not (new / name).exists():
            found = [f"only in {old if (old / name).exists() else new}"]
        else:
            a, b = (old / name).read_bytes(), (new / name).read_bytes()
            found = compared(a, b) or ["other bytes"] if a != b else []
        differs |= bool(found)
        for what in found:
            print(f"{name}: {what}")
    return int(differs)


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
