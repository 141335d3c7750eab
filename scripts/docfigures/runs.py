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
        kept = self._kept(command + " > " + name)
        if not kept.exists():
            with tempfile.TemporaryDirectory(dir=self.keep) as folder:
                out = Path(folder) / "out"
                self._run(shlex.split(command) + ["--quiet", "--out", str(out)], codes)
                self._write(kept, (out / name).read_text())
        return json.loads(kept.read_text())

    def table(self, command):
        """Rows of the CSV file that `phs COMMAND --out FILE` writes, as dictionaries of text."""
        kept = self._kept(command + " > csv")
        if not kept.exists():
            with tempfile.TemporaryDirectory(dir=self.keep) as folder:
                out = Path(folder) / "out.csv"
                self._run(shlex.split(command) + ["--out", str(out)], (0,))
                self._write(kept, out.read_text())
        with kept.open() as file:
            return list(csv.DictReader(file))

    def file(self, content):
        """Path of a file with that content (JSON, which is YAML too), named by its hash."""
        text = json.dumps(content, indent=1, sort_keys=True) + "\n"
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
