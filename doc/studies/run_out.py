"""How far collapsing columns run out, by method and mesh: a part of the
work-precision study."""
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

import run_output
from column_cases import COLUMNS, WIDTH, ColumnMesh, column_run
from runs import make_all
from tables import markdown, number
from work_cases import METHODS, NAME, SQUARES
from work_rows import error_of, references, signed_percent, work, work_row

CELLS = (10, 20, 40, 80)  # in the half width, on meshes 1 to 4
CHOSEN = ("paper", "separation", "averaged", "cell-4", "cell-9", "squares-4",
          "squares-9")
FINEST = ("cell-4", "squares-4")  # also run on mesh 4
REFERENCES = ("cell-9", "squares-9")
# Share of the mass in front of what counts as the heap, in a layer thinner than
# a cell; experiments have it as single grains.
SCATTERED = 0.02


def mesh_of(key, method, cells):
    return ColumnMesh(key, cells, SQUARES[0] in METHODS[method].settings)


def run_of(key, method, cells):
    return column_run(NAME, f"{key}-{method}-{cells}",
                      mesh_of(key, method, cells), METHODS[method].settings)


def cases():
    """Column, method and cells; the coarse meshes first."""
    return [(key, method, cells) for cells in CELLS for key in COLUMNS
            for method in CHOSEN if cells <= finest(key, method)]


def finest(key, method):
    """The most cells for which the method's run is worth its time. As
    densities drift, the paper's steps shrink."""
    is_low = COLUMNS[key].aspect_ratio <= 1.
    if method == "paper":
        return CELLS[2] if is_low else CELLS[1]
    return CELLS[3] if is_low and method in FINEST else CELLS[2]


def make_runs():
    for case in cases():
        mesh_of(*case).make()
    make_all([run_of(*case) for case in cases()])


def results():
    return [row_of(*case) for case in cases()
            if run_output.has_ended(run_of(*case).directory)]


def row_of(key, method, cells):
    return work_row(key, method, WIDTH / cells, CELLS.index(cells) + 1,
                    run_of(key, method, cells).directory,
                    lambda directory: {"run_out": run_out(directory)})


def run_out(directory):
    """(r_end - r_0) / r_0 of the heap that the particles are at the end."""
    reader = vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(max((directory / "vtu").glob("particles_*.vtu"))))
    reader.Update()
    particles = reader.GetOutput()
    places = vtk_to_numpy(particles.GetPoints().GetData())[:, 0]
    masses = vtk_to_numpy(particles.GetPointData().GetArray("mass"))
    order = places.argsort()
    behind = masses[order].cumsum()
    front = order[behind.searchsorted((1. - SCATTERED) * behind[-1])]
    return places[front] / WIDTH - 1.


def reference(rows):
    lines = []
    for key, column in COLUMNS.items():
        value, uncertainty = references(rows, key, "run_out", REFERENCES)
        lines.append([column.title, number(value, ".3g"),
                      f"{100 * uncertainty / value:.1f} %",
                      column.law])
    return markdown(["column", "reference", "±", "experiments"], lines)


def errors(rows):
    """A line for each method: errors and work on all meshes."""
    def error(row):
        return signed_percent(error_of(rows, row, "run_out", REFERENCES))

    lines = []
    for key, column in COLUMNS.items():
        for method in CHOSEN:
            own = {row["mesh"]: row for row in rows
                   if (row["silo"], row["method"]) == (key, method)}
            lines.append([f"{column.title}, {METHODS[method].title}"] + [
                cell(own[mesh]) if mesh in own else "–"
                for cell in (error, work)
                for mesh in range(1, len(CELLS) + 1)])
    return markdown(["column, method"] +
                    [f"{what}, {cells} cells" for what in ("error", "work")
                     for cells in CELLS], lines)


def parts(rows):
    return {"run-out-reference": reference(rows), "run-out": errors(rows)}
