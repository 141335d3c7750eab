#!/usr/bin/env python3
"""Runs the script lines of the CI files that are there to copy, as CI would: in a copy of the example. Kept
limits end with 0 and all artifacts; a limit that is missed, of the curve or of the modes, ends with 1 and all
artifacts, and the JUnit XML says so.

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
    """Scripts, whether each runs after a failure too, and artifacts, of all jobs."""
    steps = [step for job in document["jobs"].values() for step in job["steps"]]
    kept = [step["with"]["path"] for step in steps if "upload-artifact" in step.get("uses", "")]
    assert all(step["if"] == "always()" for step in steps if "upload-artifact" in step.get("uses", ""))
    scripts = [(step["run"], step.get("if") == "always()") for step in steps if "run" in step]
    return scripts, " ".join(kept).split()


def gitlab(document):
    jobs = [job for job in document.values() if "script" in job]
    artifacts = [job["artifacts"] for job in jobs]
    assert all(a["when"] == "always" for a in artifacts)
    return ([("\n".join(job["script"]), False) for job in jobs],
            [path for a in artifacts for path in a["paths"] + a["reports"]["junit"]])


def run(scripts, folder, phs):
    path = folder / "bin"
    path.mkdir()
    (path / "phs").symlink_to(phs)
    environment = dict(os.environ, PATH=f"{path}:{os.environ['PATH']}")
    code, said = 0, ""
    for script, always in scripts:
        if code != 0 and not always:
            continue
        done = subprocess.run(["sh", "-e", "-c", script], cwd=folder, env=environment,
                              stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        code, said = code or done.returncode, said + done.stderr
    return code, said


def failures(file):
    return sum(int(suite.get("failures")) for suite in xml.etree.ElementTree.parse(file).iter("testsuite"))


def check(name, read, ci, phs):
    faults = []
    scripts, artifacts = read(yaml.safe_load((ci / name).read_text()))
    if sum(script.count("phs ") for script, _ in scripts) < 2 or not artifacts:
        faults.append(f"{name}: found {scripts}, artifacts {artifacts}")
    # Which limit is missed, and the number that makes it so.
    misses = {"": None, "modes": ("modes_limits.yaml", "10e6", "1"), "curve": ("limits.yaml", "0.8", "1e-3")}
    for missed, change in misses.items():
        with tempfile.TemporaryDirectory() as scratch:
            folder = pathlib.Path(scratch) / "project"
            shutil.copytree(ci / "example", folder)
            if change:
                limits = folder / change[0]
                limits.write_text(limits.read_text().replace(change[1], change[2]))
            code, said = run(scripts, folder, phs)
            if code != (1 if missed else 0):
                faults.append(f"{name}: ends with {code}, missed: {missed or 'none'}: {said}")
            if missed and not failures(folder / f"junit_{missed}.xml"):
                faults.append(f"{name}: the JUnit XML does not tell the miss of the {missed}")
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
