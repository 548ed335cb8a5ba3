"""The runs of the study of outlets and hoppers that flow or don't."""
import math
from typing import NamedTuple

from study_runs import WITHOUT_OUTPUT, study_run

NAME = "will-it-flow"
SCENE = "../quickstart"
GRAVITY, DENSITY = 9.81, 1500.  # m/s^2, kg/m^3
WEIGHT = GRAVITY * DENSITY  # N/m^3


CELLS = 8  # across an outlet, mostly


def short(value):
    return f"{value:.9g}"


class Arching(NamedTuple):
    """A small plane silo whose smallest outlet is looked for."""
    hopper_angle: float  # from the vertical, degrees; 0: flat bottom
    friction: float  # degrees
    cohesion: float  # Pa
    cells: int = CELLS  # across each outlet tried

    WIDTH = 0.4  # of the silo, m
    HEIGHT = 0.6  # of material, about
    WALL_FRICTION = 20  # degrees
    END = 5.  # of a run, in sqrt(D/g) of Jenike's outlet
    AUTOMATIC_CELLS = 12  # squares across the outlet

    @property
    def arching_width(self):
        """Jenike's."""
        phi = math.radians(self.friction)
        strength = 2 * self.cohesion * math.cos(phi) / (1 - math.sin(phi))
        return (1 + self.hopper_angle / 180) * strength / WEIGHT

    @property
    def first_half_width(self):
        """Below the limit to be found: what is narrower than necessary costs
        most."""
        return self.arching_width / 2 * (0.5 if self.hopper_angle else 0.7)

    @property
    def end_time(self):
        return self.END * math.sqrt(self.arching_width / GRAVITY)

    def run(self):
        half_width, outlet = self.WIDTH / 2, self.first_half_width
        hopper = 0.
        if self.hopper_angle:
            hopper = ((half_width - outlet) /
                      math.tan(math.radians(self.hopper_angle)))
        wall = self.HEIGHT - hopper / 2  # about the same material
        name = (f"arching-{self.hopper_angle:g}-{self.friction:g}-"
                f"{self.cohesion:g}")
        if self.cells != CELLS:
            name += f"-{self.cells}"
        return study_run(
            NAME, name, SCENE, (
                ("Scene/Cell type", "quadrilateral"),
                ("Scene/Half width", half_width),
                ("Scene/Wall height", short(wall)),
                ("Scene/Hopper height", short(hopper)),
                ("Scene/Outlet half width", short(outlet)),
                ("Scene/Fall region depth", 0.1),
                ("Scene/Element size", "auto"),
                ("Scene/Refinement", short(self.cells / self.AUTOMATIC_CELLS)),
                ("Material/Internal friction angle", self.friction),
                ("Material/Yield cone", "Matsuoka-Nakai"),
                ("Material/Cohesion", self.cohesion),
                ("Walls/Friction angle", self.WALL_FRICTION),
                ("Particle stage/End time", short(self.end_time))),
            WITHOUT_OUTPUT, ("--study", "smallest-outlet"))


BOTTOMS = (0., 20.)
FRICTIONS = (25., 35.)
COHESIONS = (400., 600., 800., 1000.)
# Bottom, cohesion and cells across the outlet
REFINED = ((0., 400., 16), (0., 800., 16), (20., 800., 16))


def arching_cases():
    return [Arching(bottom, friction, cohesion) for bottom in BOTTOMS
            for friction in FRICTIONS for cohesion in COHESIONS]


def refined_cases():
    return [Arching(bottom, friction, cohesion, cells)
            for bottom, cohesion, cells in REFINED for friction in FRICTIONS]


def mass_flow_limit(friction, wall_friction):
    """Jenike's for cones, degrees."""
    sine = math.sin(math.radians(friction))
    wall = math.asin(math.sin(math.radians(wall_friction)) / sine)
    return 90 - 0.5 * math.degrees(math.acos((1 - sine) / (2 * sine)) + wall +
                                   math.radians(wall_friction))


class Cone(NamedTuple):
    """A round silo with a conical hopper; angles in degrees."""
    wall_friction: float
    half_angle: float  # to the vertical

    FRICTION = 30
    OUTLET, RADIUS, WALL = 0.1, 0.3, 0.3  # m
    SIZE = 0.0125  # of squares
    DISPLACEMENT = 0.01  # m, up to which material counts as stagnant
    END = 3.  # s, enough for half of the material

    @property
    def limit(self):
        return mass_flow_limit(self.FRICTION, self.wall_friction)

    def run(self):
        height = ((self.RADIUS - self.OUTLET) /
                  math.tan(math.radians(self.half_angle)))
        return study_run(
            NAME, f"cone-{self.wall_friction:g}-{self.half_angle:g}-"
            f"{self.OUTLET:g}", SCENE, (
                ("Scene/Formulation", "axisymmetric"),
                ("Scene/Cell type", "quadrilateral"),
                ("Scene/Half width", self.RADIUS),
                ("Scene/Wall height", self.WALL),
                ("Scene/Outlet half width", self.OUTLET),
                ("Scene/Hopper height", short(height)),
                ("Scene/Fall region depth", 0.2),
                ("Scene/Element size", self.SIZE),
                ("Scene/Particles per cell", 9),
                ("Scene/Headroom", 0.05),
                ("Material/Internal friction angle", self.FRICTION),
                ("Material/Yield cone", "Matsuoka-Nakai"),
                ("Walls/Friction angle", self.wall_friction),
                ("Walls/Tangential penalty", 1e9),
                ("Particle stage/End time", self.END),
                ("Particle stage/On lost particle", "remove"),
                ("Output/Stagnant displacement",
                 short(self.DISPLACEMENT / (2 * self.OUTLET)))),
            WITHOUT_OUTPUT)


CONES = {10.: (20., 30., 40., 45., 50., 55., 60.),
         20.: (10., 20., 25., 30., 35., 40., 50.)}  # wall friction: angles


def cones():
    return [Cone(wall, angle) for wall, angles in CONES.items()
            for angle in angles]
