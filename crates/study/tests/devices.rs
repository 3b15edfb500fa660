//! Records of several GPUs in one file.

use barchan_study::{Record, RecordFile};

fn record(device: Option<&str>, gpu_ns: f64) -> Record {
    let device = device.map(str::to_owned);
    Record { technique: "sky".to_owned(), device, is_software: Some(true), gpu_ns: Some(gpu_ns), ..Record::default() }
}

fn file(records: Vec<Record>) -> RecordFile {
    RecordFile { machine: "a box".to_owned(), records }
}

#[test]
fn a_gpu_that_is_measured_again_has_its_new_records_alone_and_others_keep_theirs() {
    let previous = file(vec![record(Some("here"), 1.0), record(Some("elsewhere"), 2.0), record(None, 3.0)]);
    let merged = file(vec![record(Some("here"), 4.0)]).with_other_devices(&previous);
    assert_eq!(merged.records, [record(Some("here"), 4.0), record(Some("elsewhere"), 2.0)]);
}

#[test]
fn times_of_gpus_read_back_as_they_were_written() {
    let written = file(vec![Record { gpu_ns_min: Some(0.5), gpu_ns_spread: Some(0.25), ..record(Some("a, b"), 1.5) }]);
    assert_eq!(RecordFile::from_csv(&written.to_csv().unwrap()).unwrap(), written);
}
