//! Interpretation of columns as coordinates of points, and of columns without headings.

use crate::propose::headings::{Heading, Word, stands_for};
use crate::propose::meaning::{Evidence, Interpretation, Meaning, PointSet};
use crate::propose::table::{Column, Table, heading_axis};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use std::collections::BTreeSet;

/// Tag of the headings of a quaternion, and the columns of its components.
type Quaternion = (String, [usize; 4]);

/// Kind of a set of coordinates, by the words of its headings.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Plain,
    Measured,
    Named,
    Commanded,
    Difference,
    Other,
}

/// Set of coordinates whose headings differ only in the axis.
#[derive(Clone, Debug)]
struct Set {
    points: PointSet,
    kind: Kind,
}

/// Minimum count of numbers without headings that are points of three numbers each: fewer numbers
/// may be the joints and the points of a robot.
pub(crate) const FEWEST_OF_POINTS: usize = 30;
/// Minimum and maximum number of rows whose distances are compared.
const FEWEST_COMPARED: usize = 5;
const MOST_COMPARED: usize = 100;
/// Maximum difference of two distances that agree, relative to the mean distance: a camera measures
/// with a few percent.
const AGREES: f64 = 0.04;
/// Number of points of a row from which on they are the targets of a body.
const MANY_POINTS: usize = 4;
/// Maximum number of sets of coordinates that are commanded, measured, and their difference.
const MOST_RELATED: usize = 12;
/// Numbers of a row that may be a row of a table whose rows and columns are exchanged.
const WIDE: usize = 90;
/// Maximum count of numbers without headings that may be a point with a number behind it.
const MOST_OF_POINT: usize = 5;
/// Minimum count of numbers that may be the joints of an arm and a point.
const FEWEST_OF_ARM: usize = 9;
/// Maximum count of numbers of a row that may be a table of one row.
const MOST_IN_ROW: usize = 16;

/// Words of positions that name no body.
const NEUTRAL: [&str; 20] = [
    "p",
    "pos",
    "position",
    "t",
    "tcp",
    "pt",
    "c",
    "coord",
    "coordinate",
    "coordinates",
    "trans",
    "translation",
    "loc",
    "location",
    "point",
    "座標",
    "坐标",
    "koordinate",
    "coordonnee",
    "coordenada",
];
/// Words of orientations that name no body.
const TURNED: [&str; 14] = [
    "r",
    "rot",
    "rotation",
    "orientation",
    "euler",
    "rpy",
    "q",
    "quat",
    "quaternion",
    "ori",
    "orient",
    "attitude",
    "姿勢",
    "姿态",
];

/// Words of sizes, of places on a screen, and of fields and motions, which are no points.
const NO_POINTS: [&str; 20] = [
    "scale", "size", "extent", "width", "gaze", "screen", "cursor", "pixel", "pixels", "image", "img", "bbox",
    "texture", "uv", "color", "gravity", "jerk", "twist", "wrench", "beschl",
];

/// Words of the robot's own bodies, whose poses its controller computes.
const OF_CONTROLLER: [&str; 12] = [
    "flange",
    "flansch",
    "bride",
    "brida",
    "flangia",
    "robot",
    "roboter",
    "controller",
    "effector",
    "eef",
    "法兰",
    "フランジ",
];

/// Words of a heading that name a body: neither words of positions nor of orientations. `r` in
/// front of a name is the right of two.
fn names_of_body(tag: &str) -> impl Iterator<Item = &str> {
    let words: Vec<&str> = tag.split(' ').filter(|word| !word.is_empty()).collect();
    let is_name = |word: &&str| !NEUTRAL.contains(word) && !TURNED.contains(word);
    let first = words.iter().position(|word| !NEUTRAL.contains(word));
    let right = first.filter(|at| words[*at] == "r" && words.iter().any(is_name));
    let names = words.into_iter().enumerate().filter(move |(at, word)| is_name(word) || right == Some(*at));
    names.map(|(_, word)| word)
}

/// Returns the words that name a body: neither words of positions and orientations, nor numbers of
/// components, nor words for measured.
fn body(tag: &str) -> Vec<&str> {
    names_of_body(tag).filter(|word| !stands_for(word, Word::Measured)).collect()
}

/// Returns the name of the target that the headings of a point give; empty for words that name no
/// body.
pub(crate) fn target_name(tag: &str) -> String {
    names_of_body(tag).collect::<Vec<&str>>().join("_")
}

/// Axis of each column of a survey, with the other words of its heading: east and north of one
/// body, and its height, which may also stand beside x and y.
fn survey_axes(table: &Table) -> Vec<Option<(usize, String)>> {
    let numeric = |column: &&Column| column.is_numeric();
    let named: Vec<Option<(usize, String)>> = table
        .columns
        .iter()
        .map(|column| Some(column).filter(numeric).and_then(|column| column.heading.survey_axis()))
        .collect();
    let has = |axis: usize, tag: &str| named.iter().flatten().any(|(of, words)| *of == axis && words == tag);
    // x and y of the same body without a z; words such as "coordinate" may stand beside them
    let plain: Vec<(usize, String)> = table.columns.iter().filter(numeric).filter_map(heading_axis).collect();
    let has_plain = |axis: usize, tag: &str| plain.iter().any(|(of, words)| *of == axis && words == tag);
    let bare = |tag: &str| tag.split(' ').filter(|word| !NEUTRAL.contains(word)).collect::<Vec<&str>>().join(" ");
    let beside = |tag: &str| {
        let is_flat = |of: &&String| bare(of) == tag && has_plain(0, of) && has_plain(1, of) && !has_plain(2, of);
        plain.iter().map(|(_, of)| of).find(is_flat).cloned()
    };
    let placed = |(axis, tag): (usize, String)| match has(0, &tag) && has(1, &tag) {
        true => Some((axis, tag)),
        false => beside(&tag).filter(|_| axis == 2).map(|tag| (axis, tag)),
    };
    named.iter().map(|of| of.clone().and_then(placed)).collect()
}

/// Returns the axis at the end of a word for measured, commanded or difference (`nomx`, `devy`,
/// `MX Coord.`), and this word, if the table has the headings of all three axes.
fn joined_axis(column: &Column, table: &Table) -> Option<(usize, String)> {
    let is_neutral = |word: &&String| word.len() > 1 && NEUTRAL.contains(&word.as_str());
    let without_neutral = |column: &Column| {
        column.heading.words.iter().filter(|word| !is_neutral(word)).cloned().collect::<Vec<String>>().join(" ")
    };
    let word = Some(without_neutral(column)).filter(|word| !word.contains(' '))?;
    let last = word.chars().last()?;
    let axis = ['x', 'y', 'z'].iter().position(|axis| *axis == last)?;
    let before = &word[..word.len() - 1];
    let known = [Word::Measured, Word::Commanded, Word::Difference];
    // alone, `MX` is a moment
    let is_measured = before == "m" && column.heading.words.iter().any(|word| is_neutral(&word));
    let is_long = before.len() > 2 && known.into_iter().any(|meaning| stands_for(before, meaning));
    let is_known = before == "d" || is_measured || is_long;
    let has = |axis: char| table.columns.iter().any(|other| without_neutral(other) == format!("{before}{axis}"));
    (is_known && ['x', 'y', 'z'].into_iter().all(has)).then(|| (axis, before.to_owned()))
}

/// Returns the kind of a set by the words of its headings.
fn kind_by_words(tag: &str) -> Kind {
    let has = |meaning: Word| tag.split(' ').any(|word| stands_for(word, meaning));
    let long = |meaning: Word| tag.split(' ').any(|word| word.len() > 1 && stands_for(word, meaning));
    match () {
        () if tag.is_empty() => Kind::Plain,
        () if has(Word::Uncertainty) || has(Word::Motion) || tag == "n" || long(Word::Normal) => Kind::Other,
        () if tag.split(' ').any(|word| NO_POINTS.contains(&word)) => Kind::Other,
        () if tag.split(' ').any(|word| TURNED.contains(&word) && !names_of_body(tag).any(|name| name == word)) => {
            Kind::Other
        }
        () if has(Word::Difference) => Kind::Difference,
        () if ["target", "ziel"].contains(&tag) => Kind::Named,
        () if has(Word::Commanded) && !long(Word::Measured) => Kind::Commanded,
        () if has(Word::Measured) => Kind::Measured,
        () if tag.split(' ').all(|word| NEUTRAL.contains(&word)) => Kind::Plain,
        () => Kind::Named,
    }
}

/// `true` if the third of three sets is the second minus the first in all rows, to the digits of
/// the file.
fn are_differences(table: &Table, [first, second, third]: [&PointSet; 3]) -> bool {
    let axes = (0..3).map(|axis| [first.columns[axis], second.columns[axis], third.columns[axis]]);
    let mut any = false;
    let all = axes.filter(|columns| columns.iter().any(Option::is_some)).all(|columns| {
        let [Some(a), Some(b), Some(c)] = columns else { return false };
        let largest = table.columns[c].largest();
        // zeros are no commanded values: every column is its own difference from them
        any |= largest > 0.0 && table.columns[a].largest() > 0.0;
        let rounding = 5e-3 * largest + 1e-9 * table.columns[a].largest();
        // what is measured is near what is commanded: other differences are distances of bodies
        let (low, high) = table.columns[a].range();
        if largest > 0.2 * (high - low).max(table.columns[a].largest()) {
            return false;
        }
        table.finite_rows([a, b, c]).all(|[a, b, c]| (b - a - c).abs() <= rounding.max(2e-4 * c.abs()))
    });
    all && any
}

/// `true` if two points are much nearer to each other in all rows than the points of the rows are.
fn nearly_agree(table: &Table, a: &PointSet, b: &PointSet) -> bool {
    const NEAR: f64 = 2e-3;
    let span = |at: usize| {
        let (low, high) = table.columns[at].range();
        high - low
    };
    let spread = a.columns.iter().flatten().map(|at| span(*at)).fold(0.0, f64::max);
    let near = |(a, b): (&Option<usize>, &Option<usize>)| match (a, b) {
        (Some(a), Some(b)) => table.finite_rows([*a, *b]).all(|[a, b]| (a - b).abs() <= NEAR * spread),
        _ => false,
    };
    spread > 0.0 && a.columns.iter().zip(&b.columns).filter(|(a, b)| a.is_some() || b.is_some()).all(near)
}

/// Corrects the kinds of sets by the other sets and columns of the table.
fn by_other_sets(sets: &mut [Set], table: &Table) {
    let has = |kind: Kind| sets.iter().any(|set| set.kind == kind);
    // `x_t` beside `x_dif`, and a target beside measured values, is the commanded value
    let (compared, measured) = (has(Kind::Difference), has(Kind::Measured));
    for set in sets.iter_mut() {
        let is_target = ["target", "ziel"].contains(&set.points.tag.as_str());
        if compared && (is_target || set.points.tag == "t") || measured && is_target {
            set.kind = Kind::Commanded;
        }
    }
    // `TX` beside `FX` is a torque
    let has_force = |rest: &[&str]| {
        let force: Vec<&str> = ["fx"].into_iter().chain(rest.iter().copied()).collect();
        let is_force = |column: &Column| {
            let words: BTreeSet<&str> = column.heading.words.iter().map(String::as_str).collect();
            words == force.iter().copied().collect()
        };
        table.columns.iter().any(is_force)
    };
    for set in sets.iter_mut() {
        let words: Vec<&str> = set.points.tag.split(' ').collect();
        if words[0] == "t" && has_force(&words[1..]) {
            set.kind = Kind::Other;
        }
    }
    // linear velocities stand beside angular ones
    let is_of = |set: &Set, word: &str| set.points.tag.split(' ').any(|of| of == word);
    if sets.iter().any(|set| is_of(set, "angular")) {
        sets.iter_mut()
            .filter(|set| is_of(set, "angular") || is_of(set, "linear"))
            .for_each(|set| set.kind = Kind::Other);
    }
    // `R.x` beside `L.x` is the right of two bodies
    let one = |tag: &str| sets.iter().position(|set| set.points.tag == tag);
    if let (Some(left), Some(right)) = (one("l"), one("r")) {
        for (at, name) in [(left, "left"), (right, "right")] {
            (sets[at].points.tag, sets[at].kind) = (name.to_owned(), Kind::Named);
        }
    }
    let directed = |set: &Set| match set.points.columns {
        [Some(x), Some(y), Some(z)] => table.rows > 1 && table.are_unit([x, y, z]),
        _ => false,
    };
    // axes of a tool beside its position
    if sets.iter().any(|set| set.kind != Kind::Other && !directed(set)) {
        sets.iter_mut().filter(|set| directed(set)).for_each(|set| set.kind = Kind::Other);
    }
}

/// `true` if nine of ten distances from row to row agree: one point in two frames, or two points of
/// a body that does not turn.
fn are_rigid(table: &Table, a: &PointSet, b: &PointSet) -> bool {
    let ([Some(a0), Some(a1), Some(a2)], [Some(b0), Some(b1), Some(b2)]) = (a.columns, b.columns) else {
        return false;
    };
    let all: Vec<[f64; 6]> = table.finite_rows([a0, a1, a2, b0, b1, b2]).collect();
    let rows: Vec<&[f64; 6]> = all.iter().step_by(all.len().div_ceil(MOST_COMPARED).max(1)).collect();
    let distance =
        |p: &[f64; 6], q: &[f64; 6], from: usize| (from..from + 3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
    let pairs = (0..rows.len()).flat_map(|i| (i + 1..rows.len()).map(move |j| (i, j)));
    let both: Vec<[f64; 2]> = pairs.map(|(i, j)| [0, 3].map(|from| distance(rows[i], rows[j], from))).collect();
    // in other units as well
    let [first, second] = [0, 1].map(|k| both.iter().map(|pair| pair[k]).sum::<f64>());
    let scale = first / second;
    let most = AGREES * first / both.len().max(1) as f64;
    let agreeing = both.iter().filter(|[a, b]| (a - scale * b).abs() <= most).count();
    rows.len() >= FEWEST_COMPARED && scale.is_finite() && scale > 0.0 && 10 * agreeing >= 9 * both.len()
}

/// Returns three of the columns behind the first three that nearly agree with these: commanded and
/// measured coordinates, or two measurements.
fn repeated_point(table: &Table, columns: &[usize]) -> Option<[usize; 3]> {
    let set = |at: &[usize]| PointSet { tag: String::new(), columns: [0, 1, 2].map(|k| at.get(k).copied()) };
    let point = set(columns);
    let others = columns.get(3..)?.windows(3);
    others.filter(|at| nearly_agree(table, &point, &set(at))).find_map(|at| at.try_into().ok())
}

/// `true` if three or four neighbouring columns have norm 1 in all rows: a direction or a
/// quaternion.
fn has_direction(table: &Table, columns: &[usize]) -> bool {
    let three = columns.windows(3).any(|at| table.are_unit([at[0], at[1], at[2]]));
    three || columns.windows(4).any(|at| table.are_unit([at[0], at[1], at[2], at[3]]))
}

/// `true` if the texts in front of the rows are headings: rows and columns are exchanged.
fn are_names_of_columns(table: &Table) -> bool {
    let is_heading = |cell: &str| {
        let heading = Heading::parse(cell);
        let is_axis = ["x", "y", "z"].contains(&heading.joined().as_str());
        let is_numbered = heading.words.last().is_some_and(|word| word.parse::<usize>().is_ok());
        is_axis || heading.is_only(&[Word::Time]) || is_numbered && heading.has(Word::Joint)
    };
    let texts = table.columns.iter().find(|column| !column.is_numeric());
    texts.is_some_and(|column| column.cells.len() > 1 && column.cells.iter().all(|cell| is_heading(cell)))
}

/// Returns whether the distance of two points is the same in all rows, and whether the vector
/// between the two is.
fn steady(table: &Table, a: &PointSet, b: &PointSet) -> [bool; 2] {
    const STEADY: f64 = 0.01;
    let ([Some(a0), Some(a1), Some(a2)], [Some(b0), Some(b1), Some(b2)]) = (a.columns, b.columns) else {
        return [false; 2];
    };
    let rows: Vec<[f64; 3]> =
        table.finite_rows([a0, a1, a2, b0, b1, b2]).map(|[x, y, z, u, v, w]| [x - u, y - v, z - w]).collect();
    let (low, high) = [a0, a1, a2].map(|at| table.columns[at].range()).into_iter().fold(
        (0.0, 0.0),
        |(low, high): (f64, f64), (from, to)| if to - from > high - low { (from, to) } else { (low, high) },
    );
    let count = rows.len().max(1) as f64;
    let is_steady = |value: &dyn Fn(&[f64; 3]) -> f64| {
        let mean = rows.iter().map(value).sum::<f64>() / count;
        (rows.iter().map(|row| (value(row) - mean).powi(2)).sum::<f64>() / count).sqrt() <= STEADY * (high - low)
    };
    let norm = |row: &[f64; 3]| row.iter().map(|v| v * v).sum::<f64>().sqrt();
    [is_steady(&norm), (0..3).all(|k| is_steady(&|row| row[k]))]
}

impl Interpretation {
    /// Returns two points of a row that may be one point in two frames: their distances from row to
    /// row agree, and they are not two targets on one body.
    pub(crate) fn in_two_frames(&self, table: &Table) -> Option<[usize; 2]> {
        let count = self.points.len();
        let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
        let is_pair = |[i, j]: &[usize; 2]| {
            let (a, b) = (&self.points[*i], &self.points[*j]);
            // names that differ in a number alone are targets: `smr 1` and `smr 2`
            let name = |tag: &str| tag.chars().filter(|c| !c.is_ascii_digit()).collect::<String>();
            let alike = name(&target_name(&a.tag)) == name(&target_name(&b.tag)) || nearly_agree(table, a, b);
            // of two targets on one body the distance stays, and the direction changes
            !alike && are_rigid(table, a, b) && steady(table, a, b) != [true, false]
        };
        pairs.filter(|_| count < MANY_POINTS).find(is_pair)
    }

    /// `true` for two points that may be one point in two frames which differ in their directions.
    pub(crate) fn is_in_turned_frames(&self, table: &Table) -> bool {
        let turned = |[i, j]: [usize; 2]| !steady(table, &self.points[i], &self.points[j])[1];
        self.in_two_frames(table).is_some_and(turned)
    }

    /// Adds that a pose of the robot is in the same rows as the measured point: `etalon cell` finds
    /// the relation of both.
    pub(crate) fn poses_of_robot(&mut self, table: &Table) {
        let of_robot = |tag: &&String| tag.split(' ').any(|word| OF_CONTROLLER.contains(&word));
        let Some(tag) = self.bodies.iter().find(of_robot).cloned() else { return };
        // a pose has more columns than the three of its position
        let is_of = |column: &&Column| tag.split(' ').all(|word| column.heading.words.iter().any(|of| of == word));
        let has_pose = table.columns.iter().filter(is_of).count() >= 6;
        if !has_pose || self.points.iter().all(|set| set.tag == tag) {
            return;
        }
        let is_turned = [self.quaternion_columns(), self.rotation_columns(), self.matrix_columns()].concat().len() > 2;
        let solve = if is_turned { "hand-eye" } else { "tool-reflector" };
        self.doubt(phrase!("doubt-pose-of-robot", body = tag, solve));
    }

    /// Finds coordinates: sets of x, y and z whose headings differ only in the axis.
    pub(crate) fn coordinates(&mut self, table: &Table) {
        if !self.points.is_empty() {
            return;
        }
        let mut sets: Vec<Set> = Vec::new();
        let survey = survey_axes(table);
        for (i, column) in table.columns.iter().enumerate() {
            let free = self.taken[i].meaning == Meaning::Unknown && column.is_numeric();
            let of_survey = survey[i].clone();
            let named = || heading_axis(column).or_else(|| joined_axis(column, table));
            let Some((axis, tag)) = of_survey.or_else(named).filter(|_| free) else { continue };
            match sets.iter_mut().find(|set| set.points.tag == tag && set.points.columns[axis].is_none()) {
                Some(set) => set.points.columns[axis] = Some(i),
                None => {
                    let mut columns = [None; 3];
                    columns[axis] = Some(i);
                    // `ft` in front is a force and a torque, behind the axis it is feet
                    let is_force = column.heading.words.first().is_some_and(|word| word == "ft");
                    let is_other = column.heading.other_quantity || is_force || tag == "w";
                    let kind = if is_other { Kind::Other } else { kind_by_words(&tag) };
                    sets.push(Set { points: PointSet { tag, columns }, kind });
                }
            }
        }
        let axes = |set: &Set| set.points.columns.iter().flatten().count();
        // a coordinate of one axis counts only if there is no set of more axes
        let most = sets.iter().map(axes).max().unwrap_or(0);
        sets.retain(|set| {
            set.points.columns[0].is_some() && set.points.columns[1].is_some() || axes(set) == most && most < 2
        });
        by_other_sets(&mut sets, table);
        self.related_sets(&mut sets, table);
        self.bodies = sets.iter().map(|set| set.points.tag.clone()).collect();
        self.pose_of_controller(&mut sets, table);
        let others: Vec<&Set> = sets.iter().filter(|set| set.kind == Kind::Other).collect();
        for set in &others {
            for at in set.points.columns.iter().flatten() {
                let heading = &table.columns[*at].heading;
                if heading.has(Word::Uncertainty) {
                    self.taken[*at].meaning = Meaning::Unknown;
                }
            }
        }
        let of = |kind: Kind| sets.iter().filter(|set| set.kind == kind).cloned().collect::<Vec<Set>>();
        self.take_sets(
            table,
            &of(Kind::Commanded),
            &|axis| Meaning::Commanded(axis),
            &phrase!("why-commanded-heading"),
        );
        self.take_sets(
            table,
            &of(Kind::Difference),
            &|axis| Meaning::Difference(axis),
            &phrase!("why-difference-heading"),
        );
        let (measured, plain, named) = (of(Kind::Measured), of(Kind::Plain), of(Kind::Named));
        let points = match () {
            () if !measured.is_empty() => measured,
            () if !plain.is_empty() => plain,
            () => named,
        };
        for (number, set) in points.iter().enumerate() {
            let why = match set.kind {
                Kind::Measured => phrase!("why-measured-heading"),
                Kind::Named => phrase!("why-axes-differ"),
                _ => phrase!("why-heading"),
            };
            self.take_sets(table, std::slice::from_ref(set), &|axis| Meaning::Point(number, axis), &why);
        }
        self.points = points.into_iter().map(|set| set.points).collect();
        self.judge(&sets, table);
    }

    fn take_sets(&mut self, table: &Table, sets: &[Set], meaning: &dyn Fn(usize) -> Meaning, why: &Phrase) {
        for set in sets {
            for (axis, at) in set.points.columns.iter().enumerate() {
                let Some(at) = at else { continue };
                let why = match table.columns[*at].heading.unit {
                    Some(unit) => phrase!("why-in-unit", why, unit),
                    None => why.clone(),
                };
                self.take(*at, meaning(axis), why);
            }
        }
    }

    /// Finds the sets whose difference is a third one in all rows: commanded and measured values
    /// with their deviation, if the headings do not say which is which.
    fn related_sets(&mut self, sets: &mut [Set], table: &Table) {
        if sets.len() > MOST_RELATED {
            return;
        }
        let unnamed = |set: &Set| matches!(set.kind, Kind::Plain | Kind::Named);
        let triples = (0..sets.len()).flat_map(|a| (0..sets.len()).map(move |b| (a, b)));
        let triples = triples.flat_map(|(a, b)| (0..sets.len()).map(move |c| [a, b, c]));
        let is_related = |[a, b, c]: &[usize; 3]| {
            let kinds = [Kind::Plain, Kind::Named];
            let fits = |at: usize, more: Kind| kinds.contains(&sets[at].kind) || sets[at].kind == more;
            a != b
                && b != c
                && a != c
                && (unnamed(&sets[*a]) || unnamed(&sets[*b]) || unnamed(&sets[*c]))
                && fits(*a, Kind::Commanded)
                && fits(*b, Kind::Measured)
                && fits(*c, Kind::Difference)
                && are_differences(table, [*a, *b, *c].map(|at| &sets[at].points))
        };
        let Some([a, b, c]) = triples.clone().find(is_related) else { return };
        (sets[a].kind, sets[b].kind, sets[c].kind) = (Kind::Commanded, Kind::Measured, Kind::Difference);
        let columns = |at: usize| sets[at].points.columns.iter().flatten().map(|at| at + 1).collect::<Vec<usize>>();
        self.doubt(phrase!(
            "doubt-sets-by-difference",
            commanded = columns(a),
            measured = columns(b),
            difference = columns(c)
        ));
    }

    /// Asks which of several points is the measured one, if their headings are equal or their
    /// coordinates nearly agree in all rows.
    fn ask_about_sets(&mut self, table: &Table) {
        let alike = |i: usize, j: usize| {
            let (a, b) = (&self.points[i], &self.points[j]);
            target_name(&a.tag) == target_name(&b.tag) || nearly_agree(table, a, b)
        };
        let count = self.points.len();
        if let Some([first, second]) = self.in_two_frames(table).map(|pair| pair.map(|at| self.points[at].tag.clone()))
        {
            return self.ask(phrase!("ask-two-frames", first, second));
        }
        let pair = (0..count).flat_map(|i| (i + 1..count).map(move |j| (i, j))).find(|(i, j)| alike(*i, *j));
        let columns = |at: usize| self.points[at].columns.iter().flatten().map(|at| at + 1).collect::<Vec<usize>>();
        if let Some((i, j)) = pair {
            self.ask(phrase!("ask-sets-alike", first = columns(i), second = columns(j)));
        }
    }

    /// Gives each point the quaternion of its body; a quaternion of another body is not taken.
    pub(crate) fn own_orientations(&mut self) {
        let quaternions = std::mem::take(&mut self.orientations.quaternions);
        let mut left: Vec<(String, [usize; 4])> = quaternions.clone();
        for number in 0..self.points.len() {
            let of_point: Vec<String> = body(&self.points[number].tag).into_iter().map(str::to_owned).collect();
            let same = |(tag, _): &(String, [usize; 4])| body(tag) == of_point;
            // a heading that names no body is of the only point
            let alone = |(tag, _): &Quaternion| {
                number == 0 && (body(tag).is_empty() || of_point.is_empty()) && !self.is_of_another_body(tag)
            };
            // of equal headings those next to the coordinates
            let own = &self.points[number].columns;
            let gap = |columns: &[usize; 4]| {
                own.iter().flatten().flat_map(|at| columns.map(|of| of.abs_diff(*at))).min().unwrap_or(0)
            };
            let nearest = |fits: &dyn Fn(&Quaternion) -> bool| {
                (0..left.len()).filter(|at| fits(&left[*at])).min_by_key(|at| gap(&left[*at].1))
            };
            let Some(at) = nearest(&same).or_else(|| nearest(&alone)) else { continue };
            let (tag, columns) = left.remove(at);
            if body(&tag) != of_point && !body(&tag).is_empty() {
                self.doubt(phrase!("doubt-orientation-of-body", body = tag));
            }
            if number > 0 {
                self.orientations.of_points.push((number, columns));
            } else {
                self.orientations.quaternions.push((tag, columns));
            }
        }
        if self.points.is_empty() {
            self.orientations.quaternions = quaternions;
            return;
        }
        for (k, at) in left.iter().flat_map(|(_, columns)| columns.iter().enumerate()) {
            self.take(*at, Meaning::OtherOrientation(k), phrase!("why-other-body"));
        }
        for (k, at) in self.orientations.of_points.clone().iter().flat_map(|(_, columns)| columns.iter().enumerate()) {
            self.take(*at, Meaning::OtherOrientation(k), phrase!("why-heading-and-four"));
        }
    }

    /// `true` if the words before a component of an orientation name the measured body.
    pub(crate) fn is_of_own_body(&self, words: &str) -> bool {
        self.points.first().is_some_and(|point| body(words) == body(&point.tag))
    }

    /// `true` if the words before a component of an orientation name a body whose coordinates are
    /// another set than the measured point.
    pub(crate) fn is_of_another_body(&self, words: &str) -> bool {
        let named = body(words);
        let Some(point) = self.points.first().filter(|_| !named.is_empty()) else { return false };
        let is_named = |tag: &str| body(tag) == named;
        !is_named(&point.tag) && self.bodies.iter().any(|tag| is_named(tag))
            || !body(&point.tag).is_empty() && !is_named(&point.tag) && self.points.len() > 1
    }

    /// Adds doubts and questions about the coordinates.
    fn judge(&mut self, sets: &[Set], table: &Table) {
        self.ask_about_sets(table);
        let one = |kind: Kind| sets.iter().find(|set| set.kind == kind).map(|set| set.points.clone());
        self.commanded.beside = one(Kind::Commanded).filter(|_| !self.points.is_empty());
        if self.points.is_empty()
            && let Some(commanded) = one(Kind::Commanded)
        {
            self.commanded.difference = one(Kind::Difference);
            if self.commanded.difference.is_some() {
                self.ask(phrase!("ask-sign-of-difference"));
            }
            self.commanded.alone = Some(commanded);
        }
        let left: Vec<String> = sets
            .iter()
            .filter(|set| matches!(set.kind, Kind::Plain | Kind::Named) && !self.points.contains(&set.points))
            .map(|set| match set.points.tag.as_str() {
                "" => "x, y, z".to_owned(),
                tag => format!("`{tag}`"),
            })
            .collect();
        if !left.is_empty() && !self.points.is_empty() {
            self.doubt(phrase!("doubt-coordinates-left", left));
        }
        self.ask_about_controller(&left, table);
        let computed = |set: &&PointSet| {
            let mut words = set.tag.split(' ');
            words.clone().any(|word| OF_CONTROLLER.contains(&word))
                && !words.any(|word| word.len() > 1 && stands_for(word, Word::Measured))
        };
        if let Some(body) = self.points.iter().find(computed).map(|set| set.tag.clone()) {
            self.doubt(phrase!("doubt-controller-pose", body));
        }
        let bare = |set: &PointSet| set.columns.iter().flatten().any(|at| table.columns[*at].heading.bare_metre);
        if self.points.iter().any(bare) {
            self.doubt(phrase!("doubt-bare-metre"));
        }
    }

    /// `true` if the joints have these words in addition to their own: `measured` of `measured_q1`.
    fn are_words_of_joints(&self, words: &str, table: &Table) -> bool {
        let joints = self.joint_columns();
        let is_same = |at: &usize| {
            let of_column = table.columns[*at].heading.words.iter().map(String::as_str);
            let own: Vec<&str> =
                of_column.filter(|word| !stands_for(word, Word::Joint) && word.parse::<usize>().is_err()).collect();
            own.join(" ") == words
        };
        !words.is_empty() && joints.len() > 1 && joints.iter().all(is_same)
    }

    /// Takes the point of an instrument (`marker_x`) and not that of the controller: a set with the
    /// words of the joints (`measured_q1`, `measured_x`).
    fn pose_of_controller(&mut self, sets: &mut [Set], table: &Table) {
        const INSTRUMENTS: [&str; 5] = ["tracker", "laser", "optitrack", "vicon", "mocap"];
        let has_word = |set: &Set| {
            let is_target = |word: &str| INSTRUMENTS.contains(&word) || stands_for(word, Word::Target);
            matches!(set.kind, Kind::Named | Kind::Measured) && set.points.tag.split(' ').any(is_target)
        };
        let is_computed = |set: &Set| set.kind == Kind::Measured && self.are_words_of_joints(&set.points.tag, table);
        let Some(computed) = sets.iter().position(is_computed) else { return };
        let Some(used) = sets.iter().find(|set| has_word(set) && !is_computed(set)) else { return };
        let (body, used) = (sets[computed].points.tag.clone(), used.points.tag.clone());
        sets[computed].kind = Kind::Other;
        self.doubt(phrase!("doubt-computed-by-controller", body, used));
    }

    /// Asks whether an instrument measured the point, if its heading has the words of the joints
    /// and there are coordinates of another body.
    fn ask_about_controller(&mut self, left: &[String], table: &Table) {
        let Some(point) = self.points.first().map(|set| set.tag.clone()) else { return };
        if !left.is_empty() && self.are_words_of_joints(&point, table) {
            self.ask(phrase!("ask-computed-by-controller", body = point, others = left.to_vec()));
        }
    }

    /// Interprets columns without headings.
    ///
    /// Texts in front are the label. Values identify quaternions, rotation matrices, directions and
    /// times. The first other numbers are x, y and z.
    pub(crate) fn by_position(&mut self, table: &Table) {
        let set = |found: &mut Self, at: usize, meaning: Meaning, why: Phrase| found.take(at, meaning, why);
        let numeric: Vec<usize> = (0..table.columns.len()).filter(|i| table.columns[*i].is_numeric()).collect();
        let leading = numeric.first().copied().unwrap_or(0);
        for (i, column) in table.columns.iter().enumerate().filter(|(_, column)| !column.is_numeric()) {
            if column.clock && column.texts != [""] && !column.texts.is_empty() {
                self.clock(i, column);
                continue;
            }
            let is_constant = table.rows > 1 && column.texts.len() == 1;
            let (meaning, why) = match () {
                () if column.texts.is_empty() || column.texts == [""] => (Meaning::Text, phrase!("why-empty")),
                () if i < leading && is_constant && self.first(Meaning::Target).is_none() => {
                    self.ask(phrase!("ask-text-in-all-rows", text = column.texts[0]));
                    (Meaning::Target, phrase!("why-text-in-all-rows"))
                }
                () if i < leading => (Meaning::Label, phrase!("why-text-before")),
                () => (Meaning::Text, phrase!("why-text-behind")),
            };
            let number = |cell: &str| cell.trim().replace(',', ".").parse::<f64>().is_ok();
            let count = column.cells.iter().filter(|cell| number(cell)).count();
            if 2 * count > column.cells.len() {
                let text = column.cells.iter().find(|cell| !number(cell)).map_or("", |cell| cell);
                self.doubt(phrase!("doubt-numbers-and-text", column = i + 1, count, rows = column.cells.len(), text));
            }
            set(self, i, meaning, why);
        }
        // a text between the numbers divides them: they are not the joints of one robot
        let is_divided = numeric.windows(2).any(|pair| pair[1] - pair[0] > 1);
        let mut rest = numeric;
        if table.rows == 1 && rest.len() > MOST_IN_ROW {
            return self.doubt(phrase!("doubt-one-row", count = rest.len()));
        }
        let are_named = rest.len() > MOST_IN_ROW && table.rows <= MOST_IN_ROW && are_names_of_columns(table);
        if rest.len() > WIDE && rest.len() > 10 * table.rows || are_named {
            return self.doubt(phrase!("doubt-transposed", rows = table.rows, columns = rest.len()));
        }
        if self.matrices_by_position(table, &rest) {
            return;
        }
        self.constants_in_front(table, &mut rest);
        // a running number or a time in front
        let before = rest.len() % 3 == 1 && rest.len() > 3 || rest.len() == 8 || rest.len() == 5;
        let first = rest.first().map(|i| &table.columns[*i]);
        let increases =
            |column: &&Column| column.is_increasing() || column.is_ordered() && column.epoch_unit().is_some();
        if let Some(column) = first.filter(|column| before && increases(column) && !column.is_constant()) {
            let quaternion = rest.len() == 7 && table.are_unit([rest[3], rest[4], rest[5], rest[6]]);
            let cloud = self.are_scanned(table, &rest);
            if !quaternion && !cloud {
                // behind the name of a target
                let counted = if self.first(Meaning::Target).is_some() { Meaning::Pose } else { Meaning::Count };
                match column.is_counter() || column.counts_mostly() {
                    true => set(self, rest[0], counted, phrase!("why-counts")),
                    false => {
                        set(self, rest[0], Meaning::Time, phrase!("why-increases"));
                        self.doubt(phrase!("doubt-first-increases"));
                    }
                }
                rest.remove(0);
            }
        } else if (rest.len() % 3 == 1 || is_divided && rest.len() > 3)
            && first.is_some_and(Column::is_whole)
            && rest[1..].iter().take(3).all(|i| !table.columns[*i].is_whole())
        {
            set(self, rest[0], Meaning::Count, phrase!("why-whole-before-decimals"));
            rest.remove(0);
        }
        self.by_count(table, &rest, is_divided);
    }

    /// Recognises running numbers and constants in front of many numbers.
    fn constants_in_front(&mut self, table: &Table, rest: &mut Vec<usize>) {
        while let Some(at) = rest.first().copied().filter(|_| rest.len() > FEWEST_OF_POINTS) {
            let column = &table.columns[at];
            match () {
                () if column.is_counter() => self.take(at, Meaning::Count, phrase!("why-counts")),
                () if column.is_whole() && column.is_constant() => {
                    self.take(at, Meaning::Count, phrase!("why-constant"));
                }
                () => return,
            }
            rest.remove(0);
        }
    }

    /// Takes many numbers for the points of a row, three numbers each, as a question.
    pub(crate) fn points_in_row(&mut self, rest: &[usize]) {
        for (number, at) in rest.chunks_exact(3).enumerate() {
            at.iter()
                .enumerate()
                .for_each(|(axis, at)| self.take(*at, Meaning::Point(number, axis), phrase!("why-place")));
            let columns = [Some(at[0]), Some(at[1]), Some(at[2])];
            self.points.push(PointSet { tag: (number + 1).to_string(), columns });
        }
        self.ask(phrase!("ask-points-in-row", count = rest.len() / 3, numbers = rest.len()));
    }

    /// Interprets the numbers of a row by their count and values; a text may divide them.
    fn by_count(&mut self, table: &Table, rest: &[usize], is_divided: bool) {
        if self.are_scanned(table, rest) {
            self.point_at(&rest[..3]);
            rest[3..].iter().for_each(|at| self.take(*at, Meaning::Appearance, phrase!("why-colours")));
            return self.doubt(phrase!("doubt-scanned"));
        }
        let set = |found: &mut Self, at: usize, meaning: Meaning, why: Phrase| found.take(at, meaning, why);
        match *rest {
            [x, y, z, a, b, c, d] if table.are_unit([a, b, c, d]) => {
                self.point_at(&[x, y, z]);
                for (k, at) in [d, a, b, c].into_iter().enumerate() {
                    set(self, at, Meaning::Quaternion(k), phrase!("why-four-of-length-one"));
                }
                self.doubt_until(Evidence::Orientations, phrase!("doubt-quaternion-order"));
            }
            [x, y, z, i, j, k] if table.are_unit([i, j, k]) => {
                self.point_at(&[x, y, z]);
                for (n, at) in [i, j, k].into_iter().enumerate() {
                    set(self, at, Meaning::Direction(n), phrase!("why-three-of-length-one"));
                }
            }
            [x, y, z, a, b, c]
                if [x, y, z].iter().any(|i| table.columns[*i].largest() > 361.0) && self.has_no_text() =>
            {
                self.point_at(&[x, y, z]);
                for (n, at) in [a, b, c].into_iter().enumerate() {
                    set(self, at, Meaning::Rotation(n), phrase!("why-behind-lengths"));
                }
                self.ask_until(Evidence::Orientations, phrase!("ask-rotation"));
                self.doubt_until(Evidence::JointOrder, phrase!("doubt-six-without-headings"));
            }
            [_, _, _, _, _, _] | [_, _, _, _, _, _, _] if self.has_no_text() && !is_divided => {
                for (k, at) in rest.iter().enumerate() {
                    set(self, *at, Meaning::Joint(k), phrase!("why-as-many-as-joints"));
                }
                self.doubt_until(Evidence::JointOrder, phrase!("doubt-joints-without-headings", count = rest.len()));
            }
            [_, _] | [_, _, _] => self.point_at(rest),
            [..] if rest.len() >= FEWEST_OF_POINTS && rest.len().is_multiple_of(3) => self.points_in_row(rest),
            [x, y, z, ..] => {
                let is_long = rest.len() > MOST_OF_POINT;
                // behind a name, or in front of a direction, the first three are the point, unless
                // the numbers are as many as those of an arm and a point
                let copy = repeated_point(table, rest);
                let is_named = !self.has_no_text() && (rest.len() < FEWEST_OF_ARM || copy.is_some());
                if !is_long || is_named || has_direction(table, &rest[3..]) {
                    self.point_at(&[x, y, z]);
                    if let Some(second) = copy {
                        let first = [x, y, z].map(|at| at + 1).to_vec();
                        self.ask(phrase!("ask-sets-alike", first, second = second.map(|at| at + 1).to_vec()));
                    }
                }
                if is_long {
                    self.ask_until(Evidence::JointOrder, phrase!("ask-numbers-without-headings", count = rest.len()));
                }
            }
            _ => {}
        }
    }

    /// `true` for the numbers of a scanned point: its coordinates, its intensity or none, and three
    /// whole numbers up to 255, its colour.
    fn are_scanned(&self, table: &Table, rest: &[usize]) -> bool {
        let [.., r, g, b] = *rest else { return false };
        let is_colour = |at: usize| {
            let (low, high) = table.columns[at].range();
            table.columns[at].is_whole() && low >= 0.0 && high <= 255.0
        };
        let fractional = |at: &usize| !table.columns[*at].is_whole();
        let varied = [r, g, b].iter().any(|at| !table.columns[*at].is_constant());
        let number = matches!(rest.len(), 6 | 7) && [r, g, b].into_iter().all(is_colour) && varied;
        number && self.has_no_text() && rest[..3].iter().all(fractional)
    }

    fn has_no_text(&self) -> bool {
        !self.taken.iter().any(|taken| matches!(taken.meaning, Meaning::Label | Meaning::Target))
    }

    fn point_at(&mut self, at: &[usize]) {
        let mut columns = [None; 3];
        for (axis, at) in at.iter().enumerate() {
            columns[axis] = Some(*at);
            self.take(*at, Meaning::Point(0, axis), phrase!("why-place"));
        }
        self.points.push(PointSet { tag: String::new(), columns });
    }

    /// Finds a 4×4 or 3×4 matrix (row by row), or a point and a 3×3 matrix, at the end of the row.
    fn matrices_by_position(&mut self, table: &Table, numeric: &[usize]) -> bool {
        let at = |from: usize, k: usize| numeric[from + k];
        for (length, step) in [(16, 4), (12, 4), (9, 3)] {
            let Some(from) = numeric.len().checked_sub(length) else { continue };
            let rotation: [usize; 9] = std::array::from_fn(|k| at(from, step * (k / 3) + k % 3));
            if !table.are_rotations(rotation) {
                continue;
            }
            for (k, column) in rotation.into_iter().enumerate() {
                self.take(column, Meaning::Matrix(k / 3, k % 3), phrase!("why-orthonormal"));
            }
            // perhaps behind a number of the row or a time; of more numbers none is known
            match step {
                4 => self.point_at(&[at(from, 3), at(from, 7), at(from, 11)]),
                _ if from == 3 || from == 4 => self.point_at(&numeric[from - 3..from]),
                _ => {}
            }
            if length == 16 {
                for k in 12..16 {
                    self.take(at(from, k), Meaning::MatrixEnd, phrase!("why-row-0001"));
                }
            }
            self.doubt_until(Evidence::JointOrder, phrase!("doubt-matrix-order"));
            return true;
        }
        false
    }
}
