//! Messages of ROS 2 in CDR version 1: 4 bytes of encapsulation, primitive types aligned to their
//! size.
//!
//! Source: OMG DDS-XTypes 1.3, 7.4.

/// Reader of a message.
pub(crate) struct CdrReader<'a> {
    /// Data behind the encapsulation: alignment counts from here.
    data: &'a [u8],
    at: usize,
    is_big_endian: bool,
}

impl<'a> CdrReader<'a> {
    /// Returns a reader behind the encapsulation: 0 is big endian, 1 little endian.
    pub fn new(message: &'a [u8]) -> Option<Self> {
        let (start, data) = message.split_at_checked(4)?;
        let is_big_endian = match start[..2] {
            [0, 0] => true,
            [0, 1] => false,
            _ => return None,
        };
        Some(Self { data, at: 0, is_big_endian })
    }

    fn bytes<const N: usize>(&mut self) -> Option<[u8; N]> {
        let start = self.at.next_multiple_of(N);
        let mut bytes: [u8; N] = self.data.get(start..start + N)?.try_into().ok()?;
        self.at = start + N;
        if self.is_big_endian {
            bytes.reverse();
        }
        Some(bytes)
    }

    pub fn i32(&mut self) -> Option<i32> {
        self.bytes().map(i32::from_le_bytes)
    }

    pub fn u32(&mut self) -> Option<u32> {
        self.bytes().map(u32::from_le_bytes)
    }

    pub fn f64(&mut self) -> Option<f64> {
        self.bytes().map(f64::from_le_bytes)
    }

    /// Returns a text, whose length counts its closing zero.
    pub fn string(&mut self) -> Option<String> {
        let length = self.u32()? as usize;
        let bytes = self.data.get(self.at..self.at.checked_add(length)?)?;
        self.at += length;
        let bytes = bytes.strip_suffix(b"\0").unwrap_or(bytes);
        String::from_utf8(bytes.to_vec()).ok()
    }

    /// Returns a sequence; a count that the data cannot hold is no count.
    pub fn list<T>(&mut self, each: fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let count = self.u32()? as usize;
        if count > self.data.len() {
            return None;
        }
        (0..count).map(|_| each(self)).collect()
    }
}

/// Writer of a message, little-endian.
pub struct CdrWriter(Vec<u8>);

impl Default for CdrWriter {
    fn default() -> Self {
        Self(vec![0, 1, 0, 0])
    }
}

impl CdrWriter {
    /// Appends a primitive value, aligned to its size.
    pub fn value<const N: usize>(mut self, bytes: [u8; N]) -> Self {
        let behind = self.0.len() - 4;
        self.0.resize(4 + behind.next_multiple_of(N), 0);
        self.0.extend(bytes);
        self
    }

    /// Appends a whole number.
    pub fn whole(self, value: u32) -> Self {
        self.value(value.to_le_bytes())
    }

    /// Appends a number of elements.
    pub fn count(self, count: usize) -> Self {
        self.whole(u32::try_from(count).unwrap_or(u32::MAX))
    }

    /// Appends numbers.
    pub fn numbers(self, values: impl IntoIterator<Item = f64>) -> Self {
        values.into_iter().fold(self, |out, value| out.value(value.to_le_bytes()))
    }

    /// Appends a text, whose length counts its closing zero.
    pub fn text(self, text: &str) -> Self {
        let mut out = self.count(text.len() + 1);
        out.0.extend(text.bytes().chain([0]));
        out
    }

    /// Appends a `std_msgs/Header`.
    pub fn header(self, time_s: f64, frame: &str) -> Self {
        let (seconds, rest) = (time_s.floor(), time_s.fract());
        self.whole(seconds as u32).whole((rest * 1e9) as u32).text(frame)
    }

    /// Appends bytes without alignment.
    pub fn bytes(mut self, bytes: impl IntoIterator<Item = u8>) -> Self {
        self.0.extend(bytes);
        self
    }

    /// Returns the message.
    pub fn finish(self) -> Vec<u8> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use etalon_base::noise::Noise;

    #[derive(Clone, Debug)]
    enum Field {
        Whole(u32),
        Numbers(Vec<u64>),
        Text(String),
    }

    #[test]
    fn drawn_fields_read_back_bit_for_bit() {
        let mut noise = Noise::new(11, 1);
        let mut draw = |count: f64| noise.uniform(count / 2.0) + count / 2.0;
        for _ in 0..300 {
            let field = |_| match draw(3.0) as u8 {
                0 => Field::Whole(draw(4_294_967_296.0) as u32),
                // any bits: infinities and NaN too
                1 => Field::Numbers((0..draw(9.0) as u8).map(|_| draw(1.8e19) as u64).collect()),
                _ => Field::Text((0..draw(9.0) as u8).map(|_| ['a', '\u{e9}', '/'][draw(3.0) as usize]).collect()),
            };
            let fields: Vec<Field> = (0..30).map(field).collect();
            let message = fields.iter().fold(CdrWriter::default(), |out, field| match field {
                Field::Whole(value) => out.whole(*value),
                Field::Numbers(bits) => out.count(bits.len()).numbers(bits.iter().map(|bits| f64::from_bits(*bits))),
                Field::Text(text) => out.text(text),
            });
            let message = message.finish();
            let mut reader = CdrReader::new(&message).unwrap();
            for field in fields {
                match field {
                    Field::Whole(value) => assert_eq!(reader.u32(), Some(value)),
                    Field::Numbers(bits) => {
                        let read = reader.list(CdrReader::f64).unwrap();
                        assert_eq!(read.into_iter().map(f64::to_bits).collect::<Vec<_>>(), bits);
                    }
                    Field::Text(text) => assert_eq!(reader.string(), Some(text)),
                }
            }
            assert_eq!(reader.u32(), None);
        }
    }
}
