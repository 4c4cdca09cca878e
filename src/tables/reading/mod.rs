//! From the text of a file to rows and columns.

pub(super) mod from_row;
pub mod guess;
pub(super) mod head;
pub mod lexer;
pub(super) mod marks;
pub mod sheet;
pub(super) mod text;
