"""docs/failures.md: the alarm for a lost hose of the damped bogie."""
from docfigures.list_alarms_nightly import told

DOCUMENT = "docs/failures.md"
PART = "alarms_damped."


def figures(phs):
    made = told(phs, "alarms_damped")
    return {key: made[key] for key in ("hoses", "false", "told")}
