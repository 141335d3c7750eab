"""Runs phs and keeps its answers."""
import csv
import hashlib
import json
import os
import shlex
import subprocess
import tempfile
from pathlib import Path


class RunFailed(Exception):
    pass


class Skipped(Exception):
    """The list cannot be made here, and why (data that are not shipped, say)."""


class Phs:
    """phs("compare curve_r550 …") gives the JSON that the command prints."""

    def __init__(self, program, source, keep):
        self.program = Path(program).resolve()
        self.source = Path(source)
        self.keep = Path(keep)
        self.keep.mkdir(parents=True, exist_ok=True)
        self.base = self._hash_of_program_and_data()

    def _hash_of_program_and_data(self):
        digest = hashlib.sha256(self.program.read_bytes())
        for folder in ("models", "bogie_xml"):
            for path in sorted((self.source / folder).rglob("*")):
                if path.is_file():
                    digest.update(str(path.relative_to(self.source)).encode())
                    digest.update(path.read_bytes())
        return digest

    def _kept(self, what):
        digest = self.base.copy()
        digest.update(what.encode())
        return self.keep / (digest.hexdigest()[:32] + ".txt")

    def _run(self, words, codes):
        done = subprocess.run([str(self.program)] + words, cwd=self.source, text=True,
                              capture_output=True, stdin=subprocess.DEVNULL, check=False)
        if done.returncode not in codes:
            raise RunFailed(f"phs {shlex.join(words)}: exit code {done.returncode}\n{done.stderr}")
        return done.stdout

    def _write(self, path, text):
        """Aside, then renamed: another list may want the same answer."""
        handle, aside = tempfile.mkstemp(dir=self.keep)
        with os.fdopen(handle, "w") as file:
            file.write(text)
        os.replace(aside, path)

    def __call__(self, command, codes=(0,)):
        """JSON that `phs COMMAND` prints. `codes`: exit codes that are no failure here."""
        kept = self._kept(command)
        if not kept.exists():
            words = shlex.split(command) + ["--format", "json", "--quiet"]
            self._write(kept, self._run(words, codes))
        return json.loads(kept.read_text())

    def result(self, command, name, codes=(0,)):
        """JSON of the file NAME in the result folder of `phs COMMAND`."""
        return json.loads(self.result_text(command, name, codes))

    def result_text(self, command, name, codes=(0,)):
        """Text of that file."""
        kept = self._kept(command + " > " + name)
        if not kept.exists():
            with tempfile.TemporaryDirectory(dir=self.keep) as folder:
                out = Path(folder) / "out"
                self._run(shlex.split(command) + ["--quiet", "--out", str(out)], codes)
                self._write(kept, (out / name).read_text())
        return kept.read_text()

    def text(self, command):
        """What `phs COMMAND --out FILE` prints, for verbs that write a file and say the rest."""
        kept = self._kept(command + " > text")
        if not kept.exists():
            with tempfile.TemporaryDirectory(dir=self.keep) as folder:
                words = shlex.split(command) + ["--out", str(Path(folder) / "out.csv")]
                self._write(kept, self._run(words, (0,)))
        return kept.read_text()

    def plain(self, command):
        """What `phs COMMAND` prints as it stands, for --help."""
        kept = self._kept(command + " > plain")
        if not kept.exists():
            self._write(kept, self._run(shlex.split(command), (0,)))
        return kept.read_text()

    def columns(self, command, name, wanted):
        """Columns of a CSV file in the result folder of `phs COMMAND`, as lists of numbers."""
        kept = self._kept(command + " > " + name + " " + " ".join(wanted))
        if not kept.exists():
            with tempfile.TemporaryDirectory(dir=self.keep) as folder:
                out = Path(folder) / "out"
                self._run(shlex.split(command) + ["--quiet", "--out", str(out)], (0,))
                with (out / name).open() as file:
                    rows = list(csv.DictReader(file))
            self._write(kept, json.dumps({c: [float(row[c]) for row in rows] for c in wanted}))
        return json.loads(kept.read_text())

    def file(self, content):
        """Path of a file with that content, named by its hash: text, or data as JSON, which is YAML."""
        text = content if isinstance(content, str) else json.dumps(content, indent=1) + "\n"
        path = self.keep / ("case_" + hashlib.sha256(text.encode()).hexdigest()[:16] + ".yaml")
        if not path.exists():
            self._write(path, text)
        return str(path)

    def shell(self, command):
        """Standard output of another program of this build."""
        kept = self._kept("$ " + command)
        if not kept.exists():
            done = subprocess.run(command, cwd=self.source, shell=True, text=True,
                                  capture_output=True, stdin=subprocess.DEVNULL, check=False)
            if done.returncode != 0:
                raise RunFailed(f"{command}: exit code {done.returncode}\n{done.stderr}")
            self._write(kept, done.stdout)
        return kept.read_text()
