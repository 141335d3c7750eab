"""README.md: something that is on no list, found in a record of an independent program."""
from docfigures.hidden import answer, errors, verdict

DOCUMENT = "README.md"
PART = "hidden."


def figures(phs):
    return {"verdict": verdict(answer(phs, "off_list")), "errors": errors(phs, "off_list")}
