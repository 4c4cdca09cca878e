//! One language for all tables: columns by name, number or expression, constants, filters, several files.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends};
use etalon::base::phrase;
use etalon::base::pose::Pose;
use etalon::formats::{Export, TableReading, file_text, observations_with};
use etalon::identify::Settings;
use etalon::stages::kinds::{self, RowDefaults};
use etalon::stages::orientations::AngleOrder;
use std::path::Path;

fn layout(toml: &str) -> TableReading {
    let stated: etalon::campaign::ObservationsDefinition =
        toml::from_str(&format!("file = \"o.csv\"\n{toml}")).unwrap_or_else(|e| panic!("{toml}: {e}"));
    stated.reading()
}

fn said(text: &str, toml: &str) -> String {
    observations_with("o.csv", text, &layout(toml)).unwrap_err().to_string()
}

#[test]
fn the_same_table_however_it_is_laid_out() {
    let plain = "pose,target,kind,x_mm,y_mm,u_mm\n1,A,point,1.5,2.5,0.01\n2,A,point,3.5,4.5,0.02\n";
    let right = observations_with("o.csv", plain, &TableReading::default()).unwrap();
    for (text, stated) in [
        // no header, columns by number, constants, expanded uncertainties
        (
            "1;1,5;2,5;0,02\n2;3,5;4,5;0,04\n",
            "delimiter = \";\"\ndecimal = \",\"\nheader = false\ncoverage_factor = 2\nkind = \"point\"\ntarget = \"A\"\n\
             columns = { pose = 1, x_mm = 2, y_mm = 3, u_mm = 4 }",
        ),
        // computed columns; a title above the header; comments; rows that are left out
        (
            "report\npose|x_t|x dif|Y [m]|U95 um|flag\n# a comment\n1|2|0.5|0.0025|20|0\n1|99|0.5|0.0025|20|1\n2|4|0.5|0.0045|40|0\n",
            "delimiter = \"|\"\nheader = [\"x_t\", \"U95\"]\ncomment = \"#\"\ncoverage_factor = 2\nwithout = { flag = 1 }\n\
             constants = { target = \"A\", kind = \"point\" }\n\
             columns = { x_mm = \"x_t - x dif\", y_m = \"Y [m]\", u_um = \"U95 um\" }",
        ),
        (
            "p\ta\tx\ty\tmode\n1\tA\t0.75\t2.5\tgood\n2\tA\t1.75\t4.5\tgood\n3\tA\t1.75\t4.5\tbad\n",
            "delimiter = \"tab\"\nheader = 1\nonly = { mode = [\"good\", \"best\"] }\nkind = \"point\"\n\
             columns = { pose = \"p\", target = \"a\", x_mm = \"2 * x\", y_mm = \"y\", u_mm = \"0.01 * p\" }",
        ),
    ] {
        let read = observations_with("o.csv", text, &layout(stated)).unwrap_or_else(|e| panic!("{stated}: {e}"));
        assert_eq!(read.positions().unwrap(), right.positions().unwrap(), "{stated}");
        for (a, b) in read.numbers("u_mm").unwrap().iter().zip(right.numbers("u_mm").unwrap()) {
            assert!((a - b).abs() < 1e-15, "{stated}: {a} {b}");
        }
        for name in ["target", "kind", "pose", "cycle"] {
            assert_eq!(read.texts(name).unwrap(), right.texts(name).unwrap(), "{name} {stated}");
        }
    }
}

#[test]
fn cells_that_were_not_measured_are_missing_and_others_are_errors() {
    let text = "pose,target,x_mm,y_mm\n1,A,nan,2.5\n2,A,N/A,\n3,A,1.5,2.5\n";
    let read = observations_with("o.csv", text, &TableReading::default()).unwrap();
    let x = read.numbers("x_mm").unwrap();
    assert!(x[0].is_nan() && x[1].is_nan() && x[2] == 1.5, "{x:?}");
    // a computed value of a missing one is missing
    let computed = observations_with("o.csv", text, &layout("columns = { z_mm = \"x_mm + y_mm\" }")).unwrap();
    let z = computed.numbers("z_mm").unwrap();
    assert!(z[0].is_nan() && z[1].is_nan() && z[2] == 4.0, "{z:?}");
    for (stated, part) in [
        ("columns = { z_mm = \"x_mm + y_mn\" }", "did you mean `y_mm`"),
        ("columns = { z_mm = 9 }", "error[column-number-unknown]"),
        ("columns = { z_mm = \"x_mm / 0\" }", "error[computed-not-finite]"),
        ("columns = { z = 1 }", "error[observation-column-unknown]: `z`"),
        ("only = { quality = 1 }", "error[column-unknown]"),
        ("only = { target = \"B\" }", "error[no-row-selected]"),
        ("target = \"A\"", "error[stated-and-in-table]: `target`"),
        ("missing = [\"none\"]", "[not-a-number]: `nan`"),
    ] {
        let said = said(text, stated);
        assert!(said.contains(part), "{stated}: {said}");
    }
}

#[test]
fn an_encoding_may_be_stated_in_the_format() {
    let form = "delimiter = \";\", encoding = \"windows-1252\", columns = [\"label\", \"x\", \"y\", \"z\"]";
    let stated: Export = toml::from_str(&format!("file = \"t.csv\"\nunit = \"mm\"\nformat = {{ {form} }}"))
        .unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(stated.format.dialect.to_string(), format!("{{ {} }}", form.replace(", enc", ", decimal = \".\", enc")));
    let text = file_text(Path::new("t.csv"), b"H\xf6he;1;2;3\n", None, &stated.format).unwrap();
    assert_eq!(text, "H\u{f6}he;1;2;3\n");
    assert!(file_text(Path::new("t.csv"), b"H\xf6he;1;2;3\n", None, &Default::default()).is_err());
}

#[test]
fn exports_have_computed_columns_and_filters_too() {
    let read = |format: &str, text: &str| {
        let export: Export = toml::from_str(&format!("file = \"e.csv\"\nunit = \"mm\"\nformat = {format}\n"))
            .unwrap_or_else(|e| panic!("{format}: {e}"));
        let (points, problems) = export.format.read("e.csv", &text.into(), export.unit);
        (points.iter().map(|p| (p.xyz_mm, p.refused.clone())).collect::<Vec<_>>(), problems.to_string())
    };
    let text = "x_t;y_t;z_t;x_dif;y_dif;z_dif;deleted\n10;20;30;0,5;0,25;-1;0\n1;1;1;0;0;0;1\n";
    let (points, problems) = read(
        "{ delimiter = \";\", decimal = \",\", header = 1, columns = { x = \"x_t - x_dif\", y = \"y_t - y_dif\", z = \"z_t - z_dif\" }, \
         without = { deleted = 1 } }",
        text,
    );
    assert_eq!(points[0], ([9.5, 19.75, 31.0], None), "{problems}");
    assert_eq!(points[1].1.as_deref(), Some(&phrase!("row-left-out-by-cell", column = "deleted", cell = "1")));
    // without a header
    let (points, problems) =
        read("{ delimiter = \"blank\", columns = { x = \"25.4 * $2\", y = 3, z = \"$1\" } }", "1 2 3\n4 5 6\n");
    assert_eq!(points[1].0, [127.0, 6.0, 4.0], "{problems}");
    // slips: a wrong name, and a cell that is no number
    let format = "{ delimiter = \";\", decimal = \",\", header = 1, columns = { x = \"x_t - x_diff\", y = \"y_t\", z = \"z_t\" } }";
    let (_, problems) = read(format, text);
    assert!(problems.has_phrase("did-you-mean name=x_dif"), "{problems}");
    let (_, problems) = read(&format.replace("x_diff", "x_dif"), &text.replace("0,5", "half"));
    assert!(problems.contains("[not-a-number]: `half`") && problems.contains("e.csv:2"), "{problems}");
}

#[test]
fn several_tables_of_observations_are_one() {
    let whole = copy_sample("probe-poses");
    ends(&whole, "run", 0, &[]);
    let parts = copy_sample("probe-poses");
    let text = std::fs::read_to_string(parts.path().join("observations.csv")).unwrap();
    let (head, rows) = text.split_once('\n').unwrap();
    let half = rows.match_indices('\n').nth(rows.lines().count() / 2).unwrap().0 + 1;
    std::fs::write(parts.path().join("a.csv"), format!("{head}\n{}", &rows[..half])).unwrap();
    // the second file has semicolons, decimal commas and headings of its own
    let second = rows[half..].replace(',', ";").replace('.', ",");
    let head = head.replace("q1_deg", "J1").replace(',', ";");
    std::fs::write(parts.path().join("b.csv"), format!("{head}\n{second}")).unwrap();
    let stated = std::fs::read_to_string(parts.path().join("campaign.toml")).unwrap();
    let (before, after) = stated.split_once("[observations]").unwrap();
    let after = after.split_once("\n[").map_or("", |(_, after)| after);
    let tables = "[[observations]]\nfile = \"a.csv\"\n[[observations]]\nfile = \"b.csv\"\ndelimiter = \";\"\ndecimal = \",\"\n\
                  columns = { q1_deg = \"J1\" }\n";
    std::fs::write(parts.path().join("campaign.toml"), format!("{before}{tables}\n[{after}")).unwrap();
    ends(&parts, "check", 0, &[]);
    ends(&parts, "run", 0, &[]);
    assert_eq!(parts.parameters().parameters, whole.parameters().parameters);
    // an error of the second file names it and its line
    let wrong = second.replacen(';', ";=x", 2).replacen(";=x", ";", 1);
    std::fs::write(parts.path().join("b.csv"), format!("{head}\n{wrong}")).unwrap();
    ends(&parts, "check", 2, &["b.csv:2"]);
    // an error that is found in all rows together: a target that nobody measures in that way
    let lost = second.replacen(";probe;", ";;", 1);
    std::fs::write(parts.path().join("b.csv"), format!("{head}\n{lost}")).unwrap();
    ends(&parts, "check", 2, &["b.csv"]);
}

#[test]
fn tests_of_poses_read_tables_in_any_layout() {
    let plain = copy_sample("pose-test");
    ends(&plain, "run", 0, &[]);
    let own = copy_sample("pose-test");
    for name in ["poses.csv", "commanded.csv", "reference.csv"] {
        let text = std::fs::read_to_string(own.path().join(name)).unwrap();
        let text = text.replace("x_mm", "X").replace(',', ";").replace('.', ",");
        std::fs::write(own.path().join(name), text).unwrap();
    }
    own.replace(
        "campaign.toml",
        "[poses]\n",
        "[poses]\ndelimiter = \";\"\ndecimal = \",\"\ncolumns = { x_mm = \"X\", approach = \"Anfahrt\" }\n",
    );
    ends(&own, "run", 0, &[]);
    let document = |scratch: &Scratch| std::fs::read_to_string(scratch.path().join("out/iso9283.json")).unwrap();
    let characteristics = |text: String| text.split_once("\"poses\"").map(|(_, rest)| rest.to_owned()).unwrap();
    assert_eq!(characteristics(document(&plain)), characteristics(document(&own)));
    // the command
    let program = |scratch: &Scratch, more: &[&str]| {
        let arguments =
            [&["iso9283", "pose", "poses.csv", "--commanded", "commanded.csv", "--json"][..], more].concat();
        let output =
            std::process::Command::new(crate::support::program()).args(arguments).current_dir(scratch.path()).output();
        let output = output.unwrap();
        (String::from_utf8(output.stdout).unwrap(), String::from_utf8(output.stderr).unwrap())
    };
    let (right, said) = program(&plain, &[]);
    let options = ["--delimiter", "semicolon", "--decimal", "comma", "--column", "x_mm=X"];
    let (found, said_too) = program(&own, &options);
    assert!(!right.is_empty() && right == found, "{said} {said_too}");
    let (_, said) = program(&own, &[]);
    assert!(said.contains("--delimiter"), "{said}");
    // headings that one of the tables has: each is stated
    let both = [&options[..], &["--column", "x_mm=Soll X"]].concat();
    assert_eq!(program(&own, &both).0, right);
    let commanded = std::fs::read_to_string(own.path().join("commanded.csv")).unwrap().replacen('X', "Soll X", 1);
    std::fs::write(own.path().join("commanded.csv"), &commanded).unwrap();
    for (first, second) in [("x_mm=X", "x_mm=Soll X"), ("x_mm=Soll X", "x_mm=X")] {
        let stated = ["--delimiter", ";", "--decimal", ",", "--column", first, "--column", second];
        let (found, said) = program(&own, &stated);
        assert!(found == right, "{said}");
    }
    // a heading is missing: the hint does not offer columns that are read as what they are
    let (_, said) = program(&own, &options);
    assert!(said.says("error[column-unknown] column=x_mm") && said.contains("Soll X"), "{said}");
    assert!(!said.contains("one of: pose"), "{said}");
    // marks of the section apply to a table with its own columns
    let own_columns = "commanded = { file = \"commanded.csv\", columns = { x_mm = \"Soll X\" } }";
    own.replace("campaign.toml", "commanded = \"commanded.csv\"", own_columns);
    ends(&own, "run", 0, &[]);
    assert_eq!(characteristics(document(&plain)), characteristics(document(&own)));
    // both headings in one table
    std::fs::write(own.path().join("commanded.csv"), commanded.replacen("y_mm", "X", 1)).unwrap();
    let (_, said) = program(&own, &both);
    assert!(said.says("error[option-column-ambiguous] column=x_mm"), "{said}");
}

/// `etalon ARGS` in the folder of a campaign: exit code and output.
fn answer(scratch: &Scratch, arguments: &[&str]) -> (Option<i32>, String) {
    let output = std::process::Command::new(crate::support::program())
        .args(arguments)
        .current_dir(scratch.path())
        .output()
        .unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout) + &text(output.stderr))
}

#[test]
fn commands_read_tables_in_the_same_language() {
    // joint values of an arm: commas and names of etalon, or a file of another program
    let scratch = copy_sample("probe-poses");
    let file = |name: &str, text: &str| std::fs::write(scratch.path().join(name), text).unwrap();
    let joints = |sep: &str, point: &str, i: usize| {
        let values: Vec<String> = (1..=6).map(|k| format!("{}.{}", (7 * i * k) % 60, k).replace('.', point)).collect();
        format!("{i}{sep}{}", values.join(sep))
    };
    let head = "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n";
    file("plain.csv", &(head.to_owned() + &(1..9).map(|i| joints(",", ".", i) + "\n").collect::<String>()));
    let other: String = (1..9).map(|i| joints(";", ",", i) + "\n").collect();
    file("other.csv", &format!("% made elsewhere\nNr;A1;A2;A3;A4;A5;A6\n{other}"));
    file("bare.csv", &other);
    let of_robot = |table: &'static str, more: &[&'static str]| {
        let (code, said) =
            answer(&scratch, &[&["kinematics", "direct", table, "--robot", "robot.toml"], more].concat());
        assert_eq!(code, Some(0), "{table}: {said}");
        said
    };
    let plain = of_robot("plain.csv", &[]);
    let named = [
        "--delimiter",
        ";",
        "--decimal",
        ",",
        "--comment",
        "%",
        "--column",
        "pose=Nr",
        "--column",
        "q1_deg=A1",
        "--column",
        "q2_deg=A2",
        "--column",
        "q3_deg=A3",
        "--column",
        "q4_deg=A4",
        "--column",
        "q5_deg=A5",
        "--column",
        "q6_deg=A6",
    ];
    assert_eq!(of_robot("other.csv", &named), plain);
    let numbered = [
        "--delimiter",
        ";",
        "--decimal",
        ",",
        "--no-header",
        "--column",
        "pose=1",
        "--column",
        "q1_deg=2",
        "--column",
        "q2_deg=3",
        "--column",
        "q3_deg=4",
        "--column",
        "q4_deg=5",
        "--column",
        "q5_deg=6",
        "--column",
        "q6_deg=7",
    ];
    assert_eq!(of_robot("bare.csv", &numbered), plain);
    // a slip: the exchanged decimal mark is refused
    let (code, said) = answer(
        &scratch,
        &["kinematics", "direct", "other.csv", "--robot", "robot.toml", "--delimiter", ";", "--comment", "%"],
    );
    assert!(code == Some(2) && said.contains("error["), "{said}");
}

#[test]
fn loads_are_read_in_the_same_language() {
    let text = include_str!("../../samples/pose-test/loads.csv");
    let scratch = Scratch::with(&[
        ("plain.csv", text),
        ("other.csv", &text.replace(',', ";").replace('.', ",").replacen("force_n", "F [N]", 1)),
    ]);
    let of = |table: &str, more: &[&str]| {
        let (code, said) = answer(&scratch, &[&["iso9283", "compliance", table, "--json"], more].concat());
        assert_eq!(code, Some(0), "{said}");
        said
    };
    let plain = of("plain.csv", &[]);
    let stated = ["--delimiter", ";", "--decimal", ",", "--column", "force_n=F [N]"];
    assert_eq!(of("other.csv", &stated), plain);
}

/// Tables of a section in a form of their own, in several files: the same characteristics.
#[test]
fn tables_inside_other_sections_state_their_form() {
    let plain = copy_sample("pose-test");
    ends(&plain, "run", 0, &[]);
    let own = copy_sample("pose-test");
    let text = |name: &str| std::fs::read_to_string(own.path().join(name)).unwrap();
    let write = |name: &str, text: String| std::fs::write(own.path().join(name), text).unwrap();
    // loads in kilograms of a thousandth of a newton, half of them in each of two files, with rows that are deleted
    let loads = text("loads.csv");
    let rows: Vec<&str> = loads.lines().skip(1).collect();
    let row = |line: &&str| {
        let mut cells: Vec<String> = line.split(',').map(str::to_owned).collect();
        cells[2] = format!("{}", 1000.0 * cells[2].parse::<f64>().unwrap());
        format!("{};0\n", cells.join(";").replace('.', ","))
    };
    let head = "Belastung\nRichtung;Zyklus;F [mN];X;Y;Z;weg\n";
    let deleted = "+x;9;nan;1;2;3;1\n";
    let (first, second) = rows.split_at(rows.len() / 2);
    for (name, part) in [("lx.csv", first), ("ly.csv", second)] {
        write(name, head.to_owned() + &part.iter().map(row).collect::<String>() + deleted);
    }
    // commanded poses without a header, separated by blanks
    let commanded = text("commanded.csv");
    write("cmd.txt", commanded.split_once('\n').unwrap().1.replace(',', " "));
    own.replace(
        "campaign.toml",
        "file = \"loads.csv\"",
        "file = [\"lx.csv\", \"ly.csv\"]\ndelimiter = \";\"\ndecimal = \",\"\nheader = 2\n\
         columns = { direction = \"Richtung\", cycle = \"Zyklus\", force_n = \"F [mN] / 1000\", x_mm = \"X\", y_mm = \"Y\", z_mm = \"Z\" }\n\
         without = { weg = 1 }",
    );
    own.replace(
        "campaign.toml",
        "commanded = \"commanded.csv\"",
        "commanded = { file = \"cmd.txt\", delimiter = \"blank\", header = false, columns = { pose = 1, x_mm = 2, y_mm = 3, z_mm = 4, \
         a_deg = 5, b_deg = 6, c_deg = 7 } }",
    );
    let said = ends(&own, "run", 0, &[]);
    assert!(!said.contains("columns-not-read"), "{said}");
    let document = |scratch: &Scratch, name: &str| {
        let text = std::fs::read_to_string(scratch.path().join("out").join(name)).unwrap();
        serde_json::from_str::<serde_json::Value>(&text).unwrap()
    };
    assert_eq!(document(&own, "iso9283.json"), document(&plain, "iso9283.json"));
    let directions = |scratch: &Scratch| {
        let all = document(scratch, "iso9283-compliance.json")["directions"].clone();
        let all: Vec<(String, f64)> = all
            .as_array()
            .unwrap()
            .iter()
            .map(|d| (d["direction"].to_string(), d["compliance_mm_n"].as_f64().unwrap()))
            .collect();
        all
    };
    let (found, right) = (directions(&own), directions(&plain));
    assert_eq!(found.len(), 6);
    assert!(found.iter().zip(&right).all(|(a, b)| a.0 == b.0 && (a.1 - b.1).abs() < 1e-12), "{found:?} {right:?}");
    // slips: a cell of the second file, a delimiter that is not stated, a key of a text beside a sheet
    write("ly.csv", text("ly.csv").replacen("+x;9;nan", "+w;9;1", 1).replacen(";1\n", ";0\n", 1));
    ends(&own, "check", 2, &["[load-direction-unknown]", "ly.csv:"]);
    own.replace("campaign.toml", "delimiter = \";\"\ndecimal = \",\"", "decimal = \",\"");
    ends(&own, "check", 2, &["[comma-ambiguous]", "set `delimiter = \";\"` and `decimal = \",\"`"]);
    own.replace("campaign.toml", "decimal = \",\"\n", "encoding = \"utf-8\"\nsheet = \"Loads\"\n");
    ends(&own, "check", 2, &["[key-of-text-table]"]);
}

#[test]
fn points_are_fitted_from_any_form() {
    let points =
        "Name;X (in);Y (in);Z (in);weg\nA;1,5;0,5;2;0\nB;0,5;1,5;2;0\nC;-0,5;0,5;2;0\nD;0,5;-0,5;2;0\nE;9;9;9;1\n";
    let scratch = Scratch::with(&[("p.csv", points), ("q.csv", "1.5,0.5,2\n0.5,1.5,2\n-0.5,0.5,2\n0.5,-0.5,2\n")]);
    let (code, right) =
        answer(&scratch, &["fit", "circle3d", "q.csv", "--unit", "inch", "--delimiter", ",", "--columns", "x,y,z"]);
    assert_eq!(code, Some(0), "{right}");
    assert!(right.contains("25.4"), "a circle of one inch: {right}");
    let form = ["--unit", "inch", "--delimiter", ";", "--decimal", ",", "--without", "weg=1"];
    let named = ["--column", "x=X (in)", "--column", "y=Y (in)", "--column", "z=Z (in)"];
    let (code, found) = answer(&scratch, &[&["fit", "circle3d", "p.csv"][..], &form, &named].concat());
    assert_eq!((code, &found), (Some(0), &right));
    let (code, said) = answer(&scratch, &["fit", "circle3d", "p.csv", "--unit", "inch", "--decimal", ","]);
    assert!(code == Some(2) && said.contains("[column-separation-unclear]"), "{said}");
    let both = [&["fit", "circle3d", "p.csv"][..], &form, &named, &["--columns", "label,x,y,z"]].concat();
    let (code, said) = answer(&scratch, &both);
    assert!(code == Some(2) && said.contains("[option-columns-twice]"), "{said}");
}

/// Rows of a log are left out by their cells, are listed, and keep their numbers.
#[test]
fn rows_of_a_log_are_left_out_by_filters() {
    let plain = copy_sample("prexyt-cmm");
    ends(&plain, "run", 0, &[]);
    let own = copy_sample("prexyt-cmm");
    let log = std::fs::read_to_string(own.path().join("encoders.csv")).unwrap();
    let (head, rows) = log.split_once('\n').unwrap();
    let marked: String = rows.lines().map(|row| format!("{row},0\n")).collect();
    // a row that the controller marks as faulty has no values
    let text = format!("{head},fault\n1,1,?,?,?,1\n{marked}");
    std::fs::write(own.path().join("encoders.csv"), text).unwrap();
    ends(&own, "check", 2, &["[not-a-number]"]);
    own.replace("campaign.toml", "file = \"encoders.csv\"\n", "file = \"encoders.csv\"\nwithout = { fault = 1 }\n");
    ends(&own, "run", 0, &[]);
    assert_eq!(own.parameters().parameters, plain.parameters().parameters);
    let import = std::fs::read_to_string(own.path().join("out/import.json")).unwrap();
    assert!(import.contains("row-left-out-by-cell"), "{import}");
    own.replace("campaign.toml", "without = { fault = 1 }", "only = { mode = 1 }");
    ends(&own, "check", 2, &["[column-unknown]", "encoders.csv:1"]);
    own.replace("campaign.toml", "only = { mode = 1 }", "only = { fault = 7 }");
    ends(&own, "check", 2, &["[no-row-selected]"]);
}

/// Columns with the names of a hexapod's joints are its joints, however they are written; a table of unknown columns has no
/// lines to paste.
#[test]
fn legs_are_joints_and_nothing_is_pasted_where_nothing_is_read() {
    let scratch = copy_sample("hexapod");
    let rows = |head: &str| {
        let row = |i: usize| {
            let cells: Vec<String> = (1..=6).map(|k| format!("{}.25", 20 + (17 * i * k) % 70)).collect();
            format!("{i},{}\n", cells.join(","))
        };
        format!("{head}\n{}", (1..40).map(row).collect::<String>())
    };
    let paste = phrase!("next-paste").to_string();
    for heading in ["leg#_mm", "Leg#", "leg#", "Leg # [mm]", "LEG_#"] {
        let heads: Vec<String> = (1..=6).map(|k| heading.replace('#', &k.to_string())).collect();
        std::fs::write(scratch.path().join("legs.csv"), rows(&format!("pose,{}", heads.join(",")))).unwrap();
        let (code, said) = answer(&scratch, &["formats", "legs.csv", "--robot", "robot.toml"]);
        assert!(code == Some(0) && said.contains("[log]") && said.contains(&paste), "{heading}: {said}");
        assert!(said.contains(&heads[5]) && !said.contains("leg7"), "{heading}: {said}");
    }
    std::fs::write(scratch.path().join("legs.csv"), "foo,bar\nyes,no\nno,yes\n").unwrap();
    let (_, said) = answer(&scratch, &["formats", "legs.csv"]);
    assert!(!said.contains(&paste), "{said}");
}

/// The sample `probe-poses` in two tables; `changed` changes the heading of the second.
fn in_two_tables(changed: impl Fn(&str) -> String) -> Scratch {
    let own = copy_sample("probe-poses");
    let text = std::fs::read_to_string(own.path().join("observations.csv")).unwrap();
    let (head, rows) = text.split_once('\n').unwrap();
    let rows: Vec<&str> = rows.lines().collect();
    let (first, second) = rows.split_at(rows.len() / 2);
    for (name, part, head) in [("one.csv", first, head.to_owned()), ("two.csv", second, changed(head))] {
        std::fs::write(own.path().join(name), format!("{head}\n{}\n", part.join("\n"))).unwrap();
    }
    let both = "[[observations]]\nfile = \"one.csv\"\n\n[[observations]]\nfile = \"two.csv\"\n";
    own.replace("campaign.toml", "[observations]\nfile = \"observations.csv\"\n", both);
    own
}

/// Root mean square (mm) of the position residuals of a run.
fn residual_mm(own: &Scratch) -> f64 {
    let text = std::fs::read_to_string(own.path().join("out/parameters.json")).unwrap();
    let found: serde_json::Value = serde_json::from_str(&text).unwrap();
    found["residuals"]["position_rms_mm"].as_f64().unwrap()
}

#[test]
fn each_table_has_its_own_order_of_angles() {
    let quaternions = in_two_tables(str::to_owned);
    ends(&quaternions, "run", 0, &[]);
    let own = in_two_tables(str::to_owned);
    let angles = |file: &str, order: &str| {
        let text = std::fs::read_to_string(own.path().join(file)).unwrap();
        let order: AngleOrder = order.parse().unwrap();
        let row = |line: &str| {
            let (before, q) = line.split_at(line.rmatch_indices(',').nth(3).unwrap().0);
            let q: Vec<f64> = q[1..].split(',').map(|cell| cell.parse().unwrap()).collect();
            let [a, b, c] = order.angles(&Pose::from_quaternion([q[0], q[1], q[2], q[3]])).map(f64::to_degrees);
            format!("{before},{a},{b},{c}\n")
        };
        let (head, rows) = text.split_once('\n').unwrap();
        let head = head.replace("qw,qx,qy,qz", "a_deg,b_deg,c_deg");
        std::fs::write(own.path().join(file), head + "\n" + &rows.lines().map(row).collect::<String>()).unwrap();
        own.replace("campaign.toml", &format!("\"{file}\"\n"), &format!("\"{file}\"\norientation = \"{order}\"\n"));
    };
    angles("one.csv", "zyx");
    angles("two.csv", "xyz");
    ends(&own, "run", 0, &[]);
    let [first, second] = [&quaternions, &own].map(residual_mm);
    assert!((first / second - 1.0).abs() < 1e-6, "{first} {second}");
    // a table without a stated order does not take the order of another
    own.replace("campaign.toml", "orientation = \"xyz\"\n", "");
    ends(&own, "check", 2, &["error[angle-order-missing]", "two.csv:1"]);
}

#[test]
fn columns_of_every_table_are_read_or_named() {
    // in the place of a column that the first table has
    for (column, wrong) in [("x_mm", "x_mmm"), ("q3_deg", "q3_degg")] {
        let own = in_two_tables(|head| head.replace(column, wrong));
        ends(&own, "check", 2, &["error[column-unknown]", &format!("`{column}`"), wrong, "two.csv:1"]);
    }
    // also the last coordinate of a single table, and a torque of the second of two
    let own = copy_sample("torque-arm");
    own.replace("observations.csv", "z_mm", "z_mmm");
    ends(&own, "check", 2, &["error[column-unknown]", "`z_mm`", "z_mmm", "observations.csv:1"]);
    let own = copy_sample("torque-arm");
    std::fs::copy(own.path().join("observations.csv"), own.path().join("two.csv")).unwrap();
    own.replace("two.csv", "tau3_nm", "tau3");
    own.replace(
        "campaign.toml",
        "[observations]\nfile = \"observations.csv\"\n",
        "[[observations]]\nfile = \"observations.csv\"\n[[observations]]\nfile = \"two.csv\"\n",
    );
    ends(&own, "check", 2, &["error[column-unknown]", "`tau3_nm`", "two.csv:1"]);
    // names that begin like columns are no columns
    let own = copy_sample("probe-poses");
    let text = std::fs::read_to_string(own.path().join("observations.csv")).unwrap();
    let more =
        |(i, line): (usize, &str)| format!("{line}{}\n", if i == 0 { ",u_percent,urot,x_dev" } else { ",5,0.1,7" });
    std::fs::write(own.path().join("observations.csv"), text.lines().enumerate().map(more).collect::<String>())
        .unwrap();
    let said = ends(&own, "check", 0, &["[columns-not-read] count=3"]);
    assert!(["`u_percent`", "`urot`", "`x_dev`"].iter().all(|name| said.contains(name)), "{said}");
}

/// Rows without a joint value or any coordinate are listed with the reason, like rows of exports and logs.
#[test]
fn rows_in_which_nothing_was_measured_are_listed() {
    let own = copy_sample("torque-arm");
    own.replace("observations.csv", ",2203.652999,-1037.171434,-120.957270", ",,,");
    own.replace("observations.csv", "2,SMR,14.751476,", "2,SMR,,");
    ends(&own, "run", 0, &[]);
    let text = std::fs::read_to_string(own.path().join("out/import.json")).unwrap();
    let import: serde_json::Value = serde_json::from_str(&text).unwrap();
    let sources = import["sources"].as_array().unwrap().iter();
    let refused = sources.flat_map(|source| source["refused"].as_array().unwrap());
    let listed: Vec<_> =
        refused.map(|row| (row["line"].as_u64().unwrap(), row["reason_phrase"]["id"].as_str().unwrap())).collect();
    assert_eq!(listed, [(2, "row-without-coordinates"), (3, "row-cell-empty")]);
}

/// A distance with an own `ux_mm`, where a column `u_mm` is empty in its row.
#[test]
fn an_own_uncertainty_counts_beside_an_empty_column() {
    let text = "pose,target,kind,other,distance_mm,u_mm,ux_mm,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n\
                1,probe,distance,post,900,0.02,,1,2,3,4,5,6\n2,probe,distance,post,900,,0.5,6,5,4,3,2,1\n";
    let own = copy_sample("probe-poses");
    let mut robot =
        etalon::campaign::read_robot(&own.path().join("robot.toml")).unwrap().build(&["probe".to_owned()]).unwrap();
    let table = etalon::formats::observations("o.csv", text).unwrap();
    let without = RowDefaults { length_mm: Some(0.04), ..RowDefaults::default() };
    let found = kinds::observed(robot.as_mut(), &table, without, Settings::default(), &mut Vec::new()).unwrap();
    let u: Vec<f64> = found.settings.conditions.iter().map(|c| c.standard_uncertainty).collect();
    assert_eq!(u, [0.02, 0.5]);
}

#[test]
fn a_filter_reads_numbers_in_the_marks_of_the_table() {
    let rows = |stated: &str| {
        let layout = layout(&format!("delimiter = \";\"\nthousands = \",\"\nwithout = {{ {stated} }}"));
        let text = "pose;x_mm;id\n1;1;1.234\n2;2;1,234\n3;3;1234\n";
        observations_with("o.csv", text, &layout).unwrap().numbers("x_mm").unwrap()
    };
    assert_eq!(rows("id = 1234"), [1.0]);
    assert_eq!(rows("id = \"1,234\""), [1.0]);
    assert_eq!(rows("id = 1.234"), [2.0, 3.0]);
    assert_eq!(rows("id = \"1.234\""), [2.0, 3.0]);
}
