"""Silos drawn at random with the mesh that the program chooses, beside meshes
twice as fine."""
import math
import random
from typing import NamedTuple

import run_output
from outlet_sweep import mean_rate
from plots import STYLE, plt, save
from runs import make_all
from study_runs import WITHOUT_FIELDS, study_run
from tables import markdown, number
from traction_tables import integral_along, mean_over_outputs, rows_at

NAME = "any-silo"
NUMBER = 30
SEED = 2026
SCENE = "../quickstart"
REFINEMENTS = (1, 2)
GRAVITY, DENSITY = 9.81, 1500.  # m/s^2, kg/m^3
WINDOW = (3., 5.)  # in sqrt(D/g)
OUTPUTS_IN_WINDOW = 8
GOAL = 0.05  # of the rate and of the walls' normal force


class Silo(NamedTuple):
    """Lengths in m, angles in degrees, Young's modulus in Pa."""
    formulation: str
    half_width: float
    outlet_half_width: float
    wall_height: float
    hopper_height: float
    hopper_slope: float  # to the horizontal; 0: flat bottom
    internal_friction: float
    wall_friction: float
    stiffness: float  # E / (rho g H)
    poisson_ratio: float

    @property
    def time(self):
        """sqrt(D/g) in s."""
        return math.sqrt(2 * self.outlet_half_width / GRAVITY)

    @property
    def height(self):
        return self.wall_height + self.hopper_height

    @property
    def period(self):
        """Of the pressure waves between floor and surface, in s."""
        ratio = self.poisson_ratio
        confined_modulus = (self.stiffness * DENSITY * GRAVITY * self.height *
                            (1 - ratio) / ((1 + ratio) * (1 - 2 * ratio)))
        return 4 * self.height * math.sqrt(DENSITY / confined_modulus)

    @property
    def end_time(self):
        """In s: the window, and for the walls' force at least one period."""
        return max(WINDOW[1] * self.time,
                   WINDOW[0] * self.time + self.period)

    @property
    def rate_unit(self):
        """rho sqrt(g) D^1.5 or D^2.5, in kg/(s m) or kg/s."""
        exponent = 2.5 if self.formulation == "axisymmetric" else 1.5
        return (DENSITY * math.sqrt(GRAVITY) *
                (2 * self.outlet_half_width)**exponent)


def draw_silo(chance):
    """Within the bounds that the page states."""
    def by_factor(lower, upper):
        return math.exp(chance.uniform(math.log(lower), math.log(upper)))

    half_width = by_factor(0.2, 5.)
    outlet = half_width * by_factor(0.05, 0.6)
    height = 2 * half_width * chance.uniform(1., 6.)
    slope = chance.choice([0., chance.uniform(10., 80.)])
    hopper = (half_width - outlet) * math.tan(math.radians(slope))
    friction = chance.uniform(20., 40.)
    return Silo(chance.choice(["plane strain", "axisymmetric"]), half_width,
                outlet, max(height - hopper, 0.3 * height), hopper, slope,
                friction, chance.uniform(0., friction), by_factor(40., 4000.),
                chance.uniform(0.2, 0.45))


def silos():
    chance = random.Random(SEED)
    return [draw_silo(chance) for _ in range(NUMBER)]


def silo_run(index, silo, refinement):
    young_modulus = silo.stiffness * DENSITY * GRAVITY * silo.height
    start_time = WINDOW[0] * silo.time
    settings = (("Scene/Formulation", silo.formulation),
                ("Scene/Half width", silo.half_width),
                ("Scene/Outlet half width", silo.outlet_half_width),
                ("Scene/Wall height", silo.wall_height),
                ("Scene/Hopper height", silo.hopper_height),
                ("Scene/Fall region depth", 4 * silo.outlet_half_width),
                ("Scene/Element size", "auto"),
                ("Scene/Refinement", refinement),
                ("Material/Yield cone", "Matsuoka-Nakai"),
                ("Material/Internal friction angle", silo.internal_friction),
                ("Material/Young modulus", young_modulus),
                ("Material/Poisson ratio", silo.poisson_ratio),
                ("Walls/Friction angle", silo.wall_friction),
                ("Particle stage/End time", silo.end_time),
                ("Output/Interval",
                 (silo.end_time - start_time) / OUTPUTS_IN_WINDOW),
                ("Output/History interval", WINDOW[1] * silo.time / 100))
    return study_run(NAME, f"silo-{index + 1}-refinement-{refinement}", SCENE,
                     settings, WITHOUT_FIELDS)


def make_runs():
    make_all([silo_run(index, silo, refinement)
              for index, silo in enumerate(silos())
              for refinement in REFINEMENTS])


def flow_rate(directory, silo):
    """Mean in the window, in kg/s or kg/(s m)."""
    return mean_rate(run_output.read_table(directory, "flow_rate.csv"),
                     silo.time, *WINDOW)


def wall_force(directory, silo):
    """The walls' mean normal force from the window's start to the end of the
    run, in N or N/m."""
    def at(time):
        rows = [row for row in rows_at(directory, time)
                if not math.isnan(row["normal_Pa"])]
        for row in rows:
            row["normal_N_per_m"] = row["normal_Pa"] * (
                2 * math.pi * row["x_m"] if silo.formulation == "axisymmetric"
                else 1.)
        return sum(integral_along([row for row in rows if row["wall"] == wall],
                                  "normal_N_per_m")
                   for wall in {row["wall"] for row in rows})
    return mean_over_outputs(directory, WINDOW[0] * silo.time, silo.end_time,
                             at)


def results():
    rows = []
    for index, silo in enumerate(silos()):
        directories = [silo_run(index, silo, refinement).directory
                       for refinement in REFINEMENTS]
        if all(map(run_output.has_ended, directories)):
            rows.append(row_of(index, silo, directories))
    return rows


def seconds_to_window_end(summary, silo):
    """That the run has taken up to the end of the rate's window: of what goes
    on for the walls' force, as large a share as of the time."""
    share = WINDOW[1] * silo.time / silo.end_time
    return (run_output.seconds_of(summary, "setup", "static") +
            share * run_output.seconds_of(summary, "loop", "output"))


def row_of(index, silo, directories):
    summaries = [run_output.read_summary(directory)
                 for directory in directories]
    row = {"silo": index + 1, **silo._asdict(),
           "finished": all(summary["status"] == "finished"
                           for summary in summaries),
           "particles": summaries[0]["particles"],
           "particle_steps": summaries[0]["particle_steps"],
           "seconds": seconds_to_window_end(summaries[0], silo),
           "rate": None, "rate_error": None, "force_error": None}
    if row["finished"]:
        rate, fine_rate = (flow_rate(directory, silo)
                           for directory in directories)
        force, fine_force = (wall_force(directory, silo)
                             for directory in directories)
        row.update(rate=rate / silo.rate_unit, rate_error=rate / fine_rate - 1,
                   force_error=force / fine_force - 1)
    return row


def percent(value):
    return "–" if value is None else f"{100 * value:+.1f}"


def table_of_silos(rows):
    return markdown(
        ["silo", "", "D / W", "H / W", "hopper", "φ", "φ_w", "E/(ρgH)", "ν",
         "particles", "10⁶ particle-steps", "seconds", "rate",
         "rate's error, %", "wall force's error, %"],
        [[row["silo"], "axisymmetric" if row["formulation"][0] == "a"
          else "plane",
          f"{row['outlet_half_width'] / row['half_width']:.2f}",
          f"{(row['wall_height'] + row['hopper_height']) / row['half_width'] / 2:.1f}",
          f"{row['hopper_slope']:.0f}°" if row["hopper_slope"] else "flat",
          f"{row['internal_friction']:.0f}°", f"{row['wall_friction']:.0f}°",
          f"{row['stiffness']:.0f}", f"{row['poisson_ratio']:.2f}",
          row["particles"], f"{row['particle_steps'] / 1e6:.0f}",
          number(row["seconds"], ".1f"), number(row["rate"], ".3f"),
          percent(row["rate_error"]), percent(row["force_error"])]
         for row in rows])


def summary_of(rows):
    ended = [row for row in rows if row["finished"]]

    def share(condition):
        return f"{sum(map(condition, rows))} of {len(rows)}"

    def typical(column):
        return math.sqrt(sum(row[column]**2 for row in ended) / len(ended))
    return (f"{share(lambda row: row['finished'])} runs end. The rate is within "
            f"{100 * GOAL:.0f} % in "
            + share(lambda row: row["finished"] and
                    abs(row["rate_error"]) <= GOAL)
            + ", the walls' normal force in "
            + share(lambda row: row["finished"] and
                    abs(row["force_error"]) <= GOAL)
            + f"; root mean square {100 * typical('rate_error'):.1f} and "
            f"{100 * typical('force_error'):.1f} %. At most ten seconds take "
            + share(lambda row: row["seconds"] <= 10.) + ".")


def parts(rows):
    return {"silos": table_of_silos(rows), "summary": summary_of(rows)}


def draw(rows):
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(layout="constrained", figsize=(6, 4))
        for formulation, color in (("plane strain", "#1d3557"),
                                   ("axisymmetric", "#c9822a")):
            chosen = [row for row in rows if row["finished"] and
                      row["formulation"] == formulation]
            axes.plot([row["seconds"] for row in chosen],
                      [100 * row["rate_error"] for row in chosen], "o",
                      markersize=4, color=color, label=formulation)
        axes.axhspan(-100 * GOAL, 100 * GOAL, color="#00000010")
        axes.set_xscale("log")
        axes.set_xlabel("seconds")
        axes.set_ylabel("rate's error, %")
        axes.legend(frameon=False)
        save(figure, NAME + ".png")
