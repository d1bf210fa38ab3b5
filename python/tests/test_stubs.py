"""What editors and type checkers are told is what the module has."""

import ast
import pathlib
import subprocess
import sys

import swayaw

PYTHON = pathlib.Path(__file__).parents[1]


def test_stubs_are_as_the_module_has_it():
    made = subprocess.run(
        [sys.executable, PYTHON / "stubs" / "make_stubs.py", "--check"], capture_output=True, text=True, check=False
    )
    assert made.returncode == 0, made.stderr


def test_every_public_name_is_in_the_stubs_and_explained():
    tree = ast.parse((PYTHON / "swayaw" / "__init__.pyi").read_text(encoding="utf-8"))
    names = {node.name for node in tree.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    for name in swayaw.__all__:
        if name not in ("__version__", "figures"):
            assert name in names, name
            assert (getattr(swayaw, name).__doc__ or "").strip(), name


def test_no_name_of_cpp_is_left_in_a_docstring():
    for name in swayaw.__all__:
        value = getattr(swayaw, name)
        members = vars(value).values() if isinstance(value, type) else [value]
        for member in members:
            assert "swayaw::" not in (getattr(member, "__doc__", None) or ""), (name, member)
