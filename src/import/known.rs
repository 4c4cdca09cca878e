//! Formats that say what they are: what `etalon formats` knows at a glance, and what holds no points at all.

/// What a file is.
pub(super) struct Known {
    /// As `format` states it; none where the file holds nothing that can be imported.
    pub format: Option<&'static str>,
    /// What it is, and by what it was known.
    pub what: &'static str,
    /// Whether the file states its unit itself.
    pub unit: Option<&'static str>,
}

/// By what a kind of file is known, what it is, and its `format`. One row a kind; the first that fits counts.
type Kind = (fn(&str) -> bool, &'static str, Option<&'static str>);

const KINDS: [Kind; 15] = [
    (|t| xml(t) && head(t).contains("QIFDocument"), "a QIF document", Some("qif")),
    (
        |t| xml(t) && (head(t).contains("digitalCalibrationCertificate") || head(t).contains("dfm.dk")),
        "a digital calibration certificate: results of a calibration, and no measured points",
        None,
    ),
    (|t| xml(t), "an XML document of no kind that is read", None),
    (
        |t| t.lines().take(20).any(|l| l.starts_with("// SpatialAnalyzer") || l.starts_with("// AXES =")),
        "a SpatialAnalyzer export of points: its comments say so",
        Some("spatialanalyzer"),
    ),
    (
        |t| t.lines().next().is_some_and(|l| l.starts_with("coordsystype,") && l.contains(",val1,val2,val3,")),
        "a list of stationary points measured through Leica's emScon interface: its header says so",
        Some("leica-emscon"),
    ),
    (
        |t| t.lines().take(5).any(|l| l.contains("Meas X    Meas Y     Nom X")),
        "a table of drilled holes in columns of fixed width: its header says so",
        Some("sdss-plate"),
    ),
    (
        |t| head(t).contains("PolyWorks|Inspector project description"),
        "a project description of PolyWorks|Inspector: its first line says so",
        Some("polyworks_project"),
    ),
    (
        |t| t.starts_with("Name,Control,Nom,Meas"),
        "a report of PolyWorks with a row for each control: its header says so",
        Some("polyworks_report"),
    ),
    (|t| t.starts_with("planid\tpartnb"), "a table of Zeiss Calypso: its header says so", Some("calypso")),
    (|t| t.starts_with("FILNAM/"), "DMIS output: its first record says so", Some("dmis")),
    (|t| t.starts_with("XYZIJK"), "an .xyz file of PC-DMIS: its first line says so", Some("pcdmis_xyz")),
    (|t| t.starts_with("#00:GEOPAK"), "a scan of GEOPAK-Win: its first record says so", Some("geopak_gws")),
    (|t| t.starts_with("ply\n") || t.starts_with("ply\r"), "a PLY file: its first line says so", Some("ply")),
    (|t| head(t).contains("= HEADER /"), "a VDA-FS file: its header says so", Some("vda_fs")),
    (
        |t| t.starts_with("// Header") && t.contains("Version;SJ-4"),
        "roughness parameters of a Mitutoyo SJ-410, and no coordinates",
        None,
    ),
];

fn xml(text: &str) -> bool {
    text.trim_start().starts_with('<')
}

/// Where a document says what it is.
fn head(text: &str) -> &str {
    let end = text.char_indices().nth(4000).map_or(text.len(), |(i, _)| i);
    &text[..end]
}

/// What the text says it is, if it does.
pub(super) fn known(text: &str) -> Option<Known> {
    let (_, what, format) = KINDS.into_iter().find(|(is, _, _)| is(text))?;
    let axes = || text.lines().find(|line| line.starts_with("// AXES ="));
    let unit = match format {
        Some("spatialanalyzer") => {
            ["mm", "m", "inch"].into_iter().find(|u| axes().is_some_and(|l| l.contains(&format!("({u})"))))
        }
        _ => None,
    };
    Some(Known { format, what, unit })
}
