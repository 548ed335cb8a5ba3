"""The runs of the study of mesh seeds."""
from study_runs import WITHOUT_FIELDS, auto_scene, study_run
from runs import SILOS, Run, lip_run
from tables import TITLES

NAME = "mesh-seeds"
SEEDS = (1, 2, 3)
ALGORITHMS = ("Frontal-Delaunay", "Delaunay")
FREE_LIP = "plane-flat-bottom-free-lip"
# Shorter than the scenes' own; long enough for the steady stretch.
END_TIMES = {"axisymmetric-flat-bottom": 0.8, "axisymmetric-hopper": 0.8}
CASES = {SILOS[0]: TITLES[SILOS[0]],
         FREE_LIP: TITLES[SILOS[0]] + ", free lip",
         **{silo: TITLES[silo] for silo in SILOS[1:]}}


def seed_run(case, algorithm, seed):
    """Gmsh's usual choice is that of the scene's own run."""
    has_free_lip = case == FREE_LIP
    scene = auto_scene(SILOS[0] if has_free_lip else case, 3)
    is_scene_itself = (algorithm, seed) == (ALGORITHMS[0], SEEDS[0])
    if is_scene_itself and case not in END_TIMES:
        return lip_run(3, "free") if has_free_lip else Run(scene, scene)
    settings = [("Scene/Mesh algorithm", algorithm),
                ("Scene/Mesh seed", seed)]
    if has_free_lip:
        settings.append(("Walls/Outlet lip", "free"))
    if case in END_TIMES:
        settings.append(("Particle stage/End time", END_TIMES[case]))
    run = study_run(NAME, f"{case}-{algorithm}-{seed}", scene, settings)
    return run._replace(settings=run.settings + WITHOUT_FIELDS)


def runs():
    return [seed_run(case, algorithm, seed) for case in CASES
            for algorithm in ALGORITHMS for seed in SEEDS]
