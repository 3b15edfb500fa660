//! Records as files: the columns are a promise, and what is written reads back.

use barchan_study::{Item, Quantity, Record, RecordFile, Setting};
use proptest::prelude::*;

/// A column may be added at the end; a change here breaks every file of records that was ever written.
const COLUMNS: &str = "technique,setting,scene,width,height,quantity,samples,wrong_share,rms,mean,p99,max,per,rounds,\
                       cpu_ns,cpu_ns_min,cpu_ns_spread,wall_ns,wall_ns_min,wall_ns_spread,fetches,bytes,bake_seconds,\
                       bandwidth_share,height_fetches,table_fetches,gpu_ns,gpu_ns_min,gpu_ns_spread,device,is_software,host";

fn file(records: Vec<Record>) -> RecordFile {
    RecordFile { machine: "a box, 2 cores".to_owned(), records }
}

fn example() -> Record {
    Record {
        technique: "horizon".to_owned(),
        setting: Setting::default().with("method", "sweep").with("directions", 32),
        scene: "dunes".to_owned(),
        width: 512,
        height: 256,
        quantity: Some(Quantity::ElevationDegrees),
        samples: Some(1000),
        rms: Some(1.0 / 3.0),
        per: Some(Item::TexelDirection),
        cpu_ns: Some(16.5),
        ..Record::default()
    }
}

#[test]
fn the_machine_comes_first_then_the_columns_in_their_order() {
    let text = file(vec![example()]).to_csv().unwrap();
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[..2], ["# machine: a box, 2 cores", COLUMNS]);
    assert_eq!(
        lines[2],
        "horizon,method=sweep directions=32,dunes,512,256,elevation_degrees,1000,,0.33333,,,,texel_direction,,16.5,,,,,,,,,,,,,,,,,"
    );
    assert_eq!(lines.len(), 3);
}

#[test]
fn a_scene_may_be_called_anything() {
    let scene = "a \"rock\", split\nin two, # 1";
    let written = file(vec![Record { scene: scene.to_owned(), ..example() }]);
    assert_eq!(RecordFile::from_csv(&written.to_csv().unwrap()).unwrap().records[0].scene, scene);
}

#[test]
fn a_machine_stays_in_its_line() {
    let written = RecordFile { machine: "two\nlines".to_owned(), records: vec![example()] }.to_csv().unwrap();
    assert_eq!(RecordFile::from_csv(&written).unwrap().machine, "two lines");
}

#[test]
fn a_file_from_before_a_column_was_added_is_still_read() {
    let text = "# machine: a box\ntechnique,setting,scene,width,height\nhorizon,method=sweep,dunes,512,256\n";
    let read = RecordFile::from_csv(text).unwrap();
    assert_eq!((read.records[0].width, read.records[0].height_fetches), (512, None));
}

#[test]
fn an_unknown_column_is_refused() {
    let text = file(vec![example()]).to_csv().unwrap();
    let message = RecordFile::from_csv(&text.replacen("technique", "tecnique", 1)).unwrap_err().to_string();
    assert!(message.contains("tecnique"), "{message}");
}

#[test]
fn a_value_that_is_not_its_columns_is_refused() {
    let text = file(vec![example()]).to_csv().unwrap();
    for (right, wrong) in [("512", "wide"), ("elevation_degrees", "elevation"), ("method=sweep", "sweep")] {
        assert!(RecordFile::from_csv(&text.replacen(right, wrong, 1)).is_err(), "{wrong}");
    }
}

prop_compose! {
    fn records()(
        scene in "[ -~]{0,20}",
        width in any::<u32>(),
        bytes in proptest::option::of(any::<u64>()),
        numbers in proptest::array::uniform6(proptest::option::of(-1e30..1e30)),
    ) -> Record {
        let [wrong_share, rms, mean, cpu_ns, wall_ns, bake_seconds] = numbers;
        Record { scene, width, bytes, wrong_share, rms, mean, cpu_ns, wall_ns, bake_seconds, ..example() }
    }
}

proptest! {
    #[test]
    fn what_is_written_reads_back(records in proptest::collection::vec(records(), 1..4)) {
        let written = file(records.into_iter().map(Record::rounded).collect());
        let text = written.to_csv().unwrap();
        let read = RecordFile::from_csv(&text).unwrap();
        prop_assert_eq!(&read, &written);
        prop_assert_eq!(read.to_csv().unwrap(), text);
    }
}
