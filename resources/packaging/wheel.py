"""Packs the built Python module as a wheel for the Python that runs this file.

    python3 wheel.py --metadata METADATA [--licence FILE]... [--strip PROGRAM] --out FOLDER FILE...

FILE: the files of the package. The wheel has the same bytes for the same files.
"""

import argparse
import base64
import email
import hashlib
import pathlib
import subprocess
import sys
import sysconfig
import tempfile
import zipfile


def contents(file: pathlib.Path, strip: str) -> bytes:
    """The bytes of a file; those of a library without its symbols for debuggers."""
    if file.suffix != ".so" or not strip:
        return file.read_bytes()
    with tempfile.TemporaryDirectory() as folder:
        stripped = pathlib.Path(folder, file.name)
        subprocess.run([strip, "--strip-unneeded", "-o", stripped, file], check=True)
        return stripped.read_bytes()


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--metadata", type=pathlib.Path, required=True)
    parser.add_argument("--licence", type=pathlib.Path, action="append", default=[])
    parser.add_argument("--strip", default="")
    parser.add_argument("--out", type=pathlib.Path, required=True)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    arguments = parser.parse_args()

    metadata = arguments.metadata.read_text(encoding="utf-8")
    fields = email.message_from_string(metadata)
    name = f"{fields['Name']}-{fields['Version']}"
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    tag = f"{python}-{python}-{platform}"
    info = f"{name}.dist-info"
    wheel = f"Wheel-Version: 1.0\nGenerator: unprojector\nRoot-Is-Purelib: false\nTag: {tag}\n"

    entries = {f"{fields['Name']}/{file.name}": contents(file, arguments.strip) for file in arguments.files}
    entries[f"{info}/METADATA"] = metadata.encode()
    entries[f"{info}/WHEEL"] = wheel.encode()
    for file in arguments.licence:
        entries[f"{info}/{file.name}"] = file.read_bytes()
    record = ""
    for path, data in entries.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{path},sha256={digest},{len(data)}\n"
    entries[f"{info}/RECORD"] = f"{record}{info}/RECORD,,\n".encode()

    out = arguments.out / f"{name}-{tag}.whl"
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in entries.items():
            entry = zipfile.ZipInfo(path)  # with the date 1980-01-01
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o100644 << 16
            archive.writestr(entry, data)
    print(out)


if __name__ == "__main__":
    main()
