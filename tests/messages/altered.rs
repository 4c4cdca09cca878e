//! Messages of samples whose rows are altered by a rule, and of files too large for a case.

use super::{RUN, hold, samples};

fn sample(file: &str) -> String {
    std::fs::read_to_string(samples().join(file)).unwrap()
}

fn kept(text: String) -> &'static str {
    Box::leak(text.into_boxed_str())
}

#[test]
fn of_readings_that_share_errors() {
    // the robot stops beside where its log says, by a part of the noise, in all readings of a pose
    let row = |line: &str| {
        let [label, x, y, z] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let pose: f64 = label.split('_').nth(1).unwrap().parse().unwrap();
        let by = [(1.7 * pose).sin(), (2.9 * pose + 1.0).sin()].map(|share| 4e-4 * share);
        let moved = [x, y].map(|v| v.parse::<f64>().unwrap());
        format!("{label} {:.5} {:.5} {z}\n", moved[0] + by[0], moved[1] + by[1])
    };
    let rows = kept(sample("prexyt-cmm/exports/poses.txt").lines().map(row).collect());
    let all = ("campaign.toml", "calibration = \"1-8\"\nvalidation = \"9-59\"", "calibration = \"all\"");
    hold(&[("pose-residuals-correlated", "prexyt-cmm", edits([all, ("exports/poses.txt", "", rows)]), RUN)]);
}

#[test]
fn of_many_wrong_readings() {
    // the first reading of each ball at each calibration pose is off by a millimetre, to and fro
    let row = |(i, line): (usize, &str)| {
        let [label, x, y, z] = line.split(' ').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let [_, pose, cycle] = label.split('_').collect::<Vec<_>>()[..] else { panic!("{line}") };
        let is_wrong = cycle == "1" && pose.parse::<u32>().unwrap() < 9;
        let by = if !is_wrong {
            0.0
        } else if i % 2 == 0 {
            1.0
        } else {
            -1.0
        };
        format!("{label} {:.5} {y} {z}\n", x.parse::<f64>().unwrap() + by)
    };
    let rows = kept(sample("prexyt-cmm/exports/poses.txt").lines().enumerate().map(row).collect());
    let exclude = ("campaign.toml", "residuals = \"targets\"", "residuals = \"targets\"\noutliers = \"exclude\"");
    hold(&[("outliers-too-many", "prexyt-cmm", edits([exclude, ("exports/poses.txt", "", rows)]), RUN)]);
}

fn edits<const N: usize>(all: [(&'static str, &'static str, &'static str); N]) -> super::Edits {
    Box::leak(Box::new(all))
}

#[test]
fn of_orientations_without_positions() {
    let table = sample("probe-poses/observations.csv");
    let heads: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let row = |line: &str| {
        let cells = line.split(',').zip(&heads);
        let cells: Vec<&str> =
            cells.map(|(cell, head)| if ["x_mm", "y_mm", "z_mm"].contains(head) { "" } else { cell }).collect();
        cells.join(",") + "\n"
    };
    let rows = kept(format!("{}\n", heads.join(",")) + &table.lines().skip(1).map(row).collect::<String>());
    hold(&[("nothing-to-judge", "probe-poses", edits([("observations.csv", "", rows)]), "recommend @")]);
}

#[test]
fn of_a_recording_with_a_jump() {
    let x = |i: u32| if i == 50 { 500.0 } else { 0.1 * f64::from(i) };
    let rows: String = (0..100).map(|i| format!("{:.2},{:.1},0,0\n", 0.01 * f64::from(i), x(i))).collect();
    let table = kept(format!("time_s,x_mm,y_mm,z_mm\n{rows}"));
    hold(&[("samples-too-fast count=1", "", edits([("t.csv", "", table)]), "iso9283 --stream @/t.csv")]);
}

#[test]
fn of_files_that_grow_when_read() {
    let faults = "<PlaneFeatureMeasurement id=\"1\"><PointList n=\"1\"><WholePointSetId>9</WholePointSetId></PointList></PlaneFeatureMeasurement>";
    let qif = super::data::QIF.replace("</MeasuredFeatures>", &(faults.repeat(60) + "</MeasuredFeatures>"));
    hold(&[("further-messages", "", edits([("b.qif", "", kept(qif))]), "fit plane @/b.qif")]);
}
