"""The examples of this folder: KIND/NAME holds new files in their places, `rows` what is put into files that exist, and
`run`, a shell script that shows the example in use. `rows`:

    file: PATH
    after: | before: | change: BEGINNING OF THE ONE LINE MEANT
    | line that is put there
"""
import dataclasses
import pathlib
import re

HERE = pathlib.Path(__file__).resolve().parent
# Heading of CONTRIBUTING.md, files at most, examples at least.
KINDS = {
    "effect": ("An effect", 4, 3),
    "creep_law": ("A creep law", 5, 3),
    "element": ("An element between bodies", 5, 3),
    "bogie": ("A bogie", 2, 3),
    "output": ("An output channel", 2, 3),
    "verb": ("A verb", 4, 3),
    "number": ("A number of a PHS", 2, 1),
}


@dataclasses.dataclass
class Insertion:
    file: str
    where: str
    anchor: str
    lines: list


@dataclasses.dataclass
class Example:
    kind: str
    folder: pathlib.Path

    @property
    def name(self):
        return f"{self.kind}/{self.folder.name}"

    def new_files(self):
        """Path in the tree -> file."""
        return {str(path.relative_to(self.folder)): path for path in sorted(self.folder.rglob("*"))
                if path.is_file() and path.parent != self.folder}

    def insertions(self):
        found, file = [], None
        for line in (self.folder / "rows").read_text().splitlines():
            key, _, text = line.partition(": ")
            if line.startswith("|"):
                found[-1].lines.append(line[2:])
            elif key == "file":
                file = text
            elif key in ("after", "before", "change"):
                found.append(Insertion(file, key, text, []))
            else:
                raise ValueError(f"{self.name}/rows: what is '{line}'?")
        return found

    def touched(self):
        return sorted(set(self.new_files()) | {insertion.file for insertion in self.insertions()})


def all_examples():
    return [Example(kind, folder) for kind in KINDS for folder in sorted((HERE / kind).iterdir()) if folder.is_dir()]


def put(text, insertion):
    """The text with the lines put in; the anchor must begin one line and no other."""
    lines = text.split("\n")
    at = [i for i, line in enumerate(lines) if line.startswith(insertion.anchor)]
    if len(at) != 1:
        raise ValueError(f"{insertion.file}: {len(at)} lines begin with '{insertion.anchor}'")
    # A row may go on over several lines: it ends where a line closes it.
    last = at[0]
    if insertion.where == "after":
        while lines[last].lstrip().startswith("{") and not lines[last].endswith("},"):
            last += 1
            if lines[last].endswith("},"):
                break
    begin, end = {"after": (last + 1, last + 1), "before": (at[0], at[0]), "change": (at[0], at[0] + 1)}[insertion.where]
    return "\n".join(lines[:begin] + insertion.lines + lines[end:])


def apply(example, tree):
    """Does what the example says to `tree`, path -> bytes."""
    for path, file in example.new_files().items():
        if path in tree:
            raise ValueError(f"{example.name}: {path} is there already")
        tree[path] = file.read_bytes()
    for insertion in example.insertions():
        tree[insertion.file] = put(tree[insertion.file].decode(), insertion).encode()


def check_count(example, page):
    """Faults of one example against the page: too many files, a file that the page does not name."""
    heading, limit, _ = KINDS[example.kind]
    section = page.partition(f"\n## {heading}\n")[2].partition("\n## ")[0]
    faults = []
    if f"At most {limit} files." not in section:
        faults.append(f"CONTRIBUTING.md, {heading}: does not say 'At most {limit} files.'")
    touched = example.touched()
    if len(touched) > limit:
        faults.append(f"{example.name}: {len(touched)} files, at most {limit}: {', '.join(touched)}")
    patterns = [re.escape(path).replace("NAME", r"\w+") for path in re.findall(r"`([\w/.]+\.\w+)`", section)]
    for path in touched:
        if not any(re.fullmatch(pattern, path) for pattern in patterns):
            faults.append(f"{example.name}: CONTRIBUTING.md, {heading}, does not name {path}")
    return faults


def missing_paths(page, root):
    """Files that the page names and that are not there."""
    paths = set(re.findall(r"`([\w/.]+/[\w.]+\.\w+)`", page))
    return [path for path in sorted(paths) if "NAME" not in path and not (root / path).exists()]
