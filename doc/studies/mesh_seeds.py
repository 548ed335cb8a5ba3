"""How far the results of mesh 3 depend on the mesh generator's algorithm and
random numbers."""
import run_output
from outlet_sweep import mean_rate
from plots import STYLE, plt, save
from runs import make_all
from run_out import run_out
from seed_cases import (ALGORITHMS, CASES, COLUMN_CASES, END_TIMES, NAME, cases,
                        make_column_meshes, runs, seed_run)
from sweep_cases import WINDOW, outlet_time
from tables import markdown, number
from traction_tables import mean_wall_force, wall_force
from work_cases import SILOS as WORK_SILOS

QUANTITIES = {
    "steady_flow_rate_kg_per_s": "steady flow rate, kg/(s m) or kg/s",
    "window_flow_rate_kg_per_s": "flow rate from 3 to 5 √(D/g), "
                                 "kg/(s m) or kg/s",
    "flow_rate_plateau_kg_per_s": "plateau, kg/(s m) or kg/s",
    "tenth_time_s": "time for a tenth of the material, s",
    "discharge_time_s": "discharge time, s",
    "wall_force_at_rest_N": "wall force at rest, N/m or N",
    "wall_force_in_flow_N": "wall force in flow, N/m or N",
    "run_out": "run-out over r₀",
}
ALGORITHM_COLORS = {"Frontal-Delaunay": "#1d3557", "Delaunay": "#c9822a"}


def make_runs():
    make_column_meshes()
    make_all(runs())


def results():
    return [row_of(*case) for case in cases()
            if run_output.has_ended(seed_run(*case).directory)]


def row_of(name, algorithm, seed):
    directory = seed_run(name, algorithm, seed).directory
    measured = ({"run_out": run_out(directory)} if name in COLUMN_CASES else
                of_silo(name, directory))
    return {"case": name, "algorithm": algorithm, "seed": seed,
            "cells": run_output.read_summary(directory)["cells"],
            **{quantity: measured.get(quantity) for quantity in QUANTITIES}}


def of_silo(silo, directory):
    summary = run_output.read_summary(directory)
    unit = outlet_time(WORK_SILOS[silo.split("-")[0]].outlet)
    return {
        "steady_flow_rate_kg_per_s": summary["steady_flow_rate_kg_per_s"],
        "window_flow_rate_kg_per_s": mean_rate(
            run_output.read_table(directory, "flow_rate.csv"), unit, *WINDOW),
        # The middle half of the discharged mass moves with the end.
        "flow_rate_plateau_kg_per_s":
            None if silo in END_TIMES
            else summary["flow_rate_plateau_kg_per_s"],
        "tenth_time_s": run_output.time_until(directory, 0.1),
        "discharge_time_s": (summary["discharge_time_s"]
                             if silo == "plane-hopper" else None),
        "wall_force_at_rest_N": wall_force(directory, 0),
        "wall_force_in_flow_N": mean_wall_force(
            directory, *(time * unit for time in WINDOW))}


def spread(values):
    """Largest less smallest over the mean."""
    return (max(values) - min(values)) / (sum(values) / len(values))


def values_of(rows, name, quantity, algorithms=ALGORITHMS):
    return [row[quantity] for row in rows if row["case"] == name and
            row["algorithm"] in algorithms and row[quantity] is not None]


def percent(values):
    return f"{100 * spread(values):.1f} %" if len(values) > 1 else "–"


def spreads(rows):
    lines = []
    for name, case in CASES.items():
        for quantity, title in QUANTITIES.items():
            values = values_of(rows, name, quantity)
            if values:
                lines.append(
                    [case, title, len(values),
                     number(sum(values) / len(values)),
                     *(percent(values_of(rows, name, quantity, (algorithm,)))
                       for algorithm in ALGORITHMS), percent(values)])
    return markdown(["case", "quantity", "meshes", "mean",
                     *(f"spread, {name}" for name in ALGORITHMS),
                     "spread, all"], lines)


def meshes(rows):
    lines = [[CASES[row["case"]], row["algorithm"], row["seed"],
              row["cells"], *(number(row[quantity])
                              for quantity in QUANTITIES)] for row in rows]
    return markdown(["case", "algorithm", "seed", "elements",
                     *QUANTITIES.values()], lines)


def parts(rows):
    return {"spreads": spreads(rows), "meshes": meshes(rows)}


def draw(rows):
    """Each mesh's result over the mean of its silo."""
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(2, 4, figsize=(13, 6), sharey=True,
                                      layout="constrained")
        for axes, (quantity, title) in zip(panels.flat, QUANTITIES.items()):
            draw_quantity(axes, rows, quantity)
            axes.set_title(title.split(",")[0], fontsize=11)
        for axes in panels[:, 0]:
            axes.set_ylabel("result over its mean")
        panels[1, 0].legend(*legend_of(panels[0, 0]), frameon=False)
        save(figure, NAME + ".png")


def legend_of(axes):
    """Each label once."""
    handles = dict(zip(*reversed(axes.get_legend_handles_labels())))
    return list(handles.values()), list(handles)


def draw_quantity(axes, rows, quantity):
    axes.axhspan(0.985, 1.015, color="#dddddd", linewidth=0)
    drawn = [name for name in CASES if values_of(rows, name, quantity)]
    for place, name in enumerate(drawn):
        values = values_of(rows, name, quantity)
        for i, algorithm in enumerate(ALGORITHMS):
            own = values_of(rows, name, quantity, (algorithm,))
            axes.plot(len(own) * [place + 0.2 * i - 0.1],
                      [len(values) * value / sum(values) for value in own],
                      "o", markersize=4, color=ALGORITHM_COLORS[algorithm],
                      label=algorithm)
    axes.set_xlim(-0.5, len(drawn) - 0.5)
    axes.set_xticks(range(len(drawn)),
                    [CASES[name].replace(", mesh 3", "").replace(
                        ", ", "\n").replace("axisymmetric", "axi-\nsymmetric")
                     for name in drawn], fontsize=6)
