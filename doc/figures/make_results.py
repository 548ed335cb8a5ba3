"""Runs the scenes that the documentation shows, where that has not been done
since the program changed, and makes its tables, plots and pictures anew, and
what the scenes say of their results.

usage: make_results.py [--no-runs]   (called by ./dev figures)
"""
import re
import subprocess
import sys

import plots
import tables
from expectations import write_expectations
from pages import fill_all
from run_output import has_ended
from runs import OUTPUT, ROOT, SILOS, all_runs, make_all
from traction_tables import sign_change, tractions

DRAW_FLOW = ROOT / "build" / "release" / "figures" / "draw_flow"
PLANE, AXISYMMETRIC = SILOS[:2], SILOS[2:]

# The pictures of Figures 3, 4, 7, 8 and 11: run and times in s.
PICTURES = {
    "figure-3": ("plane-flat-bottom-mesh-3", (0, 0.5, 1.0, 1.5, 2.5)),
    "figure-4": ("plane-hopper-mesh-3", (0, 0.5, 1.0, 1.5, 2.0)),
    "figure-7": ("axisymmetric-flat-bottom-mesh-3", (0, 0.3, 0.6, 1.0, 2.0)),
    "figure-8": ("axisymmetric-hopper-mesh-3", (0, 0.3, 0.6, 0.9, 1.2)),
    "section-5.3": ("plane-section-5.3", (0, 1, 2.5, 4, 5.5)),
}


def parts():
    """The generated parts of the pages by name."""
    result = {
        "scenes": tables.scenes(),
        "table-1": tables.mesh_data(PLANE + ("plane-section-5.3",)),
        "table-2": tables.time_steps(PLANE),
        "table-3": tables.mesh_data(AXISYMMETRIC),
        "table-4": tables.time_steps(AXISYMMETRIC),
        "run-times": tables.run_times(),
        "processor": processor(),
        "discharge-times": tables.discharge_times(),
        "hopper-times": tables.hopper_times(),
        "cone-times": tables.cone_times(),
        "density": tables.density(),
        "lip": tables.lip(),
        "sign-change": sign_change("plane-flat-bottom-mesh-3-auto",
                                   (0.2, 0.4, 0.6, 0.8, 1, 1.2, 1.5, 2, 2.5)),
    }
    for silo in SILOS:
        result["plateaus-" + silo] = tables.plateaus(silo)
    for picture, (name, times) in PICTURES.items():
        result["tractions-" + picture] = tractions(name, times)
    return result


def processor():
    with open("/proc/cpuinfo", encoding="utf-8") as file:
        return re.search(r"model name\s*: (.*)", file.read()).group(1)


def draw(name, picture, times, *options):
    if has_ended(OUTPUT / name):
        subprocess.run([DRAW_FLOW, *options, OUTPUT / name,
                        plots.IMAGES / (picture + ".png"), *map(str, times)],
                       check=True)
    else:
        print(f"{picture}.png: {name} has not been run", file=sys.stderr)


def draw_pictures():
    for picture, (name, times) in PICTURES.items():
        draw(name, picture, times, "--paper", "--half")
    draw("plane-flat-bottom-mesh-3-auto", "plane-flat-bottom",
         (0, 0.5, 1, 1.5, 2, 2.5))
    plots.draw_flow_rates(PLANE, "figure-5.png", (2.5, 3.5))
    plots.draw_flow_rates(AXISYMMETRIC, "figure-9.png", (2, 2))


def main():
    if "--no-runs" not in sys.argv[1:]:
        make_all(all_runs())
    draw_pictures()
    fill_all(parts())
    write_expectations()


if __name__ == "__main__":
    main()
