//! Messages of comparisons: two campaigns with the documents of one sample, of which the second is changed.

use super::ran;
use etalon::base::message::Message;
use etalon::compare::{Compared, compare};
use etalon::documents::{Iso9283StreamDocument, ParameterStatus, ParametersDocument, UncertaintyFrom};
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::path::Path;

const CALIBRATION: &str = "prexyt-cmm";

fn read<T: DeserializeOwned>(out: &Path, name: &str) -> Option<T> {
    let bytes = std::fs::read(out.join(name)).ok()?;
    Some(serde_json::from_slice(&bytes).unwrap())
}

fn campaign(sample: &str, folder: &str) -> Compared {
    let out = ran(sample).join("out");
    Compared {
        folder: folder.to_owned(),
        campaign: read(&out, "campaign.json").unwrap(),
        identified: read(&out, "parameters.json").zip(read(&out, "accuracy.json")),
        iso9283: read(&out, "iso9283.json"),
        streams: read(&out, "iso9283-streams.json"),
        inputs: BTreeMap::new(),
        readings: None,
    }
}

fn messages(all: &[Compared]) -> Vec<Message> {
    compare(all).map_or_else(|problems| problems.0, |document| document.messages)
}

/// Two equal campaigns lack the message; the change of the second causes it.
fn hold(id: &str, sample: &str, change: fn(&mut Compared)) {
    let mut all = [campaign(sample, "a"), campaign(sample, "b")];
    let before = messages(&all);
    assert!(before.iter().all(|message| message.id != id), "{id}: {before:?}");
    change(&mut all[1]);
    let after = messages(&all);
    assert!(after.iter().any(|message| message.is(id, &[])), "{id}: {after:?}");
}

fn parameters(compared: &mut Compared) -> &mut ParametersDocument {
    &mut compared.identified.as_mut().unwrap().0
}

#[test]
fn of_parameters_that_are_not_alike() {
    hold("parameters-differ", CALIBRATION, |b| _ = parameters(b).parameters.pop());
    hold("parameters-not-in-all", CALIBRATION, |b| parameters(b).parameters[0].status = ParameterStatus::Fixed);
    hold("nominal-values-differ", CALIBRATION, |b| parameters(b).parameters[3].nominal += 0.5);
    hold("model-misfits", CALIBRATION, |b| parameters(b).residuals.uncertainties_from = UncertaintyFrom::Residuals);
}

#[test]
fn of_a_copy_of_a_campaign() {
    let copy = |folder: &str, readings: &str| Compared {
        readings: Some(readings.to_owned()),
        ..campaign(CALIBRATION, folder)
    };
    let named = |second: &str| {
        let all = messages(&[copy("a", "one"), copy("b", second)]);
        all.iter().any(|message| message.is("campaigns-with-same-readings", &[("count", &1)]))
    };
    assert!(named("one") && !named("other"));
}

#[test]
fn of_tests_that_are_not_alike() {
    fn streams(b: &mut Compared, change: fn(&mut Iso9283StreamDocument)) {
        let all = b.streams.as_mut().unwrap().streams.iter_mut().map(|named| &mut named.stream);
        assert!(all.filter(|stream| stream.path.is_some()).map(change).count() > 0);
    }
    const TEST: &str = "prexyt-repeatability";
    hold("document-not-in-all", TEST, |b| b.streams = None);
    hold("poses-not-in-all", TEST, |b| _ = b.iso9283.as_mut().unwrap().poses.pop());
    hold("stream-not-in-all", TEST, |b| streams(b, |stream| stream.path = None));
    hold("stream-commands-differ", TEST, |b| streams(b, |stream| stream.path.as_mut().unwrap().length_mm *= 1.1));
}
