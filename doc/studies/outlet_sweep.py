"""The flow rate W over the outlet's width D, and the fit W = A (D - k h)^n with
the element size h."""
import math
from typing import NamedTuple

import numpy
from scipy.optimize import least_squares
from scipy.stats import t as student

import run_output
from plots import STYLE, plt, save
from runs import make_all
from sweep_cases import (NAME, SILOS, VARIANTS, WINDOW, cases, outlet_time,
                         runs, sweep_run)
from tables import markdown, number

COLORS = {"floor": "#1d3557", "free": "#c9822a", "averaged": "#4a7c59",
          "cell": "#9b2226"}
FEWEST = 5  # widths for a fit
CONFIDENCE = 0.95
RATE = "flow_rate_kg_per_s"


class Fit(NamedTuple):
    factor: float
    offset: float  # k, in elements
    exponent: float
    offset_error: float  # half of the confidence interval
    exponent_error: float
    deviation: float  # root mean square, of the logarithm

    def rate(self, width, element):
        return self.factor * (width - self.offset * element)**self.exponent


def make_runs():
    make_all(runs())


def results():
    return [row_of(*case) for case in cases()
            if run_output.has_ended(sweep_run(*case).directory)]


def row_of(key, kind, outlet, seed):
    silo = SILOS[key]
    directory = sweep_run(key, kind, outlet, seed).directory
    summary = run_output.read_summary(directory)
    start, end = WINDOW
    middle = 0.5 * (start + end)
    table = run_output.read_table(directory, "flow_rate.csv")
    rate, earlier, later = (mean_rate(table, outlet_time(outlet), *times)
                            for times in ((start, end), (start, middle),
                                          (middle, end)))
    return {"silo": key, "variant": kind, "outlet_width_m": 2 * outlet,
            "seed": seed,
            "outlet_width_elements": 2 * outlet / silo.element,
            RATE: rate, "earlier_" + RATE: earlier, "later_" + RATE: later,
            # The formula's rate without grain size.
            "over_beverloo": rate / table["beverloo_0_kg_per_s"][0],
            "mass_left_share": (summary["mass_in_silo_kg"] /
                                summary["mass_initial_kg"]),
            "status": summary["status"]}


def mean_rate(table, unit, start, end):
    """In kg/s; start and end in `unit` s."""
    mass = numpy.interp([start * unit, end * unit], table["time_s"],
                        table["discharged_mass_kg"])
    return (mass[1] - mass[0]) / ((end - start) * unit)


def select(rows, key, kind):
    return [row for row in rows if row["silo"] == key and
            row["variant"] == kind and row["status"] == "finished"]


def has_enough(rows):
    return len({row["outlet_width_m"] for row in rows}) >= FEWEST


def fit(rows, element, exponent=None, column=RATE):
    """Least squares of the logarithm; of n too if no exponent is given."""
    width = numpy.array([row["outlet_width_m"] for row in rows])
    rate = numpy.log([row[column] for row in rows])
    start = exponent or 2.

    def errors(parameters):
        n = exponent or parameters[2]
        return (parameters[0] - rate +
                n * numpy.log(width - parameters[1] * element))

    first = [rate[-1] - start * math.log(width[-1]), 0.]
    bounds = ([-numpy.inf, -20.], [numpy.inf, 0.95 * min(width) / element])
    if exponent is None:
        first.append(start)
        bounds = (bounds[0] + [0.], bounds[1] + [10.])
    found = least_squares(errors, first, bounds=bounds, x_scale="jac")
    freedom = len(rows) - len(first)
    variance = 2 * found.cost / freedom
    error = student.ppf(0.5 + 0.5 * CONFIDENCE, freedom) * numpy.sqrt(
        variance * numpy.diag(numpy.linalg.inv(found.jac.T @ found.jac)))
    return Fit(math.exp(found.x[0]), found.x[1], exponent or found.x[2],
               error[1], 0. if exponent else error[2],
               math.sqrt(2 * found.cost / len(rows)))


def fits(rows, key):
    silo = SILOS[key]
    lines = []
    for kind, variant in VARIANTS.items():
        chosen = select(rows, key, kind)
        if has_enough(chosen):
            lines.append([variant.title, len(chosen),
                          *fit_cells(chosen, silo)])
    start, end = WINDOW
    middle = 0.5 * (start + end)
    return markdown(
        ["variant", "runs", "exponent n", "offset k, elements", "deviation",
         f"n from {start:g} to {middle:g}", f"n from {middle:g} to {end:g}",
         f"offset k if n = {silo.exponent:g}", "deviation"], lines)


def fit_cells(rows, silo):
    free = fit(rows, silo.element)
    fixed = fit(rows, silo.element, silo.exponent)
    halves = (fit(rows, silo.element, column=half + RATE)
              for half in ("earlier_", "later_"))
    return [f"{free.exponent:.2f} ± {free.exponent_error:.2f}",
            f"{free.offset:.1f} ± {free.offset_error:.1f}",
            f"{100 * free.deviation:.1f} %",
            *(f"{half.exponent:.2f} ± {half.exponent_error:.2f}"
              for half in halves),
            f"{fixed.offset:.2f} ± {fixed.offset_error:.2f}",
            f"{100 * fixed.deviation:.1f} %"]


def rates(rows, key):
    silo = SILOS[key]
    unit = "kg/(s m)" if key == "plane" else "kg/s"
    lines = []
    for outlet in silo.outlets:
        line = [f"{2 * outlet:g}", f"{2 * outlet / silo.element:g}"]
        for kind in VARIANTS:
            line += rate_cells([row for row in select(rows, key, kind)
                                if row["outlet_width_m"] == 2 * outlet])
        lines.append(line)
    head = ["outlet D, m", "D, elements"]
    for variant in VARIANTS.values():
        head += [f"{variant.title}, {unit}", "over Beverloo's"]
    return markdown(head, lines)


def rate_cells(rows):
    """Means over the seeds."""
    if not rows:
        return 2 * ["–"]

    def mean(column):
        return sum(row[column] for row in rows) / len(rows)
    return [number(mean(RATE)), f"{mean('over_beverloo'):.2f}"]


def parts(rows):
    return {f"{table.__name__}-{key}": table(rows, key)
            for key in SILOS for table in (fits, rates)}


def draw_variant(axes, chosen, key, kind):
    silo = SILOS[key]
    width = numpy.array([row["outlet_width_elements"] for row in chosen])
    axes.plot(width, [row["over_beverloo"] for row in chosen], "o",
              markersize=4, color=COLORS[kind], label=VARIANTS[kind].title)
    if not has_enough(chosen):
        return
    # Beverloo's rate is a multiple of D^n.
    factor = (chosen[0]["over_beverloo"] / chosen[0][RATE] *
              chosen[0]["outlet_width_m"]**silo.exponent)
    line = silo.element * numpy.linspace(min(width), max(width), 100)
    rate = fit(chosen, silo.element).rate(line, silo.element)
    axes.plot(line / silo.element, factor * rate / line**silo.exponent,
              color=COLORS[kind], linewidth=1)


def draw(rows):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, 2, layout="constrained",
                                      figsize=(10, 4), sharey=True)
        for axes, (key, silo) in zip(panels, SILOS.items()):
            for kind in VARIANTS:
                chosen = select(rows, key, kind)
                if chosen:
                    draw_variant(axes, chosen, key, kind)
            axes.set_ylim(0, None)
            axes.set_xlabel("outlet's width, elements")
            axes.set_title(silo.title, fontsize=11)
            if axes.lines:
                axes.legend(frameon=False, fontsize=8, loc="lower right")
        panels[0].set_ylabel("rate over Beverloo's, d/D = 0")
        save(figure, NAME + ".png")
