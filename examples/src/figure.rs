//! Figures of line plots side by side, as SVG in the width and type size of a journal page.

use std::error::Error;
use std::fs;
use std::io;
use std::ops::Range;
use std::path::Path;

use plotters::chart::MeshStyle;
use plotters::coord::ranged1d::Ranged;
use plotters::coord::{CoordTranslate, Shift};
use plotters::element::DashedPathElement;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

/// plotters rounds coordinates to whole pixels; at this resolution the rounding is invisible.
const PIXELS_PER_MM: f64 = 100.0;

// Lengths on the page, in mm.
const WIDTH: f64 = 180.0;
pub(crate) const LEGEND_ROW: f64 = 6.0;
const TITLE: f64 = 6.0;
const LEFT: f64 = 13.0;
const RIGHT: f64 = 3.0;
const BOTTOM: f64 = 9.0;
/// 8 points.
const TYPE_SIZE: f64 = 8.0 * 25.4 / 72.0;

pub(crate) const LEGEND_COLUMNS: usize = 4;

/// Colours that differ for any colour vision, and in grey too.
#[derive(Clone, Copy, Debug)]
pub enum Ink {
    /// A dark blue.
    Blue,
    /// A lighter red towards orange.
    Vermilion,
}

impl Ink {
    pub(crate) fn color(self) -> RGBColor {
        match self {
            Self::Blue => RGBColor(0, 48, 107),
            Self::Vermilion => RGBColor(213, 94, 0),
        }
    }
}

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

/// Writes the drawing on a page with a height in mm, and creates the folder if there is none.
pub(crate) fn save(
    path: &Path,
    height: f64,
    draw: impl FnOnce(&Canvas<'_>) -> Result<(), Box<dyn Error>>,
) -> Result<(), Box<dyn Error>> {
    let size = (pixels(WIDTH) as u32, pixels(height) as u32);
    let mut svg = String::new();
    {
        let canvas = SVGBackend::with_string(&mut svg, size).into_drawing_area();
        canvas.fill(&WHITE)?;
        draw(&canvas)?;
        canvas.present()?;
    }
    let in_pixels = format!(r#"width="{}" height="{}""#, size.0, size.1);
    let in_mm = format!(r#"width="{WIDTH}mm" height="{height}mm""#);
    let failed = |to: &str, path: &Path, error: io::Error| {
        format!("cannot {to} `{}`: {error}; run the example in a folder where you may write", path.display())
    };
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder).map_err(|error| failed("create", folder, error))?;
    }
    fs::write(path, svg.replacen(&in_pixels, &in_mm, 1)).map_err(|error| failed("write", path, error))?;
    Ok(())
}

/// A page or a part of it.
pub(crate) type Canvas<'a> = DrawingArea<SVGBackend<'a>, Shift>;

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

/// The ends of the line in an entry of the legend.
pub(crate) fn legend_sample() -> [(i32, i32); 2] {
    [2.0, 11.0].map(|x| (pixels(x), pixels(LEGEND_ROW / 2.0)))
}

pub(crate) fn draw_legend_name(slot: &Canvas<'_>, name: &str) -> Result<(), Box<dyn Error>> {
    let [_, (end, middle)] = legend_sample();
    let style = text().pos(Pos::new(HPos::Left, VPos::Center));
    slot.draw_text(name, &style, (end + pixels(1.5), middle))?;
    Ok(())
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

/// The room around a plot, with the line above it if there is one.
pub(crate) fn frame<'a, 's>(
    area: &'a Canvas<'s>,
    title: Option<&str>,
) -> Result<ChartBuilder<'a, 'static, SVGBackend<'s>>, Box<dyn Error>> {
    if let Some(title) = title {
        draw_title(area, title)?;
    }
    let mut chart = ChartBuilder::on(area);
    chart
        .margin_top(pixels(if title.is_some() { TITLE } else { 1.0 }))
        .margin_left(pixels(1.0))
        .margin_right(pixels(RIGHT))
        .x_label_area_size(pixels(BOTTOM))
        .y_label_area_size(pixels(LEFT - 1.0));
    Ok(chart)
}

/// The line above a plot, centred on it.
fn draw_title(area: &Canvas<'_>, title: &str) -> Result<(), Box<dyn Error>> {
    let (width, _) = area.dim_in_pixel();
    let middle = (width as i32 + pixels(LEFT - RIGHT)) / 2;
    let style = text().pos(Pos::new(HPos::Center, VPos::Center));
    area.draw_text(title, &style, (middle, pixels(TITLE / 2.0)))?;
    Ok(())
}

/// Thin axes and a faint grid, with the type of the page.
pub(crate) fn plain<'m, 'a, 'b, 'c, X: Ranged, Y: Ranged>(
    mesh: &'m mut MeshStyle<'a, 'b, X, Y, SVGBackend<'c>>,
) -> &'m mut MeshStyle<'a, 'b, X, Y, SVGBackend<'c>> {
    mesh.axis_style(BLACK.stroke_width(thickness(0.25)))
        .bold_line_style(BLACK.mix(0.15).stroke_width(thickness(0.15)))
        .light_line_style(TRANSPARENT)
        .set_all_tick_mark_size(pixels(0.7))
        .label_style(text())
        // plotters centres text as if it were lower case; digits are taller.
        .y_label_offset(pixels(0.3))
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

pub(crate) fn text() -> TextStyle<'static> {
    // plotters divides the given type size by 1.24.
    ("sans-serif", TYPE_SIZE * PIXELS_PER_MM * 1.24).into()
}

pub(crate) fn pixels(mm: f64) -> i32 {
    (mm * PIXELS_PER_MM).round() as i32
}

pub(crate) fn thickness(mm: f64) -> u32 {
    pixels(mm) as u32
}
