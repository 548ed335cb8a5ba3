"""The walls' tractions at the times of Figures 3, 4, 7 and 8."""
import run_output
from runs import OUTPUT
from tables import markdown, number


def integral_along(rows, column):
    """Over the arc length, by the trapezoidal rule."""
    rows = sorted(rows, key=lambda row: row["arc_length_m"])
    return sum(0.5 * (a[column] + b[column]) *
               (b["arc_length_m"] - a["arc_length_m"])
               for a, b in zip(rows, rows[1:]))


def mean_along(rows, column):
    lengths = [row["arc_length_m"] for row in rows]
    return integral_along(rows, column) / (max(lengths) - min(lengths))


def parts_of_walls(rows):
    """The vertical wall's quarter at the bottom, the rest of it, and the
    hopper or floor, to which the closed outlet belongs at the start."""
    wall = [row for row in rows if row["wall"] == "wall"]
    foot = min(row["y_m"] for row in wall)
    limit = foot + 0.25 * (max(row["y_m"] for row in wall) - foot)
    bottom = ("hopper" if any(row["wall"] == "hopper" for row in rows)
              else "floor")
    return {"wall, lowest quarter":
            [row for row in wall if row["y_m"] <= limit],
            "wall above": [row for row in wall if row["y_m"] > limit],
            bottom: [row for row in rows if row["wall"] == bottom]}


def rows_at(directory, time):
    table = run_output.read_table(directory, "wall_traction.csv")
    nearest = min(set(table["time_s"]), key=lambda t: abs(t - time))
    keys = list(table)
    return [row for row in
            (dict(zip(keys, values)) for values in zip(*table.values()))
            if row["time_s"] == nearest]


def wall_force(directory, time, wall="wall"):
    """Normal force on one wall, the vertical one, in N; plane: per metre."""
    return integral_along([row for row in rows_at(directory, time)
                           if row["wall"] == wall], "normal_Pa")


def mean_over_outputs(directory, start, end, value_at):
    """Mean of value_at(time) over a stretch of time. Each output is a mean over
    the time since the one before."""
    times = sorted(set(run_output.read_table(directory,
                                             "wall_traction.csv")["time_s"]))
    stretches = {end_of_output: min(end, end_of_output) - max(start, before)
                 for before, end_of_output in zip(times, times[1:])}
    weights = {time: weight for time, weight in stretches.items() if weight > 0}
    return (sum(weight * value_at(time) for time, weight in weights.items()) /
            sum(weights.values()))


def mean_wall_force(directory, start, end, wall="wall"):
    """wall_force(), mean over a stretch of time."""
    return mean_over_outputs(directory, start, end,
                             lambda time: wall_force(directory, time, wall))


def tractions(name, times):
    """Normal / tangential means in kPa."""
    if not run_output.has_ended(OUTPUT / name):
        return markdown(["not run"], [])
    lines, head = [], []
    for time in times:
        parts = parts_of_walls(rows_at(OUTPUT / name, time))
        head = ["time, s"] + list(parts)
        line = [f"{time:g}"]
        for rows in parts.values():
            normal, tangential = (mean_along(rows, column) / 1e3 for column in
                                  ("normal_Pa", "tangential_Pa"))
            line.append(f"{number(normal, '.3g')} / "
                        f"{number(tangential, '.3g')}")
        lines.append(line)
    return markdown(head, lines)


def sign_change(name, times):
    """Where on the vertical wall the tangential traction is negative."""
    head = ["time, s", "nodes with negative traction / all",
            "between the heights, m", "lowest tangential traction, Pa",
            "at the height, m"]
    if not run_output.has_ended(OUTPUT / name):
        return markdown(["not run"], [])
    lines = []
    for time in times:
        wall = [row for row in rows_at(OUTPUT / name, time)
                if row["wall"] == "wall"]
        heights = [row["y_m"] for row in wall if row["tangential_Pa"] < 0]
        lowest = min(wall, key=lambda row: row["tangential_Pa"])
        line = [f"{time:g}", f"{len(heights)} / {len(wall)}"]
        if heights:
            line += [f"{min(heights):.3g} to {max(heights):.3g}",
                     number(lowest["tangential_Pa"], ".0f"),
                     number(lowest["y_m"], ".3g")]
        lines.append(line + ["–"] * (len(head) - len(line)))
    return markdown(head, lines)
