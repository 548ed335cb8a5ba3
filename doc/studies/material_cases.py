"""The runs of the study of materials: hoppers, silos with each cone, and mu(I)
and cohesion in units where density and gravity are 1."""
import functools
import math
from typing import NamedTuple

from radial_stress import radial_field
from study_runs import WITHOUT_FIELDS, study_run

NAME = "materials"
SCENE = "../quickstart"
GRAVITY, DENSITY = 9.81, 1500.  # m/s^2, kg/m^3
WEIGHT = GRAVITY * DENSITY  # N/m^3
CONES = ("Matsuoka-Nakai", "plane strain", "compression", "paper")


def run_of(name, settings):
    return study_run(NAME, name, SCENE, settings, WITHOUT_FIELDS)


def short(value):
    return f"{value:.9g}"


cached_field = functools.cache(radial_field)


class Hopper(NamedTuple):
    """Angles in degrees."""
    formulation: str
    cone: str
    friction: float
    half_angle: float  # to the vertical
    wall_friction: float
    loosest_density: float = 0.95

    OUTLET = 0.1  # half width or radius, m
    TOP = 1.  # the same of the hopper's upper end
    HEADROOM = 0.1
    RADII = (3.5, 5.)  # of the mean, over the outlet's

    @property
    def is_cone(self):
        return self.formulation == "axisymmetric"

    @property
    def times(self):
        """Of the mean, s; wider hoppers are sooner in steady flow, and without
        their head."""
        return (0.5, 1.) if self.half_angle <= 10. else (0.4, 0.7)

    @property
    def effective_friction(self):
        """Of Mohr and Coulomb in this hopper's flow, degrees."""
        sine = math.sin(math.radians(self.friction))
        if self.cone == "paper" and not self.is_cone:
            sine = 18 * sine / (9 - sine**2) / math.sqrt(3)
        return math.degrees(math.asin(sine))

    @property
    def field(self):
        return cached_field(round(self.effective_friction, 6),
                            self.half_angle, self.wall_friction,
                            int(self.is_cone))

    @property
    def name(self):
        words = [self.formulation, self.cone, short(self.friction),
                 short(self.half_angle), short(self.wall_friction),
                 short(self.loosest_density)]
        return "hopper-" + "-".join(words).replace(" ", "-")

    def run(self):
        """On its hopper stands smooth-walled material as heavy as the field's
        radial stress there on the axis, so that the field begins at the
        top."""
        sine, tangent = (function(math.radians(self.half_angle))
                         for function in (math.sin, math.tan))
        height = (self.TOP - self.OUTLET) / tangent
        head = 1.1 * self.field.axis * self.TOP / sine
        return run_of(self.name, (
            ("Scene/Formulation", self.formulation),
            ("Scene/Half width", self.TOP),
            ("Scene/Wall height", short(head)),
            ("Scene/Outlet half width", self.OUTLET),
            ("Scene/Hopper height", short(height)),
            ("Scene/Fall region depth", 0.3),
            ("Scene/Cell type", "quadrilateral"),
            ("Scene/Element size", 0.05),
            ("Scene/Outlet element size", 0),
            ("Scene/Particles per cell", 9),
            ("Scene/Headroom", self.HEADROOM),
            ("Material/Young modulus", short(500 * WEIGHT * (height + head))),
            ("Material/Internal friction angle", short(self.friction)),
            ("Material/Yield cone", self.cone),
            ("Walls/Friction angles",
             f"wall: 0, hopper: {short(self.wall_friction)}"),
            ("Walls/Tangential penalty", 1e9),
            ("Particle stage/Loosest density", short(self.loosest_density)),
            ("Particle stage/End time", self.times[1]),
            ("Output/Interval", 0.1)))


PAPER_WEDGES = [Hopper("plane strain", "paper", friction, half_angle, wall)
                for friction, half_angle, walls in (
                    (25., 10., (5., 10., 15., 20.)), (25., 20., (5., 10., 20.)),
                    (30., 10., (5., 10., 20.)), (30., 20., (5., 10., 20.)))
                for wall in walls]
# The angles that act in plane flow when the paper's cone gets 25 and 30 degrees
PLANE_WEDGES = [wedge._replace(cone="plane strain",
                               friction=wedge.effective_friction)
                for wedge in PAPER_WEDGES if wedge.wall_friction == 10.]
CONICAL = [Hopper("axisymmetric", "Matsuoka-Nakai", *angles)
           for angles in ((40., 15., 20.), (50., 20., 20.), (40., 15., 10.))]
HOPPERS = PAPER_WEDGES + PLANE_WEDGES + CONICAL
# Where material separates as soon as it is less dense than without stress
SEPARATING = [hopper._replace(loosest_density=1.)
              for hopper in (*PAPER_WEDGES[:4], PAPER_WEDGES[7], CONICAL[0])]

SILOS = {"plane-flat-bottom": "plane, flat bottom",
         "plane-hopper": "plane, hopper",
         "axisymmetric-flat-bottom": "axisymmetric, flat bottom",
         "axisymmetric-hopper": "axisymmetric, hopper"}
SILO_FRICTIONS = (25, 35)
SILO_TIMES = {"plane": (0.5, 1.), "axisymmetric": (0.3, 0.6)}  # s


def silo_times(silo):
    return SILO_TIMES[silo.split("-", maxsplit=1)[0]]


def silo_run(silo, cone, friction):
    start, end = silo_times(silo)
    return study_run(
        NAME, f"{silo}-{cone.replace(' ', '-')}-{friction}",
        f"{silo}-mesh-2-auto", (
            ("Material/Internal friction angle", friction),
            ("Material/Yield cone", cone),
            ("Particle stage/End time", end),
            ("Output/Interval", end - start)), WITHOUT_FIELDS)


def silo_cases():
    return [(silo, cone, friction) for silo in SILOS
            for friction in SILO_FRICTIONS for cone in CONES]




def unit_scene(young_modulus, penalty=10):
    """The walls' penalty is as many times as stiff as a metre of the material;
    in the default scene, ten times."""
    return (("Scene/Gravity", "0, -1"), ("Scene/Headroom", 0.1),
            ("Material/Density", 1),
            ("Material/Young modulus", young_modulus),
            ("Walls/Tangential penalty", penalty * young_modulus))


NO_SLIP = (("Walls/Friction angle", 89),)
RISE = 0.28  # mu_2 - mu_s


def mu_i(slow, grain):
    """mu_s and the grains' diameter."""
    phi, phi_2 = (math.degrees(math.atan(mu)) for mu in (slow, slow + RISE))
    return (("Material/Model", "mu(I)"),
            ("Material/Internal friction angle", short(phi)),
            ("Material/Law constants",
             f"phi_2: {short(phi_2)}, I_0: 0.4, d: {short(grain)}, rho_s: 1"))


FILL = 4.5
HOURGLASS_TIMES = (1., 3.)
HOURGLASS = {0.157: 0.29774, 0.235: 0.51529, 0.313: 0.77562, 0.391: 1.06707,
             0.470: 1.38452, 0.548: 1.72337}  # half hole: rate
REFINED = 0.313


def box_settings(half_width, outlet, element, penalty=10):
    """A box filled to FILL without slip; `element`: at the outlet."""
    return (*unit_scene(1e3 * FILL, penalty), *NO_SLIP,
            ("Scene/Half width", half_width),
            ("Scene/Wall height", FILL),
            ("Scene/Outlet half width", outlet),
            ("Scene/Fall region depth", 3 * outlet),
            ("Scene/Element size", 0.15),
            ("Scene/Outlet element size", short(element)))


def hourglass_run(outlet, refinement=1):
    end = HOURGLASS_TIMES[1]
    return run_of(f"hourglass-{outlet}-{refinement}", (
        # With 10, the finer mesh finds no state at rest.
        *box_settings(2.5, outlet, outlet / 8, penalty=1),
        *mu_i(0.32, 1 / 30),
        ("Scene/Refinement", refinement),
        ("Particle stage/End time", end), ("Output/Interval", end)))


COHESIVE_TIMES = (3.5, 4.5)
# mu_s: cohesion: rate at t = 4, and whether that is creep
COHESIVE = {
    0.1: {0.: 1.950, 0.25: 1.488, 0.30: 1.378, 0.50: 0.725},
    0.2: {0.: 1.684, 0.15: 1.387, 0.30: 0.979, 0.50: 0.065},
    0.3: {0.: 1.429, 0.15: 1.088, 0.25: 0.723, 0.30: 0.429},
    0.4: {0.: 1.219, 0.05: 1.112, 0.15: 0.813, 0.25: 0.206, 0.30: 0.060},
    0.5: {0.: 1.081, 0.15: 0.580, 0.25: 0.057}}
ARRESTED = 0.1  # rates below are creep


def cohesive_run(slow, cohesion):
    end = COHESIVE_TIMES[1]
    return run_of(f"cohesive-{slow}-{cohesion}", (
        *box_settings(5., 0.5, 1 / 16),
        *mu_i(slow, 1 / 30),
        ("Walls/Outlet lip", "floor"),  # without slip up to its edge
        ("Material/Cohesion", cohesion),
        ("Particle stage/End time", end), ("Output/Interval", end)))


def cohesive_cases():
    return [(slow, cohesion) for slow, rates in COHESIVE.items()
            for cohesion in rates]


class Plug(NamedTuple):
    """Half of the slot's width and the radius are 1, as is the height."""
    formulation: str
    limit: float  # cohesion

    SHARES = (0.6, 0.7, 0.8, 0.9, 0.97, 1.03)
    END = 1.5

    @property
    def mass(self):
        return math.pi if self.formulation == "axisymmetric" else 2.

    def run(self, share):
        return run_of(f"plug-{self.formulation.replace(' ', '-')}-{share}", (
            *unit_scene(2e3), *NO_SLIP,
            ("Scene/Formulation", self.formulation),
            ("Scene/Cell type", "quadrilateral"),
            ("Scene/Half width", 3), ("Scene/Wall height", 1),
            ("Scene/Outlet half width", 1),
            ("Scene/Fall region depth", 1.5),
            ("Scene/Element size", 0.04), ("Scene/Outlet element size", 0),
            ("Material/Internal friction angle", 0),
            ("Material/Yield cone", "plane strain"),
            ("Material/Cohesion", short(share * self.limit)),
            ("Particle stage/End time", self.END),
            ("Output/Interval", self.END)))


PLUGS = (Plug("plane strain", 1.), Plug("axisymmetric", 0.5))


def all_runs():
    return ([hopper.run() for hopper in HOPPERS + SEPARATING] +
            [silo_run(*case) for case in silo_cases()] +
            [hourglass_run(outlet) for outlet in HOURGLASS] +
            [hourglass_run(REFINED, 2)] +
            [cohesive_run(*case) for case in cohesive_cases()] +
            [plug.run(share) for plug in PLUGS for share in plug.SHARES])
