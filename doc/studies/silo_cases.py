"""Random closed silos: what the study of them draws, their meshes and runs."""
import math
import random
import subprocess
from pathlib import Path
from typing import NamedTuple

from study_runs import WITHOUT_OUTPUT, auto_scene, output_of, study_run

NAME = "closed-silos"
COUNT = 300
GEOMETRY = Path(__file__).with_name("closed_silo.geo")
INSERTS = ("roof", "diamond", "box", "plate")
KINDS = ("flat bottom", "hopper", *INSERTS)
WEIGHTS = (1, 3, 1, 1, 1, 1)
SPECIFIC_WEIGHT = 1500. * 9.81  # N/m^3


class Silo(NamedTuple):
    seed: int
    kind: str
    formulation: str
    cell_type: str
    half_width: float  # m, as all lengths
    height: float
    outlet: float  # half width; its lid is the bottom
    hopper_angle: float  # from the vertical, degrees
    insert: dict  # parameters of GEOMETRY
    cells: float  # about
    stress_ratio: float  # Young's modulus over the weight of the height
    poisson_ratio: float
    friction_angle: float  # degrees
    wall_friction_angle: float

    @property
    def has_insert(self):
        return self.kind in INSERTS

    @property
    def hopper_height(self):
        if self.kind != "hopper":
            return 0.
        return min(5. * self.half_width, (self.half_width - self.outlet) /
                   math.tan(math.radians(self.hopper_angle)))

    @property
    def size(self):
        """Of elements."""
        area = self.half_width * (self.height + self.hopper_height / 2.)
        is_triangle = self.cell_type == "triangle"
        size = math.sqrt(area / self.cells * (2. if is_triangle else 1.))
        return size if self.has_insert else min(size, self.outlet)

    @property
    def mesh_file(self):
        return output_of(NAME) / f"{self.seed}.msh"


def draw_insert(chance, kind, half_width, height):
    width = half_width * chance.uniform(0.2, 0.5)
    level = height * chance.uniform(0.2, 0.45)
    upper = min(0.9 * height, level + width * chance.uniform(0.5, 2.))
    lower = max(0.2 * level, level - width * chance.uniform(0.2, 1.))
    thickness = 0.15 * width
    heights = {"roof": (upper, level, level, level - 0.05 * width),
               "diamond": (upper, level, level, lower),
               "box": (upper, upper, level, level),
               "plate": (level + thickness, level + thickness, level, level)}
    names = ("upper", "outer_upper", "outer_lower", "lower")
    return {"insert_width": width,
            **dict(zip(names, heights.get(kind, heights["roof"])))}


def draw(seed):
    """The silo of this seed."""
    chance = random.Random(seed)
    kind = chance.choices(KINDS, WEIGHTS)[0]
    half_width = 10 ** chance.uniform(-0.6, 0.6)
    height = half_width * chance.uniform(1., 8.)
    friction_angle = chance.uniform(5., 45.)
    return Silo(seed, kind,
                chance.choice(("plane strain", "axisymmetric")),
                chance.choice(("triangle", "quadrilateral")),
                half_width, height, half_width * chance.uniform(0.05, 0.6),
                chance.uniform(5., 80.),
                draw_insert(chance, kind, half_width, height),
                10 ** chance.uniform(2.3, 3.7), 10 ** chance.uniform(1.6, 3.6),
                chance.uniform(0.2, 0.4), friction_angle,
                chance.uniform(0., friction_angle + 15.))


def silos():
    return [draw(seed) for seed in range(1, COUNT + 1)]


def make_mesh(silo):
    squares = silo.cell_type == "quadrilateral"
    numbers = {"half_width": silo.half_width, "height": silo.height,
               # Each element is divided into squares of half its size.
               "size": silo.size * (2. if squares else 1.),
               "squares": int(squares), **silo.insert}
    arguments = [text for name, value in numbers.items()
                 for text in ("-setnumber", name, str(value))]
    silo.mesh_file.parent.mkdir(parents=True, exist_ok=True)
    subprocess.run(["gmsh", "-2", "-v", "0", str(GEOMETRY), *arguments, "-o",
                    str(silo.mesh_file)], check=True)


def silo_run(silo):
    """The state at rest only."""
    settings = [
        ("Scene/Formulation", silo.formulation),
        ("Scene/Cell type", silo.cell_type),
        ("Scene/Element size", silo.size),
        ("Scene/Outlet", "closed"),
        ("Material/Young modulus",
         silo.stress_ratio * SPECIFIC_WEIGHT * silo.height),
        ("Material/Poisson ratio", silo.poisson_ratio),
        ("Material/Internal friction angle", silo.friction_angle),
        ("Material/Yield cone", "paper"),
        ("Walls/Friction angle", silo.wall_friction_angle),
        ("Particle stage/End time", 0)]
    if silo.has_insert:
        settings += [("Scene/Shape", "mesh file"),
                     ("Scene/Mesh file", silo.mesh_file)]
    else:
        settings += [("Scene/Half width", silo.half_width),
                     ("Scene/Wall height", silo.height),
                     ("Scene/Outlet half width", silo.outlet),
                     ("Scene/Hopper height", silo.hopper_height)]
    return study_run(NAME, str(silo.seed), auto_scene("plane-flat-bottom", 1),
                     settings, WITHOUT_OUTPUT)
