"""The silos of the outlet sweep and their runs."""
from typing import NamedTuple

from study_runs import WITHOUT_OUTPUT, auto_scene, study_run

NAME = "outlet-sweep"
LIPS = ("floor", "free")
PLANE_OUTLETS = (0.10, 0.15, 0.20, 0.25, 0.30, 0.35)
AXISYMMETRIC_OUTLETS = (0.025, 0.03125, 0.0375, 0.04375, 0.05, 0.0625)


class Silo(NamedTuple):
    title: str
    scene: str
    half_width: float
    wall_height: float
    fall_depth: float
    element: float
    outlets: tuple  # half widths
    end_time: float

    @property
    def is_plane(self):
        return self.scene.startswith("plane")

    @property
    def exponent(self):
        """Beverloo's."""
        return 1.5 if self.is_plane else 2.5


SILOS = {
    "plane": Silo("plane", auto_scene("plane-flat-bottom", 3), 1.0, 2.4, 0.65,
                  0.025, PLANE_OUTLETS, 1.6),
    "plane-wide": Silo("plane, wide", auto_scene("plane-flat-bottom", 3), 1.6,
                       3.6, 0.65, 0.025, PLANE_OUTLETS, 1.8),
    "axisymmetric": Silo("axisymmetric",
                         auto_scene("axisymmetric-flat-bottom", 3), 0.15,
                         0.35, 0.075, 0.003125, AXISYMMETRIC_OUTLETS, 1.0),
}

PLANE = tuple(key for key, silo in SILOS.items() if silo.is_plane)
AXISYMMETRIC = tuple(key for key, silo in SILOS.items() if not silo.is_plane)


def sweep_run(key, lip, outlet):
    silo = SILOS[key]
    settings = (("Scene/Half width", silo.half_width),
                ("Scene/Wall height", silo.wall_height),
                ("Scene/Fall region depth", silo.fall_depth),
                ("Scene/Element size", silo.element),
                ("Scene/Outlet half width", outlet),
                ("Walls/Outlet lip", lip),
                ("Particle stage/End time", silo.end_time))
    run = study_run(NAME, f"{key}-{lip}-{outlet:g}", silo.scene, settings)
    return run._replace(settings=run.settings + WITHOUT_OUTPUT)


def runs():
    return [sweep_run(key, lip, outlet) for key, silo in SILOS.items()
            for lip in LIPS for outlet in silo.outlets]
