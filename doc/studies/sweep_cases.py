"""The silos of the outlet sweep and their runs."""
import math
from typing import NamedTuple

from study_runs import WITHOUT_OUTPUT, auto_scene, study_run

NAME = "outlet-sweep"
LIPS = ("floor", "free")
PLANE_SCENE = auto_scene("plane-flat-bottom", 3)
AXISYMMETRIC_SCENE = auto_scene("axisymmetric-flat-bottom", 3)
PLANE_OUTLETS = (0.10, 0.15, 0.20, 0.25, 0.30, 0.35)
FINE_OUTLETS = (0.10, 0.125, 0.15)
AXISYMMETRIC_OUTLETS = (0.025, 0.03125, 0.0375, 0.04375, 0.05, 0.0625)


class Silo(NamedTuple):
    """Lengths in m, the time in s. With a reference these are for that half
    width of the outlet; for others the whole silo is scaled, and the time with
    the root, so that all silos are geometrically similar."""
    title: str
    scene: str
    half_width: float
    wall_height: float
    fall_depth: float
    end_time: float
    element: float
    outlets: tuple  # half widths
    reference: float = None

    @property
    def is_plane(self):
        return self.scene == PLANE_SCENE

    @property
    def exponent(self):
        """Beverloo's."""
        return 1.5 if self.is_plane else 2.5

    def scale(self, outlet):
        return outlet / self.reference if self.reference else 1.

    def relative_outlet(self, outlet):
        return outlet / (self.half_width * self.scale(outlet))


SILOS = {
    "plane": Silo("plane", PLANE_SCENE, 1.0, 2.4, 0.65, 1.6, 0.025,
                  PLANE_OUTLETS),
    "plane-similar": Silo("plane, similar", PLANE_SCENE, 0.8, 1.7, 0.65, 1.2,
                          0.025, PLANE_OUTLETS, 0.2),
    "plane-fine": Silo("plane, similar, fine mesh", PLANE_SCENE, 0.8, 1.7,
                       0.65, 1.2, 0.0125, FINE_OUTLETS, 0.2),
    "axisymmetric": Silo("axisymmetric", AXISYMMETRIC_SCENE, 0.15, 0.35,
                         0.075, 0.55, 0.003125, AXISYMMETRIC_OUTLETS),
}
PLANE = tuple(key for key, silo in SILOS.items() if silo.is_plane)
AXISYMMETRIC = tuple(key for key, silo in SILOS.items() if not silo.is_plane)


def sweep_run(key, lip, outlet):
    silo = SILOS[key]
    scale = silo.scale(outlet)
    settings = (("Scene/Half width", round(scale * silo.half_width, 6)),
                ("Scene/Wall height", round(scale * silo.wall_height, 6)),
                ("Scene/Fall region depth", round(scale * silo.fall_depth, 6)),
                ("Scene/Element size", silo.element),
                ("Scene/Outlet half width", outlet),
                ("Walls/Outlet lip", lip),
                ("Particle stage/End time",
                 round(math.sqrt(scale) * silo.end_time, 4)))
    run = study_run(NAME, f"{key}-{lip}-{outlet:g}", silo.scene, settings)
    return run._replace(settings=run.settings + WITHOUT_OUTPUT)


def runs():
    return [sweep_run(key, lip, outlet) for key, silo in SILOS.items()
            for lip in LIPS for outlet in silo.outlets]
