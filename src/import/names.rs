//! Names, each once, in the order in which they came: found by a hash, never listed by it.

/// Names and where to find them.
pub(super) struct Names<'a> {
    /// In the order of their first time.
    pub all: Vec<&'a [u8]>,
    /// Place of a name plus one, where its hash falls or behind; a power of two of them, half of them free.
    slots: Vec<u32>,
    /// The place of the last name asked for, and of each name the one that came behind it: rows repeat.
    last: u32,
    next: Vec<u32>,
}

impl<'a> Names<'a> {
    pub fn new() -> Self {
        Self { all: Vec::new(), slots: vec![0; 1024], last: 0, next: Vec::new() }
    }

    /// The place of a name, and whether it is new.
    pub fn place(&mut self, name: &'a [u8]) -> (u32, bool) {
        let guess = self.next.get(self.last as usize).copied().unwrap_or_default();
        if self.all.get(guess as usize).is_some_and(|known| same(known, name)) {
            self.last = guess;
            return (guess, false);
        }
        let (place, new) = self.find(name);
        if new {
            self.next.push(0);
        }
        if let Some(next) = self.next.get_mut(self.last as usize) {
            *next = place;
        }
        self.last = place;
        (place, new)
    }

    fn find(&mut self, name: &'a [u8]) -> (u32, bool) {
        if 2 * self.all.len() >= self.slots.len() {
            self.slots = vec![0; 2 * self.slots.len()];
            for i in 0..self.all.len() {
                let slot = self.slot(self.all[i]);
                self.slots[slot] = i as u32 + 1;
            }
        }
        let slot = self.slot(name);
        match self.slots[slot] {
            0 => {
                self.all.push(name);
                self.slots[slot] = self.all.len() as u32;
                (self.all.len() as u32 - 1, true)
            }
            place => (place - 1, false),
        }
    }

    /// The slot of a name, or the free one that it would take.
    fn slot(&self, name: &[u8]) -> usize {
        let mask = self.slots.len() - 1;
        let mut slot = hash(name) as usize & mask;
        while self.slots[slot].checked_sub(1).is_some_and(|place| !same(self.all[place as usize], name)) {
            slot = (slot + 1) & mask;
        }
        slot
    }
}

/// Whether two names are the same; they are short, and a loop is quicker than a call.
#[inline]
fn same(a: &[u8], b: &[u8]) -> bool {
    a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a == b)
}

/// Eight bytes at a time, mixed by a multiplication as in the finalizer of SplitMix64 (Steele et al., OOPSLA 2014).
fn hash(name: &[u8]) -> u64 {
    let mix = |h: u64, word: u64| {
        let h = (h ^ word).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        h ^ (h >> 31)
    };
    let (words, rest) = name.as_chunks::<8>();
    let h = words.iter().fold(name.len() as u64, |h, word| mix(h, u64::from_le_bytes(*word)));
    mix(h, rest.iter().fold(1, |word, b| word << 8 | u64::from(*b)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_has_one_place_however_many_there_are() {
        let texts: Vec<String> = (0..5000).map(|i| format!("ball_{}", i % 1700)).collect();
        let mut names = Names::new();
        for (i, text) in texts.iter().enumerate() {
            assert_eq!(names.place(text.as_bytes()), ((i % 1700) as u32, i < 1700), "{text}");
        }
        assert_eq!(names.all.len(), 1700);
    }
}
