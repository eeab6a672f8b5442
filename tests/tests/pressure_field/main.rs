//! Pressures at many times and radii at once.

mod fading;
mod late_radii;
mod long_intervals;
mod order;
mod rows;
mod short_intervals;
