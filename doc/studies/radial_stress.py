"""Jenike's radial stress field in hoppers: stresses gamma r s(theta) of rigid
plastic material that slides down, by Runge and Kutta's method and shooting."""
import math
from typing import NamedTuple

STEPS = 300  # from the axis to the wall; 600 change the eighth digit
FASTEST = 0.95  # share of sin(delta) where cos(2 psi) has a singularity


class Field(NamedTuple):
    wall: float  # normal stress on the wall over gamma r
    axis: float  # radial stress on the axis over gamma r


def slopes(angle, stress, psi, sine, dimension):
    """Of the mean stress and of the larger principal stress' angle psi to the
    radius. Dimension: 0 in wedges, 1 in cones, where the stress around the axis
    is the larger principal one."""
    cosine_2, sine_2 = math.cos(2 * psi), math.sin(2 * psi)
    cotangent = 1 / math.tan(angle)
    along = -(stress * (1 + sine * cosine_2) + stress * (
        2 * sine * cosine_2 + dimension * (sine * (cosine_2 - 1) +
                                           sine * sine_2 * cotangent)) +
              math.cos(angle))
    across = -(3 * stress * sine * sine_2 + stress * dimension * (
        -sine * (cosine_2 + 1) * cotangent + sine * sine_2) -
               math.sin(angle))
    matrix = ((sine * sine_2, 2 * stress * sine * cosine_2),
              (1 - sine * cosine_2, 2 * stress * sine * sine_2))
    determinant = matrix[0][0] * matrix[1][1] - matrix[0][1] * matrix[1][0]
    return ((along * matrix[1][1] - matrix[0][1] * across) / determinant,
            (matrix[0][0] * across - matrix[1][0] * along) / determinant)


def shoot(on_axis, sine, half_angle, dimension):
    """Mean stress and psi at the wall; both are regular on the axis."""
    angle = 1e-5 * half_angle
    rise = ((1 + on_axis * (1 - 3 * sine - 2 * dimension * sine)) /
            (2 * on_axis * sine * (1 + dimension)))
    state = (on_axis, math.pi / 2 + rise * angle)
    step = (half_angle - angle) / STEPS

    def slope(offset, previous, share):
        return slopes(angle + offset, state[0] + share * previous[0],
                      state[1] + share * previous[1], sine, dimension)
    for _ in range(STEPS):
        first = slope(0., (0., 0.), 0.)
        second = slope(step / 2, first, step / 2)
        third = slope(step / 2, second, step / 2)
        fourth = slope(step, third, step)
        state = tuple(value + step / 6 * (a + 2 * b + 2 * c + d)
                      for value, a, b, c, d in zip(state, first, second, third,
                                                   fourth))
        angle += step
        if state[0] <= 0 or math.cos(2 * state[1]) > FASTEST * sine:
            return state[0], math.inf
    return state


def radial_field(friction_angle, half_angle, wall_friction_angle, dimension):
    """All angles in degrees; the friction angle is that of Mohr and Coulomb."""
    sine = math.sin(math.radians(friction_angle))
    half_angle = math.radians(half_angle)
    wall_friction = math.radians(wall_friction_angle)
    target = (math.pi + wall_friction +
              math.asin(math.sin(wall_friction) / sine)) / 2

    def at_wall(logarithm):
        return shoot(math.exp(logarithm), sine, half_angle, dimension)
    upper = 3.  # psi at the wall falls with the stress on the axis
    while at_wall(upper - 0.05)[1] < target:
        upper -= 0.05
    lower = upper - 0.05
    for _ in range(40):
        middle = (lower + upper) / 2
        if at_wall(middle)[1] < target:
            upper = middle
        else:
            lower = middle
    stress, psi = at_wall(upper)
    return Field(stress * (1 - sine * math.cos(2 * psi)),
                 math.exp(upper) * (1 - sine))
