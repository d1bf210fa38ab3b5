"""Writes swayaw/__init__.pyi, what editors and type checkers know of the module, from its signatures and docstrings.

    PYTHONPATH=build/dev/python python3 python/stubs/make_stubs.py          # writes it
    PYTHONPATH=build/dev/python python3 python/stubs/make_stubs.py --check  # fails if it would be another
"""

import inspect
import pathlib
import re
import sys

import swayaw
from swayaw import _swayaw

FILE = pathlib.Path(__file__).parents[1] / "swayaw" / "__init__.pyi"

HEAD = '''# Made by python/stubs/make_stubs.py from the docstrings of the module.
from os import PathLike
from types import ModuleType
from typing import Any, Callable, Dict, Iterator, List, Mapping, NamedTuple, Optional, Set, Tuple, Union

import numpy
from numpy.typing import ArrayLike

__version__: str
figures: ModuleType
'''

#: as pybind11 writes a signature
SIGNATURE = re.compile(r"^(?:\d+\. )?(?P<name>\w+)\((?P<arguments>.*)\) -> (?P<result>.+)$")


def typed(text: str) -> str:
    """A type as pybind11 names it, in the words of a stub."""
    text = re.sub(r"numpy\.ndarray\[[^\]]*\]", "numpy.ndarray", text)
    text = re.sub(r"\b(\w+)\[\d+\]", r"\1", text)  # the length of a fixed array
    text = text.replace("swayaw.", "").replace("os.PathLike", "Union[str, PathLike[str]]").replace("handle", "Any")
    text = re.sub(r"\bobject\b", "Any", text)
    text = re.sub(r"\bUnion\[str, PathLike\[str\]\]", "Union[str, 'PathLike[str]']", text)
    return text.replace("function", "Callable[..., Any]")


def argument(text: str) -> str:
    """One argument: arrays may be anything that numpy takes, and a default is left to the docstring."""
    name, _, rest = text.partition(": ")
    if not rest:
        return text
    kind, _, default = rest.partition(" = ")
    kind = typed(kind).replace("numpy.ndarray", "ArrayLike")
    if default == "None" and not kind.startswith("Optional") and kind != "Any":
        kind = f"Optional[{kind}]"
    return f"{name}: {kind}" + (" = ..." if default else "")


def split(arguments: str) -> list:
    """Arguments at the commas that are in no bracket."""
    parts, depth, start = [], 0, 0
    for i, c in enumerate(arguments):
        depth += (c in "[(<") - (c in "])>")
        if c == "," and depth == 0:
            parts.append(arguments[start:i].strip())
            start = i + 1
    return [p for p in parts + [arguments[start:].strip()] if p]


def signatures(function) -> list:
    """All signatures of a function of the extension as "(…) -> …"."""
    found = [SIGNATURE.match(line) for line in (function.__doc__ or "").splitlines()]
    found = [f for f in found if f and f["name"] == function.__name__]
    if len(found) > 1 and "*args" in found[0]["arguments"]:
        found = found[1:]  # the head of overloads
    return [f"({', '.join(map(argument, split(f['arguments'])))}) -> {typed(f['result'])}" for f in found]


def words(docstring: str, indent: str) -> str:
    """The sentences of a docstring, without signatures."""
    lines = [line for line in inspect.cleandoc(docstring or "").splitlines() if not SIGNATURE.match(line)]
    text = "\n".join(lines).replace("Overloaded function.", "").strip()
    if not text:
        return ""
    text = re.sub(r"\n{3,}", "\n\n", text).replace("\\", "\\\\").replace("\n", f"\n{indent}")
    if text.startswith('"'):
        text = "\\" + text
    if text.endswith('"'):
        text = text[:-1] + '\\"'
    return f'{indent}"""{text}"""\n'


class Left:
    """A default that is left to the docstring."""

    def __repr__(self) -> str:
        return "..."


def python_signature(function) -> str:
    """Of a function written in Python."""
    signature = inspect.signature(function)
    arguments = [a if a.default is a.empty else a.replace(default=Left()) for a in signature.parameters.values()]
    text = str(signature.replace(parameters=arguments)).replace("'", "").replace("_swayaw.", "").replace("os.PathLike", "PathLike[str]")
    text = re.sub(r"(?<![\w.])PathLike\[str\]", "'PathLike[str]'", text).replace("swayaw.", "").replace("typing.", "")
    return text if "->" in text else f"{text} -> Any"


def function_stub(name: str, function, indent: str = "") -> str:
    text, inner = "", indent + "    "
    if inspect.isfunction(function):
        doc = words(function.__doc__, inner)
        return f"{indent}def {name}{python_signature(function)}:{chr(10) + doc if doc else ' ...' + chr(10)}"
    found = signatures(function) or ["(*args: Any, **kwargs: Any) -> Any"]
    doc = words(function.__doc__, inner)
    for i, signature in enumerate(found):
        overload = f"{indent}@overload\n" if len(found) > 1 else ""
        last = i + 1 == len(found)
        text += f"{overload}{indent}def {name}{signature}:{chr(10) + doc if last and doc else ' ...' + chr(10)}"
    return text


def property_stub(name: str, value: property, kind: str) -> str:
    if not kind:
        getter = signatures_of_property(value)
        kind = getter or "Any"
    doc = words(value.__doc__, "        ")
    text = f"    @property\n    def {name}(self) -> {kind}:{chr(10) + doc if doc else ' ...' + chr(10)}"
    if value.fset is not None:
        text += f"    @{name}.setter\n    def {name}(self, value: Any) -> None: ...\n"
    return text


def signatures_of_property(value: property) -> str:
    """The type that a getter returns, as its own docstring says."""
    match = re.search(r"-> (.+)$", (value.fget.__doc__ or "").splitlines()[0]) if value.fget.__doc__ else None
    return typed(match[1]) if match else ""


#: what Python gives every class, and what the package gives every value type
INHERITED = {"__module__", "__doc__", "__dict__", "__annotations__", "__hash__", "__getstate__", "__setstate__", "_fields",
             "_asdict", "_replace", "__repr__", "__eq__", "__weakref__", "samples_in_words"}


def constructor(cls) -> str:
    """By the fields of a value type that people make; else as pybind11 says."""
    if not hasattr(cls, "_fields"):
        if not signatures(cls.__init__):
            return ""  # none that people call
        return function_stub("__init__", cls.__init__, "    ")
    if "*args" not in (cls.__init__.__doc__ or ""):
        return ""
    fields = ", ".join(f"{name}: {typed(cls.__annotations__[name])} = ..." for name in cls._fields)
    return f"    def __init__(self, {fields}) -> None: ...\n"


def class_stub(name: str, cls) -> str:
    if issubclass(cls, Exception):
        places = "    file: str\n    line: int\n    column: int\n" if name == "FileError" else ""
        return f"class {name}({cls.__bases__[0].__name__}):\n{words(cls.__doc__, '    ')}{places}"
    text = f"class {name}:\n{words(cls.__doc__, '    ')}"
    kinds = {field: typed(kind) for field, kind in cls.__dict__.get("__annotations__", {}).items()}
    if hasattr(cls, "_fields"):
        text += "    def _asdict(self) -> Dict[str, Any]: ...\n"
        text += f"    def _replace(self, **values: Any) -> {name}: ...\n"
    members = {k: v for k, v in vars(cls).items() if k not in INHERITED}
    for member, value in sorted(members.items()):
        if isinstance(value, staticmethod):
            text += "    @staticmethod\n" + function_stub(member, value.__func__, "    ")
        elif type(value).__name__ == "pybind11_static_property":
            text += f"    {member}: Tuple[str, ...]\n"
        elif isinstance(value, property):
            text += property_stub(member, value, kinds.get(member, ""))
        elif member == "__init__":
            text += constructor(cls)
        elif callable(value) and not member.startswith("_pybind"):
            text += function_stub(member, value, "    ")
    return text


def tuple_stub(name: str, cls) -> str:
    """A named tuple or a dataclass of the package."""
    base = "(NamedTuple)" if issubclass(cls, tuple) else ""
    fields = "".join(f"    {field}: {getattr(kind, '__forward_arg__', kind)}\n" for field, kind in cls.__annotations__.items())
    own = {k: v for k, v in vars(cls).items() if inspect.isfunction(v) and not k.startswith("_")}
    methods = "".join(function_stub(k, v, "    ") for k, v in own.items())
    properties = "".join(
        property_stub(k, v, str(v.fget.__annotations__.get("return", "Any"))) for k, v in vars(cls).items()
        if isinstance(v, property)
    )
    return f"class {name}{base}:\n{words(cls.__doc__, '    ')}{fields}{methods}{properties}"


def stubs() -> str:
    names = [n for n in swayaw.__all__ if n not in ("__version__", "figures")]
    parts = []
    for name in names:
        value = getattr(swayaw, name)
        if isinstance(value, type) and getattr(_swayaw, name, None) is not value:
            parts.append(tuple_stub(name, value))
        elif isinstance(value, type):
            parts.append(class_stub(name, value))
        else:
            parts.append(function_stub(name, value))
    body = "\n".join(parts)
    head = HEAD.replace("Union\n", "Union, overload\n", 1) if "@overload" in body else HEAD
    return head + "\n" + body


def main() -> int:
    text = stubs()
    if "--check" in sys.argv[1:]:
        same = FILE.exists() and FILE.read_text(encoding="utf-8") == text
        if not same:
            print(f"{FILE} is not as python/stubs/make_stubs.py makes it", file=sys.stderr)
        return 0 if same else 1
    FILE.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
