//! Parts of a proposed campaign that the user completes: a value `"?"`, a unit `UNIT`.

use etalon_base::error;
use etalon_base::message::{Message, Place, Problems};

/// Part of a line that is to be completed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OpenPart<'l> {
    /// Value `"?"` of this key.
    Value(&'l str),
    /// Unit of joints: `q1_UNIT = ..`.
    JointUnit,
    /// Unit of times: `time_UNIT`.
    TimeUnit,
    /// Unit of measured rotations: `rx_UNIT`.
    AngleUnit,
}

/// Names of a rotation in `columns` of an export or of a table, whose unit is open.
const ROTATION: [&str; 6] = ["rx_UNIT", "ry_UNIT", "rz_UNIT", " a_UNIT", " b_UNIT", " c_UNIT"];

impl OpenPart<'_> {
    /// Completes this part of a line with a value of TOML, or with a unit.
    pub fn answered(self, line: &str, answer: &str) -> String {
        match self {
            Self::Value(key) => line.replace(&format!("{key} = \"?\""), &format!("{key} = {answer}")),
            Self::JointUnit => {
                // the unit of the times is another question
                let kept = std::iter::once("time_UNIT").chain(ROTATION);
                let hidden =
                    kept.fold(line.to_owned(), |line, name| line.replace(name, &name.replace("UNIT", "\u{1}")));
                hidden.replace("_UNIT", &format!("_{answer}")).replace('\u{1}', "UNIT")
            }
            Self::TimeUnit => line.replace("time_UNIT", &format!("time_{answer}")),
            Self::AngleUnit => {
                ROTATION.iter().fold(line.to_owned(), |line, name| line.replace(name, &name.replace("UNIT", answer)))
            }
        }
    }
}

/// Parts of a line of campaign.toml or robot.toml that are to be completed, each once.
pub fn open_parts(line: &str) -> Vec<OpenPart<'_>> {
    let stated = line.split(" #").next().unwrap_or(line);
    if stated.trim_start().starts_with('#') {
        return Vec::new();
    }
    let mut parts: Vec<OpenPart> = Vec::new();
    let is_of_key = |c: char| c.is_alphanumeric() || matches!(c, '_' | '-' | '"');
    for (at, _) in stated.match_indices(" = \"?\"") {
        let before = &stated[..at];
        let part = OpenPart::Value(before.rsplit(|c: char| !is_of_key(c)).next().unwrap_or(before));
        if !parts.contains(&part) {
            parts.push(part);
        }
    }
    if stated.contains("time_UNIT") {
        parts.push(OpenPart::TimeUnit);
    }
    if ROTATION.iter().any(|name| stated.contains(name)) {
        parts.push(OpenPart::AngleUnit);
    }
    let others =
        std::iter::once("time_UNIT").chain(ROTATION).fold(stated.to_owned(), |rest, name| rest.replace(name, ""));
    if others.contains("_UNIT =") {
        parts.push(OpenPart::JointUnit);
    }
    parts
}

/// Errors of the open parts of a text.
pub(crate) fn open_questions(name: &str, text: &str) -> Problems {
    let message = |part: OpenPart, line: &str| match part {
        OpenPart::JointUnit => error!("joint-unit-open"),
        OpenPart::TimeUnit => error!("time-unit-open"),
        OpenPart::AngleUnit => error!("angle-unit-open"),
        OpenPart::Value(key) => {
            error!("key-open", key, remark = line.split_once(" #").map_or("none", |(_, remark)| remark.trim()))
        }
    };
    let questions = |(at, line): (usize, &str)| -> Vec<Message> {
        let place = || Place::line(name, at + 1, line);
        open_parts(line).into_iter().map(|part| message(part, line).at(place())).collect()
    };
    Problems(text.lines().enumerate().flat_map(questions).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_open_part_of_a_line_is_found_once_and_completed() {
        use OpenPart::{AngleUnit, JointUnit, TimeUnit, Value};
        for (line, parts) in [
            ("unit = \"?\"    # mm, m", vec![Value("unit")]),
            ("# unit = \"?\"", vec![]),
            ("a = 1 # b = \"?\"", vec![]),
            (
                "format = { rotation = \"?\", columns = [\"x\", \"rx_UNIT\", \"time_UNIT\"] }",
                vec![Value("rotation"), TimeUnit, AngleUnit],
            ),
            (
                "columns = { time_UNIT = \"t\", q1_UNIT = 1, q2_UNIT = { number = 2, per_count = \"?\" } }",
                vec![Value("per_count"), TimeUnit, JointUnit],
            ),
            ("columns = { q1_UNIT = 1, x_mm = 2, a_UNIT = 3, b_UNIT = 4, c_UNIT = 5 }", vec![AngleUnit, JointUnit]),
        ] {
            assert_eq!(open_parts(line), parts, "{line}");
        }
        let line = "columns = { q1_UNIT = 1, a_UNIT = 3 }";
        assert_eq!(JointUnit.answered(line, "rad"), "columns = { q1_rad = 1, a_UNIT = 3 }");
        let line = "format = { rotation = \"?\", columns = [\"rx_UNIT\", \"ry_UNIT\", \"rz_UNIT\"] }";
        let line = Value("rotation").answered(&AngleUnit.answered(line, "deg"), "\"zyx\"");
        assert_eq!(line, "format = { rotation = \"zyx\", columns = [\"rx_deg\", \"ry_deg\", \"rz_deg\"] }");
        let line = TimeUnit.answered("columns = { time_UNIT = 1, q1_UNIT = 2 }", "ms");
        assert_eq!(JointUnit.answered(&line, "rad"), "columns = { time_ms = 1, q1_rad = 2 }");
    }
}
