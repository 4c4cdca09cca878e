//! Rows of tables of a SQLite database, read in the order of their row ids: the storage of rosbag2
//! before MCAP (`.db3`).
//!
//! Source: SQLite database file format (sqlite.org/fileformat2.html), sections 1.3 (header), 1.6
//! (b-tree pages), 2.1 (records), 2.6 (schema).

use etalon_base::error;
use etalon_base::message::Message;

/// First bytes of a database.
pub(crate) const MAGIC: &[u8] = b"SQLite format 3\0";
/// Length of the header of the file, in front of the first page's content.
const HEADER: usize = 100;
/// Depth of b-trees; a page has at least four cells below it.
const DEEPEST: usize = 40;
/// Maximum size of a row (bytes).
const LARGEST_ROW: usize = 1 << 30;

/// Value of a column.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    Null,
    Whole(i64),
    Real(f64),
    Text(String),
    Bytes(Vec<u8>),
}

impl Value {
    /// Returns a whole number.
    pub fn whole(&self) -> Option<i64> {
        if let Self::Whole(value) = self { Some(*value) } else { None }
    }

    /// Returns a text.
    pub fn text(&self) -> Option<&str> {
        if let Self::Text(text) = self { Some(text) } else { None }
    }
}

/// Database in memory.
pub(crate) struct Database<'a> {
    bytes: &'a [u8],
    page_size: usize,
    /// Bytes of a page that hold content.
    usable: usize,
}

/// Row id and values of a row.
pub(crate) type Row = (i64, Vec<Value>);

impl<'a> Database<'a> {
    /// Reads the header.
    ///
    /// # Errors
    /// Fails for a file that ends early, a database with a write-ahead log, and text in UTF-16.
    pub fn new(bytes: &'a [u8]) -> Result<Self, Message> {
        let header = bytes.get(..HEADER).filter(|header| header.starts_with(MAGIC)).ok_or_else(|| broken("end"))?;
        let page_size = match u16::from_be_bytes([header[16], header[17]]) {
            1 => 65_536,
            size if size.is_power_of_two() && size >= 512 => usize::from(size),
            _ => return Err(broken("page")),
        };
        if header[18] > 1 || header[19] > 1 {
            return Err(broken("log"));
        }
        if header[56..60] != [0, 0, 0, 1] {
            return Err(broken("encoding"));
        }
        let usable = page_size - usize::from(header[20]);
        Ok(Self { bytes, page_size, usable })
    }

    /// Returns the number of the first page of a table; `None` if the table is missing.
    pub fn table(&self, name: &str) -> Result<Option<usize>, Message> {
        let mut root = None;
        self.each_row(1, &mut |(_, values)| {
            if let [Value::Text(kind), Value::Text(own), _, Value::Whole(page), ..] = &values[..]
                && kind == "table"
                && own == name
            {
                root = usize::try_from(*page).ok();
            }
            Ok(())
        })?;
        Ok(root)
    }

    /// Calls `each` with the rows of the table whose first page has this number.
    ///
    /// # Errors
    /// Fails if a page or a record is malformed, or `each` fails.
    pub fn each_row(&self, root: usize, each: &mut dyn FnMut(Row) -> Result<(), Message>) -> Result<(), Message> {
        // pages that follow, each with its depth
        let mut open = vec![(root, 0)];
        let (mut visited, mut room) = (0, self.bytes.len());
        while let Some((number, depth)) = open.pop() {
            visited += 1;
            if depth > DEEPEST || visited > self.bytes.len() / self.page_size {
                return Err(broken("page"));
            }
            let page = self.page(number)?;
            let start = if number == 1 { HEADER } else { 0 };
            let kind = page[start];
            let count = usize::from(u16::from_be_bytes([page[start + 3], page[start + 4]]));
            let pointers = start + if kind == INTERIOR { 12 } else { 8 };
            let cell = |i: usize| -> Result<usize, Message> {
                let at = pointers + 2 * i;
                let pair = page.get(at..at + 2).ok_or_else(|| broken("page"))?;
                Ok(usize::from(u16::from_be_bytes([pair[0], pair[1]])))
            };
            match kind {
                LEAF => {
                    for i in 0..count {
                        each(self.row(page, cell(i)?, &mut room)?)?;
                    }
                }
                INTERIOR => {
                    // the first child is taken off the list first
                    open.push((number_at(page, start + 8)?, depth + 1));
                    for i in (0..count).rev() {
                        open.push((number_at(page, cell(i)?)?, depth + 1));
                    }
                }
                _ => return Err(broken("page")),
            }
        }
        Ok(())
    }

    /// Returns a page; pages count from 1.
    fn page(&self, number: usize) -> Result<&'a [u8], Message> {
        let from = number.checked_sub(1).and_then(|index| index.checked_mul(self.page_size));
        let page = from.and_then(|from| self.bytes.get(from..from.checked_add(self.page_size)?));
        page.ok_or_else(|| broken("end"))
    }

    /// Returns the row of a cell. All rows together are smaller than the file, `room`: a page
    /// belongs to one row.
    fn row(&self, page: &[u8], at: usize, room: &mut usize) -> Result<Row, Message> {
        let mut at = at;
        let length = usize::try_from(varint(page, &mut at)?).map_err(|_| broken("record"))?;
        let id = varint(page, &mut at)?;
        if length > LARGEST_ROW {
            return Err(broken("record"));
        }
        *room = room.checked_sub(length).ok_or_else(|| broken("record"))?;
        // section 1.6: part of a long record is on further pages
        let most = self.usable - 35;
        let least = (self.usable - 12) * 32 / 255 - 23;
        let local = match least + length.saturating_sub(least) % (self.usable - 4) {
            _ if length <= most => length,
            part if part <= most => part,
            _ => least,
        };
        let mut record = page.get(at..at + local).ok_or_else(|| broken("record"))?.to_vec();
        let mut next = if local < length { number_at(page, at + local)? } else { 0 };
        while record.len() < length {
            let further = self.page(next)?;
            let part = (length - record.len()).min(self.usable - 4);
            record.extend_from_slice(&further[4..4 + part]);
            next = number_at(further, 0)?;
        }
        Ok((id, values(&record)?))
    }
}

/// Kinds of pages of tables.
const LEAF: u8 = 0x0d;
const INTERIOR: u8 = 0x05;

fn broken(fault: &str) -> Message {
    error!("database-unreadable", fault)
}

/// Returns the page number at a place.
fn number_at(page: &[u8], at: usize) -> Result<usize, Message> {
    let bytes = page.get(at..at + 4).ok_or_else(|| broken("page"))?;
    Ok(bytes.iter().fold(0, |number, byte| number << 8 | usize::from(*byte)))
}

/// Returns a whole number of one to nine bytes, and moves behind it.
fn varint(bytes: &[u8], at: &mut usize) -> Result<i64, Message> {
    let mut value: i64 = 0;
    for i in 0..9 {
        let byte = *bytes.get(*at).ok_or_else(|| broken("record"))?;
        *at += 1;
        if i == 8 {
            return Ok(value << 8 | i64::from(byte));
        }
        value = value << 7 | i64::from(byte & 0x7f);
        if byte < 0x80 {
            break;
        }
    }
    Ok(value)
}

/// Returns the values of a record.
fn values(record: &[u8]) -> Result<Vec<Value>, Message> {
    let mut at = 0;
    let head = usize::try_from(varint(record, &mut at)?).map_err(|_| broken("record"))?;
    if head > record.len() {
        return Err(broken("record"));
    }
    let mut body = head;
    let mut values = Vec::new();
    while at < head {
        let kind = varint(record, &mut at)?;
        let length = match kind {
            0 | 8 | 9 => 0,
            1..=4 => kind,
            5 => 6,
            6 | 7 => 8,
            12.. => (kind - 12) / 2,
            _ => return Err(broken("record")),
        };
        let end = usize::try_from(length).ok().and_then(|length| body.checked_add(length));
        let bytes = end.and_then(|end| record.get(body..end)).ok_or_else(|| broken("record"))?;
        body += bytes.len();
        let whole = || {
            let sign = bytes.first().is_some_and(|byte| *byte > 0x7f);
            bytes.iter().fold(if sign { -1 } else { 0 }, |value: i64, byte| value << 8 | i64::from(*byte))
        };
        values.push(match kind {
            0 => Value::Null,
            8 => Value::Whole(0),
            9 => Value::Whole(1),
            1..=6 => Value::Whole(whole()),
            7 => Value::Real(f64::from_bits(whole() as u64)),
            _ if kind % 2 == 0 => Value::Bytes(bytes.to_vec()),
            _ => Value::Text(String::from_utf8_lossy(bytes).into_owned()),
        });
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_of_one_to_nine_bytes() {
        let read = |bytes: &[u8]| {
            let mut at = 0;
            varint(bytes, &mut at).map(|value| (value, at)).ok()
        };
        assert_eq!(read(&[0x7f]), Some((127, 1)));
        assert_eq!(read(&[0x81, 0x00]), Some((128, 2)));
        assert_eq!(read(&[0xff; 9]), Some((-1, 9)));
        assert_eq!(read(&[0x80]), None);
    }

    #[test]
    fn values_of_every_kind() {
        // NULL, -2 in one byte, 300 in two, 0, 1, 1.5, a text and bytes
        let head = [9, 0, 1, 2, 8, 9, 7, 17, 14];
        let body = [&[0xfe, 0x01, 0x2c][..], &1.5_f64.to_be_bytes(), b"ab", &[7]].concat();
        let expected = [
            Value::Null,
            Value::Whole(-2),
            Value::Whole(300),
            Value::Whole(0),
            Value::Whole(1),
            Value::Real(1.5),
            Value::Text("ab".to_owned()),
            Value::Bytes(vec![7]),
        ];
        assert_eq!(values(&[&head[..], &body].concat()).unwrap(), expected);
        let cut = values(&[&head[..], &body[..5]].concat()).unwrap_err();
        assert!(cut.is("database-unreadable", &[("fault", &"record")]));
    }
}
