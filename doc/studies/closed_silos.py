"""Whether random closed silos find a state at rest, and in what time."""
import os
import statistics

import run_output
from plots import STYLE, plt, save
from runs import is_up_to_date, make
from silo_cases import KINDS, NAME, make_mesh, silo_run, silos
from tables import markdown, number

NOT_QUITE = "The state at rest is not quite one"


def make_runs():
    for silo in silos():
        if silo.has_insert and not silo.mesh_file.exists():
            make_mesh(silo)
        make_and_time(silo_run(silo))


def make_and_time(run):
    """One run after the other: then what children have used is its own time,
    which other work on the machine doesn't change much."""
    if is_up_to_date(run):
        return
    before = os.times().children_user
    make(run)
    seconds_file(run).write_text(str(os.times().children_user - before),
                                 encoding="utf-8")


def seconds_file(run):
    return run.directory / "seconds.txt"


def results():
    return [row_of(silo) for silo in silos()
            if run_output.has_ended(silo_run(silo).directory)]


def row_of(silo):
    run = silo_run(silo)
    directory = run.directory
    row = {"seed": silo.seed, "kind": silo.kind,
           "formulation": silo.formulation, "cell_type": silo.cell_type,
           "friction_angle": silo.friction_angle,
           "wall_friction_angle": silo.wall_friction_angle}
    has_failed = not (directory / "summary.json").exists()
    summary = {} if has_failed else run_output.read_summary(directory)
    log = (directory / "sandglass.log").read_text(encoding="utf-8")
    return {**row, "has_failed": has_failed, "is_not_quite": NOT_QUITE in log,
            "cells": summary.get("cells"),
            "newton_iterations": summary.get("static_newton_iterations"),
            "relaxation_steps": summary.get("static_relaxation_steps"),
            "seconds": None if has_failed
            else float(seconds_file(run).read_text(encoding="utf-8"))}


def share_of(kind, rows):
    own = [row for row in rows if kind in (row["kind"], "all")]
    found = [row for row in own if not row["has_failed"]]
    seconds = [row["seconds"] for row in found]
    return [kind, len(own), len(own) - len(found),
            sum(row["is_not_quite"] for row in own),
            sum(row["relaxation_steps"] > 0 for row in found),
            number(statistics.median(seconds), ".2f"),
            number(statistics.quantiles(seconds, n=10)[-1], ".1f"),
            number(max(seconds), ".1f")]


def kinds(rows):
    return markdown(["silo", "number", "failed", "not quite at rest",
                     "by relaxation too", "median, s", "nine tenths below, s",
                     "slowest, s"],
                    [share_of(kind, rows) for kind in (*KINDS, "all")])


def slowest(rows):
    found = sorted((row for row in rows if not row["has_failed"]),
                   key=lambda row: -row["seconds"])
    lines = []
    for row in found[:8]:
        lines.append([row["seed"], row["kind"], row["formulation"],
                      row["cell_type"], row["cells"],
                      f"{row['friction_angle']:.0f}°",
                      f"{row['wall_friction_angle']:.0f}°",
                      row["newton_iterations"], row["relaxation_steps"],
                      number(row["seconds"], ".1f")])
    return markdown(["seed", "silo", "formulation", "cells' type", "cells",
                     "φ", "φ_w", "Newton iterations", "relaxation steps",
                     "seconds"], lines)


def parts(rows):
    return {"kinds": kinds(rows), "slowest": slowest(rows)}


def draw(rows):
    """Time over the number of cells."""
    found = [row for row in rows if not row["has_failed"]]
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
        for title, color, is_relaxed in (
                ("Newton's method alone", "#1d3557", False),
                ("with relaxation", "#c9822a", True)):
            own = [row for row in found
                   if (row["relaxation_steps"] > 0) == is_relaxed]
            axes.loglog([row["cells"] for row in own],
                        [row["seconds"] for row in own], "o", markersize=3,
                        color=color, label=title)
        axes.set_xlabel("cells")
        axes.set_ylabel("processor's time, s")
        axes.legend(frameon=False)
        save(figure, NAME + ".png")
