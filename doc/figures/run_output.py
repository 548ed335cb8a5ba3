"""Reads the files of an output directory."""
import csv
import json
import math
import re

RUN_PARTS = ("setup", "static", "loop", "output")  # all of a run


def has_ended(directory):
    """Whether its run came to an end, the scene's or that of a breakdown."""
    return (directory / "input.txt").exists()


def read_summary(directory):
    with open(directory / "summary.json", encoding="utf-8") as file:
        return json.load(file)


def plateau(directory):
    if not has_ended(directory):
        return None
    return read_summary(directory)["flow_rate_plateau_kg_per_s"]


def read_table(directory, name):
    """The columns of a .csv file by name, as numbers where they are."""
    with open(directory / name, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))

    def value(text):
        try:
            return float(text)
        except ValueError:
            return text
    return {key: [value(row[key]) for row in rows] for key in rows[0]}


def count_points(directory, name):
    """In the first file of a series: the nodes of `grid`, the particles of
    `particles`. The number is in the file's head."""
    with open(directory / "vtu" / (name + "_00000.vtu"), "rb") as file:
        head = file.read(2000).decode("latin-1")
    return int(re.search(r'NumberOfPoints="(\d+)', head).group(1))


def discharge_time(directory):
    """When the silo is empty, or None: the first row of the history in which
    no material is above the outlet's level."""
    if not has_ended(directory):
        return None
    history = read_table(directory, "history.csv")
    for time, mass in zip(history["time_s"], history["mass_in_silo_kg"]):
        if time > 0 and mass <= 0:
            return time
    return None


def seconds_of(summary, *parts):
    """What these parts of a run have taken in all."""
    return sum(summary[part + "_seconds"] for part in parts)


def time_until(directory, share):
    """When this share of the mass has passed the outlet, in s; it must have."""
    table = read_table(directory, "flow_rate.csv")
    masses, times = table["discharged_mass_kg"], table["time_s"]
    target = share * read_summary(directory)["mass_initial_kg"]
    after = next(i for i, mass in enumerate(masses) if mass >= target)
    part = (target - masses[after - 1]) / (masses[after] - masses[after - 1])
    return times[after - 1] + part * (times[after] - times[after - 1])


def largest(directory, column):
    values = read_table(directory, "history.csv")[column]
    return max(value for value in values if not math.isnan(value))


def flow_rate_at(directory, time):
    """The mean over the window of flow_rate.csv that ends at `time`, or None
    if the run broke down before."""
    if not has_ended(directory):
        return None
    table = read_table(directory, "flow_rate.csv")
    times = table["time_s"]
    if times[-1] < time - 0.01:
        return None
    nearest = min(range(len(times)), key=lambda i: abs(times[i] - time))
    return table["mass_flow_rate_kg_per_s"][nearest]
