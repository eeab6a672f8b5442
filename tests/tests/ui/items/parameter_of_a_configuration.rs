use cartcontact::gap_profile;

#[gap_profile(curvature * r^2)]
struct Ball<#[cfg(any())] T, #[cfg(all())] U> {
    curvature: f64,
    #[cfg(any())]
    unit: T,
    #[cfg(all())]
    unit: U,
}

fn main() {}
