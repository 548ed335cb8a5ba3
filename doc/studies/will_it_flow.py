"""Outlets that arch and conical hoppers with dead zones, beside Jenike's
limits."""
import run_output
from outlet_cases import (BOTTOMS, CELLS, CONES, FRICTIONS, NAME, REFINED,
                          WEIGHT, Arching, arching_cases, cones, refined_cases)
from closed_silos import make_and_time, seconds_file
from plots import STYLE, plt, save
from tables import markdown, number

FIRST, SECOND = 0.25, 0.5  # discharged shares of the material
ALL_MOVES = 0.005  # largest stagnant share of the material
TITLES = {0.: "flat", 20.: "hopper of 20°"}
COLORS = {25.: "#1d3557", 35.: "#c9822a"}
SHIFTS = {25.: 0., 35.: 0.004}  # of points in the picture, which hide others


def make_runs():
    for case in arching_cases() + cones() + refined_cases():
        make_and_time(case.run())


def summary_of(case):
    """Of a run or study that has come to its end, else None."""
    directory = case.run().directory
    if not run_output.has_ended(directory):
        return None
    summary = run_output.read_summary(directory)
    return summary if summary["status"] == "finished" else None


def seconds_of(case):
    return float(seconds_file(case.run()).read_text(encoding="utf-8"))


def arching_row(case):
    summary = summary_of(case) or {}
    return {"kind": "outlet", "angle": case.hopper_angle,
            "friction": case.friction, "cohesion_or_wall": case.cohesion,
            "cells": case.cells,
            "first": summary.get("largest_arrested_half_width_m"),
            "second": summary.get("smallest_flowing_half_width_m"),
            "jenike": summary.get("jenike_outlet_width_m"),
            "rathole": summary.get("jenike_rathole_diameter_m"),
            "seconds": seconds_of(case)}


def stagnant_share(case, discharged):
    """Of the initial mass, when this share of it has flowed out; None if it
    has not by the end."""
    history = run_output.read_table(case.run().directory, "history.csv")
    initial = history["mass_in_silo_kg"][0]
    for mass, stagnant in zip(history["mass_discharged_kg"],
                              history["stagnant_mass_kg"]):
        if mass >= discharged * initial:
            return stagnant / initial
    return None


def cone_row(case):
    is_there = summary_of(case) is not None
    return {"kind": "cone", "angle": case.half_angle,
            "friction": float(case.FRICTION),
            "cohesion_or_wall": case.wall_friction,
            "cells": None,
            "first": stagnant_share(case, FIRST) if is_there else None,
            "second": stagnant_share(case, SECOND) if is_there else None,
            "jenike": case.limit, "rathole": None,
            "seconds": seconds_of(case)}


def results():
    return [row_of(case) for cases, row_of in (
        (arching_cases() + refined_cases(), arching_row),
        (cones(), cone_row))
            for case in cases if run_output.has_ended(case.run().directory)]


def smallest(rows):
    lines = []
    for row in rows:
        if row["kind"] != "outlet":
            continue
        bounds = [row["first"], row["second"]]
        share = ("–" if limit(row) is None or not row["jenike"]
                 else f"{2 * limit(row) / row['jenike']:.2f}")
        lines.append([
            TITLES[row["angle"]], f"{row['friction']:g}°",
            f"{row['cohesion_or_wall']:g}", row["cells"],
            *(number(bound and 1e3 * bound, ".1f") for bound in bounds),
            number(row["jenike"] and 500 * row["jenike"], ".1f"), share,
            number(row["rathole"] and 500 * row["rathole"], ".1f"),
            f"{row['seconds']:.0f}"])
    return markdown(["bottom", "φ", "c, Pa", "cells", "stands at, mm",
                     "flows from, mm", "Jenike's arching, mm", "ours over it",
                     "Jenike's rathole, mm", "seconds"], lines)


def limit(row):
    """Half width between what stands and what flows, in m, or None."""
    bounds = [row["first"], row["second"]]
    return None if None in bounds else sum(bounds) / 2


def ratios(rows, is_counted=lambda row: row["cells"] == CELLS):
    """Of the limits found to Jenike's."""
    return [2 * limit(row) / row["jenike"] for row in rows
            if row["kind"] == "outlet" and is_counted(row) and
            limit(row) is not None]


def smallest_summary(rows):
    found = ratios(rows)
    if not found:
        return "not run"
    return (f"{len(found)} of {len(arching_cases())} limits were found; they "
            f"are {min(found):.2f} to {max(found):.2f} times Jenike's.")


def refined_ratios(rows):
    texts = []
    for bottom in BOTTOMS:
        found = ratios(rows, lambda row, bottom=bottom:
                       row["cells"] != CELLS and row["angle"] == bottom)
        if found:
            texts.append(f"{min(found):.2f} to {max(found):.2f} "
                         f"({TITLES[bottom]})")
    return " and ".join(texts) if texts else "–"


def refined_summary(rows):
    """Limits on finer squares over those on the usual ones."""
    texts = []
    keys = ("angle", "friction", "cohesion_or_wall")
    for bottom, cells in sorted({(bottom, cells)
                                 for bottom, _, cells in REFINED}):
        found = [limit(fine) / limit(row) for row in rows for fine in rows
                 if row["cells"] == CELLS and fine["cells"] == cells and
                 fine["angle"] == bottom and
                 all(row[key] == fine[key] for key in keys) and
                 None not in (limit(row), limit(fine))]
        if found:
            texts.append(f"{min(found):.2f} to {max(found):.2f} times as wide "
                         f"({TITLES[bottom]}, {cells} cells, {len(found)} "
                         "limits)")
    return ", ".join(texts) if texts else "not run"


def percent(share):
    return "–" if share is None else f"{100 * share:.1f}"


def verdict(row):
    """Whether all material moves."""
    return None if row["first"] is None else row["first"] <= ALL_MOVES


def mass_flow(rows):
    lines = []
    for row in rows:
        if row["kind"] != "cone":
            continue
        moves = verdict(row)
        lines.append([f"{row['cohesion_or_wall']:g}°", f"{row['jenike']:.1f}°",
                      f"{row['angle']:g}°",
                      "mass" if row["angle"] < row["jenike"] else "funnel",
                      percent(row["first"]), percent(row["second"]),
                      "–" if moves is None else "mass" if moves else "funnel",
                      f"{row['seconds']:.0f}"])
    return markdown(["φ_w", "Jenike's limit", "θ", "Jenike",
                     "stagnant after a quarter, %", "after half, %", "here",
                     "seconds"], lines)


def mass_flow_summary(rows):
    texts = []
    for wall in CONES:
        own = [row for row in rows if row["kind"] == "cone" and
               row["cohesion_or_wall"] == wall and verdict(row) is not None]
        moving = [row["angle"] for row in own if verdict(row)]
        dead = [row["angle"] for row in own if not verdict(row)]
        if moving and dead:
            texts.append(f"φ_w = {wall:g}°: all moves "
                         f"up to {max(moving):g}°, not from "
                         f"{min(dead):g}° on, Jenike "
                         f"{own[0]['jenike']:.1f}°")
    return "; ".join(texts) + "." if texts else "no limit was found"


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (smallest, smallest_summary, refined_summary,
                         refined_ratios, mass_flow, mass_flow_summary)}


def trials(case):
    """Pairs of the outlet's width over the silo's and whether it flows."""
    directory = case.run().directory
    if not (directory / "study.csv").exists():
        return []
    table = run_output.read_table(directory, "study.csv")
    return [(2 * half_width / case.WIDTH, flows) for half_width, flows in
            zip(table["outlet_half_width_m"], table["flows"])]


def draw_map(axes, bottom):
    load = WEIGHT * Arching.WIDTH
    for friction in FRICTIONS:
        color = COLORS[friction]
        cases = [case for case in arching_cases()
                 if (case.hopper_angle, case.friction) == (bottom, friction)]
        for case in cases:
            for width, flows in trials(case):
                axes.plot(width, case.cohesion / load + SHIFTS[friction], "o",
                          color=color, markersize=5,
                          markerfacecolor="none" if flows else color)
        widest = cases[-1].arching_width / Arching.WIDTH
        axes.plot([0, widest], [0, cases[-1].cohesion / load], "--",
                  color=color, linewidth=1, label=f"Jenike, φ = {friction:g}°")
    top = max(case.cohesion for case in arching_cases()) / load
    axes.plot([0, 2 * top], [0, top], ":", color="#666666", linewidth=1,
              label="a plug, φ = 0")
    axes.set_title(TITLES[bottom], fontsize=11)
    axes.set_xlabel("outlet's width over the silo's")
    axes.set_xlim(0, 1)
    axes.set_ylim(bottom=0)
    axes.legend(frameon=False, fontsize=8)


def draw(_):
    """Filled: stands; open: flows."""
    with plt.rc_context(STYLE):
        figure, row = plt.subplots(1, len(BOTTOMS), layout="constrained",
                                   figsize=(9, 4), sharey=True)
        for axes, bottom in zip(row, BOTTOMS):
            draw_map(axes, bottom)
        row[0].set_ylabel("c / (ρ g B), with the silo's width B")
        save(figure, NAME + ".png")
