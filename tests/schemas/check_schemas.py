#!/usr/bin/env python3
"""JSON schemas and readers say the same: every shipped YAML file passes the schema that it names, the
schemas in models/schemas are those of the program, and a misspelt key, a number out of range and a wrong
word are refused by the schema and by the reader.

check_schemas.py ROOT PHS. Needs jsonschema and yaml (Debian: python3-jsonschema, python3-yaml);
exit code 77 without them."""
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(f"left out: {error}")
    sys.exit(77)

MODELINE = re.compile(r"# yaml-language-server: \$schema=(\S+)\n")
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
# Which schema the files of a folder name.
FOLDERS = {"scenarios": "scenario", "tracks": "track", "phs": "phs", "rigs": "rig", "sweeps": "study",
           "studies": "design_study",
           "urdf": "mapping", "reference": "known_misses"}


class Core(yaml.SafeLoader):
    """YAML 1.2 as editors read it: 1e4 is a number, `no` and `on` are words."""


Core.yaml_implicit_resolvers = {}
for pattern, tag, first in [(r"true|false", "bool", "tf"), (r"~|null|", "null", ["~", "n", ""]),
                            (r"[-+]?\d+", "int", "-+0123456789"),
                            (r"[-+]?(\.\d+|\d+(\.\d*)?)([eE][-+]?\d+)?", "float", "-+.0123456789")]:
    Core.add_implicit_resolver(f"tag:yaml.org,2002:{tag}", re.compile(f"^(?:{pattern})$"), list(first))
Core.add_constructor("tag:yaml.org,2002:float", lambda loader, node: float(node.value))
Core.add_constructor("tag:yaml.org,2002:int", lambda loader, node: int(node.value))


class Check:
    def __init__(self, root, phs):
        self.root, self.phs, self.faults = root, phs, []
        self.schemas = {}

    def fault(self, text):
        self.faults.append(text)

    def ask(self, *words):
        return subprocess.run([self.phs, *words], capture_output=True, text=True)

    def errors(self, kind, text):
        return [f"{'.'.join(map(str, e.absolute_path))}: {e.message[:200]}"
                for e in jsonschema.Draft7Validator(self.schemas[kind]).iter_errors(yaml.load(text, Core))]

    def made_by_program(self):
        for file in sorted((self.root / "models/schemas").glob("*.json")):
            made = self.ask("schema", file.stem)
            if made.stdout != file.read_text():
                self.fault(f"{file.name} is not what `phs schema {file.stem}` prints; scripts/write_pages")
            self.schemas[file.stem] = json.loads(made.stdout or "{}")
            jsonschema.Draft7Validator.check_schema(self.schemas[file.stem])

    def shipped(self):
        count = 0
        for file in sorted((self.root / "models").rglob("*.yaml")):
            name, text = file.relative_to(self.root), file.read_text()
            line = MODELINE.match(text)
            if not line:
                self.fault(f"{name} names no schema in its first line")
                continue
            schema = (file.parent / line.group(1)).resolve()
            if schema.parent != self.root / "models/schemas" or schema.stem not in self.schemas:
                self.fault(f"{name} names {schema}, which is not there")
                continue
            expected = FOLDERS.get(file.parent.name)
            if expected and expected != schema.stem:
                self.fault(f"{name} names the schema of a {schema.stem}")
            count += 1
            for error in self.errors(schema.stem, text):
                self.fault(f"{name}: the schema refuses what ships: {error}")
        return count

    def scenario_page(self):
        """docs/scenarios.md: every key that is read has its row; range and default there are those of the reader."""
        rows = {}
        for line in (self.root / "docs/scenarios.md").read_text().splitlines():
            cells = [cell.strip() for cell in line.split(" | ")]
            if line.startswith("| `") and len(cells) == 4:
                for key in re.findall(r"`(\w+)", cells[0]):
                    rows.setdefault(key, cells)
        read = self.schemas["scenario"]["properties"]
        for key in sorted(read.keys() - rows.keys()):
            self.fault(f"docs/scenarios.md has no row for {key}")
        for key in read.keys() & rows.keys():
            _, unit, default, _ = rows[key]
            # Keys of one row share its cell: speed_km_h and speed_m_s.
            row = [read[other] for other in read if rows.get(other) is rows[key]]
            alternatives = row + [one for other in row for one in other.get("anyOf", [])]
            bounds = {float(one[name]) for one in alternatives for name in
                      ("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum") if name in one}
            said = {float(number) for number in NUMBER.findall(unit)}
            if not said <= bounds:
                self.fault(f"docs/scenarios.md, {key}: the page says {unit}, the reader {sorted(bounds)}")
            value = read[key].get("default")
            word = f"{value:g}" if isinstance(value, float) else str(value)
            if value is not None and word not in default:
                self.fault(f"docs/scenarios.md, {key}: the page says {default}, the reader {word}")

    def refused_alike(self):
        """(kind, what is read by, good text, changes that both must refuse)."""
        scenario = "track: straight\nspeed_km_h: 60\nduration_s: 0.02\n"
        track = ("gauge_m: 1.067\nsegments:\n  - {kind: tangent, length_m: 100}\n"
                 "  - {kind: transition, length_m: 50}\n"
                 "  - {kind: curve, hand: left, radius_m: 300, length_m: 100}\n"
                 "  - {kind: transition, length_m: 60}\n  - {kind: tangent, length_m: 40}\n")
        rig = ("rig: quarter\nmodel: quarter_setup2\nsignal:\n  duration_s: 1\n"
               "  actuator_m: {kind: sine, amplitude_m: 1e-3, frequency_Hz: 1}\n")
        limits = "limits:\n  - {quantity: run.steps, at_least: 1}\n"
        phs = (self.root / "models/phs/quarter_setup2.yaml").read_text()
        study = ("scenario: scenario.yaml\ndesign: grid\naxes:\n"
                 "  - {key: scenario.speed_km_h, values: [50]}\n")
        cases = [
            ("scenario", ["simulate", "FILE", "--quiet"], scenario,
             [("speed_km_h", "sped_km_h"), ("60", "600"), ("duration_s", "duration"),
              ("track: straight\n", "track: straight\nvehicle: tram\n"),
              ("track: straight\n", "track: straight\nrunning: {drive_torque_nm: 1}\n"),
              ("track: straight\n", "track: straight\neffects: {piston_leakag: {}}\n")]),
            ("limits", ["simulate", "SCENARIO", "--quiet", "--check", "FILE"], limits,
             [("quantity", "quantiti"), ("at_least", "atleast")]),
            ("rig", ["rig", "FILE", "--quiet", "--out", "OUT"], rig,
             [("amplitude_m", "amplitud_m"), ("sine", "sinus"), ("model", "modell"),
              ("duration_s: 1", "duration_s: -1")]),
            ("phs", ["rig", "RIG", "--quiet", "--out", "OUT"], phs,
             [("bulk_modulus_Pa", "bulk_modulus"), ("bore_m: 0.100", "bore_m: 100"),
              ("law: isothermal", "law: isotermal")]),
            ("track", ["simulate", "ONTRACK", "--quiet"], track,
             [("gauge_m", "gage_m"), ("radius_m: 300", "radius_m: 3"), ("hand: left", "hand: links"),
              ("length_m: 50", "lenght_m: 50")]),
            ("study", ["sweep", "FILE", "--quiet", "--workers", "1", "--out", "OUT"], study,
             [("design: grid", "design: gird"), ("axes", "axis"), ("values", "value")]),
        ]
        with tempfile.TemporaryDirectory() as folder:
            folder = pathlib.Path(folder)
            (folder / "scenario.yaml").write_text(scenario)
            (folder / "rig.yaml").write_text(rig.replace("quarter_setup2", "file.yaml"))
            (folder / "ontrack.yaml").write_text(scenario.replace("straight", "file.yaml"))
            places = {"FILE": folder / "file.yaml", "SCENARIO": folder / "scenario.yaml",
                      "RIG": folder / "rig.yaml", "ONTRACK": folder / "ontrack.yaml"}
            for kind, words, good, changes in cases:
                for number, (before, after) in enumerate([("", "")] + changes):
                    text = good.replace(before, after, 1) if before else good
                    places["OUT"] = folder / f"out_{kind}_{number}"
                    (folder / "file.yaml").write_text(text)
                    run = self.ask(*[str(places.get(word, word)) for word in words])
                    refused = run.returncode == 3
                    errors = self.errors(kind, text)
                    if refused != bool(before):
                        self.fault(f"{kind}, '{after}': the reader ends with {run.returncode}: {run.stderr}")
                    if bool(errors) != bool(before):
                        self.fault(f"{kind}, '{after}': the schema says {errors or 'nothing'}")


def main(root, phs):
    check = Check(pathlib.Path(root).resolve(), phs)
    check.made_by_program()
    count = check.shipped()
    check.scenario_page()
    check.refused_alike()
    print("\n".join(check.faults) or f"{count} files, {len(check.schemas)} schemas: readers say the same")
    return 1 if check.faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
