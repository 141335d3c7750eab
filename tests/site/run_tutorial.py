#!/usr/bin/env python3
"""Follows a tutorial word by word, in an empty folder: files as given, commands as given, and what they print.

run_tutorial.py PAGE.md --phs PROGRAM [--python FOLDER] [--slurm TOOL] [--write]
  ```sh                     commands; exit code 0, or N where `title="exit code N"` says so
  ```yaml title="a.yaml"    a file, written as it stands; also xml, python, csv
  ```text                   what the command before printed: these lines in this order, others between them. A number
                            may differ by one in its last digit; `…` stands for anything
  ```sh title="on the cluster"   needs Slurm: without --slurm, or where it cannot be started, left out
--write puts the numbers of this run into the page. Exit code 77: the part for Slurm was left out.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import tempfile

BLOCK = re.compile(r"^```(\w+)(?: title=\"([^\"]*)\")?\n(.*?)^```$", re.S | re.M)
NUMBER = re.compile(r"(?<![\w.])[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
ON_CLUSTER = "on the cluster"


def same(expected, line):
    """The same words; numbers within one of the last digit that the page gives."""
    parts = [re.escape(part).replace(r"\ ", " ") for part in NUMBER.split(expected)]
    pattern = "(" + NUMBER.pattern + ")"
    words = pattern.join(re.sub(r" +", r"\\s+", part).replace("…", ".*") for part in parts)
    found = re.fullmatch(words + r"\s*", line)
    if not found:
        return None
    numbers = NUMBER.findall(expected)
    return all(close(a, b) for a, b in zip(numbers, found.groups()))


def close(a, b):
    a, b = a.replace("−", "-"), b.replace("−", "-")
    mantissa, _, exponent = a.partition("e")
    digits = len(mantissa.partition(".")[2])
    unit = 10.0 ** (int(exponent or 0) - digits)
    return abs(float(a) - float(b)) <= 1.01 * unit or a == b


def find(expected, printed):
    """[(expected line, printed line or None, numbers agree)]"""
    at, found = 0, []
    for line in expected:
        if not line.strip() or line.strip() == "…":
            continue
        words_only = None
        for i in range(at, len(printed)):
            verdict = same(line, printed[i])
            if verdict is not None:
                words_only = i if words_only is None else words_only
            if verdict:
                words_only = i
                break
        if words_only is None:
            found.append((line, None, False))
        else:
            found.append((line, printed[words_only], bool(same(line, printed[words_only]))))
            at = words_only + 1
    return found


class Tutorial:
    def __init__(self, page, environment, folder, slurm):
        self.page, self.environment, self.folder, self.slurm = page, environment, folder, slurm
        self.text = page.read_text(encoding="utf-8")
        self.new = self.text
        self.faults, self.printed = [], []
        self.commands, self.left_out = 0, False

    def follow(self):
        for block in BLOCK.finditer(self.text):
            language, title, body = block.groups()
            line = self.text[:block.start()].count("\n") + 1
            if language == "sh":
                self.run(body, title or "", line)
            elif language == "text":
                self.compare(body, line)
            elif title:
                file = self.folder / title
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(body, encoding="utf-8")

    def run(self, body, title, line):
        if title == ON_CLUSTER and not self.slurm:
            self.left_out, self.printed = True, None
            return
        wanted = int(title.split()[-1]) if title.startswith("exit code") else 0
        done = subprocess.run(["bash", "-e", "-c", body], cwd=self.folder, env=self.environment, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=500, check=False)
        self.printed = done.stdout.splitlines()
        self.commands += 1
        if done.returncode != wanted:
            self.faults.append(f"{self.page.name}:{line}: exit code {done.returncode}\n{done.stdout}")

    def compare(self, body, line):
        if self.printed is None:
            return
        for expected, printed, agree in find(body.splitlines(), self.printed):
            if printed is None:
                self.faults.append(f"{self.page.name}:{line}: not printed: {expected}")
            elif not agree:
                self.faults.append(f"{self.page.name}:{line}: the page says\n  {expected}\nprinted is\n  {printed}")
                if "…" not in expected:
                    self.new = self.new.replace(expected, printed.rstrip())


def main():
    ask = argparse.ArgumentParser()
    ask.add_argument("page", type=pathlib.Path)
    ask.add_argument("--phs", type=pathlib.Path, required=True)
    ask.add_argument("--python", default="")
    ask.add_argument("--slurm", default="")
    ask.add_argument("--write", action="store_true")
    asked = ask.parse_args()
    environment = {**os.environ, "PATH": f"{asked.phs.resolve().parent}:/usr/bin:/bin:/usr/sbin", "MPLBACKEND": "Agg",
                   "PYTHONPATH": asked.python, "PYTHONDONTWRITEBYTECODE": "1"}
    # Sockets of Slurm need short paths.
    with tempfile.TemporaryDirectory(prefix="phs_") as scratch:
        node = pathlib.Path(scratch) / "slurm"
        wants_slurm = ON_CLUSTER in asked.page.read_text(encoding="utf-8")
        slurm = asked.slurm and wants_slurm and start(asked.slurm, node, environment)
        try:
            folder = pathlib.Path(scratch) / "tutorial"
            folder.mkdir()
            tutorial = Tutorial(asked.page, environment, folder, slurm)
            tutorial.follow()
        finally:
            if slurm:
                subprocess.run([asked.slurm, "stop", node], check=False)
    if asked.write:
        asked.page.write_text(tutorial.new, encoding="utf-8")
    print("\n".join(tutorial.faults + [f"{tutorial.commands} blocks of commands, {len(tutorial.faults)} faults"]))
    if tutorial.faults or tutorial.commands == 0:
        return 1
    return 77 if tutorial.left_out else 0


def start(tool, node, environment):
    node.mkdir()
    started = subprocess.run([tool, "start", node, str(os.getpid())], text=True, capture_output=True, check=False)
    if started.returncode == 77:
        print(started.stdout)
        return False
    started.check_returncode()
    name, value = started.stdout.splitlines()[0].split("=", 1)
    environment[name] = value
    return True


if __name__ == "__main__":
    sys.exit(main())
