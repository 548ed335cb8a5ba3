"""Flow rate and speed over the share of the consistent mass matrix, and the
frequency of an elastic bar."""
import re
import statistics
import subprocess

import run_output
from plots import STYLE, plt, save
from runs import SANDGLASS, make_all
from study_runs import WITHOUT_OUTPUT, auto_scene, output_of, study_run
from tables import markdown, number, outcome

NAME = "mass-matrix"
SHARES = (0, 0.25, 0.5, 0.75, 0.9)
REPETITIONS = (1, 2, 3)
PHYSICS_TESTS = SANDGLASS.parent / "tests" / "physics_tests"
BAR_TEST = "Bar.FrequencyConvergesAndGainsByAConsistentMassShare"
BAR_OUTPUT = output_of(NAME) / "bar.txt"


def mass_run(share, repetition, part):
    """Part: `share`, or `lumped` for the run beside it without one."""
    value = share if part == "share" else 0
    return study_run(NAME, f"{share:g}-{part}-{repetition}",
                     auto_scene("plane-flat-bottom", 2),
                     (("Particle stage/Consistent mass share", value),
                      ("Particle stage/Volumetric strain", "element"),
                      ("Particle stage/Force integration", "particles")),
                     WITHOUT_OUTPUT)


def make_runs():
    """In pairs, whose runs share whatever else the machine does."""
    for repetition in REPETITIONS:
        for share in SHARES:
            make_all([mass_run(share, repetition, part)
                      for part in ("share", "lumped")])
    if PHYSICS_TESTS.exists():
        done = subprocess.run([PHYSICS_TESTS, f"--gtest_filter={BAR_TEST}"],
                              capture_output=True, text=True, check=False)
        BAR_OUTPUT.write_text(done.stdout, encoding="utf-8")


def results():
    rows = []
    for share in SHARES:
        pairs = [tuple(mass_run(share, repetition, part).directory
                       for part in ("share", "lumped"))
                 for repetition in REPETITIONS]
        pairs = [pair for pair in pairs if all(map(run_output.has_ended,
                                                   pair))]
        if pairs:
            rows.append(row_of(share, pairs))
    return rows


def row_of(share, pairs):
    summaries = [tuple(map(run_output.read_summary, pair)) for pair in pairs]
    first = summaries[0][0]
    return {"share": share, "steps": first["steps"],
            "end_time_s": first["end_time_s"],
            "particle_steps_per_second": statistics.median(
                own["particle_steps_per_second"] for own, _ in summaries),
            "speed_over_lumped": statistics.median(
                own["particle_steps_per_second"] /
                lumped["particle_steps_per_second"]
                for own, lumped in summaries),
            "time_over_lumped": statistics.median(
                own["loop_seconds"] / lumped["loop_seconds"]
                for own, lumped in summaries),
            "flow_rate_plateau_kg_per_s": first["flow_rate_plateau_kg_per_s"],
            "steady_flow_rate_kg_per_s": first["steady_flow_rate_kg_per_s"],
            "outcome": outcome(first), "message": first.get("message") or ""}


def flow(rows):
    return markdown(
        ["share", "steps", "10⁶ particle-steps/s", "speed over that of 0",
         "run time over that of 0", "plateau, kg/(s m)",
         "steady rate, kg/(s m)", "outcome"],
        [[f"{row['share']:g}", row["steps"],
          number(row["particle_steps_per_second"] / 1e6, ".2f"),
          number(row["speed_over_lumped"], ".2f"),
          number(row["time_over_lumped"], ".1f"),
          number(row["flow_rate_plateau_kg_per_s"]),
          number(row["steady_flow_rate_kg_per_s"]),
          row["outcome"]] for row in rows])


def bar(_):
    """From what the test of the bar prints."""
    if not BAR_OUTPUT.exists():
        return markdown(["share", "not run"], [])
    found = re.findall(r"errors of the frequency with 8, 16, 32 elements (.*)",
                       BAR_OUTPUT.read_text(encoding="utf-8"))
    return markdown(["share", "8 elements", "16 elements", "32 elements"],
                    [[share] + [f"{100 * float(error):.2f} %"
                                for error in line.split()]
                     for share, line in zip(("0", "0.5"), found)])


def parts(rows):
    return {part.__name__: part(rows) for part in (flow, bar)}


def draw(rows):
    rows = [row for row in rows if row["outcome"] == "finished"]
    shares = [row["share"] for row in rows]
    columns = (("flow_rate_plateau_kg_per_s", "plateau, kg/(s m)"),
               ("steps", "steps"),
               ("time_over_lumped", "run time over that of share 0"))
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, len(columns), figsize=(9, 3),
                                      layout="constrained")
        for axes, (column, title) in zip(panels, columns):
            axes.plot(shares, [row[column] for row in rows], "o-",
                      color="#1d3557", linewidth=1.2, markersize=4)
            axes.set_ylim(0, 1.06 * max(row[column] for row in rows))
            axes.set_xlabel("consistent mass share")
            axes.set_title(title, fontsize=11)
        save(figure, NAME + ".png")
