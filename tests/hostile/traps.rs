//! The traps of export files that real software lays, by their numbers in the notes on formats.
//!
//! Elsewhere: 1 (`import::encoding`), 2 and 4 to 6 (`import::number`, laws::texts), 8 (reference::exports, the mixed
//! Leica files), 12 (reference::qif), 13, 14 and 17 (reference::readers), 9, 15 and 16 (reference::logs), 23 (hostile::qif,
//! `import::bounded`).

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample};
use etalon::base::catalogue::Phrase;
use etalon::base::message::Result;
use etalon::base::phrase;
use etalon::campaign::Campaign;
use etalon::formats::Format;
use etalon::formats::dialect::Unit;
use etalon::formats::{Point, read_file};
use etalon::stages::gather::{Gathered, gather};

#[derive(serde::Deserialize)]
struct Stated {
    format: Format,
}

/// Reads a text in a format, in millimetres.
fn read(text: &str, format: &str) -> Result<Vec<Point>> {
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    let stated: Stated = toml::from_str(&format!("format = {format}")).expect(format);
    read_file(file.path(), None, &stated.format, Unit::Millimetre)
}

fn said(text: &str, format: &str) -> String {
    read(text, format).expect_err(format).to_string()
}

const LXYZ: &str = "columns = [\"label\", \"x\", \"y\", \"z\"]";

/// The sample with other exports.
fn campaign(exports: &str, files: &[(&str, &str)]) -> (Scratch, Result<Gathered>) {
    let scratch = copy_sample("prexyt-cmm");
    let head = "name = \"d\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 20\ncoverage_factor = 2\n";
    let tail = "[log]\nfile = \"encoders.csv\"\ncolumns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n\
                [join]\nby = [\"pose\", \"cycle\"]\n[frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n";
    std::fs::write(scratch.path().join("campaign.toml"), format!("{head}{exports}\n{tail}")).unwrap();
    for (file, text) in files {
        std::fs::write(scratch.path().join(file), text).unwrap();
    }
    let imported = Campaign::read(&scratch.path()).and_then(|c| gather(&c));
    (scratch, imported)
}

#[test]
fn trap_2_a_comma_that_separates_and_marks_decimals_is_refused() {
    let told = said("A,1,25,2,5,3,75\n", &format!("{{ delimiter = \",\", decimal = \",\", {LXYZ} }}"));
    assert!(told.contains("error[comma-ambiguous]"), "{told}");
    let scratch = copy_sample("prexyt-cmm");
    scratch.replace("campaign.toml", "file = \"encoders.csv\"", "file = \"encoders.csv\"\ndecimal = \",\"");
    let told = Campaign::read(&scratch.path()).and_then(|c| gather(&c)).unwrap_err().to_string();
    assert!(told.contains("error[comma-ambiguous]"), "{told}");
}

#[test]
fn trap_3_a_semicolon_does_not_mean_a_decimal_comma() {
    let text = "P5;-274.556;-3189.212;-248.113;;;;\r\n";
    let points = read(text, &format!("{{ delimiter = \";\", {LXYZ} }}")).unwrap();
    assert_eq!(points[0].xyz_mm, [-274.556, -3189.212, -248.113]);
    let told = said(text, &format!("{{ delimiter = \";\", decimal = \",\", {LXYZ} }}"));
    assert!(told.contains("set `decimal = \".\"`"), "{told}");
    assert_eq!(told.matches("[not-a-number]").count(), 3, "all cells are told at once: {told}");
}

#[test]
fn trap_7_what_was_not_measured_is_listed_and_never_a_number() {
    let markers = ["---", "N/A", "nan", "1.#QNAN", "*********", "-1.#IND"];
    let rows: String = markers.iter().map(|m| format!("A;{m};{m};{m}\n")).collect();
    let text = rows + "B;1;*****;3\nC;;;\nD; ; ; \nE;1;2;3\n";
    let points = read(&text, &format!("{{ delimiter = \";\", {LXYZ} }}")).unwrap();
    let reasons: Vec<&Phrase> = points.iter().filter_map(|p| p.refused.as_deref()).collect();
    assert_eq!((points.len(), reasons.len()), (10, 9));
    assert_eq!(reasons[4], &phrase!("row-not-measured", column = "x", cell = "*********"));
    assert_eq!(reasons[6], &phrase!("row-not-measured", column = "y", cell = "*****"));
    assert_eq!(reasons[7], &phrase!("row-without-coordinates"));
    let half = read("A;1;;3\n", &format!("{{ delimiter = \";\", {LXYZ} }}")).unwrap();
    assert_eq!(half[0].refused.as_deref(), Some(&phrase!("row-cell-empty", column = "y")));
    // what the campaign states holds instead of all that
    let none = format!("{{ delimiter = \";\", {LXYZ}, missing = [\"999\"] }}");
    assert!(said("A;---;2;3\n", &none).contains("[not-a-number]: `---`"));
    assert!(read("A;999;2;3\n", &none).unwrap()[0].refused.is_some());
}

#[test]
fn trap_7_the_origin_counts_as_not_measured_unless_the_campaign_says_otherwise() {
    let files = [("o.txt", "K 0 0 0\nL 1 2 3\n")];
    let export = |missing: &str| {
        format!("[[export]]\nfile = \"o.txt\"\nunit = \"mm\"\nformat = {{ delimiter = \"blank\", {LXYZ}{missing} }}")
    };
    let refused = |missing: &str| {
        let imported = campaign(&export(missing), &files).1.unwrap();
        let source = imported.document.sources.into_iter().find(|s| s.kind.name() == "export").unwrap();
        (imported.points.len(), source.refused.into_iter().map(|r| r.reason.to_string()).collect::<Vec<_>>())
    };
    assert_eq!(refused(""), (1, vec!["not measured: 0 0 0".to_owned()]));
    assert_eq!(refused(", missing = [\"\"]"), (2, Vec::new()));
}

#[test]
fn trap_7_a_frame_on_measured_points_has_its_origin_at_one() {
    let read = |text: &str| {
        let export =
            format!("[[export]]\nfile = \"o.txt\"\nunit = \"mm\"\nformat = {{ delimiter = \"blank\", {LXYZ} }}");
        let imported = campaign(&export, &[("o.txt", text)]).1.unwrap();
        let warned = imported.document.messages.iter().any(|message| message.id == "origin-not-measured");
        (imported.points.len(), warned)
    };
    // the second point on the x axis, the third in the plane
    assert_eq!(read("K 0 0 0\nL 500.123 0 0\nM 300.4 400.2 0\nN 1.5 2.5 3.5\n"), (4, false));
    // measured points: one lost target, with a warning, or several
    assert_eq!(read("L 500.123 0.2 0.1\nK 0 0 0\nM 300.4 400.2 0.3\n"), (2, true));
    assert_eq!(read("K 0 0 0\nL 500.123 0.2 0.1\nM 0 0 0\nN 300.4 400.2 0.3\n"), (2, false));
    // two rows at the origin are no frame, whatever lies on an axis
    assert_eq!(read("K 0 0 0\nL 500.123 0 0\nM 0 0 0\n"), (1, false));
    // across a plane, z is 0 in all rows
    assert_eq!(read("K 0 0 0\nL 500.123 0.2 0\nM 300.4 400.2 0\n"), (2, true));
}

#[test]
fn trap_9_names_that_occur_twice_are_no_key() {
    let named = "{ delimiter = \",\", header = 1, columns = { label = \"name\", x = \"x\", y = \"y\", z = \"z\" } }";
    let told = said("name,x,y,z,x\nA,1,2,3,4\n", named);
    assert!(told.contains("[heading-twice]") && told.has_phrase("state-column-number"), "{told}");
    // the same target of a pose in two rows
    let files = [("o.txt", "K_1_1 1 2 3\nK_1_1 1 2 4\n")];
    let export =
        "[[export]]\nfile = \"o.txt\"\nunit = \"mm\"\nformat = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"";
    let told = campaign(export, &files).1.unwrap_err().to_string();
    assert!(
        told.says("error[target-twice] target=K pose=1") && told.has_phrase("target-twice.hint file=o.txt line=1"),
        "{told}"
    );
    // names of SpatialAnalyzer are keys with their group alone
    let points = read("G1, P1, 1, 2, 3\nG2, P1, 4, 5, 6\n", "\"spatialanalyzer\"").unwrap();
    assert_eq!(points.iter().map(|p| &*p.label).collect::<Vec<_>>(), ["G1::P1", "G2::P1"]);
}

#[test]
fn trap_10_rows_of_other_widths_trailing_fields_and_the_last_word() {
    let format = format!("{{ delimiter = \";\", {LXYZ}, end = \"END\" }}");
    let points = read("A;1;2;3;;;;\nB;4;5;6\nEND;;\n\n", &format).unwrap();
    assert_eq!(points.len(), 2);
    let told = said("A;1;2;3;7\nB;4;5\nC;1;2;3\n", &format);
    assert!(told.says("error[row-field-count] fields=5"), "{told}");
    assert!(told.says("error[row-field-count] fields=3"), "{told}");
    assert!(told.has_phrase("propose-format"), "{told}");
    assert!(said("A;1;2;3\nEND\nB;1;2;3\n", &format).says("error[rows-after-end] end=END"));
    // without a statement the word is not a point
    let told = said("A;1;2;3\nEND\n", &format!("{{ delimiter = \";\", {LXYZ} }}"));
    assert!(told.says("error[row-field-count] fields=1") && told.contains(":2\n"), "{told}");
}

#[test]
fn trap_11_a_header_with_blanks_in_its_names_is_found_by_its_words() {
    let text =
        "Plug Plate: 7\r\nDate: 2014\r\n\r\n    Meas X    Meas Y     Nom X\r\n    11.610   -10.090    11.650\r\n";
    let points = read(text, "{ widths = [10, 10, 10], header = \"Meas X\", columns = [\"x\", \"y\"] }").unwrap();
    assert_eq!(points[0].xyz_mm, [11.61, -10.09, 0.0]);
    let told = said(text, "{ widths = [10, 10, 10], header = \"Meas Q\", columns = [\"x\", \"y\"] }");
    assert!(told.says("[header-words-missing] words=Meas Q"), "{told}");
}

#[test]
fn trap_13_angles_of_a_direction_are_no_i_j_k() {
    let told = said("0.1 -0.4 -2.1 179.99 90.009 90.0\n", "\"xyzijk\"");
    assert!(told.says("error[direction-not-unit] length=220.450"), "{told}");
    assert!(told.has_phrase("skip-direction-angles"), "{told}");
    assert!(read("0.1 -0.4 -2.1 -1 0 0.001\n", "\"xyzijk\"").unwrap()[0].direction.is_some());
}

#[test]
fn trap_17_the_extension_of_a_file_says_nothing() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["points.csv", "points.igs", "points", "points.txt"] {
        let file = folder.path().join(name);
        std::fs::write(&file, "1.5 2.5 3.5\n").unwrap();
        let proposed = etalon::formats::propose_file(&file).unwrap();
        assert_eq!(proposed.readings[0].delimiter.as_deref(), Some("blank"), "{name}");
    }
    let told = said("1.5 2.5 3.5\n", "{ delimiter = \",\", columns = [\"x\", \"y\", \"z\"] }");
    assert!(told.says("error[row-field-count] fields=1") && told.contains("`etalon formats FILE`"), "{told}");
}

#[test]
fn trap_18_coordinates_rounded_coarser_than_the_instrument_are_told() {
    let rows = |digits: usize, slope: f64| -> String {
        let row = |i: usize| {
            let [x, y, z] = [1.23456 * i as f64, 7.7 / i as f64, 3.21 + slope * i as f64];
            format!("P{i} {x:.digits$} {y:.digits$} {z:.digits$}\n")
        };
        (1..9).map(row).collect()
    };
    let export = "[[export]]\nfile = \"o.txt\"\nunit = \"mm\"\nformat = \"polyworks\"";
    let warned = |digits, slope| {
        let imported = campaign(export, &[("o.txt", &rows(digits, slope))]).1.unwrap();
        imported.document.messages.iter().find(|m| m.id == "coordinates-rounded").map(|m| m.what.clone())
    };
    // the instrument's standard uncertainty is 0.01 mm
    let told = warned(1, 0.4321).unwrap();
    assert!(told.contains("(x to 0.1 mm, y to 0.1 mm, z to 0.1 mm)"), "{told}");
    // a height that is the same everywhere may be exact
    let told = warned(1, 0.0).unwrap();
    assert!(told.contains("(x to 0.1 mm, y to 0.1 mm)"), "{told}");
    assert_eq!((warned(3, 0.4321), warned(3, 0.0)), (None, None));
}

#[test]
fn trap_19_mixed_line_ends_and_a_last_line_without_one() {
    let points = read("A;1;2;3\r\nB;4;5;6\nC;7;8;9\rD;1;1;1", &format!("{{ delimiter = \";\", {LXYZ} }}")).unwrap();
    assert_eq!(
        points.iter().map(|p| (p.line, &*p.label)).collect::<Vec<_>>(),
        [(1, "A"), (2, "B"), (3, "C"), (4, "D")]
    );
}

#[test]
fn trap_20_more_columns_than_the_documentation_says_are_refused() {
    let row = (1..=21).map(|i| format!("{i}.5")).collect::<Vec<_>>().join(" ") + "\n";
    let columns = vec!["\"-\""; 15].join(", ");
    let told = said(&row, &format!("{{ delimiter = \"blank\", columns = [\"x\", \"y\", \"z\", {columns}] }}"));
    assert!(told.says("error[row-field-count] fields=21") && told.contains("18 fields"), "{told}");
}

#[test]
fn trap_21_a_target_that_a_spreadsheet_would_compute_is_refused() {
    for target in ["=1+1", "@SUM(A1)", "+K", "-K"] {
        let files = [("o.txt", format!("{target}_1_1 1 2 3\n"))];
        let files: Vec<(&str, &str)> = files.iter().map(|(f, t)| (*f, t.as_str())).collect();
        let export =
            "[[export]]\nfile = \"o.txt\"\nunit = \"mm\"\nformat = \"polyworks\"\nlabel = \"{target}_{pose}_{cycle}\"";
        let told = campaign(export, &files).1.unwrap_err().to_string();
        assert!(told.contains("error[target-formula]") && told.contains("o.txt:1"), "{told}");
    }
}

#[test]
fn trap_22_exports_relative_to_different_frames_are_told() {
    let text = |frame: &str, name: &str| format!("// Points Relative to Coordinate Frame '{frame}'\n{name}, 1, 2, 3\n");
    let export = |file: &str| format!("[[export]]\nfile = {file:?}\nunit = \"mm\"\nformat = \"spatialanalyzer\"\n");
    let files = [("a.txt", text("A::WORLD", "P")), ("b.txt", text("A::Tool", "Q"))];
    let files: Vec<(&str, &str)> = files.iter().map(|(f, t)| (*f, t.as_str())).collect();
    let imported = campaign(&(export("a.txt") + &export("b.txt")), &files).1.unwrap();
    let told = imported.document.messages.iter().find(|m| m.id == "frames-differ").unwrap();
    assert!(told.what.contains("`A::Tool`") && told.what.contains("`A::WORLD`"), "{}", told.what);
    let dialects: Vec<&str> = imported.document.sources.iter().map(|s| s.dialect.english()).collect();
    assert!(dialects.iter().any(|d| d.ends_with("relative to `A::Tool`")), "{dialects:?}");
}
