"""docs/program.md: the options of every verb, as --help says them."""
import re

DOCUMENT = "docs/program.md"


def verbs(phs):
    """Names under "Subcommands:" of phs --help."""
    lines = phs.plain("--help").partition("Subcommands:")[2].splitlines()
    return [m.group(1) for m in (re.match(r"  (\w[\w-]*)", line) for line in lines) if m]


def block(phs, verb):
    text = phs.plain(verb + " --help")
    text = re.sub(r"\n *-h,--help [^\n]*", "", text)
    text = re.sub(r"(--threads [^\n]*\])=\d+", r"\1", text)  # as many as the machine has
    lines = [line.rstrip() for line in text.strip().splitlines()]
    text = re.sub(r"\n{2,}", "\n\n", "\n".join(lines))
    return f"### `phs {verb}`\n```\n{text}\n```"


def figures(phs):
    return {"options": "\n" + "\n\n".join(block(phs, verb) for verb in verbs(phs)) + "\n"}
