"""What the paper states: Tables I to IV, run times and discharge times."""

# Element size in m; nodes, elements and material points of meshes 1 to 3.
MESH_DATA = {
    "plane-flat-bottom": ((0.1, 239, 413, 1480), (0.05, 808, 1489, 5320),
                          (0.025, 2949, 5644, 20344)),
    "plane-hopper": ((0.1, 272, 469, 1704), (0.05, 951, 1755, 6384),
                     (0.025, 3368, 6446, 23552)),
    "axisymmetric-flat-bottom": ((0.0125, 351, 625, 2224),
                                 (0.00625, 1300, 2447, 8776),
                                 (0.003125, 4470, 8640, 30912)),
    "axisymmetric-hopper": ((0.0125, 421, 752, 2732),
                            (0.00625, 1563, 2947, 10776),
                            (0.003125, 5466, 10580, 38672)),
    "plane-section-5.3": ((0.1, 1523, 2876, 11056),),
}

# The steps in the scenes' parameter files, meshes 1 to 3.
TIME_STEPS = {
    "plane-flat-bottom": ("1e-3", "5e-4, after 3 s 2.5e-4",
                          "2.5e-4, after 2 s 1.25e-4"),
    "plane-hopper": ("1e-3", "5e-4", "2.5e-4"),
    "axisymmetric-flat-bottom": ("10e-5", "5e-5",
                                 "2.5e-5, after 1 s 1.25e-5"),
    "axisymmetric-hopper": ("10e-5", "5e-5", "2.5e-5, after 1.2 s 1.25e-5"),
}

# Run time on mesh 3, in hours, and the simulated time in s.
COMPUTATION = {
    "plane-flat-bottom": (17.43, 2.5),
    "plane-hopper": (19.48, 3.09),
    "axisymmetric-flat-bottom": (105.1, 2.0),
    "axisymmetric-hopper": (83.3, 1.4),
}

# In s.
DISCHARGE_TIME = {"plane-hopper": 3.09, "plane-section-5.3": 7.13}
DISCHARGE_TIME_FINITE_ELEMENTS = 7.90
