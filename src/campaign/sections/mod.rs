//! Sections of campaign.toml that are checked together with the others.

pub(super) mod geometric;
pub(super) mod iso9283;
pub(super) mod join;
pub(super) mod mixed;
pub(super) mod selection;
pub(super) mod table;
pub(super) mod title;
