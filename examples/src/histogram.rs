//! A histogram of many values, with some of their quantiles marked.

use std::error::Error;
use std::path::Path;

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::page::{Canvas, Ink, frame, plain, save, text, thickness};

/// The height of the page, in mm.
const HEIGHT: f64 = 80.0;
/// The part of the plot above the highest bar, with the names of the marks.
const HEADROOM: f64 = 0.12;
/// A light blue, opaque so that it covers the grid.
const FILL: RGBColor = RGBColor(115, 141, 174);

/// How to draw values.
#[derive(Clone, Debug)]
pub struct Histogram {
    /// The line above the plot.
    pub title: String,
    /// The quantity with its unit.
    pub label: &'static str,
    /// The unit of the density.
    pub unit: &'static str,
    /// The width of a bar.
    pub bin: f64,
    /// The end of the axis, which starts at 0; of larger values only the share is named.
    pub end: f64,
    /// Values to mark, with their names.
    pub marks: Vec<(String, f64)>,
}

impl Histogram {
    /// Writes the histogram of values, none of them negative, as SVG.
    ///
    /// # Errors
    ///
    /// If the file cannot be written.
    pub fn write(&self, path: &Path, values: &[f64]) -> Result<(), Box<dyn Error>> {
        let densities = self.densities(values);
        save(path, HEIGHT, |canvas| self.draw(canvas, &densities))
    }

    /// The share of all values in each bar, per length of the axis.
    fn densities(&self, values: &[f64]) -> Vec<f64> {
        let mut counts = vec![0_u32; (self.end / self.bin).ceil().max(1.0) as usize];
        for value in values {
            if let Some(count) = counts.get_mut((value / self.bin) as usize) {
                *count += 1;
            }
        }
        let whole = values.len() as f64 * self.bin;
        counts.into_iter().map(|count| f64::from(count) / whole).collect()
    }

    /// The corners of all bars together; single bars would show seams between them.
    fn outline(&self, densities: &[f64]) -> Vec<(f64, f64)> {
        let tops = (0_u32..)
            .zip(densities)
            .flat_map(|(bar, &density)| [bar, bar + 1].map(|side| (self.bin * f64::from(side), density)));
        [(0.0, 0.0)].into_iter().chain(tops).chain([(self.bin * densities.len() as f64, 0.0)]).collect()
    }

    fn draw(&self, canvas: &Canvas<'_>, densities: &[f64]) -> Result<(), Box<dyn Error>> {
        let end = self.bin * densities.len() as f64;
        let beyond = 100.0 * (1.0 - self.bin * densities.iter().sum::<f64>());
        let top = densities.iter().fold(0.0, |top: f64, &density| top.max(density)) / (1.0 - HEADROOM);
        let mut chart = frame(canvas, Some(&self.title))?.build_cartesian_2d(0.0..end, 0.0..top)?;
        plain(&mut chart.configure_mesh())
            .disable_x_mesh()
            .x_labels(10)
            .y_labels(6)
            .x_label_formatter(&|value| format!("{value:.1}"))
            .y_label_formatter(&|value| format!("{value:.1}"))
            .x_desc(if beyond < 0.005 {
                self.label.to_owned()
            } else {
                format!("{}; {beyond:.2} % of the values lie beyond the axis", self.label)
            })
            .y_desc(format!("probability density (1/{})", self.unit))
            .draw()?;

        chart.plotting_area().draw(&Polygon::new(self.outline(densities), FILL.filled()))?;
        let line = Ink::Vermilion.color().stroke_width(thickness(0.4));
        let name = text().pos(Pos::new(HPos::Center, VPos::Bottom));
        let level = top * (1.0 - HEADROOM / 2.0);
        for (mark, value) in &self.marks {
            chart.plotting_area().draw(&PathElement::new([(*value, 0.0), (*value, level)], line))?;
            chart.plotting_area().draw(&Text::new(mark.clone(), (*value, level), name.clone()))?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_have_the_area_of_their_share() {
        let histogram =
            Histogram { title: String::new(), label: "", unit: "", bin: 0.5, end: 1.2, marks: Vec::new() };
        assert_eq!(histogram.densities(&[0.0, 0.4, 0.5, 7.0]), [1.0, 0.5, 0.0]);
    }
}
