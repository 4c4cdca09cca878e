//! A hint is a line that can be pasted and works: the lines of hints are taken from what the program says, put where the
//! message points, and the error is gone.

use super::etalon;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};

/// Fragments between backticks of the hint of this error that are lines of TOML.
fn lines(said: &str, id: &str) -> Vec<toml::Table> {
    let at = said.find(&format!("error[{id}]")).unwrap_or_else(|| panic!("no {id}: {said}"));
    let hint = said[at..].split_once("hint: ").unwrap_or_else(|| panic!("no hint of {id}: {said}")).1;
    let hint = hint.split("\n\n").next().unwrap_or_default().split("error[").next().unwrap_or_default();
    let one_line = hint.lines().map(str::trim).collect::<Vec<_>>().join(" ");
    one_line
        .split('`')
        .skip(1)
        .step_by(2)
        .filter(|text| text.contains(" = "))
        .filter_map(|text| toml::from_str(text).ok())
        .collect()
}

/// Table of the campaign at a path of keys; numbers are places in lists.
fn table<'a>(campaign: &'a mut toml::Table, path: &[&str]) -> &'a mut toml::Table {
    let Some((first, rest)) = path.split_first() else { return campaign };
    let (key, number) = first.split_once('.').map_or((*first, None), |(key, n)| (key, n.parse::<usize>().ok()));
    let value = campaign.entry(key).or_insert_with(|| toml::Value::Table(toml::Table::new()));
    let value = match number {
        Some(n) => &mut value.as_array_mut().unwrap()[n],
        None => value,
    };
    table(value.as_table_mut().unwrap(), rest)
}

/// Pastes the first `count` lines of the hint at `path`: the error must be gone.
fn works(scratch: &Scratch, id: &str, path: &[&str], count: usize) {
    let (code, said) = etalon(scratch, "check");
    assert_eq!(code, Some(2), "{said}");
    let pasted = lines(&said, id);
    assert!(pasted.len() >= count && count > 0, "{id} has {} lines: {said}", pasted.len());
    let file = scratch.path().join("campaign.toml");
    let mut campaign: toml::Table = toml::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    for line in pasted.into_iter().take(count) {
        table(&mut campaign, path).extend(line);
    }
    std::fs::write(&file, toml::to_string(&campaign).unwrap()).unwrap();
    let (code, after) = etalon(scratch, "check");
    assert!(!after.contains(&format!("[{id}]")), "{id} remains after its hint: {after}");
    assert_eq!(code, Some(0), "another error instead of {id}: {after}");
}

fn rewrite(scratch: &Scratch, file: &str, change: impl Fn(&str) -> String) {
    let path = scratch.path().join(file);
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(path, change(&text)).unwrap();
}

#[test]
fn hints_of_delimiter_and_decimal_mark() {
    for (delimiter, decimal) in [(";", "."), (";", ","), ("\t", ".")] {
        let scratch = copy_sample("prexyt-cmm");
        rewrite(&scratch, "encoders.csv", |text| text.replace('.', "#").replace(',', delimiter).replace('#', decimal));
        works(&scratch, "delimiter-does-not-split", &["log"], 2);
    }
}

#[test]
fn hints_of_encoding() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "file = \"encoders.csv\"", "file = \"encoders.csv\"\ncomment = \"#\"");
    let path = scratch.path().join("encoders.csv");
    let mut bytes = b"# \xb1 0.5 \xb5m\n".to_vec();
    bytes.extend(std::fs::read(&path).unwrap());
    std::fs::write(path, bytes).unwrap();
    works(&scratch, "encoding-invalid", &["log"], 1);
}

#[test]
fn hints_of_poses_and_headers() {
    // rows that name a target and no pose
    let scratch = Scratch::with(&[
        ("robot.toml", include_str!("../../samples/prexyt-cmm/robot.toml")),
        ("k.csv", &points(1.0)),
        ("l.csv", &points(2.0)),
        ("log.csv", &format!("pose,a,b,c\n{}", (1..=9).map(|i| format!("{i},{i},{i}0.5,{i}1\n")).collect::<String>())),
        ("campaign.toml", CAMPAIGN),
    ]);
    let (_, said) = etalon(&scratch, "check");
    let pasted = lines(&said, "target-without-pose");
    assert_eq!(pasted.first().and_then(|line| line["pose"].as_str()), Some("row"), "{said}");
    rewrite(&scratch, "campaign.toml", |text| text.replace("target = ", "pose = \"row\"\ntarget = "));
    let (_, after) = etalon(&scratch, "check");
    assert!(!after.contains("target-without-pose"), "{after}");
    // headings where no header is stated
    rewrite(&scratch, "campaign.toml", |text| text.replace("header = 1, ", ""));
    let (_, said) = etalon(&scratch, "check");
    assert_eq!(lines(&said, "header-not-stated")[0]["header"].as_integer(), Some(1), "{said}");
    rewrite(&scratch, "campaign.toml", |text| text.replace("columns = { x", "header = 1, columns = { x"));
    let (_, after) = etalon(&scratch, "check");
    assert!(!after.contains("header-not-stated"), "{after}");
}

#[test]
fn hints_of_clocks() {
    let scratch = copy_sample("prexyt-cmm");
    rewrite(&scratch, "campaign.toml", |text| text.replace("by = [\"pose\", \"cycle\"]", "by = \"time\""));
    let (_, said) = etalon(&scratch, "check");
    let pasted = lines(&said, "join-clock-missing");
    let line = |key: &str| format!("{key} = {}", pasted.iter().find_map(|line| line.get(key)).unwrap());
    // the joints of this machine are prismatic
    assert!(line("standstill").contains("within_mm"), "{said}");
    let stated = format!("by = \"time\"\n{}\n{}", line("clock_offset_s"), line("tolerance_s"));
    rewrite(&scratch, "campaign.toml", |text| text.replacen("by = \"time\"", &stated, 1));
    let (_, after) = etalon(&scratch, "check");
    assert!(!after.contains("join-clock-missing"), "{after}");
}

fn points(shift: f64) -> String {
    let row = |i: usize| format!("{:.4},{:.4},1.0\n", 10.0 * i as f64 + shift, 3.5 * (i * i) as f64);
    "X,Y,Z\n".to_owned() + &(1..=9).map(row).collect::<String>()
}

const CAMPAIGN: &str = r#"
name = "c"
robot = "robot.toml"
[instrument]
name = "i"
expanded_uncertainty_um = 2.7
coverage_factor = 2
[[export]]
file = "k.csv"
unit = "mm"
format = { delimiter = ",", header = 1, columns = { x = "X", y = "Y", z = "Z" } }
target = "K"
[[export]]
file = "l.csv"
unit = "mm"
format = { delimiter = ",", header = 1, columns = { x = "X", y = "Y", z = "Z" } }
target = "L"
[log]
file = "log.csv"
columns = { pose = "pose", rho1_mm = "a", rho2_mm = "b", rho3_mm = "c" }
[join]
by = ["pose"]
[frame.world]
as_exported = true
[identify]
calibration = "all"
"#;

/// Pastes the first line of the hint at `path`: this error is gone, whatever else is said.
fn goes(scratch: &Scratch, id: &str, path: &[&str]) {
    let (_, said) = etalon(scratch, "check");
    let pasted = lines(&said, id).into_iter().next().unwrap_or_else(|| panic!("no line for {id}: {said}"));
    let file = scratch.path().join("campaign.toml");
    let mut campaign: toml::Table = toml::from_str(&std::fs::read_to_string(&file).unwrap()).unwrap();
    table(&mut campaign, path).extend(pasted);
    std::fs::write(&file, toml::to_string(&campaign).unwrap()).unwrap();
    let (_, after) = etalon(scratch, "check");
    assert!(!after.contains(&format!("[{id}]")), "{id} remains after its hint: {after}");
}

#[test]
fn hints_of_units_labels_and_targets() {
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace(
        "campaign.toml",
        "file = \"exports/poses.txt\"\nformat = \"polyworks\"\nunit = \"mm\"",
        "file = \"exports/poses.txt\"\nformat = \"polyworks\"",
    );
    works(&scratch, "key-missing", &["export.1"], 1);
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "label = \"{target}_{pose}_{cycle}\"\n", "");
    works(&scratch, "label-form-missing", &["export.1"], 1);
    let scratch = copy_sample("column-arm");
    scratch.replace("campaign.toml", "targets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]\n", "");
    works(&scratch, "no-target", &["join"], 1);
}

#[test]
fn hints_of_columns_and_headers() {
    for (heading, other) in [("q1_deg", "J1"), ("target", "Ziel"), ("pose", "Nr")] {
        let scratch = copy_sample("probe-poses");
        rewrite(&scratch, "observations.csv", |text| text.replacen(heading, other, 1));
        works(&scratch, "column-unknown", &["observations"], 1);
    }
    // no header: every row would be read one too late
    for (sample, file, path) in
        [("probe-poses", "observations.csv", "observations"), ("prexyt-cmm", "encoders.csv", "log")]
    {
        let scratch = copy_sample(sample);
        rewrite(&scratch, file, |text| text.split_once('\n').unwrap().1.to_owned());
        let (_, said) = etalon(&scratch, "check");
        assert_eq!(said.matches("error[").count(), 1, "one cause, one error: {said}");
        goes(&scratch, "header-holds-numbers", &[path]);
    }
}

#[test]
fn hints_of_sheets_and_marks_of_tables() {
    let scratch = copy_sample("probe-poses");
    std::fs::copy("tests/workbooks/synthetic-openpyxl.xlsx", scratch.path().join("book.xlsx")).unwrap();
    scratch.replace("campaign.toml", "file = \"observations.csv\"", "file = \"book.xlsx\"");
    goes(&scratch, "sheet-not-stated", &["observations"]);
    for mark in [";", "\t"] {
        let scratch = copy_sample("probe-poses");
        rewrite(&scratch, "observations.csv", |text| text.replace(',', mark));
        let (_, said) = etalon(&scratch, "check");
        assert_eq!(said.matches("error[").count(), 1, "one cause, one error: {said}");
        works(&scratch, "delimiter-does-not-split", &["observations"], 2);
    }
    // a decimal comma is stated, and the default delimiter is a comma too
    let scratch = copy_sample("probe-poses");
    rewrite(&scratch, "observations.csv", |text| text.replace(',', ";").replace('.', ","));
    scratch.replace("campaign.toml", "file = \"observations.csv\"", "file = \"observations.csv\"\ndecimal = \",\"");
    works(&scratch, "comma-ambiguous", &["observations"], 2);
}

#[test]
fn hints_of_orientations_and_uncertainties() {
    use etalon::base::pose::Pose;
    // the angles of the sample in the order of fixed axes x, y, z, which is not stated
    let scratch = copy_sample("probe-poses");
    let order: etalon::base::angle_order::AngleOrder = "fixed xyz".parse().unwrap();
    rewrite(&scratch, "observations.csv", |text| {
        let mut lines = text.lines();
        let head = lines.next().unwrap().replace("qw,qx,qy,qz", "a_deg,b_deg,c_deg");
        let row = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            let (rest, q) = cells.split_at(cells.len() - 4);
            let q: Vec<f64> = q.iter().map(|v| v.parse().unwrap()).collect();
            let angles = order.angles(&Pose::from_quaternion([q[0], q[1], q[2], q[3]])).map(f64::to_degrees);
            format!("{},{},{},{}\n", rest.join(","), angles[0], angles[1], angles[2])
        };
        format!("{head}\n") + &lines.map(row).collect::<String>()
    });
    works(&scratch, "angle-order-missing", &["observations"], 1);
}

#[test]
fn one_cause_is_one_error() {
    let count = |scratch: &Scratch| etalon(scratch, "check").1.matches("error[").count();
    // a wrong target, a wrong form of labels, a joint in an unknown unit
    for (from, to) in [
        ("by = [\"pose\", \"cycle\"]", "by = [\"pose\", \"cycle\"]\ntargets = [\"K\", \"M\"]"),
        ("{target}_{pose}_{cycle}", "{target}-{pose}-{cycle}"),
        ("rho1_mm = ", "rho1_cm = "),
    ] {
        let scratch = copy_sample("prexyt-cmm");
        scratch.replace("campaign.toml", from, to);
        assert_eq!(count(&scratch), 1, "{to}: {}", etalon(&scratch, "check").1);
    }
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "{target}_{pose}_{cycle}", "{target}-{pose}-{cycle}");
    scratch.replace(
        "campaign.toml",
        "by = [\"pose\", \"cycle\"]",
        "by = [\"pose\", \"cycle\"]\ntargets = [\"K\", \"L\"]",
    );
    assert_eq!(count(&scratch), 1, "{}", etalon(&scratch, "check").1);
    // one wrong column: its rows are one error, with the first three of them
    for (sample, file, column) in
        [("prexyt-cmm", "encoders.csv", 2), ("probe-poses", "observations.csv", 3), ("pose-test", "poses.csv", 3)]
    {
        let scratch = copy_sample(sample);
        rewrite(&scratch, file, |text| {
            let (head, rows) = text.split_once('\n').unwrap();
            let row = |line: &str| {
                let mut cells: Vec<&str> = line.split(',').collect();
                cells[column] = "n.v.";
                cells[column + 1] = "n.v.";
                cells.join(",") + "\n"
            };
            format!("{head}\n") + &rows.lines().map(row).collect::<String>()
        });
        let (_, said) = etalon(&scratch, "check");
        assert_eq!(said.matches("error[").count(), 1, "{sample}: {said}");
        assert!(said.has_phrase("also-in-lines second=3 third=4"), "{sample}: {said}");
    }
}
