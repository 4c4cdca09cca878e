//! Q-DAS ASCII transfer format (AQDEF), `.dfq`: K fields `Knnnn/characteristic value`, one a line.
//!
//! Every coordinate is a characteristic of its own. A point consists of the values of the
//! coordinates X, Y and Z of one name on one piece: the n-th values of `Ball 1.X`, `Ball 1.Y` and
//! `Ball 1.Z`, or of the elements of a group (`K2030` and `K2031`, or nodes `K5112` with `K5102`
//! and `K5103`). The point has the name of the group; the names of the elements state the axes.
//!
//! Values are K fields (`K0001/n`) or rows of pieces without keys: the character 15 separates
//! characteristics, the character 20 the fields of a value (value, attribute, time, ..). A value
//! counts if its attribute `K0002` is 0. Index 0 means all characteristics; no index means the
//! first. Source: defined contents of K fields, Q-DAS data format (Hexagon), and ISO/TR 11462-5.

use super::pivot::{Pivot, Said};
use super::{
    About, ExportFormat, ExportRow, Recognised, Text, WriteError, Writing, decimal_comma, not_this_format, unit_agrees,
};
use crate::Point;
use crate::dialect::{Dialect, Unit};
use etalon_base::message::{Message, Problems};
use etalon_base::{error, phrase};
use etalon_tables::Decimal;
use etalon_tables::lexer::number;
use std::collections::{BTreeMap, BTreeSet};

/// Files `.dfq` of measuring systems with a Q-DAS interface.
pub(super) struct Aqdef;

const CHARACTERISTICS: char = '\u{f}';
const FIELDS: char = '\u{14}';

impl ExportFormat for Aqdef {
    fn about(&self) -> About {
        About { name: "aqdef", title: "Q-DAS ASCII transfer format", decimal_comma: true, ..About::default() }
    }

    fn recognise(&self, text: &str) -> Option<Recognised> {
        let what = phrase!("is-aqdef");
        Recognised::by(text.starts_with("K0100 "), 1.0, what)
    }

    fn read(&self, text: &Text, dialect: &Dialect, unit: Unit) -> (Vec<Point>, Problems) {
        let mut problems = Problems::default();
        let mut file = File { decimal: dialect.form.decimal(), ..File::default() };
        for (i, line) in text.lines.iter().enumerate().filter(|(_, line)| !line.trim().is_empty()) {
            problems.0.extend(file.line(i + 1, line).err().map(|message| message.at(text.place(i + 1))));
        }
        let points = file.points(text, unit, &mut problems);
        (points, problems)
    }

    fn write(&self, rows: &[ExportRow], how: &Writing) -> Result<String, WriteError> {
        let mut all = format!("K0100 {}\nK1001 simulated\nK2004/0 0\nK2142/0 {}\n", 3 * rows.len(), how.unit.name());
        let coordinates =
            || rows.iter().flat_map(|row| ["X", "Y", "Z"].into_iter().zip(row.xyz).map(move |c| (row, c)));
        for (i, (row, (axis, _))) in coordinates().enumerate() {
            all += &format!("K2002/{} {}.{axis}\n", i + 1, row.label);
        }
        for (i, (_, (_, value))) in coordinates().enumerate() {
            all += &format!("K0001/{} {}\n", i + 1, how.number(value));
        }
        Ok(all)
    }
}

/// Contents of a file during reading.
#[derive(Default)]
struct File<'a> {
    decimal: Decimal,
    /// Number of characteristics (`K0100`).
    stated: Option<usize>,
    /// Part of the characteristics that follow.
    part: usize,
    characteristics: BTreeMap<usize, Characteristic<'a>>,
    /// Statements with index 0, which apply to all characteristics.
    common: Characteristic<'a>,
    groups: Groups<'a>,
    order: Order,
}

/// The order of values in the file.
#[derive(Default)]
struct Order {
    /// Index of the piece that is being read, from 0, and the characteristics with values.
    piece: usize,
    of_piece: BTreeSet<usize>,
    last: usize,
    /// `true` if values of one characteristic are not adjacent: the file is ordered by pieces.
    by_piece: bool,
}

/// A characteristic with its values.
#[derive(Default)]
struct Characteristic<'a> {
    line: usize,
    part: usize,
    number: &'a str,
    name: &'a str,
    /// Line and words.
    unit: Option<(usize, &'a str)>,
    /// Kind of the values: 0 variable, 1 attributive, 5 and 6 lists of errors.
    kind: &'a str,
    values: Vec<Value>,
}

impl<'a> Characteristic<'a> {
    fn called(&self) -> &'a str {
        if self.name.is_empty() { self.number } else { self.name }
    }
}

/// Value of a characteristic on a piece.
struct Value {
    line: usize,
    /// Index of the piece, if the file is ordered by pieces.
    piece: usize,
    /// None: the row has no value of this characteristic.
    value: Option<f64>,
    /// 0: valid; 129 invalid, 255 placeholder, 256 deleted, 290 not plausible.
    attribute: u64,
}

/// Groups of characteristics.
#[derive(Default)]
struct Groups<'a> {
    /// `K2030`: the characteristic of a group, by the number of the group.
    simple: BTreeMap<usize, usize>,
    /// `K2031`: the number of the group to which a characteristic belongs.
    elements: BTreeMap<usize, usize>,
    /// `K5002`: names of logical groups.
    names: BTreeMap<usize, &'a str>,
    /// `K5112` and `K5113`: nodes that are characteristics or logical groups.
    nodes: BTreeMap<usize, Node>,
    /// `K5102`: the parent node of a characteristic; `K5103`: the parent node of a node.
    above: BTreeMap<usize, usize>,
    nodes_above: BTreeMap<usize, usize>,
}

#[derive(Clone, Copy)]
enum Node {
    Characteristic(usize),
    Logical(usize),
}

impl<'a> File<'a> {
    fn line(&mut self, line: usize, text: &'a str) -> Result<(), Message> {
        let Some((key, index, content)) = field(text) else { return self.piece(line, text) };
        if self.stated.is_none() && key != 100 {
            return Err(no_aqdef().hint(phrase!("export-one-dfq")));
        }
        let all = index == Some(0);
        let index = index.unwrap_or(1);
        match key {
            100 if self.stated.is_some() => {
                return Err(error!("several-data-sets", record = "K0100"));
            }
            100 => self.stated = Some(whole(content)?),
            1 => self.value(line, self.known(index)?, content, None)?,
            2 => {
                let attribute = whole(content)? as u64;
                let ones: Vec<usize> = if all { self.characteristics.keys().copied().collect() } else { vec![index] };
                for one in ones {
                    let last = self.characteristics.get_mut(&one).and_then(|known| known.values.last_mut());
                    let early =
                        || error!("record-too-early", record = format!("K0002/{one}"), needed = format!("K0001/{one}"));
                    last.ok_or_else(early)?.attribute = attribute;
                }
            }
            1001 => self.part = index,
            2000..3000 if all => self.common.state(line, key, content),
            2030 => drop(self.groups.simple.insert(whole(content)?, index)),
            2031 => drop(self.groups.elements.insert(index, whole(content)?)),
            2000..3000 => {
                let (part, known) = (self.part, self.known(index)?);
                let one = self.characteristics.entry(known).or_insert_with(|| Characteristic {
                    line,
                    part,
                    ..Default::default()
                });
                one.state(line, key, content);
            }
            5002 => drop(self.groups.names.insert(index, content)),
            5112 => drop(self.groups.nodes.insert(index, Node::Characteristic(whole(content)?))),
            5113 => drop(self.groups.nodes.insert(index, Node::Logical(whole(content)?))),
            5102 => drop(self.groups.above.insert(whole(content)?, index)),
            5103 => drop(self.groups.nodes_above.insert(whole(content)?, index)),
            _ => {}
        }
        Ok(())
    }

    /// Index of a characteristic of the file.
    fn known(&self, index: usize) -> Result<usize, Message> {
        let count = self.stated.unwrap_or(0);
        let known = (1..=count).contains(&index);
        known.then_some(index).ok_or_else(|| error!("characteristic-beyond-count", index, count))
    }

    fn value(&mut self, line: usize, index: usize, value: &str, attribute: Option<&str>) -> Result<(), Message> {
        let decimal = self.decimal;
        let Some(one) = self.characteristics.get_mut(&index) else {
            let needed = format!("K2002/{index}");
            return Err(error!("record-too-early", record = format!("K0001/{index}"), needed));
        };
        let value = match value.trim() {
            "" => None,
            value => Some(number(value, decimal).map_err(|message| decimal_comma(message, value, "aqdef"))?),
        };
        let attribute = attribute.map(str::trim).filter(|words| !words.is_empty()).map_or(Ok(0), whole)? as u64;
        let order = &mut self.order;
        order.by_piece |= order.last != index && !one.values.is_empty();
        order.last = index;
        if !order.of_piece.insert(index) {
            order.piece += 1;
            order.of_piece = BTreeSet::from([index]);
        }
        one.values.push(Value { line, piece: order.piece, value, attribute });
        Ok(())
    }

    /// A row of values without keys: one of each characteristic, in their order.
    fn piece(&mut self, line: usize, text: &str) -> Result<(), Message> {
        if self.stated.is_none() {
            return Err(no_aqdef());
        }
        let is_value = |c: char| c.is_ascii_digit() || "+-.,eE \t".contains(c);
        if !text.contains([CHARACTERISTICS, FIELDS]) && !text.chars().all(is_value) {
            let valid = phrase!("k-field-or-values");
            return Err(error!("record-invalid", text = text.trim(), format = "aqdef", valid));
        }
        if !self.order.of_piece.is_empty() {
            self.order.piece += 1;
            self.order.of_piece.clear();
        }
        for (i, value) in text.split(CHARACTERISTICS).enumerate() {
            let mut fields = value.split(FIELDS);
            let (first, attribute) = (fields.next().unwrap_or_default(), fields.next());
            self.value(line, self.known(i + 1)?, first, attribute)?;
        }
        Ok(())
    }

    /// Name of the point and axis of the coordinate in a characteristic.
    fn coordinate(&self, index: usize, one: &Characteristic<'a>) -> Option<(&'a str, usize)> {
        let name = one.called();
        let kind = if one.kind.is_empty() { self.common.kind } else { one.kind };
        if !matches!(kind, "" | "0") {
            return None;
        }
        let words = || name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.is_empty());
        let mut axes = words().filter_map(axis);
        if let Some(group) = self.group(index).filter(|group| !group.is_empty()) {
            return axes.next().filter(|_| axes.next().is_none()).map(|axis| (group, axis));
        }
        let axis = words().next_back().and_then(axis)?;
        let label = name.trim_end().strip_suffix(|c: char| c.is_alphanumeric())?;
        let label = label.trim_end_matches(['.', '_', '-', ':', '/', ',', ' ', '\t']);
        (!label.is_empty() && words().count() > 1).then_some((label, axis))
    }

    /// Name of the group to which a characteristic belongs.
    fn group(&self, index: usize) -> Option<&'a str> {
        let groups = &self.groups;
        let called = |index: &usize| self.characteristics.get(index).map(Characteristic::called);
        if let Some(number) = groups.elements.get(&index) {
            return groups.simple.get(number).and_then(called);
        }
        match groups.nodes.get(groups.above.get(&index)?)? {
            Node::Characteristic(above) if *above != index => called(above),
            // the node of the characteristic: its parents follow
            Node::Characteristic(_) => match groups.nodes.get(groups.nodes_above.get(groups.above.get(&index)?)?)? {
                Node::Characteristic(above) => called(above),
                Node::Logical(number) => groups.names.get(number).copied(),
            },
            Node::Logical(number) => groups.names.get(number).copied(),
        }
    }

    /// `true` if other characteristics are elements of this one.
    fn is_group(&self, index: usize) -> bool {
        let groups = &self.groups;
        let below =
            |node: &usize| matches!(groups.nodes.get(node), Some(Node::Characteristic(above)) if *above == index);
        groups.simple.values().any(|group| *group == index)
            || groups.above.iter().any(|(element, node)| *element != index && below(node))
    }

    fn points(self, text: &Text, unit: Unit, problems: &mut Problems) -> Vec<Point> {
        let mut pivot = Pivot::default();
        let mut others = Vec::new();
        let values = self.characteristics.values().map(|one| one.values.len()).sum::<usize>();
        if values == 0 && problems.0.is_empty() {
            let message = error!("no-measured-points", contents = "none", records = "K0001");
            problems.0.push(message.hint(phrase!("export-one-dfq")).at(text.place(1)));
        }
        let mut coordinates = Vec::new();
        let mut counts = BTreeMap::new();
        for (index, one) in &self.characteristics {
            match self.coordinate(*index, one) {
                Some((label, axis)) => {
                    problems.0.extend(self.unit(one, text, unit).err());
                    let count = *counts.entry((one.part, label)).or_insert(one.values.len());
                    problems.0.extend(self.missing(one, count).map(|(line, message)| message.at(text.place(line))));
                    let values = one.values.iter().enumerate();
                    coordinates.extend(values.map(|(piece, value)| (piece, *index, one.part, label, axis, value)));
                }
                None if self.is_group(*index) => {}
                None => {
                    let line = one.values.first().map_or(one.line, |value| value.line);
                    let reason = phrase!("characteristic-of-no-axis");
                    others.push(text.no_point(line, one.called(), reason));
                }
            }
        }
        coordinates.sort_by_key(|(piece, index, ..)| (*piece, *index));
        for (piece, _, part, label, axis, value) in coordinates {
            let said = match value.value.filter(|_| value.attribute == 0) {
                Some(coordinate) => Said::Coordinate(axis, coordinate),
                None => Said::Other(format!("K0002 = {}", value.attribute)),
            };
            pivot.add(value.line, label, &format!("{part}/{piece}"), said);
        }
        let mut points = pivot.rows(text, unit);
        points.extend(others);
        points
    }

    /// Error if the values of the characteristic belong to other pieces than the values of the
    /// other axes of the point.
    fn missing(&self, one: &Characteristic, count: usize) -> Option<(usize, Message)> {
        let name = one.called();
        if let Some((i, value)) =
            one.values.iter().enumerate().find(|(i, value)| self.order.by_piece && value.piece != *i)
        {
            let message = error!("value-of-piece-missing", name, number = i + 1, piece = value.piece + 1);
            return Some((value.line, message));
        }
        let found = one.values.len();
        (found != count).then(|| (one.line, error!("coordinate-counts-differ", name, found, count)))
    }

    /// Returns an error if the unit of the characteristic differs from the unit of the campaign.
    fn unit(&self, one: &Characteristic, text: &Text, stated: Unit) -> Result<(), Message> {
        let Some((line, words)) = one.unit.or(self.common.unit).filter(|(_, words)| !words.is_empty()) else {
            return Ok(());
        };
        let Some(unit) = Unit::from_heading(&format!("[{words}]")) else {
            let message = error!("unit-unknown", unit = words, units = ["mm", "m", "um", "inch"]);
            return Err(message.at(text.place(line)));
        };
        unit_agrees(stated, unit, &"K2142", text.place(line))
    }
}

impl<'a> Characteristic<'a> {
    fn state(&mut self, line: usize, key: usize, content: &'a str) {
        match key {
            2001 => self.number = content,
            2002 => self.name = content,
            2004 => self.kind = content,
            2142 => self.unit = Some((line, content)),
            _ => {}
        }
    }
}

/// Key, index and content of a K field: `K2002/1 Ball 1.X`.
fn field(text: &str) -> Option<(usize, Option<usize>, &str)> {
    let (key, content) = text.trim().split_once([' ', '\t']).unwrap_or((text.trim(), ""));
    let digits = |words: &str| !words.is_empty() && words.bytes().all(|b| b.is_ascii_digit());
    let mut parts = key.strip_prefix('K')?.split('/');
    let key = parts.next().filter(|key| key.len() == 4 && digits(key))?;
    // a second index belongs to the value
    let index = parts.next();
    if !index.is_none_or(digits) || !parts.all(digits) {
        return None;
    }
    Some((key.parse().ok()?, index.map(str::parse).transpose().ok()?, content.trim()))
}

/// Error for a file without `K0100` in its first field.
fn no_aqdef() -> Message {
    not_this_format("aqdef", &phrase!("begins-with", text = "K0100"))
}

fn whole(content: &str) -> Result<usize, Message> {
    let valid = || phrase!("whole-number");
    content.parse().map_err(|_| error!("record-invalid", text = content, format = "aqdef", valid = valid()))
}

fn axis(word: &str) -> Option<usize> {
    ["X", "Y", "Z"].iter().position(|axis| axis.eq_ignore_ascii_case(word))
}
