#!/usr/bin/env python3
"""The stub of the compiled half names what it has, with as many arguments: no more, no less."""
import ast
import inspect
import pathlib
import re
import sys

from phs import _phs


def of_stub(path):
    names = {}
    for node in ast.parse(path.read_text()).body:
        if isinstance(node, ast.FunctionDef):
            names[node.name] = len(node.args.args)
        elif isinstance(node, ast.ClassDef):
            for part in node.body:
                if isinstance(part, ast.FunctionDef):
                    names[f"{node.name}.{part.name}"] = len(part.args.args)
    return names


def of_module():
    names = {}
    for name, value in vars(_phs).items():
        if inspect.isclass(value):
            for part, method in vars(value).items():
                if not part.startswith("_"):
                    names[f"{name}.{part}"] = count(method)
        elif callable(value):
            names[name] = count(value)
    return names


def count(function):
    """Arguments by the line that pybind11 writes into the docstring."""
    return len(re.findall(r"\b(?:arg\d+|self): ", function.__doc__.splitlines()[0]))


stub, module = of_stub(pathlib.Path(_phs.__file__).parent / "_phs.pyi"), of_module()
different = {name for name in stub.keys() | module.keys() if stub.get(name) != module.get(name)}
for name in sorted(different):
    print(f"{name}: stub {stub.get(name)}, module {module.get(name)} arguments")
sys.exit(1 if different or not stub else 0)
