//! Triangles whose sides are joined in pairs.
//!
//! A *side* is a number: side k of triangle t is 3t + k and runs from corner k to corner k + 1. The same number names the corner
//! that it starts at.

/// No side, no place, no point.
pub(super) const NONE: u32 = u32::MAX;

/// Set on a twin that lies beyond a crease, or whose triangle cannot be oriented likewise: joined, but not smoothly.
const CUT: u32 = 1 << 31;

/// The most triangles whose sides can be numbered, the bit of a cut aside.
pub(super) const MOST_TRIANGLES: usize = ((CUT - 1) / 3) as usize;

/// Triangles between places, joined along sides.
#[derive(Debug, Default)]
pub(super) struct Surface {
    /// The place of every corner; [`NONE`] for the corners of a triangle that was left out.
    pub(super) corners: Vec<u32>,
    /// The side beyond each side.
    twins: Vec<u32>,
    /// Which triangles run the other way than in the mesh; empty where none does.
    turned: Vec<bool>,
}

impl Surface {
    pub(super) fn new(corners: Vec<u32>, twins: Vec<u32>) -> Self {
        Self { corners, twins, turned: Vec::new() }
    }

    pub(super) fn sides(&self) -> core::ops::Range<u32> {
        0..self.corners.len() as u32
    }

    /// The place a side starts at.
    pub(super) fn from(&self, side: u32) -> u32 {
        self.corners[side as usize]
    }

    /// The place a side ends at.
    pub(super) fn to(&self, side: u32) -> u32 {
        self.corners[next(side) as usize]
    }

    /// The side on which the surface goes on smoothly.
    pub(super) fn smooth_twin(&self, side: u32) -> Option<u32> {
        let twin = self.twins[side as usize];
        (twin < CUT).then_some(twin)
    }

    /// The side on which the surface goes on, smoothly or not.
    pub(super) fn twin(&self, side: u32) -> Option<u32> {
        let twin = self.twins[side as usize];
        (twin != NONE).then_some(twin & !CUT)
    }

    /// Whether both triangles of a joined edge are seen from the same side: they run along it in opposite ways.
    pub(super) fn agree(&self, side: u32, twin: u32) -> bool {
        self.from(side) != self.from(twin)
    }

    pub(super) fn join(&mut self, side: u32, twin: u32) {
        self.twins[side as usize] = twin;
        self.twins[twin as usize] = side;
    }

    /// The surface is not smooth across this edge.
    pub(super) fn cut(&mut self, side: u32, twin: u32) {
        self.twins[side as usize] |= CUT;
        self.twins[twin as usize] |= CUT;
    }

    /// Turns triangles over: corners 1 and 2 change places.
    pub(super) fn turn(&mut self, turned: Vec<bool>) {
        let renamed = |side: u32| if turned[(side / 3) as usize] { side - side % 3 + (2 - side % 3) } else { side };
        let old = self.twins.clone();
        for (side, &twin) in old.iter().enumerate() {
            let moved = if twin == NONE { NONE } else { renamed(twin & !CUT) | (twin & CUT) };
            self.twins[renamed(side as u32) as usize] = moved;
        }
        for (triangle, corners) in self.corners.chunks_exact_mut(3).enumerate() {
            if turned[triangle] {
                corners.swap(1, 2);
            }
        }
        self.turned = turned;
    }

    /// The vertex of the mesh at a corner.
    pub(super) fn vertex(&self, corner: u32, triangles: &[[u32; 3]]) -> u32 {
        let triangle = (corner / 3) as usize;
        let turned = self.turned.get(triangle).is_some_and(|&turned| turned);
        let corner = corner as usize % 3;
        triangles[triangle][if turned { (3 - corner) % 3 } else { corner }]
    }
}

/// The side after this one in its triangle.
pub(super) fn next(side: u32) -> u32 {
    if side % 3 == 2 { side - 2 } else { side + 1 }
}

/// The side before this one in its triangle.
pub(super) fn previous(side: u32) -> u32 {
    if side.is_multiple_of(3) { side + 2 } else { side - 1 }
}
