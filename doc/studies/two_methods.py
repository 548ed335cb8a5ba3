"""Both flow methods under refinement: the silo of Section 5.3, whose walls are
smooth, and the flat bottom with rough walls."""
from typing import NamedTuple

import run_output
from plots import STYLE, plt, save
from runs import make_all
from study_runs import WITHOUT_FIELDS, study_run
from tables import markdown, number, outcome
from traction_tables import mean_wall_force

NAME = "two-methods"
ELEMENTS = "finite elements"
PARTICLES = "particles"
PAPER = "particles, as in the paper"
# When energies and forces are compared: from then, until then, in s; and the
# wall below the vertical one.
SILOS = {"section-5.3": (1.0, 3.0, "hopper"),
         "flat-bottom": (0.5, 1.0, "floor")}


class Case(NamedTuple):
    silo: str
    method: str
    element: float  # m

    @property
    def run(self):
        return study_run(NAME, f"{self.silo}-{self.method}-{self.element:g}"
                         .replace(", ", "-").replace(" ", "-"),
                         self.scene, self.settings, WITHOUT_FIELDS)

    @property
    def scene(self):
        if self.silo == "section-5.3":
            return ("plane-section-5.3-updated-lagrangian"
                    if self.method == ELEMENTS else "plane-section-5.3-auto")
        return "plane-flat-bottom-mesh-1-auto"

    @property
    def settings(self):
        own = {
            ELEMENTS: (("Flow/Method", "updated Lagrangian"),
                       ("Walls/Outlet lip", "floor"),
                       ("Updated Lagrangian stage/Time step",
                        f"{0.05 * self.element:g}")),
            PARTICLES: (),
            PAPER: (("Walls/Outlet lip", "floor"),
                    ("Particle stage/Volumetric strain", "element"),
                    ("Particle stage/Force integration", "particles")),
        }[self.method]
        return (("Scene/Element size", self.element),
                ("Output/Interval", 0.25)) + own


CASES = ([Case("section-5.3", ELEMENTS, size) for size in (0.4, 0.2, 0.1)] +
         [Case("section-5.3", method, size)
          for method in (PARTICLES, PAPER) for size in (0.2, 0.1, 0.05)] +
         [Case("flat-bottom", ELEMENTS, size) for size in (0.2, 0.1, 0.05)] +
         [Case("flat-bottom", method, size)
          for method in (PARTICLES, PAPER) for size in (0.1, 0.05, 0.025)])


def make_runs():
    make_all([case.run for case in reversed(CASES)])


def results():
    return [row_of(case) for case in CASES
            if run_output.has_ended(case.run.directory)]


def value_at(directory, table, column, time):
    """In the first row not before a time; None if there is none."""
    columns = run_output.read_table(directory, table)
    return next((value for at, value in zip(columns["time_s"], columns[column])
                 if at >= time - 1e-6), None)


def row_of(case):
    directory = case.run.directory
    summary = run_output.read_summary(directory)
    start, end, bottom = SILOS[case.silo]
    if summary["end_time_s"] < end:  # broke down before
        forces = {}
    else:
        forces = {wall: mean_wall_force(directory, start, end, wall)
                  for wall in ("wall", bottom)}
    return {"silo": case.silo, "method": case.method, "element_m": case.element,
            "cells": summary["cells"],
            "plateau_kg_per_s": summary["flow_rate_plateau_kg_per_s"],
            "empty_after_s": run_output.discharge_time(directory),
            "share_left": summary["mass_in_silo_kg"] /
            summary["mass_initial_kg"],
            "kinetic_energy_J": value_at(directory, "history.csv",
                                         "kinetic_energy_J", end),
            "dissipated_energy_J": value_at(directory, "history.csv",
                                            "dissipated_energy_J", end),
            "wall_force_N": forces.get("wall"),
            "bottom_force_N": forces.get(bottom),
            "mass_balance_error": summary["mass_balance_error"],
            "loop_seconds": summary["loop_seconds"],
            "outcome": outcome(summary)}


def table(rows, silo, last_head, last):
    return markdown(
        ["method", "element, m", "plateau, kg/(s m)", last_head,
         "kinetic energy, J/m", "dissipated, kJ/m", "on the wall, kN/m",
         f"on the {SILOS[silo][2]}, kN/m", "seconds", "outcome"],
        [[row["method"], f"{row['element_m']:g}",
          number(row["plateau_kg_per_s"]), last(row),
          number(row["kinetic_energy_J"], ".3g"),
          number(scaled(row["dissipated_energy_J"]), ".4g"),
          number(scaled(row["wall_force_N"]), ".4g"),
          number(scaled(row["bottom_force_N"]), ".4g"),
          number(row["loop_seconds"], ".2g"), row["outcome"]]
         for row in rows if row["silo"] == silo])


def scaled(value):
    return None if value is None else value / 1e3


def smooth(rows):
    return table(rows, "section-5.3", "empty after, s",
                 lambda row: number(row["empty_after_s"], ".3g"))


def rough(rows):
    return table(rows, "flat-bottom", "left at the end",
                 lambda row: number(row["share_left"], ".3f"))


def parts(rows):
    return {part.__name__: part(rows) for part in (smooth, rough)}


def draw(rows):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, len(SILOS), figsize=(9, 3.2),
                                      layout="constrained")
        for axes, silo in zip(panels, SILOS):
            for method, colour in ((ELEMENTS, "#c1121f"),
                                   (PARTICLES, "#1d3557"),
                                   (PAPER, "#8d99ae")):
                chosen = [row for row in rows if row["silo"] == silo and
                          row["method"] == method and
                          row["outcome"] == "finished"]
                axes.plot([row["element_m"] for row in chosen],
                          [row["plateau_kg_per_s"] for row in chosen], "o-",
                          color=colour, linewidth=1.2, markersize=4,
                          label=method)
            axes.set_xlim(left=0)
            axes.set_ylim(bottom=0)
            axes.set_xlabel("element, m")
            axes.set_title(f"{silo}: plateau, kg/(s m)", fontsize=11)
        panels[0].legend(frameon=False, fontsize=9)
        save(figure, NAME + ".png")
