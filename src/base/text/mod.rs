//! Texts that a person reads: messages, their catalogue, worded values, templates.

pub mod catalogue;
pub mod country;
pub mod message;
pub mod pattern;
pub mod template;
pub mod worded;
