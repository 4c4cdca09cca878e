//! Layout of a file: lines, headings, coordinates, their meaning.

pub(super) mod arrays;
pub(super) mod coordinates;
pub(super) mod headings;
pub(super) mod lines;
pub(super) mod meaning;
pub(super) mod table;
