"""The runs of the study of element tests, and the measured tests beside
them."""
import csv
import math
from typing import NamedTuple

from runs import ROOT
from study_runs import study_run

NAME = "element-tests"
SCENE = "../element-tests/triaxial"
DATA = ROOT / "tests" / "data"
SAND = "karlsruhe-fine-sand-"
CRITICAL_ANGLE = 33.1  # degrees, of that sand

PRESSURE = 100e3  # Pa
FRICTION = 30  # degrees
STIFFNESS = 5e7  # Pa, of the laws with a constant one
FINAL_STRAIN = 0.2
STEPS, MANY_STEPS = 1000, 100000

# Title, Material/Model, Material/Yield cone
LAWS = tuple([(f"Drucker–Prager, `{cone}`", "Drucker-Prager", cone)
              for cone in ("Matsuoka-Nakai", "plane strain", "compression",
                           "paper")] +
             [("μ(I)", "mu(I)", None),
              ("von Wolffersdorff", "von Wolffersdorff", None),
              ("Wu–Bauer", "Wu-Bauer", None), ("Kolymbas", "Kolymbas", None),
              ("Lade", "Lade", None)])
# Title, Element test/Kind, Element test/Axial strain
KINDS = (("compression", "triaxial", FINAL_STRAIN),
         ("extension", "triaxial", -FINAL_STRAIN),
         ("biaxial", "biaxial", FINAL_STRAIN),
         ("simple shear", "simple shear", FINAL_STRAIN))


def read_data(name):
    with open(DATA / (SAND + name + ".csv"), encoding="utf-8") as file:
        lines = [line for line in file if not line.startswith("#")]
    return list(csv.DictReader(lines))


def test_run(name, settings):
    return study_run(NAME, name, SCENE, settings, mode=("--element-test",))


def stresses(axial, lateral):
    return f"{axial:.9g}, {lateral:.9g}, {lateral:.9g}"


class Oedometer(NamedTuple):
    name: str
    start: float  # axial stress, Pa
    void_ratio: float  # at the start
    points: tuple  # pairs of axial stress and void ratio

    def run(self):
        at_rest = 1. - math.sin(math.radians(CRITICAL_ANGLE))
        return test_run(f"oedometer-{self.name}", (
            ("Material/Model", "von Wolffersdorff"),
            ("Material/Void ratio", self.void_ratio),
            ("Element test/Kind", "oedometer"),
            ("Element test/Initial stress",
             stresses(self.start, at_rest * self.start)),
            ("Element test/Axial strain", 0.1),
            ("Element test/Largest axial stress",
             1.01 * self.points[-1][0]),
            ("Element test/Steps", 10000)))


class Triaxial(NamedTuple):
    """Strains are shares, compression positive."""
    name: str
    pressure: float  # Pa
    void_ratio: float  # at the start
    peak: float  # of q, Pa
    strain_at_peak: float
    q: tuple  # pairs of axial strain and q
    volume: tuple  # pairs of axial and volumetric strain

    END = 0.3

    def run(self):
        return test_run(f"triaxial-{self.name}", (
            ("Material/Model", "von Wolffersdorff"),
            ("Material/Void ratio", self.void_ratio),
            ("Element test/Kind", "triaxial"),
            ("Element test/Initial stress",
             stresses(self.pressure, self.pressure)),
            ("Element test/Axial strain", self.END),
            ("Element test/Steps", 3000)))


def by_test(name):
    tests = {}
    for row in read_data(name):
        tests.setdefault(row["test"], []).append(row)
    return tests


def oedometers():
    return [Oedometer(name, 1e3 * float(rows[0]["start_sigma1_kPa"]),
                      float(rows[0]["start_void_ratio"]),
                      tuple((1e3 * float(row["sigma1_kPa"]),
                             float(row["void_ratio"])) for row in rows))
            for name, rows in by_test("oedometer").items()]


def triaxials():
    tests = []
    for name, rows in by_test("drained-triaxial").items():
        def pairs(quantity, factor, rows=rows):
            return tuple((float(row["axial_strain_percent"]) / 100,
                          factor * float(row["value"]))
                         for row in rows if row["quantity"] == quantity)
        first = rows[0]
        tests.append(Triaxial(
            name, 1e3 * float(first["start_p_kPa"]),
            float(first["start_void_ratio"]),
            1e3 * float(first["peak_q_kPa"]),
            float(first["axial_strain_at_peak_percent"]) / 100,
            pairs("q_kPa", 1e3), pairs("volumetric_strain_percent", 0.01)))
    return sorted(tests, key=lambda test: -test.void_ratio)


def law_run(law, kind, steps=STEPS):
    _, model, cone = law
    title, kind_name, strain = kind
    words = [model, cone or "", title, str(steps)]
    settings = [("Material/Model", model),
                ("Material/Internal friction angle", FRICTION),
                ("Material/Young modulus", STIFFNESS),
                ("Element test/Kind", kind_name),
                ("Element test/Initial stress", stresses(PRESSURE, PRESSURE)),
                ("Element test/Axial strain", strain),
                ("Element test/Steps", steps)]
    if cone:
        settings.append(("Material/Yield cone", cone))
    return test_run("-".join(word for word in words if word).replace(" ", "-"),
                    settings)


def timed_runs():
    """Each law's compression with few and with many steps."""
    return [law_run(law, KINDS[0], steps) for law in LAWS
            for steps in (STEPS, MANY_STEPS)]


def all_runs():
    return ([test.run() for test in oedometers() + triaxials()] +
            [law_run(law, kind) for law in LAWS for kind in KINDS] +
            timed_runs())
