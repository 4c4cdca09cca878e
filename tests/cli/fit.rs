//! `etalon fit`: probes, QIF, and points that determine nothing.

use super::{etalon, text};
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::worded::Worded;
use etalon::documents::FitDocument;
use std::fmt::Write;
use std::process::Output;

/// Points of a ball of radius 12.5 mm: centres of a probe of 2.5 mm that touched one of 10 mm from outside, or one of
/// 15 mm from inside.
fn ball() -> String {
    let mut lines = String::new();
    for i in 0..20 {
        let ((s, c), (t, d)) = ((0.7 * f64::from(i)).sin_cos(), (0.31 * f64::from(i)).sin_cos());
        let _ = writeln!(lines, "{:.12} {:.12} {:.12}", 12.5 * c * d, 12.5 * s * d, 12.5 * t);
    }
    lines
}

#[test]
fn a_probe_is_stated_with_its_side() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("b.txt"), ball()).unwrap();
    let run = |element: &str, rest: &[&str]| {
        etalon(folder.path(), &[&["fit", element, "b.txt", "--unit", "mm", "--json"], rest].concat())
    };
    for (side, radius) in [("outside", 10.0), ("inside", 15.0)] {
        let answered = run("sphere", &["--probe-radius-mm", "2.5", "--probe-side", side]);
        let document: FitDocument = serde_json::from_slice(&answered.stdout).unwrap();
        assert!((document.geometry.radius_mm.unwrap() - radius).abs() < 1e-9, "{side}: {document:?}");
        let probe = document.probe.unwrap();
        assert_eq!((probe.side.as_str(), probe.radius_mm), (side, 2.5));
        assert!((probe.uncompensated_radius_mm.unwrap() - 12.5).abs() < 1e-9);
    }
    let refused = |element: &str, rest: &[&str], part: &str| {
        let output = run(element, rest);
        let said = text(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.says(part) && said.contains("hint:") && output.stdout.is_empty(), "{part:?} is not said: {said}");
    };
    refused("sphere", &["--probe-radius-mm", "2.5"], "error[probe-side-missing]");
    refused("sphere", &["--probe-side", "inside"], "error[probe-radius-missing]");
    refused("sphere", &["--probe-radius-mm", "2.5", "--probe-side", "left"], "error[probe-side-unknown]");
    refused("sphere", &["--probe-radius-mm", "2.5", "--probe-side", "0,0,1"], "error[probe-side-needs-inside]");
    refused("sphere", &["--probe-radius-mm", "13", "--probe-side", "outside"], "error[probe-larger-than-element]");
    refused(
        "sphere",
        &["--probe-radius-mm", "-1", "--probe-side", "outside"],
        "error[probe-radius-not-positive] radius=-1",
    );
    refused("plane", &["--probe-radius-mm", "2.5", "--probe-side", "inside"], "error[probe-side-needs-direction]");
    refused("enclosing-sphere", &["--probe-radius-mm", "2.5", "--probe-side", "inside"], "not compensated");
    let up = run("plane", &["--probe-radius-mm", "2.5", "--probe-side", "-0.1,-0.1,-1"]);
    let document: FitDocument = serde_json::from_slice(&up.stdout).unwrap();
    let (before, after) = (document.probe.unwrap().uncompensated_point_mm, document.geometry.point_mm.unwrap());
    assert!(
        after[2] > before[2] || document.geometry.normal.unwrap()[2].abs() < 0.5,
        "the probe was below: the plane is above"
    );
}

const UNITS: &str = "<FileUnits><PrimaryUnits><LinearUnit><UnitName>mm</UnitName><UnitConversion><Factor>0.001</Factor>\
                     </UnitConversion></LinearUnit></PrimaryUnits></FileUnits>";

/// A QIF file with a bore of 30 mm measured by a probe of 2.5 mm, without a word on its side but its nominal diameter.
fn bore() -> String {
    let mut points = String::new();
    for i in 0..12 {
        let (s, c) = f64::from(i).sin_cos();
        let _ = write!(points, "{:.12} {:.12} 5 ", 12.5 * c, 12.5 * s);
    }
    format!(
        "<QIFDocument versionQIF=\"3.0.0\">{UNITS}<CircleFeatureDefinition id=\"1\"><Diameter>30</Diameter>\
         </CircleFeatureDefinition><CircleFeatureNominal id=\"2\"><FeatureDefinitionId>1</FeatureDefinitionId>\
         </CircleFeatureNominal><CircleFeatureItem id=\"3\"><FeatureNominalId>2</FeatureNominalId><FeatureName>B</FeatureName>\
         </CircleFeatureItem><CircleFeatureMeasurement id=\"4\"><FeatureItemId>3</FeatureItemId><PointList n=\"1\">\
         <WholePointSetId>5</WholePointSetId></PointList><Location>0 0 5</Location><Normal>0 0 1</Normal>\
         <Diameter>30.002</Diameter></CircleFeatureMeasurement><MeasuredPointSet id=\"5\" count=\"12\"><Points>{points}\
         </Points><Compensated>false</Compensated><ProbeRadius>2.5</ProbeRadius></MeasuredPointSet></QIFDocument>"
    )
}

#[test]
fn qif_features_are_set_against_what_the_file_states() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("b.qif"), bore()).unwrap();
    let answered = etalon(folder.path(), &["fit", "b.qif", "--json"]);
    let documents: Vec<FitDocument> = serde_json::from_slice(&answered.stdout).unwrap();
    let [document] = &documents[..] else { panic!("{documents:?}") };
    assert_eq!((document.label.as_deref(), document.element.as_str()), (Some("B"), "circle3d"));
    assert!((document.geometry.radius_mm.unwrap() - 15.0).abs() < 1e-9, "{document:?}");
    let probe = document.probe.as_ref().unwrap();
    assert_eq!(
        (probe.side.as_str(), probe.side_from.as_ref().map(Worded::english)),
        ("inside", Some("from the nominal diameter"))
    );
    let stated = document.stated.as_ref().unwrap();
    assert!((stated.radius_less_stated_mm.unwrap() + 0.001).abs() < 1e-9, "{stated:?}");
    assert_eq!(stated.id, "4");
    let lines = text(&etalon(folder.path(), &["fit", "circle3d", "b.qif"]).stdout);
    assert!(lines.contains("from the nominal diameter") && lines.contains("fitted -1.00e-3 mm"), "{lines}");
    let fitted = |rest: &[&str]| -> Output { etalon(folder.path(), &[&["fit", "b.qif", "--json"], rest].concat()) };
    // what the user states goes over what the file says
    let outside: Vec<FitDocument> = serde_json::from_slice(&fitted(&["--probe-side", "outside"]).stdout).unwrap();
    assert!((outside[0].geometry.radius_mm.unwrap() - 10.0).abs() < 1e-9);
    for (rest, part) in [
        (&["--unit", "inch"][..], "error[unit-differs] of_file=mm"),
        (&["--radius-mm", "15"], "error[qif-with-columns]"),
        (&["--probe-side", "0,0,1"], "error[probe-side-needs-inside]"),
    ] {
        let refused = fitted(rest);
        assert_eq!(refused.status.code(), Some(2));
        assert!(text(&refused.stderr).says(part), "{}", text(&refused.stderr));
    }
    let none = etalon(folder.path(), &["fit", "plane", "b.qif"]);
    assert!(text(&none.stderr).has_phrase("no-feature-fitted.hint seen=circle3d"), "{}", text(&none.stderr));
    // neither nominal, stated nor internal: the radius of the centres is no answer
    let bare = bore().replace("Diameter>", "Depth>");
    std::fs::write(folder.path().join("b.qif"), bare).unwrap();
    let refused = fitted(&[]);
    let said = text(&refused.stderr);
    assert!(refused.status.code() == Some(2) && refused.stdout.is_empty(), "{said}");
    assert!(said.says("[probe-of-feature-unknown] feature=B missing=side") && said.contains("--probe-side"), "{said}");
    // other texts do not say their element
    std::fs::write(folder.path().join("b.txt"), ball()).unwrap();
    let said = text(&etalon(folder.path(), &["fit", "b.txt"]).stderr);
    assert!(said.contains("[fit-element-missing]") && said.contains("hint:"), "{said}");
}

#[test]
fn a_campaign_reads_the_same_points_from_qif() {
    let (polyworks, qif) = (copy_sample("prexyt-cmm"), copy_sample("prexyt-cmm"));
    for file in ["exports/world.txt", "exports/poses.txt"] {
        let mut features = String::new();
        for (i, line) in std::fs::read_to_string(qif.path().join(file)).unwrap().lines().enumerate() {
            let (name, place) = line.split_once(' ').unwrap();
            let _ = writeln!(
                features,
                "<PointFeatureItem id=\"i{i}\"><FeatureName>{name}</FeatureName></PointFeatureItem>\
                 <PointFeatureMeasurement id=\"m{i}\"><FeatureItemId>i{i}</FeatureItemId><Location>{place}</Location>\
                 </PointFeatureMeasurement>"
            );
        }
        let document = format!("<QIFDocument versionQIF=\"3.0.0\">{UNITS}\n{features}</QIFDocument>\n");
        std::fs::write(qif.path().join(file), document).unwrap();
    }
    qif.replace("campaign.toml", "format = \"polyworks\"", "format = \"qif\"");
    let observations = [&polyworks, &qif].map(|scratch| {
        let output = etalon(scratch.root(), &["run", "campaign"]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        std::fs::read_to_string(scratch.path().join("out/observations.csv")).unwrap()
    });
    assert!(observations[0] == observations[1]);
    // the unit that the campaign states is the file's, or it is an error
    qif.replace("campaign.toml", "unit = \"mm\"", "unit = \"inch\"");
    let refused = etalon(qif.root(), &["check", "campaign"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(text(&refused.stderr).says("error[unit-differs] of_file=mm"));
}

#[test]
fn points_that_determine_nothing_are_messages_and_never_numbers_that_are_none() {
    let folder = tempfile::tempdir().unwrap();
    let row = |n: usize, p: &dyn Fn(f64) -> [f64; 3]| -> String {
        (0..n).map(|i| p(i as f64)).map(|[x, y, z]| format!("{x:e} {y:e} {z:e}\n")).collect()
    };
    let ring = |size: f64, far: f64| row(24, &|i| [far + size * i.cos(), far + size * i.sin(), far + size * (i % 4.0)]);
    let sets = [
        ("no point", String::new()),
        ("1 point", row(1, &|_| [1.0, 2.0, 3.0])),
        ("2 points", row(2, &|i| [i, 2.0, 3.0])),
        ("identical", row(9, &|_| [3.0, -4.0, 1e3])),
        ("on a line", row(9, &|i| [i / 3.0, 1.0 - i / 7.0, i])),
        ("in a plane", row(12, &|i| [i * i % 7.0, i, 2.0])),
        ("1e6 mm away", ring(1.0, 1e6)),
        ("1e-6 mm small", ring(1e-6, 0.0)),
        ("1e-6 mm small and 1e6 mm away", ring(1e-6, 1e6)),
        ("1e90 mm large", ring(1e90, 0.0)),
        ("larger than any square", ring(1e200, 0.0)),
        ("infinite", "inf 0 0\n1 2 3\n".to_owned()),
        ("no number", "1 2 3\nnan 0 0\n".to_owned()),
        ("too large", "1e999 0 0\n1 2 3\n".to_owned()),
    ];
    let elements = etalon::fit::Element::ALL.map(|e| e.name());
    for (what, points) in &sets {
        std::fs::write(folder.path().join("p.txt"), points).unwrap();
        for element in elements.iter().copied().chain(["enclosing-circle", "enclosing-sphere"]) {
            let output = etalon(folder.path(), &["fit", element, "p.txt", "--unit", "mm", "--json"]);
            let said = text(&output.stderr);
            assert!(!said.contains("panicked"), "{element} of {what}: {said}");
            match output.status.code() {
                Some(0) => {
                    // a number that is none would be written as null, where the document wants a number
                    let document: FitDocument = serde_json::from_slice(&output.stdout)
                        .unwrap_or_else(|e| panic!("{element} of {what}: {e}: {}", text(&output.stdout)));
                    let size = [
                        document.geometry.radius_mm,
                        document.geometry.minor_radius_mm,
                        document.geometry.apex_angle_deg,
                    ];
                    assert!(size.into_iter().flatten().all(f64::is_finite), "{element} of {what}: {document:?}");
                }
                Some(2) => {
                    assert!(said.starts_with("error") && output.stdout.is_empty(), "{element} of {what}: {said}")
                }
                code => panic!("{element} of {what}: {code:?}: {said}"),
            }
        }
    }
}

#[test]
fn formats_with_a_reader_of_their_own_are_fitted_by_label() {
    let folder = tempfile::tempdir().unwrap();
    let (mut inspec, mut ply) = (String::from("\"C 1: Diameter\",20\n7.5\n\"C 1: 3D MCS Points\"\n"), Vec::new());
    for i in 0..12 {
        let (s, c) = f64::from(i).sin_cos();
        let _ = writeln!(inspec, "{:.12},{:.12},5", 10.0 * c, 10.0 * s);
        ply.extend([10.0 * c, 10.0 * s, 5.0].into_iter().flat_map(f64::to_le_bytes));
    }
    std::fs::write(folder.path().join("c.csv"), inspec).unwrap();
    let head = "ply\nformat binary_little_endian 1.0\nelement vertex 12\nproperty double x\nproperty double y\nproperty double z\n\
                end_header\n";
    std::fs::write(folder.path().join("c.ply"), [head.as_bytes(), &ply].concat()).unwrap();
    let fit = |file: &str, rest: &[&str]| -> Output {
        etalon(folder.path(), &[&["fit", "circle3d", file, "--unit", "mm", "--json", "--by-label"], rest].concat())
    };
    for (file, format, label) in [("c.csv", "inspec", Some("C 1")), ("c.ply", "ply", None)] {
        let answered = fit(file, &["--format", format]);
        let documents: Vec<FitDocument> = serde_json::from_slice(&answered.stdout).unwrap();
        assert_eq!(
            (documents.len(), documents[0].label.as_deref(), documents[0].points),
            (1, label, 12),
            "{documents:?}"
        );
        assert!((documents[0].geometry.radius_mm.unwrap() - 10.0).abs() < 1e-9, "{documents:?}");
        let said = text(&answered.stderr);
        assert_eq!(said.says("warning[rows-left-out] count=1"), format == "inspec", "{said}");
    }
    for (rest, part) in [
        (&["--format", "inspect"][..], "--format: invalid value"),
        (&["--format", "dmis"], "error[no-measured-points]"),
    ] {
        let refused = fit("c.csv", rest);
        assert_eq!(refused.status.code(), Some(2));
        assert!(text(&refused.stderr).says(part), "{}", text(&refused.stderr));
    }
}

#[test]
fn outlying_points_are_named_and_set_aside_on_request() {
    let folder = tempfile::tempdir().unwrap();
    let mut lines = ball();
    lines += "14 0 0.5\n";
    std::fs::write(folder.path().join("b.txt"), &lines).unwrap();
    let run = |rest: &[&str]| {
        let output = etalon(folder.path(), &[&["fit", "sphere", "b.txt", "--unit", "mm", "--json"], rest].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        serde_json::from_slice::<FitDocument>(&output.stdout).unwrap()
    };
    let plain = run(&[]);
    assert!(
        plain.messages.iter().any(|m| m.id == "points-outlying") && plain.set_aside.is_none(),
        "{:?}",
        plain.messages
    );
    let robust = run(&["--robust"]);
    assert_eq!((robust.set_aside, robust.points), (Some(vec![21]), 21));
    assert!((robust.geometry.radius_mm.unwrap() - 12.5).abs() < 1e-9);
    std::fs::write(folder.path().join("b.txt"), ball()).unwrap();
    assert_eq!(run(&[]).messages, []);
    assert_eq!(run(&["--robust"]).set_aside, Some(Vec::new()));
}

/// Answer of a fit of points in `tests/cli/points`, as a document and as text.
fn fitted(points: &str, rest: &[&str]) -> (FitDocument, String) {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.txt"), points).unwrap();
    let run = |more: &[&str]| {
        let output = etalon(folder.path(), &[&["fit", rest[0], "p.txt", "--unit", "mm"], &rest[1..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{rest:?}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    (serde_json::from_str(&run(&["--json"])).unwrap(), run(&[]))
}

fn ids(document: &FitDocument) -> Vec<&str> {
    document.messages.iter().map(|m| &*m.id).collect()
}

const ARC_AND_TWO_FAR: &str = include_str!("points/circle-arc-and-two-far.txt");
const CLUSTER_AND_TWO_FAR: &str = include_str!("points/line-cluster-and-two-far.txt");
const FIVE: &str = include_str!("points/cylinder-five.txt");
const CUBE: &str = include_str!("points/cube.txt");
const CROSS: &str = include_str!("points/cross.txt");
const STRIP: &str = include_str!("points/strip.txt");

#[test]
fn points_far_from_all_others_are_sound_if_one_element_explains_all() {
    let (circle, _) = fitted(ARC_AND_TWO_FAR, &["circle3d", "--robust"]);
    assert_eq!((circle.set_aside.as_deref(), circle.points), (Some(&[][..]), 60));
    // without `--robust` 99.99998 mm, standard uncertainty 0.0008 mm
    assert!((circle.geometry.radius_mm.unwrap() - 99.99998).abs() < 1e-5, "{circle:?}");
    let (line, _) = fitted(CLUSTER_AND_TWO_FAR, &["line", "--robust"]);
    assert_eq!(line.set_aside.as_deref(), Some(&[][..]));
    // 0.05 mm off, 25 times the noise, where the arc and the other far point determine the circle
    let mut moved: Vec<String> = ARC_AND_TWO_FAR.lines().map(str::to_owned).collect();
    let row: Vec<f64> = moved[20].split_whitespace().map(|v| v.parse().unwrap()).collect();
    moved[20] = format!("{} {} {}", row[0] * 1.0005, row[1] * 1.0005, row[2]);
    let (circle, _) = fitted(&(moved.join("\n") + "\n"), &["circle3d", "--robust"]);
    assert_eq!(circle.set_aside, Some(vec![21]));
}

#[test]
fn a_minimum_zone_has_the_warnings_of_the_least_squares_fit_of_the_same_points() {
    let mut outlier: String = (0..40).map(|i| format!("{} {} 0.00{}\n", i % 7 * 10, i % 9 * 8, i * 7 % 5)).collect();
    outlier += "31 22 0.9\n";
    for (element, points, expected) in [
        ("cylinder", FIVE, &["element-ambiguous", "element-without-redundancy"][..]),
        ("cylinder", CUBE, &["element-ambiguous"]),
        ("plane", CUBE, &["element-ambiguous"]),
        ("plane", outlier.as_str(), &["points-outlying"]),
    ] {
        let (squares, _) = fitted(points, &[element]);
        let (zone, _) = fitted(points, &[element, "--minimum-zone"]);
        let [squares, zone] = [ids(&squares), ids(&zone)];
        assert!(expected.iter().all(|id| squares.contains(id)), "{element}: {squares:?}");
        assert!(squares.iter().all(|id| zone.contains(id)), "{element}: {squares:?} {zone:?}");
    }
}

#[test]
fn a_direction_that_points_do_not_determine_is_named_with_its_uncertainty() {
    for (element, points, id, name) in [
        ("plane", CUBE, "element-ambiguous", "normal"),
        ("line", CROSS, "element-ambiguous", "axis"),
        ("plane", STRIP, "element-direction-uncertain", "normal"),
        ("circle3d", CUBE, "element-ambiguous", "normal"),
    ] {
        let (document, shown) = fitted(points, &[element]);
        assert!(ids(&document).contains(&id), "{element}: {:?}", document.messages);
        let line = shown.lines().find(|line| line.trim_start().starts_with(name)).unwrap();
        assert!(line.contains("(u = ") && line.ends_with(" deg)"), "{shown}");
    }
    // a plate of 100 mm with noise of 0.01 mm has a normal
    let plate: String = (0..25).map(|i| format!("{} {} 0.0{}\n", i % 5 * 25, i / 5 * 25, i * 7 % 3)).collect();
    assert_eq!(ids(&fitted(&plate, &["plane"]).0), [""; 0]);
}

/// Points of a sphere of radius 38.1 mm as rows of a table.
fn sphere(row: impl Fn(usize, [f64; 3]) -> String) -> String {
    let point = |i: usize| {
        let ((s, c), (t, d)) = ((1.3 * i as f64).sin_cos(), (0.4 * i as f64 - 1.0).sin_cos());
        [1234.567 + 38.1 * d * c, -345.678 + 38.1 * d * s, 89.012 + 38.1 * t]
    };
    (0..12).map(|i| row(i, point(i)) + "\n").collect()
}

#[test]
fn one_language_of_tables_reads_the_files_of_every_program() {
    let folder = tempfile::tempdir().unwrap();
    let radius = |bytes: &[u8], options: &[&str]| {
        std::fs::write(folder.path().join("p.txt"), bytes).unwrap();
        let answered = etalon(folder.path(), &[&["fit", "sphere", "p.txt", "--json"], options].concat());
        let said = text(&answered.stderr);
        let document: Option<FitDocument> = serde_json::from_slice(&answered.stdout).ok();
        (document.and_then(|document| document.geometry.radius_mm), said)
    };
    let fits = |bytes: &[u8], options: &[&str]| {
        let (radius, said) = radius(bytes, options);
        assert!(radius.is_some_and(|radius| (radius - 38.1).abs() < 1e-3), "{radius:?}: {said}");
        said
    };
    let plain = format!("Name\tX\tY\tZ\n{}", sphere(|i, [x, y, z]| format!("K{i}\t{x:.4}\t{y:.4}\t{z:.4}")));
    let columns = ["--unit", "mm", "--delimiter", "tab", "--header", "1", "--columns", "label,x,y,z"];
    let utf_16: Vec<u8> = "\u{feff}".encode_utf16().chain(plain.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    fits(&utf_16, &columns);
    fits(plain.replace('\n', "\r").as_bytes(), &columns);
    let japanese: Vec<u8> = [b"\x93_\t".as_slice(), plain.trim_start_matches("Name\t").as_bytes()].concat();
    fits(&japanese, &[&columns[..], &["--encoding", "shift_jis"]].concat());
    // rows that were not measured are counted
    let gaps = plain.clone() + "K90\tNaN\tNaN\tNaN\nK91\t\t\t\n";
    assert!(fits(gaps.as_bytes(), &columns).says("warning[rows-left-out] count=2"));
    // a header that takes a row
    let (none, said) =
        radius(format!("take\n\n{plain}").as_bytes(), &[&columns[..4], &["--header", "3"], &columns[6..]].concat());
    assert!(none.is_none() && said.says("error[header-is-data] rows=3"), "{said}");
    // a unit of the file
    let units = plain.replacen('\n', "\n\tm\tm\tm\n", 1);
    let (none, said) = radius(units.as_bytes(), &[&columns[..4], &["--header", "2"], &columns[6..]].concat());
    assert!(none.is_none() && said.says("error[unit-differs] of_file=m"), "{said}");
    // polar coordinates in a format as a campaign states it, and by options
    let polar = sphere(|i, [x, y, z]| {
        let (flat, gon) = (x.hypot(y), 200.0 / std::f64::consts::PI);
        let azimuth = (gon * y.atan2(x)).rem_euclid(400.0);
        format!("{i};{azimuth:.7};{:.7};{:.7}", gon * flat.atan2(z), x.hypot(y).hypot(z) / 1000.0)
    });
    let polar = format!("Point;Hz;V;D\n{polar}");
    let keys = "{ delimiter = \";\", header = 1, angle_unit = \"gon\", columns = [\"label\", \"azimuth\", \"zenith\", \"distance\"] }";
    fits(polar.as_bytes(), &["--unit", "m", "--format", keys]);
    let options = ["--unit", "m", "--delimiter", ";", "--header", "1", "--columns", "label,azimuth,zenith,distance"];
    fits(polar.as_bytes(), &[&options[..], &["--angle-unit", "gon"]].concat());
    let (none, said) = radius(polar.as_bytes(), &options);
    assert!(none.is_none() && said.says("error[angle-unit-missing]") && said.contains("--angle-unit"), "{said}");
    let (none, said) = radius(polar.as_bytes(), &["--unit", "m", "--format", "{ delimiter = 3 }"]);
    assert!(none.is_none() && said.says("error[option-refused] option=--format"), "{said}");
}
