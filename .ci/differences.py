#!/usr/bin/env python3
"""differences.py OLD NEW: compares two folders of outputs, numbers and words apart.

Prints two lists with a line a file that differs: how many of its numbers differ, and by how much of
the larger one at most; the first line whose words differ, with its numbers blanked. A file that is no
text either differs or does not. Crashes of the new outputs' programs are named too. Returns 1 if any
file differs."""
import pathlib
import re
import sys

NUMBER = re.compile(r"[-+−]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")
CRASH = re.compile(rb"^exit code (?!0$|1$|2$).*", re.MULTILINE)


def compared(old: bytes, new: bytes) -> tuple[str, str]:
    """What differs between the numbers and between the words of two files; empty: nothing."""
    try:
        texts = old.decode(), new.decode()
    except UnicodeDecodeError:
        return ("other bytes" if old != new else ""), ""
    numbers = [[float(number.replace("−", "-")) for number in NUMBER.findall(text)] for text in texts]
    words = [NUMBER.sub("#", text).splitlines() for text in texts]
    inNumbers = inWords = ""
    if len(numbers[0]) != len(numbers[1]):
        inNumbers = f"{len(numbers[0])} numbers, now {len(numbers[1])}"
    elif off := [abs(a - b) / max(abs(a), abs(b)) for a, b in zip(*numbers) if a != b]:
        inNumbers = f"{len(off)} of {len(numbers[0])} numbers, by {max(off):.1e}"
    if words[0] != words[1]:
        lines = next(((a, b) for a, b in zip(*words) if a != b), None)
        inWords = f"{lines[0].strip()!r}, now {lines[1].strip()!r}" if lines else "another number of lines"
    elif old != new and not inNumbers:
        inWords = "other blanks or other digits of the same numbers"
    return inNumbers, inWords


def main(old: pathlib.Path, new: pathlib.Path) -> int:
    names = sorted({path.relative_to(folder) for folder in (old, new) for path in folder.rglob("*") if path.is_file()})
    if not names:
        sys.exit(f"There are no files in {old} and {new}")
    found: dict[str, list[str]] = {"numbers": [], "words": [], "files": []}
    for name in names:
        if not (old / name).exists() or not (new / name).exists():
            found["files"].append(f"{name}: only in {(old if (old / name).exists() else new).name}")
            continue
        contents = (old / name).read_bytes(), (new / name).read_bytes()
        for what, text in zip(("numbers", "words"), compared(*contents)):
            if text:
                found[what].append(f"{name}: {text}")
        found["files"] += [f"{name}: {crash.decode()}" for crash in CRASH.findall(contents[1])]
    for what, lines in found.items():
        if lines:
            print(f"== {what}: {len(lines)} of {len(names)} files", *lines, sep="\n")
    return int(any(found.values()))


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
