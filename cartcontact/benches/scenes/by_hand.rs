//! The solver of 0.025 r² + 1.09375e-4 r⁴ as one would write it by hand, for this geometry and f64 only.
//!
//! Radii come from a table of cubics in the fraction of the load integral and one step of Halley's method, or, in the
//! usual way, from Newton's method; the other evaluators are nested polynomials in a². Neither code nor tables are
//! shared with the library, whose generated code has to be as quick as this.

/// J(a) = s³ (`J6` + `J8` s) with s = a².
const J6: f64 = 1.0 / 480.0;
const J8: f64 = 7.0 / 768_000.0;

/// The table holds load integrals from 2^`FIRST` to 2^(`FIRST` + `OCTAVES`), with four rows per octave: 4 KiB.
const FIRST: i32 = -42;
const OCTAVES: usize = 64;

static SEEDS: [[f32; 4]; 4 * OCTAVES] = seeds();

/// The contact radius from the table, or by Newton's method for load integrals outside it.
#[inline]
pub(crate) fn radius(load_integral: f64) -> f64 {
    let (index, fraction) = place(load_integral);
    match SEEDS.get(index) {
        Some(row) => halley(f64::from(cubic(row, fraction)), load_integral),
        None => outside(load_integral),
    }
}

/// Many radii: first the seeds, then the steps, which the compiler turns into vector code, of 128 bits for any x86-64
/// processor.
pub(crate) fn radii(load_integrals: &[f64], radii: &mut [f64]) {
    for (load_integrals, radii) in load_integrals.chunks(64).zip(radii.chunks_mut(64)) {
        let mut seeds = [0.0; 64];
        let mut inside = true;
        for (seed, &load_integral) in seeds.iter_mut().zip(load_integrals) {
            let (index, fraction) = place(load_integral);
            inside &= index < SEEDS.len();
            *seed = cubic(&SEEDS[index.min(SEEDS.len() - 1)], fraction);
        }
        for ((radius, &load_integral), &seed) in radii.iter_mut().zip(load_integrals).zip(&seeds) {
            *radius = halley(f64::from(seed), load_integral);
        }
        if !inside {
            for (radius, &load_integral) in radii.iter_mut().zip(load_integrals) {
                *radius = self::radius(load_integral);
            }
        }
    }
}

/// The contact radius without a table: Newton's method from the smaller of the two one-term radii.
///
/// This start is above the root, and as J is convex the method always descends from there; it ends when a step no
/// longer leads down.
#[inline]
pub(crate) fn radius_by_newton(load_integral: f64) -> f64 {
    let eighth = (load_integral * (1.0 / J8)).sqrt().sqrt().sqrt();
    let mut a = (load_integral * (1.0 / J6)).cbrt().sqrt().min(eighth);
    loop {
        let s = a * a;
        let fifth = s * s * a;
        let surplus = fifth * a * (J6 + J8 * s) - load_integral;
        let next = a - surplus / (fifth * (6.0 * J6 + 8.0 * J8 * s));
        if next.partial_cmp(&a) != Some(core::cmp::Ordering::Less) {
            return next;
        }
        a = next;
    }
}

#[inline]
pub(crate) fn approach(a: f64) -> f64 {
    let s = a * a;
    s * (0.0125 + 7.0 / 192_000.0 * s)
}

#[inline]
pub(crate) fn load_integral(a: f64) -> f64 {
    let s = a * a;
    s * s * s * (J6 + J8 * s)
}

#[inline]
pub(crate) fn pressure_kernel(a: f64, r: f64) -> f64 {
    if r >= a {
        return 0.0;
    }
    let inset = (a - r) * (a + r);
    inset * inset * (0.0015625 + 7.0 / 2_304_000.0 * (2.0 * (a * a) + r * r))
}

#[cold]
#[inline(never)]
fn outside(load_integral: f64) -> f64 {
    if load_integral == 0.0 { 0.0 } else { radius_by_newton(load_integral) }
}

/// The index of the row, from the exponent and the first two bits of the fraction, and the fraction.
#[inline(always)]
fn place(load_integral: f64) -> (usize, f32) {
    let bits = load_integral.to_bits();
    let index = (bits >> 50).wrapping_sub((4 * (1023 + FIRST)) as u64);
    (index as usize, f32::from_bits((bits >> 29) as u32 & 0x007f_ffff | 0x3f80_0000))
}

/// Two independent halves: one multiplication more than Horner's rule, but a shorter latency.
#[inline(always)]
fn cubic(row: &[f32; 4], u: f32) -> f32 {
    (row[0] + u * row[1]) + u * u * (row[2] + u * row[3])
}

/// a − a f aJ′ / ((aJ′)² − f a²J″/2) with f = J − y, everything over J8 s³, in s = a².
#[inline(always)]
const fn halley(a: f64, load_integral: f64) -> f64 {
    const RATIO: f64 = J6 / J8;
    let s = a * a;
    let cube = s * s * s;
    let surplus = cube * (RATIO + s) - load_integral * (1.0 / J8);
    let first = 0.75 * RATIO + s;
    let half_second = 15.0 / 64.0 * RATIO + 0.4375 * s;
    a - (0.125 * a * first) * surplus / (cube * first * first - surplus * half_second)
}

/// In each row, the cubic through the radii at the four Chebyshev points of the load integrals of the row.
const fn seeds() -> [[f32; 4]; 4 * OCTAVES] {
    // cos(π/8) and cos(3π/8).
    const POINTS: [f64; 4] = [
        -0.923_879_532_511_286_7,
        -0.382_683_432_365_089_8,
        0.382_683_432_365_089_8,
        0.923_879_532_511_286_7,
    ];
    let mut rows = [[0.0; 4]; 4 * OCTAVES];
    let mut a = 1e-6;
    let mut index = 0;
    while index < rows.len() {
        let octave = f64::from_bits(((1023 + FIRST) as u64 + index as u64 / 4) << 52);
        let (mut u, mut radii) = ([0.0; 4], [0.0; 4]);
        let mut k = 0;
        while k < 4 {
            u[k] = 1.0 + 0.25 * (index % 4) as f64 + 0.125 * (1.0 + POINTS[k]);
            // Halley's method starts from the last radius, and needs more steps only in the first row.
            let mut step = 0;
            while step < if index == 0 { 60 } else { 6 } {
                a = halley(a, octave * u[k]);
                step += 1;
            }
            radii[k] = a;
            k += 1;
        }
        rows[index] = interpolated(u, radii);
        index += 1;
    }
    rows
}

/// The cubic through four points in ascending powers: Newton's divided differences, multiplied out.
const fn interpolated(u: [f64; 4], mut values: [f64; 4]) -> [f32; 4] {
    let mut order = 1;
    while order < 4 {
        let mut k = 3;
        while k >= order {
            values[k] = (values[k] - values[k - 1]) / (u[k] - u[k - order]);
            k -= 1;
        }
        order += 1;
    }
    let mut powers = [values[3], 0.0, 0.0, 0.0];
    let mut k = 3;
    while k > 0 {
        k -= 1;
        // powers ← powers · (u − u_k) + values_k
        let mut i = 3;
        while i > 0 {
            powers[i] = powers[i - 1] - u[k] * powers[i];
            i -= 1;
        }
        powers[0] = values[k] - u[k] * powers[0];
    }
    [powers[0] as f32, powers[1] as f32, powers[2] as f32, powers[3] as f32]
}
