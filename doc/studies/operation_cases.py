"""The runs of the study of how a silo is filled, fed and opened."""
from study_runs import WITHOUT_FIELDS, study_run

NAME = "operation"

LAYERS = (1, 2, 4, 8, 16, 32)
SHARES = (25, 50, 75, 100)  # of the outlet that a gate leaves open, %
OUTLET = 0.2  # half width of the whole outlet, m
STEADY_END = 45.  # s


def layer_run(n_layers):
    return study_run(NAME, f"layers-{n_layers}", "../operation/layers",
                     (("Scene/Layers", n_layers),), WITHOUT_FIELDS)


def steady_run():
    return study_run(NAME, "steady", "../operation/refill",
                     (("Stop/Steady within", 0),
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
            [opening_run(share, has_gate) for share in SHARES
             for has_gate in (True, False)])
