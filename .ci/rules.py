#!/usr/bin/env python3
"""rules.py [CHECKOUT]: the rules of the sources and texts that no compiler checks. Prints what breaks one; returns 1 then.

- includes    tests -> gui -> core; rooms (core/ray, gui/view) include each other in one direction
- names       nothing that a header of Windows or a library turns into something else, nothing asked in two places
- words       texts use the terms of resources/manual/glossary.md, not those of its column "Not"
- twins       each text has its Chinese: messages, window, manual, formulas, help of the command, templates
- data        each file of tests/data/texts has a test"""
import collections, graphlib, json, pathlib, re, shutil, subprocess, sys, tempfile, xml.etree.ElementTree

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
RESOURCES = ROOT / "resources"
INCLUDE = re.compile(r'^\s*#\s*include\s*["<]((?:core|gui|tests|\.)/?[^">]+)', re.MULTILINE)
STRIPPED = re.compile(r'R"(\w*)\(.*?\)\1"|//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', re.DOTALL)
# What may stand only in some files: a pattern, the files that are read, those that may have it, and why.
ONLY = [
    (r"\b(?:near|far)\b", "core gui tests", "", "Windows defines it as a macro: nearDistance, farPlane"),
    (r"^\s*using namespace", "core/**.h gui/**.h tests/**.h", "", "a header passes the names on"),
    (r"hardware_concurrency", "core gui", "core/base/parallel.cpp", "each question opens a file: base::coreCount()"),
    (r"QFileDialog", "gui", "gui/widgets/file_dialogs.cpp gui/widgets/save_name.cpp", "it starts in no known folder"),
    (r"(?:new|public|make_unique<)\s*Q(?:Plain)?TextEdit\b|QGraphicsTextItem|setReadOnly\(false\)", "gui",
     "gui/widgets/plain_text_box.cpp gui/widgets/plain_text_box.h", "a paste of nothing ends the program: PlainTextBox"),
]
GHOSTS = ("are said|are told|besides|come about|comes about|is said|is told|let go|lets go|nobody|somebody|take apart|tell apart|told apart|"
          "turned round|turn round|whatever|what is to be|wherever|whoever|there is nothing of")
found: list[str] = []


def sources(*folders: str):
    for folder in folders:
        where, pattern = folder.split("/**") if "/**" in folder else (folder, "")
        for file in sorted((ROOT / where).rglob("*" + pattern)):
            if file.suffix in (".h", ".hpp", ".cpp", ".inl"):
                yield str(file.relative_to(ROOT)), file.read_text(encoding="utf8")


def includes() -> None:
    graph = collections.defaultdict(set)
    level = {"core": 0, "gui": 1, "tests": 2}
    for file, text in sources("core", "gui"):
        for other in INCLUDE.findall(text):
            if other[0] == ".":
                found.append(f"{file} includes {other} without its room")
            elif level[other.split("/")[0]] > level[file.split("/")[0]] or (file.startswith("gui/") and other.startswith("core/cli/")):
                found.append(f"{file} includes {other}, which may include it")
            graph["/".join(file.split("/")[:2])].add("/".join(other.split("/")[:2]))
    try:
        graphlib.TopologicalSorter({room: others - {room} for room, others in graph.items()}).prepare()
    except graphlib.CycleError as circle:
        found.append("rooms in a circle: " + " > ".join(circle.args[1]))


def names() -> None:
    for pattern, folders, allowed, reason in ONLY:
        for file, text in sources(*folders.split()):
            if file not in allowed.split() and (match := re.search(pattern, STRIPPED.sub(" ", text), re.MULTILINE)):
                found.append(f"{file}: {match.group().strip()}: {reason}")


def strings(value) -> list[str]:
    if isinstance(value, str):
        return [value]
    return [text for inner in (value.values() if isinstance(value, dict) else value if isinstance(value, list) else []) for text in strings(inner)]


def prose(page: str) -> str:
    return re.sub(r"^```.*?^```|`[^`\n]*`|\]\([^)]*\)", " ", page, flags=re.DOTALL | re.MULTILINE)


def messages_of_window():
    """The texts of the window with their translations, brought up to date where Qt's lupdate is installed."""
    with tempfile.TemporaryDirectory() as folder:
        file = shutil.copy(RESOURCES / "translations/unprojector_zh_CN.ts", folder)
        if lupdate := shutil.which("lupdate") or shutil.which("/usr/lib/qt6/bin/lupdate"):
            subprocess.run([lupdate, "-silent", "-no-obsolete", "-locations", "none", "-I", ROOT, ROOT / "gui", "-ts", file],
                           check=True, stderr=subprocess.DEVNULL)
        return [(message.findtext("source"), message.find("translation")) for message in xml.etree.ElementTree.parse(file).iter("message")]


def words() -> None:
    glossary = (RESOURCES / "manual/glossary.md").read_text(encoding="utf8")
    wrong = [term.strip() for row in re.findall(r"^\|[^|]*\|[^|]*\|([^|]*)\|\s*$", glossary, re.MULTILINE) for term in row.split(",")]
    terms = "|".join(re.escape(term) for term in wrong if term not in ("–", "Not", "---", ""))
    texts = [("window", source) for source, _ in messages_of_window()]
    texts += [("messages", key) for key in json.loads((RESOURCES / "translations/unproject_zh_CN.json").read_text(encoding="utf8"))]
    for file in sorted((RESOURCES / "lessons").glob("*.json")):
        if "_zh" not in file.name:
            texts += [(file.name, re.sub("<[^>]*>", " ", text)) for text in strings(json.loads(file.read_text(encoding="utf8"))) if " " in text]
    for file in [ROOT / "README.md", *sorted((RESOURCES / "manual").glob("*.md")), *sorted((RESOURCES / "help").rglob("*.*"))]:
        if file.name != "glossary.md" and "_zh_CN" not in file.name:
            texts.append((file.name, re.sub("<[^>]*>", " ", prose(file.read_text(encoding="utf8")))))
    for where, text in texts:
        for match in re.finditer(rf"\b(?:{terms}|{GHOSTS})s?\b", re.sub(r"[*_]|\s+", " ", text), re.IGNORECASE):
            found.append(f"{where}: “{match.group()}” is no term: {text.strip()[:80] if len(text) < 500 else ''}")


def told(code: str, calls: str):
    """The literals in the first argument of each call; those side by side are one."""
    for call in re.finditer(rf"(?<!\w)(?:{calls})\(", code):
        depth, texts, isBeside = 0, [], False
        for token in re.finditer(r'"((?:\\.|[^"\\])*)"|\'(?:\\.|[^\'])\'|\S', code[call.end():]):
            if token[1] is not None:
                text = re.sub(r"\\(.)", lambda escape: "\n" if escape[1] == "n" else escape[1], token[1])
                texts[len(texts) - isBeside:] = ["".join(texts[-1:]) + text if isBeside else text]
            depth += {"(": 1, "{": 1, ")": -1, "}": -1}.get(token[0], 0)
            if depth < 0 or (token[0] == "," and depth == 0):
                break
            isBeside = token[1] is not None
        yield from texts


def shape(text: str) -> list[str]:
    """What a text and its translation have in common: places of values, links, headings, options."""
    return sorted(re.findall(r"%\d|%n|href=['\"][^'\"]*|\]\(|</?(?!i\b)[a-z]+\b|^#+ |^\|(?=\s?-)|^```.*|^\[\S+(?=(?: \S+)?\]$)|id=\"[^\"]*\"", text, re.MULTILINE))


def twins() -> None:
    catalogue = json.loads((RESOURCES / "translations/unproject_zh_CN.json").read_text(encoding="utf8"))
    said = {mistake[key] for mistake in json.loads((RESOURCES / "doctor/mistakes.json").read_text(encoding="utf8")) for key in ("name", "sentence")}
    for room, calls in ("core", "tr|marked"), ("gui", "marked"):
        said.update(*(told(re.sub(r"//[^\"\n]*$", "", code, flags=re.MULTILINE), calls) for _, code in sources(room)))
    found.extend(f"unproject_zh_CN.json and core: only one has: {text}" for text in sorted(said ^ catalogue.keys()))
    pairs = [("core: " + key, key, text) for key, text in catalogue.items()]
    for source, translation in messages_of_window():
        if translation.get("type") or not "".join(translation.itertext()).strip():
            found.append(f"window: no Chinese for: {source}")
        pairs.append(("window: " + source, source, "".join(translation.itertext())))
    for file in [*(RESOURCES / "manual").glob("*.md"), *(RESOURCES / "help").rglob("*.*"), *(RESOURCES / "templates").glob("*.csv")]:
        twin = file.parent / "zh_CN" / file.name if file.suffix == ".md" else file.with_stem(file.stem + "_zh_CN")
        if "_zh_CN" in file.name or file.name == "development.md":
            continue
        if not twin.is_file():
            found.append(f"{file.relative_to(ROOT)}: there is no {twin.relative_to(ROOT)}")
        elif file.suffix == ".csv":
            pairs.append((file.name, *("# line\n" * each.read_text(encoding="utf8").count("\n") for each in (file, twin))))
        else:
            pairs.append((file.name, *(re.sub(r"\]\([^)]*\)", "](link)", each.read_text(encoding="utf8")) for each in (file, twin))))
    found.extend(f"{where}: its Chinese has other values, links or headings" for where, text, twin in pairs if shape(text) != shape(twin))


def data() -> None:
    read = re.findall(r'(?:addCases|cases)\("([^"]+)"\)', "".join(text for _, text in sources("tests")))
    read += re.findall(r'"([\w.]+)"', (ROOT / "core/landmark_files/landmark_file.cpp").read_text()) # by suffixOf
    found.extend(f"{file.relative_to(ROOT)}: no test reads it" for file in (ROOT / "tests/data/texts").iterdir() if file.stem not in read)


for rule in (includes, names, words, twins, data):
    rule()
print(*found, sep="\n", end="\n" if found else "")
sys.exit(bool(found))
