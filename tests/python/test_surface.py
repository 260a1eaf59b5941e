"""The module's names, types and help."""

import ast
import inspect
import pathlib
import subprocess
import sys

import pytest
import unprojector as up

STUBS = ast.parse((pathlib.Path(up.__file__).parent / "__init__.pyi").read_text(encoding="utf-8"))


def names_of(body):
    found = {}
    for node in body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and not node.name.startswith("_"):
            found[node.name] = node
    return found


def public(thing):
    return {name for name in dir(thing) if not name.startswith("_")}


def test_stubs_name_what_the_module_has():
    stubs = names_of(STUBS.body)
    assert set(stubs) == set(up.__all__)
    for name, node in stubs.items():
        if name == "Stages":
            assert tuple(field.target.id for field in node.body) == up.Stages._fields
        elif isinstance(node, ast.ClassDef):
            assert set(names_of(node.body)) == public(getattr(up, name)), name


def test_stubs_have_the_arguments_of_the_help():
    for name, node in names_of(STUBS.body).items():
        functions = names_of(node.body).values() if isinstance(node, ast.ClassDef) else [node]
        for function in functions:
            if name == "Stages" or any(isinstance(d, ast.Name) and d.id == "property" for d in function.decorator_list):
                continue
            owner = getattr(up, name) if isinstance(node, ast.ClassDef) else up
            help_text = getattr(owner, function.name).__doc__
            for argument in [*function.args.args, *function.args.kwonlyargs]:
                if argument.arg != "self":
                    assert argument.arg in help_text, (name, function.name, argument.arg)


def test_everything_public_has_help():
    for name in up.__all__:
        thing = getattr(up, name)
        assert inspect.getdoc(thing), name
        if inspect.isclass(thing):
            for member in public(thing):
                assert inspect.getdoc(getattr(thing, member)), (name, member)


def test_help_shows_no_signature_of_cpp():
    for thing in (up.Setup.unproject, up.Setup.cloud, up.Scene.pick, up.diagnose, up.read_landmarks):
        assert "::" not in thing.__doc__ and "arg0" not in thing.__doc__


@pytest.mark.skipif(sys.flags.optimize > 0, reason="asserts are off")
def test_importing_needs_nothing_but_numpy():
    code = "import sys, numpy; before = set(sys.modules); import unprojector; print(sorted(m.split('.')[0] for m in set(sys.modules) - before))"
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True, text=True).stdout
    assert set(ast.literal_eval(printed)) <= {"unprojector", "pathlib", "fnmatch", "ntpath", "urllib", "ipaddress", "errno"}
