"""How fast the particle stage is beside a plain loop and the machine's limits,
what else a run costs, and a model of what MPI will cost."""
import itertools
import json
import os
import re
import statistics
import subprocess

import run_output
from runs import ROOT, make
from study_runs import WITHOUT_OUTPUT, auto_scene, output_of, study_run
from tables import markdown, number

import scaling_model

NAME = "performance"
SCENE = auto_scene("plane-flat-bottom", 3)
ELEMENT_SIZE = 0.025  # of mesh 3, in m
REPETITIONS = 9  # of what is timed as a whole; medians count
REFINEMENTS = (1, 2, 4, 8)
BENCH = ROOT / "build" / "bench" / "particle_loop.json"
CALLGRIND = output_of(NAME) / "callgrind.out"
CALLGRIND_PARTS = output_of(NAME) / "callgrind-parts"
KINDS = ("plane/triangles", "plane/quadrilaterals",
         "axisymmetric/triangles", "axisymmetric/quadrilaterals")
PARTS_OF_STEP = {
    "sums_at_nodes": "sums from cells to nodes (2 to 4)",
    "time_step": "critical time step",
    "nodal_equations": "nodal equations and contact (2, 4, 5)",
    "velocity_map": "velocity map (7)",
    "volumetric_strain": "averaged volumetric strain",
    "particles": "particles, and their sums in cells (2 to 4, 6, 8, 9)",
    "relocation": "change of cells",
    "splitting": "splitting of particles",
    "order": "order in memory"}


def discharge_runs(has_files):
    """With all outputs, or without VTU files; the scene's interval is the
    program's default."""
    name = "discharge" if has_files else "discharge-without-files"
    return [study_run(NAME, f"{name}-{repetition}", SCENE, (),
                      () if has_files else WITHOUT_OUTPUT)
            for repetition in range(REPETITIONS)]


def start_run(refinement, particles_per_cell=4, with_output=False):
    """The first steps from an unstressed start."""
    steps = 10
    time_step = 2.5e-4 / refinement
    name = f"start-{refinement}-{particles_per_cell}"
    if with_output:
        name += "-output"
    return study_run(NAME, name, SCENE, (
        ("Scene/Element size", ELEMENT_SIZE / refinement),
        ("Scene/Particles per cell", particles_per_cell),
        ("Static stage/Enabled", "false"),
        ("Particle stage/Time step", time_step),
        ("Particle stage/End time", steps * time_step)),
                     () if with_output else WITHOUT_OUTPUT)


def memory_runs(with_output):
    """One mesh with few and with many particles."""
    return [start_run(2, particles, with_output) for particles in (4, 16)]


def counted_run():
    """For valgrind, with the paper's step: what the benchmark measures."""
    return study_run(NAME, "counted", SCENE, (
        ("Static stage/Enabled", "false"),
        ("Walls/Outlet lip", "floor"),
        ("Particle stage/Volumetric strain", "element"),
        ("Particle stage/Force integration", "particles"),
        ("Particle stage/Time step", 2.5e-4),
        ("Particle stage/End time", 0.025)))


def rank_run(n_ranks, refinement, pair, *settings):
    return n_ranks, study_run(
        NAME, f"ranks-{n_ranks}-{refinement}-{pair}", SCENE, (
            ("Scene/Element size", ELEMENT_SIZE / refinement), *settings))


def short_pairs():
    """The first steps of 325 thousand particles on one and on two ranks."""
    return [[rank_run(n_ranks, 4, pair, ("Static stage/Enabled", "false"),
                      ("Particle stage/End time", 0.05))
             for n_ranks in (1, 2)]
            for pair in range(REPETITIONS)]


def discharge_pair():
    """All of the discharge of 81 thousand particles."""
    return [rank_run(n_ranks, 2, "discharge") for n_ranks in (1, 2)]


def make_on_ranks(n_ranks, run):
    settings = [word for setting in run.settings + WITHOUT_OUTPUT
                for word in ("-s", setting)]
    environment = dict(os.environ, OMP_NUM_THREADS="1",
                       OMPI_ALLOW_RUN_AS_ROOT="1",
                       OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       OMPI_MCA_hwloc_base_binding_policy="none")
    subprocess.run(
        ["mpirun", "-n", str(n_ranks),
         str(ROOT / "build" / "release" / "sandglass"), str(run.prm),
         "--quiet", "-o", str(run.directory), *settings],
        check=True, capture_output=True, env=environment)


def count_instructions():
    run = counted_run()
    run.directory.mkdir(parents=True, exist_ok=True)
    settings = [word for setting in run.settings + WITHOUT_OUTPUT
                for word in ("-s", setting)]
    subprocess.run(
        ["valgrind", "--tool=callgrind",
         f"--callgrind-out-file={CALLGRIND}",
         "--toggle-collect=*ExplicitParticleStage*::step()",
         str(ROOT / "build" / "release" / "sandglass"), str(run.prm),
         "--quiet", "-o", str(run.directory), *settings],
        check=True, capture_output=True)


def count_parts():
    """What the benchmark dumps at the end of each part of a step."""
    for dump in CALLGRIND_PARTS.parent.glob(CALLGRIND_PARTS.name + ".*"):
        dump.unlink()
    subprocess.run(
        ["valgrind", "--tool=callgrind", "--instr-atstart=no",
         f"--callgrind-out-file={CALLGRIND_PARTS}",
         str(ROOT / "build" / "release" / "benchmarks" /
             "bench_particle_loop"),
         f"--benchmark_filter=counted_parts/{KINDS[0]}",
         "--benchmark_format=json",
         f"--benchmark_out={CALLGRIND_PARTS}.json"],
        check=True, capture_output=True)


def make_runs():
    """One after the other, for their times."""
    alternating = zip(discharge_runs(True), discharge_runs(False))
    for run in [*itertools.chain.from_iterable(alternating),
                *memory_runs(False), *memory_runs(True),
                *(start_run(refinement) for refinement in REFINEMENTS)]:
        make(run)
    count_instructions()
    count_parts()
    for pair in [*short_pairs(), discharge_pair()]:
        for n_ranks, run in pair:
            make_on_ranks(n_ranks, run)


def benchmarks():
    """The counters of each benchmark by its name without settings."""
    with open(BENCH, encoding="utf-8") as file:
        return {re.sub("/iterations.*", "", entry["name"]): entry
                for entry in json.load(file)["benchmarks"]}


def results():
    measured = benchmarks()
    rows = []
    for kind in KINDS:
        plain = measured[f"beside_plain_loop/{kind}"]
        rows.append({"kind": kind, "refinement": 1,
                     "particles": plain["particles"],
                     "ns_per_particle_step": plain["ns_per_particle_step"],
                     "plain_over_stage": plain["plain_over_stage"],
                     "time_over_mesh_3": 1,
                     "defaults_over_paper": measured[
                         f"defaults_beside_paper/{kind}"]["time_over_paper"],
                     "bytes": plain["bytes_per_particle_step"],
                     "filled_lanes": plain["filled_lanes"]})
        for refinement in REFINEMENTS[1:]:
            fine = measured[f"beside_mesh_3/{kind}/{refinement}"]
            rows.append({"kind": kind, "refinement": refinement,
                         "particles": fine["particles"],
                         "ns_per_particle_step": fine["ns_per_particle_step"],
                         "plain_over_stage": None,
                         "time_over_mesh_3": fine["time_over_mesh_3"],
                         "defaults_over_paper": None,
                         "bytes": fine["bytes_per_particle_step"],
                         "filled_lanes": fine["filled_lanes"]})
    return rows


def loop(rows):
    lines = []
    for kind in KINDS:
        own = [row for row in rows if row["kind"] == kind]
        lines.append([kind.replace("/", ", "),
                      number(own[0]["ns_per_particle_step"], ".0f"),
                      number(own[0]["plain_over_stage"], ".2f"),
                      *(number(row["time_over_mesh_3"], ".2f")
                        for row in own[1:]),
                      number(own[0]["defaults_over_paper"], ".2f"),
                      f"{100 * own[0]['filled_lanes']:.0f} %"])
    sizes = [f"elements of 1/{refinement}" for refinement in REFINEMENTS[1:]]
    return markdown(["cells", "ns on mesh 3", "plain loop over stage",
                     *sizes, "defaults over paper's", "lanes filled"], lines)


def instructions():
    """In step(), per particle and step."""
    total = re.search(r"^totals: (\d+)", CALLGRIND.read_text(), re.MULTILINE)
    summary = run_output.read_summary(counted_run().directory)
    return int(total.group(1)) / summary["particle_steps"]


def limits(rows):
    measured = benchmarks()
    bandwidth = measured["limits/memory_bandwidth"]["bytes_per_second"]
    arithmetic = measured["limits/vector_arithmetic"][
        "vector_instructions_per_second"]
    count = instructions()
    lines = []
    for row in rows[:len(REFINEMENTS)]:
        seconds = 1e-9 * row["ns_per_particle_step"]
        lines.append([f"{row['particles'] / 1000:.0f} 000",
                      number(row["bytes"], ".0f"),
                      f"{100 * row['bytes'] / seconds / bandwidth:.0f} %",
                      number(count, ".0f"),
                      number(count / seconds / arithmetic, ".2f")])
    return markdown(["particles", "bytes", "of the memory's limit",
                     "instructions", "instructions over the probe's"], lines)


def instructions_of_parts():
    """Per particle and step."""
    with open(f"{CALLGRIND_PARTS}.json", encoding="utf-8") as file:
        steps = json.load(file)["benchmarks"][0]["particle_steps"]
    counts = dict.fromkeys(PARTS_OF_STEP, 0)
    for dump in CALLGRIND_PARTS.parent.glob(CALLGRIND_PARTS.name + ".[0-9]*"):
        text = dump.read_text()
        part = re.search(r"^desc: Trigger: Client Request: (\w+)", text,
                         re.MULTILINE)
        if part and part.group(1) in counts:
            counts[part.group(1)] += int(
                re.search(r"^totals: (\d+)", text, re.MULTILINE).group(1))
    return {part: count / steps for part, count in counts.items()}


def times_of_parts(kind, refinement):
    """In ns per particle and step, and the bytes known beside them."""
    measured = benchmarks()[f"parts_of_step/{kind}/{refinement}"]
    return {part: (measured[f"ns_of_{part}"],
                   measured.get(f"bytes_of_{part}"))
            for part in PARTS_OF_STEP}


def total_time(kind, refinement):
    return sum(time for time, _ in times_of_parts(kind, refinement).values())


def parts_of_step(_):
    """The parts of a step with the program's defaults."""
    bandwidth = benchmarks()["limits/memory_bandwidth"]["bytes_per_second"]
    mesh_3 = times_of_parts(KINDS[0], 1)
    fine = times_of_parts(KINDS[0], REFINEMENTS[-1])
    counts = instructions_of_parts()
    lines = []
    for part, title in PARTS_OF_STEP.items():
        nanoseconds, moved = mesh_3[part]
        lines.append([
            title, number(nanoseconds, ".1f"), number(counts[part], ".0f"),
            number(moved, ".0f"),
            number(moved and 100e9 * moved / nanoseconds / bandwidth, ".0f"),
            number(fine[part][0], ".1f"),
            *(number(times_of_parts(kind, 1)[part][0], ".1f")
              for kind in KINDS[1:])])
    lines.append(["all", number(total_time(KINDS[0], 1), ".0f"),
                  number(sum(counts.values()), ".0f"), "", "",
                  number(total_time(KINDS[0], REFINEMENTS[-1]), ".0f"),
                  *(number(total_time(kind, 1), ".0f")
                    for kind in KINDS[1:])])
    return markdown(
        ["part (steps of Section 4.4)", "ns", "instructions", "bytes",
         "% of the memory's limit", "ns, 1.3 million particles",
         *(f"ns, {kind.replace('/', ' ')}" for kind in KINDS[1:])], lines)


def memory_per_particle(with_output=False):
    """In bytes, over the mesh's own."""
    few, many = (run_output.read_summary(run.directory)
                 for run in memory_runs(with_output))
    return ((many["peak_rss_MiB"] - few["peak_rss_MiB"]) * 2**20 /
            (many["particles"] - few["particles"]))


def particle_memory(_):
    return f"{memory_per_particle():.0f} bytes"


def output_memory(_):
    return f"{memory_per_particle(with_output=True):.0f} bytes"


def element_memory(_):
    """From two meshes, without the particles' share."""
    small, large = (run_output.read_summary(start_run(refinement).directory)
                    for refinement in (1, 4))
    peak, particles, cells = (
        large[key] - small[key]
        for key in ("peak_rss_MiB", "particles", "cells"))
    per_element = (peak * 2**20 - memory_per_particle() * particles) / cells
    return f"{per_element / 1024:.1f} KiB"


def whole_run_shares(with_files, without_files):
    """Share of each part in the sum of all."""
    seconds, without = (
        {part: summary[part + "_seconds"]
         for part in run_output.RUN_PARTS}
        for summary in (run_output.read_summary(run.directory)
                        for run in (with_files, without_files)))
    whole = sum(seconds.values())
    seconds["files"] = seconds["output"] - without["output"]
    return {part: value / whole for part, value in seconds.items()}


def whole_run(_):
    titles = {"setup": "set-up", "static": "static stage",
              "loop": "particle stage", "output": "output",
              "files": "of it, VTU files"}
    shares = [whole_run_shares(*runs) for runs in
              zip(discharge_runs(True), discharge_runs(False))]
    lines = []
    for part, title in titles.items():
        values = sorted(share[part] for share in shares)
        lines.append([title, f"{100 * statistics.median(values):.1f} %",
                      f"{100 * values[0]:.1f} to {100 * values[-1]:.1f} %"])
    return markdown(["part of the run", "share of the time", "range"], lines)


def speed_up(pair, *parts):
    """How much faster the second run of a pair is, in these parts of both."""
    seconds = [run_output.seconds_of(
        run_output.read_summary(run.directory), *parts) for _, run in pair]
    return seconds[0] / seconds[1]


def two_ranks(_):
    factors = sorted(speed_up(pair, "loop") for pair in short_pairs())
    # Other work on the machine only adds to a time.
    fastest = [min(run_output.read_summary(run.directory)["loop_seconds"]
                   for _, run in runs) for runs in zip(*short_pairs())]
    return (f"{statistics.median(factors):.2f} (median of {len(factors)} "
            f"pairs, {factors[0]:.2f} to {factors[-1]:.2f}; the fastest run "
            f"over the fastest: {fastest[0] / fastest[1]:.2f})")


def two_ranks_discharge(_):
    """New partitions are part of the set-up."""
    return f"{speed_up(discharge_pair(), 'loop', 'setup'):.2f}"


def set_up(_):
    lines = []
    for refinement in REFINEMENTS:
        summary = run_output.read_summary(start_run(refinement).directory)
        lines.append([summary["particles"], summary["cells"],
                      number(1e6 * summary["setup_seconds"] /
                             summary["cells"], ".0f"),
                      number(1024 * summary["peak_rss_MiB"] /
                             summary["particles"], ".2f")])
    return markdown(["particles", "elements", "set-up, µs per element",
                     "peak memory, KiB per particle, all included"], lines)


def scaling(_):
    return scaling_model.table(total_time(KINDS[0], REFINEMENTS[-1]))


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (loop, limits, parts_of_step, particle_memory,
                         output_memory, element_memory, whole_run, two_ranks,
                         two_ranks_discharge, set_up, scaling)}


def draw(_):
    """The page has no plot."""
