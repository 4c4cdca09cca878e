//! Tables of observations as people have them: marks, units, uncertainties, single coordinates, rows that are left out.

use super::{etalon, text_of};
use crate::support::said::Says;
use crate::support::scratch::{Scratch, cmm_truth, copy_sample};
use etalon::base::noise::Noise;
use etalon::documents::{ParametersDocument, ResidualSummary, Role};

/// A measured ball of the sample's robot: what a row states.
struct Row {
    pose: usize,
    cycle: usize,
    target: &'static str,
    xy_mm: [f64; 2],
    q: [f64; 3],
}

/// Balls K and L at 24 poses, with noise of `sigma_mm` in each of the cycles.
fn measured(sigma_mm: &[f64]) -> Vec<Row> {
    let (robot, values, log) = cmm_truth();
    let (mut noise, mut rows) = (Noise::new(5, 1), Vec::new());
    for (cycle, sigma_mm) in (1..).zip(sigma_mm) {
        for (pose, q) in (1..).zip(log.iter().take(24)) {
            for (k, target) in ["K", "L"].into_iter().enumerate() {
                let p = robot.position(&values, q, k);
                let xy_mm = [p[0] + noise.gaussian(*sigma_mm), p[1] + noise.gaussian(*sigma_mm)];
                rows.push(Row { pose, cycle, target, xy_mm, q: *q });
            }
        }
    }
    rows
}

/// A table of these rows; `more` adds columns: their names, and the cells of a row.
fn table(rows: &[Row], names: &str, more: impl Fn(&Row) -> String) -> String {
    let mut text = format!("pose,cycle,target,x_mm,y_mm,rho1_mm,rho2_mm,rho3_mm{names}\n");
    for row in rows {
        let Row { pose, cycle, target, xy_mm: [x, y], q: [a, b, c] } = row;
        text += &format!("{pose},{cycle},{target},{x},{y},{a},{b},{c}{}\n", more(row));
    }
    text
}

/// `etalon identify` on a table: exit code, parameters.json where there is one, stderr.
fn identify(text: &str, options: &[&str]) -> (Option<i32>, Option<ParametersDocument>, String) {
    let scratch: Scratch = copy_sample("prexyt-cmm");
    std::fs::write(scratch.path().join("o.csv"), text).unwrap();
    let fixed = ["identify", "--robot", "robot.toml", "--observations", "o.csv", "--json"];
    let output = etalon(&scratch.path(), &[&fixed[..], options].concat());
    (output.status.code(), serde_json::from_slice(&output.stdout).ok(), text_of(&output))
}

fn found(text: &str, options: &[&str]) -> ParametersDocument {
    let (code, document, said) = identify(text, options);
    assert_eq!(code, Some(0), "{said}");
    document.unwrap()
}

/// Values and standard uncertainties of two documents agree.
fn agree(a: &ParametersDocument, b: &ParametersDocument, relative: f64) {
    for (a, b) in a.parameters.iter().zip(&b.parameters) {
        assert!((a.value - b.value).abs() < relative * a.value.abs().max(1.0), "{}: {} {}", a.name, a.value, b.value);
        let [u, v] = [a, b].map(|p| p.standard_uncertainty.unwrap_or(0.0));
        assert!((u - v).abs() <= 1e3 * relative * u, "u of {}: {u} {v}", a.name);
    }
}

fn refused(text: &str, options: &[&str], parts: &[&str]) {
    let (code, _, said) = identify(text, options);
    assert_eq!(code, Some(2), "{said}");
    parts.iter().for_each(|part| assert!(said.says(part), "{part:?} is not said:\n{said}"));
}

#[test]
fn equal_uncertainties_of_rows_are_that_of_the_instrument() {
    let rows = measured(&[0.003]);
    let stated = found(&table(&rows, "", |_| String::new()), &["--standard-uncertainty-um", "3"]);
    for (names, cells) in [
        (",ux_mm,uy_mm", ",0.003,0.003"),
        (",ux_um,uy_m", ",3,0.000003"),
        (",u_mm", ",0.003"),
        (",cxx_mm2,cxy_mm2,cyy_mm2", ",9e-6,0,9e-6"),
    ] {
        let weighted = found(&table(&rows, names, |_| cells.to_owned()), &[]);
        agree(&stated, &weighted, 1e-9);
        let (a, b) = (&stated.residuals, &weighted.residuals);
        assert!(
            (a.test.chi_square.unwrap() - b.test.chi_square.unwrap()).abs() < 1e-6 && (a.rms - b.rms).abs() < 1e-12
        );
        assert!(weighted.messages.iter().any(|m| m.id == "readings-weighted"));
    }
}

/// Before the identification base and balls alone are fitted: with all parameters of the robot held, this is the answer.
#[test]
fn the_error_before_identification_is_that_of_the_nominal_robot() {
    let text = table(&measured(&[0.003]), "", |_| String::new());
    let free = found(&text, &[]);
    let of_robot = free.parameters.iter().filter(|p| p.role == Role::Robot);
    let hold: Vec<&str> = of_robot.flat_map(|p| ["--hold", p.name.as_str()]).collect();
    let held = found(&text, &hold).residuals;
    let rms = |r: &ResidualSummary| [r.position.position_rms_before_mm.unwrap(), r.position.position_rms_mm.unwrap()];
    let ([before, after], [nominal_before, nominal]) = (rms(&free.residuals), rms(&held));
    assert!((nominal_before - nominal).abs() < 1e-6 * nominal && (before - nominal).abs() < 1e-6 * nominal);
    assert!(after < 0.1 * before, "{before} {after}");
}

#[test]
fn a_row_weighs_by_its_uncertainty() {
    // good rows, and bad ones that say so
    let rows = measured(&[0.003, 0.3]);
    let sigma = |row: &Row| if row.cycle == 1 { 0.003 } else { 0.3 };
    let text = table(&rows, ",ux_mm,uy_mm", |row| format!(",{0},{0}", sigma(row)));
    let weighted = found(&text, &[]);
    let good = found(&table(&measured(&[0.003]), "", |_| String::new()), &["--standard-uncertainty-um", "3"]);
    for (a, b) in weighted.parameters.iter().zip(&good.parameters) {
        let (Some(u), Some(v)) = (a.standard_uncertainty, b.standard_uncertainty) else { continue };
        assert!((a.value - b.value).abs() < 0.1 * v && (0.99..=1.0).contains(&(u / v)), "{}: {u} {v}", a.name);
    }
    // a reading twice with an uncertainty larger by the root of two is the reading once
    let rows = measured(&[0.003]);
    let once =
        found(&table(&rows, ",ux_mm,uy_mm", |row| format!(",{},0.002", 0.002 + 0.001 * (row.pose % 3) as f64)), &[]);
    let mut twice = measured(&[0.003]);
    twice.extend(measured(&[0.003]).into_iter().map(|row| Row { cycle: 2, ..row }));
    let of = |row: &Row| format!(",{},{}", 2f64.sqrt() * (0.002 + 0.001 * (row.pose % 3) as f64), 2f64.sqrt() * 0.002);
    agree(&once, &found(&table(&twice, ",ux_mm,uy_mm", of), &[]), 1e-9);
    // covariances turn the axes: x and y apart are no longer what is measured well
    let along = found(&table(&rows, ",cxx_mm2,cxy_mm2,cyy_mm2", |_| ",1e-4,9.99e-5,1e-4".to_owned()), &[]);
    assert!(along.parameters.iter().zip(&once.parameters).any(|(a, b)| (a.value - b.value).abs() > 1e-4));
}

#[test]
fn single_coordinates_count_one_each() {
    let rows = measured(&[0.003]);
    let text = table(&rows, ",ux_mm,uy_mm", |_| ",0.003,0.003".to_owned());
    let whole = found(&text, &[]);
    // the same coordinates, each in a row of its own
    let mut single = String::from("pose,cycle,target,x_mm,y_mm,rho1_mm,rho2_mm,rho3_mm,ux_mm,uy_mm\n");
    for (i, line) in text.lines().skip(1).enumerate() {
        let cells: Vec<&str> = line.split(',').collect();
        match i < 24 {
            true => single += &format!("{line}\n"),
            false => {
                for (k, [x, y]) in [[cells[3], ""], ["", cells[4]]].into_iter().enumerate() {
                    let head = format!("{},{},{}", cells[0], k + 2, cells[2]);
                    single += &format!("{head},{x},{y},{}\n", cells[5..].join(","));
                }
            }
        }
    }
    let apart = found(&single, &[]);
    agree(&whole, &apart, 1e-7);
    assert_eq!(whole.residuals.degrees_of_freedom, apart.residuals.degrees_of_freedom);
    assert!(apart.messages.iter().any(|m| m.is("partial-coordinates", &[("count", &48)])));
    // one coordinate less is one degree of freedom less
    let shorter: Vec<&str> = single.lines().collect();
    let fewer = found(&(shorter[..shorter.len() - 1].join("\n") + "\n"), &[]);
    assert_eq!(fewer.residuals.degrees_of_freedom, apart.residuals.degrees_of_freedom - 1);
}

#[test]
fn a_table_is_read_in_its_own_marks() {
    let text = table(&measured(&[0.003]), "", |_| String::new());
    let expected = found(&text, &[]);
    let german = text.replace(',', ";").replace('.', ",");
    agree(&expected, &found(&german, &["--delimiter", "semicolon", "--decimal", "comma"]), 1e-12);
    refused(&german, &[], &["error[delimiter-does-not-split]", "`delimiter = \";\"` and `decimal = \",\"`"]);
    refused(&german, &["--delimiter", "semicolon"], &["[not-a-number]", "o.csv:2"]);
    refused(&german, &["--decimal", "comma"], &["o.csv"]);
}

#[test]
fn uncertainties_that_are_none_are_refused() {
    let rows = measured(&[0.003]);
    let with = |cell: &'static str| {
        table(&rows, ",ux_mm,uy_mm", move |row| if row.pose == 3 { cell.to_owned() } else { ",0.003,0.003".to_owned() })
    };
    for (cells, part) in [
        (",0.003,", "error[coordinate-uncertainty-missing]"),
        (",-0.003,0.003", "error[coordinate-uncertainty-unusable]: `ux_mm` = -0.003 "),
        (",0.003,3000", "error[coordinate-uncertainty-unusable]: `uy_mm` = 3000 "),
    ] {
        refused(&with(cells), &[], &[part, "o.csv:6"]);
    }
    refused(&with(",,"), &[], &["[readings-without-uncertainty] without=2 readings=48", "--standard-uncertainty-um"]);
    found(&with(",,"), &["--standard-uncertainty-um", "3"]);
    refused(
        &table(&rows, ",cxx_mm2,cxy_mm2,cyy_mm2", |_| ",1e-6,2e-6,1e-6".to_owned()),
        &[],
        &["error[position-covariance-invalid]"],
    );
    refused(&table(&rows, ",ux_mm", |_| ",0.003".to_owned()), &[], &["[column-unknown]", "`uy_mm`"]);
    let option = ["--standard-uncertainty-um", "3", "--pose-residuals"];
    refused(&with(",0.003,0.003"), &option, &["[own-uncertainties-unusable]"]);
    // a name that is mistaken is not read, and said
    let mistaken = found(&table(&rows, ",ux_m m,uy_nm", |_| ",0.003,0.003".to_owned()), &[]);
    assert!(mistaken.messages.iter().any(|m| m.is("columns-not-read", &[("count", &2)])), "{:?}", mistaken.messages);
}

#[test]
fn rows_and_poses_are_left_out_with_their_reason() {
    let mut rows = measured(&[0.003]);
    let clean = found(
        &table(&rows, "", |_| String::new()),
        &["--exclude", "5: ball loose", "--exclude-rows", "3-4: ball loose"],
    );
    rows[2].xy_mm[0] += 5.0;
    rows[8].xy_mm[1] -= 5.0;
    let options = ["--exclude", "5: ball loose", "--exclude-rows", "3-4: beam broken"];
    let left_out = found(&table(&rows, "", |_| String::new()), &options);
    agree(&clean, &left_out, 1e-12);
    for part in [
        "[excluded-readings] count=2 of=pose 5 reason=ball loose",
        "[excluded-rows] count=2 rows=3-4 reason=beam broken",
    ] {
        assert!(left_out.messages.iter().any(|m| m.to_string().says(part)), "{part}");
    }
    let text = table(&rows, "", |_| String::new());
    for (option, value, part) in [
        ("--exclude", "99: why", "error[exclusion-matches-nothing] of=poses name=99"),
        ("--exclude", "5", "error[exclusion-option-without-reason]"),
        ("--exclude", "all: why", "error[exclusion-names-nothing]: `all`"),
        ("--exclude-rows", "48-50, 60: why", "error[exclusion-matches-nothing] of=rows name=60"),
        ("--exclude-rows", "4", "error[exclusion-option-without-reason]"),
    ] {
        refused(&text, &[option, value], &[part]);
    }
}

/// A name in one row is not that of another place: `anchr_C` is a misspelt `anchor_C`, and `anchor_E` would be a fifth anchor.
#[test]
fn a_misspelt_name_of_one_row_is_refused() {
    let ran = |to: &str| {
        let scratch = copy_sample("draw-wire");
        let path = scratch.path().join("observations.csv");
        let text = std::fs::read_to_string(&path).unwrap();
        std::fs::write(&path, text.replacen("anchor_C", to, 1)).unwrap();
        let output = etalon(&scratch.path(), &["run", "."]);
        (output.status.code(), text_of(&output))
    };
    for name in ["anchr_C", "anchor_c", "achnor_C", "anchor_C"] {
        let (code, said) = ran(name);
        if name == "anchor_C" {
            assert_eq!(code, Some(0), "{said}");
            continue;
        }
        assert_eq!(code, Some(2), "{name}: {said}");
        let meant = ["observations.csv:4", "did you mean `anchor_C`?", &format!("error[name-on-few-rows]: `{name}` ")];
        meant.iter().for_each(|part| assert!(said.says(part), "{part:?} is not said of {name}:\n{said}"));
    }
    let (code, said) = ran("anchor_E");
    assert!(code != Some(2) || !said.has_phrase("did-you-mean"), "{said}");
}
