"""Pages that are made from code: keys of YAML files, the Python package, the C API; files and folders."""
import ast
import json
import re

LANGUAGES = {".yml": "yaml", ".yaml": "yaml", ".csv": "text", ".py": "python", ".json": "json",
             ".h": "c", "": "text"}
MOST_LINES = 400


def fence(text, language):
    ticks = "````" if "```" in text else "```"
    return f"{ticks}{language}\n{text.rstrip()}\n{ticks}\n"


def file(path, within):
    lines = path.read_text(encoding="utf-8").splitlines()
    shown = "\n".join(lines[:MOST_LINES])
    more = f"\n{len(lines) - MOST_LINES} further lines are in the file itself.\n" * (len(lines) > MOST_LINES)
    return f"# {within.name}\n\n`{within}` of the sources.\n\n{fence(shown, LANGUAGES.get(path.suffix, 'text'))}{more}"


def folder(path, within):
    text = f"# {within}\n\nA folder of the sources.\n\n"
    for each in sorted(path.rglob("*")):
        if each.is_file():
            text += f"## {each.relative_to(path)}\n\n"
            text += fence(each.read_text(encoding="utf-8"), LANGUAGES.get(each.suffix, "text")) + "\n"
    return text


def reference(root):
    return {"reference/files.md": schemas(root), "reference/python.md": python_package(root),
            "reference/c_api.md": c_api(root)}


# ---- Keys of YAML files ----

KINDS = ("scenario", "track", "phs", "rig", "study", "mapping", "limits", "known_misses")


def schemas(root):
    text = ("# Keys of YAML files\n\nMade from the JSON schemas, which are made from the readers "
            "([YAML files in an editor](../schemas.md)). A key below another one is written with a dot; `[]` is "
            "an element of a list, `NAME` any name.\n")
    for kind in KINDS:
        schema = json.loads((root / f"models/schemas/{kind}.json").read_text(encoding="utf-8"))
        rows = list(keys(schema, "", schema))
        text += f"\n## {kind}\n\n{schema['description'].split('; made by')[0]}.\n\n"
        text += "| key | holds | default |\n|---|---|---|\n"
        for name, holds, default in rows:
            text += f"| `{name}` | {holds} | {default} |\n"
    return text


def keys(schema, prefix, whole, depth=0):
    """(key, what it holds, default) of everything below."""
    seen = set()
    for option in options(schema, whole):
        for name, part in option.get("properties", {}).items():
            if (prefix + name) in seen:
                continue
            seen.add(prefix + name)
            yield prefix + name, holds(part, whole), default_of(part)
            if depth < 4:
                yield from keys(part, prefix + name + ".", whole, depth + 1)
        items = option.get("items")
        if isinstance(items, dict):
            yield from keys(items, prefix[:-1] + "[].", whole, depth + 1)
        more = option.get("additionalProperties")
        if isinstance(more, dict) and depth < 4:
            yield from keys(more, prefix + "NAME.", whole, depth + 1)


def options(schema, whole):
    """The schema, or those it is one of; references followed."""
    if "$ref" in schema:
        part = whole
        for step in schema["$ref"].removeprefix("#/").split("/"):
            part = part[step]
        yield from options(part, whole)
        return
    yield schema
    for name in ("anyOf", "oneOf", "allOf"):
        for option in schema.get(name, ()):
            yield from options(option, whole)


def holds(schema, whole):
    found = []
    for option in options(schema, whole):
        if "enum" in option:
            found.append(", ".join(f"`{word}`" for word in option["enum"]))
        elif option.get("type") == "number" or option.get("type") == "integer":
            found.append(("whole number" if option["type"] == "integer" else "number") + bounds(option))
        elif option.get("type") == "array":
            found.append("list")
        elif "object" in as_list(option.get("type")):
            found.append("map")
        elif "type" in option:
            found.append("text" if "string" in as_list(option["type"]) else "yes or no")
    text = " or ".join(dict.fromkeys(found)) or "anything"
    # Texts of the tables are written for the pages of docs/.
    told = re.sub(r"\]\((?=[a-z_]+\.md)", "](../", schema.get("description", ""))
    return f"{text}: {told}".replace("|", "\\|") if told else text


def as_list(value):
    return value if isinstance(value, list) else [value]


def bounds(option):
    low = option.get("minimum", option.get("exclusiveMinimum"))
    high = option.get("maximum", option.get("exclusiveMaximum"))
    if low is None and high is None:
        return ""
    begin = f" > {low:g}" if "exclusiveMinimum" in option else f" {low:g}" if low is not None else ""
    if high is None:
        return begin if begin.startswith(" >") else f" ≥{begin}"
    end = f"< {high:g}" if "exclusiveMaximum" in option else f"{high:g}"
    return f"{begin} … {end}" if low is not None else f" ≤ {end}"


def default_of(schema):
    if "default" not in schema:
        return ""
    return f"`{json.dumps(schema['default'], ensure_ascii=False)}`".replace("|", "\\|")


# ---- The Python package ----

def python_package(root):
    package = root / "python/phs"
    names = exported(package / "__init__.py")
    text = ("# Functions and classes of the Python package\n\nMade from the sources of the package. "
            "How to use it: [Python](../python.md).\n")
    functions, classes, found = [], [], set()
    for module in sorted(package.glob("_*.py")):
        for node in ast.parse(module.read_text(encoding="utf-8")).body:
            if getattr(node, "name", None) in names:
                found.add(node.name)
                (functions if isinstance(node, ast.FunctionDef) else classes).append(node)
    missing = set(names) - found - {"__version__", "plot"}
    if missing:
        raise SystemExit(f"python/phs: {', '.join(sorted(missing))} is exported, but not found")
    text += "\n## Functions\n"
    for node in sorted(functions, key=lambda n: n.name):
        text += f"\n### phs.{node.name}\n\n" + fence(signature(node, "phs."), "python") + "\n" + documented(node)
    text += "\n## phs.plot\n"
    for node in ast.parse((package / "plot.py").read_text(encoding="utf-8")).body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            text += f"\n### phs.plot.{node.name}\n\n" + fence(signature(node, "phs.plot."), "python")
            text += "\n" + documented(node)
    text += "\n## Classes\n"
    for node in sorted(classes, key=lambda n: n.name):
        bases = ", ".join(ast.unparse(base) for base in node.bases)
        text += f"\n### phs.{node.name}\n\n" + (f"Is a `{bases}`. " if bases else "") + documented(node)
        rows = list(members(node))
        if rows:
            text += "\n| member | |\n|---|---|\n" + "".join(f"| {name} | {told} |\n" for name, told in rows)
    return text


def exported(init):
    for node in ast.parse(init.read_text(encoding="utf-8")).body:
        if isinstance(node, ast.Assign) and node.targets[0].id == "__all__":
            return [element.value for element in node.value.elts]
    raise SystemExit(f"{init}: no __all__")


def signature(node, prefix):
    """One parameter a line where it is long."""
    call = f"{prefix}{node.name}({ast.unparse(node.args)})"
    result = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    if len(call + result) <= 90:
        return call + result
    parts = re.split(r", (?![^\[(]*[\])])", ast.unparse(node.args))
    return f"{prefix}{node.name}(\n    " + ",\n    ".join(parts) + "\n)" + result


def documented(node):
    """The docstring; its examples as code."""
    told = ast.get_docstring(node) or ""
    out, example = [], False
    for line in told.splitlines():
        begins = line.startswith(">>>")
        if begins and not example:
            out.append("\n```python")
            example = True
        elif example and not line.strip():
            out.append("```\n")
            example = False
        out.append(line)
    return "\n".join(out + ["```"] * example) + "\n"


def members(node):
    for part in node.body:
        if not isinstance(part, ast.FunctionDef) or part.name.startswith("_"):
            continue
        told = " ".join((ast.get_docstring(part) or "").split("\n\n")[0].split()).replace("|", "\\|")
        is_property = any(getattr(d, "id", "") == "property" for d in part.decorator_list)
        arguments = [a.arg for a in part.args.args if a.arg not in ("self", "cls")]
        yield f"`{part.name}`" if is_property else f"`{part.name}({', '.join(arguments)})`", told


# ---- The C API ----

def c_api(root):
    header = (root / "plugin/phs_mujoco.h").read_text(encoding="utf-8")
    text = ("# C API of the plugin\n\nMade from `plugin/phs_mujoco.h`. How the plugin is declared in a model: "
            "[The MuJoCo plugin](../plugin.md).\n\n")
    begin = header[:header.index("#ifndef")]
    text += comment(begin, "//") + "\n"
    count = 0
    for told, function in re.findall(r"((?:^///.*\n)+)^PHS_API ([^;]+;)", header, re.M):
        name = re.search(r"(\w+)\(", function)[1]
        text += f"\n## {name}\n\n" + fence(" ".join(function.split()), "c") + "\n" + comment(told, "///") + "\n"
        count += 1
    if count != header.count("PHS_API ") - header.count("define PHS_API "):
        raise SystemExit("plugin/phs_mujoco.h: a function has no comment of its own")
    return text


def comment(text, mark):
    """A comment as prose; lines set in by three columns are code."""
    out, inside = [], False
    for line in text.splitlines():
        line = line.removeprefix(mark)
        is_code = line.startswith("   ")
        if is_code != inside:
            out.append("```c" if is_code else "```")
            inside = is_code
        out.append(line[3:] if is_code else line.strip())
    return "\n".join(out + ["```"] * inside)
