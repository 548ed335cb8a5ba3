"""Laws beside exact solutions and other programs' tables: hoppers with Jenike's
radial stress field, silos with each cone, mu(I) and cohesion."""
import math

import numpy

import run_output
from conical_field import matsuoka_nakai, wall_stress
from material_cases import (ARRESTED, COHESIVE, COHESIVE_TIMES, CONES, CONICAL,
                            HOPPERS, HOURGLASS, HOURGLASS_TIMES, NAME,
                            PAPER_WEDGES, PLANE_WEDGES, PLUGS, REFINED, SILOS,
                            SEPARATING, SILO_FRICTIONS, WEIGHT, all_runs, cohesive_cases,
                            cohesive_run, hourglass_run, silo_cases, silo_run,
                            silo_times)
from outlet_sweep import mean_rate
from plots import STYLE, plt, save
from runs import make_all
from tables import markdown
from traction_tables import mean_along, rows_at

NEAR = 0.101  # cohesions that are near enough for a straight line
PLUG_PATH = (0.01, 0.15)  # displacements between which it falls evenly


def make_runs():
    make_all(all_runs())


def has_result(run):
    return (run_output.has_ended(run.directory) and
            run_output.read_summary(run.directory)["status"] == "finished")


def wall_rows(directory, wall, start):
    """The rows of a wall later than `start` as dictionaries."""
    table = run_output.read_table(directory, "wall_traction.csv")
    rows = (dict(zip(table, values)) for values in zip(*table.values()))
    return [row for row in rows
            if row["wall"] == wall and row["time_s"] > start + 1e-9]


def hopper_profile(hopper):
    """Radii over the outlet's and means over time of the normal traction over
    gamma r."""
    sine = math.sin(math.radians(hopper.half_angle))
    tractions = {}
    for row in wall_rows(hopper.run().directory, "hopper", hopper.times[0]):
        tractions.setdefault(round(row["x_m"], 6), []).append(row["normal_Pa"])
    xs = numpy.array(sorted(tractions))
    means = numpy.array([numpy.mean(tractions[x]) for x in xs])
    return xs / hopper.OUTLET, means * sine / (WEIGHT * xs)


def hopper_row(hopper):
    radii, stresses = hopper_profile(hopper)
    lower, upper = hopper.RADII
    chosen = (radii >= lower) & (radii <= upper)
    return {"case": hopper.name, "quantity": "wall stress",
            "value": stresses[chosen].mean(), "reference": hopper.field.wall}


def silo_rows(silo, cone, friction):
    start, end = silo_times(silo)
    directory = silo_run(silo, cone, friction).directory
    case = f"{silo}, {cone}, {friction}"
    yield {"case": case, "quantity": "rate", "reference": None,
           "value": mean_rate(run_output.read_table(directory, "flow_rate.csv"),
                              1., start, end)}
    for wall in ("wall", "hopper" if "hopper" in silo else "floor"):
        rows = [row for row in rows_at(directory, end) if row["wall"] == wall]
        yield {"case": case, "quantity": wall, "reference": None,
               "value": mean_along(rows, "normal_Pa")}


def rate_row(case, run, times, reference):
    table = run_output.read_table(run.directory, "flow_rate.csv")
    return {"case": case, "quantity": "rate",
            "value": mean_rate(table, 1., *times), "reference": reference}


def plug_row(plug, share):
    """Acceleration between two displacements, and the mean share of the
    cohesion times the length of contact."""
    history = run_output.read_table(plug.run(share).directory, "history.csv")
    times = numpy.array(history["time_s"])
    speeds = numpy.sqrt(2 * numpy.array(history["kinetic_energy_J"]) /
                        plug.mass)
    paths = numpy.concatenate([[0.], numpy.cumsum(
        numpy.diff(times) * (speeds[1:] + speeds[:-1]) / 2)])
    chosen = (paths >= PLUG_PATH[0]) & (paths <= PLUG_PATH[1])
    if chosen.sum() < 3:
        return {"case": f"{plug.formulation}, {share}",
                "quantity": "acceleration", "value": 0., "reference": None}
    slope = numpy.polyfit(times[chosen], speeds[chosen], 1)[0]
    return {"case": f"{plug.formulation}, {share}", "quantity": "acceleration",
            "value": slope,
            "reference": 1 - share * (1 - paths[chosen].mean())}


def results():
    rows = [hopper_row(hopper) for hopper in HOPPERS + SEPARATING
            if has_result(hopper.run())]
    for case in silo_cases():
        if has_result(silo_run(*case)):
            rows += silo_rows(*case)
    for outlet, reference in HOURGLASS.items():
        for refinement in (1, 2):
            run = hourglass_run(outlet, refinement)
            if has_result(run):
                rows.append(rate_row(f"hourglass, {outlet}, {refinement}", run,
                                     HOURGLASS_TIMES, reference))
    for slow, cohesion in cohesive_cases():
        run = cohesive_run(slow, cohesion)
        if has_result(run):
            rows.append(rate_row(f"cohesive, {slow}, {cohesion}", run,
                                 COHESIVE_TIMES, COHESIVE[slow][cohesion]))
    return rows + [plug_row(plug, share) for plug in PLUGS
                   for share in plug.SHARES if has_result(plug.run(share))]


def find(rows, case, quantity="rate"):
    return next((row for row in rows if row["case"] == case and
                 row["quantity"] == quantity), None)


def value(row, form):
    return "–" if row is None else format(row["value"], form)


def error(row):
    if row is None or not row["reference"]:
        return "–"
    return f"{100 * (row['value'] / row['reference'] - 1):+.1f}"


def hopper_table(rows, hoppers):
    lines = []
    for hopper in hoppers:
        row = find(rows, hopper.name, "wall stress")
        if row:
            lines.append([
                f"`{hopper.cone}`", f"{hopper.friction:.4g}°",
                f"{hopper.effective_friction:.2f}°",
                f"{hopper.half_angle:g}°", f"{hopper.wall_friction:g}°",
                f"{row['value']:.4f}", f"{row['reference']:.4f}", error(row)])
    return markdown(["`Yield cone`", "φ", "δ", "α", "φ_w", "σ_w/(γ r)",
                     "exact", "difference, %"], lines)


def wedges(rows):
    return hopper_table(rows, PAPER_WEDGES + PLANE_WEDGES)


def conical(rows):
    lines = []
    for hopper in CONICAL:
        row = find(rows, hopper.name, "wall stress")
        if row:
            own = wall_stress(
                matsuoka_nakai(math.sin(math.radians(hopper.friction))),
                hopper.half_angle, hopper.wall_friction)
            lines.append([f"{hopper.friction:g}°", f"{hopper.half_angle:g}°",
                          f"{hopper.wall_friction:g}°", f"{row['value']:.4f}",
                          f"{row['reference']:.4f}", f"{own:.4f}", error(row)])
    return markdown(["δ", "α", "φ_w", "σ_w/(γ r)", "Jenike", "its own field",
                     "difference to Jenike, %"], lines)


def separation(rows):
    return hopper_table(rows, SEPARATING)


def acting_angles(_):
    """Where each cone's angle acts, from the slopes of q over p."""
    lines = []
    for friction in SILO_FRICTIONS:
        sine = math.sin(math.radians(friction))
        slopes = {"plane strain": math.sqrt(3) * sine,
                  "compression": 6 * sine / (3 - sine),
                  "paper": 18 * sine / (9 - sine**2)}
        for cone in CONES:
            if cone == "Matsuoka-Nakai":
                # I1 I2 / I3 is the same where the middle stress is the mean.
                sines = (2 * sine / math.sqrt(3 + sine**2), sine, sine)
            else:
                m = slopes[cone]
                sines = (m / math.sqrt(3), 3 * m / (6 + m), 3 * m / (6 - m))
            lines.append([f"{friction}°", f"`{cone}`"] + [
                f"{math.degrees(math.asin(x)):.1f}°" for x in sines])
    return markdown(["φ typed", "`Yield cone`", "acts in plane flow",
                     "in compression", "in extension (converging cone)"],
                    lines)


def cones(rows):
    lines = []
    for silo, title in SILOS.items():
        bottom = "hopper" if "hopper" in silo else "floor"
        for friction in SILO_FRICTIONS:
            for cone in CONES:
                case = f"{silo}, {cone}, {friction}"
                cells = [find(rows, case, quantity)
                         for quantity in ("rate", "wall", bottom)]
                if None in cells:
                    continue
                rate, wall, floor = (cell["value"] for cell in cells)
                lines.append([title, f"{friction}°", f"`{cone}`",
                              f"{rate:.4g}", f"{wall / 1e3:.3g}",
                              f"{floor / 1e3:.3g}"])
    return markdown(["silo", "φ", "`Yield cone`", "rate, kg/(s m) or kg/s",
                     "wall, kPa", "floor or hopper, kPa"], lines)


def hourglass(rows):
    lines = []
    for outlet, reference in HOURGLASS.items():
        row, fine = (find(rows, f"hourglass, {outlet}, {refinement}")
                     for refinement in (1, 2))
        change = ("–" if None in (row, fine) else
                  f"{100 * (fine['value'] / row['value'] - 1):+.1f}")
        lines.append([f"{outlet:.3f}", f"{reference:.3f}", value(row, ".3f"),
                      error(row), value(fine, ".3f"), change])
    return markdown(["W", "Basilisk", "here", "difference, %",
                     "cells half as large", "change, %"], lines)


def cohesive(rows):
    lines = []
    for slow, cohesion in cohesive_cases():
        row = find(rows, f"cohesive, {slow}, {cohesion}")
        reference = COHESIVE[slow][cohesion]
        stopped = reference < ARRESTED
        lines.append([slow, cohesion, f"{slow + cohesion:.2f}",
                      f"{reference:.3f}" + (" (creep)" if stopped else ""),
                      value(row, ".3f"), "–" if stopped else error(row)])
    return markdown(["μ_s", "Co", "Co + μ_s", "Basilisk", "here",
                     "difference, %"], lines)


def arrest(rows):
    """Co + mu_s where the straight line through the two slowest flows is 0."""
    lines = []
    for slow, rates in COHESIVE.items():
        chosen = [cohesion for cohesion, rate in rates.items()
                  if rate > ARRESTED][-2:]
        found = [find(rows, f"cohesive, {slow}, {cohesion}")
                 for cohesion in chosen]
        if None in found or chosen[1] - chosen[0] > NEAR:
            continue

        def limit(first, second, chosen=chosen, slow=slow):
            return (slow + chosen[1] + second * (chosen[1] - chosen[0]) /
                    (first - second))
        theirs = limit(*(rates[cohesion] for cohesion in chosen))
        ours = limit(*(row["value"] for row in found))
        lines.append([slow, f"{chosen[0]:g}, {chosen[1]:g}", f"{theirs:.3f}",
                      f"{ours:.3f}", f"{ours - theirs:+.3f}"])
    return markdown(["μ_s", "from Co", "Basilisk, Co + μ_s", "here",
                     "difference"], lines)


def plug(rows):
    lines = []
    for silo in PLUGS:
        found = [(share, find(rows, f"{silo.formulation}, {share}",
                              "acceleration")) for share in silo.SHARES]
        found = [(share, row) for share, row in found if row]
        falling = [row for _, row in found if row["reference"]]
        limit = "–"
        if len(falling) > 1:
            # a = 1 - c / c_limit
            loads = [1 - row["reference"] for row in falling]
            slope, at_zero = numpy.polyfit(
                loads, [row["value"] for row in falling], 1)
            limit = f"{-at_zero / slope:.3f}"
        for share, row in found:
            expected = ("–" if not row["reference"]
                        else f"{row['reference']:.3f}")
            lines.append([silo.formulation, share, f"{row['value']:.3f}",
                          expected, limit])
    return markdown(["", "c over its limit", "acceleration over g",
                     "of a plug", "limit found over exact"], lines)


def summary(rows):
    chosen = [find(rows, hopper.name, "wall stress")
              for hopper in PAPER_WEDGES + PLANE_WEDGES]
    errors = [abs(row["value"] / row["reference"] - 1) for row in chosen
              if row]
    if not errors:
        return "not run"
    return (f"{sum(size <= 0.03 for size in errors)} of {len(errors)} are "
            f"within 3 %; the largest difference is {100 * max(errors):.1f} %.")


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (wedges, conical, separation, acting_angles, cones, hourglass,
                         cohesive, arrest, plug, summary)}


def draw(_):
    """Wall stress over the radius in wedges, beside the field's."""
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(layout="constrained", figsize=(6, 4))
        colors = ("#1d3557", "#4f8a8b", "#c9822a", "#9b2226")
        for color, hopper in zip(colors, PAPER_WEDGES):
            if has_result(hopper.run()):
                axes.plot(*hopper_profile(hopper), color=color, linewidth=1.2,
                          label=f"φ_w = {hopper.wall_friction:g}°")
                axes.axhline(hopper.field.wall, color=color, linestyle="--",
                             linewidth=0.9)
        axes.axvspan(*HOPPERS[0].RADII, color="#00000010")
        axes.set_xlabel("r over that of the outlet's edge")
        axes.set_ylabel("σ_w / (γ r)")
        axes.set_ylim(bottom=0)
        axes.legend(frameon=False)
        save(figure, NAME + ".png")
