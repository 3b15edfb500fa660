//! Many channels to one.

use crate::{
    DecodeError, Format,
    samples::{Sample, Samples, with_samples},
};

/// Which channels to look at, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Pick {
    /// This one.
    One(usize),
    /// The first of R, G and B, provided that all three are equal everywhere.
    Grey([usize; 3]),
}

impl Pick {
    /// The channels to decode.
    pub(crate) fn indices(self) -> Vec<usize> {
        match self {
            Self::One(i) => vec![i],
            Self::Grey(rgb) => rgb.to_vec(),
        }
    }

    /// The same pick, where only [`Self::indices`] were decoded.
    pub(crate) fn among_wanted(self) -> Self {
        match self {
            Self::One(_) => Self::One(0),
            Self::Grey(_) => Self::Grey([0, 1, 2]),
        }
    }

    /// How messages and reports call the channel.
    pub(crate) fn name(self, names: &[String]) -> String {
        match self {
            Self::One(i) => names[i].clone(),
            Self::Grey(_) => "R=G=B".to_owned(),
        }
    }
}

/// The rule of the crate's documentation, applied to the names of the channels.
pub(crate) fn pick(format: Format, names: &[String], wanted: Option<&str>) -> Result<Pick, DecodeError> {
    let find = |name: &str| names.iter().position(|n| n == name);
    if let Some(wanted) = wanted {
        return find(wanted).map(Pick::One).ok_or_else(|| DecodeError::NoSuchChannel {
            format,
            wanted: wanted.to_owned(),
            present: list(names),
        });
    }
    let mut opaque = names.iter().enumerate().filter(|(_, name)| *name != "A");
    if let (Some((i, _)), None) = (opaque.next(), opaque.next()) {
        return Ok(Pick::One(i));
    }
    if let Some(y) = find("Y") {
        return Ok(Pick::One(y));
    }
    match (find("R"), find("G"), find("B")) {
        (Some(r), Some(g), Some(b)) => Ok(Pick::Grey([r, g, b])),
        _ if names.len() == 1 => Ok(Pick::One(0)),
        _ => Err(DecodeError::WhichChannel { format, present: list(names) }),
    }
}

/// `R, G, B`, cut short where a file has hundreds.
pub(crate) fn list(names: &[String]) -> String {
    const SHOWN: usize = 12;
    let mut words: Vec<String> =
        names.iter().take(SHOWN).map(|name| name.chars().filter(|c| !c.is_control()).take(64).collect()).collect();
    if names.len() > SHOWN {
        words.push(format!("… ({} in all)", names.len()));
    }
    words.join(", ")
}

/// The channels of a picture in one block of samples.
pub(crate) struct Channels {
    pub(crate) format: Format,
    pub(crate) width: u32,
    pub(crate) height: u32,
    pub(crate) count: usize,
    /// Whether a whole channel follows a whole channel, rather than a texel a texel.
    pub(crate) planar: bool,
    pub(crate) samples: Samples,
}

impl Channels {
    /// The samples of the picked channel alone.
    pub(crate) fn take(self, pick: Pick) -> Result<Samples, DecodeError> {
        let texels = self.width as usize * self.height as usize;
        let found = with_samples!(&self.samples, v => v.len());
        if texels.checked_mul(self.count) != Some(found) {
            return Err(DecodeError::damaged(
                self.format,
                &format_args!("it has {found} samples, not {}", texels * self.count),
            ));
        }
        let stride = if self.planar { 1 } else { self.count };
        let start = |channel: usize| if self.planar { channel * texels } else { channel };
        let (format, width) = (self.format, self.width as usize);
        let channel = match pick {
            Pick::One(channel) => channel,
            Pick::Grey(rgb) => {
                let starts = rgb.map(start);
                if let Some((i, rgb)) = with_samples!(&self.samples, v => first_colour(v, starts, stride, texels)) {
                    let (column, row) = ((i % width) as u32, (i / width) as u32);
                    return Err(DecodeError::Colour { format, column, row, rgb });
                }
                rgb[0]
            }
        };
        Ok(with_samples!(self.samples, v => wrap compact(v, start(channel), stride, texels)))
    }
}

/// The first texel whose three samples are not all equal, and these. NaN is taken for equal to NaN.
fn first_colour<T: Sample>(v: &[T], starts: [usize; 3], stride: usize, texels: usize) -> Option<(usize, [f64; 3])> {
    (0..texels).map(|i| (i, starts.map(|start| v[start + i * stride].to_f64()))).find(|(_, [r, g, b])| {
        let same = |a: f64, b: f64| a == b || (a.is_nan() && b.is_nan());
        !(same(*r, *g) && same(*r, *b))
    })
}

/// Moves one channel to the front and drops the rest, in place: the samples may be gigabytes.
fn compact<T: Sample>(mut v: Vec<T>, start: usize, stride: usize, texels: usize) -> Vec<T> {
    if start != 0 || stride != 1 {
        for i in 0..texels {
            v[i] = v[start + i * stride];
        }
    }
    v.truncate(texels);
    v
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(list: &str) -> Vec<String> {
        list.split(' ').map(str::to_owned).collect()
    }

    #[test]
    fn the_rule_without_a_name() {
        let rule = |list| pick(Format::Exr, &names(list), None);
        assert_eq!(rule("height"), Ok(Pick::One(0)));
        assert_eq!(rule("A"), Ok(Pick::One(0)));
        assert_eq!(rule("A Z"), Ok(Pick::One(1)));
        assert_eq!(rule("B G R Y"), Ok(Pick::One(3)));
        assert_eq!(rule("A B G R"), Ok(Pick::Grey([3, 2, 1])));
        assert_eq!(
            rule("U V").unwrap_err().to_string(),
            "the EXR file does not say which channel is the height; name `channel` as one of U, V"
        );
    }

    #[test]
    fn a_name_wins() {
        assert_eq!(pick(Format::Png, &names("R G B A"), Some("A")), Ok(Pick::One(3)));
        assert_eq!(
            pick(Format::Png, &names("Y A"), Some("R")).unwrap_err().to_string(),
            "`channel` is `R`, which the PNG file does not have; Y, A would be accepted"
        );
    }

    #[test]
    fn planes_and_interleaved_texels_agree() {
        let take = |planar, samples: &[u8], pick| {
            let samples = Samples::U8(samples.to_vec());
            Channels { format: Format::Tiff, width: 2, height: 1, count: 3, planar, samples }.take(pick)
        };
        for channel in 0..3 {
            let expected = Samples::U8(vec![channel as u8, channel as u8 + 10]);
            assert_eq!(take(false, &[0, 1, 2, 10, 11, 12], Pick::One(channel)).as_ref(), Ok(&expected));
            assert_eq!(take(true, &[0, 10, 1, 11, 2, 12], Pick::One(channel)).as_ref(), Ok(&expected));
        }
        assert_eq!(take(false, &[7, 7, 7, 9, 9, 9], Pick::Grey([0, 1, 2])), Ok(Samples::U8(vec![7, 9])));
        assert_eq!(take(true, &[7, 9, 7, 9, 7, 9], Pick::Grey([0, 1, 2])), Ok(Samples::U8(vec![7, 9])));
        assert_eq!(
            take(true, &[7, 9, 7, 9, 7, 8], Pick::Grey([0, 1, 2])).unwrap_err().to_string(),
            "the TIFF image is in colour: at column 1, row 0, R, G and B are 9, 9 and 8; \
             name the `channel` that is the height"
        );
    }
}
