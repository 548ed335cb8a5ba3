"""What a step costs on many ranks, from the sizes of its messages: a model, not
a measurement. Plane strain, triangles, four particles in each."""
import math

from tables import markdown

RANKS = (1, 10, 100, 1000)
STRONG_PARTICLES = 1_300_000
WEAK_PARTICLES = 20_000  # on each rank

# A network of today, rounded.
LATENCY = 2e-6  # s, one message or one stage of a reduction
BANDWIDTH = 1e10  # bytes/s

PARTICLES_PER_ELEMENT = 4
ELEMENTS_PER_NODE = 2
NEIGHBORS = 6

# In one step with the automatic time step. Nodal exchanges and their
# components: sums 7, acceleration 2, momentum 2, velocity 2; every 20 steps
# seven iterations of Lanczos' method, each with five exchanges of 2.
EXCHANGES = 4 + 7 * 5 / 20
COMPONENTS = 7 + 2 + 2 + 2 + 7 * 5 * 2 / 20
# All-reductions: local eigenvalue, faults, the handover of particles; two in
# each iteration.
REDUCTIONS = 3 + 7 * 2 / 20
# Loops over a rank's elements in search of those with particles.
SCANS = 3 + 7 * 2 / 20
SCAN_TIME = 3e-10  # s for each element


def bytes_exchanged(particles):
    """By one rank in one step. Its ghosts: the nodes on its border that others
    own, about half of those around a square, and the next row of nodes."""
    nodes = particles / PARTICLES_PER_ELEMENT / ELEMENTS_PER_NODE
    return (2 + 4) * math.sqrt(nodes) * COMPONENTS * 8


def step_time(all_particles, ranks, particle_time):
    """Work, scans and communication in s."""
    own = all_particles / ranks
    work = own * particle_time
    scans = SCANS * SCAN_TIME * own / PARTICLES_PER_ELEMENT
    if ranks == 1:
        return work, scans, 0.
    communication = (EXCHANGES * LATENCY * math.sqrt(NEIGHBORS) +
                     bytes_exchanged(own) / BANDWIDTH +
                     REDUCTIONS * LATENCY * math.log2(ranks))
    return work, scans, communication


def efficiency(all_particles, ranks, particle_time):
    parts = step_time(all_particles, ranks, particle_time)
    alone = all_particles / ranks * particle_time
    return alone / sum(parts)


def percent(value):
    return f"{100 * value:.0f} %"


def table(particle_nanoseconds):
    particle_time = 1e-9 * particle_nanoseconds
    lines = []
    for ranks in RANKS:
        work, scans, communication = (
            1e6 * part for part in step_time(STRONG_PARTICLES, ranks,
                                             particle_time))
        volume = (bytes_exchanged(STRONG_PARTICLES / ranks) / 1024
                  if ranks > 1 else 0)
        lines.append([ranks, f"{work:.0f}", f"{scans:.0f}",
                      f"{communication:.0f}", f"{volume:.0f}",
                      percent(efficiency(STRONG_PARTICLES, ranks,
                                         particle_time)),
                      percent(efficiency(ranks * WEAK_PARTICLES, ranks,
                                         particle_time))])
    return markdown(["ranks", "particles, µs", "search for filled elements, µs",
                     "communication, µs", "KiB sent per rank",
                     "efficiency, 1.3 million in all",
                     "efficiency, 20 000 per rank"], lines)
