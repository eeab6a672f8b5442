"""The pressures that tests/loads_from_nothing.rs expects, to 25 digits.

Under a load that begins with nothing there is no first contact, and Eq. (28) leaves

    P(r, t) = (2/π) ∫ Y′ (a² − r²)/a⁴ e^(−χ (t−τ)) dτ,    Y = F + χ ∫F,    (π m/4) J(a) = Y,

from the time at which the edge was at r.

Needs mpmath: python3 tests/reference/loads_from_nothing.py
"""

from mpmath import exp, findroot, log1p, mp, mpf, nstr, pi, quad, sin

mp.dps = 30
CHI, M, SQUARE, FOURTH = mpf("0.02"), mpf("0.375"), mpf("0.025"), mpf("1.09375e-4")


def radius_squared(hereditary):
    """a² of J = (C₂ a⁶ + C₄ a⁸)/12, by Newton's method from above."""
    target = 48 * hereditary / (pi * M)
    square = (target / SQUARE) ** (mpf(1) / 3)
    for _ in range(200):
        value, slope = square**3 * (SQUARE + FOURTH * square), square**2 * (3 * SQUARE + 4 * FOURTH * square)
        step = (value - target) / slope
        square -= step
        if abs(step) < square * mpf(10) ** -28:
            return square
    raise ArithmeticError(hereditary)


def pressure(t, force, rate, impulse, borders, r=0, power=1):
    """P(r, t) from F, F′ and ∫F, with borders where they change quickly; at the first one the edge is at r.

    The integral is over the root of the time with this power, in which the integrand is smooth.
    """

    def integrand(u):
        tau = u**power
        square = radius_squared(force(tau) + CHI * impulse(tau))
        change = rate(tau) + CHI * force(tau)
        share = (square - r * r) / (square * square)
        return change * share * exp(-CHI * (t - tau)) * power * u ** (power - 1)

    borders = [mpf(border) ** (mpf(1) / power) for border in borders]
    return 2 / pi * quad(integrand, borders)


def show(name, value):
    print(f"{name:28} {nstr(value, 25)}")


def half_a_cosine(t, duration=1):
    t, d = mpf(t), mpf(duration)
    rise = (
        lambda s: 100 * sin(pi * s / 2 / d) ** 2 if s < d else mpf(100),
        lambda s: 50 * pi / d * sin(pi * s / d) if s < d else mpf(0),
        lambda s: 50 * (s - d / pi * sin(pi * s / d)) if s < d else 50 * d + 100 * (s - d),
    )
    # Where an e-folding is short, only the last ones count.
    borders = [max(mpf(0), t - folds / CHI) for folds in (80, 40, 20, 10, 5, 2, 1)] + [mpf(0), min(t, d), t]
    return pressure(t, *rise, sorted(set(borders)))


def root():
    """90 (t − 100)^0.1 at 101 s, in the time since the knot, where Y′ is infinite."""
    force, impulse = lambda s: 90 * s ** mpf("0.1"), lambda s: 90 / mpf("1.1") * s ** mpf("1.1")
    return pressure(mpf(1), force, lambda s: 9 * s ** mpf("-0.9"), impulse, [0, 1], power=30)


def logistic(t, steepness):
    """90/(1 + e^(−b (t − 100))), from where it is e^(−230) of its end."""
    t, b = mpf(t), mpf(steepness)
    share = lambda s: 1 / (1 + exp(-b * (s - 100)))
    impulse = lambda s: 90 / b * log1p(exp(b * (s - 100)))
    borders = [100 + k / b for k in (-230, -120, -60, -30, -15, -8, -4, -2, -1, 0, 1, 2, 4, 8, 15, 30, 60)]
    borders = [border for border in borders if border < t] + [t]
    return pressure(t, lambda s: 90 * share(s), lambda s: 90 * b * share(s) * (1 - share(s)), impulse, borders)


def high_power(n):
    impulse = lambda s: s ** (n + 1) / (n + 1)
    return pressure(mpf(1), lambda s: s**n, lambda s: n * s ** (n - 1), impulse, [0, 0.5, 0.9, 1])


def behind_a_rest(r):
    """(t − 1)^1.5 at 100 s, in the time since the knot."""
    force, impulse = lambda s: s ** mpf("1.5"), lambda s: s ** mpf("2.5") / mpf("2.5")
    edge = lambda s: radius_squared(force(s) + CHI * impulse(s)) - r * r
    first = findroot(edge, (mpf("1e-6"), mpf(50)), solver="anderson")
    borders = [first + (99 - first) * mpf(part) / 8 for part in range(9)]
    return pressure(mpf(99), force, lambda s: mpf("1.5") * s ** mpf("0.5"), impulse, borders, r=r)


def two_rises(t):
    """(t − 1)^1.5, and 50 N more in some hundredths around 2 s, in the time since the knot."""
    t, width = mpf(t) - 1, mpf("0.005")
    share = lambda s: 1 / (1 + exp((1 - s) / width))
    force = lambda s: s ** mpf("1.5") + 50 * share(s)
    rate = lambda s: mpf("1.5") * s ** mpf("0.5") + 50 / width * share(s) * (1 - share(s))
    softplus = lambda x: log1p(exp(x)) if x < 0 else x + log1p(exp(-x))
    impulse = lambda s: s ** mpf("2.5") / mpf("2.5") + 50 * width * (softplus((s - 1) / width) - softplus(-1 / width))
    borders = [0, 0.1, 0.5, 0.8] + [1 + k * width for k in (-20, -12, -7, -4, -2, -1, 0, 1, 2, 4, 7, 12, 20)]
    borders = [border for border in borders if border < t] + [t]
    return pressure(t, force, rate, impulse, borders, power=2)


for time in ["0.5", "1", "3"]:
    show(f"half a cosine, {time} s", half_a_cosine(time))
for time in ["50", "300", "1000", "1100"]:
    show(f"half a slow cosine, {time} s", half_a_cosine(time, 1000))
show("a root, 101 s", root())
for time in ["100", "110"]:
    show(f"a steep logistic, {time} s", logistic(time, 8))
show("a logistic, 101 s", logistic("101", 2))
for exponent in [20, 30]:
    show(f"t^{exponent}, 1 s", high_power(exponent))
for distance in [1, 3]:
    show(f"behind a rest, 100 s, {distance} mm", behind_a_rest(distance))
for time in ["2.1", "3"]:
    show(f"two rises, {time} s", two_rises(time))
