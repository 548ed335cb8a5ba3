"""The runs of the study of how a silo is filled, fed and opened."""
from study_runs import WITHOUT_FIELDS, study_run

NAME = "operation"

LAYERS = (1, 2, 4, 8, 16, 25)
SHARES = (25, 50, 75, 100)  # of the outlet that a gate leaves open, %
OUTLET = 0.2  # half width of the whole outlet, m
STEADY_END = 52.  # s
# Cell type, size of elements, and of those at the lip, in m
FUNNELS = {"triangles": ("triangle", 0.05, 0.02),
           "finer triangles": ("triangle", 0.03, 0.02),
           "squares": ("quadrilateral", 0.025, 0)}
RELIEF = ("where fed", "never")  # of overfull cells


def layer_run(n_layers):
    return study_run(NAME, f"layers-{n_layers}", "../operation/layers",
                     (("Scene/Layers", n_layers),), WITHOUT_FIELDS)


def steady_run():
    return study_run(NAME, "steady", "../operation/refill",
                     (("Stop/Steady within", 0),
                      ("Particle stage/End time", STEADY_END),
                      ("Output/History interval", 0.05)), WITHOUT_FIELDS)


def funnel_run(case, relief):
    """A flat bottom instead of the hopper; as fine at the lip on all cells."""
    cell_type, size, at_lip = FUNNELS[case]
    name = case.replace(" ", "-") + ("-crowded" if relief == "never" else "")
    return study_run(NAME, f"funnel-{name}", "../operation/refill",
                     (("Scene/Hopper height", 0),
                      ("Scene/Wall height", 1),
                      ("Scene/Cell type", cell_type),
                      ("Scene/Element size", size),
                      ("Scene/Outlet element size", at_lip),
                      ("Particle stage/Relieve overfull cells", relief),
                      ("Stop/Steady within", 0),
                      ("Particle stage/End time", STEADY_END),
                      ("Output/History interval", 0.05)), WITHOUT_FIELDS)


def funnel_runs():
    """By case and relief."""
    return {(case, relief): funnel_run(case, relief)
            for case in FUNNELS for relief in RELIEF}


def opening_run(share, has_gate):
    """As wide an opening by a gate, or by an outlet of that width."""
    of_opening = ((("Gates/Openings", f"outlet: 0 {share}"),) if has_gate else
                  (("Gates/Openings", ""),
                   ("Scene/Outlet half width", f"{share / 100 * OUTLET:g}")))
    return study_run(NAME, f"{'gate' if has_gate else 'outlet'}-{share}",
                     "../operation/gate",
                     (("Scene/Cell type", "quadrilateral"),
                      ("Scene/Outlet half width", OUTLET),
                      ("Scene/Element size", 0.025),
                      ("Scene/Outlet element size", 0),
                      ("Particle stage/End time", 2.5)) + of_opening,
                     WITHOUT_FIELDS)


def runs():
    return ([layer_run(n) for n in LAYERS] + [steady_run()] +
            list(funnel_runs().values()) +
            [opening_run(share, has_gate) for share in SHARES
             for has_gate in (True, False)])
