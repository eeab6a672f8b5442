//! The scenes with their reference values, and the error of a result against them.

/// Held from t = 0 on, in N.
pub(crate) const FORCE: f64 = 100.0;
/// m, in MPa/mm³: two layers of 1 mm and 0.25 MPa.
pub(crate) const STIFFNESS: f64 = 0.375;
/// χ, in 1/s.
pub(crate) const RATE: f64 = 1.0 / 512.0;

/// A time and a distance from the axis, with the exact results there.
///
/// Times, distances, force and medium are numbers of f32 too, so that both precisions have the same scenes.
#[derive(Debug)]
pub(crate) struct Scene {
    pub(crate) time: f64,
    pub(crate) distance: f64,
    pub(crate) radius: Exact,
    pub(crate) pressure: Exact,
}

/// A number to twice the precision of f64, as an unevaluated sum: one f64 could not tell an error of half a unit
/// in the last place from none.
#[derive(Debug)]
pub(crate) struct Exact {
    nearest: f64,
    rest: f64,
}

impl Exact {
    /// The relative error of a result.
    pub(crate) fn error(&self, result: f64) -> f64 {
        ((result - self.nearest) - self.rest).abs() / self.nearest
    }
}

const fn scene(time: f64, distance: f64, radius: [f64; 2], pressure: [f64; 2]) -> Scene {
    Scene {
        time,
        distance,
        radius: Exact { nearest: radius[0], rest: radius[1] },
        pressure: Exact { nearest: pressure[0], rest: pressure[1] },
    }
}

/// χ t is from 0.03 to 16; distances from the axis are up to 0.84 of the contact radius, two of them covered late.
///
/// The results are from 50-digit arithmetic on the gap 0.025 r² + 1.09375e-4 r⁴: the radius is the root of (14),
/// the pressure that of Eqs. (25)–(27) as printed, with adaptive quadrature.
pub(crate) static SCENES: [Scene; 12] = [
    scene(
        16.0,
        0.0,
        [7.181062613322931, 1.6488497745215709e-16],
        [1.8136490553499607, -1.099231965288442e-16],
    ),
    scene(28.0, 3.0, [7.206444692537152, 5.063061222942821e-17], [1.248414896142602, -4.521261433698667e-17]),
    scene(
        50.0,
        6.0,
        [7.251747328339631, -3.429007650198211e-16],
        [0.18805100743299694, 4.277607617828563e-18],
    ),
    scene(
        90.0,
        0.0,
        [7.3303526883747026, -1.976531670468478e-16],
        [1.7321893557253385, 9.199934598333771e-17],
    ),
    scene(
        160.0,
        3.0,
        [7.457713583938087, -7.714041403272984e-17],
        [1.188348149308781, -9.584246404160593e-17],
    ),
    scene(
        280.0,
        6.0,
        [7.6516623005377085, 1.4900177222371101e-16],
        [0.2663692568011077, -8.489293473093824e-18],
    ),
    scene(
        500.0,
        0.0,
        [7.949440392373177, 1.9568115590490148e-16],
        [1.3697867943087954, 1.083065982781406e-16],
    ),
    scene(
        900.0,
        3.0,
        [8.370664417272838, -8.362902658270127e-16],
        [0.9256457826501813, -4.5341723823374293e-17],
    ),
    scene(
        1600.0,
        7.5,
        [8.906241428179241, 3.015107885337315e-16],
        [0.18585430851219323, 1.0761944109996535e-17],
    ),
    scene(
        2800.0,
        0.0,
        [9.540295726813545, -2.5492550753445493e-16],
        [0.7460671696202628, -4.709031577653139e-17],
    ),
    scene(
        5000.0,
        3.0,
        [10.30555067149054, -6.083973856801853e-16],
        [0.5647410225027641, 3.5898522645935646e-17],
    ),
    scene(
        8192.0,
        9.0,
        [11.036760731608997, -7.429279596988985e-16],
        [0.17150809734699834, -2.1477344984921928e-18],
    ),
];
