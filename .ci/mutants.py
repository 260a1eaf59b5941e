#!/usr/bin/env python3
"""mutants.py FOLDER [COUNT [SEED]]: tells which of COUNT (60) small faults in the product the tests find.

Copies the sources to FOLDER, puts all faults into the copy (the variable MUTANT chooses one), builds it, and runs every
test once to learn which faults it reaches. Then it runs, for each fault, the tests that reach it, those of its room and
the fastest first, until one fails twice. Prints a table: no test finds a fault that "lives". 60 faults take an hour and
more on two cores. The same SEED gives the same faults: there, MUTANT=7 ctest --preset dev tries fault 7."""
import concurrent.futures, json, os, pathlib, random, re, shlex, subprocess, sys, time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROOMS = [*(f"core/{room}" for room in "base geometry unproject ray mesh landmarks doctor scene_file cameras pipeline".split()),
         "gui/document", "gui/view"]
HEADER = """#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#include <array>
#include <atomic>
#include <cstdlib>
#include <fstream>
inline bool mutant(int number)
{
    static const int chosen = std::getenv("MUTANT") ? std::atoi(std::getenv("MUTANT")) : 0;
    static const char *const folder = std::getenv("MUTANTS_REACHED");
    static std::array<std::atomic<bool>, 1000> reached{};
    if (folder && !reached[std::size_t(number)].exchange(true))
        std::ofstream(std::string(folder) + "/" + std::to_string(number)) << number;
    return number == chosen;
}
"""
SWAPS = {"sign": {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * ", "(-": "("},
         "comparison": {" < ": " <= ", " > ": " >= ", " <= ": " < ", " >= ": " > ", " == ": " != ", " != ": " == ",
                        " && ": " || ", " || ": " && ", "(!": "("},
         "index": {".x": ".y", ".y": ".z", ".z": ".x", "[0]": "[1]", "[1]": "[0]", "[2]": "[0]", "[i]": "[i + 1]"}}
NUMBER = re.compile(r"(?<![\w.\"])\d+(?:\.\d+)?(?![\w.\"])")
RETURN = re.compile(r"(\s+)return (.+);$")
CONDITION = re.compile(r"(\s+(?:\} else )?(?:if|while) )(\([^;=]*(?:[=!<>]=[^;=]*)*\))( \{)?$")
ASSIGNMENT = re.compile(r"(\s+)([^=()]+ [-+*/]?= )(.+);$")
CALL = re.compile(r"(\s+)((?!return |delete |using |throw )[\w.:>\-\[\]]+\(.*\));$")


def changes(text: str):
    """(kind, the expression with one change), for every place in it."""
    for kind, swaps in SWAPS.items():
        for old, new in swaps.items():
            for found in re.finditer(re.escape(old) + (r"\b" if old[-1].isalpha() else ""), text):
                yield kind, text[:found.start()] + new + text[found.end():]
    for found in NUMBER.finditer(text):
        number = found.group()
        other = str(float(number) * 1.5 + 0.25) if "." in number else str(int(number) + 1)
        yield "constant", text[:found.start()] + other + text[found.end():]


def mutated(line: str, number: int):
    """(kind, the changed part, the line with the choice) for each possible change of a line."""
    if '"' in line or "//" in line or "constexpr" in line or "mutant(" in line or line.count("(") != line.count(")"):
        return
    fault = f"mutant({number})"
    if found := RETURN.match(line):
        for kind, text in changes(found[2]):
            yield kind, f"return {text};", f"{found[1]}{{ if ({fault}) return {text}; return {found[2]}; }}"
    elif found := CONDITION.match(line):
        for kind, text in changes(found[2]):
            yield kind, text, f"{found[1]}({fault} ? bool{text} : bool{found[2]}){found[3] or ''}"
    elif found := ASSIGNMENT.match(line):
        for kind, text in changes(found[3]):
            yield kind, found[2] + text, f"{found[1]}{found[2]}{fault} ? ({text}) : ({found[3]});"
        if " " not in found[2].split(" = ")[0].strip(" +-*/="):
            yield "dropped", "", f"{found[1]}{{ if (!{fault}) {line.strip()} }}"
    elif found := CALL.match(line):
        yield "dropped", "", f"{found[1]}{{ if (!{fault}) {line.strip()} }}"
        for kind, text in changes(found[2]):
            yield kind, text, f"{found[1]}{{ if ({fault}) {text}; else {found[2]}; }}"


def draw(folder: pathlib.Path, count: int, dice: random.Random) -> list[dict]:
    """Puts the faults into the copy, as many into each room. A fault that the compiler warns of is not counted."""
    commands = {entry["file"]: entry for entry in json.loads((folder / "build/dev/compile_commands.json").read_text())}
    rooms = [[(file, line) for file in sorted((folder / room).rglob("*.cpp")) if str(file) in commands
              for line in range(len(file.read_text().splitlines()))] for room in ROOMS]
    for room in rooms:
        dice.shuffle(room)
    faults: list[dict] = []
    while len(faults) < count and any(rooms):
        room = rooms[len(faults) % len(rooms)]
        file, at = room.pop() if room else dice.choice([place for other in rooms for place in other])
        lines = (original := file.read_text()).splitlines()
        at += lines[0].endswith('/mutant.h"')
        if not (options := list(mutated(lines[at], len(faults) + 1))):
            continue
        kind = dice.choice(sorted({option[0] for option in options}))
        _, change, both = dice.choice([option for option in options if option[0] == kind])
        was, lines[at] = lines[at].strip(), both
        if "/mutant.h" not in lines[0]:
            lines[0] = f'#include "{folder}/mutant.h"\n{lines[0]}'
        file.write_text("\n".join(lines) + "\n")
        command = [word for word in shlex.split(commands[str(file)]["command"]) if not word.endswith("ccache")]
        if subprocess.run([*command, "-fsyntax-only"], cwd=commands[str(file)]["directory"], capture_output=True, check=False).returncode:
            file.write_text(original)
        else:
            faults.append({"place": f"{file.relative_to(folder)}:{at + ('mutant.h' not in original)}", "kind": kind, "was": was, "is": change})
    return faults


def main(folder: pathlib.Path, count: int, seed: int) -> None:
    def shell(command: str, **variables: str) -> subprocess.CompletedProcess:
        return subprocess.run(["bash", "-c", f"source {ROOT}/.ci/common.sh && export CCACHE_BASEDIR={folder} && cd {folder} && {command}"],
                              check=not variables, stdout=subprocess.PIPE, env=os.environ | variables)

    def passes(test: str, limit: float, **variables: str) -> bool:
        return not shell(f"timeout -k 9 {limit:.0f} ctest --test-dir build/dev --no-tests=error -R '^{re.escape(test)}$'", **variables).returncode

    folder.mkdir(parents=True)
    shell(f"git -C {ROOT} ls-files -z | (cd {ROOT} && xargs -0 cp --parents -t {folder})")
    (folder / "mutant.h").write_text(HEADER)
    launcher = folder / "tests/launch.sh" # runs a test without the variables that it does not know
    launcher.write_text(launcher.read_text().replace("for name in ", "for name in MUTANT MUTANTS_REACHED ", 1))
    shell("cmake --preset dev")
    faults = draw(folder, count, random.Random(seed))
    shell("cmake --build --preset dev")
    tests = {test["name"]: " ".join(test["command"]) for test in json.loads(shell("ctest --test-dir build/dev --show-only=json-v1").stdout)["tests"]}
    reaching: dict[int, list[tuple[float, str]]] = {number: [] for number in range(1, len(faults) + 1)}

    def learn(test: str) -> None:
        (reached := folder / "reached" / test).mkdir(parents=True)
        reached.chmod(0o777) # some tests run as another user
        start = time.monotonic()
        if not passes(test, 900, MUTANTS_REACHED=str(reached)):
            print(f"{test} fails without a fault: it is left out", file=sys.stderr)
            return
        for file in reached.iterdir():
            reaching[int(file.name)].append((time.monotonic() - start, test))

    def find(number: int) -> str:
        room = "tests_" + "_".join(faults[number - 1]["place"].split("/")[:2]).replace("_file", "")
        for seconds, test in sorted(reaching[number], key=lambda known: (room not in tests[known[1]], known)):
            if not any(passes(test, 5 * seconds + 60, MUTANT=str(number)) for _ in range(2)): # no test fails by chance twice
                return test
        return "**lives**" if reaching[number] else "**lives: no test reaches it**"

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(learn, tests))
        print("| | place | kind | was | is | found by |\n|---|---|---|---|---|---|")
        for number, fault in zip(reaching, faults):
            fault["test"] = pool.submit(find, number)
        for number, fault in zip(reaching, faults):
            fault["test"] = fault["test"].result()
            print(f"| {number} | {fault['place']} | {fault['kind']} | `{fault['was']}` | `{fault['is']}` | {fault['test']} |", flush=True)
    print(f"\n{sum('lives' in fault['test'] for fault in faults)} of {len(faults)} live.")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve(), int((sys.argv[2:] or [60])[0]), int((sys.argv[3:] or [1])[0]))
