//! Controller files read back: values of parameters in lists, and the robot that a file describes.

use crate::run::selftest::data::{Data, Slip};
use crate::run::selftest::row::{Rows, Subject, not_made};
use crate::run::selftest::sample::{Scratch, document, inward, positions, robot};
use etalon_base::message::Result;
use etalon_base::pose::{Vector, minus, norm};
use etalon_base::{error, phrase};
use etalon_campaign::read_robot;
use etalon_controllers::{Description, ExportInput, by_name};
use etalon_robots::{Parameter, Robot};

pub(crate) const SUBJECT: Subject = Subject {
    id: "exports",
    requirement: || phrase!("selftest-exports"),
    rows,
    slips: &[
        Slip::Digit("/kinematics/3/targets_mm/0/0", 8),
        Slip::Swap("/kinematics/6/joints/0/0", "/kinematics/6/joints/0/1"),
        Slip::Unit("/kinematics/3/targets_mm", 1.0 / 25.4),
    ],
};

/// Formats that list parameters.
const LISTS: [&str; 8] = ["json", "csv", "c-header", "matlab", "python", "twincat", "plcopen", "siemens-scl"];

fn rows(data: &Data) -> Vec<Rows> {
    let (mut lists, mut robots) = (Rows::new("parameters.json"), Rows::new("tests/selftest/make.py"));
    let model = |name: &str| {
        let all = data.at("/kinematics").items();
        all.into_iter().find(|item| item.text("/model") == name).unwrap_or_else(|| data.at("/missing"))
    };
    let found = listed(&model("prexyt"), &mut lists);
    keep("prexyt", found, &mut lists);
    for (name, read) in [("urdf", urdf as Read), ("hexapod", hexapod as Read), ("five_bar", five_bar as Read)] {
        keep(name, read(&model(name), &mut robots), &mut robots);
    }
    vec![lists, robots]
}

/// Reads the file of a robot back.
type Read = fn(&Data, &mut Rows) -> Result<()>;

fn keep(name: &str, result: Result<()>, rows: &mut Rows) {
    if let Err(problems) = result {
        rows.failed(not_made(name, &problems));
    }
}

/// Text of a controller file.
fn text(format: &str, robot: &dyn Robot, values: &[f64]) -> Result<String> {
    described(format, robot, values, None)
}

/// Text of a controller file of a robot that another file describes.
fn described(format: &str, robot: &dyn Robot, values: &[f64], description: Option<Description>) -> Result<String> {
    let document = document(robot, values)?;
    let given = ExportInput { robot: Some(robot), description, ..ExportInput::parameters(&document) };
    Ok(String::from_utf8_lossy(&by_name(format)?.write(&given)?).into_owned())
}

/// Every value of a parameter, bit for bit, with the parameter's name.
fn listed(item: &Data, rows: &mut Rows) -> Result<()> {
    let robot = robot(item.text("/robot"), "", &["K", "L"])?;
    let robot = robot.as_ref();
    // digits to the last bit, unlike the digits of the nominal values
    let values: Vec<f64> = robot.nominal().iter().map(|v| v * (1.0 + 1e-7 / 3.0)).collect();
    for format in LISTS {
        let text = text(format, robot, &values)?;
        let parameters = robot.parameters();
        let is_written = |(p, value): &(&Parameter, &f64)| {
            let value = p.quantity.outward(**value);
            let in_entry = |entry: &str| names(entry, &p.name) && numbers(entry).any(|v| v == value);
            match format {
                "json" => json_value(&text, &p.name) == Some(value),
                "plcopen" => text.split("<variable ").skip(1).any(in_entry),
                _ => text.lines().any(in_entry),
            }
        };
        let written = parameters.iter().zip(&values).filter(is_written).count();
        rows.add(phrase!("selftest-listed", format), "", [parameters.len() as f64, written as f64], 0.0);
    }
    Ok(())
}

/// `true` if an entry names a parameter: the name is a word, perhaps behind a prefix and in front
/// of a unit.
fn names(entry: &str, name: &str) -> bool {
    let is_name = |c: char| c.is_alphanumeric() || c == '_';
    let units = ["_mm", "_deg", "_ratio"];
    entry.split(|c| !is_name(c)).any(|word| {
        let word = word.to_lowercase();
        let bare = word.strip_prefix("etalon_prexyt_").or(word.strip_prefix("c_")).unwrap_or(&word);
        [&word, bare].iter().any(|word| *word == name || units.iter().any(|unit| word.strip_suffix(unit) == Some(name)))
    })
}

/// Numbers in a line.
fn numbers(line: &str) -> impl Iterator<Item = f64> + '_ {
    line.split(|c: char| !(c.is_ascii_digit() || matches!(c, '.' | '-' | '+' | 'e' | 'E')))
        .filter_map(|word| word.parse().ok())
}

/// Value of a parameter in controller.json.
fn json_value(text: &str, name: &str) -> Option<f64> {
    let document: serde_json::Value = serde_json::from_str(text).ok()?;
    document["parameters"][name]["value"].as_f64()
}

/// A URDF, whose robot is built again.
fn urdf(item: &Data, rows: &mut Rows) -> Result<()> {
    let own = robot(item.text("/robot"), item.text("/urdf"), &["ball"])?;
    let description = Description { file: "arm.urdf", text: item.text("/urdf") };
    let text = described("urdf", own.as_ref(), &own.nominal(), Some(description))?;
    let links: Vec<&str> = text.split("<link name=\"").skip(1).filter_map(|rest| rest.split('"').next()).collect();
    let [base, .., tool] = links[..] else {
        return Err(error!("selftest-data-unreadable", name = "urdf", reason = "").into());
    };
    let stated = format!("model = \"urdf\"\nfile = \"arm.urdf\"\nbase_link = \"{base}\"\ntool_link = \"{tool}\"\n");
    let scratch = Scratch::with(&[("robot.toml", &stated), ("arm.urdf", &text)])?;
    let read = read_robot(&scratch.path().join("robot.toml"))?.build(&["ball".to_owned()])?;
    // base and target are not in a URDF
    let mut values = read.nominal();
    for (value, p) in values.iter_mut().zip(read.parameters()) {
        if let Some(index) = own.index(&p.name).filter(|_| p.name.starts_with("base_") || p.name.starts_with("ball_")) {
            *value = own.parameters()[index].nominal;
        }
    }
    let joints = item.at("/joints").items();
    let found: Vec<f64> =
        joints.iter().flat_map(|q| positions(read.as_ref(), &values, &inward(read.as_ref(), &q.numbers("")))).collect();
    // angles of the file are rounded in the last digit
    rows.add_all(phrase!("selftest-file-robot", format = "urdf"), "mm", [&item.numbers("/targets_mm"), &found], 1e-6);
    Ok(())
}

/// Legs of a hexapod in LinuxCNC: the lengths at the pose of the joint values.
fn hexapod(item: &Data, rows: &mut Rows) -> Result<()> {
    let own = robot(item.text("/robot"), "", &["ball"])?;
    let nominal = own.nominal();
    let text = text("linuxcnc-hexapod", own.as_ref(), &nominal)?;
    let place = |end: &str, leg: usize| -> Vector {
        ["x", "y", "z"].map(|axis| after(&text, &format!("setp genhexkins.{end}.{leg}.{axis} ")))
    };
    // the pose of the independent program: its target, without the base of the robot
    let base = etalon_robots::base_pose(&nominal);
    let target = own.free_base().map_or(6, |free| free.target_place(0));
    let (mut expected, mut found) = (Vec::new(), Vec::new());
    for (q, at) in item.at("/joints").items().iter().zip(item.points("/targets_mm")) {
        let q = q.numbers("");
        let pose = own.kinematics().and_then(|arm| arm.tool_pose(&nominal, &q));
        let Some(pose) = pose else { continue };
        let in_world = base.then(&pose).apply([nominal[target], nominal[target + 1], nominal[target + 2]]);
        expected.push(0.0);
        found.push(norm(minus(in_world, at)));
        for leg in 0..6 {
            let length = norm(minus(pose.apply(place("platform", leg)), place("base", leg)));
            let line = text.lines().find(|line| line.starts_with(&format!("# joint {leg}:"))).unwrap_or_default();
            let offset = after(line, "value + ");
            expected.push(q.get(leg).copied().unwrap_or(f64::NAN));
            found.push(length - offset);
        }
    }
    rows.add_all(phrase!("selftest-file-robot", format = "linuxcnc-hexapod"), "mm", [&expected, &found], 1e-8);
    Ok(())
}

/// Links and motors of a five-bar in RepRapFirmware, whose coordinates have five decimals.
fn five_bar(item: &Data, rows: &mut Rows) -> Result<()> {
    let own = robot(item.text("/robot"), "", &["ball"])?;
    let mut nominal = own.nominal();
    // the tool is on the line of its link, beyond the joint, as the format requires
    let value = |name: &str| own.index(name).map_or(f64::NAN, |i| own.parameters()[i].nominal);
    for (i, p) in own.parameters().iter().enumerate() {
        if p.name == "gamma" {
            nominal[i] = 0.0;
        }
    }
    let text = text("reprap-five-bar", own.as_ref(), &nominal)?;
    let line = text.lines().find(|line| line.starts_with("M669 ")).unwrap_or_default();
    let letter = |letter: char| -> Vec<f64> {
        let word = line.split(' ').find_map(|word| word.strip_prefix(letter)).unwrap_or_default();
        word.split(':').filter_map(|number| number.parse().ok()).collect()
    };
    let (proximal, distal) = (letter('P'), letter('D'));
    let [across, along] = ['X', 'Y'].map(|axis| letter(axis).into_iter().reduce(|a, b| a - b).unwrap_or(f64::NAN));
    let apart = across.hypot(along);
    let first = |all: &[f64], i: usize| all.get(i).copied().unwrap_or(f64::NAN);
    let mut links = [first(&proximal, 0), first(&proximal, 1), first(&distal, 0), first(&distal, 1)];
    let mut expected = ["l11", "l21", "l12", "l22"].map(value);
    // either arm may be the left one
    links.sort_by(f64::total_cmp);
    expected.sort_by(f64::total_cmp);
    let (expected, found) = ([&expected[..], &[value("d")]].concat(), [&links[..], &[apart]].concat());
    rows.add_all(phrase!("selftest-file-robot", format = "reprap-five-bar"), "mm", [&expected, &found], 1.1e-5);
    Ok(())
}

/// Number behind a key.
fn after(text: &str, key: &str) -> f64 {
    let rest = text.find(key).map_or("", |at| &text[at + key.len()..]);
    rest.split([' ', '\n', ':']).next().and_then(|word| word.parse().ok()).unwrap_or(f64::NAN)
}
