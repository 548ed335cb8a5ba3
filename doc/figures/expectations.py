"""What the scenes of prm/paper say of their results in their first lines."""
import re
import sys
import textwrap

import run_output
from runs import paper_runs
from tables import summary_of

# A run's time differs from machine to machine.
ROUND_TIMES = (1, 2, 5, 10, 20, 30, 60, 120, 300, 600, 1200, 1800)  # s


def time_in_words(seconds):
    nearest = min(ROUND_TIMES, key=lambda time: abs(time / seconds - 1))
    number, unit = ((nearest, "second") if nearest < 60
                    else (nearest // 60, "minute"))
    return f"about a {unit}" if number == 1 else f"about {number} {unit}s"


def outcome(run, summary):
    emptied = run_output.discharge_time(run.directory)
    if emptied is not None:
        return f"empty after {emptied:.2g} s"
    left = summary["mass_in_silo_kg"] / summary["mass_initial_kg"]
    return (f"{100 * left:.0f} % of the material left after "
            f"{summary['end_time_s']:g} s")


def expectation(run, summary):
    unit = "kg/(s m)" if run.scene.startswith("plane") else "kg/s"
    seconds = run_output.seconds_of(summary, *run_output.RUN_PARTS)
    plateau = float(f"{summary['flow_rate_plateau_kg_per_s']:.3g}")
    return (f"Expect: about {plateau:g} {unit} on the plateau, "
            f"{outcome(run, summary)}; {time_in_words(seconds)} on one core.")


def write_expectations():
    """In the place of what the scenes say so far."""
    for run in paper_runs():
        summary = summary_of(run.directory)
        if summary is None or summary["status"] != "finished":
            print(f"{run.prm.name}: its run has not ended", file=sys.stderr)
            continue
        comment = textwrap.fill(expectation(run, summary), width=79,
                                initial_indent="# ", subsequent_indent="# ")
        before = run.prm.read_text(encoding="utf-8")
        after, n_replaced = re.subn(r"# Expect:[^;]*;[^;]*?\bcore\.", comment,
                                    before, count=1)
        if n_replaced == 0:
            raise SystemExit(f"{run.prm}: has no comment 'Expect: ...; ... on "
                             "one core.'")
        if after != before:
            run.prm.write_text(after, encoding="utf-8")
