"""Jenike's radial stress field by the finite elements of the second method, in
the hoppers of the study of materials."""
import math

import numpy

import run_output
from material_cases import CONICAL, PAPER_WEDGES, WEIGHT
from materials import has_result, wall_rows
from plots import STYLE, plt, save
from runs import make_all
from study_runs import WITHOUT_FIELDS, study_run
from tables import markdown

NAME = "hopper-fields"
SCENE = "../quickstart"
# Newmark's parameters that take waves away, beside the paper's
DAMPED, UNDAMPED = (0.9, 0.49), (0.5, 0.25)
# What belongs to the particles alone
OF_PARTICLES = ("Scene/Cell type", "Scene/Element size", "Scene/Headroom",
                "Scene/Outlet element size", "Scene/Particles per cell",
                "Particle stage/", "Output/")


class Field:
    """A hopper of the study of materials, by finite elements."""

    def __init__(self, hopper, newmark=DAMPED):
        self.hopper = hopper
        self.newmark = newmark

    @property
    def times(self):
        """Of the mean, s: from when the wave of the opening has gone, to when
        the hopper's head has."""
        if self.hopper.is_cone:
            return 0.2, 0.35
        return (0.5, 0.7) if self.hopper.half_angle <= 10. else (0.4, 0.7)

    @property
    def element(self):
        """In m: not above the height of the hopper's head."""
        head = next(setting for setting in self.hopper.run().settings
                    if setting.startswith("Scene/Wall height="))
        return min(0.1, float(head.split("=")[1]))

    @property
    def run(self):
        settings = [tuple(setting.split("=", 1))
                    for setting in self.hopper.run().settings
                    if not setting.startswith(OF_PARTICLES)]
        settings += [
            ("Flow/Method", "updated Lagrangian"),
            ("Scene/Cell type", "triangle"),
            ("Scene/Element size", f"{self.element:g}"),
            ("Particle stage/End time", self.times[1]),
            ("Updated Lagrangian stage/Time step", 0.005),
            ("Updated Lagrangian stage/Newmark delta", self.newmark[0]),
            ("Updated Lagrangian stage/Newmark alpha", self.newmark[1]),
            ("Output/Interval", 0.05)]
        delta = f"{self.newmark[0]:g}"
        return study_run(NAME, f"{self.hopper.name}-delta-{delta}", SCENE,
                         settings, WITHOUT_FIELDS)

    def stress(self):
        """Mean and standard deviation in time of the wall's normal traction
        over gamma r, a mean along the wall."""
        start, end = self.times
        lower, upper = (radius * self.hopper.OUTLET
                        for radius in self.hopper.RADII)
        sine = math.sin(math.radians(self.hopper.half_angle))
        of_times = {}
        for row in wall_rows(self.run.directory, "hopper", start):
            if row["time_s"] < end + 1e-9 and lower <= row["x_m"] <= upper:
                of_times.setdefault(row["time_s"], []).append(
                    row["normal_Pa"] * sine / (WEIGHT * row["x_m"]))
        means = [numpy.mean(values) for values in of_times.values()]
        return numpy.mean(means), numpy.std(means)


FIELDS = ([Field(hopper) for hopper in PAPER_WEDGES + CONICAL] +
          [Field(PAPER_WEDGES[1], UNDAMPED)])


def make_runs():
    make_all([field.run for field in FIELDS])


def results():
    rows = []
    for field in FIELDS:
        if not has_result(field.run):
            continue
        mean, deviation = field.stress()
        summary = run_output.read_summary(field.run.directory)
        rows.append({"formulation": field.hopper.formulation,
                     "newmark_delta": field.newmark[0],
                     "delta": field.hopper.effective_friction,
                     "half_angle": field.hopper.half_angle,
                     "wall_friction": field.hopper.wall_friction,
                     "element_m": field.element,
                     "value": mean, "deviation": deviation,
                     "reference": field.hopper.field.wall,
                     "loop_seconds": summary["loop_seconds"]})
    return rows


def difference(row):
    return 100 * (row["value"] / row["reference"] - 1)


def is_damped(row):
    return row["newmark_delta"] == DAMPED[0]


def fields(rows):
    return markdown(
        ["hopper", "δ", "α", "φ_w", "Newmark's δ", "σ_w/(γ r)", "its spread",
         "exact", "difference, %", "seconds"],
        [["cone" if row["formulation"] == "axisymmetric" else "wedge",
          f"{row['delta']:.2f}°", f"{row['half_angle']:g}°",
          f"{row['wall_friction']:g}°", f"{row['newmark_delta']:g}",
          f"{row['value']:.4f}", f"{row['deviation']:.3f}",
          f"{row['reference']:.4f}", f"{difference(row):+.1f}",
          f"{row['loop_seconds']:.0f}"] for row in rows])


def summary(rows):
    damped = [abs(difference(row)) for row in rows if is_damped(row)]
    return (f"{sum(value <= 3. for value in damped)} of {len(damped)} are "
            f"within 3 %; the largest difference is {max(damped):.1f} %.")


def parts(rows):
    return {part.__name__: part(rows) for part in (fields, summary)}


def draw(rows):
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(figsize=(4.5, 4.2), layout="constrained")
        largest = 1.1 * max(row["reference"] for row in rows)
        axes.plot([0, largest], [0, largest], color="#8d99ae", linewidth=1)
        for formulation, colour in (("plane strain", "#1d3557"),
                                    ("axisymmetric", "#c1121f")):
            chosen = [row for row in rows if is_damped(row) and
                      row["formulation"] == formulation]
            axes.plot([row["reference"] for row in chosen],
                      [row["value"] for row in chosen], "o", color=colour,
                      markersize=5, label="cones" if colour == "#c1121f"
                      else "wedges")
        axes.set_xlabel("Jenike's σ_w/(γ r)")
        axes.set_ylabel("finite elements")
        axes.legend(frameon=False, fontsize=9)
        save(figure, NAME + ".png")
