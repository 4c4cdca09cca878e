//! Head of a table: the row at which the data begin, the rows above it that name the columns, and
//! the unit of lengths that the head gives.

use crate::Form;
use crate::lexer::{Row, row};
use crate::units::{is_other_unit, unit_cell, unit_word, without_brackets};
use std::collections::BTreeSet;
use std::ops::Range;

/// Maximum number of rows with numbers above the headings.
const SEARCHED: usize = 60;
/// Maximum number of rows above the headings that look like the data.
const MOST_ABOVE: usize = 8;
/// Maximum number of rows of counts above data without headings.
const MOST_COUNTS: usize = 3;
/// Number of rows that show how a data row looks.
const SAMPLE: usize = 200;
/// Maximum number of rows above the data that are searched for names of columns.
const MOST_ROWS: usize = 8;
/// Maximum number of lines above the data that are searched for a unit.
const MOST_LINES: usize = 400;

/// Rows above the data that name the columns.
#[derive(Clone, Debug, Default)]
pub struct Head {
    /// Name of each column: of its heading, behind the names of the groups that tell equal headings
    /// apart; `None` if no row has a name for each column.
    pub names: Option<Vec<String>>,
    /// Unit of each column in a row of units.
    pub units: Vec<Option<&'static str>>,
    /// Columns of other quantities than lengths, angles, times and temperatures, by the row of
    /// units.
    pub others: Vec<usize>,
    /// Name of the group of each column, in a row whose cells stand above several columns each.
    pub groups: Vec<Option<String>>,
    /// Line of the row that names the columns.
    pub line: Option<usize>,
    /// `true` if the row names groups of columns alone. Three members are x, y, z, others numbered.
    pub is_of_groups: bool,
}

/// Unit of lengths that the head of a file contains.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StatedUnit {
    /// Unit, spelled as in the keys of a campaign.
    pub unit: &'static str,
    /// Line of the statement.
    pub line: usize,
    /// Statement as the file writes it.
    pub how: String,
}

/// `true` if no field begins with a digit: rows of headings, and rows without numbers.
pub(crate) fn is_worded(row: &Row) -> bool {
    !row.fields.iter().any(|f| f.trim_start_matches(['+', '-', '.']).starts_with(|c: char| c.is_ascii_digit()))
}

/// Number of fields up to the last one that is filled.
pub(crate) fn filled_width(row: &Row) -> usize {
    row.fields.iter().rposition(|f| !f.is_empty()).map_or(0, |i| i + 1)
}

/// Returns the index of the first data row: the first row with two numbers, unless rows that look
/// like the data begin only below a row of headings.
pub(crate) fn first_data_row(
    all: &[Row],
    of_sheet: bool,
    is_number: &dyn Fn(&str) -> bool,
    is_gap: &dyn Fn(&str) -> bool,
) -> Option<usize> {
    let numbers = |row: &Row| row.fields.iter().filter(|f| is_number(f)).count();
    let first = all.iter().position(|row| numbers(row) >= 2)?;
    let data: Vec<&Row> = all[first..].iter().filter(|row| numbers(row) >= 2).take(SAMPLE).collect();
    let width = match of_sheet {
        true => None,
        false => most_common(data.iter().map(|row| filled_width(row))),
    };
    let of_width = |row: &Row| width.is_none_or(|width| filled_width(row) == width);
    let usual: Vec<&&Row> = data.iter().filter(|row| of_width(row)).collect();
    let columns = usual.iter().map(|row| row.fields.len()).max().unwrap_or(0);
    let holds = |row: &Row, at: usize| is_number(row.field(at)) || row.field(at).is_empty() || is_gap(row.field(at));
    let is_numeric = |at: &usize| {
        usual.iter().any(|row| is_number(row.field(*at)))
            && usual.iter().filter(|row| holds(row, *at)).count() * 5 >= usual.len() * 4
    };
    let numeric: Vec<usize> = (0..columns).filter(is_numeric).collect();
    let is_data = |row: &Row| numbers(row) >= 2 && of_width(row) && numeric.iter().all(|at| holds(row, *at));
    let searched = &all[first..all.len().min(first + SEARCHED)];
    let start = searched.iter().position(is_data)?;
    let is_heading = |row: &Row| is_worded(row) && row.fields.iter().filter(|f| !f.is_empty()).count() >= 2;
    if searched[..start].iter().any(is_heading) {
        return Some(first + start);
    }
    // a line of numbers above the headings may look like the data
    let names_all = |row: &Row| {
        let words: BTreeSet<&str> = row.fields.iter().map(AsRef::as_ref).collect();
        let distinct = words.len() == columns && row.fields.len() == columns && columns > 2;
        distinct && is_worded(row) && !words.iter().any(|word| word.is_empty() || is_gap(word))
    };
    let heading = searched.iter().take(MOST_ABOVE + 1).position(names_all);
    let below = heading.and_then(|at| Some(at + searched[at..].iter().position(is_data)?));
    // counts in front of the data, with the name of the file: whole numbers above fractions
    let numbers_in =
        |row: &Row, fits: &dyn Fn(&str) -> bool| row.fields.iter().filter(|f| is_number(f)).all(|f| fits(f));
    let are_counts =
        searched[..start].iter().all(|row| numbers_in(row, &|field| field.bytes().all(|b| b.is_ascii_digit())));
    let in_fractions =
        usual.iter().filter(|row| is_data(row)).all(|row| !numbers_in(row, &|field| !field.contains(['.', ','])));
    if below.is_none() && (1..=MOST_COUNTS).contains(&start) && are_counts && in_fractions && data.len() >= 4 * start {
        return Some(first + start);
    }
    Some(first + below.filter(|at| data.len() >= 4 * at).unwrap_or(0))
}

impl Head {
    /// Reads the head from the rows above the data of a table with this number of columns; in a row
    /// whose fields are separated by `blanks`, a unit in brackets belongs to the name before it.
    pub(crate) fn new(above: &[Row], columns: usize, blanks: bool) -> Self {
        let mut head = Self { units: vec![None; columns], ..Self::default() };
        // the number of rows that follow, and rows of delimiters alone
        let is_count = |row: &&Row| filled_width(row) < 2 && row.field(0).bytes().all(|b| b.is_ascii_digit());
        let mut rows = above.iter().rev().take(MOST_ROWS).skip_while(is_count).peekable();
        let Some(mut last) = rows.next() else { return head };
        if let Some(units) = units_row(last, columns)
            && let Some(named) = rows.peek().filter(|row| names_row(row, columns, blanks).is_some())
        {
            head.others = (0..columns).filter(|at| is_other_unit(without_brackets(last.field(*at)))).collect();
            (head.units, last) = (units, named);
            rows.next();
        }
        let members = || members_of_groups(last, columns).filter(|_| !blanks && rows.peek().is_none());
        let Some(mut names) = names_row(last, columns, blanks).or_else(members) else { return head };
        head.is_of_groups = last.fields.len() < columns;
        head.line = Some(last.line);
        // a column that the last row leaves empty is named by rows directly above it
        let mut is_above = true;
        let mut groups: Vec<Vec<(String, bool)>> = Vec::new();
        for row in rows {
            let is_group = is_worded(row) && (!blanks || row.fields.len() == columns);
            is_above &= is_group;
            // a row of bodies may have names such as `763:Neck`; the body that carries another one
            // does not name it
            let first = row.fields.iter().find(|field| !field.is_empty()).map_or("", |field| field);
            if (is_group || first == "Name" && names_bodies(row)) && first != "Parent" {
                let group = spread(row, columns);
                for (name, (cell, is_filled)) in names.iter_mut().zip(&group).filter(|_| is_above) {
                    if name.is_empty() && *is_filled {
                        name.clone_from(cell);
                    }
                }
                groups.push(group);
            }
        }
        // numbers of serial kind name a group worse than words
        groups
            .sort_by_key(|group| group.iter().filter(|(cell, _)| cell.contains(|c: char| c.is_ascii_digit())).count());
        if let Some(group) = groups.iter().find(|group| is_spread(group)) {
            head.groups = group.iter().map(|(cell, _)| Some(cell.clone()).filter(|cell| !cell.is_empty())).collect();
        }
        for group in groups {
            add_group(&mut names, &group);
        }
        head.names = Some(names);
        head
    }
}

/// `true` if the cells behind the first one are names, and no numbers.
fn names_bodies(row: &Row) -> bool {
    let cells = row.fields.iter().filter(|field| !field.is_empty()).skip(1);
    let is_name = |cell: &str| cell.contains(|c: char| c.is_alphabetic() || c == ':');
    cells.clone().count() > 1 && cells.clone().all(|cell| is_name(cell))
}

/// Names of all columns, if the row has a name for each.
fn names_row(row: &Row, columns: usize, blanks: bool) -> Option<Vec<String>> {
    let fields: Vec<&str> = row.fields.iter().map(AsRef::as_ref).collect();
    let mut names: Vec<String> = Vec::new();
    if blanks && fields.len() > columns {
        for field in fields {
            match names.last_mut().filter(|_| field.starts_with(['[', '('])) {
                Some(name) => name.extend([" ", field]),
                None => names.push(field.to_owned()),
            }
        }
        names.retain(|name| !name.is_empty());
        if names.len() != columns {
            return None;
        }
    } else {
        names = fields.into_iter().map(str::to_owned).collect();
    }
    // a header has words: counts and the name of the file are none
    let is_file = |name: &str| name.rsplit_once('.').is_some_and(|(_, end)| (2..=4).contains(&end.len()));
    let is_count = |name: &String| name.bytes().all(|b| b.is_ascii_digit());
    let is_word = |name: &String| name.contains(char::is_alphabetic);
    let are_counts = names.iter().any(is_count) && names.iter().all(|name| is_count(name) || is_file(name));
    (names.len() >= columns && names.iter().any(is_word) && !are_counts).then(|| {
        names.truncate(columns);
        names
    })
}

/// Names of the members of groups, if a row of words is shorter than the data and its cells stand
/// above several columns each.
fn members_of_groups(row: &Row, columns: usize) -> Option<Vec<String>> {
    const ANGLES: [&str; 7] = ["joint", "axis", "achse", "gelenk", "angle", "winkel", "encoder"];
    let group = spread(row, columns);
    let is_shorter = (2..columns).contains(&row.fields.len()) && !row.field(0).is_empty();
    if !is_shorter || !is_worded(row) || !is_spread(&group) {
        return None;
    }
    let starts: Vec<usize> = (0..columns).filter(|at| group[*at].1).collect();
    let ends = starts.iter().copied().skip(1).chain([columns]);
    let mut names = Vec::with_capacity(columns);
    for (from, to) in starts.iter().copied().zip(ends) {
        let name = &group[from].0;
        let is_of_angles = ANGLES.iter().any(|word| name.to_lowercase().contains(word));
        names.extend((0..to - from).map(|k| match to - from {
            1 => name.clone(),
            3 if !is_of_angles => format!("{name} {}", ["x", "y", "z"][k]),
            _ => format!("{name} {}", k + 1),
        }));
    }
    Some(names)
}

/// Unit of each column, if every filled cell but the first one of the row is a unit.
fn units_row(row: &Row, columns: usize) -> Option<Vec<Option<&'static str>>> {
    let units: Vec<Option<&'static str>> = (0..columns).map(|at| unit_cell(row.field(at))).collect();
    let empty = |cell: &str| cell.is_empty() || cell.chars().all(|c| !c.is_alphanumeric() && c != '"' && c != '\u{b0}');
    let is_other = |at: usize| is_other_unit(without_brackets(row.field(at)));
    let is_unit = |at: usize| units[at].is_some() || is_other(at) || empty(row.field(at));
    let count = units.iter().flatten().count() + (0..columns).filter(|at| is_other(*at)).count();
    let others = (1..columns).all(is_unit);
    (others && (count >= 2 || count == 1 && is_unit(0)) && filled_width(row) <= columns).then_some(units)
}

/// Cells of a row of groups, each spread over the empty cells to its right, and `true` for a cell
/// that is filled in the file.
fn spread(row: &Row, columns: usize) -> Vec<(String, bool)> {
    let mut last = "";
    let cell = |at: usize| {
        let field = row.field(at);
        if !field.is_empty() {
            last = field;
        }
        (last.to_owned(), !field.is_empty())
    };
    (0..columns).map(cell).collect()
}

/// `true` if two cells of a row stand above more than one column each.
fn is_spread(group: &[(String, bool)]) -> bool {
    group.windows(2).filter(|pair| pair[0].1 && !pair[1].1).count() >= 2
}

/// Puts the names of groups before headings that are equal, if they tell these apart.
fn add_group(names: &mut [String], group: &[(String, bool)]) {
    let is_equal = |i: usize, j: usize| i != j && names[i] == names[j];
    let columns = 0..names.len();
    let splits = |i: usize| !names[i].is_empty() && columns.clone().any(|j| is_equal(i, j) && group[i].0 != group[j].0);
    let split: Vec<bool> = columns.clone().map(splits).collect();
    // a group names all its columns whose heading is not unique
    let again = |i: usize| !names[i].is_empty() && columns.clone().any(|j| is_equal(i, j));
    let some = split.contains(&true);
    let named = |i: &usize| split[*i] || some && again(*i);
    let named: Vec<usize> = columns.clone().filter(named).collect();
    for at in named.into_iter().filter(|at| !group[*at].0.is_empty()) {
        names[at] = format!("{} {}", group[at].0, names[at]);
    }
}

/// Words of statements of a unit of lengths, in lower case.
const UNIT_KEYS: [&str; 12] = [
    "units",
    "unit",
    "einheiten",
    "einheit",
    "unités",
    "unité",
    "unita",
    "unità",
    "unidades",
    "unidad",
    "单位",
    "単位",
];

/// Unit of lengths that a word gives.
fn length_unit(word: &str) -> Option<&'static str> {
    unit_word(word.trim_matches(|c: char| matches!(c, '"' | '\'' | '(' | ')' | '[' | ']' | ';' | ',')))
        .filter(|unit| ["mm", "m", "cm", "um", "inch"].contains(unit))
}

/// Returns the units of lengths that are given in the lines above the data, which begin at the line
/// `first`: a key with its unit, a comment, or the cells of coordinates in rows of units. Cells in
/// these `columns` count.
pub fn stated_units(text: &str, form: &Form, first: usize, columns: &dyn Fn(usize) -> bool) -> Vec<StatedUnit> {
    let above = text.lines().take(first.saturating_sub(1).min(MOST_LINES)).enumerate();
    let mut stated: Vec<StatedUnit> = Vec::new();
    let plain = Form { comment: None, ..form.clone() };
    let is_comment = |line: &str| form.comment.as_deref().is_some_and(|mark| line.trim_start().starts_with(mark));
    let mut last: Option<Row> = None;
    for (i, line) in above.filter(|(_, line)| !line.trim().is_empty()) {
        let mut add = |unit: Option<&'static str>, how: &str| {
            stated.extend(unit.map(|unit| StatedUnit { unit, line: i + 1, how: how.trim().to_owned() }));
        };
        if let Some((unit, how)) = stated_in_words(line) {
            add(Some(unit), &line[how]);
            continue;
        }
        if is_comment(line) {
            continue;
        }
        let Ok(cells) = row("", i + 1, line, &plain) else { continue };
        let width = cells.fields.len();
        let is_key = |cell: &str| {
            let cell = cell.trim_end_matches([':', '=']).trim().to_lowercase();
            UNIT_KEYS.iter().any(|key| cell == *key || cell.ends_with(&format!(" {key}")))
        };
        for at in (0..width).filter(|at| is_key(cells.field(*at))) {
            add(length_unit(cells.field(at + 1)), &format!("{} {}", cells.field(at), cells.field(at + 1)));
        }
        for at in 0..width {
            if let Some(last) = last.as_ref().filter(|last| is_key(last.field(at))) {
                add(length_unit(cells.field(at)), &format!("{} {}", last.field(at), cells.field(at)));
            }
        }
        if units_row(&cells, width).is_some() {
            for at in (0..width).filter(|at| columns(*at)) {
                add(length_unit(cells.field(at)), cells.field(at));
            }
        }
        last = Some(cells);
    }
    stated
}

/// Unit that a line gives in words, and the place of the statement: `units: mm`, `UNITS=MM`,
/// `coordinates in mm`.
fn stated_in_words(line: &str) -> Option<(&'static str, Range<usize>)> {
    let lower = line.to_lowercase();
    // statements of other quantities than coordinates
    let others = ["uncert", "sigma", "std", "accuracy", "tolerance", "wavelength", "resolution", "rms"];
    if lower.len() != line.len() || others.iter().any(|word| lower.contains(word)) {
        return None;
    }
    let word = |from: usize| {
        let end = lower[from..].find(|c: char| !(c.is_alphanumeric() || "\u{b5}\u{3bc}\"".contains(c)));
        from..end.map_or(lower.len(), |end| from + end)
    };
    // the unit behind a word of these, and one of these marks
    let behind = |keys: &[&str], mark: &dyn Fn(&str) -> Option<usize>| {
        let places = keys.iter().flat_map(|key| lower.match_indices(key));
        places.filter(|(at, _)| lower[..*at].chars().next_back().is_none_or(|c| !c.is_alphanumeric())).find_map(
            |(at, key)| {
                let rest = at + key.len();
                let value = rest + mark(&lower[rest..])?;
                let opened = lower[value..].len() - lower[value..].trim_start_matches(['(', '[', ' ', '\t', '"']).len();
                let unit = word(value + opened);
                Some((length_unit(&lower[unit.clone()])?, at..unit.end))
            },
        )
    };
    let equals = |rest: &str| {
        let marked = rest.trim_start();
        marked.starts_with([':', '=', '/']).then(|| rest.len() - marked.len() + 1)
    };
    let lengths = ["coord", "length", "position", "dimension", "all values", "all units", "all data"];
    let measured = || behind(&["in"], &|rest| rest.starts_with(' ').then_some(1));
    let key = behind(&UNIT_KEYS, &equals);
    key.or_else(|| measured().filter(|_| lengths.iter().any(|word| lower.contains(word))))
}

/// Returns the count that occurs most often, the largest if there are several.
pub(crate) fn most_common(counts: impl Iterator<Item = usize>) -> Option<usize> {
    let mut times = std::collections::BTreeMap::new();
    counts.for_each(|count| *times.entry(count).or_insert(0usize) += 1);
    times.into_iter().max_by_key(|&(count, times)| (times, count)).map(|(count, _)| count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Delimiter;

    #[test]
    fn statements_of_a_unit_of_lengths_are_found_and_others_are_not() {
        let units = |text: &str| {
            let form = Form { comment: Some("#".to_owned()), ..Form::delimited(Delimiter::Comma) };
            let stated = stated_units(&format!("{text}\n1.5,2.5\n"), &form, 1 + text.lines().count(), &|_| true);
            stated.into_iter().map(|stated| (stated.unit, stated.line)).collect::<Vec<_>>()
        };
        for (text, unit) in [
            ("# units: mm", "mm"),
            ("UNITS=IN", "inch"),
            ("Length Units,Meters", "m"),
            ("Einheit: Millimeter", "mm"),
            ("# all coordinates in metres", "m"),
            ("X,Y\n[mm],[mm]", "mm"),
            ("Rate,Units\n100,mm", "mm"),
        ] {
            assert!(units(text).iter().all(|(found, _)| *found == unit) && !units(text).is_empty(), "{text}");
        }
        for text in [
            "# uncertainty unit: um",
            "# measured in 3 rows",
            "unit,x",
            "# tolerance in mm",
            "X,Y",
            "# inside in part 3",
        ] {
            assert!(units(text).is_empty(), "{text}: {:?}", units(text));
        }
        assert_eq!(units("Take,1\nX,Y\nmm,m"), [("mm", 3), ("m", 3)]);
    }
}
