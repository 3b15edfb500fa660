//! Charts as SVG: curves over an axis, and a surface over two.
//!
//! A chart is drawn from records alone, as a table of the docs is, so that no picture can be older than its
//! measurement. SVG is text: the same numbers are the same bytes, and a diff shows which moved.

use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::StudyError;

/// Points joined by lines; one alone is a dot.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Its name in the legend.
    pub name: String,
    /// Its points, from left to right.
    pub points: Vec<(f64, f64)>,
}

/// Where the names of curves stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Legend {
    /// For curves that rise.
    UpperLeft,
    /// For curves that fall.
    UpperRight,
    /// In room of its own, for curves that are everywhere.
    Above,
}

/// Curves over one axis; both axes start at 0.
#[derive(Debug, Clone, PartialEq)]
pub struct LineChart {
    /// What is shown.
    pub title: String,
    /// What runs to the right, with its unit.
    pub across: String,
    /// What runs up, with its unit.
    pub up: String,
    /// The curves, in the order of the legend.
    pub curves: Vec<Curve>,
    /// Where their names stand.
    pub legend: Legend,
}

/// A surface over two axes, seen from above: a number and a colour for each pair of steps, blue above 0 and red below.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatChart {
    /// What is shown.
    pub title: String,
    /// What runs to the right, and its steps.
    pub across: (String, Vec<String>),
    /// What runs up, and its steps from the bottom.
    pub up: (String, Vec<String>),
    /// `[up][across]`; what was not measured is `None`.
    pub cells: Vec<Vec<Option<f64>>>,
    /// The number at which colours are full, for charts that are compared.
    pub full: f64,
}

/// The colours of curves, told apart with any eyes: Masataka Okabe, Kei Ito, *Color Universal Design*, 2008.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(213, 94, 0),
    RGBColor(230, 159, 0),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(0, 114, 178),
    RGBColor(0, 158, 115),
];
const FONT: &str = "sans-serif";
const TEXT: i32 = 14;
const TITLE: i32 = 16;

impl LineChart {
    /// The chart as an SVG document.
    ///
    /// # Errors
    /// None in practice: nothing is written but memory.
    pub fn svg(&self) -> Result<String, StudyError> {
        drawn((640, 400), |area| {
            let most = |of: fn(&(f64, f64)) -> f64| {
                self.curves
                    .iter()
                    .flat_map(|curve| curve.points.iter().map(of))
                    .fold(0.0, f64::max)
                    .max(f64::MIN_POSITIVE)
            };
            let (room, corner) = match self.legend {
                Legend::UpperLeft => (1.05, SeriesLabelPosition::UpperLeft),
                Legend::UpperRight => (1.05, SeriesLabelPosition::UpperRight),
                Legend::Above => (1.75, SeriesLabelPosition::UpperLeft),
            };
            let mut chart = ChartBuilder::on(area)
                .margin(12)
                .caption(&self.title, (FONT, TITLE))
                .x_label_area_size(40)
                .y_label_area_size(52)
                .build_cartesian_2d(0.0..most(|point| point.0), 0.0..room * most(|point| point.1))?;
            chart
                .configure_mesh()
                .light_line_style(TRANSPARENT)
                .x_desc(&self.across)
                .y_desc(&self.up)
                .label_style((FONT, TEXT))
                .draw()?;
            for (curve, colour) in self.curves.iter().zip(COLOURS.iter().cycle()) {
                let style = colour.stroke_width(2);
                chart
                    .draw_series(LineSeries::new(curve.points.iter().copied(), style))?
                    .label(&curve.name)
                    .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style));
                if let [point] = curve.points[..] {
                    chart.draw_series([Circle::new(point, 4, colour.filled())])?;
                }
            }
            chart
                .configure_series_labels()
                .position(corner)
                .background_style(WHITE.mix(0.85))
                .label_font((FONT, TEXT))
                .draw()
        })
    }
}

/// Pixels of a heat chart: of a cell, and around all of them.
const CELL: (i32, i32) = (68, 34);
const LEFT: i32 = 76;
const TOP: i32 = 40;
const BELOW: i32 = 52;

impl HeatChart {
    /// The chart as an SVG document.
    ///
    /// # Errors
    /// None in practice: nothing is written but memory.
    pub fn svg(&self) -> Result<String, StudyError> {
        let (columns, rows) = (self.across.1.len() as i32, self.up.1.len() as i32);
        let (right, bottom) = (LEFT + columns * CELL.0, TOP + rows * CELL.1);
        drawn(((right + 16) as u32, (bottom + BELOW) as u32), |area| {
            let middle = ((LEFT + right) / 2, (TOP + bottom) / 2);
            area.draw_text(&self.title, &words(TITLE), (middle.0, TOP / 2))?;
            area.draw_text(&self.across.0, &words(TEXT), (middle.0, bottom + 38))?;
            let upright = words(TEXT).transform(FontTransform::Rotate270);
            area.draw_text(&self.up.0, &upright, (16, middle.1))?;
            for (column, step) in self.across.1.iter().enumerate() {
                area.draw_text(step, &words(TEXT), (LEFT + CELL.0 * column as i32 + CELL.0 / 2, bottom + 14))?;
            }
            for (row, (step, cells)) in self.up.1.iter().zip(&self.cells).enumerate() {
                let top = bottom - CELL.1 * (row as i32 + 1);
                area.draw_text(step, &words(TEXT), (LEFT - 22, top + CELL.1 / 2))?;
                for (column, cell) in cells.iter().enumerate() {
                    self.draw_cell(area, *cell, (LEFT + CELL.0 * column as i32, top))?;
                }
            }
            Ok(())
        })
    }

    fn draw_cell(&self, area: &Area<'_>, cell: Option<f64>, (left, top): (i32, i32)) -> Drawing {
        let Some(number) = cell else { return Ok(()) };
        let strength = (number / self.full).clamp(-1.0, 1.0);
        let full = if strength < 0.0 { COLOURS[1] } else { COLOURS[5] };
        let corners = [(left, top), (left + CELL.0 - 1, top + CELL.1 - 1)];
        area.draw(&Rectangle::new(corners, full.mix(strength.abs()).filled()))?;
        let ink = if strength.abs() > 0.6 { WHITE } else { BLACK };
        let style = words(TEXT).color(&ink);
        area.draw_text(&short(number), &style, (left + CELL.0 / 2, top + CELL.1 / 2))
    }
}

/// A tenth is enough of what a colour says as well; U+2212 is as wide as a plus.
fn short(number: f64) -> String {
    let text = format!("{number:.1}").replace('-', "−");
    if text == "−0.0" { "0.0".to_owned() } else { text }
}

fn words(size: i32) -> TextStyle<'static> {
    TextStyle::from((FONT, size)).pos(Pos::new(HPos::Center, VPos::Center))
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;
type Drawing = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// The document that drawing on white gives.
fn drawn(size: (u32, u32), draw: impl FnOnce(&Area<'_>) -> Drawing) -> Result<String, StudyError> {
    let mut text = String::new();
    let area = SVGBackend::with_string(&mut text, size).into_drawing_area();
    let done = area.fill(&WHITE).and_then(|()| draw(&area)).and_then(|()| area.present());
    drop(area);
    match done {
        Ok(()) => Ok(text),
        Err(error) => Err(StudyError::Chart { message: error.to_string() }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn heat(cells: Vec<Vec<Option<f64>>>) -> String {
        let steps =
            |name: &str, count: usize| (name.to_owned(), (0..count).map(|step| format!("step {step}")).collect());
        let across = steps("width", cells[0].len());
        let up = steps("height", cells.len());
        HeatChart { title: "a & b".to_owned(), across, up, cells, full: 2.0 }.svg().unwrap()
    }

    #[test]
    fn cells_are_blue_above_zero_red_below_and_full_at_most() {
        let svg = heat(vec![vec![Some(1.0), Some(-9.0), Some(-0.01), None]]);
        assert_eq!(svg.matches("#0072B2").count(), 1);
        assert!(svg.contains("fill=\"#D55E00\"") && svg.contains("−9.0"), "{svg}");
        // Rounded to nothing is nothing, of either sign; what was not measured has no cell.
        assert!(svg.contains("0.0") && !svg.contains("−0.0"));
        assert_eq!(svg.matches("<rect").count(), 1 + 3);
    }

    #[test]
    fn words_are_text_and_may_be_any() {
        let svg = heat(vec![vec![Some(0.0)]]);
        assert!(svg.contains("a &amp; b") && svg.contains("width") && svg.contains("height"), "{svg}");
    }

    #[test]
    fn every_curve_is_drawn_and_named() {
        let curve = |name: &str, top| Curve { name: name.to_owned(), points: vec![(0.0, 0.0), (1.0, top)] };
        let words = ["title", "right", "up"].map(str::to_owned);
        let [title, across, up] = words.clone();
        let svg = LineChart {
            title,
            across,
            up,
            curves: vec![curve("low", 1.0), curve("high", 2.0)],
            legend: Legend::UpperRight,
        }
        .svg()
        .unwrap();
        assert!(words.iter().all(|word| svg.contains(word.as_str())));
        assert!(svg.contains("low") && svg.contains("high") && svg.contains("#000000") && svg.contains("#D55E00"));
    }

    #[test]
    fn a_point_alone_is_seen() {
        let curve = |points: Vec<(f64, f64)>| Curve { name: String::new(), points };
        let svg = |points| {
            LineChart {
                title: String::new(),
                across: String::new(),
                up: String::new(),
                curves: vec![curve(points)],
                legend: Legend::Above,
            }
            .svg()
        };
        assert_eq!(svg(vec![(1.0, 2.0)]).unwrap().matches("<circle").count(), 1);
        assert_eq!(svg(vec![(1.0, 2.0), (2.0, 3.0)]).unwrap().matches("<circle").count(), 0);
    }

    #[test]
    fn a_chart_of_nothing_is_still_a_chart() {
        let empty = LineChart {
            title: String::new(),
            across: String::new(),
            up: String::new(),
            curves: Vec::new(),
            legend: Legend::UpperLeft,
        };
        assert!(empty.svg().unwrap().starts_with("<svg"));
    }
}
