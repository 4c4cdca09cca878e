//! Lines of a proposal for campaign.toml, from the interpretation of the columns.

use crate::dialect::{ColumnRole, Columns, CoordinateType, Dialect, ROTATION_VECTOR, Unit, coordinate_type, quoted};
use crate::exports::delimited::point_rows;
use crate::logs::LogKind;
use crate::points::{Point, has_frame_on_points};
use crate::propose::coordinates;
use crate::propose::meaning::{Evidence, Fractions, Interpretation, Meaning, PointSet};
use crate::propose::statements::{Label, Line, Lines, OPEN_UNIT, Target};
use crate::propose::table::Table;
use crate::table::QUATERNION;
use etalon_base::catalogue::Phrase;
use etalon_base::message::{Message, Problems};
use etalon_base::phrase;
use etalon_documents::FormatsDocument;
use etalon_tables::guess::{Guess, names};
use etalon_tables::{ColumnSource, Delimiter};
use std::fmt::Write;

/// Remark to complete the columns of a proposed log.
pub const JOINTS: &str =
    "# write the joints as robot.toml names them, and for UNIT deg, rad, mm, m or um: the file does not state it\n";

/// Remark on an open order of angles.
const ROTATION_REMARK: &str = "   # rotation: \"zyx\", \"fixed xyz\" .. for three angles in this order, \"vector\" for a \
     rotation vector; \"-\" in place of the three columns leaves them out";

/// Remark on columns that nothing tells.
const COLUMNS_REMARK: &str = "# the columns in order, [\"x\", \"y\", \"z\", \"-\", ...]; columns of joints by \
     their numbers in `joints = { q1_deg = 1, ... }` below";

/// Maximum number of problems of a trial that are repeated as doubts.
const SHOWN: usize = 3;

/// Maximum number of columns that a doubt about columns that are not read lists.
const LISTED_UNREAD: usize = 8;

/// Maximum number of columns that are listed from the left; more columns are named.
const LISTED: usize = 14;

/// Proposal for a table.
#[derive(Clone, Copy)]
pub(crate) struct Proposal<'a> {
    pub file: &'a str,
    pub text: &'a str,
    pub best: &'a Guess<'a>,
    pub table: &'a Table,
    pub found: &'a Interpretation,
}

/// Returns the line of the unit.
pub(crate) fn unit_line(unit: Option<&str>) -> String {
    match unit {
        Some(unit) => format!("unit = {unit:?}                # the file states it\n"),
        None => {
            "unit = \"?\"                 # mm, m, cm, um or inch: the file does not state it, and it is never guessed\n"
                .to_owned()
        }
    }
}

/// Returns the line of a unit that the kinematics of the nominal robot support.
pub(crate) fn fitted_unit_line(unit: Option<&str>) -> String {
    unit_line(unit).replace("the file states it", "the kinematics of the nominal robot fit with it")
}

/// Returns the column of a joint in `columns` of a log or `joints` of an export, by its heading or
/// by its number.
pub(crate) fn joint_column(is_reversed: bool, heading: Option<&str>, number: usize) -> String {
    match (is_reversed, heading) {
        (false, Some(name)) => quoted(name),
        (false, None) => number.to_string(),
        (true, Some(name)) => format!("{{ name = {}, per_count = -1 }}", quoted(name)),
        (true, None) => format!("{{ number = {number}, per_count = -1 }}"),
    }
}

/// Returns the first problems of reading a file, as doubts.
pub(crate) fn problems_as_doubts(problems: &Problems) -> Vec<Phrase> {
    let doubt = |message: &Message| match message.place.as_ref().and_then(|place| place.line) {
        Some(line) => phrase!("doubt-in-line", line, problem = message.phrase()),
        None => message.phrase(),
    };
    let mut doubts: Vec<Phrase> = problems.0.iter().take(SHOWN).map(doubt).collect();
    if problems.0.len() > SHOWN {
        doubts.push(phrase!("doubt-more-problems", count = problems.0.len() - SHOWN));
    }
    doubts
}

/// Returns the first row without a point, and the number of others, as a doubt.
pub(crate) fn refused_as_doubts(points: &[Point]) -> Vec<Phrase> {
    let refused: Vec<&Point> = points.iter().filter(|point| point.refused.is_some()).collect();
    let Some((line, reason)) = refused.first().and_then(|p| Some((p.line, p.refused.as_deref()?))) else {
        return Vec::new();
    };
    vec![match refused.len() - 1 {
        0 => phrase!("doubt-in-line", line, problem = reason),
        more => phrase!("doubt-rows-refused", line, reason, more),
    }]
}

/// Returns the role of each column in an export of the measured point with this number; rotations
/// in an open unit are in degrees.
pub(crate) fn roles(found: &Interpretation, set: usize) -> Vec<ColumnRole> {
    const XYZ: [ColumnRole; 3] = [ColumnRole::X, ColumnRole::Y, ColumnRole::Z];
    const IJK: [ColumnRole; 3] = [ColumnRole::I, ColumnRole::J, ColumnRole::K];
    const U: [ColumnRole; 3] = [ColumnRole::U1, ColumnRole::U2, ColumnRole::U3];
    const U95: [ColumnRole; 3] = [ColumnRole::U95x, ColumnRole::U95y, ColumnRole::U95z];
    let has_point = !found.points.is_empty();
    let all = |wanted: fn(usize) -> Meaning| (0..3).all(|k| found.first(wanted(k)).is_some());
    let expanded = all(Meaning::ExpandedUncertainty);
    let uncertain = all(Meaning::Uncertainty) && !expanded;
    let matrix = found.matrix_columns().len() == 9 && set == 0;
    let directed = all(Meaning::Direction);
    let (timed, stamped) = (found.first(Meaning::Time).is_some(), found.first(Meaning::Clock).is_some());
    let mut seen: Vec<ColumnRole> = Vec::new();
    let role = |meaning: Meaning| match meaning {
        Meaning::Label => ColumnRole::Label,
        Meaning::Target => ColumnRole::Target,
        Meaning::Pose => ColumnRole::Pose,
        Meaning::Cycle => ColumnRole::Cycle,
        Meaning::Time => match found.clock.unit {
            None | Some("s") => ColumnRole::TimeS,
            Some("ms") => ColumnRole::TimeMs,
            Some("us") => ColumnRole::TimeUs,
            Some("ns") => ColumnRole::TimeNs,
            _ => ColumnRole::Skip,
        },
        Meaning::Point(of, axis) if of == set => XYZ[axis.min(2)],
        Meaning::Direction(axis) if directed => IJK[axis.min(2)],
        Meaning::Uncertainty(axis) if uncertain => U[axis.min(2)],
        Meaning::ExpandedUncertainty(axis) if expanded => U95[axis.min(2)],
        Meaning::Quaternion(k) if set == 0 && has_point => ColumnRole::ORIENTATIONS[0][k.min(3)],
        Meaning::Rotation(k) if set == 0 && has_point => {
            let form = if found.orientations.rotation.unit == Some("rad") { 2 } else { 1 };
            ColumnRole::ORIENTATIONS[form][k.min(2)]
        }
        Meaning::Matrix(i, j) if matrix => ColumnRole::ORIENTATIONS[3][(3 * i + j).min(8)],
        Meaning::Temperature => ColumnRole::TemperatureC,
        Meaning::Deleted => ColumnRole::Deleted,
        Meaning::Clock if !timed => ColumnRole::Timestamp,
        Meaning::TimeOfDay if !timed && !stamped => ColumnRole::Timestamp,
        Meaning::Day if !timed && !stamped && found.first(Meaning::TimeOfDay).is_some() => ColumnRole::Date,
        Meaning::Azimuth if !has_point => ColumnRole::Azimuth,
        Meaning::Zenith if !has_point => ColumnRole::Zenith,
        Meaning::Elevation if !has_point => ColumnRole::Elevation,
        Meaning::Distance if !has_point => ColumnRole::Distance,
        _ => ColumnRole::Skip,
    };
    let mut once = |role: ColumnRole| {
        let again = role != ColumnRole::Skip && role != ColumnRole::Label && seen.contains(&role);
        seen.push(role);
        if again { ColumnRole::Skip } else { role }
    };
    let mut roles: Vec<ColumnRole> = found.taken.iter().map(|taken| once(role(taken.meaning))).collect();
    let of_point = found.orientations.of_points.iter().filter(|(number, _)| *number == set);
    for (k, at) in of_point.flat_map(|(_, columns)| columns.iter().enumerate()) {
        roles[*at] = ColumnRole::ORIENTATIONS[0][k];
    }
    roles
}

impl Proposal<'_> {
    /// Returns the lines, and adds doubts and questions to the document.
    pub fn lines(&self, document: &mut FormatsDocument) -> Lines {
        let found = self.found;
        let joints = found.joint_columns();
        let polar = roles(found, 0).iter().any(|role| role.is_angle());
        let has_point = !found.points.is_empty() || polar;
        match (joints.len() >= 2, has_point) {
            (_, false) if found.commanded.alone.is_some() && found.commanded.difference.is_some() => {
                self.computed(document, &joints)
            }
            (true, false) => match found.first(Meaning::Distance) {
                Some(distance) => self.distances(document, &joints, distance),
                None => {
                    document.kind = "log".to_owned();
                    document.because(phrase!("because-log", reason = self.named(&joints, phrase!("says-joints"))));
                    if !self.found.by_kinematics {
                        document.ask(phrase!("ask-joints"));
                    }
                    self.not_read().into_iter().for_each(|doubt| document.doubt(doubt));
                    self.log(None)
                }
            },
            (true, true) => self.mixed(document, &joints),
            (false, true) => self.points(document),
            (false, false) if found.waits_for(Evidence::JointOrder) && found.matrix_columns().is_empty() => {
                self.open(document)
            }
            (false, false) => self.commanded(document),
        }
    }

    /// Returns a sentence with the names of columns; without a header, the evidence in the values.
    fn named(&self, columns: &[usize], said: Phrase) -> Phrase {
        match self.table.columns.iter().any(|column| column.name.is_some()) {
            true => {
                let names: Vec<&str> =
                    columns.iter().take(8).filter_map(|i| self.table.columns[*i].name.as_deref()).collect();
                phrase!("names-of-columns", said, names)
            }
            false => phrase!("because-numbers", count = columns.len()),
        }
    }

    /// Returns the reference to a column: its heading if it is unique, or its number.
    fn column(&self, at: usize) -> String {
        match self.heading(at) {
            Some(name) => quoted(name),
            None => (at + 1).to_string(),
        }
    }

    /// Returns the heading of a column, if a campaign can name the column by it.
    fn heading(&self, at: usize) -> Option<&str> {
        let header =
            self.best.named.row.as_ref().filter(|_| !self.best.named.commented && names(self.best).is_some())?;
        let name = header.fields.get(at)?.as_ref();
        let once = header.fields.iter().filter(|field| *field == name).count() == 1;
        // a heading that blanks split is not one field
        let whole = self.table.columns.get(at)?.name.as_deref() == Some(name.trim());
        (once && whole && !name.is_empty()).then_some(name)
    }

    /// Returns the sum of whole seconds and their fractions, if this is the column of the seconds.
    fn seconds(&self, at: usize) -> Option<String> {
        let Fractions { seconds, column, per_second } = self.found.clock.fractions.filter(|of| of.seconds == at)?;
        let [seconds, fractions] =
            [seconds, column].map(|at| self.heading(at).map_or_else(|| format!("${}", at + 1), str::to_owned));
        Some(format!("{seconds} + {fractions} / {per_second}"))
    }

    /// Returns the group of columns that a point alone is in.
    fn group(&self, set: &PointSet) -> Option<String> {
        let of = |set: &PointSet| {
            let mut groups = set.columns.iter().flatten().map(|at| self.table.columns[*at].group.clone());
            let first = groups.next()??;
            groups.all(|group| group.as_ref() == Some(&first)).then_some(first)
        };
        let group = of(set)?;
        let alone = self.found.points.iter().filter(|other| of(other).as_ref() == Some(&group)).count() == 1;
        (alone && self.found.points.len() > 1).then_some(group)
    }

    /// Returns the unit in the headings of a point.
    fn unit(&self, set: &PointSet) -> Option<Unit> {
        let of = |at: &usize| {
            let heading = &self.table.columns[*at].heading;
            heading.unit.filter(|_| !heading.bare_metre || self.table.columns[*at].largest() < 30.0)
        };
        let mut units: Vec<Option<&str>> = set.columns.iter().flatten().map(of).collect();
        units.dedup();
        match units[..] {
            [unit] => Unit::named(unit?),
            _ => None,
        }
    }

    /// Returns the dialect of an export of one point.
    fn dialect(&self, set: usize) -> Dialect {
        let roles = roles(self.found, set);
        let several = self.found.points.len() > 1;
        let is_computed = self.found.clock.fractions.is_some();
        let columns = match several || is_computed || roles.len() > LISTED && !self.best.named.commented {
            // fields without a heading that only some rows have
            false => {
                let mut all = roles.clone();
                all.resize(roles.len().max(self.best.widths[1]), ColumnRole::Skip);
                Columns::InOrder(all)
            }
            true => {
                let at = |i: usize| match (self.seconds(i), self.heading(i)) {
                    (Some(computed), _) => ColumnSource::Heading(computed),
                    (None, Some(name)) => ColumnSource::Heading(name.to_owned()),
                    (None, None) => ColumnSource::Number(i + 1),
                };
                let stated = roles.iter().enumerate().filter(|(_, role)| **role != ColumnRole::Skip);
                let mut named: Vec<(ColumnRole, ColumnSource)> = stated.map(|(i, role)| (*role, at(i))).collect();
                named.sort_by_key(|(role, _)| *role as usize);
                Columns::Named(named)
            }
        };
        let angle = |i: usize| self.table.columns[i].heading.unit;
        let angles = (0..roles.len()).filter(|i| roles[*i].is_angle()).find_map(angle);
        let angle_unit = angles.and_then(|unit| match unit {
            "deg" => Some(crate::dialect::AngleUnit::Deg),
            "rad" => Some(crate::dialect::AngleUnit::Rad),
            "gon" => Some(crate::dialect::AngleUnit::Gon),
            _ => None,
        });
        let coverage_factor = roles.iter().any(|role| role.is_expanded()).then_some(2.0);
        let is_turned = roles.iter().any(|role| matches!(role, ColumnRole::RxDeg | ColumnRole::RxRad));
        let rotation = self.found.orientations.rotation.order.clone().filter(|_| is_turned);
        Dialect { form: self.best.form.clone(), columns, angle_unit, coverage_factor, rotation, ..Dialect::default() }
    }

    /// Returns the dialect as TOML: a time or a rotation whose unit is open has the unit UNIT, and
    /// an open order of angles is a question.
    fn written(&self, dialect: &Dialect) -> String {
        let roles = dialect.columns.roles();
        let is_turned = roles.iter().any(|role| matches!(role, ColumnRole::RxDeg | ColumnRole::RxRad));
        let is_open = is_turned && dialect.rotation.is_none();
        let asked =
            Dialect { rotation: dialect.rotation.clone().or(is_open.then(|| "?".to_owned())), ..dialect.clone() };
        let mut written = asked.to_string();
        let mut open = |name: &str, unit: &str| {
            let (from, to) = (format!("{name}_{unit}"), format!("{name}_UNIT"));
            for [before, behind] in [["\"", "\""], ["", " = "]] {
                written = written.replace(&format!("{before}{from}{behind}"), &format!("{before}{to}{behind}"));
            }
        };
        if self.found.clock.question.is_some() {
            open("time", "s");
        }
        if is_turned && self.found.orientations.rotation.unit.is_none() {
            ["rx", "ry", "rz"].iter().for_each(|name| open(name, "deg"));
        }
        match is_open {
            true => written + ROTATION_REMARK,
            false => written,
        }
    }

    /// Returns the lines of exports of points.
    fn points(&self, document: &mut FormatsDocument) -> Lines {
        document.kind = "export".to_owned();
        let lines = (0..self.found.points.len().max(1)).map(|set| self.export(document, set)).collect();
        if self.found.points.len() > 1 {
            document.because(phrase!("because-several-points", count = self.found.points.len()));
        }
        self.not_read().into_iter().for_each(|doubt| document.doubt(doubt));
        lines
    }

    /// Returns the lines of an export whose columns nothing tells.
    fn open(&self, document: &mut FormatsDocument) -> Lines {
        document.kind = "export".to_owned();
        document.ask(phrase!("ask-unit"));
        let columns = Columns::InOrder(vec![ColumnRole::Skip]);
        let form = Dialect { form: self.best.form.clone(), columns, ..Dialect::default() }.to_string();
        let form = form.replace("columns = [\"-\"]", "columns = \"?\"");
        self.new_export(format!("{form}   {COLUMNS_REMARK}"))
            .with_text(unit_line(None))
            .with(Line::Target(Target::Open))
            .with(Line::PoseByRow)
    }

    /// Returns the first lines of an export of the file.
    fn new_export(&self, format: String) -> Lines {
        Lines::element("export").with(Line::File(self.file.to_owned())).with(Line::Format(format))
    }

    /// Returns the lines of one export.
    fn export(&self, document: &mut FormatsDocument, set: usize) -> Lines {
        let roles = roles(self.found, set);
        let points = self.found.points.get(set);
        let distance = || Unit::named(self.table.columns[self.found.first(Meaning::Distance)?].heading.unit?);
        let unit = points.map_or_else(distance, |points| self.unit(points));
        let dialect = self.dialect(set);
        let mut lines = self.new_export(self.written(&dialect));
        let fitted = |at: &usize| self.table.columns[*at].heading.fitted;
        lines.push(Line::Text(match points.is_some_and(|points| points.columns.iter().flatten().all(fitted)) {
            true => fitted_unit_line(unit.map(Unit::name)),
            false => unit_line(unit.map(Unit::name)),
        }));
        let of: Vec<ColumnRole> = roles.iter().copied().filter(|role| role.is_coordinate()).collect();
        let kind = coordinate_type(&of).unwrap_or(CoordinateType::Cartesian);
        if dialect.angle_unit.is_none() && of.iter().any(|role| role.is_angle()) {
            document.ask(phrase!("ask-angle-unit"));
        }
        let named = self.table.columns.iter().any(|column| column.name.is_some());
        lines.push(Line::Remark(match named {
            true => format!("the columns are {}", kind.name()),
            false => format!("are the columns x, y, z in this order, and {}?", kind.name()),
        }));
        if set == 0 {
            self.tried(&dialect, unit).into_iter().for_each(|doubt| document.doubt(doubt));
            self.blocks().into_iter().for_each(|question| document.ask(question));
            if unit.is_none() {
                document.ask(self.unit_of_lengths(points));
            }
            if !named {
                document.ask(phrase!("ask-order-of-columns"));
            }
        }
        let has = |role: ColumnRole| roles.contains(&role);
        let several_points = self.found.points.len() > 1;
        if has(ColumnRole::Label) {
            lines.push(Line::Label(if several_points { Label::Pose } else { Label::Open }));
        }
        if !has(ColumnRole::Target) && (several_points || !has(ColumnRole::Label)) {
            let alike = |name: &str| {
                self.found.points.iter().filter(|points| coordinates::target_name(&points.tag) == name).count() > 1
            };
            let tag = points.map(|points| coordinates::target_name(&points.tag));
            let tag = tag.filter(|tag| self.found.points.len() > 1 && !alike(tag));
            let tag = points.and_then(|points| self.group(points)).or(tag);
            lines.push(Line::Target(match tag {
                _ if self.found.is_in_turned_frames(self.table) => Target::InOtherFrame,
                Some(tag) if tag.parse::<u32>().is_ok() => Target::Named(format!("marker_{tag}"), ""),
                Some(tag) if !tag.is_empty() => Target::Named(tag, ""),
                _ => Target::Open,
            }));
        }
        // a column or the label may give the pose; the times of several targets tell their poses
        let several = has(ColumnRole::Timestamp) && has(ColumnRole::Target) && self.has_several_targets();
        let stated = [ColumnRole::Label, ColumnRole::Pose];
        let timed = [ColumnRole::TimeS, ColumnRole::TimeMs, ColumnRole::TimeUs, ColumnRole::TimeNs];
        if !several && !stated.iter().chain(&timed).any(|role| has(*role)) {
            lines.push(Line::PoseByRow);
        }
        lines
    }

    /// `true` if the column of targets has several names.
    fn has_several_targets(&self) -> bool {
        let cells = self.found.first(Meaning::Target).map(|at| &self.table.columns[at].cells);
        cells.is_some_and(|cells| cells.windows(2).any(|pair| pair[0] != pair[1]))
    }

    /// Returns the question of the unit with the size of the coordinates, and the units that fit
    /// it.
    fn unit_of_lengths(&self, points: Option<&PointSet>) -> Phrase {
        let largest = points.map_or(0.0, |points| {
            points.columns.iter().flatten().map(|at| self.table.columns[*at].largest()).fold(0.0, f64::max)
        });
        match largest {
            0.0 => phrase!("ask-unit"),
            largest if largest < 15.0 => phrase!("ask-unit-of-size", largest, units = "m"),
            largest if largest < 200.0 => phrase!("ask-unit-of-size", largest, units = "inch-or-mm"),
            largest => phrase!("ask-unit-of-size", largest, units = "mm"),
        }
    }

    /// Returns the question of blocks: the headings stand above the rows of each of them again.
    fn blocks(&self) -> Option<Phrase> {
        let row =
            self.best.named.row.as_ref().filter(|row| row.fields.iter().any(|f| f.contains(char::is_alphabetic)))?;
        let heading = self.text.lines().nth(row.line.checked_sub(1)?)?.trim();
        let again = self.text.lines().enumerate().skip(row.line).filter(|(_, line)| line.trim() == heading);
        let lines: Vec<usize> = again.map(|(at, _)| at + 1).collect();
        let line = *lines.first()?;
        Some(phrase!("ask-blocks", line, count = lines.len() + 1))
    }

    /// Returns a doubt about columns of numbers that are not read, if their meaning is unknown.
    fn not_read(&self) -> Option<Phrase> {
        let named = self.table.columns.iter().any(|column| column.name.is_some());
        let has_point = !self.found.points.is_empty();
        let roles = roles(self.found, 0);
        let unread = |(i, taken): (usize, &crate::propose::meaning::Taken)| {
            let unread = match taken.meaning {
                Meaning::Unknown => true,
                Meaning::Count => !named,
                Meaning::OtherOrientation(_) => {
                    !self.found.orientations.of_points.iter().any(|(_, at)| at.contains(&i))
                }
                Meaning::Uncertainty(_)
                | Meaning::ExpandedUncertainty(_)
                | Meaning::Scatter
                | Meaning::Distance
                | Meaning::Azimuth
                | Meaning::Zenith
                | Meaning::Elevation => has_point && roles.get(i) == Some(&ColumnRole::Skip),
                _ => false,
            };
            let unread = unread && self.found.clock.fractions.is_none_or(|of| of.column != i);
            let column = &self.table.columns[i];
            let name = || column.name.as_ref().map(|name| format!(" `{name}`")).unwrap_or_default();
            (unread && column.is_numeric()).then(|| format!("{}{}", i + 1, name()))
        };
        let mut columns: Vec<String> = self.found.taken.iter().enumerate().filter_map(unread).collect();
        let more = columns.len().saturating_sub(LISTED_UNREAD);
        columns.truncate(LISTED_UNREAD);
        (!columns.is_empty()).then(|| phrase!("doubt-columns-not-read", columns, more))
    }

    /// Returns the problems of reading the whole file with this dialect, as doubts.
    fn tried(&self, dialect: &Dialect, unit: Option<Unit>) -> Vec<Phrase> {
        let (points, problems) = point_rows(self.file, &self.text.into(), dialect, unit.unwrap_or(Unit::Millimetre));
        let mut doubts = problems_as_doubts(&problems);
        let at_origin = |p: &&Point| p.refused.is_none() && p.xyz_mm == [0.0; 3];
        let origin = points.iter().find(at_origin).filter(|_| !has_frame_on_points(&points));
        doubts.extend(origin.map(|p| phrase!("doubt-origin", line = p.line)));
        doubts.extend(refused_as_doubts(&points));
        doubts
    }

    /// Returns the lines of a file with joints and points.
    fn mixed(&self, document: &mut FormatsDocument, joints: &[usize]) -> Lines {
        document.because(self.named(joints, phrase!("says-joints-beside")));
        self.not_read().into_iter().for_each(|doubt| document.doubt(doubt));
        let open = self.are_open(joints);
        if open {
            document.ask(phrase!("ask-joints"));
        }
        let turned = [self.found.quaternion_columns(), self.found.rotation_columns()].concat();
        if !turned.is_empty() && self.found.points.len() == 1 {
            document.kind = "observations".to_owned();
            document.because(self.named(&turned, phrase!("says-orientations")));
            let tried = self.tried(&self.dialect(0), self.unit(&self.found.points[0]));
            tried.into_iter().for_each(|doubt| document.doubt(doubt));
            return self.observations(joints, &turned);
        }
        document.kind = "export with joints".to_owned();
        let joints = self.joints_line(joints);
        let sets = 0..self.found.points.len().max(1);
        let lines: Lines = sets.map(|set| self.export(document, set).with_text(joints.clone())).collect();
        lines.with_text(if open { JOINTS } else { "" })
    }

    /// Returns the line of the joints of an export.
    fn joints_line(&self, joints: &[usize]) -> String {
        let entry = |(k, at): (usize, &usize)| {
            let (key, column) = self.joint(k, *at, self.joint_unit(*at));
            format!("{key} = {column}")
        };
        format!("joints = {{ {} }}\n", joints.iter().enumerate().map(entry).collect::<Vec<_>>().join(", "))
    }

    /// Returns `true` if neither headings nor kinematics state all joints and their units.
    fn are_open(&self, joints: &[usize]) -> bool {
        let is_open = |at: &usize| self.joint_unit(*at) == OPEN_UNIT || self.heading(*at).is_none();
        !self.found.by_kinematics && joints.iter().any(is_open)
    }

    /// Returns the name of a joint: its name in the robot file, or its number.
    fn joint_key(&self, k: usize) -> String {
        self.found.joint_names.get(k).cloned().unwrap_or_else(|| format!("q{}", k + 1))
    }

    /// Returns the entry of a joint in `columns` of a log or `joints` of an export.
    fn joint(&self, k: usize, at: usize, unit: &str) -> (String, String) {
        let column = joint_column(self.found.reversed.contains(&at), self.heading(at), at + 1);
        (format!("{}_{unit}", self.joint_key(k)), column)
    }

    /// Returns the unit of the column of a joint, as the suffix of its key.
    fn joint_unit(&self, at: usize) -> &'static str {
        self.table.columns[at].heading.unit.filter(|unit| ["deg", "rad", "mm", "m"].contains(unit)).unwrap_or(OPEN_UNIT)
    }

    /// Returns the columns of pose, cycle, target and joints with their names in observations.
    fn observation_columns(&self, joints: &[usize]) -> Vec<(String, String)> {
        let mut columns = Vec::new();
        let mut column = |name: String, at: usize| columns.push((name, self.column(at)));
        for (name, meaning) in [("pose", Meaning::Pose), ("cycle", Meaning::Cycle), ("target", Meaning::Target)] {
            if let Some(at) = self.found.first(meaning) {
                column(name.to_owned(), at);
            }
        }
        for (k, at) in joints.iter().enumerate() {
            let source = match self.found.reversed.contains(at) {
                false => self.column(*at),
                true => {
                    let name = self.heading(*at).map_or_else(|| format!("${}", at + 1), str::to_owned);
                    quoted(&format!("-1 * {name}"))
                }
            };
            columns.push((format!("{}_{}", self.joint_key(k), self.joint_unit(*at)), source));
        }
        columns
    }

    /// Returns the lines of a table of observations with joints, positions and orientations.
    fn observations(&self, joints: &[usize], turned: &[usize]) -> Lines {
        let points = &self.found.points[0];
        let unit = self.unit(points).map_or(OPEN_UNIT, Unit::name);
        let mut columns = self.observation_columns(joints);
        for (name, at) in ["x", "y", "z"].into_iter().zip(points.columns) {
            columns.extend(at.map(|at| (format!("{name}_{unit}"), self.column(at))));
        }
        let angle = self.found.orientations.rotation.unit.unwrap_or(OPEN_UNIT);
        let order = self.found.orientations.rotation.order.as_deref();
        let names = if order == Some(ROTATION_VECTOR) { ["rx", "ry", "rz"] } else { ["a", "b", "c"] };
        match turned.len() {
            4 => {
                columns.extend(QUATERNION.into_iter().zip(turned).map(|(name, at)| (name.to_owned(), self.column(*at))))
            }
            _ => columns
                .extend(names.into_iter().zip(turned).map(|(name, at)| (format!("{name}_{angle}"), self.column(*at)))),
        }
        let remark = if self.are_open(joints) { JOINTS } else { "" };
        let mut lines = self.table_lines("observations", None).with(Line::Columns(columns)).with_text(remark);
        if let (3, Some(order)) = (turned.len(), order.filter(|order| *order != ROTATION_VECTOR)) {
            lines.push(Line::Text(format!("orientation = {}\n", quoted(order))));
        } else if turned.len() == 3 && order.is_none() {
            lines = lines.with_text(
                "orientation = \"?\"          # order of the three angles: \"zyx\", \"fixed xyz\" ..; without it the error names the orders that fit. Of a\n\
                 # rotation vector name the columns rx_UNIT, ry_UNIT, rz_UNIT instead\n",
            );
        }
        lines.followed_by(self.target_and_pose("probe", "the body that was measured"))
    }

    /// Returns the section and the form of a table, which a log in a known format states.
    fn table_lines(&self, section: &'static str, format: Option<LogKind>) -> Lines {
        let form = &self.best.form;
        let lines = Lines::section(section).with(Line::File(self.file.to_owned()));
        let mut out = String::new();
        match (&form.sheet, form.delimiter) {
            (Some(sheet), _) => {
                let _ = writeln!(out, "sheet = {}", quoted(sheet));
            }
            (None, delimiter) => {
                if let Some(format) = format {
                    let _ = writeln!(out, "format = {:?}", format.about().name);
                }
                let delimiter = delimiter.map_or(",", Delimiter::name);
                let _ = writeln!(out, "delimiter = {delimiter:?}\ndecimal = {:?}", form.decimal().name());
                if let Some(thousands) = form.thousands {
                    let _ = writeln!(out, "thousands = {:?}", thousands.name());
                }
            }
        }
        if let Some(comment) = &form.comment {
            let _ = writeln!(out, "comment = {}", quoted(comment));
        }
        if section != "log" && self.best.header != 1 {
            let _ = writeln!(out, "header = {}", self.best.header);
        }
        lines.with_text(out)
    }

    fn target_and_pose(&self, target: &str, what: &'static str) -> Lines {
        let mut lines = Lines::default();
        if self.found.first(Meaning::Target).is_none() {
            lines.push(Line::Target(Target::Named(target.to_owned(), what)));
        }
        if self.found.first(Meaning::Pose).is_none() {
            lines.push(Line::PoseByRow);
        }
        lines
    }

    /// Returns the lines of joints and one length (draw wire or ball bar).
    fn distances(&self, document: &mut FormatsDocument, joints: &[usize], distance: usize) -> Lines {
        document.kind = "observations".to_owned();
        document.because(self.named(&[joints, &[distance]].concat(), phrase!("says-joints-and-length")));
        document.ask(phrase!("ask-anchor"));
        let unit = self.table.columns[distance].heading.unit.unwrap_or(OPEN_UNIT);
        let mut columns = self.observation_columns(joints);
        columns.push((format!("distance_{unit}"), self.column(distance)));
        self.table_lines("observations", None)
            .with(Line::Columns(columns))
            .with_text(JOINTS)
            .with_text(
                "kind = \"distance\"\nconstants = { other = \"anchor\" }   # the point from which the distance is measured\n",
            )
            .followed_by(self.target_and_pose("ball", "the end of the wire on the robot"))
    }

    /// Returns the lines of joints, a commanded point and its difference from the measured point.
    fn computed(&self, document: &mut FormatsDocument, joints: &[usize]) -> Lines {
        let (Some(commanded), Some(difference)) = (&self.found.commanded.alone, &self.found.commanded.difference)
        else {
            return Lines::default();
        };
        document.kind = "export".to_owned();
        let both = commanded.columns.into_iter().chain(difference.columns).flatten().collect::<Vec<usize>>();
        document.because(self.named(&both, phrase!("says-commanded-and-difference")));
        document.doubt(phrase!("doubt-sign-of-difference"));
        let name = |at: usize| self.heading(at).map_or_else(|| format!("${}", at + 1), str::to_owned);
        let mut columns: Vec<(ColumnRole, ColumnSource)> = Vec::new();
        for (role, meaning) in [
            (ColumnRole::Label, Meaning::Label),
            (ColumnRole::Target, Meaning::Target),
            (ColumnRole::Pose, Meaning::Pose),
            (ColumnRole::Cycle, Meaning::Cycle),
        ] {
            columns.extend(self.found.first(meaning).map(|at| (role, ColumnSource::Heading(name(at)))));
        }
        for (axis, role) in [ColumnRole::X, ColumnRole::Y, ColumnRole::Z].into_iter().enumerate() {
            if let (Some(of), Some(from)) = (commanded.columns[axis], difference.columns[axis]) {
                columns.push((role, ColumnSource::Heading(format!("{} - {}", name(of), name(from)))));
            }
        }
        let has = |role: ColumnRole| columns.iter().any(|(of, _)| *of == role);
        let (named, numbered) =
            (has(ColumnRole::Label) || has(ColumnRole::Target), has(ColumnRole::Label) || has(ColumnRole::Pose));
        let unit = self.unit(commanded);
        let (form, columns) = (self.best.form.clone(), Columns::Named(columns));
        let dialect = Dialect { form, columns, ..Dialect::default() };
        let mut lines = self.new_export(dialect.to_string()).with_text(unit_line(unit.map(Unit::name)));
        if unit.is_none() {
            document.ask(self.unit_of_lengths(Some(commanded)));
        }
        if !named {
            lines.push(Line::Target(Target::Open));
        }
        if !numbered {
            lines.push(Line::PoseByRow);
        }
        if joints.len() >= 2 {
            document.kind = "export with joints".to_owned();
            document.ask(phrase!("ask-joints"));
            lines = lines.with_text(self.joints_line(joints)).with_text(JOINTS);
        }
        lines
    }

    /// Returns the remark on a table without joints and measured points.
    fn commanded(&self, document: &mut FormatsDocument) -> Lines {
        document.kind = "unknown".to_owned();
        if self.found.commanded.alone.is_some() {
            document.kind = "commanded".to_owned();
            let doubt = phrase!("doubt-all-commanded");
            document.facts.without_attained = Some(doubt.clone());
            document.doubt(doubt);
        }
        Lines::default().with_text(format!(
            "# `{}`: no column is a measured coordinate or a joint; state what the columns are in `columns`\n",
            self.file
        ))
    }

    /// Returns the lines of a log, in a known format or as delimited text.
    pub fn log(&self, kind: Option<LogKind>) -> Lines {
        let lines = self.table_lines("log", kind).with_text(match self.best.header {
            rows @ (0 | 1) => format!("header = {}\n", rows == 1),
            rows => format!("header = {rows}\n"),
        });
        let unit_of = |at: usize| {
            let name = self.table.columns[at].name.as_deref();
            name.zip(kind).and_then(|(name, kind)| kind.column_unit(name))
        };
        let mut columns = Vec::new();
        for (at, taken) in self.found.taken.iter().enumerate() {
            let key = match taken.meaning {
                Meaning::Pose => "pose".to_owned(),
                Meaning::Cycle => "cycle".to_owned(),
                Meaning::Label => "label".to_owned(),
                Meaning::Time => {
                    let unit = unit_of(at).or(self.found.clock.unit).filter(|u| ["s", "ms", "us", "ns"].contains(u));
                    let open = if kind.is_none() && self.found.clock.question.is_some() { OPEN_UNIT } else { "s" };
                    format!("time_{}", unit.unwrap_or(open))
                }
                _ => match unit_of(at) {
                    Some(unit @ ("s" | "ms" | "ns")) if self.found.first(Meaning::Time).is_none() => {
                        format!("time_{unit}")
                    }
                    _ => continue,
                },
            };
            let seconds = self.seconds(at).filter(|_| taken.meaning == Meaning::Time);
            columns.push((key, seconds.map_or_else(|| self.column(at), |computed| quoted(&computed))));
        }
        for (k, at) in self.found.joint_columns().into_iter().enumerate() {
            let unit =
                unit_of(at).filter(|unit| ["deg", "rad", "mm", "m"].contains(unit)).unwrap_or(self.joint_unit(at));
            columns.push(self.joint(k, at, unit));
        }
        lines.with(Line::Columns(columns)).with_text(JOINTS)
    }
}
