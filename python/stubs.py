"""Writes the type stubs of the module: the names, types and texts that it has itself.

usage: stubs.py FOLDER, of the package acmap"""

import ast
import inspect
import pathlib
import re
import sys
import textwrap
import types

folder = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, str(folder.parent))
import acmap  # noqa: E402

head = '''"""{doc}"""

# Made from the module by python/stubs.py.

import os
import types
from typing import Any, Callable, Dict, List, NoReturn, Optional, Sequence, Tuple, Union

import numpy
from numpy.typing import NDArray

class _Class(type): ...

_Vector = Union[Sequence[float], NDArray[numpy.floating[Any]]]

__version__: str
'''

fields_of_reports = """
    seconds: List[Tuple[str, float]]
    remarks: List[str]
"""


def result_type(shown):
    """The type that pybind11 shows, as mypy knows it."""
    shown = re.sub(r"Annotated\[(.*?), FixedSize\(\d+\)\]", r"\1", shown)
    shown = re.sub(r"(?<=[\w\]])\[\d+\]\]", "]", shown)  # List[float[3]]
    shown = re.sub(r"numpy\.ndarray\[(?:numpy\.)?(\w+)(\[[^]]*\])?\]", r"NDArray[numpy.\1]", shown)
    shown = re.sub(r"numpy\.ndarray\b", "NDArray[Any]", shown)
    shown = shown.replace("os.PathLike", "os.PathLike[str]")
    # None only beside what comes from a file: not every program has to ask.
    shown = shown.replace("Optional[acmap.Report]", "Union[Report, Any]")
    return shown.replace("acmap.", "")


def parameter_type(shown):
    """Tuples and arrays do where a list is shown."""
    shown = re.sub(r"[Ll]ist\[float\]", "_Vector", result_type(shown))
    return re.sub(r"\b[Ll]ist\[", "Sequence[", shown)


def function(name, thing):
    """thing begins with what pybind11 shows of it: name(one: type = default) -> type."""
    shown, _, help = thing.__doc__.partition("\n\n")
    parameters, _, result = shown[shown.index("(") :].strip().rpartition(" -> ")
    parameters = re.sub(r"^\(self: [\w.]+", "(self", parameter_type(parameters))
    return f"def {name}{parameters} -> {result_type(result)}:", inspect.cleandoc(help)


def described(declaration, help, indent=""):
    return f"{indent}{declaration}\n" + textwrap.indent(f'"""{help}"""\n', indent + "    ")


def members_of(cls):
    for name, member in vars(cls).items():
        if isinstance(member, property):
            declaration, _ = function(name, member.fget)
            yield "    @property\n" + described(declaration, member.__doc__, "    ")
        elif isinstance(member, types.WrapperDescriptorType):  # for what only acmap makes
            yield "    def __init__(self, *args: NoReturn, **kwargs: NoReturn) -> None: ...\n"
        elif name == "__init__" or not name.startswith("_"):
            yield described(*function(name, member), "    ")


def stub_of(name, thing):
    if not inspect.isclass(thing):
        return described(*function(name, thing))
    base = thing.__base__.__name__
    declaration = f"class {name}({base if hasattr(acmap, base) else 'metaclass=_Class'}):"
    return "\n".join([described(declaration, inspect.getdoc(thing)), *members_of(thing)])


listed = {"Cancelled", "Report"}
things = [
    stub_of(name, thing)
    for name, thing in vars(acmap).items()
    if not name.startswith("_") and name not in listed
]
stub = "\n".join(
    [
        head.format(doc=acmap.__doc__),
        described("class Cancelled(Exception):", acmap.Cancelled.__doc__),
        described("class Report(types.SimpleNamespace):", acmap.Report.__doc__) + fields_of_reports,
        *things,
    ]
)
ast.parse(stub)
(folder / "__init__.pyi").write_text(stub)
