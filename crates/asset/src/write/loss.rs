//! What an encoding costs, measured on the values that went through it.

/// Decoded minus given, over every number of a table, in the unit of the values.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct EncodingLoss {
    /// Numbers measured: texels times channels.
    pub values: u64,
    /// Root of the mean square.
    pub rms: f64,
    /// The largest, without its sign.
    pub max: f64,
}

/// Values that go through a loop side by side. Each has its own sum, so that the order of summation is fixed however
/// wide the machine's vectors are.
const LANES: usize = 8;

/// What was measured on one layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LayerMeasure {
    values: u64,
    squares: [f64; LANES],
    largest: [f64; LANES],
    least_value: [f32; LANES],
    greatest_value: [f32; LANES],
}

impl LayerMeasure {
    pub(super) const EMPTY: Self = Self {
        values: 0,
        squares: [0.0; LANES],
        largest: [0.0; LANES],
        least_value: [f32::INFINITY; LANES],
        greatest_value: [f32::NEG_INFINITY; LANES],
    };

    /// Adds values and what they decode to.
    pub(super) fn add(&mut self, given: &[f32], decoded: &[f32]) {
        let (mut given_lanes, mut decoded_lanes) = (given.chunks_exact(LANES), decoded.chunks_exact(LANES));
        for (given, decoded) in given_lanes.by_ref().zip(decoded_lanes.by_ref()) {
            for lane in 0..LANES {
                self.add_one(lane, given[lane], decoded[lane]);
            }
        }
        for (lane, (&given, &decoded)) in given_lanes.remainder().iter().zip(decoded_lanes.remainder()).enumerate() {
            self.add_one(lane, given, decoded);
        }
        self.values += given.len() as u64;
    }

    #[inline]
    fn add_one(&mut self, lane: usize, given: f32, decoded: f32) {
        let error = (f64::from(decoded) - f64::from(given)).abs();
        self.squares[lane] += error * error;
        self.largest[lane] = if error > self.largest[lane] { error } else { self.largest[lane] };
        let (least, greatest) = (self.least_value[lane], self.greatest_value[lane]);
        self.least_value[lane] = if decoded < least { decoded } else { least };
        self.greatest_value[lane] = if decoded > greatest { decoded } else { greatest };
    }

    /// Numbers measured.
    pub(super) fn values(&self) -> u64 {
        self.values
    }

    /// The least and the greatest decoded value; a zero is +0.
    pub(super) fn range(&self) -> (f32, f32) {
        let least = self.least_value.into_iter().fold(f32::INFINITY, f32::min);
        let greatest = self.greatest_value.into_iter().fold(f32::NEG_INFINITY, f32::max);
        (least + 0.0, greatest + 0.0)
    }

    /// The loss of this layer alone.
    #[must_use]
    pub fn loss(&self) -> EncodingLoss {
        total(core::slice::from_ref(self))
    }
}

/// The loss over layers, summed in their order.
pub(super) fn total(layers: &[LayerMeasure]) -> EncodingLoss {
    let values = layers.iter().map(|layer| layer.values).sum::<u64>();
    let squares = layers.iter().map(|layer| layer.squares.iter().sum::<f64>()).sum::<f64>();
    let max = layers.iter().flat_map(|layer| layer.largest).fold(0.0, f64::max);
    EncodingLoss { values, rms: (squares / values.max(1) as f64).sqrt(), max }
}
