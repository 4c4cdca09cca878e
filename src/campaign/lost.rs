//! What of a TOML file does not count because it did not read: nobody shall draw conclusions from its absence.

/// The keys that lead to every entry that was taken away or filled in; a number among them counts tables of an array.
#[derive(Clone, Debug, Default)]
pub struct Lost(Vec<Vec<String>>);

impl Lost {
    /// Adds an entry.
    pub(super) fn add(&mut self, path: Vec<String>) {
        self.0.push(path);
    }

    /// Whether exactly this entry is among them.
    pub(super) fn holds(&self, path: &[String]) -> bool {
        self.0.iter().any(|lost| lost == path)
    }

    /// Whether something at, above or below these keys is lost.
    pub fn touches(&self, path: &[&str]) -> bool {
        self.0.iter().any(|lost| meet(lost, path))
    }

    /// The same, but for keys of this name.
    pub fn touches_beside(&self, path: &[&str], key: &str) -> bool {
        self.0.iter().any(|lost| meet(lost, path) && lost.last().is_none_or(|last| last != key))
    }

    /// Whether the entry itself is lost, or one above it, or an element of it.
    pub fn whole(&self, key: &str) -> bool {
        self.0.iter().any(|lost| lost.len() <= 2 && lost.first().is_some_and(|first| first == key))
    }

    /// Whether nothing is lost.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

fn meet(lost: &[String], path: &[&str]) -> bool {
    lost.iter().zip(path).all(|(a, b)| a == b)
}
