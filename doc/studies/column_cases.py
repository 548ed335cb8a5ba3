"""Columns that collapse behind a gate, for the studies of work and mesh seeds:
their meshes and runs. tests/hard/column_collapse.cc has the same case."""
import math
import pathlib
import subprocess
from typing import NamedTuple

from study_runs import auto_scene, output_of, study_run
from sweep_cases import GRAVITY

GEOMETRY = pathlib.Path(__file__).with_name("column.geo")
WIDTH = 0.1  # half width or radius, m
GMSH_ALGORITHMS = {"Frontal-Delaunay": 6, "Delaunay": 5}  # their numbers


class Column(NamedTuple):
    title: str
    formulation: str
    aspect_ratio: float  # height over WIDTH
    floor: float  # its length over WIDTH
    law: str  # run-out over WIDTH in experiments (lube2004, lube2005)

    @property
    def height(self):
        return self.aspect_ratio * WIDTH


# Not taller: against a gate as rough as they are, columns find no state at
# rest on some fine meshes, the axisymmetric one with a = 2 neither with
# triangles nor with squares.
COLUMNS = {
    "plane-column-1": Column("plane, a = 1", "plane strain", 1., 3.8,
                             "1.2 a = 1.2"),
    # Between the laws for low and tall columns.
    "plane-column-2": Column("plane, a = 2", "plane strain", 2., 5.6,
                             "1.2 a = 2.4 to 1.9 a^(2/3) = 3.02"),
    "axisymmetric-column-1": Column("axisymmetric, a = 1", "axisymmetric", 1.,
                                    3.9, "1.24 a = 1.24"),
}


class ColumnMesh(NamedTuple):
    key: str  # of COLUMNS
    cells: int  # in the half width
    has_squares: bool = False
    algorithm: str = "Frontal-Delaunay"
    seed: int = 1

    @property
    def file(self):
        kind = "squares" if self.has_squares else self.algorithm
        return (output_of("columns") /
                f"{self.key}-{self.cells}-{kind}-{self.seed}.msh")

    def make(self):
        """With Gmsh, where that has not been done."""
        if (self.file.exists() and
                self.file.stat().st_mtime > GEOMETRY.stat().st_mtime):
            return
        column = COLUMNS[self.key]
        size = WIDTH / self.cells
        lengths = {"width": WIDTH, "height": column.height,
                   "length": column.floor * WIDTH,
                   "top": 1.2 * column.height + 2. * size, "size": size}
        options = {**lengths, "squares": int(self.has_squares),
                   "Mesh.Algorithm": GMSH_ALGORITHMS[self.algorithm],
                   "Mesh.RandomSeed": self.seed}
        self.file.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run(["gmsh", str(GEOMETRY), "-2", "-v", "0", "-o",
                        str(self.file)] +
                       [text for name, value in options.items()
                        for text in ("-setnumber", name, f"{value:.9g}")],
                       check=True)


def column_run(study, name, mesh, settings):
    """The material is that of the silo; its scene's other lengths count for
    nothing beside a mesh file."""
    column = COLUMNS[mesh.key]
    end_time = round(8. * math.sqrt(column.height / GRAVITY), 3)
    return study_run(study, name, auto_scene("plane-flat-bottom", 1), (
        ("Scene/Formulation", column.formulation),
        ("Scene/Shape", "mesh file"),
        ("Scene/Mesh file", mesh.file),
        # As rough as the sand: 25 degrees on the cone of Drucker and Prager
        # are 30 degrees of Coulomb friction in plane flow.
        ("Walls/Friction angle", 30),
        ("Particle stage/End time", end_time),
        ("Output/Interval", end_time),
        ("Output/Grid", "false"),
        ("Output/Walls", "false"),
        *settings))
