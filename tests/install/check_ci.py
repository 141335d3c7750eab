#!/usr/bin/env python3
"""Runs the script lines of the CI files that are there to copy, as CI would: in a copy of the example, one
after the other, ending at the first that fails. Kept limits end with 0 and all artifacts; a limit that is
missed ends with 1, and the JUnit XML says so.

check_ci.py FOLDER PHS. Needs yaml (Debian: python3-yaml); exit code 77 without it."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

try:
    import yaml
except ImportError as error:
    print(f"left out: {error}")
    sys.exit(77)


def github(document):
    """Script lines and artifacts of all jobs."""
    steps = [step for job in document["jobs"].values() for step in job["steps"]]
    kept = [step["with"]["path"] for step in steps if "upload-artifact" in step.get("uses", "")]
    assert all(step["if"] == "always()" for step in steps if "upload-artifact" in step.get("uses", ""))
    return [step["run"] for step in steps if "run" in step], " ".join(kept).split()


def gitlab(document):
    jobs = [job for job in document.values() if "script" in job]
    artifacts = [job["artifacts"] for job in jobs]
    assert all(a["when"] == "always" for a in artifacts)
    return ([line for job in jobs for line in job["script"]],
            [path for a in artifacts for path in a["paths"] + a["reports"]["junit"]])


def run(lines, folder, phs):
    path = folder / "bin"
    path.mkdir()
    (path / "phs").symlink_to(phs)
    environment = dict(os.environ, PATH=f"{path}:{os.environ['PATH']}")
    for line in lines:
        done = subprocess.run(["sh", "-e", "-c", line], cwd=folder, env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            return done.returncode, done.stderr
    return 0, ""


def failures(file):
    return sum(int(suite.get("failures")) for suite in xml.etree.ElementTree.parse(file).iter("testsuite"))


def check(name, read, ci, phs):
    faults = []
    lines, artifacts = read(yaml.safe_load((ci / name).read_text()))
    if len(lines) < 2 or not artifacts:
        faults.append(f"{name}: found {len(lines)} script lines, artifacts {artifacts}")
    for missed in (False, True):
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch) / "project"
            shutil.copytree(ci / "example", folder)
            limits = folder / "modes_limits.yaml"
            if missed:
                limits.write_text(limits.read_text().replace("10e6", "1"))
            code, said = run(lines, folder, phs)
            if code != (1 if missed else 0):
                faults.append(f"{name}: ends with {code}, limit {'missed' if missed else 'kept'}: {said}")
            if missed and failures(folder / "junit_modes.xml") != 1:
                faults.append(f"{name}: the JUnit XML does not tell the miss")
            for artifact in artifacts:
                if not (folder / artifact).exists():
                    faults.append(f"{name}: {artifact} is kept but was not written")
    return faults


def main(ci, phs):
    ci = pathlib.Path(ci)
    faults = check("github.yml", github, ci, phs) + check("gitlab-ci.yml", gitlab, ci, phs)
    print("\n".join(faults) or "the CI files do what they say")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], pathlib.Path(sys.argv[2]).resolve()))
