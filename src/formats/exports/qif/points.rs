//! Points of the measured features of a QIF file: inline (2.x), or in point sets to which features
//! refer (3.0).

use super::Touch;
use super::units::Units;
use crate::xml::Node;
use etalon_base::message::Message;
use etalon_base::pose::Vector;
use etalon_base::{phrase, warning};
use std::collections::{BTreeMap, BTreeSet};

/// Maximum number of points of all features together: many may refer to one set.
const MOST_POINTS: usize = 1 << 23;

/// Maximum number of broken references for which a similar set is searched.
const MOST_HINTS: usize = 50;

/// A measured point.
#[derive(Clone, Copy, Debug)]
struct Sample {
    xyz_mm: Vector,
    touch: Touch,
}

/// Points of a file, and the point sets that were used.
pub(super) struct PointSets<'t, 'a> {
    sets: BTreeMap<&'t str, (Node<'t, 'a>, Result<Vec<Sample>, Message>)>,
    used: BTreeSet<&'t str>,
    given: usize,
    /// Number of broken references.
    astray: usize,
}

impl<'t, 'a> PointSets<'t, 'a> {
    /// Reads the point sets among the elements with an id.
    pub fn read(nodes: &BTreeMap<&'t str, Node<'t, 'a>>, units: &Units) -> Self {
        let sets = nodes.iter().filter(|(_, n)| n.name() == "MeasuredPointSet");
        let sets = sets.map(|(&id, &node)| (id, (node, set(node, units)))).collect();
        Self { sets, used: BTreeSet::new(), given: 0, astray: 0 }
    }

    /// Number of points in all sets that could be read.
    pub fn count(&self) -> usize {
        self.sets.values().filter_map(|(_, points)| points.as_ref().ok()).map(Vec::len).sum()
    }

    /// Sets to which no feature refers.
    pub fn unused(&self) -> impl Iterator<Item = (&'t str, Node<'t, 'a>)> {
        self.sets.iter().filter(|(id, _)| !self.used.contains(*id)).map(|(&id, &(node, _))| (id, node))
    }

    /// The points of a `PointList`, and `true` if they are centres of a probe.
    pub fn list(&mut self, list: Node<'t, 'a>, units: &Units) -> Result<(Vec<Vector>, Touch), Message> {
        let stated = list.attribute("n").and_then(|n| n.trim().parse::<usize>().ok());
        let found = list.children().count();
        if let Some(n) = stated.filter(|&n| n != found) {
            return Err(warning!("stated-count-differs", name = list.name(), stated = n, found).at(list.place()));
        }
        let mut samples: Vec<Sample> = Vec::new();
        for entry in list.children() {
            match entry.name() {
                "MeasurePoint" => samples.push(inline(entry, units)?),
                "WholePointSetId" | "RangePointSetId" | "SinglePointSetId" => self.part(entry, &mut samples)?,
                other => return Err(unsupported(entry, other)),
            }
        }
        let touch = samples.first().map_or(Touch::Contact, |s| s.touch);
        if samples.iter().any(|s| s.touch != touch) {
            return Err(warning!("compensation-mixed").at(list.place()));
        }
        Ok((samples.into_iter().map(|s| s.xyz_mm).collect(), touch))
    }

    /// Adds the points to which an entry refers; indices count from 1, a range includes its end.
    fn part(&mut self, entry: Node<'t, 'a>, samples: &mut Vec<Sample>) -> Result<(), Message> {
        let id = entry.text();
        if entry.attribute("xId").is_some() {
            return Err(warning!("reference-external", id).at(entry.place()));
        }
        let Some((node, points)) = self.sets.get(id) else {
            let name = entry.name();
            let message = warning!("reference-broken", name, id, kind = "MeasuredPointSet").at(entry.place());
            self.astray += 1;
            let far = |other: &str| Some(other.parse::<i64>().ok()?.abs_diff(id.parse().ok()?));
            // looking for the set that is meant takes as long as there are sets
            let looked = (self.astray <= MOST_HINTS).then(|| self.unused()).into_iter().flatten();
            let nearest = looked.filter_map(|(other, _)| Some((far(other)?, other))).min();
            return Err(match nearest {
                Some((_, name)) => message.hint(phrase!("did-you-mean", name)),
                None => message,
            });
        };
        self.used.insert(id);
        let points = points.as_ref().map_err(Clone::clone)?;
        let count = points.len();
        let stated = match entry.name() {
            "RangePointSetId" => entry.attribute("range"),
            "SinglePointSetId" => entry.attribute("index"),
            _ => None,
        };
        let whole = |text: &str| text.trim().parse::<usize>().ok().filter(|&i| (1..=count).contains(&i));
        let within = |stated: &str| {
            let (first, last) = stated.trim().split_once(char::is_whitespace).unwrap_or((stated, stated));
            let (first, last) = (whole(first)?, whole(last)?);
            points.get(first - 1..last).filter(|_| first <= last)
        };
        let part = match entry.name() {
            "WholePointSetId" => &points[..],
            _ => within(stated.as_deref().unwrap_or_default()).ok_or_else(|| {
                let (range, line) = (stated.as_deref().unwrap_or_default(), node.place().line.unwrap_or(0));
                warning!("point-range-invalid", range, id, line, count).at(entry.place())
            })?,
        };
        if self.given + part.len() > MOST_POINTS {
            return Err(warning!("file-too-many-items", items = "points", most = MOST_POINTS).at(entry.place()));
        }
        self.given += part.len();
        samples.extend_from_slice(part);
        Ok(())
    }
}

/// A `MeasurePoint` of QIF 2.x.
fn inline(node: Node, units: &Units) -> Result<Sample, Message> {
    let Some(point) = node.child("Point") else { return Err(missing(node, "Point")) };
    let factor = units.mm_in(point, None)?;
    let &[x, y, z] = &point.numbers()?[..] else {
        return Err(not_as_many(point, 3));
    };
    let centre = node.child("Compensated").map(|n| flag(n, n.text())).transpose()?.is_some_and(|c| !c);
    let radius = node.child("ProbeRadius").map(|n| radius(n, units, None)).transpose()?;
    let touch = if centre { Touch::Centre { radius_mm: radius } } else { Touch::Contact };
    Ok(Sample { xyz_mm: [x, y, z].map(|v| v * factor), touch })
}

/// A `MeasuredPointSet` of QIF 3.0.
fn set(node: Node, units: &Units) -> Result<Vec<Sample>, Message> {
    if let Some(other) =
        node.children().find(|c| matches!(c.name(), "CoordinateSystemId" | "TranformId" | "TransformId"))
    {
        return Err(unsupported(other, other.name()));
    }
    if let Some(binary) =
        node.children().find(|c| matches!(c.name(), "BinaryPoints" | "BinaryCompensated" | "BinaryProbeRadii"))
    {
        return Err(unsupported(binary, binary.name()).hint(phrase!("export-points-as-text")));
    }
    let Some(list) = node.child("Points") else { return Err(missing(node, "Points")) };
    let own_unit = units.mm_in_set(node)?;
    let factor = units.mm_in(list, own_unit)?;
    let numbers = list.numbers()?;
    let count = node.attribute("count").and_then(|c| c.trim().parse::<usize>().ok());
    let (name, found) = (list.name(), numbers.len());
    match count.map(|count| count.saturating_mul(3)) {
        Some(stated) if stated != found => {
            return Err(warning!("stated-count-differs", name, stated, found).at(list.place()));
        }
        None if !found.is_multiple_of(3) => {
            let counts = phrase!("three-per-point");
            return Err(warning!("number-count-differs", name, found, counts).at(list.place()));
        }
        _ => {}
    }
    let count = found / 3;
    let mut flags = match (node.child("Compensated"), node.child("Compensations")) {
        (Some(one), _) => vec![flag(one, one.text())?],
        (_, Some(all)) => all.text().split_ascii_whitespace().map(|t| flag(all, t)).collect::<Result<_, _>>()?,
        _ => return Err(missing(node, "Compensated")),
    };
    let mut radii = match (node.child("ProbeRadius"), node.child("ProbeRadii")) {
        (Some(one), _) => vec![Some(radius(one, units, own_unit)?)],
        (_, Some(all)) => {
            let factor = units.mm_in(all, own_unit)?;
            all.numbers()?.into_iter().map(|r| Some(r * factor)).collect()
        }
        _ => vec![None],
    };
    for (what, length) in [("Compensations", flags.len()), ("ProbeRadii", radii.len())] {
        if node.child(what).is_some() && length != count {
            let message = warning!("stated-count-differs", name = what, stated = count, found = length);
            return Err(message.at(node.place()));
        }
    }
    flags.resize(count, flags.first().copied().unwrap_or(true));
    radii.resize(count, radii.first().copied().flatten());
    let samples =
        numbers.chunks_exact(3).zip(flags.into_iter().zip(radii)).map(|(p, (compensated, radius_mm))| Sample {
            xyz_mm: [p[0] * factor, p[1] * factor, p[2] * factor],
            touch: if compensated { Touch::Contact } else { Touch::Centre { radius_mm } },
        });
    Ok(samples.collect())
}

/// An `xs:boolean`.
fn flag(node: Node, text: &str) -> Result<bool, Message> {
    match text {
        "true" | "1" => Ok(true),
        "false" | "0" => Ok(false),
        _ => {
            let message = warning!("record-invalid", text, format = "qif", valid = ["true", "false"]);
            Err(message.at(node.place()))
        }
    }
}

fn radius(node: Node, units: &Units, set: Option<f64>) -> Result<f64, Message> {
    let &[radius] = &node.numbers()?[..] else { return Err(not_as_many(node, 1)) };
    Ok(radius * units.mm_in(node, set)?)
}

/// Warning about an element without this child.
fn missing(node: Node, record: &str) -> Message {
    warning!("record-missing", parent = node.name(), record).at(node.place())
}

/// Warning about an element that cannot be read.
fn unsupported(node: Node, element: &str) -> Message {
    warning!("element-unsupported", element).at(node.place())
}

/// Warning about an element with more or fewer than `count` numbers.
fn not_as_many(node: Node, count: usize) -> Message {
    let found = node.text().split_ascii_whitespace().count();
    warning!("number-count-differs", name = node.name(), found, counts = [count]).at(node.place())
}
