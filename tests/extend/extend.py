#!/usr/bin/env python3
"""Adds every example of this folder to a copy of the sources as CONTRIBUTING.md says.

extend.py --count   files by hand of each example against the page; a second
extend.py BUILD     the copy in BUILD/tree: page by page written anew, built once with all examples, their tests and
                    runs
"""
import os
import pathlib
import shutil
import subprocess
import sys

sys.dont_write_bytecode = True

import examples  # noqa: E402

ROOT = examples.HERE.parents[1]
PARTS = ("CMakeLists.txt", "CMakePresets.json", "CONTRIBUTING.md", "README.md", "LICENSE", "NOTICE", "benchmarks",
         "bogie_xml", "docs", "models", "plugin", "python", "scripts", "src", "tests")
# Of the folders whose tests are built: those that hold tables and pages together.
TESTED = ("cli", "effects", "phs_model", "plugin", "rail", "vehicle")
KEPT = ("catalogue_test.cc", "energy_test.cc", "creep_laws_test.cc", "channels_test.cc", "elements_test.cc",
        "numbers_test.cc", "phs_models_doc_test.cc", "results_doc_test.cc", "program_test.cc")


def read_tree():
    """path -> bytes of all sources but the tests that nothing here needs."""
    tree = {}
    for part in PARTS:
        files = [ROOT / part] if (ROOT / part).is_file() else sorted((ROOT / part).rglob("*"))
        for file in files:
            path = file.relative_to(ROOT)
            if not file.is_file() or "__pycache__" in path.parts:
                continue
            test = path.parts[0] == "tests" and len(path.parts) == 3 and path.parts[1] in TESTED
            if test and path.name.endswith("_test.cc") and path.name not in KEPT:
                continue
            tree[str(path)] = file.read_bytes()
    return tree


def write_tree(tree, folder):
    """Files that say the same are left alone, so that a second run builds what changed."""
    for path, content in tree.items():
        file = folder / path
        if file.exists() and file.read_bytes() == content:
            continue
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(content)
        shutil.copymode(ROOT / path if (ROOT / path).exists() else ROOT / "CONTRIBUTING.md", file)
    for part in PARTS:
        for file in (folder / part).rglob("*"):
            if file.is_file() and "__pycache__" not in file.parts and str(file.relative_to(folder)) not in tree:
                file.unlink()


def count():
    page = (ROOT / "CONTRIBUTING.md").read_text()
    faults = [f"CONTRIBUTING.md names {path}, which is not there" for path in examples.missing_paths(page, ROOT)]
    tree, all_of = read_tree(), examples.all_examples()
    for kind, (_, limit, least) in examples.KINDS.items():
        of_kind = [example for example in all_of if example.kind == kind]
        if len(of_kind) < least:
            faults.append(f"{kind}: {len(of_kind)} examples, at least {least}")
        for example in of_kind:
            print(f"{example.name:32} {len(example.touched())} of at most {limit} files")
            faults += examples.check_count(example, page)
            examples.apply(example, dict(tree))  # each on its own
            examples.apply(example, tree)  # and all together
            if not (example.folder / "run").exists():
                faults.append(f"{example.name}: no run")
    return faults, tree


def call(command, folder, **environment):
    print("$", " ".join(map(str, command)), flush=True)
    subprocess.run(list(map(str, command)), cwd=folder, check=True, env={**os.environ, **environment})


def build(folder):
    made = folder / "build/release"
    if not (made / "build.ninja").exists():
        call(["cmake", "--preset", "release", "-DPHS_BENCHMARKS=OFF"], folder)
    call(["cmake", "--build", "--preset", "release", "--target", "phs", "phs_mujoco", *(f"test_{t}" for t in TESTED)],
         folder)
    return made


def write_pages(folder, made):
    call([made / "tests/test_phs_model", "--gtest_filter=PhsModelsDoc.*"], folder, PHS_WRITE_DOCS="1")
    call([made / "tests/test_vehicle", "--gtest_filter=ResultsDoc.*"], folder, PHS_WRITE_DOCS="1")
    call([sys.executable, "scripts/figures", "docs/program.md", "--phs", made / "src/cli/phs"], folder)


def run_tests(folder, made):
    """Tests that failed."""
    commands = [[made / f"tests/test_{test}", "--gtest_brief=1"] for test in TESTED if test != "cli"]
    commands += [[made / "tests/test_cli", "--gtest_brief=1", "--gtest_filter=*EveryVerbHasARow*:Verb*"],
                 ["bash", "tests/layers/check_includes.sh", "."], ["python3", "tests/layers/check_chains.py", "."]]
    failed = []
    for command in commands:
        try:
            call(command, folder)
        except subprocess.CalledProcessError:
            failed.append(f"failed: {' '.join(map(str, command))}")
    return failed


def run_examples(folder, made):
    failed = []
    for example in examples.all_examples():
        place = folder.parent / "runs" / example.name
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir(parents=True)
        print(f"--- {example.name}", flush=True)
        environment = {**os.environ, "PHS": str(made / "src/cli/phs"), "PYTHON": sys.executable, "SOURCE": str(folder),
                       "EXAMPLES": str(examples.HERE)}
        shell = ["bash", "-euo", "pipefail", str(example.folder / "run")]
        if subprocess.run(shell, cwd=place, env=environment).returncode != 0:
            failed.append(f"{example.name}: its run failed")
    return failed


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    faults, tree = count()
    if not faults and sys.argv[1] != "--count":
        folder = pathlib.Path(sys.argv[1]).resolve() / "tree"
        write_tree(tree, folder)
        made = build(folder)
        write_pages(folder, made)
        faults = run_tests(folder, made) + run_examples(folder, made)
    for fault in faults:
        print(fault, file=sys.stderr)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
