"""Markdown as GitHub reads it, written as MkDocs reads it."""
import re

FENCE = re.compile(r"^(\s*)(```+|~~~+)(.*)$")
ITEM = re.compile(r"^(\s*)([-*+]|\d+\.) +")
COMMENT = re.compile(r"<!--.*?-->", re.S)
INLINE_MATH = re.compile(r"\$`([^`]+)`\$")


def to_mkdocs(text, links=lambda text: text):
    """`links` is applied to the text outside of code."""
    blocks = split(text)
    out = []
    for kind, lines in blocks:
        if kind == "code":
            out += code(lines)
        else:
            out += prose("\n".join(lines), links)
    return "\n".join(out) + "\n"


def split(text):
    """[(prose | code, lines)]; a comment outside of code is left away before."""
    blocks, lines, fence = [], [], None
    for line in text.split("\n"):
        match = FENCE.match(line)
        if fence is None and match:
            blocks.append(("prose", lines))
            lines, fence = [line], match[2]
        elif fence is not None and match and match[2].startswith(fence) and not match[3].strip():
            blocks.append(("code", lines + [line]))
            lines, fence = [], None
        else:
            lines.append(line)
    blocks.append(("prose", lines))
    return blocks


def code(lines):
    indent, _, info = FENCE.match(lines[0]).groups()
    indent = deeper(indent)
    inner = [line.strip() if not line.strip() else line for line in lines[1:-1]]
    own = min((len(line) - len(line.lstrip()) for line in inner if line), default=0)
    own = min(own, len(FENCE.match(lines[0])[1]))
    if info.strip() == "math":
        tex = " ".join(line.strip() for line in inner)
        return ["", f"{indent}\\[ {tex} \\]", ""]
    return [f"{indent}```{info}"] + [indent + line[own:] for line in inner] + [f"{indent}```", ""]


def prose(text, links):
    # A table may begin on the line after a comment: the comment's place stays empty.
    text = COMMENT.sub("", text)
    text = outside_code(text, links)
    text = INLINE_MATH.sub(r"\\(\1\\)", text)
    out = []
    in_list = False
    for line in text.split("\n"):
        before = out[-1] if out else ""
        item = ITEM.match(line)
        if item:
            # A list needs an empty line before it, but not between its items.
            if before.strip() and not in_list:
                out.append("")
            in_list = True
            line = deeper(item[1]) + line.strip()
        elif in_list and line.startswith(" "):
            line = deeper(line[:len(line) - len(line.lstrip())]) + line.strip()
        elif not line.strip() or line.startswith("#"):
            pass
        else:
            if in_list and not before.strip():
                in_list = False
            if line.startswith("|") and before.strip() and not before.startswith("|"):
                out.append("")
                in_list = False
        out.append(line)
    return out


def outside_code(text, change):
    """`change` applied to what is not between backticks."""
    parts = re.split(r"(`+[^`]*?`+)", text)
    # A link's text may hold code: its target stands outside, behind the bracket.
    return "".join(part if i % 2 else change(part) for i, part in enumerate(parts))


def deeper(indent):
    """Two or three columns of GitHub's nested lists are four here."""
    return " " * (4 * ((len(indent) + 2) // 3 if len(indent) < 4 else len(indent) // 2))
