"""The silos of the outlet sweep and their runs."""
import math
from typing import NamedTuple

from study_runs import WITHOUT_OUTPUT, auto_scene, study_run

NAME = "outlet-sweep"
PLANE_SCENE = auto_scene("plane-flat-bottom", 3)
AXISYMMETRIC_SCENE = auto_scene("axisymmetric-flat-bottom", 3)
GRAVITY = 9.81  # m/s^2

# The rate is taken within these times, in sqrt(D/g): flow starts and spreads in
# the outlet's own time, so that a stretch in seconds would compare the start of
# wide outlets with the later flow of narrow ones.
WINDOW = (3., 5.)


class Variant(NamedTuple):
    title: str
    settings: tuple
    seeds: tuple = (1,)


class Silo(NamedTuple):
    """Similar silos: lengths are multiples of the outlet's half width, and the
    Young modulus goes with it, so that the material's weight compresses it
    alike. Only the element's size in m is the same in all."""
    title: str
    scene: str
    half_width: float
    wall_height: float
    fall_depth: float
    element: float
    outlets: tuple  # half widths in m
    exponent: float  # Beverloo's

    def young_modulus(self, outlet):
        """In Pa; the paper's in the largest silo."""
        return 1e6 * outlet / max(self.outlets)


def variant(title, lip, strain, seeds=(1,), integration="particles"):
    return Variant(title, (("Walls/Outlet lip", lip),
                           ("Particle stage/Volumetric strain", strain),
                           ("Particle stage/Force integration", integration)),
                   seeds)


VARIANTS = {
    "floor": variant("lip on the floor", "floor", "element"),
    "free": variant("free lip", "free", "element"),
    "averaged": variant("free lip, averaged strain", "free", "averaged",
                        seeds=(1, 2, 3)),
    "cell": variant("the same, force by cell", "free", "averaged",
                    integration="cell"),
}
SILOS = {
    "plane": Silo("plane", PLANE_SCENE, 4., 7.5, 2., 0.025,
                  (0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4), 1.5),
    "axisymmetric": Silo("axisymmetric", AXISYMMETRIC_SCENE, 3.5, 7., 2.,
                         0.003125, (0.01875, 0.025, 0.03125, 0.0375, 0.04375,
                                    0.05, 0.0625), 2.5),
}


def outlet_time(outlet):
    """sqrt(D/g) in s, of half the width in m."""
    return math.sqrt(2 * outlet / GRAVITY)


def sweep_run(key, kind, outlet, seed):
    silo = SILOS[key]
    end_time = math.ceil(100 * WINDOW[1] * outlet_time(outlet) + 1) / 100
    settings = (("Scene/Half width", round(silo.half_width * outlet, 9)),
                ("Scene/Wall height", round(silo.wall_height * outlet, 9)),
                ("Scene/Fall region depth", round(silo.fall_depth * outlet, 9)),
                ("Material/Young modulus", silo.young_modulus(outlet)),
                ("Scene/Element size", silo.element),
                ("Scene/Outlet half width", outlet),
                ("Scene/Mesh seed", seed),
                ("Particle stage/End time", end_time),
                *VARIANTS[kind].settings)
    return study_run(NAME, f"{key}-{kind}-{outlet:g}-{seed}", silo.scene,
                     settings, WITHOUT_OUTPUT)


def cases():
    """Silo, variant, outlet and seed of each run."""
    return [(key, kind, outlet, seed) for key, silo in SILOS.items()
            for kind in VARIANTS for seed in VARIANTS[kind].seeds
            for outlet in silo.outlets]


def runs():
    return [sweep_run(*case) for case in cases()]
