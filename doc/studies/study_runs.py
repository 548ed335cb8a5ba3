"""The runs of the studies, in build/study/NAME/."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] /
                       "figures"))

from runs import ROOT, Run, scene_name  # noqa: E402 (after the path)

WITHOUT_FIELDS = ("Output/Particles=false", "Output/Grid=false")
WITHOUT_OUTPUT = WITHOUT_FIELDS + ("Output/Walls=false",)


def output_of(study):
    return ROOT / "build" / "study" / study


def study_run(study, name, scene, settings, without=(), mode=()):
    """Settings: pairs of a parameter and its value. Without: WITHOUT_FIELDS or
    WITHOUT_OUTPUT, what the study does not look at. Mode: see Run."""
    texts = tuple(f"{parameter}={value}" for parameter, value in settings)
    return Run(name, scene, texts + without, output_of(study), mode)


def auto_scene(silo, mesh):
    return scene_name(silo, mesh, True)
