"""The runs of the study of mesh seeds."""
from study_runs import WITHOUT_FIELDS, auto_scene, study_run
from runs import SILOS, Run

NAME = "mesh-seeds"
SEEDS = (1, 2, 3)
ALGORITHMS = ("Frontal-Delaunay", "Delaunay")


def seed_run(silo, algorithm, seed):
    """Gmsh's usual choice is that of the scene's own run."""
    scene = auto_scene(silo, 3)
    if (algorithm, seed) == (ALGORITHMS[0], SEEDS[0]):
        return Run(scene, scene)
    run = study_run(NAME, f"{silo}-{algorithm}-{seed}", scene,
                    (("Scene/Mesh algorithm", algorithm),
                     ("Scene/Mesh seed", seed)))
    return run._replace(settings=run.settings + WITHOUT_FIELDS)


def runs():
    return [seed_run(silo, algorithm, seed) for silo in SILOS
            for algorithm in ALGORITHMS for seed in SEEDS]
