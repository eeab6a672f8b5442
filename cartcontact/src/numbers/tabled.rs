//! Tables of numbers in both precisions.

use crate::Scalar;
use crate::scalar::{from_single, is_single};

/// A number of a table in both precisions: conversions are slow on microcontrollers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tabled {
    double: f64,
    single: f32,
}

impl Tabled {
    pub(crate) const fn of(value: f64) -> Self {
        Self { double: value, single: value as f32 }
    }

    #[inline(always)]
    pub(crate) fn get<T: Scalar>(self) -> T {
        of_precision(self.double, self.single)
    }
}

/// The one of two numbers that has the precision of `T`.
#[inline(always)]
pub(crate) fn of_precision<T: Scalar>(double: f64, single: f32) -> T {
    if is_single::<T>() { from_single(single) } else { T::constant(double) }
}

/// The numbers of a table.
pub(crate) const fn tabled<const N: usize>(numbers: [f64; N]) -> [Tabled; N] {
    let mut table = [Tabled::of(0.0); N];
    let mut place = 0;
    while place < N {
        table[place] = Tabled::of(numbers[place]);
        place += 1;
    }
    table
}

/// The numbers of a table in rows.
pub(super) const fn tabled_rows<const WIDTH: usize, const ROWS: usize>(
    rows: [[f64; WIDTH]; ROWS],
) -> [[Tabled; WIDTH]; ROWS] {
    let mut table = [[Tabled::of(0.0); WIDTH]; ROWS];
    let mut row = 0;
    while row < ROWS {
        table[row] = tabled(rows[row]);
        row += 1;
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_of_a_table_is_the_nearest_of_its_format() {
        let third = Tabled::of(1.0 / 3.0);
        assert_eq!((third.get::<f64>(), third.get::<f32>()), (1.0 / 3.0, 1.0 / 3.0));
    }
}
