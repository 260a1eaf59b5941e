"""The code of the manual's pages runs, and prints what the pages show."""

import contextlib
import io
import pathlib
import re

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
MANUAL = ROOT / "resources" / "manual"
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
PAGES = [page for page in sorted(MANUAL.glob("**/*.md")) if "```python" in page.read_text(encoding="utf-8")]


def blocks_of(page):
    """The fenced blocks of a page: language and text."""
    return BLOCK.findall(page.read_text(encoding="utf-8"))


def differences(page):
    """Runs a page's Python blocks in the current folder, in one namespace; returns outputs that differ from the page."""
    found = []
    names = {"__name__": "__main__"}
    blocks = blocks_of(page)
    for number, (language, text) in enumerate(blocks):
        if language != "python":
            continue
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(compile(text, f"{page.name}, block {number}", "exec"), names)
        following = blocks[number + 1] if number + 1 < len(blocks) else ("", "")
        shown = following[1] if following[0] == "text" else ""
        if printed.getvalue().rstrip() != shown.rstrip():
            found.append(f"{page.name}, block {number} prints\n{printed.getvalue()}and the page shows\n{shown}")
    return found


def test_pages_have_code():
    assert len(PAGES) >= 3


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(MANUAL)))
def test_a_page_prints_what_it_shows(page, tmp_path, monkeypatch):
    if "matplotlib" in page.read_text(encoding="utf-8"):
        pytest.importorskip("matplotlib").use("Agg")
    monkeypatch.chdir(tmp_path)
    assert not differences(page)
    for picture in tmp_path.glob("*.png"):
        shown = pytest.importorskip("matplotlib.image").imread(ROOT / "resources" / "images" / picture.name)
        written = pytest.importorskip("matplotlib.image").imread(picture)
        assert shown.shape == written.shape
        assert np.abs(shown - written).mean() < 0.02, f"{picture.name} differs from the page's"


def test_a_wrong_output_is_found(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page = tmp_path / "page.md"
    page.write_text("```python\nprint(1 + 1)\n```\n\n```text\n3\n```\n", encoding="utf-8")
    assert len(differences(page)) == 1
    page.write_text("```python\nprint(1 + 1)\n```\n\n```text\n2\n```\n", encoding="utf-8")
    assert not differences(page)
