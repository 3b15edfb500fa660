//! Damaged and hostile files: nothing panics between the bytes and the shader. Every change is sealed with right checksums, so that
//! it gets past them.

mod support;

use barchan_asset::vectors::reseal;
use barchan_asset::{SectionKind, Semantic};
use barchan_wgpu::{
    DeviceLimits, ReadError, Reader, ReliefSearch, Sampling, Selection, Shader, ShaderOptions, TablePart, Technique,
    UploadPlan,
};
use support::{accepted, carried_out, file, heights, vector};

/// All that a program does with a file, short of a device. Whether it got as far as a plan.
fn exercise(bytes: &[u8], composes: bool) -> bool {
    let Ok(reader) = Reader::open(bytes) else { return false };
    let _ = reader.check_bytes();
    let part = TablePart { azimuths: Some((1, 2)), candidates: Some(1), rings: Some(1), first_level: 1 };
    let parts = Semantic::ALL.into_iter().fold(Selection::everything(), |all, table| all.with_part(table, part));
    let mut is_planned = false;
    for selection in [Selection::everything(), parts, Selection::of_techniques(&reader, &[Technique::CurvedShadow])] {
        let Ok(plan) = UploadPlan::new(&reader, &selection, &DeviceLimits::WEBGPU) else { continue };
        is_planned = true;
        let _ = (plan.parameters(), plan.bytes());
        for texture in plan.textures() {
            if reader.payload(texture.table.kind()).is_ok() && texture.bytes() < 1 << 20 {
                carried_out(&reader, texture);
            }
        }
        if composes {
            compose(&plan);
        }
    }
    is_planned
}

fn compose(plan: &UploadPlan) {
    let relief = Technique::Relief(ReliefSearch::MaximumMip);
    let groups: [&[Technique]; 5] = [
        &[Technique::Surface, Technique::HorizonShadow],
        &[Technique::CurvedShadow, Technique::Penumbra],
        &[Technique::Sky, Technique::ApertureCone],
        &[relief, Technique::ReliefShadow],
        &[Technique::Relief(ReliefSearch::ConeSteps)],
    ];
    for techniques in groups {
        let options = ShaderOptions { sampling: Sampling::Filtered, ..ShaderOptions::default() };
        let _ = Shader::compose(plan, techniques, &options);
    }
}

/// Where numbers decide something: the header, the table of sections, every descriptor.
fn places(file: &[u8]) -> Vec<usize> {
    let count = file[24] as usize;
    let descriptors = (4096..file.len()).step_by(4096).flat_map(|at| at..at + 256);
    (0..128 + 64 * count).chain(descriptors).filter(|&at| at < file.len()).collect()
}

#[test]
fn no_changed_byte_panics() {
    let (mut planned, mut refused) = (0, 0);
    for vector in accepted() {
        let mut file = vector.bytes;
        for at in places(&file) {
            let kept = file[at];
            for changed in [kept ^ 1, kept ^ 0x80, kept.wrapping_add(1), 0xFF] {
                let mut mutant = file.clone();
                mutant[at] = changed;
                reseal(&mut mutant);
                let is_planned = exercise(&mutant, changed == kept ^ 1 && at % 8 == 0);
                planned += u32::from(is_planned);
                refused += u32::from(!is_planned);
            }
            file[at] = kept;
        }
    }
    assert!(planned > 10_000 && refused > 10_000, "{planned} planned, {refused} refused");
}

#[test]
fn no_truncated_file_panics() {
    for vector in accepted() {
        for length in 0..vector.bytes.len() {
            assert!(!exercise(&vector.bytes[..length], false), "{} of {length} bytes", vector.name);
            // The same with a header that agrees.
            if length >= 128 && length % 61 == 0 {
                let mut file = vector.bytes[..length].to_vec();
                file[16..24].copy_from_slice(&(length as u64).to_le_bytes());
                reseal(&mut file);
                exercise(&file, false);
            }
        }
    }
}

#[test]
fn no_random_file_panics() {
    let mut state = 0x9E37_79B9_7F4A_7C15_u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        state
    };
    let start = vector("relief-f16");
    for round in 0..2000 {
        // The first bytes of a file, and noise behind them: from nothing but the magic to all of the section table.
        let kept = (random() % (start.len() as u64)).min(128 + 64 * 5) as usize * (round % 2);
        let mut file: Vec<u8> = start[..kept].to_vec();
        file.extend((kept..start.len()).map(|_| random() as u8));
        reseal(&mut file);
        exercise(&file, true);
    }
}

#[test]
fn damage_that_the_structure_does_not_show_is_found_by_the_checksums() {
    let mut bytes = file(vec![heights(8, barchan_asset::Wrap::Clamp, barchan_asset::Encoding::F32)]);
    Reader::open(&bytes).unwrap().check_bytes().unwrap();
    *bytes.last_mut().unwrap() ^= 1;
    let error = Reader::open(&bytes).unwrap().check_bytes().unwrap_err();
    assert_eq!(error, ReadError::Damaged { kind: SectionKind::HEIGHT });
}

#[test]
fn a_newer_file_is_read_but_for_what_it_says_one_may_skip() {
    let bytes = vector("unknown-ancillary");
    let reader = Reader::open(&bytes).unwrap();
    assert_eq!(reader.skipped(), [SectionKind(*b"NOTE")]);
    assert!(reader.texture(Semantic::Height).is_some());

    // The same in a file of a newer minor version.
    let mut newer = bytes;
    newer[14] = 9;
    reseal(&mut newer);
    let reader = Reader::open(&newer).unwrap();
    assert_eq!((reader.asset().version(), reader.skipped()), ((1, 9), &[SectionKind(*b"NOTE")][..]));
    assert_eq!(UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::WEBGPU).unwrap().textures().len(), 1);
}

#[test]
fn an_unknown_table_that_matters_is_refused_by_name() {
    let message = Reader::open(&vector("refused/unknown-critical")).unwrap_err().to_string();
    assert_eq!(message, "section 1 (NOTE): the section is critical and this reader does not know its kind");
}

#[test]
fn a_table_in_an_unknown_codec_that_one_may_skip_is_skipped() {
    let mut bytes = vector("relief-f16");
    let hemisphere = 128 + 64;
    assert_eq!(&bytes[hemisphere..hemisphere + 4], b"HEMI");
    bytes[hemisphere + 10] = 77;
    reseal(&mut bytes);
    let reader = Reader::open(&bytes).unwrap();
    assert_eq!(reader.skipped(), [SectionKind::HEMISPHERE]);
    assert!(UploadPlan::new(&reader, &Selection::everything(), &DeviceLimits::WEBGPU).is_ok());
    let message = reader.payload(SectionKind::HEMISPHERE).unwrap_err().to_string();
    assert_eq!(message, "section HEMI is stored with codec 77; 0 (raw) and 1 (zstd) are accepted");
}
