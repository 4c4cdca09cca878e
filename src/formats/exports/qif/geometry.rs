//! Measured and nominal values of a feature in a QIF file.

use super::units::Units;
use crate::xml::Node;
use etalon_base::message::Message;
use etalon_base::pose::{Vector, unit};
use etalon_base::{error, warning};

/// Given values of a feature.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FeatureGeometry {
    /// Location, or the point of the axis.
    pub point_mm: Option<Vector>,
    /// Unit normal or direction of the axis.
    pub direction: Option<Vector>,
    /// Half the diameter (of a torus the major one, of a cone the one at its point).
    pub radius_mm: Option<f64>,
    /// Half the minor diameter of a torus.
    pub minor_radius_mm: Option<f64>,
    /// Full angle of a cone.
    pub apex_angle_rad: Option<f64>,
}

impl FeatureGeometry {
    /// Reads the values of a feature of this kind from `nodes` (nominal values have two: location
    /// and size).
    pub(super) fn read<'t, 'a: 't>(
        kind: &str,
        nodes: impl Iterator<Item = Node<'t, 'a>>,
        units: &Units,
    ) -> Result<Self, Message> {
        let mut all = Self::default();
        for value in nodes.flat_map(Node::children) {
            match value.name() {
                "Axis" => {
                    for part in value.children() {
                        match part.name() {
                            "AxisPoint" => all.point_mm = Some(point(part, units)?),
                            "Direction" => all.direction = Some(direction(part)?),
                            _ => {}
                        }
                    }
                }
                "Location" => all.point_mm = Some(point(value, units)?),
                "Direction" | "AxisVector" => all.direction = Some(direction(value)?),
                "Normal" if kind != "Line" => all.direction = Some(direction(value)?),
                // the published sample gives the direction of lines as their normal
                "Normal" if all.direction.is_none() => all.direction = Some(direction(value)?),
                "Diameter" | "MajorDiameter" => all.radius_mm = Some(length(value, units)? / 2.0),
                "MinorDiameter" => all.minor_radius_mm = Some(length(value, units)? / 2.0),
                "FullAngle" => all.apex_angle_rad = Some(one(value)? * units.rad_in(value)?),
                "HalfAngle" => all.apex_angle_rad = Some(2.0 * one(value)? * units.rad_in(value)?),
                _ => {}
            }
        }
        Ok(all)
    }
}

fn point(node: Node, units: &Units) -> Result<Vector, Message> {
    let factor = units.mm_in(node, None)?;
    Ok(three(node)?.map(|v| v * factor))
}

fn direction(node: Node) -> Result<Vector, Message> {
    let wrong = || warning!("direction-zero", direction = node.text()).at(node.place());
    unit(three(node)?).ok_or_else(wrong)
}

fn length(node: Node, units: &Units) -> Result<f64, Message> {
    Ok(one(node)? * units.mm_in(node, None)?)
}

fn three(node: Node) -> Result<Vector, Message> {
    let numbers = node.numbers()?;
    <Vector>::try_from(numbers.as_slice()).map_err(|_| not_as_many(node, numbers.len(), 3))
}

fn one(node: Node) -> Result<f64, Message> {
    let numbers = node.numbers()?;
    let one = numbers.first().copied().filter(|_| numbers.len() == 1);
    one.ok_or_else(|| not_as_many(node, numbers.len(), 1))
}

/// Error for an element with too many or too few numbers.
fn not_as_many(node: Node, found: usize, count: usize) -> Message {
    error!("number-count-differs", name = node.name(), found, counts = [count]).at(node.place())
}
