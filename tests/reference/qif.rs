//! QIF_PTS_SAMPLE: one run of a coordinate measuring machine, published in QIF 2.0, 2.1 and 3.0 by the QIF community.
//!
//! Expected numbers are what the files themselves state of their features, as computed by the program that measured.

use etalon::base::phrase;
use etalon::base::pose::{Vector, cross, dot, minus, norm};
use etalon::documents::{FitDocument, FitStated};
use etalon::fit::{self, Element, FitSettings};
use etalon::formats::qif::{self, MeasuredFeatures, Touch};
use etalon::stages::observe::qif_fit::{ProbeStated, refit};

const PROBE_MM: f64 = 2.49978271104;

/// The sample in 2.0, 2.1 and 3.0.
fn samples() -> Option<[MeasuredFeatures; 3]> {
    let folder = crate::reference_data("exports/qif")?;
    Some(["qif20", "qif21", "qif3"].map(|version| {
        let path = folder.join(format!("{version}_QIF_PTS_SAMPLE.QIF"));
        let text = std::fs::read_to_string(&path).unwrap();
        qif::read(&path.display().to_string(), &text, None).unwrap()
    }))
}

fn fitted(sample: &MeasuredFeatures) -> Vec<FitDocument> {
    let refit = |feature| refit(feature, &FitSettings::default(), ProbeStated::default()).unwrap();
    sample.features.iter().filter_map(refit).collect()
}

fn stated(document: &FitDocument) -> &FitStated {
    document.stated.as_ref().unwrap()
}

#[test]
fn the_three_versions_hold_the_same_691_points_and_14_features() {
    let Some(samples) = samples() else { return };
    let versions: Vec<&str> = samples.iter().map(|s| s.version.as_str()).collect();
    assert_eq!(versions, ["2.0.0", "2.1.0", "3.0.0"]);
    for sample in &samples {
        assert_eq!((sample.points, sample.features.len()), (691, 14), "{}", sample.version);
    }
    let [first, second, third] = samples;
    for (a, b) in first.features.iter().zip(&second.features) {
        assert_eq!((&a.kind, &a.name, a.points_mm.len()), (&b.kind, &b.name, b.points_mm.len()));
        let off = a.points_mm.iter().zip(&b.points_mm).map(|(p, q)| norm(minus(*p, *q))).fold(0.0, f64::max);
        assert!(off < 1e-12, "{}: 2.0 and 2.1 differ by {off:e} mm", a.label());
    }
    // of the 3.0 file: the range "3 8" of eight points, a point without a list, and a reference that leads nowhere
    let short = [("DATUMA", 8, 6), ("POINT3", 1, 0), ("POINT5", 1, 0)];
    for (a, b) in second.features.iter().zip(&third.features) {
        assert_eq!((&a.kind, &a.name), (&b.kind, &b.name));
        let missing = short.iter().find(|s| s.0 == a.label());
        let counts = missing.map_or((b.points_mm.len(), b.points_mm.len()), |s| (s.1, s.2));
        assert_eq!((a.points_mm.len(), b.points_mm.len()), counts, "{}", a.label());
        let last = a.points_mm.iter().rev().zip(b.points_mm.iter().rev());
        for (p, q) in last.filter(|(p, q)| p != q) {
            // one digit of one number was lost: y = -1.74684332805 in 2.0 and 2.1
            assert_eq!((a.label(), p[1], q[1]), ("DATUMB", -1.74684332805, -1.7468432805));
        }
    }
    for feature in first.features.iter().chain(&second.features).filter(|f| !f.points_mm.is_empty()) {
        let Touch::Centre { radius_mm: Some(radius) } = feature.touch else {
            panic!("{} has no probe", feature.label())
        };
        assert!((radius - PROBE_MM).abs() < 1e-10, "{radius}");
    }
}

#[test]
fn the_dangling_reference_of_the_sample_is_reported_with_its_line() {
    let Some([first, second, third]) = samples() else { return };
    assert!(first.messages.is_empty() && second.messages.is_empty());
    let dangling = &third.messages[0];
    // grep -n '>828<': the reference in line 1068 means set 829
    assert_eq!(dangling.place.as_ref().and_then(|p| p.line), Some(1068));
    let hint = phrase!("did-you-mean", name = "829");
    assert!(dangling.is("reference-broken", &[("id", &"828"), ("hint", &hint)]), "{dangling}");
    let unused = &third.messages[1..];
    assert_eq!(unused.len(), 2);
    assert!(unused.iter().zip(["777", "829"]).all(|(message, id)| message.is("point-set-unused", &[("id", &id)])));
}

#[test]
fn stated_circles_cylinder_and_line_of_2_1_and_3_0_are_reproduced_after_probe_compensation() {
    let Some([_, second, third]) = samples() else { return };
    for sample in [second, third] {
        let documents = fitted(&sample);
        let labels: Vec<&str> = documents.iter().filter_map(|d| d.label.as_deref()).collect();
        assert_eq!(labels, ["DATUMA", "DATUMB", "DATUMC", "CIRCLE1", "CIRCLE2", "CYL_1"]);
        let mut worst = 0.0f64;
        for document in &documents[1..] {
            let (label, stated) = (document.label.as_deref().unwrap_or(""), stated(document));
            // observed agreement: points have twelve decimals, and the program that measured stopped somewhere
            let limit = if label == "DATUMC" { 3e-7 } else { 5e-9 };
            let off = stated.point_apart_mm.unwrap().max(stated.radius_less_stated_mm.unwrap_or(0.0).abs());
            assert!(off < limit, "{} {label}: {off:e} mm", sample.version);
            assert!(stated.direction_apart_deg.unwrap() < 3e-7, "{} {label}: {stated:?}", sample.version);
            worst = if label == "DATUMC" { worst } else { worst.max(off) };
            // without compensation it would be off by the probe
            let probe = document.probe.as_ref().unwrap();
            assert!((probe.radius_mm - PROBE_MM).abs() < 1e-10);
            if let (Some(before), Some(said)) = (probe.uncompensated_radius_mm, stated.radius_mm) {
                assert!((said - before - PROBE_MM).abs() < limit, "{label} was touched from inside");
            }
        }
        println!("QIF {}: circles and cylinder within {worst:.1e} mm of what is stated", sample.version);
    }
}

#[test]
fn the_three_versions_give_the_same_fits() {
    let Some(samples) = samples() else { return };
    let [first, second, third] = samples.each_ref().map(fitted);
    assert_eq!([first.len(), second.len(), third.len()], [6; 3]);
    for ((a, b), c) in first.iter().zip(&second).zip(&third) {
        let label = a.label.as_deref().unwrap_or("");
        let same = |a: &FitDocument, b: &FitDocument| {
            let place = |d: &FitDocument| d.geometry.center_mm.or(d.geometry.point_mm).unwrap();
            let off = norm(minus(place(a), place(b)));
            let size = a.geometry.radius_mm.unwrap_or(0.0) - b.geometry.radius_mm.unwrap_or(0.0);
            // the lost digit of the 3.0 file moves one of 219 points by 5e-8 mm
            let limit = if label == "DATUMB" { 1e-9 } else { 1e-11 };
            assert!(off < limit && size.abs() < limit, "{label}: {off:e} mm, {size:e} mm");
        };
        same(a, b);
        // the plane of the 3.0 file has six of the eight points
        if label != "DATUMA" {
            same(b, c);
        }
    }
    assert_eq!([first[0].points, second[0].points, third[0].points], [8, 8, 6]);
}

/// Largest and root mean square of the distances of points from a stated plane or circle or cylinder of probe centres.
fn spread(distances: impl Iterator<Item = f64>) -> (f64, f64) {
    let all: Vec<f64> = distances.collect();
    let rms = (all.iter().map(|d| d * d).sum::<f64>() / all.len() as f64).sqrt();
    (all.iter().fold(f64::NEG_INFINITY, |m, d| m.max(*d)), rms)
}

#[test]
fn what_2_0_states_and_the_datum_planes_are_other_criteria_than_least_squares() {
    let Some(samples) = samples() else { return };
    for sample in &samples[..2] {
        for (feature, document) in
            sample.features.iter().filter(|f| f.points_mm.len() > 2).zip(fitted(sample).iter().filter(|d| d.points > 2))
        {
            let said = &feature.stated;
            let (p, d) = (said.point_mm.unwrap(), said.direction.unwrap());
            let centres = said.radius_mm.map_or(0.0, |r| r - PROBE_MM);
            let distance = |q: &Vector| match document.element.as_str() {
                "plane" => dot(minus(*q, p), d),
                _ => norm(cross(minus(*q, p), d)) - centres,
            };
            let (largest, rms) = spread(feature.points_mm.iter().map(distance));
            let (label, version) = (feature.label(), &sample.version);
            if document.element != "plane" {
                // least squares leaves no more than any other circle or cylinder does
                assert!(
                    document.deviations.rms_mm <= rms * (1.0 + 1e-12),
                    "{version} {label}: {} over {rms}",
                    document.deviations.rms_mm
                );
                let stated = stated(document).radius_less_stated_mm.unwrap().abs();
                assert!(stated < if version == "2.1.0" { 5e-9 } else { 3e-5 }, "{version} {label}: {stated:e}");
                // the same points, and yet in 2.0 circles and cylinder are stated some micrometres away
                let apart = document.stated.as_ref().unwrap().point_apart_mm.unwrap();
                assert!(
                    if version == "2.1.0" { apart < 5e-9 } else { apart > 5e-4 && apart < 4e-3 },
                    "{label}: {apart:e}"
                );
                continue;
            }
            // a datum plane that all points are below, as a surface plate would lie: no least-squares plane
            let probe = if version == "2.0.0" { 0.0 } else { PROBE_MM };
            let above = largest - probe;
            let limit = if version == "2.0.0" { -4e-5 } else { -4e-9 };
            assert!(above < 0.0 && above > limit, "{version}: {above:e}");
            let plane = fit::element(Element::Plane, &feature.points_mm, &FitSettings::default()).unwrap();
            let height = plane.geometry.point_mm[2] - probe;
            // the file was aligned to its least-squares plane: z = 0 at the surface, and no tilt
            assert!(
                (plane.geometry.point_mm[2] - PROBE_MM).abs() < 1e-11
                    && norm(cross(plane.geometry.direction.unwrap(), [0.0, 0.0, 1.0])) < 1e-12
            );
            assert!((p[2] - height).abs() < plane.form_mm(), "{version}: the planes are apart less than the form");
        }
    }
}

#[test]
fn every_published_sample_is_read_with_the_counts_of_its_elements() {
    let Some(folder) = crate::reference_data("exports/qif") else { return };
    let mut files = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if !path.extension().is_some_and(|e| e.eq_ignore_ascii_case("qif")) {
            continue;
        }
        files += 1;
        let text = std::fs::read_to_string(&path).unwrap();
        let read = qif::read(&path.display().to_string(), &text, None).unwrap_or_else(|e| panic!("{e}"));
        let closed = text.matches("FeatureMeasurement>").count() + text.matches("FeatureActual>").count();
        assert_eq!(read.features.len(), closed, "{}", path.display());
        assert!(
            read.features.iter().all(|f| f.stated.point_mm.is_some() || f.stated == qif::FeatureGeometry::default())
        );
    }
    assert_eq!(files, 15);
}
