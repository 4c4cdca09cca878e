//! Real logs of five controllers: counts, clocks and units as their READMEs state them.

use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::campaign::Campaign;
use etalon::documents::ImportDocument;
use etalon::formats::table::Table;
use etalon::stages::gather::gather;

/// The table of a log that a campaign states so, or what is said against it.
fn read(log: &str) -> Result<(Table, ImportDocument), String> {
    let scratch = copy_sample("prexyt-cmm");
    let text = format!(
        "name = \"l\"\nrobot = \"robot.toml\"\nexport = []\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\n\
         coverage_factor = 2\n[log]\n{log}\n[join]\nby = \"row\"\n[frame.world]\nas_exported = true\n\
         [identify]\ncalibration = \"all\"\n"
    );
    std::fs::write(scratch.path().join("campaign.toml"), text).unwrap();
    let campaign = Campaign::read(&scratch.path()).unwrap_or_else(|e| panic!("{e}"));
    let imported = gather(&campaign).map_err(|e| e.to_string())?;
    Ok((imported.logs[0].table(), imported.document))
}

/// What is said against a log, which must hold all these parts.
fn refused(log: &str, parts: &[&str]) {
    let said = read(log).expect_err(log);
    for part in parts {
        assert!(said.says(part), "{part:?} is not said:\n{said}");
    }
}

fn column(table: &Table, name: &str) -> Vec<f64> {
    table.numbers(name).unwrap()
}

const GALIL: &str = "file = \"$ETALON_REFERENCE/exports/galil/doc_example_arrays.csv\"\nformat = \"galil\"\n";

#[test]
fn galil_counts_become_joints_by_the_stated_scale_and_the_shorter_array_ends_the_log() {
    if crate::reference_data("exports/galil").is_none() {
        return;
    }
    let columns = "columns = { a_mm = { name = \"one\", per_count = 0.5 }, b_rad = { name = \"ten\", per_count = 0.001, zero_count = 10 } }";
    let (table, document) = read(&format!("{GALIL}period_s = 0.002\n{columns}")).unwrap();
    assert_eq!(column(&table, "a_mm"), [0.0, 0.5, 1.0]);
    assert_eq!(column(&table, "time_s"), [0.0, 0.002, 0.004]);
    let expected = [-0.01, 0.0, 0.01].map(f64::to_degrees);
    assert!(column(&table, "b_deg").iter().zip(expected).all(|(b, e)| (b - e).abs() < 1e-14));
    let source = document.sources.iter().find(|s| s.kind.name() == "log").unwrap();
    let listed: Vec<_> = source.refused.iter().map(|r| (r.line, r.text.as_str())).collect();
    assert_eq!((source.rows_read, listed), (4, vec![(5, ",0")]));
    assert!(source.refused[0].reason.phrase().is_some_and(|reason| reason.id == "galil-array-ended"));
    // the array that is not short alone: the empty place of the other is no matter
    let (table, _) = read(&format!("{GALIL}columns = {{ b_mm = {{ name = \"ten\", per_count = 1 }} }}")).unwrap();
    assert_eq!(column(&table, "b_mm"), [0.0, 10.0, 20.0, 0.0]);
}

#[test]
fn galil_counts_without_a_scale_or_by_position_are_refused() {
    if crate::reference_data("exports/galil").is_none() {
        return;
    }
    refused(&format!("{GALIL}columns = {{ a_mm = \"one\" }}"), &["error[count-value-missing]", "per_count"]);
    let by_number = "columns = { a_mm = { number = 1, per_count = 1 } }";
    refused(&format!("{GALIL}{by_number}"), &["error[column-by-number]", "campaign.toml:"]);
}

const UR: &str = "file = \"$ETALON_REFERENCE/exports/ur_rtde/robot_data.csv\"\nformat = \"ur_rtde\"\n";

#[test]
fn ur_rtde_reads_11_rows_at_125_hz_in_radians() {
    if crate::reference_data("exports/ur_rtde").is_none() {
        return;
    }
    let (table, _) =
        read(&format!("{UR}columns = {{ time_s = \"timestamp\", q1_rad = \"actual_q_0\", q6_rad = \"actual_q_5\" }}"))
            .unwrap();
    let times = column(&table, "time_s");
    assert_eq!(times.len(), 11);
    assert!(times.windows(2).all(|t| (t[1] - t[0] - 0.008).abs() < 1e-9), "{times:?}");
    assert_eq!(column(&table, "q1_deg")[0], 1.3084329994998356f64.to_degrees());
}

#[test]
fn trap_9_ur_rtde_names_that_occur_twice_are_refused_until_the_campaign_says_which() {
    if crate::reference_data("exports/ur_rtde").is_none() {
        return;
    }
    let generic = UR.replace("format = \"ur_rtde\"\n", "");
    for i in 0..6 {
        let parts = ["error[heading-repeated] times=2", "occurrence = 1", "campaign.toml:"];
        refused(&format!("{generic}columns = {{ a_mm = \"target_current_{i}\" }}"), &parts);
    }
    // columns 26 and 44 of the header: cut -d, -f26,44
    let of = |which: &str| column(&read(&format!("{generic}columns = {{ a_mm = {which} }}")).unwrap().0, "a_mm");
    assert_eq!(of("{ name = \"target_current_0\", occurrence = 1 }"), of("26"));
    assert_eq!(of("{ name = \"target_current_0\", occurrence = 2 }"), of("44"));
    refused(
        &format!("{generic}columns = {{ a_mm = {{ name = \"target_current_0\", occurrence = 3 }} }}"),
        &["error[heading-repeated]", "from 1 to 2"],
    );
}

#[test]
fn trap_8_ur_rtde_knows_its_units_and_what_is_no_joint() {
    if crate::reference_data("exports/ur_rtde").is_none() {
        return;
    }
    refused(
        &format!("{UR}columns = {{ q1_deg = \"actual_q_0\" }}"),
        &["error[column-unit-differs]", "write `q1_rad = \"actual_q_0\"`"],
    );
    refused(&format!("{UR}columns = {{ x_mm = \"actual_TCP_pose_0\" }}"), &["error[column-unit-differs]", "x_m"]);
    refused(
        &format!("{UR}columns = {{ q1_rad = \"actual_current_0\" }}"),
        &["error[column-unit-differs]", "expected: a column in rad"],
    );
}

const KUKA: &str = "file = \"$ETALON_REFERENCE/exports/kuka_rsi/robot_data.csv\"\nformat = \"kuka_rsi\"\n";

#[test]
fn kuka_rsi_reads_2425_rows_whose_clock_steps_by_12_ms() {
    if crate::reference_data("exports/kuka_rsi").is_none() {
        return;
    }
    let (table, document) =
        read(&format!("{KUKA}columns = {{ time_ms = \"IPOC\", x_mm = \"X_RIst\", a_deg = \"A_RIst\" }}")).unwrap();
    let times = column(&table, "time_s");
    assert_eq!(times.len(), 2425);
    assert!(times.windows(2).all(|t| ((t[1] - t[0]) * 1e3).round() == 12.0));
    // first and last IPOC of the file
    assert!((times[2424] - times[0] - (1210470639.0 - 1210441551.0) / 1e3).abs() < 1e-6);
    assert_eq!((column(&table, "x_mm")[0], column(&table, "a_deg")[0]), (1279.5, 80.4));
    assert!(document.messages.is_empty(), "{:?}", document.messages);
}

#[test]
fn trap_16_kuka_rsi_refuses_the_wall_clock_of_whole_seconds_and_the_counter_as_seconds() {
    if crate::reference_data("exports/kuka_rsi").is_none() {
        return;
    }
    refused(
        &format!("{KUKA}columns = {{ time_s = \"Timestamp\", x_mm = \"X_RIst\" }}"),
        &["error[column-unit-differs]", "`IPOC`"],
    );
    refused(
        &format!("{KUKA}columns = {{ time_s = \"IPOC\" }}"),
        &["error[column-unit-differs]", "write `time_ms = \"IPOC\"`"],
    );
}

/// Every variant of the one recording, with its options.
const SCOPE: [(&str, &str); 9] = [
    ("-ContainEOF_true", "values = \"scaled\""),
    ("-DecimalMark_comma", "values = \"scaled\"\ndecimal = \",\""),
    ("-ExcludeDoubleTimestamp_false-SortChannels_false", "values = \"scaled\""),
    ("-ExcludeDoubleTimestamp_false-SortChannels_true", "values = \"scaled\""),
    ("-ExcludeDoubleTimestamp_true-SortChannels_false", "values = \"scaled\""),
    ("-Seperator_2", "values = \"scaled\""),
    ("-Seperator_3", "values = \"scaled\""),
    ("-default", "values = \"raw\"\ndecimal = \",\""),
    ("_noOS", "values = \"scaled\""),
];

fn scope(variant: &str) -> String {
    let name = "$ETALON_REFERENCE/exports/twincat_scope/tc3_scope_3_4_3145_3";
    format!("file = \"{name}{variant}.csv\"\nformat = \"twincat\"\n")
}

#[test]
fn trap_16_a_twincat_channel_is_the_same_in_every_variant_of_the_export() {
    if crate::reference_data("exports/twincat_scope").is_none() {
        return;
    }
    let channels = [
        "var_BIT",
        "var_INT8",
        "var_INT16",
        "var_INT32",
        "var_INT64",
        "var_UINT8",
        "var_UINT16",
        "var_UINT32",
        "var_UINT64",
        "var_REAL32",
        "var_REAL64",
        "func_OS",
        "func_scaled",
        "func_scaled_int",
        "func_units_unscaled",
        "func_units_scaled",
        "func_timeshift",
        "func_freesample",
        "test space",
        "test space (1)",
        "test_special([{äöü!?ß$²}])",
    ];
    for channel in channels {
        let mut first: Option<(Vec<f64>, Vec<f64>)> = None;
        let mut compared = 0;
        for (variant, options) in SCOPE {
            if variant == "_noOS" && matches!(channel, "func_OS" | "func_freesample") {
                continue; // an earlier export, without the channels of other sample times
            }
            let log = format!("{}{options}\ncolumns = {{ a_mm = \"{channel}\" }}", scope(variant));
            let (table, document) = read(&log).unwrap_or_else(|e| panic!("{variant} {channel}: {e}"));
            let found = (column(&table, "time_s"), column(&table, "a_mm"));
            let expected = if channel == "func_OS" {
                4996
            } else if channel == "func_freesample" {
                201
            } else {
                1000
            };
            assert_eq!(found.0.len(), expected, "{variant} {channel}");
            // 132959733843760000 * 100 ns after 1601 are 13:56:24.376 UTC; the text of the file says 15:56:24, in local time
            let source = document.sources.iter().find(|s| s.kind.name() == "log").unwrap();
            assert!(source.dialect.english().contains("2022-05-02T13:56:24.376Z"), "{}", source.dialect);
            let same = first.get_or_insert_with(|| found.clone());
            assert_eq!((&same.0, &same.1), (&found.0, &found.1), "{variant} {channel}");
            compared += 1;
        }
        println!("{channel}: {compared} variants");
    }
}

#[test]
fn twincat_variants_that_read_two_ways_are_refused() {
    if crate::reference_data("exports/twincat_scope").is_none() {
        return;
    }
    let columns = "values = \"scaled\"\ncolumns = { a_mm = \"var_REAL64\" }";
    refused(&format!("{}{columns}", scope("-Seperator_1")), &["error[twincat-separated-by-blanks]", "_1.csv:1"]);
    let comma = ["error[twincat-head-ragged] row=SampleTime[ms] fields=25 width=24", "_4.csv:10"];
    refused(&format!("{}{columns}", scope("-Seperator_4")), &comma);
    let raw = "columns = { a_mm = \"func_scaled\" }";
    refused(&format!("{}{raw}", scope("-default")), &["error[twincat-scale-undecided]", "values = \"raw\""]);
    let point = "values = \"raw\"\ncolumns = { a_mm = \"func_OS\" }";
    refused(
        &format!("{}{point}", scope("-default")),
        &["[not-a-number]: `0,2`", "decimal = \",\"", "-default.csv:26:"],
    );
}

#[test]
fn twincat_channels_of_other_sample_times_meet_where_both_have_a_value() {
    if crate::reference_data("exports/twincat_scope").is_none() {
        return;
    }
    let columns = "columns = { a_mm = \"func_OS\", b_mm = \"var_REAL64\" }";
    let (table, document) = read(&format!("{}{columns}", scope("-ContainEOF_true"))).unwrap();
    assert_eq!(table.height(), 1000);
    // at whole milliseconds: var_REAL64 counts them
    assert!(column(&table, "time_s").iter().zip(column(&table, "b_mm")).all(|(t, b)| (t * 1000.0 - b).abs() < 1e-9));
    assert!(
        document.messages.iter().any(|m| m.is("channel-samples-unused", &[("count", &3996)])),
        "{:?}",
        document.messages
    );
}

const ROS: &str = "file = \"$ETALON_REFERENCE/exports/ros_csv/joint_states.csv\"\nformat = \"ros\"\n";

#[test]
fn trap_15_ros_joints_in_scrambled_order_are_found_by_name_alone() {
    if crate::reference_data("exports/ros_csv").is_none() {
        return;
    }
    let columns: Vec<String> = (0..7).map(|i| format!("q{i}_rad = \"lbr_joint_{i}\"")).collect();
    let (table, _) = read(&format!("{ROS}columns = {{ {} }}", columns.join(", "))).unwrap();
    assert_eq!(table.height(), 135);
    // first row of the file: 1, 2, 3, 0, 4, 5, 6
    let first = [-0.7433388669627123f64, 1.004320471250612, 1.603735268542239, -1.6762778191946999];
    for (i, expected) in first.iter().enumerate() {
        assert!((column(&table, &format!("q{i}_deg"))[0] - expected.to_degrees()).abs() < 1e-13, "joint {i}");
    }
    refused(&format!("{ROS}columns = {{ q0_rad = 1 }}"), &["error[column-by-number]"]);
}

#[test]
fn trap_15_the_partner_without_a_header_would_be_one_row_off_and_is_refused() {
    if crate::reference_data("exports/ros_csv").is_none() {
        return;
    }
    let poses = "file = \"$ETALON_REFERENCE/exports/ros_csv/poses.csv\"\n";
    let columns = "columns = { x_m = 1, y_m = 2, z_m = 3 }";
    refused(&format!("{poses}{columns}"), &["error[header-holds-numbers]", "header = false", "poses.csv:1"]);
    // as it is: 136 rows, and a join by row with the 135 of joint_states.csv is refused by their counts
    let (table, _) = read(&format!("{poses}header = false\n{columns}")).unwrap();
    assert_eq!(table.height(), 136);
    assert_eq!(column(&table, "x_mm")[0], 0.5637046075982887 * 1000.0);
}

#[test]
fn trap_20_joints_of_the_hl6_are_separated_by_tabs_and_in_39_rows_by_a_blank_too() {
    if crate::reference_data("robots/qkm_polyworks").is_none() {
        return;
    }
    let log = |file: &str, stated: &str, columns: &str| {
        let file = format!("file = \"$ETALON_REFERENCE/robots/qkm_polyworks/{file}.txt\"\nheader = false\n");
        format!("{file}delimiter = \"{stated}\"\ncolumns = {{ {columns} }}")
    };
    let six = "q1_deg = 1, q2_deg = 2, q3_deg = 3, q4_deg = 4, q5_deg = 5, q6_deg = 6";
    let angles = "data_points_cali__c_angles";
    // the README says one row
    let said = read(&log(angles, "tab", six)).unwrap_err();
    // 39 rows: the first, two that are named, and 36
    assert!(said.says("error[row-field-count] fields=6") && said.contains(" 9, 10 and 36 "), "{said}");
    assert!(said.contains("c_angles.txt:5\n") && said.has_phrase("fields-like like=first-row width=7"), "{said}");
    let (table, _) = read(&log(angles, "blank", six)).unwrap();
    assert_eq!(table.height(), 46);
    // line 5: 31.03187354 ... -111.91 2
    assert_eq!((column(&table, "q1_deg")[4], column(&table, "q6_deg")[4]), (31.03187354, -111.91));
    for (file, separator, count) in [
        ("data_pose_cali__AnglesInDeg", "blank", 10),
        ("data_pose_cali__test_angles", "blank", 10),
        ("data_pose_cali__init_ang", "blank", 1),
        ("2020-01-19__test_points", ",", 9),
        ("data_points_cali__test_points", ",", 9),
    ] {
        assert_eq!(read(&log(file, separator, six)).unwrap().0.height(), count, "{file}");
    }
    refused(&log("2020-01-19__angle_info", "blank", six), &["angle_info.txt"]);
}
