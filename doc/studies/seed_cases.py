"""The runs of the study of mesh seeds."""
from study_runs import WITHOUT_FIELDS, auto_scene, study_run

NAME = "mesh-seeds"
SEEDS = (1, 2, 3)
ALGORITHMS = ("Frontal-Delaunay", "Delaunay")

# The hoppers until they are empty; flat bottoms to the end of their plateau.
END_TIMES = {"plane-flat-bottom": 2.0, "plane-hopper": 3.0,
             "axisymmetric-flat-bottom": 1.2, "axisymmetric-hopper": 2.0}


def seed_run(silo, algorithm, seed):
    settings = (("Scene/Mesh algorithm", algorithm),
                ("Scene/Mesh seed", seed),
                ("Particle stage/End time", END_TIMES[silo]))
    run = study_run(NAME, f"{silo}-{algorithm}-{seed}", auto_scene(silo, 3),
                    settings)
    return run._replace(settings=run.settings + WITHOUT_FIELDS)


def runs():
    return [seed_run(silo, algorithm, seed) for silo in END_TIMES
            for algorithm in ALGORITHMS for seed in SEEDS]
