//! What `cartcontact` costs when a program is compiled: `cargo run --release -p tests --bin compile_cost`.
//!
//! The first part is what an annotation adds to `cargo check`: its expansion, which the test `effort_is_bounded` of
//! the macro crate measures alone, and the check of the generated code. The crate ends in an error, so that it is
//! checked every time.
//!
//! The second part is a clean build of a crate that uses `cartcontact`, against one that uses `serde` with its derive
//! macro. Both builds have the same profile and an empty target directory, and take turns; the least of several counts.
//! Processor time of all children is more reliable than the clock where other programs run, and is known on Linux only.

use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

/// Annotated structs in a crate: enough for their time to exceed the error of the clock.
const STRUCTS: u32 = 20;
const EXPANSIONS: usize = 5;
/// The error at the end of that crate.
const END: &str = "stop here";
const BUILDS: usize = 3;

type Failure = Box<dyn Error>;

/// Elapsed time, and processor time where it is known.
#[derive(Clone, Copy, Debug)]
struct Cost {
    elapsed: Duration,
    processor: Option<Duration>,
}

impl Cost {
    const MOST: Self = Self { elapsed: Duration::MAX, processor: Some(Duration::MAX) };

    fn least(self, other: Self) -> Self {
        let processor = self.processor.zip(other.processor).map(|(own, other)| own.min(other));
        Self { elapsed: self.elapsed.min(other.elapsed), processor }
    }

    /// The time that decides: processor time if it is known.
    fn seconds(self) -> f64 {
        self.processor.unwrap_or(self.elapsed).as_secs_f64()
    }
}

fn main() -> Result<(), Failure> {
    let folder = std::env::temp_dir().join(format!("cartcontact-compile-cost-{}", std::process::id()));
    let result = expansions(&folder).and_then(|()| builds(&folder));
    fs::remove_dir_all(&folder)?;
    result
}

/// A sum of powers; those with an exponent of 0 or 1 modulo 4 have the sign `sign`.
fn sum(exponents: impl Iterator<Item = u32>, sign: char) -> String {
    let terms = exponents.map(|n| format!("{} 1.234567e-{n} * r^{n}", if n % 4 > 1 { '+' } else { sign }));
    terms.collect::<Vec<String>>().join(" ")
}

fn expansions(folder: &Path) -> Result<(), Failure> {
    println!(
        "what one annotation adds to `cargo check`, its macro unoptimised as cargo builds it by default"
    );
    let user = User::new(folder, "expansion", &cartcontact())?;
    let mut empty = Cost::MOST;
    for (name, attribute) in [
        ("nothing", String::new()),
        ("2 terms", "0.025 * r^2 + 1.09375e-4 * r^4".to_owned()),
        ("2 terms, other powers", "0.02 * r^2.37 + 1e-4 * r^4.11".to_owned()),
        ("10 terms", sum((2..22).step_by(2), '+')),
        ("10 terms, signs mixed", sum((2..22).step_by(2), '-') + ", max_radius = 0.5"),
        ("degree 64", sum(2..65, '+')),
        ("degree 64, signs mixed", sum(2..65, '-') + ", max_radius = 0.5"),
        ("two spheres, order 4", "sphere(10) - sphere(20), order = 4, max_radius = 6".to_owned()),
        (
            "two conics, order = auto",
            "conic(10.37, -0.2) - sphere(20.11), order = auto, tolerance = 1e-9, max_radius = 7.1".to_owned(),
        ),
    ] {
        let count = if attribute.is_empty() { 0 } else { STRUCTS };
        let structs = (0..count)
            .map(|index| format!("#[cartcontact::gap_profile({attribute})] pub struct S{index};\n"));
        let source = structs.collect::<String>() + &format!("compile_error!({END:?});");
        let mut cost = Cost::MOST;
        for _ in 0..=EXPANSIONS {
            // Cargo decides by the time of a file whether it is new, and repeats a failed run anyway.
            fs::write(user.folder.join("src/lib.rs"), &source)?;
            let (own, outcome) = user.cargo(&["check"])?;
            stops_at_the_end(name, &outcome)?;
            cost = cost.least(own);
        }
        if count == 0 {
            empty = cost;
        } else {
            println!("{name:26} {:6.1} ms", 1e3 * (cost.seconds() - empty.seconds()) / f64::from(count));
        }
    }
    Ok(())
}

/// Fails unless the error at the end of the crate is the only one: the time of a refused annotation is no measurement.
fn stops_at_the_end(name: &str, outcome: &Output) -> Result<(), Failure> {
    let text = String::from_utf8_lossy(&outcome.stderr);
    let errors = text.lines().filter(|line| line.starts_with("error") && !line.contains("could not compile"));
    let is_alone = errors.eq([format!("error: {END}")]);
    if is_alone { Ok(()) } else { Err(format!("{name}: the check fails elsewhere\n{text}").into()) }
}

fn builds(folder: &Path) -> Result<(), Failure> {
    let users = [
        (
            "cartcontact, libm",
            User::new(folder, "cartcontact-user", &cartcontact())?,
            "#[cartcontact::gap_profile(0.025 * r^2 + 1.09375e-4 * r^4)] pub struct Patellofemoral;",
        ),
        (
            "serde, derive",
            User::new(folder, "serde-user", "serde = { version = \"1\", features = [\"derive\"] }")?,
            "#[derive(serde::Serialize, serde::Deserialize)] pub struct Patellofemoral { pub radius: f64 }",
        ),
    ];
    let mut costs = [Cost::MOST; 2];
    for (_, user, source) in &users {
        fs::write(user.folder.join("src/lib.rs"), source)?;
    }
    for _ in 0..BUILDS {
        for ((name, user, _), cost) in users.iter().zip(&mut costs) {
            let target = user.folder.join("target");
            if target.exists() {
                fs::remove_dir_all(target)?;
            }
            // Cargo builds path dependencies incrementally, but not those from a registry.
            let (own, outcome) = user.cargo(&["build", "--config", "build.incremental=false"])?;
            if !outcome.status.success() {
                return Err(format!("the crate that uses {name} does not build").into());
            }
            *cost = cost.least(own);
        }
    }
    println!("\nclean build of a crate that uses it, elapsed and of the processor");
    for ((name, ..), cost) in users.iter().zip(&costs) {
        let processor = cost
            .processor
            .map_or_else(|| "unknown".to_owned(), |time| format!("{:.2} s", time.as_secs_f64()));
        println!("{name:20} {:6.2} s, {processor}", cost.elapsed.as_secs_f64());
    }
    let [own, serde] = costs;
    println!("ratio {:.2}, of the processor's times", own.seconds() / serde.seconds());
    println!("ratio {:.2}, of elapsed times", own.elapsed.as_secs_f64() / serde.elapsed.as_secs_f64());
    Ok(())
}

fn cartcontact() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cartcontact");
    format!("cartcontact = {{ path = {path:?}, default-features = false, features = [\"libm\"] }}")
}

/// A user's crate.
struct User {
    folder: PathBuf,
}

impl User {
    /// Writes its manifest and fetches its dependencies, which is not measured.
    fn new(folder: &Path, name: &str, dependency: &str) -> Result<Self, Failure> {
        let folder = folder.join(name);
        fs::create_dir_all(folder.join("src"))?;
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n[dependencies]\n{dependency}\n\n[workspace]\n"
        );
        fs::write(folder.join("Cargo.toml"), manifest)?;
        fs::write(folder.join("src/lib.rs"), "")?;
        let user = Self { folder };
        let fetched = Command::new(env!("CARGO")).arg("fetch").current_dir(&user.folder).status()?;
        if fetched.success() { Ok(user) } else { Err("cargo fetch failed".into()) }
    }

    /// Runs cargo and returns the cost and the output.
    fn cargo(&self, arguments: &[&str]) -> Result<(Cost, Output), Failure> {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(arguments).arg("--offline").current_dir(&self.folder);
        cargo.env("CARGO_TARGET_DIR", self.folder.join("target")).env("CARGO_TERM_COLOR", "never");
        let (start, before) = (Instant::now(), time_of_children());
        let outcome = cargo.output()?;
        let elapsed = start.elapsed();
        let processor = time_of_children().zip(before).map(|(after, before)| after - before);
        Ok((Cost { elapsed, processor }, outcome))
    }
}

/// The processor time of the processes that this process has waited for: fields 16 and 17 of `/proc/self/stat`, in
/// hundredths of a second (proc(5)). Field 2, the name in parentheses, may itself hold spaces.
fn time_of_children() -> Option<Duration> {
    let stat = fs::read_to_string("/proc/self/stat").ok()?;
    let (_, fields) = stat.rsplit_once(')')?;
    let ticks = fields.split_whitespace().skip(13).take(2).map(str::parse::<u64>);
    let ticks = ticks.sum::<Result<u64, _>>().ok()?;
    Some(Duration::from_millis(10 * ticks))
}
