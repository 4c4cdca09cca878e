//! Names, each once, in the order in which they came.

use indexmap::IndexSet;

/// Names and where to find them.
#[derive(Default)]
pub(super) struct Names<'a> {
    /// In the order of their first time.
    pub all: IndexSet<&'a [u8]>,
    /// The place of the last name asked for, and of each name the one that came behind it: rows repeat.
    last: usize,
    next: Vec<usize>,
}

impl<'a> Names<'a> {
    /// The place of a name, and whether it is new.
    pub fn place(&mut self, name: &'a [u8]) -> (u32, bool) {
        let guess = self.next.get(self.last).copied().unwrap_or_default();
        let known = self.all.get_index(guess).is_some_and(|known| same(known, name));
        let (place, new) = if known { (guess, false) } else { self.all.insert_full(name) };
        if new {
            self.next.push(0);
        }
        if !known && let Some(next) = self.next.get_mut(self.last) {
            *next = place;
        }
        self.last = place;
        (place as u32, new)
    }
}

/// Whether two names are the same; they are short, and a loop is quicker than a call.
#[inline]
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_one_place_however_many_there_are() {
        let texts: Vec<String> = (0..5000).map(|i| format!("ball_{}", i % 1700)).collect();
        let mut names = Names::default();
        for (i, text) in texts.iter().enumerate() {
            assert_eq!(names.place(text.as_bytes()), ((i % 1700) as u32, i < 1700), "{text}");
        }
        assert_eq!(names.all.len(), 1700);
    }
}
