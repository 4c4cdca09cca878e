//! Exports with a reader of their own: what a campaign calls them.

use super::Decimal;

/// A format that says itself where its points are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reader {
    /// PolyWorks|Inspector report as CSV: one row for each control of a feature.
    PolyworksReport,
    /// PolyWorks|Inspector project description: its point primitives.
    PolyworksProject,
    /// Zeiss Calypso table file: characteristics (`_chr`) or features (`_fet`).
    Calypso,
    /// DMIS output: measured features with direction vectors.
    Dmis,
    /// The dialect of Mitutoyo GEOPAK: direction angles in degrees.
    GeopakDmis,
    /// PC-DMIS `.xyz`.
    PcdmisXyz,
    /// Mitutoyo GEOPAK-Win scanning, `.gws`.
    GeopakGws,
    /// Micro-Vu InSpec.
    Inspec,
    /// VDA-FS (DIN 66301): its points.
    VdaFs,
    /// PLY, text or binary.
    Ply,
}

/// Every reader with its name in a campaign and in words, and whether its decimal mark follows a setting.
const ALL: [(Reader, &str, &str, bool); 10] = [
    (Reader::PolyworksReport, "polyworks_report", "PolyWorks report", true),
    (Reader::PolyworksProject, "polyworks_project", "PolyWorks project description", false),
    (Reader::Calypso, "calypso", "Zeiss Calypso table", true),
    (Reader::Dmis, "dmis", "DMIS output", false),
    (Reader::GeopakDmis, "geopak_dmis", "DMIS output of GEOPAK (direction angles)", false),
    (Reader::PcdmisXyz, "pcdmis_xyz", "PC-DMIS xyz", false),
    (Reader::GeopakGws, "geopak_gws", "GEOPAK-Win scanning", false),
    (Reader::Inspec, "inspec", "Micro-Vu InSpec", false),
    (Reader::VdaFs, "vda_fs", "VDA-FS", false),
    (Reader::Ply, "ply", "PLY", false),
];

impl Reader {
    /// The reader and the decimal mark that `name` or `name, decimal comma` states.
    pub fn stated(text: &str) -> Option<(Self, Decimal)> {
        let (name, decimal) = match text.split_once(',') {
            Some((name, comma)) if comma.trim() == "decimal comma" => (name, Decimal::Comma),
            Some(_) => return None,
            None => (text, Decimal::Point),
        };
        let (reader, .., either) = ALL.iter().find(|(_, known, ..)| *known == name)?;
        (*either || decimal == Decimal::Point).then_some((*reader, decimal))
    }

    /// Names in a campaign.
    pub fn names() -> impl Iterator<Item = &'static str> {
        ALL.iter().map(|(_, name, ..)| *name)
    }

    /// In words.
    pub fn in_words(self) -> &'static str {
        ALL.iter().find(|(reader, ..)| *reader == self).map_or("", |(_, _, words, _)| words)
    }
}
