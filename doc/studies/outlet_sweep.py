"""The steady flow rate W over the outlet's width D, and the fit
W = A (D - k h)^n with the element size h."""
import math
from typing import NamedTuple

import numpy
from scipy.optimize import least_squares

import run_output
from plots import STYLE, plt, save
from runs import make_all
from sweep_cases import (AXISYMMETRIC, LIPS, NAME, PLANE, SILOS, runs,
                         sweep_run)
from tables import markdown, number

LIP_COLORS = {"floor": "#1d3557", "free": "#c9822a"}
FEWEST = 4  # widths for a fit
MARKERS = {"plane": "o", "plane-similar": "s", "plane-fine": "^",
           "axisymmetric": "o"}


class Fit(NamedTuple):
    factor: float
    offset: float  # k, in elements
    exponent: float
    offset_error: float  # standard errors
    exponent_error: float
    deviation: float  # root mean square, of the logarithm

    def rate(self, width, element):
        return self.factor * (width - self.offset * element)**self.exponent


def make_runs():
    make_all(runs())


def results():
    rows = []
    for key, silo in SILOS.items():
        for lip in LIPS:
            for outlet in silo.outlets:
                directory = sweep_run(key, lip, outlet).directory
                if run_output.has_ended(directory):
                    rows.append(row_of(key, lip, outlet, directory))
    return rows


def row_of(key, lip, outlet, directory):
    silo = SILOS[key]
    summary = run_output.read_summary(directory)
    left = summary["mass_in_silo_kg"] / summary["mass_initial_kg"]
    return {"silo": key, "lip": lip, "outlet_width_m": 2 * outlet,
            "outlet_width_elements": 2 * outlet / silo.element,
            "outlet_over_silo_width": silo.relative_outlet(outlet),
            "steady_flow_rate_kg_per_s": summary["steady_flow_rate_kg_per_s"],
            "steady_flow_start_s": summary["steady_flow_start_s"],
            "steady_flow_end_s": summary["steady_flow_end_s"],
            "over_beverloo": (summary["steady_flow_rate_kg_per_s"] /
                              beverloo(directory)),
            "drift": drift(directory, summary), "mass_left_share": left, "status": summary["status"]}


def beverloo(directory):
    """The rate of the formula without grain size."""
    table = run_output.read_table(directory, "flow_rate.csv")
    return table["beverloo_0_kg_per_s"][0]


def drift(directory, summary):
    """The rate in the later half of the steady stretch over that in the
    earlier one, less 1."""
    table = run_output.read_table(directory, "flow_rate.csv")
    start, end = (summary[f"steady_flow_{word}_s"] for word in
                  ("start", "end"))
    mass = numpy.interp([start, 0.5 * (start + end), end], table["time_s"],
                        table["discharged_mass_kg"])
    return (mass[2] - mass[1]) / (mass[1] - mass[0]) - 1.


def select(rows, key, lip):
    return [row for row in rows if row["silo"] == key and row["lip"] == lip]


def fit(rows, element, exponent=None):
    """Least squares of the logarithm; of n too if no exponent is given."""
    width = numpy.array([row["outlet_width_m"] for row in rows])
    rate = numpy.log([row["steady_flow_rate_kg_per_s"] for row in rows])
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
    variance = 2 * found.cost / (len(rows) - len(first))
    error = numpy.sqrt(variance * numpy.diag(
        numpy.linalg.inv(found.jac.T @ found.jac)))
    return Fit(math.exp(found.x[0]), found.x[1], exponent or found.x[2],
               error[1], 0. if exponent else error[2],
               math.sqrt(2 * found.cost / len(rows)))


def fits(rows, keys):
    lines = []
    for key in keys:
        silo = SILOS[key]
        for lip in LIPS:
            chosen = select(rows, key, lip)
            if len(chosen) < FEWEST:
                continue
            free = fit(chosen, silo.element)
            fixed = fit(chosen, silo.element, silo.exponent)
            lines.append([
                silo.title, lip,
                f"{free.exponent:.2f} ± {free.exponent_error:.2f}",
                f"{free.offset:.1f} ± {free.offset_error:.1f}",
                f"{100 * free.deviation:.1f} %",
                f"{fixed.offset:.2f} ± {fixed.offset_error:.2f}",
                f"{100 * fixed.deviation:.1f} %"])
    power = f"{SILOS[keys[0]].exponent:g}"
    return markdown(["silo", "lip", "exponent n", "offset k, elements",
                     "deviation", f"offset k if n = {power}", "deviation"],
                    lines)


def rates(rows, keys):
    unit = "kg/(s m)" if SILOS[keys[0]].is_plane else "kg/s"
    lines = []
    for key in keys:
        silo = SILOS[key]
        for outlet in silo.outlets:
            line = [silo.title, f"{2 * outlet:g}",
                    f"{2 * outlet / silo.element:g}",
                    f"{silo.relative_outlet(outlet):.2f}"]
            for lip in LIPS:
                line += rate_cells(row for row in select(rows, key, lip)
                                   if row["outlet_width_m"] == 2 * outlet)
            lines.append(line)
    head = ["silo", "outlet D, m", "D, elements", "D / silo's width"]
    for lip in ("lip on the floor", "free lip"):
        head += [f"{lip}, {unit}", "over Beverloo's", "drift"]
    return markdown(head, lines)


def rate_cells(rows):
    row = next(rows, None)
    if row is None:
        return 3 * ["–"]
    return [number(row["steady_flow_rate_kg_per_s"]),
            f"{row['over_beverloo']:.2f}", f"{100 * row['drift']:+.0f} %"]


def parts(rows):
    return {f"{table.__name__}-{kind}": table(rows, keys)
            for kind, keys in (("plane", PLANE),
                               ("axisymmetric", AXISYMMETRIC))
            for table in (fits, rates)}


def draw_silo(axes, chosen, key, lip):
    silo = SILOS[key]
    width = numpy.array([row["outlet_width_elements"] for row in chosen])
    style = {"color": LIP_COLORS[lip], "marker": MARKERS[key]}
    axes.plot(width, [row["over_beverloo"] for row in chosen], linestyle="",
              markersize=5, label=f"{silo.title}, lip: {lip}", **style)
    if len(chosen) < FEWEST:
        return
    # Beverloo's rate is a multiple of D^n.
    factor = (chosen[0]["over_beverloo"] /
              chosen[0]["steady_flow_rate_kg_per_s"] *
              chosen[0]["outlet_width_m"]**silo.exponent)
    line = silo.element * numpy.linspace(width[0], width[-1], 100)
    rate = fit(chosen, silo.element).rate(line, silo.element)
    axes.plot(line / silo.element, factor * rate / line**silo.exponent,
              color=LIP_COLORS[lip], linewidth=1)


def draw_panel(axes, rows, keys):
    for key in keys:
        for lip in LIPS:
            chosen = select(rows, key, lip)
            if chosen:
                draw_silo(axes, chosen, key, lip)
    axes.set_ylim(0, None)
    axes.set_xlabel("outlet's width, elements")
    if axes.lines:
        axes.legend(frameon=False, fontsize=8, loc="lower right")


def draw(rows):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, 2, layout="constrained",
                                      figsize=(10, 4), sharey=True)
        for axes, keys in zip(panels, (PLANE, AXISYMMETRIC)):
            draw_panel(axes, rows, keys)
        panels[0].set_ylabel("steady rate over Beverloo's, d/D = 0")
        save(figure, NAME + ".png")
