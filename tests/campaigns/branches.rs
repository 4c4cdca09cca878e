//! Two measured hands of one torso, identified in one campaign. Synthetic: the sample two-hands.

use crate::support::said::has;
use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::base::phrase;
use etalon::documents::{ParameterStatus, ParametersDocument};
use etalon::simulate::Truth;

const TABLE: &str = "observations.csv";

/// Writes the table again with changed rows; `None` removes a row. Cells are in the order of the header.
fn rewrite(scratch: &Scratch, change: impl Fn(&[&str], Vec<String>) -> Option<Vec<String>>) {
    let path = scratch.path().join(TABLE);
    let text = std::fs::read_to_string(&path).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows = lines.filter_map(|line| change(&header, line.split(',').map(str::to_owned).collect()));
    let all: Vec<String> = std::iter::once(header.join(",")).chain(rows.map(|row| row.join(","))).collect();
    std::fs::write(path, all.join("\n") + "\n").unwrap();
}

fn column(header: &[&str], name: &str) -> usize {
    header.iter().position(|column| *column == name).unwrap()
}

/// A campaign of the left hand alone: its points, and the chain to it.
fn left_alone() -> Scratch {
    let scratch = copy_sample("two-hands");
    let robot = "model = \"urdf\"\nfile = \"two_hands.urdf\"\nbase_link = \"base\"\ntool_link = \"left_hand\"\n";
    std::fs::write(scratch.path().join("robot.toml"), robot).unwrap();
    scratch.replace("campaign.toml", "\"1-38, 51-73\"", "\"1-38\"");
    scratch.replace("campaign.toml", "[limits]\ndistance_max_mm = 0.1\n", "");
    rewrite(&scratch, |header, row| {
        let of_left = row[column(header, "target")].starts_with('L') && row[column(header, "kind")] == "point";
        of_left.then_some(row)
    });
    scratch
}

#[test]
fn two_hands_give_the_truth_and_determine_the_torso_better_than_one() {
    let both = copy_sample("two-hands");
    ends(&both, "run", 0, &[]);
    let both_parameters = both.parameters();
    let truth = Truth::read(&both.path().join("truth.toml")).unwrap();
    // deviations from the truth, in standard uncertainties
    let true_value = |name: &str, nominal: f64| truth.parameters.get(name).copied().unwrap_or(nominal);
    let deviations: Vec<f64> = (both_parameters.parameters.iter())
        .filter_map(|p| Some((p.value - true_value(&p.name, p.nominal)) / p.standard_uncertainty?))
        .collect();
    let (count, worst) = (deviations.len() as f64, deviations.iter().fold(0.0f64, |m, d| m.max(d.abs())));
    let rms = (deviations.iter().map(|d| d * d).sum::<f64>() / count).sqrt();
    let residuals = &both_parameters.residuals;
    let (chi_square, degrees) = (residuals.test.chi_square.unwrap(), residuals.degrees_of_freedom as f64);
    println!(
        "two hands: {count} deviations, rms {rms:.2} u, largest {worst:.2} u, chi-square {chi_square:.1} of {degrees}"
    );
    assert!(count > 80.0 && worst < 4.0 && (rms - 1.0).abs() < 0.3, "{count} {worst} {rms}");
    assert!((chi_square - degrees).abs() < 3.0 * (2.0 * degrees).sqrt(), "{chi_square} of {degrees}");
    let bar = both_parameters.parameters.iter().find(|p| p.name == "bar_L1_R1").unwrap();
    let u = bar.standard_uncertainty.unwrap();
    assert!((bar.value - 650.0).abs() < 3.0 * u && u < 0.0051, "{} ± {u}", bar.value);

    let left = left_alone();
    ends(&left, "run", 0, &[]);
    let left_parameters = left.parameters();
    let u = |all: &ParametersDocument, name: &str| {
        let p = all.parameters.iter().find(|p| p.name == name).unwrap();
        assert_eq!(p.status, ParameterStatus::Identified, "{name}");
        p.standard_uncertainty.unwrap()
    };
    for name in ["gain_torso_yaw", "gain_torso_pitch", "torso_pitch_x", "torso_pitch_rx", "base_rz"] {
        let (one, two) = (u(&left_parameters, name), u(&both_parameters, name));
        println!("{name}: {one:.2e} with one hand, {two:.2e} with two");
        assert!(two < 0.85 * one, "{name}: {one} {two}");
    }
    // an export of the calibrated tree has both arms
    let urdf = std::fs::read_to_string(both.path().join("out/calibrated.urdf")).unwrap();
    let nominal = std::fs::read_to_string(both.path().join("two_hands.urdf")).unwrap();
    let origin = |text: &str, joint: &str| {
        let at = text.find(&format!("<joint name=\"{joint}\"")).unwrap();
        let from = at + text[at..].find("<origin").unwrap();
        text[from..from + text[from..].find('>').unwrap()].to_owned()
    };
    for joint in ["torso_pitch", "left_3", "right_3"] {
        assert_ne!(origin(&urdf, joint), origin(&nominal, joint), "{joint}");
    }
}

/// A torso of one joint with two arms of three axes, which a tracker observes.
fn small() -> Scratch {
    let scratch = copy_sample("two-hands");
    let joint = |name: &str, ends: [&str; 2], xyz: String, axis: &str| {
        let [parent, child] = ends;
        format!(
            "<link name=\"{child}\"/>\n<joint name=\"{name}\" type=\"revolute\"><parent link=\"{parent}\"/><child link=\"{child}\"/>\
             <origin xyz=\"{xyz}\"/><axis xyz=\"{axis}\"/><limit lower=\"-2.4\" upper=\"2.4\" effort=\"1\" velocity=\"1\"/></joint>\n"
        )
    };
    let mut urdf = "<robot name=\"small\">\n<link name=\"base\"/>\n".to_owned();
    urdf += &joint("yaw", ["base", "chest"], "0 0 0.8".to_owned(), "0 0 1");
    for (side, s) in [("left", 1.0), ("right", -1.0)] {
        let [one, two, hand] = ["1", "2", "hand"].map(|name| format!("{side}_{name}"));
        urdf += &joint(&format!("{side}_q1"), ["chest", &one], format!("0.05 {} 0.35", 0.2 * s), "0 1 0");
        urdf += &joint(&format!("{side}_q2"), [&one, &two], format!("0 {} 0", 0.1 * s), "1 0 0");
        urdf += &joint(&format!("{side}_q3"), [&two, &hand], format!("0.03 {} 0", 0.3 * s), "0 0 1");
    }
    std::fs::write(scratch.path().join("two_hands.urdf"), urdf + "</robot>\n").unwrap();
    let observed: String =
        ["L1", "L2", "R1", "R2"].map(|t| format!("[[observe]]\nkind = \"point\"\ntarget = \"{t}\"\n")).concat();
    let seven = |v: &str| [v; 7].join(", ");
    let truth = format!(
        "seed = 4\ncycles = 1\ndecimals = 5\n[parameters]\nbase_x = 1850.0\nbase_rz = 141.0\nL1_x = 45.0\nL1_z = 60.0\n\
         L2_x = -50.0\nR1_x = 40.0\nR1_y = -35.0\nR1_z = 95.0\nR2_x = -75.0\nleft_q2_z = 0.2\n{observed}\
         [[poses]]\ndrawn = {{ count = 20, from = [{}], to = [{}] }}\n",
        seven("-110"),
        seven("110")
    );
    std::fs::write(scratch.path().join("truth.toml"), truth).unwrap();
    scratch.replace("campaign.toml", "\"1-38, 51-73\"\nvalidation = \"rest\"", "\"all\"");
    scratch.replace("campaign.toml", "[limits]\ndistance_max_mm = 0.1\n", "");
    scratch.replace("campaign.toml", ", \"urdf\"]", "]");
    ends(&scratch, "simulate", 0, &[]);
    scratch
}

#[test]
fn slips_between_hands_are_named() {
    ends(&small(), "run", 0, &[]);
    // the targets of left and right exchanged
    let exchanged = small();
    rewrite(&exchanged, |header, mut row| {
        let at = column(header, "target");
        row[at] = row[at].replace('L', "_").replace('R', "L").replace('_', "R");
        Some(row)
    });
    let said = ends(&exchanged, "run", 2, &["[placement-unexplained]"]);
    let exchanged = phrase!("slip-branches-exchanged", first = "`left_hand`", second = "`right_hand`");
    assert!(has(&said, &exchanged), "{said}");
    // the sign of a joint that both arms share
    let reversed = small();
    rewrite(&reversed, |header, mut row| {
        let at = column(header, "yaw_deg");
        row[at] = format!("{}", -row[at].parse::<f64>().unwrap());
        Some(row)
    });
    let said = ends(&reversed, "run", 2, &["[placement-unexplained]"]);
    assert!(said.contains("`yaw` reversed"), "{said}");
}
