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
            "outlet_over_silo_width": outlet / silo.half_width,
            "steady_flow_rate_kg_per_s": summary["steady_flow_rate_kg_per_s"],
            "steady_flow_start_s": summary["steady_flow_start_s"],
            "steady_flow_end_s": summary["steady_flow_end_s"],
            "mass_left_share": left, "status": summary["status"]}


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
            if len(chosen) < 4:
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
        for outlet in SILOS[key].outlets:
            line = []
            for lip in LIPS:
                row = next((row for row in select(rows, key, lip)
                            if row["outlet_width_m"] == 2 * outlet), None)
                if row is None:
                    line += ["–", "–"]
                    continue
                line += [number(row["steady_flow_rate_kg_per_s"]),
                         f"{row['steady_flow_start_s']:.2f} to "
                         f"{row['steady_flow_end_s']:.2f}"]
            silo = SILOS[key]
            lines.append([silo.title, f"{2 * outlet:g}",
                          f"{2 * outlet / silo.element:g}",
                          f"{outlet / silo.half_width:.2f}"] + line)
    return markdown(["silo", "outlet D, m", "D, elements", "D / silo's width",
                     f"lip on the floor, {unit}", "steady, s",
                     f"free lip, {unit}", "steady, s"], lines)


def parts(rows):
    return {f"{table.__name__}-{kind}": table(rows, keys)
            for kind, keys in (("plane", PLANE),
                               ("axisymmetric", AXISYMMETRIC))
            for table in (fits, rates)}


def draw_panel(axes, rows, key):
    silo = SILOS[key]
    for lip in LIPS:
        chosen = select(rows, key, lip)
        if len(chosen) < 4:
            continue
        free = fit(chosen, silo.element)
        width = numpy.array([row["outlet_width_m"] for row in chosen])
        line = numpy.linspace(width[0], width[-1], 100)
        axes.loglog(width, [row["steady_flow_rate_kg_per_s"]
                            for row in chosen], "o", color=LIP_COLORS[lip],
                    markersize=5)
        axes.loglog(line, free.rate(line, silo.element),
                    color=LIP_COLORS[lip], linewidth=1.2,
                    label=f"lip: {lip}, n = {free.exponent:.2f}, "
                          f"k = {free.offset:.1f}")
    axes.set_title(silo.title, fontsize=11)
    axes.set_xlabel("outlet's width, m")
    axes.set_ylabel("steady flow rate, " +
                    ("kg/(s m)" if silo.is_plane else "kg/s"))
    axes.legend(frameon=False, fontsize=8)


def draw(rows):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, len(SILOS), layout="constrained",
                                      figsize=(3.6 * len(SILOS), 3.8))
        for axes, key in zip(panels, SILOS):
            draw_panel(axes, rows, key)
        save(figure, NAME + ".png")
