"""docs/identify_examples.md: EMPS; needs its data, which are not shipped (PHS_EMPS_DIR)."""
import os

from docfigures.form import number
from docfigures.runs import Skipped

DOCUMENT = "docs/identify_examples.md"
PART = "emps."


def figures(phs):
    if not os.environ.get("PHS_EMPS_DIR"):
        raise Skipped("PHS_EMPS_DIR does not name the folder of the data")
    r = phs.result("identify models/rigs/emps.yaml", "result.json")
    fit, test = r["channels_estimation"]["force_N"], r["channels"]["force_N"]

    def percent(score):
        return number(score["relative_percent"], 3) + " %"

    effects = {e["name"]: e for e in r["effects"]}
    asymmetric = next(iter(effects["asymmetric_friction"]["parameters"].items()))
    viscous = effects["asymmetric_friction"]["parameters"].get("viscous_Ns_per_m", asymmetric[1])
    return {
        "declared_fit": percent(fit["before"]), "declared_test": percent(test["before"]),
        "fit": percent(fit["after"]), "test": percent(test["after"]),
        "order": ", ".join(f"`{e['name']}`" for e in r["effects"]),
        "asymmetry": f"{number(viscous['value'], 1)} N s/m [{number(viscous['low'], 1)}, "
                     f"{number(viscous['high'], 1)}]",
        "mass": f"{number(r['fitted']['element.mass_kg']['value'], 2)} kg",
        "formula": "`" + (effects.get("unlisted", {}).get("formula") or "none") + "`",
    }
