"""The generated tables, as Markdown, from the runs' output."""
import re

import paper_data
import run_output
from runs import (DENSITY_UPDATES, MESHES, OUTPUT, SILOS, density_run,
                  lip_run, paper_runs, scene_name)

TITLES = {
    "plane-flat-bottom": "plane, flat bottom",
    "plane-hopper": "plane, hopper",
    "axisymmetric-flat-bottom": "axisymmetric, flat bottom",
    "axisymmetric-hopper": "axisymmetric, hopper",
    "plane-section-5.3": "Section 5.3",
}


def markdown(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "\n".join("| " + " | ".join(map(str, line)) + " |"
                     for line in lines)


def number(value, form=".4g"):
    return "–" if value is None else format(value, form)


def title_of(run):
    """For example: plane, hopper, mesh 2 | auto"""
    silo = next(silo for silo in TITLES if run.scene.startswith(silo))
    mesh = next((f", mesh {mesh}" for mesh in MESHES
                 if f"mesh-{mesh}" in run.scene), "")
    return TITLES[silo] + mesh


def outcome(summary):
    if summary is None:
        return "not run"
    if summary["status"] == "finished":
        return "finished"
    time = re.search(r"t = ([\d.e-]+) s", summary["message"]).group(1)
    return f"breaks down at {float(time):.3g} s"


def summary_of(directory):
    if not run_output.has_ended(directory):
        return None
    return run_output.read_summary(directory)


def scene_row(run):
    summary = summary_of(run.directory)
    head = [title_of(run), "auto" if run.scene.endswith("-auto") else "paper"]
    if summary is None:
        return head + 9 * ["–"] + [outcome(summary)]
    return head + [
        summary["steps"],
        number(summary["end_time_s"], ".3g"),
        number(summary["flow_rate_plateau_kg_per_s"]),
        number(run_output.discharge_time(run.directory), ".3g"),
        number(summary["mass_in_silo_kg"] / summary["mass_initial_kg"],
               ".3f"),
        number(summary["mass_lost_kg"], "g"),
        number(summary["mass_balance_error"], ".0e"),
        number(run_output.largest(run.directory,
                                  "largest_speed_m_per_s"), ".3g"),
        number(summary["particle_steps_per_second"] / 1e6, ".2f"),
        outcome(summary)]


def scenes():
    head = ["scene", "time step", "steps", "simulated, s",
            "plateau, kg/s or kg/(s m)", "empty after, s", "mass left, share",
            "mass lost, kg", "mass balance", "largest speed, m/s",
            "10⁶ particle-steps/s", "outcome"]
    runs = sorted(paper_runs())
    return markdown(head, [scene_row(run) for silo in TITLES for run in runs
                           if run.scene.startswith(silo)])


def mesh_data(silos):
    """Tables I and III: paper / here."""
    rows = []
    for silo in silos:
        for i, (size, *counts) in enumerate(paper_data.MESH_DATA[silo]):
            directory = OUTPUT / (silo if silo == "plane-section-5.3"
                                  else scene_name(silo, i + 1, True))
            ours = counts_of(directory)
            rows.append([TITLES[silo], i + 1, f"{1e3 * size:g}"] +
                        [f"{a} / {b}" for a, b in zip(counts, ours)])
    return markdown(["silo", "mesh", "element size, mm", "nodes", "elements",
                     "material points"], rows)


def counts_of(directory):
    """Nodes, elements and material points at the start."""
    if not run_output.has_ended(directory):
        return 3 * ["–"]
    return [run_output.count_points(directory, "grid"),
            run_output.read_summary(directory)["cells"],
            run_output.count_points(directory, "particles")]


def time_steps(silos):
    """Tables II and IV beside the critical steps that the runs met."""
    rows = []
    for silo in silos:
        for mesh in MESHES:
            table, automatic = (scene_directory(silo, mesh, is_automatic)
                                for is_automatic in (False, True))
            rows.append(
                [TITLES[silo], mesh, paper_data.TIME_STEPS[silo][mesh - 1],
                 number(largest_share(table), ".2f"),
                 number(mean_step(automatic), ".2e"),
                 number(largest_share(automatic), ".2f"),
                 f"{steps(table)} / {steps(automatic)}"])
    return markdown(["silo", "mesh", "paper's time step, s",
                     "its largest share of the critical step",
                     "mean automatic step, s",
                     "its largest share of the critical step",
                     "steps, paper's / automatic"], rows)


def scene_directory(silo, mesh, is_automatic):
    return OUTPUT / scene_name(silo, mesh, is_automatic)


def largest_share(directory):
    if not run_output.has_ended(directory):
        return None
    return run_output.largest(directory, "time_step_over_critical")


def mean_step(directory):
    """While there is material; an empty silo has no critical step."""
    if not run_output.has_ended(directory):
        return None
    history = run_output.read_table(directory, "history.csv")
    time, step = next(
        ((time, step) for time, step, mass in
         zip(history["time_s"], history["step"], history["mass_in_silo_kg"])
         if time > 0 and mass <= 0),
        (history["time_s"][-1], history["step"][-1]))
    return time / step


def steps(directory):
    summary = summary_of(directory)
    return "–" if summary is None else summary["steps"]


def run_time(directory):
    summary = summary_of(directory)
    if summary is None:
        return "–"
    total = run_output.seconds_of(summary, *run_output.RUN_PARTS)
    return f"{total:.0f} s for {summary['end_time_s']:.3g} s"


def run_times():
    rows = []
    for silo in SILOS:
        hours, simulated = paper_data.COMPUTATION[silo]
        rows.append([TITLES[silo], f"{hours:g} h for {simulated:g} s"] +
                    [run_time(scene_directory(silo, 3, is_automatic))
                     for is_automatic in (False, True)])
    return markdown(["silo, mesh 3", "paper", "here, paper's time step",
                     "here, automatic step"], rows)


def plateaus(silo):
    """Figures 5 and 9: the three meshes' rates beside Beverloo's."""
    rows = [[f"mesh {mesh}"] +
            [number(run_output.plateau(scene_directory(silo, mesh, automatic)))
             for automatic in (False, True)] for mesh in MESHES]
    table = run_output.read_table(scene_directory(silo, 1, False),
                                  "flow_rate.csv")
    for ratio in ("0", "0.1", "0.2"):
        rate = number(table[f"beverloo_{ratio}_kg_per_s"][0])
        rows.append([f"Beverloo, d/D = {ratio}", rate, rate])
    unit = "kg/(s m)" if silo.startswith("plane") else "kg/s"
    return markdown([TITLES[silo], f"paper's time step, {unit}",
                     f"automatic step, {unit}"], rows)


def discharge_times():
    rows = [["paper, updated-Lagrangian finite elements",
             number(paper_data.DISCHARGE_TIME_FINITE_ELEMENTS)],
            ["paper, particle-in-cell",
             number(paper_data.DISCHARGE_TIME["plane-section-5.3"])]]
    for name, step in (("plane-section-5.3", "0.001 s"),
                       ("plane-section-5.3-auto", "automatic")):
        rows.append([f"here, time step {step}",
                     number(run_output.discharge_time(OUTPUT / name), ".3g")])
    return markdown(["Section 5.3", "empty after, s"], rows)


def empty_times(silo):
    """When the three meshes' silos are empty, paper's / automatic step."""
    rows = []
    for mesh in MESHES:
        times = [number(run_output.discharge_time(
            scene_directory(silo, mesh, is_automatic)), ".3g")
            for is_automatic in (False, True)]
        rows.append([f"here, mesh {mesh}", " / ".join(times)])
    return rows


def hopper_times():
    rows = [["paper, mesh 3",
             number(paper_data.DISCHARGE_TIME["plane-hopper"])],
            *empty_times("plane-hopper")]
    return markdown(["plane hopper",
                     "empty after, s (paper's / automatic step)"], rows)


def cone_times():
    return markdown(["conical hopper",
                     "empty after, s (paper's / automatic step)"],
                    empty_times("axisymmetric-hopper"))


def density():
    rows = []
    for silo, time in (("plane-flat-bottom", 1.0),
                       ("axisymmetric-flat-bottom", 0.5)):
        for update in DENSITY_UPDATES:
            row = [TITLES[silo], update]
            for is_automatic in (False, True):
                run = density_run(silo, update, is_automatic)
                row += density_cells(run, time)
            rows.append(row)
    return markdown(["scene", "update", "paper's step: rate", "outcome",
                     "automatic step: rate", "outcome"], rows)


def density_cells(run, time):
    rate = run_output.flow_rate_at(run.directory, time)
    return [number(rate), outcome(summary_of(run.directory))]


def lip():
    rows = []
    for mesh in MESHES:
        size = paper_data.MESH_DATA["plane-flat-bottom"][mesh - 1][0]
        rates = [number(run_output.plateau(lip_run(mesh, lip).directory))
                 for lip in ("floor", "free")]
        rows.append([mesh, f"{size:g} m"] + rates)
    return markdown(["mesh", "element size", "lip on the floor, kg/(s m)",
                     "free lip, kg/(s m)"], rows)
