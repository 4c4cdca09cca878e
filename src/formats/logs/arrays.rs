//! Arrays of a file of NumPy or MATLAB as a table: a cell for each number, a column for each given
//! part of an array.

use etalon_base::message::{Message, Result};
use etalon_base::{error, files};
use std::fmt::Write as _;
use std::io::Read as _;
use std::path::Path;

/// Maximum unpacked size of the arrays of a file (bytes).
pub(super) const LARGEST: u64 = 2 << 30;

/// Numbers of an array.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Numbers {
    /// Real numbers.
    Real(Vec<f64>),
    /// Whole numbers, which a time in nanoseconds needs with all its digits.
    Whole(Vec<i64>),
}

/// An array with its name.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Array {
    pub name: String,
    /// Lengths along its axes.
    pub shape: Vec<usize>,
    pub numbers: Numbers,
    /// `true` if the numbers of a column are neighbours; `false` if the numbers of a row are
    /// neighbours.
    pub by_columns: bool,
}

/// An array that is written.
pub struct NewArray {
    /// Name.
    pub name: &'static str,
    /// Values.
    pub content: Content,
}

/// Values of an array that is written.
pub enum Content {
    /// A list of texts.
    Texts(Vec<String>),
    /// A list of numbers.
    Numbers(Vec<f64>),
    /// A list of counts or indices.
    Counts(Vec<u64>),
    /// A square matrix, row by row.
    Matrix(Vec<Vec<f64>>),
}

/// Returns the bytes of all values.
pub(super) fn encode<const N: usize, T: Copy>(values: &[T], bytes: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    values.iter().flat_map(|value| bytes(*value)).collect()
}

/// File of arrays, and the files in its folder that contain its numbers.
pub(crate) struct ArrayFile<'a> {
    pub bytes: &'a [u8],
    /// Names and bytes of these files.
    pub beside: Vec<(String, Vec<u8>)>,
}

impl<'a> From<&'a [u8]> for ArrayFile<'a> {
    fn from(bytes: &'a [u8]) -> Self {
        Self { bytes, beside: Vec::new() }
    }
}

impl<'a> ArrayFile<'a> {
    /// Reads the files of these names in the folder of a file; a name may be spelled in capitals.
    ///
    /// # Errors
    /// A file that is missing, cannot be read or is too large.
    pub fn read(path: &Path, bytes: &'a [u8], names: &[String]) -> Result<Self> {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let all = || std::fs::read_dir(folder).into_iter().flatten().flatten();
        let one = |name: &String| {
            let spelled = all().filter_map(|entry| entry.file_name().into_string().ok());
            let found = spelled.filter(|other| other.eq_ignore_ascii_case(name)).min();
            let shown = folder.join(found.as_ref().unwrap_or(name)).display().to_string();
            let Some(name) = found else { return Err(error!("numbers-file-missing", file = shown).into()) };
            let failed = |e: std::io::Error| error!("cannot-read-file", file = shown, reason = e.to_string());
            let (mut numbers, file) = (Vec::new(), files::open(&folder.join(&name)));
            file.and_then(|file| file.take(files::LARGEST + 1).read_to_end(&mut numbers)).map_err(failed)?;
            if numbers.len() as u64 > files::LARGEST {
                return Err(error!("file-too-large", file = shown, most_mib = files::LARGEST >> 20).into());
            }
            Ok((name, numbers))
        };
        Ok(Self { bytes, beside: names.iter().map(one).collect::<Result<_>>()? })
    }

    /// Returns the bytes of one of these files, whose name may be spelled in capitals; none if it
    /// is not there.
    pub fn beside(&self, name: &str) -> &[u8] {
        let found = self.beside.iter().find(|(other, _)| other.eq_ignore_ascii_case(name));
        found.map_or(&[], |(_, bytes)| bytes)
    }
}

/// Spelling of a part of an array: `q[:,0]` of NumPy, `q(:,1)` of MATLAB.
#[derive(Clone, Copy)]
pub(super) struct Spelling {
    pub open: char,
    pub close: char,
    /// Number of the first column.
    pub first: usize,
}

/// An array that can be columns of a table.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ArrayParts {
    pub name: String,
    /// Length of its longer axis.
    pub count: usize,
    /// Text of each part along the longer axis: `q[:,0]`, `q[:,1]`.
    pub parts: Vec<String>,
}

/// Part of an array.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Part {
    All,
    Column(usize),
    Row(usize),
}

impl Spelling {
    /// Splits a text into the name of an array and its part.
    fn split<'t>(&self, text: &'t str) -> Option<(&'t str, Part)> {
        let Some((name, index)) = text.split_once(self.open) else { return Some((text, Part::All)) };
        let (row, column) = index.strip_suffix(self.close)?.split_once(',')?;
        let number = |text: &str| text.trim().parse::<usize>().ok()?.checked_sub(self.first);
        let part = match (row.trim(), column.trim()) {
            (":", column) => Part::Column(number(column)?),
            (row, ":") => Part::Row(number(row)?),
            _ => return None,
        };
        Some((name.trim(), part))
    }

    /// Returns the text of the first column or row of an array, whichever is along its longer axis.
    fn example(&self, array: &Array) -> String {
        let Self { open, close, first } = self;
        match array.shape[..] {
            [rows, columns] if rows == 1 || columns == 1 => array.name.clone(),
            [rows, columns] if columns > rows => format!("{}{open}{first},:{close}", array.name),
            [_, _] => format!("{}{open}:,{first}{close}", array.name),
            _ => array.name.clone(),
        }
    }

    /// Returns the arrays, with the text of each part along the longer axis.
    pub fn parts(&self, arrays: &[Array]) -> Vec<ArrayParts> {
        let Self { open, close, first } = self;
        let parts = |array: &Array| {
            let name = &array.name;
            let (count, parts) = match array.shape[..] {
                [count] => (count, vec![name.clone()]),
                [rows, columns] if rows == 1 || columns == 1 => (rows * columns, vec![name.clone()]),
                [rows, columns] if columns > rows => {
                    (columns, (0..rows).map(|i| format!("{name}{open}{},:{close}", i + first)).collect())
                }
                [rows, columns] => {
                    (rows, (0..columns).map(|j| format!("{name}{open}:,{}{close}", j + first)).collect())
                }
                _ => return None,
            };
            Some(ArrayParts { name: name.clone(), count, parts })
        };
        arrays.iter().filter_map(parts).collect()
    }

    /// Returns texts of the arrays that can be columns.
    fn examples(&self, arrays: &[Array]) -> Vec<String> {
        arrays.iter().filter(|array| (1..=2).contains(&array.shape.len())).map(|array| self.example(array)).collect()
    }
}

/// Count, first index and step of the numbers of a part.
type Run = (usize, usize, usize);

impl Array {
    /// Returns where the numbers of a part are, if the array has this part.
    fn run(&self, part: Part) -> Option<Run> {
        let (rows, columns) = match self.shape[..] {
            [count] => {
                return (part == Part::All).then_some((count, 0, 1));
            }
            [rows, columns] => (rows, columns),
            _ => return None,
        };
        let (row_step, column_step) = if self.by_columns { (1, rows) } else { (columns, 1) };
        match part {
            Part::All => (rows == 1 || columns == 1).then_some((rows * columns, 0, 1)),
            Part::Column(j) => (j < columns).then_some((rows, j * column_step, row_step)),
            Part::Row(i) => (i < rows).then_some((columns, i * row_step, column_step)),
        }
    }

    fn write(&self, at: usize, into: &mut String) {
        let _ = match &self.numbers {
            Numbers::Real(values) => write!(into, "{}", values.get(at).copied().unwrap_or(f64::NAN)),
            Numbers::Whole(values) => write!(into, "{}", values.get(at).copied().unwrap_or_default()),
        };
    }
}

/// Returns the given parts of arrays as a table with these texts as header.
///
/// # Errors
/// Fails if an array is missing, a part is not one column or row, or two parts have different
/// lengths.
pub(super) fn table(arrays: &[Array], wanted: &[&str], spelling: Spelling) -> std::result::Result<String, Message> {
    let names = spelling.examples(arrays);
    let mut parts: Vec<(&str, &Array, Run)> = Vec::new();
    for &column in wanted {
        if parts.iter().any(|(other, ..)| *other == column) {
            continue;
        }
        let named = spelling.split(column);
        let found = named.and_then(|(name, part)| Some((arrays.iter().find(|array| array.name == name)?, part)));
        let Some((array, part)) = found else {
            let message = error!("array-missing", column);
            return Err(message.hint_names(column, names.iter().map(String::as_str)));
        };
        let Some(run) = array.run(part) else {
            let shape = array.shape.iter().map(usize::to_string).collect::<Vec<_>>().join(" x ");
            return Err(error!(
                "array-part-unknown",
                column,
                name = array.name,
                shape,
                example = spelling.example(array)
            ));
        };
        if let Some((other, _, (count, ..))) = parts.first().filter(|(.., (count, ..))| *count != run.0) {
            return Err(error!("array-lengths-differ", first = *other, count = *count, second = column, other = run.0));
        }
        parts.push((column, array, run));
    }
    let Some((.., (count, ..))) = parts.first() else {
        return Err(error!("log-columns-missing").hint_names("", names.iter().map(String::as_str)));
    };
    let mut text = parts.iter().map(|(column, ..)| *column).collect::<Vec<_>>().join("\t");
    for i in 0..*count {
        for (k, (_, array, (_, start, step))) in parts.iter().enumerate() {
            text.push(if k == 0 { '\n' } else { '\t' });
            array.write(start + i * step, &mut text);
        }
    }
    text.push('\n');
    Ok(text)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use etalon_base::noise::Noise;
    use etalon_base::phrase;

    /// Writes drawn arrays and reads them back; a list has `columns` columns (0: one axis). Texts
    /// are omitted when they are read.
    pub fn read_back(written: impl Fn(&[NewArray]) -> Vec<Array>, columns: usize) {
        let mut noise = Noise::new(5, 1);
        let mut draw = |count: f64| noise.uniform(count / 2.0) + count / 2.0;
        for _ in 0..200 {
            // any bits: infinities and NaN too
            let mut numbers =
                |count: usize| (0..count).map(|_| f64::from_bits(draw(1.8e19) as u64)).collect::<Vec<f64>>();
            let size = numbers(1)[0].to_bits() as usize % 7;
            let (list, matrix) = (numbers(3 * size), (0..size).map(|_| numbers(size)).collect::<Vec<_>>());
            let counts: Vec<u64> = (0..size as u64).map(|i| i * i).collect();
            let new = |name, content| NewArray { name, content };
            let read = written(&[
                new("text", Content::Texts(vec!["a\u{e9}".to_owned(); size])),
                new("list", Content::Numbers(list.clone())),
                new("counts", Content::Counts(counts.clone())),
                new("matrix", Content::Matrix(matrix.clone())),
            ]);
            assert_eq!(read.iter().map(|array| array.name.as_str()).collect::<Vec<_>>(), ["list", "counts", "matrix"]);
            let shape = |count: usize| if columns == 0 { vec![count] } else { vec![count, columns] };
            let shapes = [shape(3 * size), shape(size), vec![size, size]];
            assert_eq!(read.iter().map(|array| array.shape.clone()).collect::<Vec<_>>(), shapes);
            let bits = |array: &Array, part| {
                let (count, start, step) = array.run(part).unwrap();
                let Numbers::Real(values) = &array.numbers else { panic!("{array:?}") };
                (0..count).map(|i| values[start + i * step].to_bits()).collect::<Vec<u64>>()
            };
            let right = |values: &[f64]| values.iter().map(|value| value.to_bits()).collect::<Vec<u64>>();
            assert_eq!(bits(&read[0], Part::All), right(&list));
            assert_eq!(bits(&read[1], Part::All), right(&counts.iter().map(|n| *n as f64).collect::<Vec<f64>>()));
            for (i, row) in matrix.iter().enumerate() {
                assert_eq!(bits(&read[2], Part::Row(i)), right(row));
            }
        }
    }

    const NUMPY: Spelling = Spelling { open: '[', close: ']', first: 0 };
    const MATLAB: Spelling = Spelling { open: '(', close: ')', first: 1 };

    fn arrays() -> Vec<Array> {
        let array = |name: &str, shape: &[usize], values: &[f64]| Array {
            name: name.to_owned(),
            shape: shape.to_vec(),
            numbers: Numbers::Real(values.to_vec()),
            by_columns: false,
        };
        vec![
            array("t", &[2], &[0.5, 1.5]),
            array("q", &[2, 3], &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]),
            array("cube", &[1, 1, 1], &[1.0]),
        ]
    }

    #[test]
    fn parts_are_those_of_the_language() {
        let all = arrays();
        assert_eq!(
            table(&all, &["t", "q[:,0]", "q[:, 2]"], NUMPY).unwrap(),
            "t\tq[:,0]\tq[:, 2]\n0.5\t1\t3\n1.5\t4\t6\n"
        );
        assert_eq!(
            table(&all, &["t", "q(:,1)", "q(:,3)"], MATLAB).unwrap(),
            "t\tq(:,1)\tq(:,3)\n0.5\t1\t3\n1.5\t4\t6\n"
        );
        assert_eq!(table(&all, &["q[1,:]"], NUMPY).unwrap(), "q[1,:]\n4\n5\n6\n");
        let mut turned = all.clone();
        turned[1] = Array { shape: vec![3, 2], by_columns: true, ..turned[1].clone() };
        assert_eq!(table(&turned, &["q[:,1]"], NUMPY).unwrap(), "q[:,1]\n4\n5\n6\n");
    }

    #[test]
    fn parts_that_are_no_column_are_refused() {
        let error = |wanted: &[&str], spelling| table(&arrays(), wanted, spelling).unwrap_err();
        let hint = phrase!("known-names", names = ["t", "q[0,:]"]);
        assert!(error(&["joints[:,0]"], NUMPY).is("array-missing", &[("column", &"joints[:,0]"), ("hint", &hint)]));
        assert!(error(&["q"], NUMPY).is("array-part-unknown", &[("shape", &"2 x 3")]));
        assert!(
            error(&["q[:,3]"], NUMPY).is("array-part-unknown", &[])
                && error(&["cube"], NUMPY).is("array-part-unknown", &[])
        );
        // MATLAB counts from 1
        assert!(error(&["q(:,0)"], MATLAB).is("array-missing", &[]));
        let lengths = error(&["t", "q[1,:]"], NUMPY);
        assert!(lengths.is("array-lengths-differ", &[("first", &"t"), ("count", &2), ("other", &3)]), "{lengths}");
        assert!(error(&[], NUMPY).is("log-columns-missing", &[]));
    }
}
