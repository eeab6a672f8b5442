//! Work against precision: the time that a radius or a pressure takes, and its error, by several methods.
//!
//! ```text
//! cargo run --release --example work_precision
//! ```
//!
//! - The generated solver, in f64 and in f32, and `Polynomial`, which knows the geometry only at run time.
//!   They choose their quadrature themselves, so that each is one point.
//! - The generated kernels with Gauss-Legendre rules of 4 to 64 nodes for the memory.
//! - The paper's formulas (14), (25)–(27) as printed, with the crates `roots` and `gauss-quad`.
//! - The contact equation (5), differentiated in time and integrated with a fixed number of steps.
//!
//! An error is the largest in twelve scenes: the paper's joint, from soon after loading to χ t = 16. The README shows a
//! copy of the figure, `figures/work_precision.svg`.

mod clock;
mod fixed_order;
mod march;
#[path = "../../cartcontact/benches/scenes/printed.rs"]
mod printed;
mod scenes;

use std::error::Error;
use std::io::{self, Write};
use std::path::Path;
use std::process::ExitCode;

use cartcontact::{Contact, ContactError, GapProfile, Medium, Polynomial, Scalar, gap_profile, load};
use examples::figure::{Curve, Dash};
use examples::log_log::{self, Mark, Panel, Series};
use examples::page::Ink;
use march::Scheme;
use printed::FULL;
use scenes::{Exact, FORCE, RATE, SCENES, STIFFNESS, Scene};

#[gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)]
struct Patellofemoral;

/// Numbers of nodes of a rule.
const ORDERS: [usize; 8] = [4, 6, 8, 10, 14, 20, 32, 64];
/// Numbers of steps of a march.
const STEPS: [u32; 5] = [16, 64, 256, 1024, 4096];
/// Last steps of the search for a root, in mm.
const LAST_STEPS: [f64; 4] = [1.0, 1e-1, 1e-4, FULL];
/// The path of the figure, relative to the folder in which the program runs.
const FIGURE: &str = "target/cartcontact/work_precision.svg";

fn main() -> ExitCode {
    examples::run(run)
}

fn run() -> Result<(), Box<dyn Error>> {
    let radius = radius_methods()?;
    let pressure = pressure_methods()?;
    let mut out = io::stdout().lock();
    write_table(&mut out, "Contact radius", &radius)?;
    write_table(&mut out, "Pressure, radius included", &pressure)?;

    let panel = |title: &str, methods: Vec<Method>| Panel {
        title: title.to_owned(),
        x: "largest relative error",
        y: "time per result (ns)",
        series: methods.into_iter().map(Method::into_series).collect(),
    };
    log_log::write(Path::new(FIGURE), 95.0, &[panel("contact radius", radius), panel("pressure", pressure)])?;
    writeln!(out, "Figure\n  {FIGURE}")?;
    Ok(())
}

/// A method, with one point for each of its settings.
struct Method {
    name: &'static str,
    look: (Ink, Dash, Mark),
    points: Vec<Point>,
}

struct Point {
    /// The number of nodes or steps, or the last step of the search for a root.
    setting: String,
    error: f64,
    nanoseconds: f64,
}

/// The exact results for a method.
type Quantity = fn(&Scene) -> &Exact;

impl Method {
    fn new(name: &'static str, ink: Ink, dash: Dash, mark: Mark) -> Self {
        Self { name, look: (ink, dash, mark), points: Vec::new() }
    }

    /// Adds a point: times the method and compares its results with the exact ones.
    fn measure<E: Error + 'static>(
        &mut self,
        setting: impl ToString,
        exact: Quantity,
        solve: impl Fn(&Scene) -> Result<f64, E>,
    ) -> Result<(), Box<dyn Error>> {
        let mut error: f64 = 0.0;
        for scene in &SCENES {
            error = error.max(exact(scene).error(solve(scene)?));
        }
        let nanoseconds = clock::nanoseconds(|scene| solve(scene).unwrap_or(f64::NAN));
        self.points.push(Point { setting: setting.to_string(), error, nanoseconds });
        Ok(())
    }

    fn into_series(self) -> Series {
        let (ink, dash, mark) = self.look;
        let points = self.points.iter().map(|point| (point.error, point.nanoseconds)).collect();
        Series { curve: Curve { name: self.name.to_owned(), ink, dash, points }, mark }
    }
}

fn radius_methods() -> Result<Vec<Method>, Box<dyn Error>> {
    let exact: Quantity = |scene| &scene.radius;
    let [mut double, mut single, mut run_time, mut printed, mut euler, mut runge_kutta] = common_methods();
    let contacts = Contacts::new()?;
    double.measure("", exact, |scene| radius(&contacts.double, scene))?;
    single.measure("", exact, |scene| radius(&contacts.single, scene))?;
    run_time.measure("", exact, |scene| radius(&contacts.run_time, scene))?;
    for last in LAST_STEPS {
        let setting = format!("step < {last:?} mm");
        printed.measure(setting, exact, |scene| printed::radius(scene.time, last))?;
    }
    for (method, scheme) in [(&mut euler, Scheme::Euler), (&mut runge_kutta, Scheme::RungeKutta)] {
        for steps in STEPS {
            let setting = format!("{steps} steps");
            method.measure(setting, exact, |scene| march::radius(scheme, steps, scene.time))?;
        }
    }
    Ok(vec![double, single, run_time, printed, euler, runge_kutta])
}

fn pressure_methods() -> Result<Vec<Method>, Box<dyn Error>> {
    let exact: Quantity = |scene| &scene.pressure;
    let [mut double, mut single, mut run_time, mut printed, mut euler, mut runge_kutta] = common_methods();
    let contacts = Contacts::new()?;
    double.measure("", exact, |scene| pressure(&contacts.double, scene))?;
    single.measure("", exact, |scene| pressure(&contacts.single, scene))?;
    run_time.measure("", exact, |scene| pressure(&contacts.run_time, scene))?;
    let mut fixed = Method::new("kernels, fixed order", Ink::Blue, Dash::Solid, Mark::Diamond);
    for order in ORDERS {
        let setting = format!("{order} nodes");
        let pressure = fixed_order::Pressure::with_order(order)?;
        fixed.measure(&setting, exact, |scene| pressure.at(scene.time, scene.distance))?;
        let pressure = printed::Pressure::with_order(order)?;
        printed.measure(&setting, exact, |scene| pressure.at(scene.time, scene.distance))?;
    }
    for (method, scheme) in [(&mut euler, Scheme::Euler), (&mut runge_kutta, Scheme::RungeKutta)] {
        for steps in STEPS {
            let setting = format!("{steps} steps");
            method.measure(setting, exact, |scene| {
                march::pressure(scheme, steps, scene.time, scene.distance)
            })?;
        }
    }
    Ok(vec![double, single, run_time, fixed, printed, euler, runge_kutta])
}

/// The methods for both radius and pressure.
fn common_methods() -> [Method; 6] {
    [
        Method::new("generated, f64", Ink::Blue, Dash::Solid, Mark::Disc),
        Method::new("generated, f32", Ink::Blue, Dash::Solid, Mark::Ring),
        Method::new("Polynomial, f64", Ink::Blue, Dash::Solid, Mark::Square),
        Method::new("formulas as printed", Ink::Vermilion, Dash::Solid, Mark::Diamond),
        Method::new("steps of Euler", Ink::Vermilion, Dash::Dotted, Mark::Cross),
        Method::new("steps of Runge-Kutta", Ink::Vermilion, Dash::Dashed, Mark::Triangle),
    ]
}

type Held<T, P> = Contact<T, P, load::Constant<T>>;
type RunTime = Polynomial<f64, [(f64, f64); 2]>;

/// The contact in the three forms of the library.
struct Contacts {
    double: Held<f64, Patellofemoral>,
    single: Held<f32, Patellofemoral>,
    run_time: Held<f64, RunTime>,
}

impl Contacts {
    fn new() -> Result<Self, Box<dyn Error>> {
        let polynomial = Polynomial::new([(0.025, 2.0), (1.09375e-4, 4.0)])?;
        let (double, single) = (contact(Patellofemoral)?, contact(Patellofemoral)?);
        Ok(Self { double, single, run_time: contact(polynomial)? })
    }
}

fn contact<T: Scalar, P: GapProfile<T>>(profile: P) -> Result<Held<T, P>, Box<dyn Error>> {
    let medium = Medium::from_constants(T::constant(STIFFNESS), T::constant(RATE))?;
    Ok(Contact::new(profile, medium, load::Constant(T::constant(FORCE)))?)
}

fn radius<T: Scalar, P: GapProfile<T>>(contact: &Held<T, P>, scene: &Scene) -> Result<f64, ContactError> {
    Ok(contact.at(T::constant(scene.time))?.radius().value())
}

/// The pressure, for which the radius is solved too.
fn pressure<T: Scalar, P: GapProfile<T>>(contact: &Held<T, P>, scene: &Scene) -> Result<f64, ContactError> {
    Ok(contact.at(T::constant(scene.time))?.pressure(T::constant(scene.distance)).value())
}

fn write_table(out: &mut impl Write, title: &str, methods: &[Method]) -> io::Result<()> {
    writeln!(out, "{title:26} setting           largest error   time (ns)")?;
    for method in methods {
        for point in &method.points {
            let Point { setting, error, nanoseconds } = point;
            writeln!(out, "  {:24} {setting:16} {error:>14.1e} {nanoseconds:>11.1}", method.name)?;
        }
    }
    writeln!(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Times aside, every method gives the reference values: the solver, and a search that has converged, but for a few
    /// roundings, the others to the bounds with their reasons.
    #[test]
    fn all_ways_lead_to_the_same_results() -> Result<(), Box<dyn Error>> {
        /// The exponents of the decay, up to 16, are rounded.
        const KERNELS: f64 = 1e-14;
        /// At χ t = 16 the printed difference loses a digit or two.
        const PRINTED: f64 = 1e-13;
        /// A scheme of first order errs by the share of a step.
        const EULER: f64 = 1.0 / 4096.0;
        /// One of fourth order with 256 steps errs by 1.7e-10, and with 1024 by a 256th of that.
        const RUNGE_KUTTA: f64 = 1e-12;

        let generated = Contacts::new()?.double;
        let printed = printed::Pressure::with_order(32)?;
        let fixed = fixed_order::Pressure::with_order(32)?;
        for scene in &SCENES {
            let Scene { time, distance, radius: exact, pressure: exact_pressure } = scene;
            assert!(exact.error(radius(&generated, scene)?) < 2.0 * f64::EPSILON);
            assert!(exact.error(printed::radius(*time, FULL)?) < 2.0 * f64::EPSILON);
            assert!(exact.error(march::radius(Scheme::Euler, 4096, *time)?) < EULER);
            assert!(exact.error(march::radius(Scheme::RungeKutta, 1024, *time)?) < RUNGE_KUTTA);

            let error = |pressure| exact_pressure.error(pressure);
            assert!(error(pressure(&generated, scene)?) < 8.0 * f64::EPSILON);
            assert!(error(fixed.at(*time, *distance)?) < KERNELS);
            assert!(error(printed.at(*time, *distance)?) < PRINTED);
            assert!(error(march::pressure(Scheme::Euler, 4096, *time, *distance)?) < EULER);
            assert!(error(march::pressure(Scheme::RungeKutta, 1024, *time, *distance)?) < RUNGE_KUTTA);
        }
        Ok(())
    }
}
