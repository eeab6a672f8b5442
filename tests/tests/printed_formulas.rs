//! The page "Where the printed formulas fail", measured against the oracle; `UPDATE_GOLDEN=1` renews it.

use core::f64::consts::FRAC_PI_4;
use core::num::NonZeroUsize;
use std::path::Path;
use std::{env, fs};

use cartcontact::GapProfile;
use cartcontact::load::Constant;
use gauss_quad::GaussLegendre;
use tests::joint::joint;
use tests::measure::relative_error;
use tests::oracle::{Oracle, Profile, double, rounded};
use tests::profiles::{Patellofemoral, case};

const M: f64 = 0.375;
const CHI: f64 = 0.0015;
const FORCE: f64 = 100.0;

/// The decimal digits lost to relative errors in units of ε: none below 10, at most all sixteen.
fn digits_lost(errors: impl IntoIterator<Item = f64>) -> f64 {
    errors.into_iter().fold(1.0, f64::max).log10().floor().min(16.0)
}

/// Σ C/(2 (n+2)²) [n aⁿ⁺² − (n+2) aⁿ r² + 2 rⁿ⁺²], Eq. (26).
fn printed_kernel(a: f64, r: f64) -> f64 {
    let term = |c: f64, n: i32| {
        let k = f64::from(n);
        let bracket = k * a.powi(n + 2) - (k + 2.0) * a.powi(n) * r * r + 2.0 * r.powi(n + 2);
        c / (2.0 * (k + 2.0) * (k + 2.0)) * bracket
    };
    term(0.025, 2) + term(1.09375e-4, 4)
}

/// The digits lost by Eq. (26) and by the crate at a depth 1 − r/a, the worst of a hundred contact radii.
fn near_the_edge(oracle: &Profile, depth: f64) -> [f64; 2] {
    let places = (0..100).map(|index| 1.0 + 0.07 * f64::from(index)).map(|a| (a, a * (1.0 - depth)));
    let expected: Vec<_> =
        places.map(|(a, r)| (a, r, rounded(&oracle.pressure_kernel(&double(a), &double(r))))).collect();
    let kernels: [fn(f64, f64) -> f64; 2] = [printed_kernel, |a, r| Patellofemoral.pressure_kernel(a, r)];
    kernels.map(|kernel| {
        digits_lost(
            expected.iter().map(|&(a, r, expected)| relative_error(kernel(a, r), expected, f64::EPSILON)),
        )
    })
}

/// m [G(a(t), r) − χ ∫ G(a(τ), r) e^(−χ (t−τ)) dτ], Eq. (25), with radii and kernels to the last digit.
///
/// In z = χ (t − τ) the integrand is smooth on panels of length 1; contributions beyond z = 45 are below ε.
fn printed_pressure(r: f64, t: f64) -> f64 {
    let radius = |z: f64| {
        let hereditary = FORCE * (1.0 + (CHI * t - z));
        Patellofemoral.radius(hereditary / (M * FRAC_PI_4)).unwrap_or(f64::NAN)
    };
    let kernel = |z: f64| Patellofemoral.pressure_kernel(radius(z), r);
    let rule = GaussLegendre::new(NonZeroUsize::new(24).unwrap_or(NonZeroUsize::MIN));
    let longest = (CHI * t).min(45.0);
    let panel = |start: f64| rule.integrate(start, (start + 1.0).min(longest), |z| kernel(z) * (-z).exp());
    let memory: f64 = (0..45).map(f64::from).filter(|start| *start < longest).map(panel).sum();
    M * (kernel(0.0) - memory)
}

/// The digits lost by Eq. (25) and by the crate after χ t, the worst of eight radii up to half the first contact
/// radius.
fn at_long_times(oracle: &Oracle, folds: f64) -> [f64; 2] {
    let (t, radii) = (folds / CHI, core::array::from_fn::<_, 8, _>(|index| 0.5 * index as f64));
    let expected = oracle.pressures(radii, t).map(|pressure| rounded(&pressure));
    let contact = joint(Patellofemoral, CHI, Constant(FORCE));
    let now = contact.at(t).unwrap_or_else(|error| unreachable!("{error}"));
    let pressures: [&dyn Fn(f64) -> f64; 2] = [&|r| printed_pressure(r, t), &|r| now.pressure(r)];
    pressures.map(|pressure| {
        let errors = radii.iter().zip(&expected);
        digits_lost(errors.map(|(&r, &expected)| relative_error(pressure(r), expected, f64::EPSILON)))
    })
}

fn page() -> String {
    let profile = case("Patellofemoral").oracle();
    let contact = Oracle::new(profile.clone(), M, CHI, &[(0.0, FORCE)]);
    let mut page = String::from(
        "Where the printed formulas lose digits.\n\
         \n\
         Apart from χ, see [`Medium::between`](crate::Medium::between), the formulas of the paper are exact, but\n\
         evaluated as they are printed they subtract numbers that are nearly equal. The tables show how many of the\n\
         sixteen decimal digits of `f64` that costs, for the gap 0.025 r² + 1.09375e-4 r⁴ and against results with more\n\
         than 40 digits; 0 stands for an error below 10 ε. The tests measure them anew.\n\
         \n\
         # Near the edge of the contact\n\
         \n\
         The bracket of Eq. (26), Σ C/(2 (n+2)²) [n aⁿ⁺² − (n+2) aⁿ r² + 2 rⁿ⁺²], has a double zero at r = a. The crate\n\
         uses (a − r)² as a factor instead, times a sum of positive terms\n\
         ([`pressure_kernel`](crate::GapProfile::pressure_kernel)).\n\
         \n\
         | 1 − r/a | digits lost by Eq. (26) | by this crate |\n\
         |---|---|---|\n",
    );
    for power in 1..=10 {
        let [printed, ours] = near_the_edge(&profile, 10_f64.powi(-power));
        page += &format!("| 1e-{power} | {printed} | {ours} |\n");
    }
    page += "\n\
         # At long times\n\
         \n\
         Eq. (25), m [G(a(t), r) − χ ∫ G(a(τ), r) e^(−χ (t−τ)) dτ], subtracts from the pressure before drainage what has\n\
         drained since, which under a held load is all of it but a share of about 1/(χ t). For this table, radii,\n\
         kernels and the integral are evaluated to the last digit, so that the only loss is that of the difference. The\n\
         crate integrates by parts, which leaves positive terms only ([`pressure`](crate::Snapshot::pressure)).\n\
         Pressures are compared up to half the first contact radius from the axis.\n\
         \n\
         | χ t | digits lost by Eq. (25) | by this crate |\n\
         |---|---|---|\n";
    for folds in [1.0, 10.0, 100.0, 1e3, 1e4] {
        let [printed, ours] = at_long_times(&contact, folds);
        page += &format!("| {folds} | {printed} | {ours} |\n");
    }
    page + "\n\
         # References\n\
         \n\
         I. Argatov, Mech. Res. Commun. 38 (2011) 29–33, doi 10.1016/j.mechrescom.2010.11.006.\n"
}

#[test]
fn the_page_on_printed_formulas_is_what_is_measured() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cartcontact/src/printed_formulas.md");
    let page = page();
    if env::var_os("UPDATE_GOLDEN").is_some() {
        fs::write(&file, &page).unwrap_or_else(|error| unreachable!("{}: {error}", file.display()));
    }
    let golden = fs::read_to_string(&file).unwrap_or_default();
    assert!(page == golden, "UPDATE_GOLDEN=1 renews {}:\n{page}", file.display());
}
