//! Meaning of each column of a table with its reason: headings, their units, values, and relations
//! between columns.

use crate::propose::headings::{Heading, Word, stands_for};
use crate::propose::table::{Column, Table, heading_axis};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;
use etalon_tables::guess::Guess;
use etalon_tables::unit_word;
use std::collections::{BTreeMap, BTreeSet};

/// Meaning of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Meaning {
    Unknown,
    Text,
    Label,
    Target,
    Pose,
    Cycle,
    Count,
    Time,
    /// Date and time of day.
    Clock,
    /// Time of day alone.
    TimeOfDay,
    /// Date alone.
    Day,
    /// Coordinate of a measured point: number of the point, and axis.
    Point(usize, usize),
    Commanded(usize),
    Difference(usize),
    Direction(usize),
    /// Component of a quaternion: w, x, y, z.
    Quaternion(usize),
    /// Component of a rotation vector, or angle.
    Rotation(usize),
    Matrix(usize, usize),
    /// Last row of a 4×4 matrix.
    MatrixEnd,
    Joint(usize),
    OtherJoint,
    Uncertainty(usize),
    ExpandedUncertainty(usize),
    Azimuth,
    Zenith,
    Elevation,
    Distance,
    Temperature,
    Deleted,
    Motion,
    /// Uncertainty or scatter of a point that no coordinate has.
    Scatter,
    /// Component of a quaternion (0 to 3) or a matrix (4 to 12) of another body than the first
    /// measured point.
    OtherOrientation(usize),
    /// Intensity or colour of a scanned point.
    Appearance,
}

impl Meaning {
    /// Returns the meaning in words.
    pub fn words(self) -> Phrase {
        const AXES: [&str; 3] = ["x", "y", "z"];
        let axis = |at: usize| AXES.get(at).copied().unwrap_or("?");
        match self {
            Self::Unknown => phrase!("means-unknown"),
            Self::Text => phrase!("means-text"),
            Self::Label => phrase!("means-label"),
            Self::Target => phrase!("means-target"),
            Self::Pose => phrase!("means-pose"),
            Self::Cycle => phrase!("means-cycle"),
            Self::Count => phrase!("means-count"),
            Self::Time => phrase!("means-time"),
            Self::Clock => phrase!("means-clock"),
            Self::TimeOfDay => phrase!("means-time-of-day"),
            Self::Day => phrase!("means-day"),
            Self::Point(0, at) => phrase!("means-measured", axis = axis(at)),
            Self::Point(set, at) => phrase!("means-measured-of-point", axis = axis(at), number = set + 1),
            Self::Commanded(at) => phrase!("means-commanded", axis = axis(at)),
            Self::Difference(at) => phrase!("means-difference", axis = axis(at)),
            Self::Direction(at) => phrase!("means-direction", component = ["i", "j", "k"][at.min(2)]),
            Self::Quaternion(at) => phrase!("means-quaternion", component = ["qw", "qx", "qy", "qz"][at.min(3)]),
            Self::Rotation(at) => phrase!("means-rotation", number = at + 1),
            Self::Matrix(i, j) => phrase!("means-matrix", row = i + 1, column = j + 1),
            Self::MatrixEnd => phrase!("means-matrix-end"),
            Self::Joint(at) => phrase!("means-joint", number = at + 1),
            Self::OtherJoint => phrase!("means-other-joint"),
            Self::Uncertainty(at) => phrase!("means-uncertainty", number = at + 1),
            Self::ExpandedUncertainty(at) => phrase!("means-expanded-uncertainty", axis = axis(at)),
            Self::Azimuth => phrase!("means-azimuth"),
            Self::Zenith => phrase!("means-zenith"),
            Self::Elevation => phrase!("means-elevation"),
            Self::Distance => phrase!("means-distance"),
            Self::Temperature => phrase!("means-temperature"),
            Self::Deleted => phrase!("means-deleted"),
            Self::Motion => phrase!("means-motion"),
            Self::Scatter => phrase!("means-scatter"),
            Self::OtherOrientation(at) => {
                const COMPONENTS: [&str; 13] =
                    ["qw", "qx", "qy", "qz", "r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"];
                phrase!("means-other-orientation", component = COMPONENTS[at.min(12)])
            }
            Self::Appearance => phrase!("means-appearance"),
        }
    }

    /// Returns the number of the joint, from 1, of a column of joint values.
    pub fn joint_number(self) -> Option<usize> {
        if let Self::Joint(at) = self { Some(at + 1) } else { None }
    }
}

/// Meaning of a column, and its reason.
#[derive(Clone, Debug)]
pub(crate) struct Taken {
    pub meaning: Meaning,
    pub why: Option<Phrase>,
}

/// Point in each row: its name in the headings, and its columns.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct PointSet {
    pub tag: String,
    pub columns: [Option<usize>; 3],
}

/// Form of three numbers of a rotation, as far as it is known.
#[derive(Clone, Debug, Default)]
pub(crate) struct RotationForm {
    /// Value of `rotation`: an order of angles, or a rotation vector.
    pub order: Option<String>,
    /// Unit: `deg` or `rad`.
    pub unit: Option<&'static str>,
}

/// Commanded point of each row.
#[derive(Clone, Debug, Default)]
pub(crate) struct CommandedPoint {
    /// Commanded point, from which the measured point is computed with the difference.
    pub alone: Option<PointSet>,
    /// Commanded point beside a measured one.
    pub beside: Option<PointSet>,
    /// Difference between commanded and measured point.
    pub difference: Option<PointSet>,
}

/// Columns of orientations.
#[derive(Clone, Debug, Default)]
pub(crate) struct Orientations {
    /// Quaternions: words of their headings, and columns, the scalar first.
    pub quaternions: Vec<(String, [usize; 4])>,
    /// Quaternions of further measured points: number of the point, and columns.
    pub of_points: Vec<(usize, [usize; 4])>,
    /// Form of the columns of a rotation.
    pub rotation: RotationForm,
}

/// Column of times.
#[derive(Clone, Debug, Default)]
pub(crate) struct Clock {
    /// Unit, if the heading or the values state one.
    pub unit: Option<&'static str>,
    /// Question about a unit that neither states.
    pub question: Option<Phrase>,
    /// Whole seconds and their fractions in two columns.
    pub fractions: Option<Fractions>,
}

/// Interpretation of a table.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interpretation {
    /// Meaning of each column.
    pub taken: Vec<Taken>,
    /// Measured points.
    pub points: Vec<PointSet>,
    /// Commanded points.
    pub commanded: CommandedPoint,
    /// Words of the headings of all sets of coordinates, without the axis.
    pub bodies: Vec<String>,
    /// Orientations of the measured points.
    pub orientations: Orientations,
    /// Times of the rows.
    pub clock: Clock,
    /// Names of the joints in robot.toml; empty if no robot was given.
    pub joint_names: Vec<String>,
    /// Columns of joints that count in the opposite direction.
    pub reversed: Vec<usize>,
    /// `true` if a log of joints stands beside the file: its points are measured.
    pub is_beside_log: bool,
    /// `true` if the kinematics of the nominal robot support the units.
    pub by_kinematics: bool,
    pub doubts: Vec<Doubt>,
    pub questions: Vec<Doubt>,
}

/// Doubt or question about an interpretation.
#[derive(Clone, Debug)]
pub(crate) struct Doubt {
    pub text: Phrase,
    /// Evidence that resolves the doubt, if any can.
    settled_by: Option<Evidence>,
}

/// Evidence that resolves doubts: of a nominal robot that reproduces the points, or of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Evidence {
    /// Columns and order of the joints.
    JointOrder,
    /// Orientations of the flange, which fit one order of the components of a quaternion, or one
    /// form of three numbers of a rotation.
    Orientations,
    /// Column of an angle from the vertical or the horizontal.
    VerticalAngle,
}

impl Interpretation {
    /// Adds a doubt.
    pub fn doubt(&mut self, text: Phrase) {
        self.doubts.push(Doubt { text, settled_by: None });
    }

    /// Adds a doubt that this evidence can resolve.
    pub fn doubt_until(&mut self, evidence: Evidence, text: Phrase) {
        self.doubts.push(Doubt { text, settled_by: Some(evidence) });
    }

    /// Adds a question.
    pub fn ask(&mut self, text: Phrase) {
        self.questions.push(Doubt { text, settled_by: None });
    }

    /// Adds a question that the kinematics of the robot can resolve.
    pub fn ask_until(&mut self, evidence: Evidence, text: Phrase) {
        self.questions.push(Doubt { text, settled_by: Some(evidence) });
    }

    /// `true` if a doubt or a question waits for this evidence.
    pub fn waits_for(&self, evidence: Evidence) -> bool {
        self.doubts.iter().chain(&self.questions).any(|doubt| doubt.settled_by == Some(evidence))
    }

    /// Removes the doubts and questions that this evidence resolves.
    pub fn settle(&mut self, evidence: Evidence) {
        for list in [&mut self.doubts, &mut self.questions] {
            list.retain(|doubt| doubt.settled_by != Some(evidence));
        }
    }

    /// Interpretation of a table whose columns are not yet known.
    pub fn unknown(table: &Table) -> Self {
        let nothing = Taken { meaning: Meaning::Unknown, why: None };
        Self { taken: vec![nothing; table.columns.len()], ..Self::default() }
    }

    /// Interprets a table.
    pub fn new(table: &Table) -> Self {
        let mut found = Self::unknown(table);
        if table.columns.iter().any(|column| column.name.is_some()) {
            found.texts(table);
            found.matrix(table);
            found.numbered_matrix(table);
            found.quaternion(table);
            found.joints(table);
            found.coordinates(table);
            found.own_orientations();
            found.rotations(table);
            found.singles(table);
            found.rest(table);
            found.vertical_angle(table);
            found.poses_of_robot(table);
        } else {
            found.by_position(table);
        }
        found.whole_seconds(table);
        found.clock_unit(table);
        found.number_with_gaps(table);
        found.numbers_of_poses(table);
        found
    }

    /// Gives coordinates without a unit in their heading the unit of length in the head of the
    /// file; two different units are a doubt.
    pub fn unit_of_head(&mut self, table: &mut Table, guess: &Guess) {
        let Some(first) = guess.stated_units.first() else { return };
        if let Some(other) = guess.stated_units.iter().find(|stated| stated.unit != first.unit) {
            let (line, unit, second, of_second) = (first.line, first.unit, other.line, other.unit);
            return self.doubt(phrase!("doubt-units-differ", line, unit, second, of_second));
        }
        for (column, taken) in table.columns.iter_mut().zip(&self.taken) {
            let is_length = matches!(
                taken.meaning,
                Meaning::Point(..) | Meaning::Commanded(_) | Meaning::Difference(_) | Meaning::Distance
            );
            if is_length && column.heading.unit.is_none() {
                column.heading.unit = Some(first.unit);
            }
        }
    }

    /// `true` if coordinates or joints stand behind a text that opens a bracket, up to the text
    /// that closes it: they are numbers of a list.
    pub fn is_within_lists(&self, table: &Table) -> bool {
        const OPEN: [char; 3] = ['[', '(', '{'];
        const CLOSED: [char; 3] = [']', ')', '}'];
        let bracketed = |column: &Column| {
            column.cells.iter().find(|cell| cell.contains(OPEN) || cell.contains(CLOSED)).map(ToString::to_string)
        };
        let texts = table.columns.iter().enumerate().filter_map(|(at, column)| Some((at, bracketed(column)?)));
        let mut open: Option<usize> = None;
        let mut lists: Vec<(usize, usize)> = Vec::new();
        for (at, text) in texts {
            let (opened, closed) = (text.matches(OPEN).count(), text.matches(CLOSED).count());
            if let Some(from) = open.filter(|_| closed > 0) {
                lists.push((from, at));
                open = None;
            }
            // a number directly behind the bracket: a list that another row closes
            let is_number = |rest: &str| rest.starts_with(|c: char| c.is_ascii_digit() || matches!(c, '-' | '.'));
            let is_list = text.split(OPEN).skip(1).any(is_number);
            open = open.or(Some(at).filter(|_| opened > closed && is_list));
        }
        lists.extend(open.map(|from| (from, self.taken.len())));
        let is_open = self.points.is_empty() && self.joint_columns().is_empty();
        let is_used = |at: usize| match self.taken[at].meaning {
            Meaning::Point(..) | Meaning::Joint(_) => true,
            Meaning::Unknown => is_open && table.columns[at].is_numeric(),
            _ => false,
        };
        (0..self.taken.len()).any(|at| is_used(at) && lists.iter().any(|(from, to)| (*from..*to).contains(&at)))
    }

    /// Returns the columns for which `number` gives a number, in the order of the numbers.
    pub fn columns(&self, number: impl Fn(Meaning) -> Option<usize>) -> Vec<usize> {
        let mut all: Vec<(usize, usize)> =
            self.taken.iter().enumerate().filter_map(|(i, taken)| Some((number(taken.meaning)?, i))).collect();
        all.sort_unstable();
        all.into_iter().map(|(_, i)| i).collect()
    }

    /// Returns the first column with this meaning.
    pub fn first(&self, meaning: Meaning) -> Option<usize> {
        self.taken.iter().position(|taken| taken.meaning == meaning)
    }

    /// Returns the commanded point of each row.
    pub fn commanded_point(&self) -> Option<&PointSet> {
        self.commanded.alone.as_ref().or(self.commanded.beside.as_ref())
    }

    /// Returns the columns of the joints in order.
    pub fn joint_columns(&self) -> Vec<usize> {
        self.columns(|meaning| if let Meaning::Joint(k) = meaning { Some(k) } else { None })
    }

    /// Returns the columns of the quaternion, w first.
    pub fn quaternion_columns(&self) -> Vec<usize> {
        self.columns(|meaning| if let Meaning::Quaternion(k) = meaning { Some(k) } else { None })
    }

    /// Returns the columns of a rotation vector or of angles.
    pub fn rotation_columns(&self) -> Vec<usize> {
        self.columns(|meaning| if let Meaning::Rotation(k) = meaning { Some(k) } else { None })
    }

    /// Returns the columns of a rotation matrix, row by row.
    pub fn matrix_columns(&self) -> Vec<usize> {
        self.columns(|meaning| if let Meaning::Matrix(i, j) = meaning { Some(3 * i + j) } else { None })
    }

    pub(crate) fn take(&mut self, at: usize, meaning: Meaning, why: Phrase) {
        self.taken[at] = Taken { meaning, why: Some(why) };
    }

    fn is_free(&self, at: usize) -> bool {
        self.taken[at].meaning == Meaning::Unknown
    }

    /// Returns the columns of numbers without a meaning so far.
    fn free<'a>(&'a self, table: &'a Table) -> impl Iterator<Item = (usize, &'a Column)> + 'a {
        table.columns.iter().enumerate().filter(|(i, column)| self.is_free(*i) && column.is_numeric())
    }

    /// Interprets a column of dates or times of day.
    pub(crate) fn clock(&mut self, at: usize, column: &Column) {
        let all = |mark: &str| column.texts.iter().all(|text| text.contains(mark));
        let dated = column.texts.iter().all(|text| text.matches(['.', '-', '/']).count() >= 2);
        let meaning = match (all(":"), dated) {
            (true, true) => Meaning::Clock,
            (true, false) => Meaning::TimeOfDay,
            (false, _) => Meaning::Day,
        };
        if all("/") {
            self.doubt(phrase!("doubt-dates"));
            return self.take(at, Meaning::Text, phrase!("why-ambiguous-dates"));
        }
        self.take(at, meaning, phrase!("why-dates"));
    }

    /// Interprets columns of text.
    fn texts(&mut self, table: &Table) {
        for (i, column) in table.columns.iter().enumerate().filter(|(_, column)| !column.is_numeric()) {
            let heading = &column.heading;
            let single = |meaning: Word| heading.words.last().is_some_and(|word| stands_for(word, meaning));
            let by_name = || phrase!("why-heading");
            match () {
                () if column.texts.is_empty() || column.texts == [""] => {
                    self.take(i, Meaning::Text, phrase!("why-empty"));
                }
                () if column.clock => self.clock(i, column),
                () if heading.has(Word::Deleted) => self.take(i, Meaning::Deleted, by_name()),
                () if heading.has(Word::Pose) => self.take(i, Meaning::Pose, by_name()),
                () if single(Word::Target) || heading.is_only(&[Word::Target]) => {
                    self.take(i, Meaning::Target, by_name());
                }
                () if heading.has(Word::Label) && !self.taken.iter().any(|t| t.meaning == Meaning::Label) => {
                    self.take(i, Meaning::Label, by_name());
                }
                () if heading.has(Word::Cycle) => self.take(i, Meaning::Text, phrase!("why-repeats-as-texts")),
                () => self.take(i, Meaning::Text, phrase!("why-nothing-known")),
            }
        }
        let named = |meanings: &[Meaning]| self.taken.iter().any(|t| meanings.contains(&t.meaning));
        let is_text = |column: &Column| {
            let is_time = column.clock || column.heading.is_only(&[Word::Time, Word::Date]);
            !column.is_numeric() && !is_time && column.texts != [""]
        };
        let varies = |column: &Column| column.distinct_in_rows(table) > 1.max(table.rows.min(4) / 2);
        if !named(&[Meaning::Label, Meaning::Target, Meaning::Pose])
            && let Some(first) = table.columns.iter().position(is_text)
            && table.columns[..first].iter().all(|c| c.is_numeric() && c.is_whole())
            && varies(&table.columns[first])
        {
            self.take(first, Meaning::Label, phrase!("why-texts-differ"));
        }
    }

    /// Finds nine columns that one word and the numbers from 0 or 1 on name, if they are a rotation
    /// matrix, row by row, in all rows.
    fn numbered_matrix(&mut self, table: &Table) {
        let numbered = |column: &Column| match &column.heading.words[..] {
            [before @ .., number] if !before.is_empty() => Some((before.join(" "), number.parse::<usize>().ok()?)),
            _ => None,
        };
        let all: Vec<(usize, (String, usize))> =
            self.free(table).filter_map(|(i, column)| Some((i, numbered(column)?))).collect();
        let first = all.iter().filter(|(_, (_, number))| *number < 2);
        // a heading that occurs several times belongs to the matrix in front of it
        let columns = |start: usize, tag: &str, from: usize| -> Option<[usize; 9]> {
            let is_part =
                |(i, (of, n)): &&(usize, (String, usize)), k: usize| *i >= start && of == tag && *n == from + k;
            let at = |k: usize| all.iter().find(|column| is_part(column, k)).map(|(i, _)| *i);
            (0..9).map(at).collect::<Option<Vec<usize>>>()?.try_into().ok()
        };
        let found = first.filter_map(|(i, (tag, from))| columns(*i, tag, *from)).filter(|at| table.are_rotations(*at));
        for (number, rotation) in found.enumerate() {
            for (k, column) in rotation.into_iter().enumerate() {
                match number {
                    0 => self.take(column, Meaning::Matrix(k / 3, k % 3), phrase!("why-nine-orthonormal")),
                    _ => self.take(column, Meaning::OtherOrientation(4 + k), phrase!("why-nine-orthonormal")),
                }
            }
        }
    }

    /// Finds the elements of a matrix: headings that end in two digits, `m_00` or `r11`.
    fn matrix(&mut self, table: &Table) {
        let place = |column: &Column| -> Option<(String, usize, usize)> {
            let words = &column.heading.words;
            let last = words.last()?;
            let mut digits: Vec<usize> = last.chars().map_while(|c| c.to_digit(10)).map(|d| d as usize).collect();
            let mut tag = &words[..words.len() - 1];
            if digits.len() == 1 && tag.last().is_some_and(|word| word.len() == 1 && word.parse::<u8>().is_ok()) {
                // `r_1_1`
                digits.insert(0, tag.last()?.parse().ok()?);
                tag = &tag[..tag.len() - 1];
            }
            (digits.len() == 2 && !tag.is_empty()).then(|| (tag.join(" "), digits[0], digits[1]))
        };
        let places: Vec<(usize, (String, usize, usize))> =
            self.free(table).filter_map(|(i, column)| Some((i, place(column)?))).collect();
        let mut tags: Vec<&String> = places.iter().map(|(_, (tag, ..))| tag).collect();
        tags.dedup();
        for tag in tags {
            for base in [0, 1] {
                let at = |i: usize, j: usize| {
                    let found = places.iter().find(|(_, (t, r, c))| t == tag && (*r, *c) == (i + base, j + base));
                    found.map(|(column, _)| *column)
                };
                let rotation: Option<Vec<usize>> = (0..9).map(|k| at(k / 3, k % 3)).collect();
                let Some(rotation) = rotation.and_then(|all| <[usize; 9]>::try_from(all).ok()) else { continue };
                if !table.are_rotations(rotation) {
                    continue;
                }
                for (k, column) in rotation.into_iter().enumerate() {
                    self.take(column, Meaning::Matrix(k / 3, k % 3), phrase!("why-nine-orthonormal"));
                }
                let moved = [0, 1, 2].map(|i| at(i, 3));
                if moved.iter().all(Option::is_some) {
                    self.points.push(PointSet { tag: tag.clone(), columns: moved });
                    for (axis, column) in moved.into_iter().flatten().enumerate() {
                        self.take(column, Meaning::Point(0, axis), phrase!("why-last-of-matrix"));
                    }
                }
                for column in (0..4).filter_map(|j| at(3, j)) {
                    self.take(column, Meaning::MatrixEnd, phrase!("why-row-0001"));
                }
                return;
            }
        }
    }

    /// Finds the quaternions: four columns each, by their headings or by their values.
    fn quaternion(&mut self, table: &Table) {
        while self.next_quaternion(table) {}
        if self.orientations.quaternions.is_empty() {
            while self.quaternion_by_values(table) {}
        }
    }

    /// Takes the first four free columns whose headings name the components of a quaternion.
    fn next_quaternion(&mut self, table: &Table) -> bool {
        const FORMS: [[&str; 4]; 4] = [
            ["qw", "qx", "qy", "qz"],
            ["w", "x", "y", "z"],
            ["q 0", "q 1", "q 2", "q 3"],
            ["q w", "q x", "q y", "q z"],
        ];
        let mut tags: Vec<String> = Vec::new();
        let free: Vec<usize> = self.free(table).map(|(i, _)| i).collect();
        let joined = |i: usize| component_last(&table.columns[i].heading.words);
        for form in FORMS {
            for i in &free {
                let joined = joined(*i);
                let tag = joined.strip_suffix(form[0]).map(str::to_owned);
                tags.extend(tag.filter(|tag| tag.is_empty() || tag.ends_with(' ')));
            }
            for tag in &tags {
                let column = |name: &str| free.iter().copied().find(|i| joined(*i) == format!("{tag}{name}"));
                let Some(all) = form.iter().map(|name| column(name)).collect::<Option<Vec<usize>>>() else { continue };
                let Ok(all) = <[usize; 4]>::try_from(all) else { continue };
                let unit = table.are_unit(all);
                let numbered = form[0] == "q 0";
                if !unit && (numbered || form[0] == "w") {
                    continue;
                }
                let why = match unit {
                    true if numbered => {
                        phrase!("why-quaternion-not-joints")
                    }
                    true => phrase!("why-heading-and-four"),
                    false => phrase!("why-heading"),
                };
                if !unit {
                    self.doubt(phrase!("doubt-quaternion-length"));
                }
                if numbered && table.columns.len() == 4 {
                    self.doubt(phrase!("doubt-four-joints"));
                }
                for (k, at) in all.into_iter().enumerate() {
                    self.take(at, Meaning::Quaternion(k), why.clone());
                }
                self.orientations.quaternions.push((tag.trim().to_owned(), all));
                return true;
            }
        }
        false
    }

    /// Takes four neighbouring columns as a quaternion if the sum of their squares is 1 in all
    /// rows, whatever their headings are. Returns `true` if there are such columns.
    fn quaternion_by_values(&mut self, table: &Table) -> bool {
        let normal = ["nx", "ny", "nz", "n x", "n y", "n z", "normal x", "normal y", "normal z"];
        let without_unit = |(i, column): (usize, &Column)| {
            let is_free = column.heading.unit.is_none() || column.component_letter().is_some();
            (is_free && !normal.contains(&column.heading.joined().as_str())).then_some(i)
        };
        let free: Vec<usize> = self.free(table).filter_map(without_unit).collect();
        let neighbours = free.windows(4).filter_map(|four| <[usize; 4]>::try_from(four).ok());
        for all in neighbours.filter(|all| all[3] - all[0] == 3) {
            let headings = all.map(|at| &table.columns[at]);
            let named = components(headings);
            let repeated = named.is_none() && repeats_an_axis(headings);
            let varies = || {
                all.iter().any(|at| !table.columns[*at].is_constant())
                    && all.iter().all(|at| table.columns[*at].largest() > UNUSED)
            };
            // further quaternions are named
            let unsure = named.is_none() && !repeated && (!self.orientations.quaternions.is_empty() || !varies());
            if table.rows < FEWEST_ROWS || !table.are_unit(all) || unsure {
                continue;
            }
            // without a name of the scalar it is the first, or the axis that is named twice, as a
            // question
            let usual = if repeated { [1, 2, 3, 0] } else { [0, 1, 2, 3] };
            let mut ordered = all;
            for (at, k) in all.into_iter().zip(named.unwrap_or(usual)) {
                self.take(at, Meaning::Quaternion(k), phrase!("why-four-of-length-one"));
                ordered[k] = at;
            }
            let words = &table.columns[ordered[1]].heading.words;
            self.orientations.quaternions.push((words[..words.len().saturating_sub(1)].join(" "), ordered));
            if named.is_none() && self.orientations.quaternions.len() == 1 {
                let columns: Vec<String> = all.iter().map(|at| table.called(*at)).collect();
                let used = if repeated { "last" } else { "first" };
                self.ask_until(Evidence::Orientations, phrase!("ask-quaternion-order", columns, used));
            }
            return true;
        }
        false
    }
}

/// Returns the words of a heading with the component of a quaternion last: `1 qx` for `qx1`.
fn component_last(words: &[String]) -> String {
    match words {
        [before @ .., component, number]
            if ["qw", "qx", "qy", "qz"].contains(&component.as_str()) && number.parse::<usize>().is_ok() =>
        {
            [before, &[number.clone(), component.clone()]].concat().join(" ")
        }
        _ => words.join(" "),
    }
}

/// Minimum number of rows for a quaternion: in fewer rows, four numbers can have length 1 by
/// chance.
const FEWEST_ROWS: usize = 3;
/// Maximum magnitude of a column that holds no component: three others of length 1 are a direction.
const UNUSED: f64 = 1e-3;

/// Returns the component (w, x, y, z) that each of four headings names.
///
/// Three axes beside any fourth heading make it the scalar; numbers from 0 to 3 begin with the
/// scalar. Numbers from 1 to 4 do not give which is the scalar.
fn components(columns: [&Column; 4]) -> Option<[usize; 4]> {
    let number = |column: &Column| column.heading.words.last()?.parse::<usize>().ok();
    let numbers = columns.map(number);
    if (0..4).all(|k| numbers.contains(&Some(k))) {
        return Some(numbers.map(|number| number.unwrap_or(0)));
    }
    let component = |column: &Column| {
        match column.component_letter() {
            Some('k') => return Some(3),
            Some(_) => return None,
            None => {}
        }
        let last = column.heading.words.last()?;
        let axis = |word: &str| ["x", "y", "z"].iter().position(|axis| *axis == word).map(|axis| axis + 1);
        let imaginary = |word: &str| ["i", "j", "k"].iter().position(|unit| *unit == word).map(|unit| unit + 1);
        axis(last).or_else(|| axis(last.strip_prefix('q')?)).or_else(|| imaginary(last))
    };
    let mut found = columns.map(component);
    let holds = |found: &[Option<usize>; 4], k: usize| found.iter().filter(|at| **at == Some(k)).count() == 1;
    let axes = (1..4).all(|k| holds(&found, k));
    let other = found.iter_mut().find(|at| at.is_none()).filter(|_| axes)?;
    *other = Some(0);
    Some(found.map(|k| k.unwrap_or(0)))
}

/// `true` for the headings x, y, z and one of them again: a mistake for w.
fn repeats_an_axis(columns: [&Column; 4]) -> bool {
    let last = columns.map(|column| column.heading.words.last().map_or("", String::as_str));
    let axes = [["x", "y", "z"], ["qx", "qy", "qz"]];
    axes.iter().any(|axes| last[..3] == *axes && axes.contains(&last[3]))
}

/// Words in the names of joints that have no number.
const NAMED_JOINTS: [&str; 10] =
    ["forearm", "upperarm", "pan", "lift", "rail", "track", "swivel", "slew", "joint", "gelenk"];

/// Parts of an arm from its base on, in seven languages: the joints of controllers that name no
/// number.
const PARTS: [&str; 4] = [
    "base basis fuss fuß sockel socle pan waist taille cintura slew swivel 基座 机座 底座 腰 腰部 ベース",
    "shoulder schulter epaule hombro spalla lift 肩 肩部 肩关节 ショルダー",
    "elbow ellbogen ellenbogen coude codo gomito 肘 肘部 肘关节 エルボー エルボ",
    "wrist handgelenk poignet muneca polso 手腕 手首 腕 リスト",
];

/// Place of a named joint in an arm, from the base on; `None` for other words.
pub(crate) fn part_of_arm(heading: &Heading) -> Option<usize> {
    let part = |word: &String| PARTS.iter().position(|words| words.split(' ').any(|known| known == word));
    heading.words.iter().filter_map(part).min()
}

/// `true` if every word of a heading is a part of an arm, a joint, or a position.
fn is_part_alone(heading: &Heading) -> bool {
    let is_plain = |word: &String| {
        PARTS.iter().any(|words| words.split(' ').any(|known| known == word))
            || stands_for(word, Word::Joint)
            || POSITIONS.contains(&word.as_str())
    };
    part_of_arm(heading).is_some() && heading.words.iter().all(is_plain)
}

/// Returns the number of a joint that a letter names: `Theta A`, `Achse B`.
fn lettered_joint(heading: &Heading) -> Option<(String, usize)> {
    let [word, letter] = &heading.words[..] else { return None };
    let at = ('a'..='h').position(|known| *letter == known.to_string())?;
    (word.chars().count() > 1 && stands_for(word, Word::Joint)).then(|| (word.clone(), at + 1))
}

/// Words of a position or a value between a joint and its number.
const POSITIONS: [&str; 8] = ["pos", "position", "positions", "angle", "angles", "winkel", "value", "wert"];

/// Returns the words and the number of a joint in a heading.
fn joint_name(heading: &Heading) -> Option<(String, Option<usize>)> {
    const COUNTS: [&str; 6] = ["cnt", "count", "counter", "index", "state", "id"];
    let is_count = heading.words.iter().any(|word| COUNTS.contains(&word.as_str()));
    if heading.other_quantity
        || is_count
        || heading.has(Word::Motion) && !heading.has(Word::Joint)
        || heading.words.iter().any(|w| is_motion(w))
    {
        return None;
    }
    let numbers: Vec<usize> = (0..heading.words.len()).filter(|i| heading.words[*i].parse::<usize>().is_ok()).collect();
    let number = numbers.last().and_then(|i| heading.words[*i].parse().ok()).filter(|n| *n < 100);
    let tag = numbers.last().map_or(heading.words.clone(), |i| heading.without(*i));
    // a part of a body whose pose was measured: `R_Shoulder-qx`
    const COMPONENTS: [&str; 10] = ["x", "y", "z", "w", "px", "py", "pz", "qx", "qy", "qz"];
    let is_component = heading.words.last().is_some_and(|word| COMPONENTS.contains(&word.as_str()));
    let of_arm = part_of_arm(heading).is_some_and(|part| part > 0) && !is_component;
    let named = of_arm || heading.words.iter().any(|word| NAMED_JOINTS.contains(&word.as_str()));
    // `axis pos act 1`: words of the state and of positions stand between the joint and its number
    let before = heading.words[..numbers.last().copied().unwrap_or(0)].iter().map(String::as_str);
    let is_state = |word: &&str| {
        word.len() > 1 && (stands_for(word, Word::Measured) || stands_for(word, Word::Commanded))
            || POSITIONS.contains(word)
    };
    let before = before.rev().find(|word| !is_state(word));
    let is_joint = named || number.is_some() && before.is_some_and(|word| stands_for(word, Word::Joint));
    is_joint.then(|| (tag.join(" "), number))
}

/// `true` for the words of an encoder or a motor, whose counts belong to the angle of a joint.
fn is_encoder(tag: &str) -> bool {
    tag.split(' ').any(|word| ["enc", "encoder", "encoders", "counts", "motor", "mot"].contains(&word))
}

/// Returns the names of the parts of an arm whose coordinates the table has: three headings differ
/// in x, y and z alone, and no word names a joint.
fn measured_parts(table: &Table) -> BTreeSet<String> {
    let mut axes: BTreeMap<String, [bool; 3]> = BTreeMap::new();
    for column in table.columns.iter().filter(|column| !column.heading.has(Word::Joint)) {
        if let Some((axis, tag)) = heading_axis(column) {
            axes.entry(tag).or_default()[axis] = true;
        }
    }
    axes.into_iter().filter(|(tag, has)| !tag.is_empty() && *has == [true; 3]).map(|(tag, _)| tag).collect()
}

/// Whole seconds and the column of their fractions: `sec` and `nanosec`, as ROS writes them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fractions {
    pub seconds: usize,
    pub column: usize,
    /// Count of the fractions in a second.
    pub per_second: f64,
}

impl Fractions {
    /// Finds the first two such columns, whose headings differ in the unit alone.
    pub fn new(table: &Table) -> Option<Self> {
        let part = |column: &Column| -> Option<(Vec<String>, &'static str)> {
            let Heading { words, unit, .. } = &column.heading;
            let of_word = || Some((words[..words.len().checked_sub(1)?].to_vec(), unit_word(words.last()?)?));
            let named = unit.map(|unit| (words.clone(), unit)).or_else(of_word);
            named.filter(|_| column.is_whole() && column.range().0 >= 0.0)
        };
        let parts: Vec<Option<(Vec<String>, &str)>> = table.columns.iter().map(part).collect();
        let of = |stem: &[String], column: usize| {
            let (words, unit) = parts[column].as_ref()?;
            let (_, per_second) = [("ns", 1e9), ("us", 1e6), ("ms", 1e3)].into_iter().find(|(of, _)| of == unit)?;
            (*words == stem && table.columns[column].largest() < per_second).then_some(per_second)
        };
        (0..parts.len()).find_map(|seconds| {
            let (stem, _) = parts[seconds].as_ref().filter(|(_, unit)| *unit == "s")?;
            let column = (0..parts.len()).find(|column| of(stem, *column).is_some())?;
            Some(Self { seconds, column, per_second: of(stem, column)? })
        })
    }

    /// Adds the fractions to the values of the seconds.
    pub fn add(self, table: &mut Table) {
        let fractions: Vec<f64> = table.columns[self.column].values.iter().map(|v| v / self.per_second).collect();
        for (value, fraction) in table.columns[self.seconds].values.iter_mut().zip(fractions) {
            *value += fraction;
        }
    }
}

/// `true` for words of velocities, forces and currents that are longer than a letter.
fn is_motion(word: &str) -> bool {
    word.len() > 1 && stands_for(word, Word::Motion)
}

impl Interpretation {
    /// Finds columns of joints.
    fn joints(&mut self, table: &Table) {
        let parts = measured_parts(table);
        let is_measured = |column: &Column| heading_axis(column).is_some_and(|(_, tag)| parts.contains(&tag));
        let mut joints: Vec<(usize, String, Option<usize>)> = self
            .free(table)
            .filter(|(_, column)| !is_measured(column))
            .filter_map(|(i, column)| joint_name(&column.heading).map(|(tag, number)| (i, tag, number)))
            .collect();
        self.base_of_arm(table, &mut joints);
        let commanded = |i: usize| table.columns[i].heading.has(Word::Commanded);
        let measured = |i: usize| table.columns[i].heading.has(Word::Measured);
        if joints.iter().any(|(i, ..)| commanded(*i)) && joints.iter().any(|(i, ..)| measured(*i) || !commanded(*i)) {
            for (i, ..) in joints.iter().filter(|(i, ..)| commanded(*i) && !measured(*i)) {
                self.take(*i, Meaning::OtherJoint, phrase!("why-others-measured"));
            }
            joints.retain(|(i, ..)| self.is_free(*i));
        }
        self.first_arm(table, &mut joints);
        self.one_family(table, &mut joints);
        if joints.len() < 2 {
            joints = self.lettered_joints(table);
        }
        if joints.len() < 2 {
            joints = self.unnamed_joints(table);
        }
        if joints.len() < 2 {
            return;
        }
        let tags: Vec<&String> = joints.iter().map(|(_, tag, _)| tag).collect();
        let one = tags.iter().all(|tag| *tag == tags[0]);
        let mut numbers: Vec<usize> = joints.iter().filter_map(|(.., number)| *number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        let numbered = one && numbers.len() == joints.len();
        let sorted = joints.windows(2).all(|pair| pair[0].2 < pair[1].2);
        // parts of an arm: wrists by their numbers
        let part = |(i, ..): &(usize, String, Option<usize>)| part_of_arm(&table.columns[*i].heading);
        let parts: Option<Vec<usize>> = joints.iter().map(part).collect();
        let is_arm = parts.is_some_and(|parts| parts.iter().max() != parts.iter().min());
        let place = |joint: &(usize, String, Option<usize>)| (part(joint), joint.2);
        if numbered && !sorted {
            joints.sort_by_key(|(.., number)| *number);
            self.doubt_until(Evidence::JointOrder, phrase!("doubt-order-of-joints"));
        } else if is_arm && !joints.is_sorted_by_key(place) {
            joints.sort_by_key(place);
            self.doubt_until(Evidence::JointOrder, phrase!("doubt-order-of-joints"));
        }
        for (k, (i, ..)) in joints.into_iter().enumerate() {
            let (low, high) = table.columns[i].range();
            let unit = match table.columns[i].heading.unit {
                Some(unit) => phrase!("why-in-unit", why = phrase!("why-heading"), unit),
                None if low.abs().max(high.abs()) <= 6.6 => {
                    phrase!("why-range-of-rad", low, high)
                }
                None => phrase!("why-range-of-deg", low, high),
            };
            self.take(i, Meaning::Joint(k), unit);
        }
    }

    /// Keeps the joints of the first arm if their headings occur again, as a question.
    fn first_arm(&mut self, table: &Table, joints: &mut Vec<(usize, String, Option<usize>)>) {
        let is_again = |at: usize| joints[..at].iter().any(|(_, tag, n)| (tag, n) == (&joints[at].1, &joints[at].2));
        let Some(end) = (1..joints.len()).find(|at| is_again(*at)) else { return };
        let (_, tag, number) = &joints[end];
        let count = joints.iter().filter(|(_, of, n)| (of, n) == (tag, number)).count();
        let others = joints.split_off(end);
        let names: Vec<String> = joints.iter().map(|(i, ..)| table.called(*i)).collect();
        for (i, ..) in others {
            self.take(i, Meaning::OtherJoint, phrase!("why-other-arm"));
        }
        self.ask(phrase!("ask-joints-again", names, count));
    }

    /// Adds the joint of the base beside shoulder, elbow or wrist: alone the word names no joint.
    fn base_of_arm(&self, table: &Table, joints: &mut Vec<(usize, String, Option<usize>)>) {
        let of_arm = |(i, ..): &&(usize, String, Option<usize>)| is_part_alone(&table.columns[*i].heading);
        if joints.iter().filter(of_arm).count() < 2 {
            return;
        }
        let is_known = |at: usize| joints.iter().any(|(i, ..)| *i == at);
        let base = self.free(table).filter(|(i, column)| is_part_alone(&column.heading) && !is_known(*i));
        let found: Vec<_> = base.map(|(i, column)| (i, column.heading.joined(), None)).collect();
        joints.extend(found);
        joints.sort_by_key(|(i, ..)| *i);
    }

    /// Finds joints that consecutive letters name.
    fn lettered_joints(&mut self, table: &Table) -> Vec<(usize, String, Option<usize>)> {
        let named = |(i, column): (usize, &Column)| {
            lettered_joint(&column.heading).map(|(word, number)| (i, word, Some(number)))
        };
        let found: Vec<(usize, String, Option<usize>)> = self.free(table).filter_map(named).collect();
        let mut numbers: Vec<usize> = found.iter().filter_map(|(.., number)| *number).collect();
        numbers.sort_unstable();
        let one = found.iter().all(|(_, word, _)| *word == found[0].1);
        if one && numbers.iter().copied().eq(1..=found.len()) { found } else { Vec::new() }
    }

    /// Keeps one family of numbered joints if several have the same numbers: the measured family,
    /// or the first. Families with other numbers are parts of one chain: a torso and an arm.
    fn one_family(&mut self, table: &Table, joints: &mut Vec<(usize, String, Option<usize>)>) {
        let mut tags: Vec<String> = joints.iter().map(|(_, tag, _)| tag.clone()).collect();
        tags.dedup();
        let numbers = |tag: &String| {
            joints.iter().filter(|(_, t, _)| t == tag).filter_map(|(.., n)| *n).collect::<BTreeSet<usize>>()
        };
        let state = |tag: &String| {
            let is_state = |word: &str| stands_for(word, Word::Measured) || stands_for(word, Word::Commanded);
            tag.split(' ').any(|word| word.len() > 1 && is_state(word))
        };
        let again = tags.iter().enumerate().any(|(k, tag)| {
            let own = numbers(tag);
            let is_same = |other: &String| match state(tag) || state(other) || is_encoder(tag) != is_encoder(other) {
                true => numbers(other).intersection(&own).count() > 1,
                false => numbers(other) == own,
            };
            own.len() > 1 && tags[..k].iter().any(is_same)
        });
        if !again {
            return;
        }
        let measured = |tag: &&String| tag.split(' ').any(|word| stands_for(word, Word::Measured));
        let of_joint = |tag: &&String| !is_encoder(tag);
        let kept = tags.iter().find(measured).or(tags.iter().find(of_joint)).unwrap_or(&tags[0]).clone();
        for (i, ..) in joints.iter().filter(|(_, tag, _)| *tag != kept) {
            self.take(*i, Meaning::OtherJoint, phrase!("why-other-family", kept));
        }
        let names: Vec<String> =
            joints.iter().filter(|(_, tag, _)| *tag != kept).map(|(i, ..)| table.called(*i)).take(4).collect();
        self.doubt(phrase!("doubt-two-families", names, kept));
        joints.retain(|(_, tag, _)| *tag == kept);
    }

    /// Finds a run of unknown columns of one letter and a number each: `C1`, `L2`, `T1`.
    fn unnamed_joints(&mut self, table: &Table) -> Vec<(usize, String, Option<usize>)> {
        let parts = |column: &Column| -> Option<(String, usize)> {
            match &column.heading.words[..] {
                [letter, number]
                    if (letter.len() <= 2 || POSITIONS[..6].contains(&letter.as_str()))
                        && !column.heading.other_quantity
                        && letter.chars().all(char::is_alphabetic) =>
                {
                    let known = [Word::Uncertainty, Word::Motion, Word::Difference, Word::Normal];
                    // `P1` beside coordinates is a point
                    let has_axes = table.columns.iter().any(|column| heading_axis(column).is_some());
                    let axis =
                        ["x", "y", "z", "w", "q"].contains(&letter.as_str()) || letter.starts_with('p') && has_axes;
                    let number = number.parse().ok()?;
                    (!axis && !known.iter().any(|of| stands_for(letter, *of))).then(|| (letter.clone(), number))
                }
                _ => None,
            }
        };
        let found: Vec<(usize, String, Option<usize>)> = self
            .free(table)
            .filter_map(|(i, column)| parts(column).map(|(letter, number)| (i, letter, Some(number))))
            .collect();
        let mut numbers: Vec<usize> = found.iter().filter_map(|(.., number)| *number).collect();
        numbers.sort_unstable();
        let from_start =
            numbers.first().is_some_and(|n| *n < 2) && numbers.windows(2).all(|pair| pair[1] == pair[0] + 1);
        let one = from_start && found.len() >= 2 && found.iter().all(|(_, letter, _)| *letter == found[0].1);
        if one {
            let names: Vec<String> = found.iter().map(|(i, ..)| table.called(*i)).collect();
            self.doubt(phrase!("doubt-unnamed-joints", names));
        }
        if one { found } else { Vec::new() }
    }

    /// Finds three columns of a rotation vector or of angles.
    fn rotations(&mut self, table: &Table) {
        const FORMS: [[&str; 3]; 13] = [
            ["rx", "ry", "rz"],
            ["phix", "phiy", "phiz"],
            ["roll", "pitch", "yaw"],
            ["yaw", "pitch", "roll"],
            ["alpha", "beta", "gamma"],
            ["phi", "theta", "psi"],
            ["rot x", "rot y", "rot z"],
            ["rotation x", "rotation y", "rotation z"],
            ["r x", "r y", "r z"],
            ["a", "b", "c"],
            ["w", "p", "r"],
            ["omega", "phi", "kappa"],
            ["orientation x", "orientation y", "orientation z"],
        ];
        if self.taken.iter().any(|taken| matches!(taken.meaning, Meaning::Quaternion(_) | Meaning::Matrix(..))) {
            return;
        }
        let commanded = |i: usize| table.columns[i].heading.has(Word::Commanded);
        let found = FORMS.into_iter().find_map(|form| self.rotation_at(table, form, &|i| !commanded(i)));
        if let Some(all) = found {
            for (k, at) in all.into_iter().enumerate() {
                self.take(at, Meaning::Rotation(k), phrase!("why-heading"));
            }
            let units = all.map(|at| table.columns[at].heading.unit);
            self.orientations.rotation.unit =
                units[0].filter(|unit| units == [units[0]; 3] && ["deg", "rad"].contains(unit));
            self.ask_until(Evidence::Orientations, phrase!("ask-rotation"));
        }
        while let Some(all) = FORMS.into_iter().find_map(|form| self.rotation_at(table, form, &commanded)) {
            all.into_iter().for_each(|at| self.take(at, Meaning::Motion, phrase!("why-commanded-rotation")));
        }
    }

    /// Returns the columns of three headings; a heading may have a word for measured or commanded.
    fn rotation_at(&self, table: &Table, form: [&str; 3], allowed: &dyn Fn(usize) -> bool) -> Option<[usize; 3]> {
        let state = |word: &str| stands_for(word, Word::Measured) || stands_for(word, Word::Commanded);
        let at = |name: &str| {
            let fits = |(i, column): &(usize, &Column)| {
                let words = column.heading.joined();
                // the number of the only point: `phix1` beside `x1`
                let number = self.points.first().filter(|_| self.points.len() == 1).map(|point| point.tag.as_str());
                let words = number.and_then(|tag| words.strip_suffix(tag)).map_or(&*words, str::trim_end);
                let stated = |(first, last): (&str, &str)| first == name && state(last) || last == name && state(first);
                let alone = words == name
                    || name.len() > 1 && words.ends_with(&format!(" {name}"))
                    || words.split_once(' ').is_some_and(stated);
                let body = words.strip_suffix(name).unwrap_or("");
                allowed(*i) && alone && !self.is_of_another_body(body)
            };
            // the rotation of the measured body first
            let own = |(_, column): &(usize, &Column)| {
                let words = column.heading.joined();
                self.is_of_own_body(words.strip_suffix(name).unwrap_or(&words))
            };
            self.free(table).filter(fits).find(own).or_else(|| self.free(table).find(fits)).map(|(i, _)| i)
        };
        let [a, b, c] = form.map(at);
        Some([a?, b?, c?])
    }

    /// Interprets single columns: names, times, angles of an instrument, temperatures.
    fn singles(&mut self, table: &Table) {
        let has = |found: &Self, meaning: Meaning| found.taken.iter().any(|taken| taken.meaning == meaning);
        let free: Vec<usize> = self.free(table).map(|(i, _)| i).collect();
        // `az` beside `ax` and `ay` is a component
        let is_axis = |heading: &Heading| {
            let beside = |word: &String| if word == "az" { "ax".to_owned() } else { word.clone() };
            let other: Vec<String> = heading.words.iter().map(beside).collect();
            other != heading.words && table.columns.iter().any(|column| column.heading.words == other)
        };
        // `vz` beside `vx` is a velocity
        let is_velocity = |heading: &Heading| {
            let beside = |word: &String| if word == "vz" { "vx".to_owned() } else { word.clone() };
            let other: Vec<String> = heading.words.iter().map(beside).collect();
            other != heading.words && table.columns.iter().any(|column| column.heading.words == other)
        };
        for i in free {
            let column = &table.columns[i];
            let heading = &column.heading;
            let whole = column.is_whole();
            let last = |meaning: Word| heading.words.last().is_some_and(|word| stands_for(word, meaning));
            let first = |meaning: Word| heading.words.first().is_some_and(|word| stands_for(word, meaning));
            let is_of_motion = heading.words.iter().any(|word| is_motion(word));
            let meaning = match () {
                () if heading.other_quantity && !is_of_motion => continue,
                () if heading.has(Word::Temperature) || heading.unit == Some("C") => Meaning::Temperature,
                () if heading.has(Word::Azimuth) && !is_axis(heading) => Meaning::Azimuth,
                () if is_velocity(heading) => Meaning::Motion,
                () if heading.has(Word::Zenith) => Meaning::Zenith,
                () if heading.has(Word::Elevation) => Meaning::Elevation,
                () if heading.has(Word::Deleted) => Meaning::Deleted,
                () if whole && (heading.has(Word::Pose) || *heading.words == ["p"]) && !has(self, Meaning::Pose) => {
                    Meaning::Pose
                }
                () if whole && (first(Word::Cycle) || last(Word::Cycle)) && !has(self, Meaning::Cycle) => {
                    Meaning::Cycle
                }
                // `TimeToTarget` decreases: no time of the samples
                () if (first(Word::Time) || last(Word::Time))
                    && (column.is_ordered() || heading.is_only(&[Word::Time]))
                    && !has(self, Meaning::Time)
                    && !heading.has(Word::Distance) =>
                {
                    Meaning::Time
                }
                () if whole && heading.is_only(&[Word::Label]) && !has(self, Meaning::Label) => Meaning::Label,
                () if whole && heading.is_only(&[Word::Count, Word::Label, Word::Target, Word::Measured]) => {
                    Meaning::Count
                }
                () if heading.has(Word::Distance) || *heading.words == ["l"] || *heading.words == ["d"] => {
                    Meaning::Distance
                }
                () if heading.has(Word::Uncertainty) => self.uncertainty(heading),
                () if is_of_motion => Meaning::Motion,
                () if whole && heading.has(Word::Count) => Meaning::Count,
                () => continue,
            };
            let why = match meaning {
                Meaning::Time if column.is_increasing() => phrase!("why-heading-increases"),
                Meaning::Time if column.is_ordered() => phrase!("why-heading-ordered"),
                Meaning::Time => phrase!("why-heading-unordered"),
                _ => phrase!("why-heading"),
            };
            self.take(i, meaning, why);
            if meaning == Meaning::Time && !column.is_ordered() && table.rows > 2 {
                self.doubt(phrase!("doubt-time-decreases", column = table.called(i)));
            }
        }
        self.directions(table);
        let of = |meaning: Meaning| self.first(meaning);
        let polar = of(Meaning::Azimuth).is_some() && of(Meaning::Distance).is_some();
        if polar && self.points.is_empty() && of(Meaning::Zenith).or(of(Meaning::Elevation)).is_none() {
            self.doubt_until(Evidence::VerticalAngle, phrase!("doubt-polar"));
        }
    }

    /// Returns the meaning of a column of uncertainties: standard or expanded, and its coordinate.
    fn uncertainty(&self, heading: &Heading) -> Meaning {
        let axis = ["x", "y", "z"].iter().position(|axis| heading.words.iter().any(|word| word == axis));
        let number =
            || heading.words.iter().find_map(|word| word.parse::<usize>().ok()).filter(|n| (1..=3).contains(n));
        let expanded = heading.words.iter().any(|word| word == "95");
        match (axis, expanded) {
            (Some(axis), true) => Meaning::ExpandedUncertainty(axis),
            (Some(axis), false) => Meaning::Uncertainty(axis),
            (None, _) if heading.words.iter().any(|word| is_motion(word)) => Meaning::Motion,
            // of the whole point: no coordinate has it
            (None, _) => number().map_or(Meaning::Scatter, |n| Meaning::Uncertainty(n - 1)),
        }
    }

    /// Finds directions `i j k` and `nx ny nz` of length 1.
    fn directions(&mut self, table: &Table) {
        const FORMS: [[&str; 3]; 5] = [
            ["i", "j", "k"],
            ["nx", "ny", "nz"],
            ["n x", "n y", "n z"],
            ["ni", "nj", "nk"],
            ["normal x", "normal y", "normal z"],
        ];
        for form in FORMS {
            let at = |name: &str| {
                let free = |(i, column): (usize, &Column)| {
                    (column.is_numeric()
                        && matches!(self.taken[i].meaning, Meaning::Unknown | Meaning::Motion | Meaning::Joint(_))
                        && column.heading.joined() == name)
                        .then_some(i)
                };
                table.columns.iter().enumerate().find_map(free)
            };
            let [Some(i), Some(j), Some(k)] = form.map(at) else { continue };
            let unit = table.are_unit([i, j, k]);
            let why = if unit { phrase!("why-heading-and-three") } else { phrase!("why-heading") };
            for (n, column) in [i, j, k].into_iter().enumerate() {
                self.take(column, Meaning::Direction(n), why.clone());
            }
            if !unit {
                self.doubt(phrase!("doubt-direction-length"));
            }
            return;
        }
    }

    /// Takes whole seconds that have their fractions in a second column for the time.
    fn whole_seconds(&mut self, table: &Table) {
        self.clock.fractions = Fractions::new(table);
        let Some(Fractions { seconds, .. }) = self.clock.fractions else { return };
        for taken in self.taken.iter_mut().filter(|taken| taken.meaning == Meaning::Time) {
            *taken = Taken { meaning: Meaning::Unknown, why: None };
        }
        self.take(seconds, Meaning::Time, phrase!("why-heading"));
    }

    /// Finds the unit of the times: in the heading, or by the size and the step of the values. A
    /// unit that neither shows is a question.
    pub(crate) fn clock_unit(&mut self, table: &Table) {
        let Some(at) = self.first(Meaning::Time) else { return };
        let column = &table.columns[at];
        let is_of_time = |unit: &&'static str| ["s", "ms", "us", "ns"].contains(unit);
        let in_words = |word: &String| unit_word(word).filter(is_of_time).filter(|_| word.len() > 1);
        let known = column.heading.unit.filter(is_of_time).or_else(|| column.heading.words.iter().find_map(in_words));
        self.clock.unit = known.or_else(|| column.epoch_unit());
        if self.clock.unit.is_some() {
            if known.is_none()
                && let Some(unit) = self.clock.unit
                && let Some(why) = self.taken[at].why.take()
            {
                self.taken[at].why = Some(phrase!("why-epoch", why, unit));
            }
            return;
        }
        if column.has_step_of_seconds() {
            return;
        }
        let (column, step) = (table.called(at), column.usual_step());
        let question = phrase!("ask-time-unit", column, step);
        self.clock.question = Some(question.clone());
        self.ask(question);
    }

    /// Proposes a running number with gaps, or out of order, as the number of the pose, with a
    /// question: the row numbers differ from it.
    fn number_with_gaps(&mut self, table: &Table) {
        let named = [Meaning::Label, Meaning::Pose, Meaning::Time, Meaning::Clock, Meaning::TimeOfDay];
        if named.iter().any(|meaning| self.first(*meaning).is_some()) {
            return;
        }
        let gap = |at: &usize| table.columns[*at].first_gap().or_else(|| table.columns[*at].first_out_of_order());
        let counted = |at: &usize| self.taken[*at].meaning == Meaning::Count;
        let Some(at) = (0..table.columns.len()).filter(counted).find(|at| gap(at).is_some()) else { return };
        let Some([before, after]) = gap(&at) else { return };
        self.take(at, Meaning::Pose, phrase!("why-counts-with-gaps"));
        self.ask(phrase!("ask-number-with-gaps", column = table.called(at), before, after));
    }

    /// Takes a running number that its heading calls a number (`Nr`, `No.`, `序号`) for the number of
    /// the pose, if it is different in all rows: another file may have the rows in another order.
    fn numbers_of_poses(&mut self, table: &Table) {
        const NUMBERS: [&str; 12] =
            ["nr", "no", "num", "number", "numero", "nummer", "n", "index", "idx", "序号", "連番", "编号"];
        const OTHERS: [&str; 11] =
            ["frame", "sample", "counter", "count", "step", "seq", "row", "zeile", "line", "ligne", "riga"];
        let named = [Meaning::Label, Meaning::Pose, Meaning::Target, Meaning::Time, Meaning::Clock, Meaning::TimeOfDay];
        if named.iter().any(|meaning| self.first(*meaning).is_some()) {
            return;
        }
        let is_number = |at: &usize| {
            let words = &table.columns[*at].heading.words;
            let has = |known: &[&str]| words.iter().any(|word| known.contains(&word.as_str()));
            has(&NUMBERS) && !has(&OTHERS)
        };
        let counted = |at: &usize| self.taken[*at].meaning == Meaning::Count && table.columns[*at].is_counter();
        if let Some(at) = (0..table.columns.len()).find(|at| counted(at) && is_number(at)) {
            self.take(at, Meaning::Pose, phrase!("why-numbers-rows"));
        }
    }

    /// Interprets a vertical angle beside azimuth and distance: a zenith angle about a quarter
    /// turn, or an elevation about zero, with a doubt.
    fn vertical_angle(&mut self, table: &Table) {
        const VERTICAL: [&str; 8] = ["v", "va", "vert", "vertical", "vertikal", "verticale", "verticala", "竖直角"];
        let has = |meaning: Meaning| self.first(meaning);
        let (Some(azimuth), Some(_)) = (has(Meaning::Azimuth), has(Meaning::Distance)) else { return };
        if has(Meaning::Zenith).or(has(Meaning::Elevation)).is_some() || !self.points.is_empty() {
            return;
        }
        let is_vertical = |(_, column): &(usize, &Column)| match &column.heading.words[..] {
            [word] | [word, _] => VERTICAL.contains(&word.as_str()),
            _ => false,
        };
        let Some(at) = self.free(table).find(is_vertical).map(|(at, _)| at) else { return };
        let column = &table.columns[at];
        let in_rad = table.columns[azimuth].largest().max(column.largest()) < 6.6;
        let unit = column.heading.unit.unwrap_or(if in_rad { "rad" } else { "deg" });
        let quarter = match unit {
            "rad" => std::f64::consts::FRAC_PI_2,
            "gon" => 100.0,
            _ => 90.0,
        };
        let count = column.numbers().count().max(1) as f64;
        let mean = column.numbers().sum::<f64>() / count;
        let is_zenith = mean.abs() > 0.5 * quarter;
        let meaning = if is_zenith { Meaning::Zenith } else { Meaning::Elevation };
        self.take(at, meaning, phrase!("why-vertical"));
        self.settle(Evidence::VerticalAngle);
        let (column, zenith) = (table.called(at), if is_zenith { "yes" } else { "no" });
        self.doubt(phrase!("doubt-vertical-angle", column, zenith));
    }

    /// Interprets the remaining columns by their values.
    fn rest(&mut self, table: &Table) {
        let free: Vec<usize> = self.free(table).map(|(i, _)| i).collect();
        for i in free {
            let column = &table.columns[i];
            if column.is_whole() && column.is_increasing() && i == 0 {
                self.take(i, Meaning::Count, phrase!("why-counts-first"));
            }
        }
    }
}
