"""The runs of the work-precision study."""
from typing import NamedTuple

from study_runs import WITHOUT_FIELDS, auto_scene, study_run
from sweep_cases import WINDOW, outlet_time

NAME = "work-precision"


class Silo(NamedTuple):
    title: str
    scene: str
    outlet: float  # half width in m
    elements: tuple  # sizes in m; the first three are the paper's meshes


SILOS = {
    "plane": Silo("plane", auto_scene("plane-flat-bottom", 1), 0.225,
                  (0.1, 0.05, 0.025, 0.0125)),
    "axisymmetric": Silo("axisymmetric",
                         auto_scene("axisymmetric-flat-bottom", 1), 0.05,
                         (0.0125, 0.00625, 0.003125, 0.0015625)),
}


class Method(NamedTuple):
    title: str
    settings: tuple
    n_meshes: int = 3
    is_in_plot: bool = False
    lip: int = 1  # Element size / Outlet element size
    silos: tuple = tuple(SILOS)


FLOOR_LIP = (("Walls/Outlet lip", "floor"),)
ELEMENT_STRAIN = (("Particle stage/Volumetric strain", "element"),)
BY_PARTICLES = (("Particle stage/Force integration", "particles"),)
UNSPLIT = (("Particle stage/Split particles", "never"),)
PAPER_DENSITY = (("Particle stage/Density update", "paper"),)
SQUARES = (("Scene/Cell type", "quadrilateral"),)


def particles(number):
    return (("Scene/Particles per cell", number),)


# Each differs from one above it in one respect; the default is "cell-4".
METHODS = {
    "paper": Method("the paper's, automatic step", FLOOR_LIP + ELEMENT_STRAIN +
                    BY_PARTICLES + UNSPLIT + PAPER_DENSITY, 4, True),
    "separation": Method("+ density: separation", FLOOR_LIP +
                         ELEMENT_STRAIN + BY_PARTICLES + UNSPLIT),
    "free": Method("+ free lip", ELEMENT_STRAIN + BY_PARTICLES + UNSPLIT, 4,
                   True),
    "averaged": Method("+ averaged volumetric strain", BY_PARTICLES + UNSPLIT,
                       4, True),
    "averaged-16": Method("averaged strain, 16 particles",
                          BY_PARTICLES + UNSPLIT + particles(16)),
    "unsplit-4": Method("+ force integration by cell", UNSPLIT),
    "unsplit-9": Method("force by cell, 9 particles", UNSPLIT + particles(9),
                        4),
    "cell-4": Method("+ split particles: the default", (), 4, True),
    "cell-9": Method("the default, 9 particles", particles(9), 4, True),
    "cell-16": Method("the default, 16 particles", particles(16)),
    "lip-4": Method("lip a quarter", (), 3, True, 4),
    "lip-4-9": Method("lip a quarter, 9 particles", particles(9), 3, True, 4),
    "lip-4-16": Method("lip a quarter, 16 particles", particles(16), 3, False,
                       4),
    "lip-8-9": Method("lip an eighth, 9 particles", particles(9),
                      3, True, 8),
    "lip-4-unsplit": Method("lip a quarter, not split", UNSPLIT,
                            3, False, 4),
    "element-9": Method("9 particles, element strain", particles(9) +
                        ELEMENT_STRAIN),
    "squares-particles": Method("squares, force by particles",
                                SQUARES + BY_PARTICLES + UNSPLIT,
                                4),
    "squares-4": Method("squares", SQUARES, 4, True),
    "squares-9": Method("squares, 9 particles", SQUARES + particles(9), 4,
                        True),
    "squares-16": Method("squares, 16 particles", SQUARES + particles(16), 4),
    "squares-16-element": Method(
        "squares, 16 particles, element strain", SQUARES + particles(16) +
        ELEMENT_STRAIN),
    "soft-9": Method("the default, 9 particles, a fifth of Young's modulus",
                     particles(9) + (("Material/Young modulus", 2e5),),
                     silos=("axisymmetric",)),
    "half-step": Method("the default, half the step",
                        (("Particle stage/Time step safety", 0.4),)),
    "middle": Method("the default, middle of step",
                     (("Particle stage/Stress integration",
                       "middle of step"),)),
    "mass-0.5": Method("the default, consistent mass share 0.5",
                       (("Particle stage/Consistent mass share", 0.5),)),
}

# The methods whose finest results are the reference: all cures, finest at
# the lip.
REFERENCES = ("lip-4-9", "lip-4-16", "lip-8-9")


def work_run(key, method, element):
    silo = SILOS[key]
    unit = outlet_time(silo.outlet)
    settings = (("Scene/Element size", element),
                ("Particle stage/End time", round(WINDOW[1] * unit + 0.02, 3)),
                # Wall tractions are means over it.
                ("Output/Interval", round(unit, 6)),
                *METHODS[method].settings)
    if METHODS[method].lip > 1:
        settings += (("Scene/Outlet element size",
                      element / METHODS[method].lip),)
    return study_run(NAME, f"{key}-{method}-{element:g}", silo.scene, settings,
                     WITHOUT_FIELDS)


def cases():
    """Silo, method and element size; the coarse meshes first."""
    return [(key, method, silo.elements[mesh]) for mesh in range(4)
            for key, silo in SILOS.items() for method in METHODS
            if mesh < METHODS[method].n_meshes and
            key in METHODS[method].silos]


def runs():
    return [work_run(*case) for case in cases()]
