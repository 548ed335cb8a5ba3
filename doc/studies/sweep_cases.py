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
    """Lengths in m. The largest outlet is less than 0.35 of the silo wide, and
    lets less than half of the material out before the window ends."""
    title: str
    scene: str
    half_width: float
    wall_height: float
    element: float
    outlets: tuple  # half widths
    exponent: float  # Beverloo's


def variant(title, lip, strain, *others, seeds=(1,)):
    return Variant(title, (("Walls/Outlet lip", lip),
                           ("Particle stage/Volumetric strain", strain),
                           *others), seeds)


VARIANTS = {
    "floor": variant("lip on the floor", "floor", "element"),
    "free": variant("free lip", "free", "element"),
    "averaged": variant("free lip, averaged strain", "free", "averaged",
                        seeds=(1, 2, 3)),
    # The scenes' material is so soft that its weight compresses it by some per
    # cent.
    "stiff": variant("the same, 4 times stiffer", "free", "averaged",
                     ("Material/Young modulus", 4e6), seeds=(1, 2)),
}
SILOS = {
    "plane": Silo("plane", PLANE_SCENE, 1.7, 3.0, 0.025,
                  (0.1, 0.125, 0.15, 0.2, 0.25, 0.3, 0.4), 1.5),
    "axisymmetric": Silo("axisymmetric", AXISYMMETRIC_SCENE, 0.18, 0.36,
                         0.003125, (0.01875, 0.025, 0.03125, 0.0375, 0.04375,
                                    0.05, 0.0625), 2.5),
}


def outlet_time(outlet):
    """sqrt(D/g) in s, of half the width in m."""
    return math.sqrt(2 * outlet / GRAVITY)


def sweep_run(key, kind, outlet, seed):
    silo = SILOS[key]
    end_time = math.ceil(100 * WINDOW[1] * outlet_time(outlet) + 1) / 100
    settings = (("Scene/Half width", silo.half_width),
                ("Scene/Wall height", silo.wall_height),
                ("Scene/Element size", silo.element),
                ("Scene/Outlet half width", outlet),
                ("Scene/Mesh seed", seed),
                ("Particle stage/End time", end_time),
                *VARIANTS[kind].settings)
    run = study_run(NAME, f"{key}-{kind}-{outlet:g}-{seed}", silo.scene,
                    settings)
    return run._replace(settings=run.settings + WITHOUT_OUTPUT)


def cases():
    """Silo, variant, outlet and seed of each run."""
    return [(key, kind, outlet, seed) for key, silo in SILOS.items()
            for kind in reversed(VARIANTS) for seed in VARIANTS[kind].seeds
            for outlet in silo.outlets]


def runs():
    return [sweep_run(*case) for case in cases()]
