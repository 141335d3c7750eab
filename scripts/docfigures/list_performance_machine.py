"""docs/performance.md: what benchmarks/run_table prints on this machine."""
import subprocess

from docfigures.runs import RunFailed

DOCUMENT = "docs/performance.md"


def figures(phs):
    build = phs.program.parent.parent.parent
    done = subprocess.run([str(phs.source / "benchmarks/run_table"), str(build), "40"], text=True,
                          capture_output=True, check=False)
    if done.returncode != 0:
        raise RunFailed(f"benchmarks/run_table: exit code {done.returncode}\n{done.stderr}")
    return {"table": "\n" + done.stdout.strip().replace("## ", "**", 1).replace("\n", "**\n", 1) + "\n"}
