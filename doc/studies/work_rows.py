"""A run's row of the work study, and its error beside the reference."""
import run_output
from work_cases import REFERENCES

MEASURED = ("flow_rate", "tenth_time", "wall_at_rest", "wall_in_flow",
            "run_out")


def work_row(key, method, element, mesh, directory, measured):
    """`measured(directory)`: what of MEASURED the scene has."""
    summary = run_output.read_summary(directory)
    row = {"silo": key, "method": method, "element_m": element, "mesh": mesh,
           "status": summary["status"],
           "steps": summary["steps"],
           "particle_steps": summary["particle_steps"],
           "loop_seconds": summary["loop_seconds"],
           "all_seconds": run_output.seconds_of(summary, "setup", "static",
                                                "loop"),
           **{quantity: None for quantity in MEASURED}}
    if summary["status"] == "finished":
        row.update(measured(directory))
    return row


def references(rows, key, quantity, methods=REFERENCES):
    """What the reference methods give on their two finest meshes: mean of the
    finest, and half the range of all as its uncertainty."""
    chosen = [row for row in rows if row["silo"] == key and
              row["method"] in methods and row["mesh"] >= 2 and
              row[quantity] is not None]
    finest = [row[quantity] for row in chosen if row["mesh"] ==
              max(other["mesh"] for other in chosen)]
    every = [row[quantity] for row in chosen]
    return sum(finest) / len(finest), 0.5 * (max(every) - min(every))


def error_of(rows, row, quantity, methods=REFERENCES):
    if row[quantity] is None:
        return None
    value = references(rows, row["silo"], quantity, methods)[0]
    return row[quantity] / value - 1.


def signed_percent(error):
    return "breaks down" if error is None else f"{100 * error:+.1f} %"


def work(row):
    return (f"{row['particle_steps'] / 1e6:.3g} M, "
            f"{row['all_seconds']:.2g} s")
