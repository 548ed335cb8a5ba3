"""Filling by layers beside Janssen, a steady state by refilling, and the flow
through a part of an outlet."""
import math

import run_output
from operation_cases import (LAYERS, NAME, OUTLET, RELIEF, SHARES,
                             funnel_runs, layer_run, opening_run, runs,
                             steady_run)
from plots import STYLE, plt, save
from runs import make_all
from tables import markdown, number

GRAVITY, DENSITY = 9.81, 1500.  # m/s^2, kg/m^3
HALF_WIDTH, WALL_FRICTION = 0.5, math.tan(math.radians(20.))  # of the layers
WINDOW = 0.8, 2.2  # of flow through a gate, s


def make_runs():
    make_all(runs())


def results():
    return ([janssen_row(n) for n in LAYERS if has_ended(layer_run(n))] +
            [steady_row("hopper, triangles", RELIEF[0], run)
             for run in [steady_run()] if has_ended(run)] +
            [steady_row(f"flat bottom, {case}", relief, run)
             for (case, relief), run in funnel_runs().items()
             if has_ended(run)] +
            [opening_row(share) for share in SHARES
             if has_ended(opening_run(share, True)) and
             has_ended(opening_run(share, False))])


def has_ended(run):
    return run_output.has_ended(run.directory)


def row(kind, case, **values):
    names = ("wall_force_N_per_m", "lateral_ratio", "over_janssen",
             "friction_over_janssen", "friction_of_whole_over_janssen",
             "flow_rate_kg_per_s", "over_outlet",
             "exponent", "spread", "last_over_second", "emptying_time_s",
             "emptying_times", "mass_over_initial", "mass_error", "relief")
    return {"kind": kind, "case": case,
            **{name: values.get(name) for name in names}}


# --- Layers --------------------------------------------------------------------

def wall_at_rest(directory):
    """Height and both tractions at the wall's nodes, from the floor up."""
    table = run_output.read_table(directory, "wall_traction.csv")
    return sorted(
        (y, normal, tangential) for time, wall, y, normal, tangential in zip(
            table["time_s"], table["wall"], table["y_m"], table["normal_Pa"],
            table["tangential_Pa"]) if time == 0. and wall == "wall")


def integral(heights, values):
    return sum((values[i] + values[i + 1]) / 2 * (heights[i + 1] - heights[i])
               for i in range(len(heights) - 1))


def beside_janssen(wall):
    """Of the wall above the lowest of these nodes: its force, the lateral
    ratio that the run shows, and both its forces over Janssen's with that."""
    y, normal, tangential = zip(*wall)
    carried, stress = 0., []
    for i in reversed(range(len(y))):
        if stress:
            carried += ((tangential[i] + tangential[i + 1]) / 2 *
                        (y[i + 1] - y[i]))
        stress.append(DENSITY * GRAVITY * (y[-1] - y[i]) -
                      carried / HALF_WIDTH)
    force = integral(y, normal)
    ratio = force / integral(y, stress[::-1])
    length = HALF_WIDTH / (WALL_FRICTION * ratio)
    height = y[-1] - y[0]
    friction = DENSITY * GRAVITY * HALF_WIDTH * (
        height - length * (1 - math.exp(-height / length)))
    return (force, ratio, force * WALL_FRICTION / friction,
            integral(y, tangential) / friction)


def janssen_row(n_layers):
    wall = wall_at_rest(layer_run(n_layers).directory)
    force, ratio, share, friction = beside_janssen(wall)
    above = [node for node in wall if node[0] > HALF_WIDTH - 1e-9]
    return row("layers", n_layers, wall_force_N_per_m=force,
               lateral_ratio=ratio, over_janssen=share,
               friction_of_whole_over_janssen=friction,
               friction_over_janssen=beside_janssen(above)[3])


# --- Steady state --------------------------------------------------------------

def steady_row(case, relief, run):
    """The rate over each emptying time of the silo, after the first."""
    rates, unit = rates_by_content(run.directory)
    settled = rates[1:]
    mean = sum(settled) / len(settled)
    summary = run_output.read_summary(run.directory)
    history = run_output.read_table(run.directory, "history.csv")
    return row("steady", case, relief=relief, flow_rate_kg_per_s=mean,
               spread=(max(settled) - min(settled)) / mean,
               last_over_second=sum(settled[-3:]) / sum(settled[:3]),
               emptying_time_s=unit, emptying_times=len(rates),
               mass_over_initial=history["mass_in_silo_kg"][-1] /
               history["mass_in_silo_kg"][0],
               mass_error=summary["mass_balance_error"])


def rates_by_content(directory):
    """Over one emptying time after the other, and how long that is: the silo's
    content over the rate of the second half."""
    history = run_output.read_table(directory, "history.csv")
    times, masses = history["time_s"], history["mass_discharged_kg"]
    half = times[-1] / 2
    rate = (masses[-1] - mass_at(times, masses, half)) / half
    unit = history["mass_in_silo_kg"][0] / rate
    return [(mass_at(times, masses, (i + 1) * unit) -
             mass_at(times, masses, i * unit)) / unit
            for i in range(int(times[-1] / unit))], unit


def mass_at(times, masses, time):
    i = next(i for i in range(1, len(times))
             if times[i] >= time or i == len(times) - 1)
    share = (time - times[i - 1]) / (times[i] - times[i - 1])
    return masses[i - 1] + share * (masses[i] - masses[i - 1])


# --- Gates ---------------------------------------------------------------------

def rate_of(run):
    history = run_output.read_table(run.directory, "history.csv")
    first, last = (mass_at(history["time_s"], history["mass_discharged_kg"],
                           time) for time in WINDOW)
    return (last - first) / (WINDOW[1] - WINDOW[0])


def opening_row(share):
    rate = rate_of(opening_run(share, True))
    whole = rate_of(opening_run(100, True))
    return row("gate", share, flow_rate_kg_per_s=rate,
               over_outlet=rate / rate_of(opening_run(share, False)),
               exponent=None if share == 100 else
               math.log(rate / whole) / math.log(share / 100))


# --- The page ------------------------------------------------------------------

def of_kind(rows, kind):
    return [row for row in rows if row["kind"] == kind]


def layers(rows):
    return markdown(
        ["layers", "wall force, kN/m", "K", "force over Janssen's",
         "friction over Janssen's", "the same above one half width"],
        [[row["case"], number(row["wall_force_N_per_m"] / 1e3, ".2f"),
          number(row["lateral_ratio"], ".4f"),
          number(row["over_janssen"], ".3f"),
          number(row["friction_of_whole_over_janssen"], ".3f"),
          number(row["friction_over_janssen"], ".3f")]
         for row in of_kind(rows, "layers")])


def gates(rows):
    return markdown(
        ["open, %", "half width, m", "flow rate, kg/(s m)",
         "over that of an outlet of this width", "exponent"],
        [[row["case"], f"{row['case'] / 100 * OUTLET:g}",
          number(row["flow_rate_kg_per_s"]), number(row["over_outlet"], ".3f"),
          number(row["exponent"], ".2f")] for row in of_kind(rows, "gate")])


def steady(rows):
    return markdown(
        ["silo", "`Relieve overfull cells`", "flow rate, kg/(s m)",
         "emptying time, s", "emptying times",
         "largest less smallest over the mean", "last three over first three",
         "mass in the silo over that of the start", "mass balance"],
        [[row["case"], f"`{row['relief']}`", number(row["flow_rate_kg_per_s"]),
          number(row["emptying_time_s"], ".2f"), row["emptying_times"],
          f"{100 * row['spread']:.1f} %", number(row["last_over_second"], ".3f"),
          number(row["mass_over_initial"], ".3f"),
          number(row["mass_error"], ".0e")]
         for row in of_kind(rows, "steady")])


def parts(rows):
    return {"layers": layers(rows), "gates": gates(rows),
            "steady": steady(rows)}


def draw(rows):
    """The flow rates of the steady states over time."""
    drawn = {"hopper, triangles": [steady_run()]}
    for (case, _), run in funnel_runs().items():
        drawn.setdefault(f"flat bottom, {case}", []).append(run)
    means = {row["case"]: row["flow_rate_kg_per_s"]
             for row in of_kind(rows, "steady") if row["relief"] == RELIEF[0]}
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, len(drawn), figsize=(14, 3),
                                      sharey=True, layout="constrained")
        for axes, (case, cases) in zip(panels, drawn.items()):
            axes.axhspan(0.985, 1.015, color="#dddddd", linewidth=0)
            for run, color in reversed(list(zip(cases,
                                                ("#1d3557", "#e07a5f")))):
                flow = run_output.read_table(run.directory, "flow_rate.csv")
                axes.plot(flow["time_s"],
                          [rate / means[case] if rate != "" else math.nan
                           for rate in flow["mass_flow_rate_kg_per_s"]],
                          color=color, linewidth=0.8)
            axes.set_title(case, fontsize=11)
            axes.set_xlabel("time, s")
        panels[0].set_ylabel("flow rate over its mean")
        panels[0].set_ylim(0.7, 1.3)
        save(figure, NAME + ".png")
