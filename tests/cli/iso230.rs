//! `etalon iso230`: an axis from its table, and its compensation.

use crate::support::said::Says;
use crate::support::scratch::{Scratch, said};
use std::process::Command;

const HEAD: &str = "position_mm,measured_mm,direction\n";
/// Two positions, two runs of either side, in any order.
const ROWS: &str = "10,10.003,1\n0,0.001,1\n0,0.002,1\n0,-0.001,-1\n0,0,-1\n10,10.005,1\n10,10.001,-1\n10,10.002,-1\n";

fn answer(rows: &str, arguments: &[&str]) -> (Option<i32>, String, String) {
    let scratch = Scratch::with(&[]);
    let table = scratch.root().join("axis.csv");
    std::fs::write(&table, format!("{HEAD}{rows}")).unwrap();
    let output = Command::new(crate::support::program()).arg("iso230").arg(table).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

#[test]
fn an_axis_has_the_quantities_of_its_table() {
    let (code, out, err) = answer(ROWS, &["--json"]);
    assert_eq!(code, Some(0), "{err}");
    let document: serde_json::Value = serde_json::from_str(&out).unwrap();
    let close = |value: &serde_json::Value, expected: f64| {
        assert!((value.as_f64().unwrap() - expected).abs() < 1e-12, "{value} {expected}");
    };
    // by hand: means 1.5, 4 (up), -0.5, 1.5 (down) um; s of two runs is half their difference times the root of two
    close(&document["axis"]["reversal_mm"], 2.5e-3);
    close(&document["axis"]["mean_reversal_mm"], 2.25e-3);
    close(&document["axis"]["systematic"]["both_mm"], 4.5e-3);
    close(&document["axis"]["mean_systematic_mm"], 2.25e-3);
    close(&document["axis"]["repeatability"]["forward_mm"], 4e-3 * 2f64.sqrt());
    close(&document["axis"]["accuracy"]["both_mm"], 4.5e-3 + 3e-3 * 2f64.sqrt());
    let (code, text, _) = answer(ROWS, &[]);
    assert!(code == Some(0) && text.contains("reversal error B") && text.contains("0.002500"), "{text}");
}

#[test]
fn a_compensation_table_holds_the_means_of_both_directions() {
    let (code, out, err) = answer(ROWS, &["--compensation", "linuxcnc"]);
    assert_eq!(code, Some(0), "{err}");
    let rows: Vec<Vec<f64>> =
        out.lines().map(|l| l.split(' ').map(|v| v.parse().unwrap()).collect::<Vec<f64>>()).collect();
    for (row, expected) in rows.iter().zip([[0.0, 1.5e-3, -5e-4], [10.0, 10.004, 10.0015]]) {
        assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{out}");
    }
    // positions of its own: they need no constant distance
    let uneven = format!("{ROWS}15,15,1\n15,15,1\n15,15,-1\n15,15,-1\n");
    let (_, out, err) = answer(&uneven, &["--compensation", "beckhoff", "--axis", "Y"]);
    for line in [
        "kopf.log_achs_name Y",
        "kw.ssfk.interval 0",
        "kw.ssfk.kw_nr_max 3",
        "kw.ssfk.table[1].setpoint 100000",
        "kw.ssfk.table[1].pos 40",
        "kw.ssfk.table[1].neg 15",
        "kw.ssfk.table[0].neg -5",
    ] {
        assert!(out.lines().any(|l| l == line), "{line}: {out} {err}");
    }
    let (code, _, err) = answer(&uneven, &["--compensation", "sinumerik"]);
    assert!(code == Some(2) && err.contains("[axis-positions-uneven]"), "{err}");
}

/// The control adds the table to the actual value, and the axis moves the other way (Siemens, K3): what it then reaches is programmed.
#[test]
fn a_sinumerik_with_its_table_is_where_it_is_programmed() {
    let (code, out, err) = answer(ROWS, &["--compensation", "sinumerik", "--axis", "Y1"]);
    assert_eq!(code, Some(0), "{err}");
    assert!(
        out.starts_with("%_N_AX_EEC_INI\n; Written by etalon") && out.ends_with("IS_MODULO[0,Y1]=0\nM17\n"),
        "{out}"
    );
    let value = |name: &str| -> f64 {
        let line = out.lines().find_map(|l| l.strip_prefix(name)?.strip_prefix('='));
        line.unwrap_or_else(|| panic!("{name}: {out}")).parse().unwrap()
    };
    assert_eq!(
        [value("$AA_ENC_COMP_MIN[0,Y1]"), value("$AA_ENC_COMP_MAX[0,Y1]"), value("$AA_ENC_COMP_STEP[0,Y1]")],
        [0.0, 10.0, 10.0]
    );
    for (i, mean_deviation) in [0.5e-3, 2.75e-3].into_iter().enumerate() {
        let moved = -value(&format!("$AA_ENC_COMP[0,{i},Y1]"));
        assert!((moved + mean_deviation).abs() < 1e-6, "{out}");
    }
    let (code, _, err) = answer(ROWS, &["--compensation", "sinumerik", "--axis", "X1]=0\nM17"]);
    assert!(code == Some(2) && err.has_phrase("axis-name-expected"), "{err}");
}

#[test]
fn tables_that_are_no_test_of_an_axis_are_refused() {
    for (rows, why) in [
        ("0,0.001,1\n0,0.002,1\n0,0,-1\n", "error[iso230-few-runs] position=0 direction=-1"),
        ("0,0.001,2\n", "[iso230-row-incomplete]"),
        ("", "error[data-rows-missing]"),
        // measured in metres
        (
            "0,0.0,1\n0,0.0,1\n0,0.0,-1\n0,0.0,-1\n10,0.01,1\n10,0.01,1\n10,0.01,-1\n10,0.01,-1\n",
            "error[deviation-steep] change=9.99 from=0 to=10",
        ),
    ] {
        let (code, _, err) = answer(rows, &[]);
        assert!(code == Some(2) && err.says(why), "{rows}: {err}");
    }
    let scratch = Scratch::with(&[("axis.csv", "position_mm,direction\n0,1\n")]);
    let (code, text) = said(&scratch, &["iso230", &scratch.path().join("axis.csv").display().to_string()]);
    assert!(code == Some(2) && text.contains("measured_mm"), "{text}");
}
