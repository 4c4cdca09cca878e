//! Formats with a reader of their own among the dialects that simulate writes and import reads back.

use super::dialects::Case;

const LOG: &str = "columns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"A\", rho2_mm = \"B\", rho3_mm = \"C\" }";
const BY_POSE: &str = "by = [\"pose\", \"cycle\"]";
const BY_ROW: &str = "header = false\npose = \"row\"\ncolumns = { rho1_mm = 1, rho2_mm = 2, rho3_mm = 3 }";

/// An export whose labels name target, pose and cycle.
macro_rules! labelled {
    ($format:literal, $unit:literal) => {
        concat!("format = \"", $format, "\"\nunit = \"", $unit, "\"\nlabel = \"{target}_{pose}_{cycle}\"")
    };
}

/// Exports without labels.
macro_rules! one_target {
    ($format:literal, $unit:literal) => {
        concat!(
            "format = \"",
            $format,
            "\"\nunit = \"",
            $unit,
            "\"\ntarget = \"K\"\npose = \"row\"\n",
            "[[export]]\nfile = \"exports/l.txt\"\nformat = \"",
            $format,
            "\"\nunit = \"",
            $unit,
            "\"\ntarget = \"L\"\npose = \"row\""
        )
    };
}

pub const CASES: [Case; 19] = [
    ("PolyWorks report", labelled!("polyworks_report", "mm"), 1.0, true, LOG, 1.0, BY_POSE),
    (
        "PolyWorks report, decimal comma",
        labelled!("polyworks_report, decimal comma", "m"),
        1000.0,
        true,
        LOG,
        1.0,
        BY_POSE,
    ),
    ("PolyWorks project", labelled!("polyworks_project", "um"), 0.001, true, LOG, 1.0, BY_POSE),
    ("Calypso", labelled!("calypso", "inch"), 25.4, true, LOG, 1.0, BY_POSE),
    ("Calypso, decimal comma", labelled!("calypso, decimal comma", "mm"), 1.0, true, LOG, 1.0, BY_POSE),
    ("Q-DAS", labelled!("aqdef", "m"), 1000.0, true, LOG, 1.0, BY_POSE),
    ("Q-DAS, decimal comma", labelled!("aqdef, decimal comma", "um"), 0.001, true, LOG, 1.0, BY_POSE),
    ("DMIS", labelled!("dmis", "m"), 1000.0, true, LOG, 1.0, BY_POSE),
    ("DMIS of GEOPAK", labelled!("geopak_dmis", "inch"), 25.4, true, LOG, 1.0, BY_POSE),
    ("GEOPAK-Win scan", labelled!("geopak_gws", "inch"), 25.4, true, LOG, 1.0, BY_POSE),
    ("InSpec", labelled!("inspec", "mm"), 1.0, true, LOG, 1.0, BY_POSE),
    ("VDA-FS", labelled!("vda_fs", "mm"), 1.0, true, LOG, 1.0, BY_POSE),
    ("PC-DMIS xyz, one target a file", one_target!("pcdmis_xyz", "inch"), 25.4, false, BY_ROW, 1.0, "by = \"row\""),
    ("PC-DMIS report", labelled!("pcdmis_report", "inch"), 25.4, true, LOG, 1.0, BY_POSE),
    ("PTX, one target a file", one_target!("ptx", "m"), 1000.0, false, BY_ROW, 1.0, "by = \"row\""),
    ("FANUC LS", labelled!("fanuc_ls", "mm"), 1.0, true, LOG, 1.0, BY_POSE),
    ("ABB RAPID", labelled!("abb_rapid", "mm"), 1.0, false, LOG, 1.0, BY_POSE),
    ("PCD, one target a file", one_target!("pcd", "m"), 1000.0, false, BY_ROW, 1.0, "by = \"row\""),
    ("PLY, one target a file", one_target!("ply", "m"), 1000.0, false, BY_ROW, 1.0, "by = \"row\""),
];
