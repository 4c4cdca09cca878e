//! Workbooks that other programs wrote: `tests/workbooks` holds made-up points (synthetic) under a title and a head, as
//! openpyxl 3.1 wrote them, and as LibreOffice Calc 7.4 saved that file again (strings shared, formulas with their value).

use crate::support::root;
use crate::support::scratch::copy_sample;
use etalon::base::phrase;
use etalon::campaign::Campaign;
use etalon::formats::propose_file;
use etalon::stages::gather::gather;
use std::path::PathBuf;

const SHEET: &str = "Points (mm)";

pub fn workbook(program: &str) -> PathBuf {
    root().join("tests/workbooks").join(format!("synthetic-{program}.xlsx"))
}

/// Points of the sheet by label, and the lines of rows that are refused.
type Read = (Vec<(String, [f64; 3])>, Vec<usize>);

fn read(program: &str) -> Result<Read, String> {
    let scratch = copy_sample("prexyt-cmm");
    std::fs::copy(workbook(program), scratch.path().join("exports/points.xlsx")).unwrap();
    let stated = format!(
        "[[export]]\nfile = \"exports/points.xlsx\"\nunit = \"mm\"\nformat = {{ sheet = \"{SHEET}\", header = [\"Name\", \"X\"], \
         columns = {{ label = \"Name\", x = \"X\", y = \"Y\", z = \"Z\" }} }}\n\n[feature.rails]"
    );
    scratch.replace("campaign.toml", "[feature.rails]", &stated);
    let imported = gather(&Campaign::read(&scratch.path()).unwrap()).map_err(|e| e.to_string())?;
    let of_workbook = imported.points.into_iter().filter(|p| p.export.ends_with(".xlsx"));
    let points = of_workbook.map(|p| (p.label.to_string(), p.xyz_mm)).collect();
    let source = imported.document.sources.iter().find(|s| s.file.ends_with(".xlsx")).unwrap();
    Ok((points, source.refused.iter().map(|r| r.line).collect()))
}

#[test]
fn workbooks_of_other_programs_read_with_all_their_digits() {
    let point = |label: &str, xyz| (label.to_owned(), xyz);
    let points = vec![
        point("K 1", [0.3, -1234.5678, 1e-7]),
        point("K 2", [1.0, 2.0, 3.0]),
        point("K 4", [12.5, 0.0, 0.333333333333333]),
        point("K 5", [1.3, 5.0, 6.0]),
    ];
    assert_eq!(read("libreoffice").unwrap(), (points, vec![7]));
    let told = read("openpyxl").unwrap_err();
    assert!(told.contains("points.xlsx:9") && told.contains("[not-a-number]") && told.contains("formula"), "{told}");
}

#[test]
fn a_proposal_names_the_sheet_and_the_columns_that_hold_points() {
    for program in ["openpyxl", "libreoffice"] {
        let proposed = propose_file(&workbook(program)).unwrap();
        let stated =
            format!("{{ sheet = \"{SHEET}\", header = 3, columns = [\"-\", \"label\", \"x\", \"y\", \"z\", \"-\"] }}");
        assert!(proposed.toml.contains(&stated), "{}", proposed.toml);
        assert_eq!(proposed.readings.len(), 1, "{:?}", proposed.readings);
        let other = phrase!("doubt-other-sheets", count = 1, sheets = ["Notes"]).into();
        assert!(proposed.doubts.contains(&other), "{:?}", proposed.doubts);
    }
}
