//! Figures of log-log plots side by side, with marks at the points.

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::coord::CoordTranslate;
use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use plotters::prelude::*;

use crate::figure::{Curve, draw_line};
use crate::page::{
    Canvas, Ink, LEGEND_COLUMNS, LEGEND_ROW, draw_legend_name, frame, legend_sample, pixels, plain, save,
    thickness,
};

/// Half the size of a mark, in mm.
const MARK: f64 = 0.9;
/// The room around the points, in decades.
const ROOM: f64 = 0.7;
/// Of how many decades each has its number along an axis; of more, every second has one, and so on.
const NUMBERED: f64 = 9.0;

/// The symbol at the points of a series.
#[derive(Clone, Copy, Debug)]
pub enum Mark {
    /// A filled circle.
    Disc,
    /// An open circle.
    Ring,
    /// A filled square.
    Square,
    /// A filled square on its tip.
    Diamond,
    /// An open triangle.
    Triangle,
    /// Two strokes.
    Cross,
}

/// Points with marks, all coordinates positive, and the line through them if there are several.
#[derive(Clone, Debug)]
pub struct Series {
    /// The points, with name and line.
    pub curve: Curve,
    /// The symbol at the points.
    pub mark: Mark,
}

/// One plot of a figure.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The line above the plot.
    pub title: String,
    /// The quantity of the horizontal axis.
    pub x: &'static str,
    /// The quantity of the vertical axis with its unit.
    pub y: &'static str,
    /// The plotted series.
    pub series: Vec<Series>,
}

/// Writes panels side by side, on the same axes and under one legend, the one of the panel with the most series;
/// the height is in mm.
///
/// # Errors
///
/// If the file cannot be written.
pub fn write(path: &Path, height: f64, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    save(path, height, |canvas| draw(canvas, panels))
}

fn draw(canvas: &Canvas<'_>, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let series = panels.iter().map(|panel| &panel.series).max_by_key(|series| series.len());
    let rows = series.map_or(0, Vec::len).div_ceil(LEGEND_COLUMNS).max(1);
    let (legend, plots) = canvas.split_vertically(pixels(LEGEND_ROW * rows as f64));
    for (slot, series) in legend.split_evenly((rows, LEGEND_COLUMNS)).iter().zip(series.into_iter().flatten())
    {
        let [start, end] = legend_sample();
        if series.curve.points.len() > 1 {
            draw_line(slot, &[start, end], &series.curve)?;
        }
        draw_mark(slot, (i32::midpoint(start.0, end.0), end.1), series.mark, series.curve.ink)?;
        draw_legend_name(slot, &series.curve.name)?;
    }
    let points = || panels.iter().flat_map(|panel| &panel.series).flat_map(|series| &series.curve.points);
    let x = Decades::around(points().map(|point| point.0));
    let y = Decades::around(points().map(|point| point.1));
    for (area, panel) in plots.split_evenly((1, panels.len())).iter().zip(panels) {
        draw_panel(area, panel, x.clone(), y.clone())?;
    }
    Ok(())
}

/// A logarithmic axis.
#[derive(Clone, Debug)]
struct Decades {
    /// The decimal logarithms of the ends.
    exponents: Range<f64>,
    /// The numbers along the axis are powers of ten whose exponents are multiples of this.
    step: i32,
}

impl Decades {
    fn around(values: impl Iterator<Item = f64>) -> Self {
        let (low, high) = values
            .map(f64::log10)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (low.min(value), high.max(value)));
        let exponents = low - ROOM..high + ROOM;
        let step = ((exponents.end - exponents.start) / NUMBERED).ceil() as i32;
        Self { exponents, step }
    }
}

impl Ranged for Decades {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (start, end): (i32, i32)) -> i32 {
        let share = (value.log10() - self.exponents.start) / (self.exponents.end - self.exponents.start);
        start + (share * f64::from(end - start)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _hint: Hint) -> Vec<f64> {
        let multiple = |exponent: f64| exponent / f64::from(self.step);
        let first = multiple(self.exponents.start).ceil() as i32;
        let last = multiple(self.exponents.end).floor() as i32;
        (first..=last).map(|index| 10_f64.powi(index * self.step)).collect()
    }

    fn range(&self) -> Range<f64> {
        10_f64.powf(self.exponents.start)..10_f64.powf(self.exponents.end)
    }
}

impl ValueFormatter<f64> for Decades {
    /// A power of ten.
    fn format(value: &f64) -> String {
        let raised = |digit| match digit {
            '-' => '⁻',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            // The other superscript digits are consecutive.
            _ => digit.to_digit(10).and_then(|digit| char::from_u32('⁰' as u32 + digit)).unwrap_or(digit),
        };
        format!("10{}", format!("{:.0}", value.log10()).chars().map(raised).collect::<String>())
    }
}

fn draw_panel(area: &Canvas<'_>, panel: &Panel, x: Decades, y: Decades) -> Result<(), Box<dyn Error>> {
    let mut chart = frame(area, Some(&panel.title))?.build_cartesian_2d(x, y)?;
    plain(&mut chart.configure_mesh()).x_desc(panel.x).y_desc(panel.y).draw()?;
    // The first series is on top.
    for Series { curve, mark } in panel.series.iter().rev() {
        if curve.points.len() > 1 {
            draw_line(chart.plotting_area(), &curve.points, curve)?;
        }
        for &point in &curve.points {
            draw_mark(chart.plotting_area(), point, *mark, curve.ink)?;
        }
    }
    Ok(())
}

fn draw_mark<C>(
    area: &DrawingArea<SVGBackend<'_>, C>,
    at: C::From,
    mark: Mark,
    ink: Ink,
) -> Result<(), Box<dyn Error>>
where
    C: CoordTranslate,
    C::From: Clone,
{
    let size = pixels(MARK);
    let (filled, paper) = (ink.color().filled(), WHITE.filled());
    let line = ink.color().stroke_width(thickness(0.3));
    let centre = || EmptyElement::at(at.clone());
    let along = |corners: &[(f64, f64)]| -> Vec<(i32, i32)> {
        corners.iter().map(|&(x, y)| (pixels(MARK * x), pixels(MARK * y))).collect()
    };
    match mark {
        Mark::Disc => area.draw(&(centre() + Circle::new((0, 0), size, filled)))?,
        Mark::Ring => {
            area.draw(&(centre() + Circle::new((0, 0), size, paper) + Circle::new((0, 0), size, line)))?;
        }
        Mark::Square => area.draw(&(centre() + Rectangle::new([(-size, -size), (size, size)], filled)))?,
        Mark::Diamond => {
            let corners = along(&[(-1.2, 0.0), (0.0, -1.2), (1.2, 0.0), (0.0, 1.2)]);
            area.draw(&(centre() + Polygon::new(corners, filled)))?;
        }
        Mark::Triangle => {
            let corners = along(&[(-1.1, 0.8), (0.0, -1.1), (1.1, 0.8), (-1.1, 0.8)]);
            area.draw(&(centre() + Polygon::new(corners.clone(), paper) + PathElement::new(corners, line)))?;
        }
        Mark::Cross => {
            let strokes = [along(&[(-0.8, -0.8), (0.8, 0.8)]), along(&[(-0.8, 0.8), (0.8, -0.8)])];
            let [down, up] = strokes.map(|stroke| PathElement::new(stroke, line));
            area.draw(&(centre() + down + up))?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_powers_of_ten() {
        let numbers = |ends: [f64; 2]| -> Vec<String> {
            Decades::around(ends.into_iter()).key_points(5).iter().map(Decades::format).collect()
        };
        assert_eq!(numbers([1e4, 9e6]), ["10⁴", "10⁵", "10⁶", "10⁷"]);
        assert_eq!(numbers([1e-12, 0.3]), ["10⁻¹²", "10⁻¹⁰", "10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"]);
        assert_eq!(Decades::format(&1e3), "10³");
    }
}
