"""A worked design case, two measured corn bins, and the residence in mass and
funnel flow."""
import run_output
from plots import STYLE, plt, save
from runs import make_all
from study_runs import study_run
from tables import markdown, number

NAME = "design-case"

CASE = "design-case"
# Wall friction of smooth steel for wheat: mean, and over or times 1.16.
FRICTIONS = (("mean", 20.8), ("lower", 18.1), ("upper", 23.8))

BINS = {"corn-bin-12.8-m": ("12.8 m", 15.2, 28.2),
        "corn-bin-11.0-m": ("11.0 m", 11.9, 26.9)}
# kg/m^3: the standard test weight, and 7.0, 7.5 and 8.0 kN/m^3.
DENSITIES = (721., 713.6, 764.5, 815.5)

SILOS = {"plane-hopper-mesh-2-auto": "hopper",
         "plane-flat-bottom-mesh-2-auto": "flat bottom"}


def case_run(title, angle):
    return study_run(NAME, f"{CASE}-{title}", f"../{CASE}",
                     (("Walls/Friction angle", angle),))


def bin_run(name, density):
    return study_run(NAME, f"{name}-{density:g}", f"../validation/{name}",
                     (("Material/Density", density),))


def silo_run(name):
    return study_run(NAME, name, name, (("Output/Grid", "false"),))


def all_runs():
    return ([bin_run(name, density) for name in BINS for density in DENSITIES] +
            [silo_run(name) for name in SILOS] +
            [case_run(*friction) for friction in FRICTIONS])


def make_runs():
    make_all(all_runs())


def results():
    return [{"run": run.name, "directory": str(run.directory)}
            for run in all_runs() if run_output.has_ended(run.directory)]


def summary_of(run):
    return (run_output.read_summary(run.directory)
            if run_output.has_ended(run.directory) else {})


def largest(run, wall, column):
    """Of the envelope, in kPa, and at which height; None without one."""
    if not run_output.has_ended(run.directory):
        return None, None
    table = run_output.read_table(run.directory, "wall_envelope.csv")
    values = [(value, y) for value, y, name in
              zip(table[column], table["y_m"], table["wall"])
              if name == wall and value == value]
    if not values:
        return None, None
    value, y = max(values)
    return value / 1000., y


def pressures():
    """Of the worked case, by wall and friction."""
    lines = []
    for title, angle in FRICTIONS:
        run = case_run(title, angle)
        for wall in ("wall", "hopper"):
            lines.append([f"{title}, {angle:g}°", wall] + [
                number(largest(run, wall, column)[0], ".3g") for column in (
                    "filling_normal_Pa", "largest_normal_Pa",
                    "en_1991_4_filling_normal_Pa",
                    "en_1991_4_discharge_normal_Pa",
                    "en_1991_4_discharge_patch_Pa")])
    return markdown(["wall friction", "wall", "at rest, kPa",
                     "in discharge, kPa", "EN 1991-4 filling, kPa",
                     "EN 1991-4 discharge, kPa", "its patch load, kPa"], lines)


def flow():
    lines = []
    for title, angle in FRICTIONS:
        summary = summary_of(case_run(title, angle))
        beverloo = None
        if summary:
            beverloo = run_output.read_table(
                case_run(title, angle).directory,
                "flow_rate.csv")["beverloo_0_kg_per_s"][0]
        lines.append([f"{title}, {angle:g}°",
                      number(summary.get("flow_rate_plateau_kg_per_s"), ".3g"),
                      number(beverloo, ".3g"),
                      summary.get("kind_of_flow") or "–",
                      number(summary.get("smallest_mass_flow_index"), ".2f"),
                      number(summary.get("slipping_wall_share"), ".2f")])
    return markdown(["wall friction", "flow rate, kg/s",
                     "Beverloo, fine grains, kg/s", "kind of flow",
                     "smallest mass flow index", "walls that slip"], lines)


def bins():
    lines = []
    for name, (diameter, depth, measured) in BINS.items():
        for density in DENSITIES:
            value, y = largest(bin_run(name, density), "wall",
                               "filling_normal_Pa")
            janssen = largest(bin_run(name, density), "wall",
                              "en_1991_4_filling_normal_Pa")[0]
            lines.append([
                diameter, f"{depth:g} m", f"{density:g}", number(measured),
                number(value, ".3g"), number(y, ".2g"),
                "–" if value is None else
                f"{100. * (value / measured - 1.):+.0f} %",
                number(janssen, ".3g")])
    return markdown(["diameter", "grain", "density, kg/m³", "measured, kPa",
                     "computed, kPa", "at the height, m", "difference",
                     "EN 1991-4, kPa"], lines)


def raster(run):
    """Corners of the cells of residence.vtu, times and shares that have
    left."""
    # Needed here only.
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(run.directory / "residence.vtu"))
    reader.Update()
    grid = reader.GetOutput()
    corners = vtk_to_numpy(grid.GetPoints().GetData())[:, :2]
    return (corners.reshape(-1, 4, 2).copy(),
            *(vtk_to_numpy(grid.GetCellData().GetArray(name)).copy()
              for name in ("residence time", "share that has left")))


def in_order(run, distance):
    """As first_in_first_out_share, of cells so many cells apart."""
    if not run_output.has_ended(run.directory):
        return None
    corners, times, shares = raster(run)
    height = corners[0, 2, 1] - corners[0, 0, 1]
    cells = {(round(float(corner[0, 0]), 6),
              round(float(corner[0, 1] / height))): (time, share >= 0.5)
             for corner, time, share in zip(corners, times, shares)}
    pairs = [(low, cells[x, row + distance])
             for (x, row), low in cells.items()
             if (x, row + distance) in cells]
    counted = [(low, high) for low, high in pairs if low[1] or high[1]]
    good = [low[1] and (not high[1] or low[0] <= high[0])
            for low, high in counted]
    return sum(good) / len(good)


def residence():
    lines = []
    for name, title in SILOS.items():
        summary = summary_of(silo_run(name))
        lines.append([title, summary.get("kind_of_flow") or "–"] + [
            number(summary.get(key), form) for key, form in (
                ("transition_height_m", ".2g"),
                ("smallest_mass_flow_index", ".2f"),
                ("first_in_first_out_share", ".3f"))] + [
            number(in_order(silo_run(name), 2), ".3f")] + [
            number(summary.get(key), form) for key, form in (
                ("mean_residence_time_s", ".3g"),
                ("residence_time_spread_s", ".2g"),
                ("live_mass_kg", ".4g"), ("residual_mass_kg", ".3g"))])
    return markdown(["bottom", "kind of flow", "transition, m",
                     "smallest mass flow index", "first in, first out",
                     "two cells apart", "mean residence, s", "± s", "live, kg/m", "dead, kg/m"],
                    lines)


def draw(rows):
    """Residence maps of both silos."""
    if len(rows) < len(all_runs()):
        return
    with plt.rc_context({**STYLE, "axes.grid": False}):
        figure, row = plt.subplots(1, len(SILOS), figsize=(8, 4.4),
                                   layout="constrained")
        for axes, (name, title) in zip(row, SILOS.items()):
            corners, times, shares = raster(silo_run(name))
            times[shares < 0.5] = float("nan")
            drawn = plt.matplotlib.collections.PolyCollection(
                corners, array=times, cmap="YlGnBu_r")
            drawn.cmap.set_bad("#888888")
            axes.add_collection(drawn)
            axes.set_aspect("equal")
            axes.autoscale()
            axes.set_title(title, fontsize=11)
            axes.set_xlabel("x, m")
            figure.colorbar(drawn, ax=axes, label="leaves at, s")
        row[0].set_ylabel("y, m")
        save(figure, "residence")


def parts(rows):
    return {"pressures": pressures(), "flow": flow(), "bins": bins(),
            "residence": residence()}
