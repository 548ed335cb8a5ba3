"""The runs of the study of how a silo is filled, fed and opened."""
from study_runs import WITHOUT_FIELDS, study_run

NAME = "operation"

LAYERS = (1, 2, 4, 8, 16, 25)
SHARES = (25, 50, 75, 100)  # of the outlet that a gate leaves open, %
OUTLET = 0.2  # half width of the whole outlet, m
STEADY_END = 45.  # s
# Of elements, and of those at the lip, in m
FUNNEL_SIZES = {"triangle": (0.05, 0.02), "quadrilateral": (0.025, 0)}


def layer_run(n_layers):
    return study_run(NAME, f"layers-{n_layers}", "../operation/layers",
                     (("Scene/Layers", n_layers),), WITHOUT_FIELDS)


def steady_run():
    return study_run(NAME, "steady", "../operation/refill",
                     (("Stop/Steady within", 0),
                      ("Particle stage/End time", STEADY_END),
                      ("Output/History interval", 0.05)), WITHOUT_FIELDS)


def funnel_run(cell_type):
    """A flat bottom instead of the hopper; as fine at the lip on both cells."""
    size, at_lip = FUNNEL_SIZES[cell_type]
    return study_run(NAME, f"funnel-{cell_type}", "../operation/refill",
                     (("Scene/Hopper height", 0),
                      ("Scene/Wall height", 1),
                      ("Scene/Cell type", cell_type),
                      ("Scene/Element size", size),
                      ("Scene/Outlet element size", at_lip),
                      ("Stop/Steady within", 0),
                      ("Particle stage/End time", STEADY_END),
                      ("Output/History interval", 0.05)), WITHOUT_FIELDS)


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
            [funnel_run(cell_type) for cell_type in FUNNEL_SIZES] +
            [opening_run(share, has_gate) for share in SHARES
             for has_gate in (True, False)])
