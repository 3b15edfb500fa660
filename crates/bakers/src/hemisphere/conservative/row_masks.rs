//! One bit per part of a cell: whether it is high enough in the slab at hand; and per run of 2ᵏ parts: whether one of them is.
//!
//! A row of masks is three fields wide, so that a footprint in any column finds its parts a field's width to both sides without asking for the
//! edge policy: bit b is part b − width.

use std::ops::Range;

use barchan_field::Edge;

use super::cells::{Axis, Cells};
use super::reach::Span;

/// Masks of all rows of parts, brought up to date where they are asked for.
pub(super) struct RowMasks<'a> {
    cells: &'a Cells,
    width: usize,
    words: usize,
    rows: Vec<Row>,
    slab: usize,
    /// The longest runs that are asked for.
    levels: usize,
    /// The words that are asked for.
    asked: Range<usize>,
}

/// The masks of a row of parts.
#[derive(Clone, Default)]
struct Row {
    /// How many parts have been set.
    set: usize,
    /// The slab for which the runs have been formed.
    formed_for: Option<usize>,
    /// `[k][word]`: bit b of k is that one of the 2ᵏ parts from b on is high enough.
    runs: Vec<u64>,
}

/// Whether one of the parts of a span is high enough, for all columns at once.
pub(super) enum Answer<'a> {
    Never,
    Always,
    /// Where either of both has its bit set.
    Either([Shifted<'a>; 2]),
}

/// Words that begin at any bit of others.
#[derive(Clone, Copy)]
pub(super) struct Shifted<'a> {
    words: &'a [u64],
    shift: u32,
}

impl<'a> RowMasks<'a> {
    pub(super) fn new(cells: &'a Cells) -> Self {
        let width = cells.columns().length() as usize;
        let words = words(width);
        Self { cells, width, words, rows: vec![Row::default(); cells.rows().count()], slab: 0, levels: 0, asked: 0..0 }
    }

    /// Turns to a slab and to the spans that will be asked for in it.
    pub(super) fn expect(&mut self, slab: usize, spans: &[Vec<Span>]) {
        let spans = || spans.iter().flatten();
        let first = spans().map(|span| span.first).min().unwrap_or(0);
        let last = spans().map(|span| span.last).max().unwrap_or(0);
        let (width, word) = (self.width as i64, |bit: i64| bit as usize / 64);
        self.slab = slab;
        self.levels = spans().map(|span| span.level()).max().unwrap_or(0);
        self.asked = word(width + first)..(word(2 * width + last) + 3).min(self.words);
    }

    /// Whether one of a span's parts in a row is high enough.
    pub(super) fn answer(&mut self, row: usize, span: Span) -> Answer<'_> {
        let cells = self.cells.row(row);
        if cells.high_enough(self.slab).is_empty() {
            return Answer::Never;
        }
        if cells.is_full(self.slab) {
            return Answer::Always;
        }
        self.form(row);
        let level = span.level();
        let runs = &self.rows[row].runs[level * self.words..][..self.words];
        let begin = |column: i64| Shifted::new(runs, (self.width as i64 + column) as usize);
        Answer::Either([begin(span.first), begin(span.last + 1 - (1 << level))])
    }

    /// Forms the runs of a row, unless they have been.
    fn form(&mut self, row: usize) {
        let cells = self.cells.row(row);
        let masks = &mut self.rows[row];
        if masks.formed_for == Some(self.slab) {
            return;
        }
        masks.formed_for = Some(self.slab);
        masks.runs.resize(masks.runs.len().max((self.levels + 1) * self.words), 0);
        let high_enough = cells.high_enough(self.slab);
        for &part in &high_enough[masks.set..] {
            set(&mut masks.runs[..self.words], self.cells.columns(), part);
        }
        masks.set = high_enough.len();
        for level in 0..self.levels {
            let (shorter, longer) = masks.runs[level * self.words..].split_at_mut(self.words);
            let (shorter, longer) = (&shorter[self.asked.clone()], &mut longer[self.asked.clone()]);
            // What would come from beyond these words is not asked for.
            let second = Shifted::new(shorter, 1 << level);
            let count = second.words.len().saturating_sub(1);
            longer[..count].copy_from_slice(&shorter[..count]);
            second.or_into(&mut longer[..count]);
        }
    }
}

/// The most that the masks of a field take in memory, in bytes: those of one thread.
pub(super) fn most_bytes(cells: &Cells) -> u64 {
    let width = cells.columns().length() as usize;
    let levels = u64::from(width.ilog2()) + 1;
    cells.rows().count() as u64 * levels * (words(width) * size_of::<u64>()) as u64
}

/// The words of a row of masks: one more than the bits take, for those who read shifted words.
fn words(width: usize) -> usize {
    (3 * width).div_ceil(64) + 3
}

impl Span {
    /// The longest run of 2ᵏ parts that is no longer: two of them cover it.
    pub(super) fn level(self) -> usize {
        (self.last - self.first + 1).ilog2() as usize
    }
}

impl<'a> Shifted<'a> {
    fn new(words: &'a [u64], bits: usize) -> Self {
        Self { words: words.get(bits / 64..).unwrap_or_default(), shift: (bits % 64) as u32 }
    }

    /// Sets the bits that are set here, word by word. There must be one word more than asked for.
    #[inline]
    pub(super) fn or_into(self, bits: &mut [u64]) {
        let count = bits.len();
        let (words, following) = (&self.words[..count], &self.words[1..][..count]);
        for (bits, (word, next)) in bits.iter_mut().zip(words.iter().zip(following)) {
            *bits |= (word >> self.shift) | ((next << 1) << (63 - self.shift));
        }
    }
}

/// Sets a part, counted from the first one, wherever it stands within a field's width of the field.
fn set(bits: &mut [u64], columns: Axis, part: u32) {
    let width = columns.length() as usize;
    let mut set = |bit: usize| bits[bit / 64] |= 1 << (bit % 64);
    let bit = (width as i64 + columns.first() + i64::from(part)) as usize;
    match columns.edge {
        Edge::Wrap => [bit - width, bit, bit + width].into_iter().for_each(set),
        Edge::Clamp if part == 0 => (0..=bit).for_each(set),
        Edge::Clamp if part as usize + 1 == columns.count() => (bit..3 * width).for_each(set),
        Edge::Clamp => set(bit),
    }
}
