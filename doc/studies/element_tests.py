"""Laws at one material point: von Wolffersdorff's beside measured tests of
Karlsruhe fine sand, and what each law gives in four tests."""
import numpy

import run_output
from closed_silos import make_and_time, seconds_file
from element_cases import (KINDS, LAWS, MANY_STEPS, NAME, STEPS, Triaxial,
                           all_runs, law_run, oedometers, triaxials)
from plots import STYLE, plt, save
from tables import markdown

FIGURE = 0.008  # largest difference of void ratio
PEAK_FIGURE = 17.  # percent
DILATION_AT = 0.1  # axial strain
DENSE = -0.02  # volumetric strain there of samples that dilate
SHOWN_TRIAXIAL = ("TMD3", "TMD8", "TMD23")  # loose to dense at 200 kPa
SHOWN_OEDOMETERS = ("OE1", "OE6", "OE12")
COLORS = ("#c9822a", "#4f8a8b", "#1d3557")


def make_runs():
    for run in all_runs():
        make_and_time(run)


def summary_of(run):
    """Of a test that has come to its end, else None."""
    if not run_output.has_ended(run.directory):
        return None
    summary = run_output.read_summary(run.directory)
    return summary if summary["status"] == "finished" else None


def table_of(run):
    return run_output.read_table(run.directory, "element_test.csv")


def oedometer_rows(test):
    table = table_of(test.run())
    for stress, measured in test.points:
        yield {"test": test.name, "quantity": "void ratio",
               "at": stress, "measured": measured,
               # Void ratio falls about evenly with the logarithm.
               "value": numpy.interp(numpy.log(stress),
                                     numpy.log(table["axial_stress_Pa"]),
                                     table["void_ratio"])}


def triaxial_rows(test):
    summary, table = summary_of(test.run()), table_of(test.run())
    for quantity, key, measured in (
            ("peak", "peak_von_mises_stress_Pa", test.peak),
            ("strain at peak", "strain_at_peak", test.strain_at_peak)):
        yield {"test": test.name, "quantity": quantity, "at": test.pressure,
               "measured": measured, "value": summary[key]}
    yield {"test": test.name, "quantity": "volumetric strain",
           "at": DILATION_AT, "measured": dict(test.volume)[DILATION_AT],
           "value": numpy.interp(DILATION_AT, table["axial_strain"],
                                 table["volumetric_strain"])}


def law_rows(law, kind):
    summary = summary_of(law_run(law, kind))
    for quantity in ("peak_friction_angle_degrees",
                     "final_friction_angle_degrees",
                     "final_volumetric_strain"):
        yield {"test": f"{law[0]}, {kind[0]}", "quantity": quantity,
               "at": kind[2], "measured": None, "value": summary[quantity]}


def seconds_of(law, steps):
    return float(seconds_file(law_run(law, KINDS[0], steps)).read_text(
        encoding="utf-8"))


def time_rows(law):
    for steps in (STEPS, MANY_STEPS):
        if summary_of(law_run(law, KINDS[0], steps)):
            yield {"test": law[0], "quantity": "seconds", "at": steps,
                   "measured": None, "value": seconds_of(law, steps)}


def results():
    rows = []
    for tests, rows_of in ((oedometers(), oedometer_rows),
                           (triaxials(), triaxial_rows)):
        for test in tests:
            if summary_of(test.run()):
                rows += rows_of(test)
    for law in LAWS:
        for kind in KINDS:
            if summary_of(law_run(law, kind)):
                rows += law_rows(law, kind)
        rows += time_rows(law)
    return rows


def chosen(rows, test, quantity):
    return [row for row in rows
            if row["test"] == test and row["quantity"] == quantity]


def largest(rows):
    """The difference that is largest in size, with its sign."""
    return max((row["value"] - row["measured"] for row in rows), key=abs)


def oedometer(rows):
    lines = []
    for test in oedometers():
        own = chosen(rows, test.name, "void ratio")
        if own:
            lines.append([test.name, f"{test.void_ratio:.4f}",
                          f"{own[-1]['measured']:.4f}",
                          f"{own[-1]['value']:.4f}", f"{largest(own):+.4f}"])
    return markdown(["test", "void ratio at 1 kPa", "at 400 kPa, measured",
                     "computed", "largest difference of all stresses"], lines)


def oedometer_summary(rows):
    own = [row for row in rows if row["quantity"] == "void ratio"]
    if not own:
        return "not run"
    difference = abs(largest(own))
    return (f"The largest difference of {len(own)} void ratios in "
            f"{len({row['test'] for row in own})} tests is {difference:.4f}; "
            f"the figure of {FIGURE} is "
            f"{'' if difference <= FIGURE else 'not '}reached.")


def error(row):
    return 100 * (row["value"] / row["measured"] - 1)


def strain_text(value, end):
    return f"{100 * value:.1f}" if value < end - 1e-3 else "not reached"


def triaxial(rows):
    lines = []
    for test in triaxials():
        own = {quantity: chosen(rows, test.name, quantity)
               for quantity in ("peak", "strain at peak",
                                "volumetric strain")}
        if not own["peak"]:
            continue
        peak, strain, volume = (found[0] for found in own.values())
        lines.append([
            test.name, f"{test.pressure / 1e3:.0f}", f"{test.void_ratio:.3f}",
            f"{peak['measured'] / 1e3:.0f}", f"{peak['value'] / 1e3:.0f}",
            f"{error(peak):+.1f}", f"{100 * strain['measured']:.1f}",
            strain_text(strain["value"], test.END),
            f"{100 * volume['measured']:+.2f}",
            f"{100 * volume['value']:+.2f}"])
    return markdown(["test", "p, kPa", "void ratio", "peak of q, kPa",
                     "computed", "difference, %", "strain at peak, %",
                     "computed", "volumetric strain at 10 %, %", "computed"],
                    lines)


def triaxial_summary(rows):
    own = [row for row in rows if row["quantity"] == "peak"]
    if not own:
        return "not run"
    errors = [error(row) for row in own]
    is_reached = max(map(abs, errors)) <= PEAK_FIGURE
    return (f"The peaks of q in {len(own)} tests differ by "
            f"{min(errors):+.1f} to {max(errors):+.1f} %; the figure of "
            f"{PEAK_FIGURE:g} % is {'' if is_reached else 'not '}reached.")


def ratios(rows, quantity, is_counted=lambda row: True):
    found = [row["value"] / row["measured"] for row in rows
             if row["quantity"] == quantity and is_counted(row)]
    return f"{min(found):.2f} to {max(found):.2f}" if found else "–"


def dilation(rows):
    return ratios(rows, "volumetric strain",
                  lambda row: row["measured"] < DENSE)


def strains(rows):
    return ratios(rows, "strain at peak",
                  lambda row: row["value"] < Triaxial.END - 1e-3)


def cell(rows, law, kind, quantity, factor=1., form=".1f"):
    own = chosen(rows, f"{law[0]}, {kind[0]}", quantity)
    if not own or own[0]["value"] is None:
        return "–"
    value = factor * own[0]["value"]
    # No minus before a zero
    return format(0. if abs(value) < 0.005 else value, form)


def angles(rows):
    lines = [[law[0]] + [
        " / ".join(cell(rows, law, kind, f"{when}_friction_angle_degrees")
                   for when in ("peak", "final")) for kind in KINDS]
             for law in LAWS]
    return markdown(["law"] + [kind[0] + ", °" for kind in KINDS], lines)


def volumes(rows):
    lines = [[law[0]] + [
        cell(rows, law, kind, "final_volumetric_strain", 100., "+.2f")
        for kind in KINDS] for law in LAWS]
    return markdown(["law"] + [kind[0] + ", %" for kind in KINDS], lines)


def times(rows):
    lines = []
    for law in LAWS:
        own = chosen(rows, law[0], "seconds")
        if len(own) == 2:
            few, many = own
            step = (many["value"] - few["value"]) / (many["at"] - few["at"])
            lines.append([law[0], f"{few['value']:.2f}",
                          f"{many['value']:.2f}", f"{1e6 * step:.0f}"])
    return markdown(["law", f"{STEPS} steps, s", f"{MANY_STEPS} steps, s",
                     "one step, μs"], lines)


def parts(rows):
    return {part.__name__.replace("_", "-"): part(rows)
            for part in (oedometer, oedometer_summary, triaxial,
                         triaxial_summary, dilation, strains, angles, volumes,
                         times)}


def draw_triaxial(stress_axes, volume_axes):
    tests = {test.name: test for test in triaxials()}
    for color, name in zip(COLORS, SHOWN_TRIAXIAL):
        test = tests[name]
        if not summary_of(test.run()):
            continue
        table = table_of(test.run())
        strain = 100 * numpy.array(table["axial_strain"])
        q = (numpy.array(table["axial_stress_Pa"]) -
             numpy.array(table["lateral_stress_Pa"]))
        for axes, line, points, factor in (
                (stress_axes, q, test.q, 1e-3),
                (volume_axes, numpy.array(table["volumetric_strain"]),
                 test.volume, 100.)):
            axes.plot(strain, factor * line, color=color, linewidth=1.2,
                      label=f"{name}, e = {test.void_ratio:.3f}")
            axes.plot([100 * x for x, _ in points],
                      [factor * y for _, y in points], "o", color=color,
                      markersize=4)
    stress_axes.set_ylabel("q, kPa")
    stress_axes.legend(frameon=False, fontsize=8)
    volume_axes.set_ylabel("volumetric strain, %")
    for axes in (stress_axes, volume_axes):
        axes.set_xlabel("axial strain, %")


def draw_oedometers(axes):
    tests = {test.name: test for test in oedometers()}
    for color, name in zip(COLORS, SHOWN_OEDOMETERS):
        run = tests[name].run()
        if not summary_of(run):
            continue
        table = table_of(run)
        axes.semilogx(numpy.array(table["axial_stress_Pa"]) / 1e3,
                      table["void_ratio"], color=color, linewidth=1.2,
                      label=name)
        axes.plot([stress / 1e3 for stress, _ in tests[name].points],
                  [ratio for _, ratio in tests[name].points], "o",
                  color=color, markersize=4)
    axes.set_xlabel("axial stress, kPa")
    axes.set_ylabel("void ratio")
    axes.legend(frameon=False, fontsize=8)


def draw(_):
    """Lines are computed, points measured."""
    with plt.rc_context(STYLE):
        figure, row = plt.subplots(1, 3, layout="constrained",
                                   figsize=(10, 3.6))
        draw_triaxial(*row[:2])
        draw_oedometers(row[2])
        save(figure, NAME + ".png")
