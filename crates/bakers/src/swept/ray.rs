//! The bilinear surface along the rays of one direction, for the obvious twins.

use barchan_field::{HeightField, Spacing};

/// The part of a ray that lies in one bilinear cell. The same for every texel: rays start at texel centres.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell {
    /// The cell's least column and row, from the texel's own.
    column: i64,
    row: i64,
    /// Where the ray enters and leaves it, in lengths from the texel.
    pub(super) start: f64,
    pub(super) end: f64,
}

/// The cells of one direction, nearest first.
pub(super) struct RayCells {
    columns_per_length: f64,
    rows_per_length: f64,
    pub(super) cells: Vec<Cell>,
}

/// The surface in one cell: height = `level` + `slope` s + `bend` s², s in lengths *from the texel*, above the texel.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parabola {
    pub(super) level: f64,
    pub(super) slope: f64,
    pub(super) bend: f64,
}

impl RayCells {
    /// The cells a ray crosses up to a radius, towards the unit vector (cos, sin).
    pub(super) fn new((cos, sin): (f64, f64), spacing: Spacing, radius: f64) -> Self {
        // v points up the picture, rows are counted downwards.
        let (columns_per_length, rows_per_length) = (cos / spacing.u(), -sin / spacing.v());
        let least = |crossed: f64, speed: f64| if speed < 0.0 { -1 - crossed as i64 } else { crossed as i64 };
        let (mut columns, mut rows, mut start) = (0.0, 0.0, 0.0);
        let mut cells = Vec::new();
        while start < radius {
            // A component of 0 never crosses: 1/0 is infinite, as it should be.
            let to_column = (columns + 1.0) / columns_per_length.abs();
            let to_row = (rows + 1.0) / rows_per_length.abs();
            let crossing = to_column.min(to_row);
            let (column, row) = (least(columns, columns_per_length), least(rows, rows_per_length));
            cells.push(Cell { column, row, start, end: crossing.min(radius) });
            columns += f64::from(to_column <= crossing);
            rows += f64::from(to_row <= crossing);
            start = crossing;
        }
        Self { columns_per_length, rows_per_length, cells }
    }

    /// The surface in a cell, above the texel that the ray leaves.
    pub(super) fn parabola(&self, field: &HeightField, texel: (i64, i64), cell: &Cell) -> Parabola {
        let height = |i: i64, j: i64| f64::from(field.texel(texel.0 + cell.column + i, texel.1 + cell.row + j));
        let (h00, h10, h01, h11) = (height(0, 0), height(1, 0), height(0, 1), height(1, 1));
        let own = f64::from(field.texel(texel.0, texel.1));
        let (along_x, along_y, twist) = (h10 - h00, h01 - h00, h00 - h10 - h01 + h11);
        // The place of the texel itself, in the cell's own coordinates.
        let (x, y) = (-cell.column as f64, -cell.row as f64);
        let (dx, dy) = (self.columns_per_length, self.rows_per_length);
        Parabola {
            // In the first cell the ray starts on the surface, exactly.
            level: if cell.start == 0.0 { 0.0 } else { h00 + along_x * x + along_y * y + twist * x * y - own },
            slope: along_x * dx + along_y * dy + twist * (x * dy + y * dx),
            bend: twist * dx * dy,
        }
    }
}

impl Parabola {
    /// The slope of the point at a distance s > 0, seen from the texel.
    pub(super) fn seen_at(&self, s: f64) -> f64 {
        self.level / s + self.slope + self.bend * s
    }
}
