//! Budget of unpacked bytes: one rule for all files that are packed. Declared sizes are checked
//! before anything is unpacked, and actual sizes while it is unpacked.

use etalon_base::error;
use etalon_base::message::Message;
use std::io::{Cursor, Read};
use zip::ZipArchive;

/// Size (bytes) to which every file may unpack.
const LEAST: u64 = 128 << 20;
/// Ratio of unpacked to packed size beyond `LEAST`. Measured numbers pack to a third at best,
/// repeated messages to a fiftieth.
const RATIO: u64 = 100;

/// Bytes to which a file may unpack.
pub(crate) struct Budget {
    /// Kind of the file in messages.
    kind: &'static str,
    most: u64,
    left: u64,
}

impl Budget {
    /// Budget of a file of `packed` bytes, at most `most`.
    pub fn new(kind: &'static str, packed: usize, most: u64) -> Self {
        let most = most.min((packed as u64).saturating_mul(RATIO).max(LEAST));
        Self { kind, most, left: most }
    }

    /// Error of a file beyond the budget.
    pub fn exceeded(&self) -> Message {
        error!("unpacked-too-large", kind = self.kind, most_mib = self.most >> 20)
    }

    /// Checks a size that the file declares.
    pub fn check(&self, declared: u64) -> Result<(), Message> {
        if declared > self.left { Err(self.exceeded()) } else { Ok(()) }
    }

    /// Takes a number of bytes out of the budget.
    pub fn take(&mut self, bytes: u64) -> Result<(), Message> {
        self.check(bytes)?;
        self.left -= bytes;
        Ok(())
    }

    /// Unpacks bytes as far as the budget lasts.
    pub fn read(&mut self, from: impl Read, damaged: impl FnOnce() -> Message) -> Result<Vec<u8>, Message> {
        let mut unpacked = Vec::new();
        // an error beyond the budget is the size
        let read = from.take(self.left + 1).read_to_end(&mut unpacked);
        self.take(unpacked.len() as u64)?;
        read.map(|_| unpacked).map_err(|_| damaged())
    }

    /// Opens a zip archive whose declared sizes are within the budget.
    pub fn open<'a>(
        &self,
        bytes: &'a [u8],
        damaged: impl Fn(String) -> Message,
    ) -> Result<ZipArchive<Cursor<&'a [u8]>>, Message> {
        let mut archive = ZipArchive::new(Cursor::new(bytes)).map_err(|e| damaged(e.to_string()))?;
        let mut declared = 0_u64;
        for i in 0..archive.len() {
            let entry = archive.by_index_raw(i).map_err(|e| damaged(e.to_string()))?;
            declared = declared.saturating_add(entry.size());
        }
        self.check(declared).map(|()| archive)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::io::repeat;

    #[test]
    fn a_budget_is_a_size_or_a_multiple_of_the_file() {
        let most = |packed: usize| Budget::new("arrays", packed, 2 << 30).most;
        assert_eq!([most(0), most(1 << 20), most(4 << 20), most(1 << 30)], [LEAST, LEAST, 400 << 20, 2 << 30]);
        assert_eq!(Budget::new("workbook", 1 << 30, 64 << 20).most, 64 << 20);
    }

    #[test]
    fn declared_and_actual_sizes_end_at_the_budget() {
        let damaged = || error!("arrays-unreadable", format = "numpy");
        let mut budget = Budget::new("arrays", 0, 1 << 20);
        assert!(budget.check(1 << 20).is_ok() && budget.check(u64::MAX).is_err());
        assert_eq!(budget.read(repeat(0).take(1 << 19), damaged).unwrap().len(), 1 << 19);
        let error = budget.read(repeat(0), damaged).unwrap_err();
        assert!(error.is("unpacked-too-large", &[("kind", &"arrays"), ("most_mib", &1)]), "{error}");
    }
}
