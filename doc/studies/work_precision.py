"""Time and particle-steps against the error of what users ask for."""
import run_out
import run_output
from outlet_sweep import mean_rate
from plots import STYLE, plt, save
from runs import make_all
from sweep_cases import WINDOW, outlet_time
from tables import markdown, number
from traction_tables import mean_wall_force, wall_force
from work_cases import (BY_PARTICLES, METHODS, NAME, SILOS, cases, runs,
                        work_run)
from work_rows import error_of, references, signed_percent, work, work_row

QUANTITIES = {"flow_rate": "flow rate",
              "tenth_time": "time for a tenth of the material",
              "wall_at_rest": "wall force at rest",
              "wall_in_flow": "wall force in flow"}
OTHERS = {"tenth_time": "time for a tenth", "wall_at_rest": "wall at rest",
          "wall_in_flow": "wall in flow"}
COLORS = {"paper": "#9b2226", "free": "#c9822a", "averaged": "#b8a13a",
          "cell-4": "#4a7c59", "cell-9": "#1d3557", "lip-4": "#52b788",
          "lip-4-9": "#457b9d", "lip-8-9": "#89c2d9",
          "squares-4": "#7a5195", "squares-9": "#bc5090"}


def make_runs():
    make_all(runs())
    run_out.make_runs()


def results():
    return [row_of(*case) for case in cases()
            if run_output.has_ended(work_run(*case).directory)] + \
        run_out.results()


def row_of(key, method, element):
    mesh = SILOS[key].elements.index(element) + 1
    return work_row(key, method, element, mesh,
                    work_run(key, method, element).directory,
                    lambda directory: measured(key, directory))


def measured(key, directory):
    """The rate in kg/s, wall forces in N; plane: per metre."""
    unit = outlet_time(SILOS[key].outlet)
    table = run_output.read_table(directory, "flow_rate.csv")
    return {"flow_rate": mean_rate(table, unit, *WINDOW),
            "tenth_time": run_output.time_until(directory, 0.1),
            "wall_at_rest": wall_force(directory, 0.),
            "wall_in_flow": mean_wall_force(
                directory, *(time * unit for time in WINDOW))}


def reference(rows):
    lines = []
    for key, silo in SILOS.items():
        for quantity, title in QUANTITIES.items():
            value, uncertainty = references(rows, key, quantity)
            lines.append([f"{silo.title}, {title}", number(value),
                          f"{100 * uncertainty / value:.1f} %"])
    return markdown(["quantity", "reference", "±"], lines)


def by_mesh(rows, key, name):
    """A method's rows by the number of the mesh, the coarsest first."""
    return {row["mesh"]: row for row in rows
            if row["silo"] == key and row["method"] == name}


def rates(rows, key, name):
    """A method's flow rates on all meshes."""
    own = by_mesh(rows, key, name)
    return [number(own[mesh]["flow_rate"] if mesh in own else None)
            for mesh in (1, 2, 3, 4)]


def on_papers_meshes(rows, key, name):
    return [row for mesh, row in by_mesh(rows, key, name).items() if mesh <= 3]


def by_method(rows, key, cell):
    """A line for each method, a column for each mesh."""
    lines = []
    for name, method in METHODS.items():
        if key not in method.silos:
            continue
        own = by_mesh(rows, key, name)
        lines.append([method.title] +
                     [cell(own[mesh]) if mesh in own else "–"
                      for mesh in (1, 2, 3, 4)])
    return markdown(["method", "mesh 1", "mesh 2", "mesh 3", "half of it"],
                    lines)


def errors(rows, key, quantity="flow_rate"):
    return by_method(rows, key, lambda row: signed_percent(
        error_of(rows, row, quantity)))


def cost(rows, key):
    return by_method(rows, key, work)


def others(rows):
    lines = []
    for key, silo in SILOS.items():
        for name in ("paper", "averaged", "cell-4", "cell-9", "lip-4-9",
                     "squares-9"):
            line = [f"{silo.title}, {METHODS[name].title}"]
            for quantity in OTHERS:
                line += [signed_percent(error_of(rows, row, quantity))
                         for row in on_papers_meshes(rows, key, name)]
            lines.append(line)
    return markdown(["silo, method"] + [f"{title}, mesh {mesh}" for title in
                                        OTHERS.values() for mesh in (1, 2, 3)],
                    lines)


def cheapest(rows, key, name, bound):
    """The cheapest of a method's runs from which on its error stays within a
    bound."""
    result = None
    for row in reversed(by_mesh(rows, key, name).values()):
        error = error_of(rows, row, "flow_rate")
        if error is None or abs(error) > bound:
            break
        result = row
    return result


def within(rows, key):
    """The work for an error, also beside that of the paper's method."""
    lines = []
    for bound in (0.1, 0.05, 0.03):
        for name, method in METHODS.items():
            row = cheapest(rows, key, name, bound)
            if row:
                lines.append([f"{100 * bound:g} %", method.title, row["mesh"],
                              f"{row['particle_steps'] / 1e6:.3g} M",
                              f"{row['all_seconds']:.2g}"])
    return markdown(["error at most", "method", "from mesh",
                     "particle-steps", "seconds"], lines)


def noise(rows):
    """Rates with both force integrations."""
    names = ("averaged", "averaged-16", "cell-4", "cell-16",
             "squares-particles", "squares-4", "squares-16")
    lines = []
    for name in names:
        is_cell = BY_PARTICLES[0] not in METHODS[name].settings
        lines.append(["squares" if name.startswith("squares") else "triangles",
                      16 if name.endswith("16") else 4,
                      "cell" if is_cell else "particles"] +
                     rates(rows, "plane", name))
    return markdown(["cells", "particles per cell", "`Force integration`",
                     "mesh 1", "mesh 2", "mesh 3", "half of it"], lines)


def graded(rows):
    """Rates of the default in meshes that are finer at the lip."""
    names = ("cell-4", "lip-4-unsplit", "lip-4", "lip-4-9", "lip-4-16",
             "lip-8-9")
    return markdown(
        ["silo, method"] + [f"mesh {mesh}" for mesh in (1, 2, 3)],
        [[f"{silo.title}, {METHODS[name].title}"] +
         [f"{number(row['flow_rate'])} ({row['particle_steps'] / 1e6:.3g} M)"
          for row in on_papers_meshes(rows, key, name)]
         for key, silo in SILOS.items() for name in names])


def axis(rows):
    """Rates of the axisymmetric silo with and without splitting."""
    lines = []
    for name in ("unsplit-4", "cell-4", "unsplit-9", "cell-9"):
        lines.append([name.rsplit("-", 1)[1],
                      "never" if name.startswith("un") else "where needed"] +
                     rates(rows, "axisymmetric", name))
    return markdown(["particles per cell", "`Split particles`", "mesh 1",
                     "mesh 2", "mesh 3", "half of it"], lines)


def parts(rows):
    tables = {"reference": reference(rows), "others": others(rows),
              "noise": noise(rows), "graded": graded(rows),
              "axis": axis(rows), **run_out.parts(rows)}
    for key in SILOS:
        for table in (errors, cost, within):
            tables[f"{table.__name__}-{key}"] = table(rows, key)
    return tables


def draw(rows):
    with plt.rc_context(STYLE):
        figure, panels = plt.subplots(1, len(SILOS), figsize=(10, 4.2),
                                      layout="constrained", sharey=True)
        for axes, (key, silo) in zip(panels, SILOS.items()):
            draw_silo(axes, rows, key)
            axes.set_title(silo.title + ", flat bottom", fontsize=11)
            axes.set_xlabel("set-up, static stage and loop, s")
        panels[0].set_ylabel("error of the flow rate, %")
        panels[0].legend(frameon=False, fontsize=7)
        save(figure, NAME + ".png")


def draw_silo(axes, rows, key):
    value, uncertainty = references(rows, key, "flow_rate")
    share = 100 * uncertainty / value
    axes.axhspan(-share, share, color="#dddddd", linewidth=0)
    for name, method in METHODS.items():
        if not method.is_in_plot:
            continue
        own = [row for row in by_mesh(rows, key, name).values()
               if row["flow_rate"] is not None]
        axes.plot([row["all_seconds"] for row in own],
                  [100 * error_of(rows, row, "flow_rate") for row in own],
                  "s--" if name.startswith("squares") else "o-", markersize=4,
                  linewidth=1.2, color=COLORS[name], label=method.title)
    axes.set_xscale("log")
