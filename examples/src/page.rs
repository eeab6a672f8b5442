//! What all figures have in common: a page as SVG, in the width and type size of a journal, and the room on it.

use std::error::Error;
use std::fs;
use std::io;
use std::path::Path;

use plotters::chart::MeshStyle;
use plotters::coord::Shift;
use plotters::coord::ranged1d::Ranged;
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
