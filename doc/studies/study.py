"""Makes a study's runs where that has not been done since the program changed,
then its .csv file, its plot and the tables of its page.

usage: study.py NAME [--no-runs]   (called by ./dev study)
"""
import csv
import sys

import study_runs  # before the next, whose directory it adds to the path
from pages import fill_all

import any_silo
import closed_silos
import design_case
import element_tests
import hopper_fields
import mass_matrix
import materials
import mesh_seeds
import operation
import outlet_sweep
import performance
import two_methods
import verification
import will_it_flow
import work_precision

STUDIES = {study.NAME: study
           for study in (any_silo, closed_silos, design_case, element_tests,
                         hopper_fields, outlet_sweep, mesh_seeds, mass_matrix,
                         materials, operation, performance, two_methods,
                         verification, will_it_flow, work_precision)}


def write_csv(name, rows):
    """Rows: dictionaries with the same keys."""
    directory = study_runs.output_of(name)
    directory.mkdir(parents=True, exist_ok=True)
    with open(directory / (name + ".csv"), "w", encoding="utf-8",
              newline="") as file:
        writer = csv.DictWriter(file, rows[0], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def main():
    names = [word for word in sys.argv[1:] if word != "--no-runs"]
    if len(names) != 1 or names[0] not in STUDIES:
        raise SystemExit("study what? " + ", ".join(STUDIES))
    study = STUDIES[names[0]]
    if "--no-runs" not in sys.argv[1:]:
        study.make_runs()
    rows = study.results()
    if not rows:
        raise SystemExit(f"{study.NAME}: nothing has been run")
    write_csv(study.NAME, rows)
    study.draw(rows)
    fill_all(study.parts(rows), study.NAME)


if __name__ == "__main__":
    main()
