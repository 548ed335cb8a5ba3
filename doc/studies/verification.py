"""Observed orders of both stages and a footing's limit load, from what the tests
print that compare with exact solutions."""
import re
import subprocess

from runs import SANDGLASS
from study_runs import output_of
from tables import markdown

NAME = "verification"
TESTS = {"physics": "*ManufacturedStatic*:*ManufacturedMotionTest*",
         "validation": "*FiniteMotion*:*FootingLimit*"}
# In the order of the tests' parameters
SETTINGS = ("plane, triangles", "plane, quadrilaterals",
            "axisymmetric, triangles", "axisymmetric, quadrilaterals")


def output_file(program):
    return output_of(NAME) / (program + ".txt")


def make_runs():
    output_of(NAME).mkdir(parents=True, exist_ok=True)
    for program, tests in TESTS.items():
        done = subprocess.run([SANDGLASS.parent / "tests" /
                               (program + "_tests"),
                               f"--gtest_filter={tests}"],
                              capture_output=True, text=True, check=False)
        output_file(program).write_text(done.stdout, encoding="utf-8")


def results():
    """What each test prints, line by line."""
    rows = []
    for program in TESTS:
        test = None
        if not output_file(program).exists():
            continue
        for line in output_file(program).read_text("utf-8").splitlines():
            if line.startswith("[ RUN"):
                test = line.split("] ")[1]
            elif test and not line.startswith("["):
                rows.append({"test": test, "line": line})
    return rows


def found(rows, test, pattern):
    """Setting and numbers of each line of a test that the pattern matches."""
    for row in rows:
        match = re.match(pattern, row["line"])
        if test in row["test"] and match:
            setting = int(row["test"].rsplit("/", 1)[1])
            yield SETTINGS[setting], [float(text) for text in match.groups()]


NUMBER = r"([-+\de.]+)"


def orders(rows, test, quantities):
    """Errors on the finest mesh and the orders between all."""
    pattern = f"{NUMBER} cells: " + "; ".join(
        f"{quantity} error {NUMBER}, order {NUMBER}"
        for quantity in quantities)
    by_setting = {}
    for setting, values in found(rows, test, pattern):
        by_setting.setdefault(setting, []).append(values)
    lines = []
    for setting, meshes in by_setting.items():
        line = [setting]
        for i in range(len(quantities)):
            line += [f"{meshes[-1][2 * i + 1]:.2g}",
                     ", ".join(f"{mesh[2 * i + 2]:.2f}" for mesh in meshes)]
        lines.append(line)
    head = ["setting"]
    for quantity in quantities:
        head += [f"{quantity} error, 64²", "orders from 8² on"]
    return markdown(head, lines)


def static(rows):
    return orders(rows, "ManufacturedStatic",
                  ("displacement", "gradient", "stress"))


def within_cells(rows):
    return orders(rows, "ManufacturedMotionTest", ("displacement", "stress"))


def finite(rows):
    lines = {}
    for setting, (cells, particles, error, _) in found(
            rows, "ConvergesOnly",
            f"{NUMBER} cells, {NUMBER} particles per cell: displacement error "
            f"{NUMBER}, stress error {NUMBER}"):
        lines.setdefault(setting, {})[(cells, particles)] = error
    columns = ((8, 4), (16, 4), (32, 4), (16, 16), (32, 64))
    return markdown(["setting"] + [f"{cells}², {particles} particles"
                                   for cells, particles in columns],
                    [[setting] + [f"{errors[column]:.3f}"
                                  for column in columns]
                     for setting, errors in lines.items()])


def pressure(rows):
    lines = {}
    for setting, (_, share) in found(
            rows, "HasAStiffness",
            f"{NUMBER} cells: displacement error over pressure .* {NUMBER}$"):
        lines.setdefault(setting, []).append(f"{share:.2f}")
    return markdown(["setting", "8²", "16²"],
                    [[setting] + shares for setting, shares in lines.items()])


def footing(rows):
    pattern = (r"(.*), (averaged|element): limit / exact " + NUMBER +
               " with 4 cells, " + NUMBER + " with 8")
    matches = [re.match(pattern, row["line"]) for row in rows]
    return markdown(["cells", "`Volumetric strain`", "4 cells", "8 cells"],
                    [[*match.groups()[:2]] +
                     [f"{float(text):.2f}" for text in match.groups()[2:]]
                     for match in matches if match])


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (static, within_cells, finite, pressure, footing)}


def draw(_):
    """No picture."""
