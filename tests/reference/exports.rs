//! Exports and logs of other people: every file is read with the counts and the unit that its README states, or refused
//! with the reason it gives.

use super::exports_table::{As, TABLE};
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::base::message::Result;
use etalon::campaign::Campaign;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::{self, Point};
use etalon::stages::gather::gather;
use etalon::tables::Encoding;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

#[derive(serde::Deserialize)]
struct Stated {
    format: Format,
    unit: Unit,
    encoding: Option<Encoding>,
}

/// Reads a file as `format = ..` and `unit = ..` say; `encoding` may follow.
fn read(path: &Path, format: &str, unit: &str) -> Result<Vec<Point>> {
    let stated: Stated = toml::from_str(&format!("format = {format}\nunit = {unit:?}\n")).expect(format);
    formats::read_file(path, stated.encoding, &stated.format, stated.unit)
}

fn points(folder: &Path, file: &str, format: &str) -> Vec<Point> {
    let path = folder.join(file);
    read(&path, format, "mm").unwrap_or_else(|e| panic!("{file}: {e}"))
}

fn reference(folder: &str) -> Option<PathBuf> {
    crate::reference_data(folder)
}

/// Whether a path has the form of a pattern, in which one `*` stands for anything.
fn fits(pattern: &str, path: &str) -> bool {
    match pattern.split_once('*') {
        Some((start, end)) => path.len() >= start.len() + end.len() && path.starts_with(start) && path.ends_with(end),
        None => pattern == path,
    }
}

/// Every file below a folder, as a path from it.
fn files(root: &Path, below: &str) -> Vec<String> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(root.join(below)).unwrap().flatten() {
        let path = format!("{below}/{}", entry.file_name().to_string_lossy());
        match entry.path().is_dir() {
            true => all.extend(files(root, &path)),
            false => all.push(path),
        }
    }
    all.sort();
    all
}

#[test]
fn every_file_has_one_row_in_the_table() {
    let Some(exports) = reference("exports") else { return };
    let root = exports.parent().unwrap();
    let all: Vec<String> = files(root, "exports").into_iter().chain(files(root, "robots")).collect();
    let about = |path: &str| path.ends_with("README.md") || path.ends_with("LICENSE") || path.contains("UPSTREAM");
    for file in all.iter().filter(|file| !about(file)) {
        let rows = TABLE.iter().filter(|(pattern, ..)| fits(pattern, file)).count();
        assert_eq!(rows, 1, "{file} has {rows} rows in the table");
    }
    for (pattern, ..) in TABLE {
        assert!(all.iter().any(|file| fits(pattern, file)), "no file is `{pattern}`");
    }
}

#[test]
fn every_file_is_read_with_its_counts_or_refused_with_its_reason() {
    let Some(exports) = reference("exports") else { return };
    let root = exports.parent().unwrap();
    let all: Vec<String> = files(root, "exports").into_iter().chain(files(root, "robots")).collect();
    for (pattern, expected, why) in TABLE {
        for file in all.iter().filter(|file| fits(pattern, file)) {
            let path = root.join(file);
            match expected {
                As::Points(format, unit, count, refused) => {
                    let points = read(&path, format, unit).unwrap_or_else(|e| panic!("{file}: {e}"));
                    let out = points.iter().filter(|p| p.refused.is_some()).count();
                    assert_eq!((points.len(), out), (*count, *refused), "{file}: {why}");
                }
                As::Refused(format, unit, says) => {
                    let said = read(&path, format, unit).expect_err(file).to_string();
                    assert!(said.says(says), "{file}: {why}, and it says: {said}");
                }
                As::Nothing(says) => {
                    let said = formats::propose_file(&path).expect_err(file).to_string();
                    assert!(said.says(says), "{file}: {why}, and it says: {said}");
                }
                // `logs_are_read_with_their_rows` and the tests named there
                As::Log(..) | As::Elsewhere => {}
            }
        }
    }
}

#[test]
fn logs_are_read_with_their_rows() {
    let Some(exports) = reference("exports") else { return };
    let root = exports.parent().unwrap();
    let all: Vec<String> = files(root, "exports").into_iter().chain(files(root, "robots")).collect();
    for (pattern, expected, why) in TABLE {
        let As::Log(delimiter, first, unit, rows) = expected else { continue };
        for file in all.iter().filter(|file| fits(pattern, file)) {
            let scratch = copy_sample("abb-irb120");
            let columns: Vec<String> =
                (1..=6).map(|joint| format!("q{joint}_{unit} = {}", first + joint - 1)).collect();
            let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
            let head = &text[..text.find("# three 1.5 inch").unwrap()];
            let campaign = format!(
                "{head}[[export]]\nfile = \"e.txt\"\nformat = \"xyz\"\nunit = \"mm\"\ntarget = \"T\"\npose = \"row\"\n\
                 [log]\nfile = \"$ETALON_REFERENCE/{file}\"\ndelimiter = {delimiter:?}\nheader = false\npose = \"row\"\n\
                 columns = {{ {} }}\n[join]\nby = \"row\"\n[frame.world]\nas_exported = true\n\
                 [identify]\ncalibration = \"all\"\n",
                columns.join(", ")
            );
            std::fs::write(scratch.path().join("campaign.toml"), campaign).unwrap();
            std::fs::write(scratch.path().join("e.txt"), "1 2 3\n").unwrap();
            let campaign = Campaign::read(&scratch.path()).unwrap_or_else(|e| panic!("{file}: {e}"));
            let imported = gather(&campaign).unwrap_or_else(|e| panic!("{file}: {e}"));
            let table = imported.logs[0].table();
            assert_eq!((table.height(), table.names().count()), (*rows, 9), "{file}: {why}");
        }
    }
}

/// Distances between rows of two files, sorted.
fn distances(a: &[Point], b: &[Point]) -> Vec<f64> {
    assert_eq!(a.len(), b.len());
    let both = a.iter().zip(b).filter(|(a, b)| a.refused.is_none() && b.refused.is_none());
    let mut all: Vec<f64> =
        both.map(|(a, b)| etalon::base::pose::norm(etalon::base::pose::minus(a.xyz_mm, b.xyz_mm))).collect();
    all.sort_by(f64::total_cmp);
    all
}

#[test]
fn reflectors_of_the_irb120_are_150_345_150_176_and_150_559_mm_apart() {
    let Some(folder) = reference("exports/faro_tracker_abb_irb120") else { return };
    let [one, two, three] = [1, 2, 3].map(|n| points(&folder, &format!("processed_SMR_{n}.txt"), "\"xyz\""));
    let median = |d: Vec<f64>| d[d.len() / 2];
    let found = [distances(&one, &two), distances(&one, &three), distances(&two, &three)].map(median);
    let mut sorted = found;
    sorted.sort_by(f64::total_cmp);
    for (found, printed) in sorted.iter().zip([150.176, 150.345, 150.559]) {
        assert!((found - printed).abs() < 0.0006, "{sorted:?}");
    }
}

#[test]
fn sm6_holds_the_same_92_targets_in_two_spellings() {
    let Some(folder) = reference("exports/spatialanalyzer") else { return };
    let format = "\"spatialanalyzer\"";
    let native = points(&folder, "SM6_nominal.txt", format);
    let all = points(&folder, "SM6_SM6_SCOD.txt", format);
    let parts = |p: &Point| p.label.split("::").map(str::to_owned).collect::<Vec<_>>();
    let keys: BTreeSet<&str> = all.iter().map(|p| &*p.label).collect();
    let names: BTreeSet<String> = all.iter().map(|p| parts(p)[2].clone()).collect();
    let groups: BTreeSet<String> = all.iter().map(|p| parts(p)[1].clone()).collect();
    // README: 232 rows, 108 names, five groups; a target's name alone is no key
    assert_eq!((all.len(), keys.len(), names.len(), groups.len()), (232, 232, 108, 5));
    let again: BTreeMap<String, [f64; 3]> = all
        .iter()
        .filter(|p| parts(p)[1].starts_with("nominal [USMN"))
        .map(|p| (parts(p)[2].clone(), p.xyz_mm))
        .collect();
    assert_eq!((native.len(), again.len()), (92, 92));
    let off = |p: &Point| {
        let there = again[&parts(p)[2]];
        (0..3).map(|k| (p.xyz_mm[k] - there[k]).abs()).fold(0.0, f64::max)
    };
    assert!(native.iter().all(|p| off(p) < 0.00012), "{:?}", native.iter().map(off).fold(0.0, f64::max));
    assert_eq!(native.iter().filter(|p| off(p) > 1e-5).count(), 2);
}

#[test]
fn nineteen_thousand_points_in_17_groups() {
    let Some(folder) = reference("exports/spatialanalyzer") else { return };
    let all = points(&folder, "inspec_converted_for_SA_group_point_xyz.csv", "\"spatialanalyzer\"");
    let groups: BTreeSet<&str> = all.iter().filter_map(|p| p.label.split("::").next()).collect();
    assert_eq!((all.len(), groups.len()), (19_474, 17));
}

#[test]
fn plates_are_drilled_where_the_published_fit_says() {
    let Some(folder) = reference("exports/cmm_fixed_width_sdss") else { return };
    for (file, fit) in [("D8131_1", "fit_8131_1_2014-10-14.txt"), ("D8300_1", "fit_8300_1_2014-11-25.txt")] {
        let sorted = |mut all: Vec<[f64; 2]>| {
            all.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
            all
        };
        let read = sorted(points(&folder, file, "\"sdss-plate\"").iter().map(|p| [p.xyz_mm[0], p.xyz_mm[1]]).collect());
        // columns 3 and 4 of the fitting program's table are what was measured
        let text = std::fs::read_to_string(folder.join(fit)).unwrap();
        let row = |line: &str| {
            let numbers: Vec<f64> = line.split_whitespace().filter_map(|f| f.parse().ok()).collect();
            (numbers.len() == 12).then(|| [numbers[2], numbers[3]])
        };
        assert_eq!(read, sorted(text.lines().filter_map(row).collect()), "{file}");
    }
}

#[test]
fn a_plate_of_25_4_mm_is_read_in_mm_with_its_normals() {
    let Some(folder) = reference("exports/xyzijk_cmm_plain") else { return };
    let all = points(&folder, "fixture.xyz", "\"xyzijk\"");
    assert!(all.iter().all(|p| p.direction.as_ref().is_some_and(|d| d[2] > 0.999)));
    let mut x: Vec<f64> = all.iter().map(|p| p.xyz_mm[0]).collect();
    x.sort_by(f64::total_cmp);
    // eleven columns of eleven points
    let steps = x.chunks(11).collect::<Vec<_>>().windows(2).map(|w| w[1][5] - w[0][5]).collect::<Vec<f64>>();
    assert!(steps.len() == 10 && steps.iter().all(|s| (s - 25.4).abs() < 0.01), "{steps:?}");
}

#[test]
fn leica_rows_of_both_kinds_become_points() {
    let Some(folder) = reference("exports/leica_tracker_cesapi") else { return };
    let all = points(&folder, "measurements_2025-09-15.csv", "\"leica-emscon\"");
    // the first row is spherical: the distance is its third number, all others are Cartesian as they stand
    let distance = etalon::base::pose::norm(all[0].xyz_mm);
    assert!((distance - 9928.352440561106).abs() < 1e-8, "{distance}");
    let u = all[0].standard_uncertainty_mm.as_ref().unwrap();
    let total = etalon::base::pose::norm(*u);
    // stdTotal of the file is 0.0204
    assert!((total - 0.02043).abs() < 0.0003, "{u:?}");
    assert_eq!(&*all[1].label, "MDUp");
    assert_eq!(all[1].xyz_mm, [-3534.4447622318253, -1318.41549400247, -841.7887480723141]);
    // the same after Excel, which cut its digits
    let cut = points(&folder, "measurements_2025-09-15calc.csv", "\"leica-emscon\"");
    for (a, b) in all.iter().zip(&cut) {
        assert!(
            a.label == b.label && distances(std::slice::from_ref(a), std::slice::from_ref(b))[0] < 2e-5,
            "{}",
            a.label
        );
    }
    assert_eq!(cut.len(), 11);
}

#[test]
fn trap_8_columns_called_xyz_that_hold_angles_are_refused_until_someone_says_so() {
    let Some(folder) = reference("exports/leica_tracker_cesapi") else { return };
    let path = folder.join("measurements_2025-09-12.csv");
    let named = |x: &str, y: &str, z: &str, more: &str| {
        format!(
            "{{ delimiter = \",\", header = 1, columns = {{ label = \"point_name\", {x} = \"x\", {y} = \"y\", {z} = \"z\" }}{more} }}"
        )
    };
    let said = read(&path, &named("x", "y", "z", ""), "mm").unwrap_err().to_string();
    assert!(said.contains("[coordinates-look-spherical]") && said.contains("coordinates = \"cartesian\""), "{said}");
    assert!(read(&path, &named("x", "y", "z", ", coordinates = \"cartesian\""), "mm").is_ok());
    let said = read(&path, &named("azimuth", "zenith", "distance", ""), "mm").unwrap_err().to_string();
    assert!(said.contains("`angle_unit`"), "{said}");
    let all = read(&path, &named("azimuth", "zenith", "distance", ", angle_unit = \"rad\""), "mm").unwrap();
    // README: at 18:35:41 SlaveDown holds the coordinates of D, at 4361.276 and 4361.279 mm
    let (slave, d) = (&all[21], &all[23]);
    assert_eq!((&*slave.label, &*d.label), ("SlaveDown", "D"));
    let [a, b] = [slave, d].map(|p| etalon::base::pose::norm(p.xyz_mm));
    assert!((a - 4361.276).abs() < 0.001 && (b - 4361.279).abs() < 0.001, "{a} {b}");
    assert!(distances(std::slice::from_ref(slave), std::slice::from_ref(d))[0] < 0.1);
}
