//! URDF from which the robot was read, with calibrated origins; everything else is preserved,
//! including comments.

use super::{About, ExportInput, Exporter, is_geometry};
use etalon_base::message::Result;
use etalon_base::pose::Pose;
use etalon_base::{error, phrase};
use etalon_robots::Effect;
use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};
use std::fmt::Write;
use std::ops::Range;

/// URDF.
pub(super) struct Urdf;

/// Replacement of a range of the file.
struct Edit {
    range: Range<usize>,
    text: String,
}

/// A joint during reading.
#[derive(Default)]
struct Joint {
    name: String,
    moves: bool,
    /// Position after its tag.
    inside: usize,
    has_origin: bool,
    /// `true` if the gain is in the multiplier of its `mimic`.
    has_gain: bool,
}

impl Exporter for Urdf {
    fn about(&self) -> About<'_> {
        About {
            frame: "base_link of robot.toml, whose place in the world of the campaign is not in this file",
            edits_urdf: true,
            // Gains of joints that mimic another joint are in the multiplier of `mimic`.
            holds: |parameter| is_geometry(parameter) || parameter.effect == Effect::Gains && parameter.by.is_some(),
            ..About::laboratory("urdf", "calibrated.urdf")
        }
    }

    fn bytes(&self, given: &ExportInput) -> Result<Vec<u8>> {
        let (robot, _) = given.robot()?;
        let file = given.description.ok_or_else(|| super::other_robot(self.name(), robot, phrase!("kind-urdf")))?;
        let mut edits = Vec::new();
        let mut left_out = Vec::new();
        collect_edits(file.text, given, &mut edits, &mut left_out)
            .ok_or_else(|| error!("urdf-malformed", file = file.file))?;
        let mut lines = given.header_of_geometry("m, rad")?;
        lines.push(format!("origins of `{}` with identified errors", file.file));
        lines.extend(left_out);
        let safe: Vec<String> = lines.iter().map(|line| super::comment(line).replace("--", "__")).collect();
        let note = format!("<!--\n  {}\n-->\n", safe.join("\n  "));
        let root = file.text.find("<robot").unwrap_or_default();
        edits.push(Edit { range: root..root, text: note });
        edits.sort_by_key(|edit| edit.range.start);
        let mut out = String::new();
        let mut at = 0;
        for edit in edits {
            out += file.text.get(at..edit.range.start).unwrap_or_default();
            out += &edit.text;
            at = edit.range.end;
        }
        Ok((out + file.text.get(at..).unwrap_or_default()).into_bytes())
    }
}

/// Collects changes of a file, and parameters that its format cannot give; `None` if the file is
/// unreadable.
fn collect_edits(text: &str, given: &ExportInput, edits: &mut Vec<Edit>, left_out: &mut Vec<String>) -> Option<()> {
    let mut reader = Reader::from_str(text);
    let (mut depth, mut joint) = (0usize, None::<Joint>);
    loop {
        let start = reader.buffer_position() as usize;
        let event = reader.read_event().ok()?;
        let range = start..reader.buffer_position() as usize;
        let empty = matches!(event, Event::Empty(_));
        match event {
            Event::Eof => return Some(()),
            Event::Start(tag) | Event::Empty(tag) => {
                match tag.local_name().as_ref() {
                    "joint" if depth == 1 => {
                        let moves = attribute(&tag, "type").is_some_and(|kind| kind != "fixed");
                        let name = attribute(&tag, "name").unwrap_or_default();
                        joint = Some(Joint { name, moves, inside: range.end, ..Joint::default() });
                    }
                    "origin" if depth == 2 => {
                        if let Some(joint) = joint.as_mut().filter(|joint| joint.moves) {
                            joint.has_origin = true;
                            let errors = errors(given, &joint.name);
                            let tag = origin(&attribute(&tag, "xyz"), &attribute(&tag, "rpy"), &errors, empty);
                            edits.extend(tag.filter(|_| !errors.is_empty()).map(|text| Edit { range, text }));
                        }
                    }
                    "mimic" if depth == 2 => {
                        let gain = joint.as_mut().filter(|joint| joint.moves).and_then(|joint| {
                            let gain = value(given, &format!("gain_{}", joint.name))?;
                            Some((gain, attribute(&tag, "joint")?))
                        });
                        if let Some((gain, other)) = gain.filter(|(gain, _)| *gain != 1.0) {
                            let number = |name: &str, absent: f64| {
                                attribute(&tag, name).map_or(Some(absent), |text| text.trim().parse::<f64>().ok())
                            };
                            let (multiplier, offset) =
                                (gain * number("multiplier", 1.0)?, gain * number("offset", 0.0)?);
                            let end = if empty { "/" } else { "" };
                            let other = quick_xml::escape::escape(other);
                            let text = format!(
                                "<mimic joint=\"{other}\" multiplier=\"{multiplier:?}\" offset=\"{offset:?}\"{end}>"
                            );
                            edits.push(Edit { range, text });
                            joint.iter_mut().for_each(|joint| joint.has_gain = true);
                        }
                    }
                    _ => {}
                }
                depth += usize::from(!empty);
            }
            Event::End(_) => {
                depth = depth.checked_sub(1)?;
                if depth == 1
                    && let Some(joint) = joint.take()
                {
                    finish(&joint, given, edits, left_out);
                }
            }
            _ => {}
        }
    }
}

/// Completes a joint at its end: adds a missing origin, and a remark on its gain.
fn finish(joint: &Joint, given: &ExportInput, edits: &mut Vec<Edit>, left_out: &mut Vec<String>) {
    let name = &joint.name;
    if !joint.moves {
        return;
    }
    let errors = errors(given, name);
    if !joint.has_origin && !errors.is_empty() {
        let text = origin(&None, &None, &errors, true).unwrap_or_default();
        edits.push(Edit { range: joint.inside..joint.inside, text: format!("\n    {text}") });
    }
    let gain = value(given, &format!("gain_{name}")).filter(|gain| *gain != 1.0 && !joint.has_gain);
    left_out.extend(gain.map(|gain| format!("not in this format: joint {name} moves {gain:?} times its value")));
}

/// Value of an attribute of a tag.
fn attribute(tag: &BytesStart, name: &str) -> Option<String> {
    let found = tag.attributes().flatten().find(|a| a.key.local_name().as_ref() == name)?;
    found.normalized_value(quick_xml::XmlVersion::Implicit1_0).ok().map(|value| value.into_owned())
}

/// Value of a parameter of the robot (mm, deg or 1).
fn value(given: &ExportInput, name: &str) -> Option<f64> {
    given.robot?.index(name)?;
    given.parameters.parameters.iter().find(|p| p.name == name).map(|p| p.value)
}

/// Small errors of a joint in the order of their motions: axis, whether it is a rotation, value (mm
/// or rad).
fn errors(given: &ExportInput, joint: &str) -> Vec<(usize, bool, f64)> {
    let all = [(false, ""), (true, "r")].into_iter().flat_map(|(turn, r)| (0..3).map(move |axis| (turn, r, axis)));
    let error = |(turn, r, axis): (bool, &str, usize)| {
        let value = value(given, &format!("{joint}_{r}{}", ["x", "y", "z"][axis]))?;
        Some((axis, turn, if turn { value.to_radians() } else { value }))
    };
    all.filter_map(error).filter(|(_, _, value)| *value != 0.0).collect()
}

/// Tag of an origin followed by errors; `None` if it is unreadable.
fn origin(xyz: &Option<String>, rpy: &Option<String>, errors: &[(usize, bool, f64)], empty: bool) -> Option<String> {
    let vector = |text: &Option<String>| -> Option<[f64; 3]> {
        let Some(text) = text else { return Some([0.0; 3]) };
        let all: Vec<f64> = text.split_ascii_whitespace().map(|v| v.parse().ok()).collect::<Option<_>>()?;
        all.try_into().ok()
    };
    let mut pose = Pose::from_xyz_rpy(vector(xyz)?.map(|m| 1000.0 * m), vector(rpy)?);
    for &(axis, turn, value) in errors {
        pose = match (turn, axis) {
            (false, _) => pose.shift(axis, value),
            (true, 0) => pose.turn_x(value),
            (true, 1) => pose.turn_y(value),
            (true, _) => pose.turn_z(value),
        };
    }
    let ([x, y, z], [roll, pitch, yaw]) = (pose.translation_mm.map(|mm| mm / 1000.0), pose.rpy_rad());
    let mut tag = String::new();
    let _ = write!(
        tag,
        "<origin xyz=\"{x:?} {y:?} {z:?}\" rpy=\"{roll:?} {pitch:?} {yaw:?}\"{}>",
        if empty { "/" } else { "" }
    );
    Some(tag)
}
