"""The radial stress field in cones of material that flows along the deviator and
keeps its volume: stresses gamma r S(theta) with the velocity -f(theta) / r^2,
so that the stress around the axis is that across the radius."""
import math

STEPS = 400  # from the axis to the wall


def matsuoka_nakai(sine):
    """Solves I1 I2 / I3 = k for x = s_theta / p, with t = tau / s_theta; the
    deviator is (-2, 1, 1) x p and the shear stress t x p."""
    k = (9 - sine**2) / (1 - sine**2)

    def ratio(shear):
        square = shear * shear
        x = 3 * sine / (3 + sine)  # less than the root
        for _ in range(50):  # Newton's method
            value = (9 - 3 * x**2 * (3 + square) -
                     k * (1 - x**2 * (3 + square) - x**3 * (2 + square)))
            slope = ((k - 3) * 2 * x * (3 + square) +
                     3 * k * x**2 * (2 + square))
            x -= value / slope
            if abs(value) < 1e-13:
                break
        return x
    return ratio


def shear_of(ratio, mobilised):
    """t where the shear stress over the stress across the radius is
    `mobilised`."""
    shear = 0.
    for _ in range(200):
        x = ratio(shear)
        new_shear = mobilised * (1 + x) / x
        if abs(new_shear - shear) < 1e-12:
            break
        shear = new_shear
    return shear


def shoot(on_axis, ratio, half_angle):
    """Stress across the radius and shear stress at the wall."""
    step = half_angle / STEPS

    def slopes(angle, across, shear_stress):
        x = ratio(shear_of(ratio, shear_stress / across))
        source = across * (1 - 8 * x) / (1 + x) + math.cos(angle)
        if angle == 0.:
            return 0., -source / 2
        return (math.sin(angle) - 4 * shear_stress,
                -source - shear_stress / math.tan(angle))
    state, angle = (on_axis, 0.), 0.
    for _ in range(STEPS):  # the midpoint rule
        first = slopes(angle, *state)
        middle = [value + step / 2 * slope
                  for value, slope in zip(state, first)]
        second = slopes(angle + step / 2, *middle)
        state = tuple(value + step * slope
                      for value, slope in zip(state, second))
        angle += step
        if state[0] <= 0 or abs(state[1]) > 0.9 * state[0]:
            break
    return state


def wall_stress(ratio, half_angle, wall_friction_angle):
    """Over gamma r; angles in degrees."""
    tangent = math.tan(math.radians(wall_friction_angle))
    half_angle = math.radians(half_angle)
    # The less friction is mobilised, the larger the stress on the axis.
    lower, upper = 1e-4, 20.
    for _ in range(60):
        middle = math.sqrt(lower * upper)
        across, shear_stress = shoot(middle, ratio, half_angle)
        if across <= 0 or -shear_stress > tangent * across:
            lower = middle
        else:
            upper = middle
    return shoot(upper, ratio, half_angle)[0]
