//! Figures of line plots side by side.

use std::error::Error;
use std::ops::Range;
use std::path::Path;

use plotters::coord::CoordTranslate;
use plotters::element::DashedPathElement;
use plotters::prelude::*;

use crate::page::{
    Canvas, Ink, LEGEND_COLUMNS, LEGEND_ROW, draw_legend_name, frame, legend_sample, pixels, plain, save,
    thickness,
};

/// How a line is drawn.
#[derive(Clone, Copy, Debug)]
pub enum Dash {
    /// Without breaks.
    Solid,
    /// In dashes.
    Dashed,
    /// In dots.
    Dotted,
}

/// A line through points.
#[derive(Clone, Debug)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Its colour.
    pub ink: Ink,
    /// How its line is drawn.
    pub dash: Dash,
    /// The points, joined in this order.
    pub points: Vec<(f64, f64)>,
}

/// The text along an axis.
#[derive(Clone, Copy, Debug)]
pub struct Axis {
    /// The quantity with its unit.
    pub label: &'static str,
    /// How many decimals the numbers have.
    pub decimals: usize,
}

/// One plot of a figure.
#[derive(Clone, Debug)]
pub struct Panel {
    /// The line above the plot, if it needs one.
    pub title: Option<String>,
    /// The horizontal axis, which starts at 0.
    pub x: Axis,
    /// The end of the horizontal axis.
    pub x_end: f64,
    /// The vertical axis, with a little room above and below the curves.
    pub y: Axis,
    /// The curves.
    pub curves: Vec<Curve>,
}

/// Writes panels side by side under one legend, the one of the first panel; the height is in mm.
///
/// # Errors
///
/// If the file cannot be written.
pub fn write(path: &Path, height: f64, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    save(path, height, |canvas| draw(canvas, panels))
}

fn draw(canvas: &Canvas<'_>, panels: &[Panel]) -> Result<(), Box<dyn Error>> {
    let curves = panels.first().map_or(&[][..], |panel| &panel.curves);
    let rows = curves.len().div_ceil(LEGEND_COLUMNS).max(1);
    let columns = curves.len().div_ceil(rows);
    let (legend, plots) = canvas.split_vertically(pixels(LEGEND_ROW * rows as f64));
    for (slot, curve) in legend.split_evenly((rows, columns)).iter().zip(curves) {
        draw_legend_entry(slot, curve)?;
    }
    for (area, panel) in plots.split_evenly((1, panels.len())).iter().zip(panels) {
        draw_panel(area, panel)?;
    }
    Ok(())
}

/// A sample of the line, with the name of the curve to its right.
///
/// plotters has legends too, but guesses the width of their text.
fn draw_legend_entry(slot: &Canvas<'_>, curve: &Curve) -> Result<(), Box<dyn Error>> {
    draw_line(slot, &legend_sample(), curve)?;
    draw_legend_name(slot, &curve.name)
}

fn draw_panel(area: &Canvas<'_>, panel: &Panel) -> Result<(), Box<dyn Error>> {
    let mut chart = frame(area, panel.title.as_deref())?
        .build_cartesian_2d(0.0..panel.x_end, vertical_range(&panel.curves))?;
    plain(&mut chart.configure_mesh())
        .x_labels(5)
        .y_labels(6)
        .x_label_formatter(&|value| format!("{value:.0$}", panel.x.decimals))
        .y_label_formatter(&|value| format!("{value:.0$}", panel.y.decimals))
        .x_desc(panel.x.label)
        .y_desc(panel.y.label)
        .draw()?;
    for curve in &panel.curves {
        draw_line(chart.plotting_area(), &curve.points, curve)?;
    }
    Ok(())
}

/// The range of the curves with some room, but none below zero, as the quantities are not negative.
fn vertical_range(curves: &[Curve]) -> Range<f64> {
    let values = curves.iter().flat_map(|curve| &curve.points).map(|point| point.1);
    let (low, high) = values
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), value| (value.min(low), value.max(high)));
    let room = 0.05 * (high - low);
    (low - room).max(0.0)..high + room
}

pub(crate) fn draw_line<C>(
    area: &DrawingArea<SVGBackend<'_>, C>,
    points: &[C::From],
    curve: &Curve,
) -> Result<(), Box<dyn Error>>
where
    C: CoordTranslate,
    C::From: Clone + 'static,
{
    let style = curve.ink.color().stroke_width(thickness(0.4));
    let (dash, space) = match curve.dash {
        Dash::Solid => {
            area.draw(&PathElement::new(points, style))?;
            return Ok(());
        }
        Dash::Dashed => (pixels(1.6), pixels(0.8)),
        Dash::Dotted => (pixels(0.4), pixels(0.6)),
    };
    area.draw(&DashedPathElement::new(points.to_vec(), dash, space, style))?;
    Ok(())
}
