//! Pressures at radii that the contact reaches one after the other, after the memory has begun.
//!
//! A radius needs an integral from the time at which it is reached. Marching to each of N radii from the beginning, along
//! a load of K knots, would pass N K knots. The time is therefore cut into S sections: a radius is marched to from the
//! beginning of the section in which it is reached to the end of that section, and from there one transition leads on,
//! which all radii reached so far share. That passes N K/S + S K/2 knots, the fewest for S = √(2 N).
//!
//! Stages in between are computed independently, as rows of a field are.

use super::{Edge, Stage, Transition, march};
use crate::contact::Contact;
use crate::load::{Load, knot_between};
use crate::scalar::has_no_derivatives;
use crate::{GapProfile, Scalar};

/// The most sections: room on the stack of a small processor.
const MOST_SECTIONS: usize = 32;

/// Fewer radii than these are as quick one by one.
const FEWEST_RADII_FOR_SECTIONS: usize = 4;

/// The sections of time between a stage and the end.
pub(crate) struct Late<'a, T, P, L> {
    contact: &'a Contact<T, P, L>,
    count: usize,
    /// The beginning of each section.
    stages: [Stage<T>; MOST_SECTIONS],
    /// The edge at the end of the last.
    end: Edge<T>,
    /// How pressures change from the end of each section on, where a radius has asked for it.
    to_end: [Option<Transition<T>>; MOST_SECTIONS],
}

impl<'a, T: Scalar, P: GapProfile<T>, L: Load<T>> Late<'a, T, P, L> {
    /// For so many radii, reached between a stage and the end.
    pub(crate) fn between(
        contact: &'a Contact<T, P, L>,
        start: Stage<T>,
        end: Edge<T>,
        radius_count: usize,
    ) -> Self {
        let load = contact.load();
        let is_one_piece =
            load.is_linear_between_knots() && knot_between(load, start.time, end.time).is_none();
        let count = if radius_count < FEWEST_RADII_FOR_SECTIONS || is_one_piece || !has_no_derivatives::<T>()
        {
            1
        } else {
            (2 * radius_count).isqrt().min(MOST_SECTIONS)
        };
        let mut stages = [start; MOST_SECTIONS];
        let length = (end.time - start.time) / T::constant(count as f64);
        for index in 1..count {
            let before = stages[index - 1].radius;
            let now = start.time + length * T::constant(index as f64);
            let loading = contact.loading(now);
            // An edge that stands still may seem to recede by a rounding.
            let reached = contact.radius_under_loading(loading).unwrap_or(before).max(before).min(end.radius);
            stages[index] = contact.stage_with_loading(loading, Edge { time: now, radius: reached });
        }
        Self { contact, count, stages, end, to_end: [None; MOST_SECTIONS] }
    }

    /// The pressure at the end at a radius that is reached after the start.
    pub(crate) fn pressure(&mut self, r: T) -> T {
        let later = &self.stages[1..self.count];
        let index = later.partition_point(|stage| stage.radius <= r);
        let next = later.get(index);
        let end_of_section = next.map_or(self.end, |next| Edge { time: next.time, radius: next.radius });
        let first = march(self.contact, self.stages[index], end_of_section, r).apply(T::zero(), r);
        let Some(next) = next else { return first };
        let to_end =
            self.to_end[index].get_or_insert_with(|| march(self.contact, *next, self.end, next.radius));
        to_end.apply(first, r)
    }
}
