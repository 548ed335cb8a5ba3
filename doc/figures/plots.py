"""The plots: flow rates over time."""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402 (after the choice of a backend)
from matplotlib.lines import Line2D  # noqa: E402

import run_output
from runs import MESHES, OUTPUT, ROOT, scene_name
from tables import TITLES

IMAGES = ROOT / "doc" / "images"
MESH_COLORS = {1: "#c9a26a", 2: "#4f8a8b", 3: "#1d3557"}
STYLE = {"font.family": "serif", "font.size": 10, "axes.grid": True,
         "grid.alpha": 0.3, "axes.spines.top": False,
         "axes.spines.right": False}


def draw_meshes(axes, silo):
    for mesh in MESHES:
        for is_automatic, style in ((False, "-"), (True, ":")):
            directory = OUTPUT / scene_name(silo, mesh, is_automatic)
            if not run_output.has_ended(directory):
                continue
            table = run_output.read_table(directory, "flow_rate.csv")
            axes.plot(table["time_s"], table["mass_flow_rate_kg_per_s"], style,
                      color=MESH_COLORS[mesh], linewidth=1.4)


def draw_beverloo(axes, silo):
    table = run_output.read_table(OUTPUT / scene_name(silo, 1, False),
                                  "flow_rate.csv")
    for ratio in ("0", "0.1", "0.2"):
        rate = table[f"beverloo_{ratio}_kg_per_s"][0]
        axes.axhline(rate, color="#888888", linewidth=0.9, linestyle="--")
        axes.annotate(f"Beverloo, d/D = {ratio}", (1, rate),
                      xycoords=("axes fraction", "data"), fontsize=8,
                      color="#666666", ha="right", va="bottom")


def draw_flow_rates(silos, picture, last_times):
    """Both silos of Figure 5 or 9 beside each other; dotted: automatic."""
    with plt.rc_context(STYLE):
        figure, row = plt.subplots(1, len(silos), figsize=(10, 4), sharey=True,
                                   layout="constrained")
        for axes, silo, last_time in zip(row, silos, last_times):
            draw_meshes(axes, silo)
            draw_beverloo(axes, silo)
            axes.set_title(TITLES[silo], fontsize=11)
            axes.set_xlabel("time, s")
            axes.set_xlim(0, last_time)
        row[0].set_ylim(bottom=0)
        row[0].set_ylabel("mass flow rate, " + (
            "kg/(s m)" if silos[0].startswith("plane") else "kg/s"))
        row[0].legend(handles=[Line2D([], [], color=MESH_COLORS[mesh],
                                      label=f"mesh {mesh}")
                               for mesh in MESHES],
                      frameon=False, loc="lower left")
        save(figure, picture)


def save(figure, picture):
    IMAGES.mkdir(exist_ok=True)
    # Without matplotlib's version, so that only results change the file.
    figure.savefig(IMAGES / picture, dpi=130, metadata={"Software": None})
    plt.close(figure)
