//! Interpretation of columns as coordinates of points, and of columns without headings.

use super::headings::{Word, stands_for};
use super::meaning::{Evidence, Interpretation, Meaning, PointSet};
use super::table::{Column, Table};
use etalon_base::catalogue::Phrase;
use etalon_base::phrase;

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

/// Returns the axis that a heading names, and its other words.
fn heading_axis(column: &Column) -> Option<(usize, String)> {
    const BEFORE: [&str; 10] = ["", "p", "pos", "t", "tcp", "pt", "c", "coord", "trans", "loc"];
    let words = &column.heading.words;
    let axis = |word: &str| {
        let last = word.chars().last()?;
        let at = ['x', 'y', 'z'].iter().position(|c| *c == last)?;
        let before = &word[..word.len() - 1];
        BEFORE.contains(&before).then(|| (at, before.to_owned()))
    };
    let places: Vec<usize> = (0..words.len()).filter(|i| axis(&words[*i]).is_some()).collect();
    let exact = places.iter().copied().find(|i| words[*i].len() == 1);
    let at = exact.or(places.first().copied())?;
    let (axis, before) = axis(&words[at])?;
    let mut rest = column.heading.without(at);
    if !before.is_empty() {
        rest.insert(0, before);
    }
    Some((axis, rest.join(" ")))
}

/// Returns the kind of a set by the words of its headings.
fn kind_by_words(tag: &str) -> Kind {
    let has = |meaning: Word| tag.split(' ').any(|word| stands_for(word, meaning));
    let long = |meaning: Word| tag.split(' ').any(|word| word.len() > 1 && stands_for(word, meaning));
    let neutral = [
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
        "point",
    ];
    match () {
        () if tag.is_empty() => Kind::Plain,
        () if has(Word::Uncertainty) || has(Word::Motion) || tag == "n" || long(Word::Normal) => Kind::Other,
        () if tag.split(' ').any(|word| {
            ["r", "rot", "rotation", "orientation", "euler", "rpy", "q", "quat", "quaternion"].contains(&word)
        }) =>
        {
            Kind::Other
        }
        () if has(Word::Difference) => Kind::Difference,
        () if tag == "target" => Kind::Named,
        () if has(Word::Commanded) && !long(Word::Measured) => Kind::Commanded,
        () if has(Word::Measured) => Kind::Measured,
        () if tag.split(' ').all(|word| neutral.contains(&word)) => Kind::Plain,
        () => Kind::Named,
    }
}

impl Interpretation {
    /// Finds coordinates: sets of x, y and z whose headings differ only in the axis.
    pub(super) fn coordinates(&mut self, table: &Table) {
        if !self.points.is_empty() {
            return;
        }
        let mut sets: Vec<Set> = Vec::new();
        for (i, column) in table.columns.iter().enumerate() {
            let free = self.taken[i].meaning == Meaning::Unknown && column.is_numeric();
            let Some((axis, tag)) = heading_axis(column).filter(|_| free) else { continue };
            match sets.iter_mut().find(|set| set.points.tag == tag && set.points.columns[axis].is_none()) {
                Some(set) => set.points.columns[axis] = Some(i),
                None => {
                    let mut columns = [None; 3];
                    columns[axis] = Some(i);
                    let kind = kind_by_words(&tag);
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
        if sets.iter().any(|set| set.kind == Kind::Difference) {
            // `x_t` beside `x_dif` is the commanded value
            for set in sets.iter_mut().filter(|set| set.points.tag == "t" || set.points.tag == "target") {
                set.kind = Kind::Commanded;
            }
        }
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

    /// Adds doubts and questions about the coordinates.
    fn judge(&mut self, sets: &[Set], table: &Table) {
        let one = |kind: Kind| sets.iter().find(|set| set.kind == kind).map(|set| set.points.clone());
        if self.points.is_empty()
            && let Some(commanded) = one(Kind::Commanded)
        {
            self.difference = one(Kind::Difference);
            if self.difference.is_some() {
                self.ask(phrase!("ask-sign-of-difference"));
            }
            self.commanded = Some(commanded);
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
        let bare = |set: &PointSet| set.columns.iter().flatten().any(|at| table.columns[*at].heading.bare_metre);
        if self.points.iter().any(bare) {
            self.doubt(phrase!("doubt-bare-metre"));
        }
    }

    /// Interprets columns without headings.
    ///
    /// Texts in front are the label. Values identify quaternions, rotation matrices, directions and
    /// times. The first other numbers are x, y and z.
    pub(super) fn by_position(&mut self, table: &Table) {
        let set = |found: &mut Self, at: usize, meaning: Meaning, why: Phrase| found.take(at, meaning, why);
        let numeric: Vec<usize> = (0..table.columns.len()).filter(|i| table.columns[*i].is_numeric()).collect();
        let leading = numeric.first().copied().unwrap_or(0);
        for (i, column) in table.columns.iter().enumerate().filter(|(_, column)| !column.is_numeric()) {
            if column.clock && column.texts != [""] && !column.texts.is_empty() {
                self.clock(i, column);
                continue;
            }
            let (meaning, why) = match () {
                () if column.texts.is_empty() || column.texts == [""] => (Meaning::Text, phrase!("why-empty")),
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
        let mut rest = numeric;
        if self.matrices_by_position(table, &rest) {
            return;
        }
        // a running number or a time in front
        let before = rest.len() % 3 == 1 && rest.len() > 3 || rest.len() == 8 || rest.len() == 5;
        let first = rest.first().map(|i| &table.columns[*i]);
        if let Some(column) = first.filter(|column| before && column.is_increasing() && !column.is_constant()) {
            let quaternion = rest.len() == 7 && table.are_unit([rest[3], rest[4], rest[5], rest[6]]);
            let step = column.numbers().take(2).collect::<Vec<f64>>();
            if !quaternion {
                match column.is_whole() && step.windows(2).all(|pair| pair[1] - pair[0] == 1.0) {
                    true => set(self, rest[0], Meaning::Count, phrase!("why-counts")),
                    false => {
                        set(self, rest[0], Meaning::Time, phrase!("why-increases"));
                        self.doubt(phrase!("doubt-first-increases"));
                    }
                }
                rest.remove(0);
            }
        } else if rest.len() % 3 == 1
            && first.is_some_and(Column::is_whole)
            && rest[1..].iter().take(3).all(|i| !table.columns[*i].is_whole())
        {
            set(self, rest[0], Meaning::Count, phrase!("why-whole-before-decimals"));
            rest.remove(0);
        }
        self.by_count(table, &rest);
    }

    /// Interprets the numbers of a row by their count and values.
    fn by_count(&mut self, table: &Table, rest: &[usize]) {
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
                self.doubt_until(Evidence::JointOrder, phrase!("doubt-six-without-headings"));
            }
            [_, _, _, _, _, _] | [_, _, _, _, _, _, _] if self.has_no_text() => {
                for (k, at) in rest.iter().enumerate() {
                    set(self, *at, Meaning::Joint(k), phrase!("why-as-many-as-joints"));
                }
                self.doubt_until(Evidence::JointOrder, phrase!("doubt-joints-without-headings", count = rest.len()));
            }
            [_, _] | [_, _, _] => self.point_at(rest),
            [x, y, z, ..] => {
                self.point_at(&[x, y, z]);
                if rest.len().is_multiple_of(3) {
                    self.doubt_until(
                        Evidence::JointOrder,
                        phrase!("doubt-points-without-headings", count = rest.len()),
                    );
                }
            }
            _ => {}
        }
    }

    fn has_no_text(&self) -> bool {
        !self.taken.iter().any(|taken| taken.meaning == Meaning::Label)
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
            match step {
                4 => self.point_at(&[at(from, 3), at(from, 7), at(from, 11)]),
                _ if from >= 3 => self.point_at(&[numeric[0], numeric[1], numeric[2]]),
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
