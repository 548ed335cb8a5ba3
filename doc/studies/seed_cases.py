"""The runs of the study of mesh seeds."""
from study_runs import WITHOUT_FIELDS, auto_scene, study_run
from runs import SILOS, Run, lip_run
from tables import TITLES

NAME = "mesh-seeds"
SEEDS = (1, 2, 3)
ALGORITHMS = ("Frontal-Delaunay", "Delaunay")
LIP_ON_FLOOR = "plane-flat-bottom-lip-on-floor"
# Shorter than the scenes' own; long enough for the steady stretch.
END_TIMES = {"axisymmetric-flat-bottom": 0.8, "axisymmetric-hopper": 0.8}
CASES = {**{silo: TITLES[silo] for silo in SILOS},
         LIP_ON_FLOOR: TITLES[SILOS[0]] + ", lip on the floor"}


def seed_run(case, algorithm, seed):
    """Gmsh's usual choice is that of the scene's own run."""
    has_lip_on_floor = case == LIP_ON_FLOOR
    scene = auto_scene(SILOS[0] if has_lip_on_floor else case, 3)
    is_scene_itself = (algorithm, seed) == (ALGORITHMS[0], SEEDS[0])
    if is_scene_itself and case not in END_TIMES:
        return lip_run(3, "floor") if has_lip_on_floor else Run(scene, scene)
    settings = [("Scene/Mesh algorithm", algorithm),
                ("Scene/Mesh seed", seed)]
    if has_lip_on_floor:
        settings.append(("Walls/Outlet lip", "floor"))
    if case in END_TIMES:
        settings.append(("Particle stage/End time", END_TIMES[case]))
    run = study_run(NAME, f"{case}-{algorithm}-{seed}", scene, settings)
    return run._replace(settings=run.settings + WITHOUT_FIELDS)


def runs():
    return [seed_run(case, algorithm, seed) for case in CASES
            for algorithm in ALGORITHMS for seed in SEEDS]
