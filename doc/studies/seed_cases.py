"""The runs of the study of mesh seeds."""
from column_cases import (COLUMNS, GMSH_ALGORITHMS, ColumnMesh,
                          column_run)
from study_runs import WITHOUT_FIELDS, auto_scene, study_run
from runs import SILOS, Run, lip_run
from tables import TITLES

NAME = "mesh-seeds"
SEEDS = (1, 2, 3)
ALGORITHMS = tuple(GMSH_ALGORITHMS)
LIP_ON_FLOOR = "plane-flat-bottom-lip-on-floor"
# Shorter than the scenes' own; long enough for the steady stretch.
END_TIMES = {"axisymmetric-flat-bottom": 0.8, "axisymmetric-hopper": 0.8}
SILO_CASES = {**{silo: TITLES[silo] + ", mesh 3" for silo in SILOS},
              LIP_ON_FLOOR: TITLES[SILOS[0]] + ", mesh 3, lip on the floor"}
COLUMN_CELLS = 40  # in the half width
COLUMN_CASES = {key: f"{column.formulation.split()[0]}, column, "
                     f"a = {column.aspect_ratio:g}"
                for key, column in COLUMNS.items()
                if column.aspect_ratio == 1.}
CASES = {**SILO_CASES, **COLUMN_CASES}


def column_mesh(case, algorithm, seed):
    return ColumnMesh(case, COLUMN_CELLS, False, algorithm, seed)


def seed_run(case, algorithm, seed):
    """Gmsh's usual choice is that of the scene's own run."""
    if case in COLUMN_CASES:
        return column_run(NAME, f"{case}-{algorithm}-{seed}",
                          column_mesh(case, algorithm, seed), ())
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
    return study_run(NAME, f"{case}-{algorithm}-{seed}", scene, settings,
                     WITHOUT_FIELDS)


def cases(of=tuple(CASES)):
    return [(case, algorithm, seed) for case in of
            for algorithm in ALGORITHMS for seed in SEEDS]


def runs():
    return [seed_run(*case) for case in cases()]


def make_column_meshes():
    for case in cases(COLUMN_CASES):
        column_mesh(*case).make()
