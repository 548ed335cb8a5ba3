"""Observed orders of both stages, limit loads of footings and steady shear, from
what the tests print that compare with exact solutions."""
import concurrent.futures
import os
import re
import subprocess
import sys

from runs import SANDGLASS
from study_runs import output_of
from tables import markdown

NAME = "verification"
TESTS = {"physics": "*ManufacturedStatic*:*ManufacturedMotionTest*:"
                    "*CornerTractions*:*RigidFooting*:*EndlessFlow*",
         "validation": "*FiniteMotion*:*EvenPressure*:*FootingLimit*"}
# In the order of the tests' parameters
SETTINGS = ("plane, triangles", "plane, quadrilaterals",
            "axisymmetric, triangles", "axisymmetric, quadrilaterals")
INTEGRATIONS = ("particles", "cell")


def output_file(program):
    return output_of(NAME) / (program + ".txt")


def run(program, arguments):
    """What a test program prints."""
    done = subprocess.run([SANDGLASS.parent / "tests" /
                           (program + "_tests"), *arguments],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"{program}_tests {' '.join(arguments)}: failed",
              file=sys.stderr)
    return done.stdout


def names_of_tests(program, pattern):
    suite = ""
    for line in run(program, ["--gtest_list_tests",
                              f"--gtest_filter={pattern}"]).splitlines():
        if line.startswith(" "):
            yield suite + line.split()[0]
        elif line.endswith("."):
            suite = line


def make_runs():
    output_of(NAME).mkdir(parents=True, exist_ok=True)
    jobs = int(os.environ.get("JOBS", os.cpu_count() or 1))
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        for program, tests in TESTS.items():
            texts = pool.map(
                lambda name, program=program: run(
                    program, [f"--gtest_filter={name}"]),
                list(names_of_tests(program, tests)))
            output_file(program).write_text("".join(texts), encoding="utf-8")


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


def orders(rows, test, quantities, integration=""):
    """Errors on the finest mesh and the orders between all."""
    pattern = f"{integration}{NUMBER} cells: " + "; ".join(
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
    return orders(rows, "ManufacturedMotionTest", ("displacement", "stress"),
                  "particles: ")


def of_integrations(rows, test, pattern):
    """Names and numbers of each setting and integration of stress."""
    for setting in SETTINGS:
        for integration in INTEGRATIONS:
            yield [setting, f"`{integration}`"], [
                values for name, values in found(
                    rows, test, f"{integration}: {pattern}")
                if name == setting]


def finite_errors(rows, quantity):
    """Errors of the displacement or the stress: the quantity 0 or 1."""
    columns = ((8, 4), (16, 4), (32, 4), (16, 16), (32, 64))
    lines = []
    for head, values in of_integrations(
            rows, "FiniteMotion",
            f"{NUMBER} cells, {NUMBER} particles per cell: displacement error "
            f"{NUMBER}, stress error {NUMBER}"):
        errors = {(cells, particles): both[quantity]
                  for cells, particles, *both in values}
        lines.append(head + [f"{errors[column]:#.2g}" for column in columns])
    return markdown(["setting", "`Force integration`"] +
                    [f"{cells}², {particles} particles"
                     for cells, particles in columns], lines)


def finite(rows):
    return finite_errors(rows, 0)


def finite_stress(rows):
    return finite_errors(rows, 1)


def pressure(rows):
    return markdown(
        ["setting", "`Force integration`", "8²", "16²"],
        [head + [f"{share:#.2g}" for _, share in values]
         for head, values in of_integrations(
             rows, "EvenPressure", f"{NUMBER} cells: displacement error over "
             f"pressure .* {NUMBER}$")])


def footing(rows):
    limits = {}
    for row in rows:
        match = re.match(r"(.*), (averaged|element), (particles|cell), "
                         rf"{NUMBER} cells: limit / exact {NUMBER}",
                         row["line"])
        if match:
            cells, strain, integration, n_cells, limit = match.groups()
            limits.setdefault((cells, strain), {})[
                (integration, int(n_cells))] = f"{float(limit):.2f}"
    columns = (("particles", 4), ("particles", 8), ("cell", 4))
    return markdown(["cells", "`Volumetric strain`"] +
                    [f"`{integration}`, {n_cells} cells"
                     for integration, n_cells in columns],
                    [[*head] + [values.get(column, "–") for column in columns]
                     for head, values in limits.items()])


def rigid_footing(rows):
    lines = []
    for row in rows:
        match = re.match(rf"(smooth|rough) footing, (\w+) flow, {NUMBER} "
                         rf"degrees, {NUMBER} cells: N_c {NUMBER}, "
                         rf"exact {NUMBER}", row["line"])
        if match:
            footing, flow, angle, n_cells, limit, exact = match.groups()
            difference = 100 * (float(limit) / float(exact) - 1)
            lines.append([f"{angle}°", flow, footing, n_cells,
                          f"{float(limit):.2f}", f"{float(exact):.2f}",
                          f"{difference:+.1f}"])
    return markdown(["φ", "plastic flow", "footing",
                     "elements in its half width", "N_c", "Prandtl",
                     "difference, %"], lines)


def steady_shear(rows):
    errors = {}
    for row in rows:
        match = re.match(rf"(layer on a slope|tube), {NUMBER} cells: velocity "
                         rf"error {NUMBER}", row["line"])
        if match:
            flow, n_cells, error = match.groups()
            errors.setdefault(flow, {})[n_cells] = f"{100 * float(error):.2f}"
    columns = ("8", "16")
    return markdown(["flow"] + [f"{n_cells} cells across, %"
                                for n_cells in columns],
                    [[flow] + [values.get(column, "–") for column in columns]
                     for flow, values in errors.items()])


BOTTOMS = ("flat bottom", "hopper", "steepening hopper")


def corners(rows):
    """Pressures; plane, triangles. The largest difference is that of all
    settings."""
    shown, differences = {}, {}
    for row in rows:
        match = re.match(rf"(at rest|in flow), (.*): normal {NUMBER} Pa, "
                         rf"continued {NUMBER} Pa, difference {NUMBER}, "
                         rf"recorded {NUMBER} Pa",
                         row["line"])
        if "CornerTractions" not in row["test"] or not match:
            continue
        when, wall, share, _, difference, recorded = match.groups()
        setting = int(row["test"].rsplit("/", 1)[1])
        bottom = BOTTOMS[setting % len(BOTTOMS)]
        differences.setdefault(bottom, []).append(float(difference))
        if setting < len(BOTTOMS):
            shown.setdefault((bottom, wall), {})[when] = [
                f"{float(value) / 1e3 + 0.:.1f}" for value in (recorded, share)]
    return markdown(
        ["silo", "wall", "recorded at rest, kPa", "share",
         "recorded in flow, kPa", "share", "largest difference"],
        [[bottom, wall, *values.get("at rest", "––"),
          *values.get("in flow", "––"),
          f"{100 * max(differences[bottom]):.1f} %"]
         for (bottom, wall), values in shown.items()])


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (static, within_cells, finite, finite_stress,
                         pressure, footing, rigid_footing,
                         steady_shear, corners)}


def draw(_):
    """No picture."""
