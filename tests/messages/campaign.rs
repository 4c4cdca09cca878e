//! Messages about campaign.toml.

use super::{CHECK, Case, RUN, hold};

const C: &str = "campaign.toml";
const CMM: &str = "prexyt-cmm";
const GEOMETRY: &str = "prexyt-geometric";
const LABEL: &str = "label = \"{target}_{pose}_{cycle}\"";
const PLANE: &str = "plane = \"rails\"\n";
const FLOOR: &str = "targets = [\"floor_1\", \"floor_2\", \"floor_3\"]";

const LOG: &str = "[log]\nfile = \"encoders.csv\"\ncolumns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n";
const COLUMN_LOG: &str = "[log]\nfile = \"encoders.csv\"\n\n[log.columns]\npose = \"pose\"\ncycle = \"cycle\"\nlift_m = \"lift\"\nshoulder_pan_rad = \"shoulder_pan\"\nshoulder_lift_rad = \"shoulder_lift\"\nelbow_rad = \"elbow\"\nwrist_1_rad = \"wrist_1\"\nwrist_2_rad = \"wrist_2\"\nwrist_3_rad = \"wrist_3\"\n";
const UNIT: &str = "unit = \"m\"\nlabel";
const JOINT: &str = "unit = \"m\"\njoints = { lift_m = \"L\" }\n";
const JOINTS: &str = "unit = \"m\"\njoints = { lift_m = \"L\" }\nlabel";

/// Syntax and kinds of values.
const TOML: &[Case] = &[
    ("unknown-key", CMM, &[(C, "coverage_factor", "coverage_facter")], CHECK),
    ("key-missing key=unit", CMM, &[(C, "unit = \"mm\"\n", "")], CHECK),
    ("unknown-variant text=milimetre", CMM, &[(C, "\"mm\"", "\"milimetre\"")], CHECK),
    ("value-of-other-kind", CMM, &[(C, "factor = 2", "factor = \"2\"")], CHECK),
    ("toml-invalid", CMM, &[(C, "name = \"PreXYT, CMM (synthetic)\"", "name = \"x")], CHECK),
    ("not-a-measured-value", CMM, &[(C, "_um = 2.7", "_um = nan")], CHECK),
    ("table-key-twice", CMM, &[(C, "factor = 2\n", "factor = 2\ncoverage_factor = 3\n")], CHECK),
    ("key-open key=target", CMM, &[(C, LABEL, "target = \"?\"")], CHECK),
    ("time-unit-open", CMM, &[(C, "pose = \"pose\"", "time_UNIT = \"Timestamp\"")], CHECK),
    ("angle-unit-open", CMM, &[(C, LABEL, "# rotation\nformat = { columns = [\"rx_UNIT\"] }")], CHECK),
    ("joint-unit-open", CMM, &[(C, "rho1_mm = ", "rho1_UNIT = ")], CHECK),
    ("campaign-missing", "", &[], "check @/nowhere"),
    ("environment-missing name=ETALON_NO_FOLDER", CMM, &[(C, "\"enc", "\"$ETALON_NO_FOLDER/enc")], CHECK),
    ("path-outside", CMM, &[(C, "\"encoders.csv\"", "\"../encoders.csv\"")], CHECK),
    ("angle-order-unknown", "probe-poses", &[(C, "ons.csv\"", "ons.csv\"\norientation = \"zxz fixed\"")], CHECK),
    ("selection-empty", CMM, &[(C, "\"1-8\"", "\"1-8, , 12\"")], CHECK),
];

const EIGHT: &str = "calibration = \"1-8\"";

/// Series of poses.
const SERIES: &[Case] = &[
    ("series-incomplete", CMM, &[(C, EIGHT, "calibration = \"1-8\"\nseries = [\"1-4\", \"6-59\"]")], CHECK),
    ("series-single", CMM, &[(C, EIGHT, "calibration = \"1-8\"\nseries = [\"all\"]")], CHECK),
    (
        "series-without-calibration",
        CMM,
        &[(C, EIGHT, "calibration = \"1-8\"\nseries = [\"1-4\", \"5-8\", \"rest\"]")],
        CHECK,
    ),
    (
        "series-not-estimated",
        CMM,
        &[(C, EIGHT, "calibration = \"1-6\"\nseries = [\"1-3\", \"rest\"]"), (C, "_um = 2.7", "_um = 0.5")],
        RUN,
    ),
];

/// Statements about exports, features and the world frame.
const FRAME: &[Case] = &[
    ("feature-unknown feature=rail", CMM, &[(C, PLANE, "plane = \"rail\"\n")], CHECK),
    ("label-unknown label=rail9_a", CMM, &[(C, "\"rail3_a\"]", "\"rail9_a\"]")], CHECK),
    ("point-or-feature-unknown name=R_hom", CMM, &[(C, "origin = \"R_home\"", "origin = \"R_hom\"")], CHECK),
    ("label-form-differs", CMM, &[(C, "{target}_{pose}_{cycle}", "{target}-{pose}-{cycle}")], CHECK),
    ("names-unchecked", CMM, &[("exports/world.txt", "", "\u{0}")], CHECK),
    ("feature-label-twice", CMM, &[(C, "\"rail2_a\", \"rail2_b\"", "\"rail2_a\", \"rail2_a\"")], CHECK),
    ("plane-frame-incomplete", CMM, &[(C, "towards = \"rail3_a\"\n", "")], CHECK),
    ("world-frame-definition", CMM, &[(C, PLANE, "as_exported = true\nplane = \"rails\"\n")], CHECK),
    ("nominal-without-tolerance", CMM, &[(C, PLANE, "tolerance_mm = 1.0\nplane = \"rails\"\n")], CHECK),
    ("frame-axis-without-direction", CMM, &[(C, "[\"R_home\", \"R_end\"]", "[\"R_home\"]")], CHECK),
    ("frame-axis-without-direction", CMM, &[(C, "[\"R_home\", \"R_end\"]", "[\"R_home\", \"R_home\"]")], CHECK),
    ("target-named-twice target=SMR_1", "delta", &[(C, "\"SMR_2\", \"SMR_3\"", "\"SMR_1\", \"SMR_3\"")], CHECK),
    ("frame-never-complete", "delta", &[(C, "\"floor_2\"", "\"floor_1\"")], CHECK),
    ("frame-few-targets", "delta", &[(C, ", \"floor_3\"", "")], CHECK),
    (
        "nominal-few-points",
        "delta",
        &[(
            C,
            FLOOR,
            "targets = [\"floor_1\", \"floor_2\", \"floor_3\"]\nnominal_mm = { floor_1 = [0, 0, 0], floor_2 = [1000, 0, 0] }\ntolerance_mm = 1.0",
        )],
        CHECK,
    ),
    ("labels-unused points=moving", CMM, &[("exports/poses.txt", "+", "extra 1 2 3\n")], CHECK),
    ("labels-unused points=stationary", CMM, &[("exports/world.txt", "+", "extra 1 2 3\n")], CHECK),
    ("export-files-missing", CMM, &[(C, "exports/poses.txt", "exports/{pose}-th.txt")], CHECK),
    ("key-and-file-name key=pose", CMM, &[(C, "exports/poses.txt", "exports/p{pose}ses.txt")], CHECK),
    ("export-empty", CMM, &[("exports/world.txt", "", "")], CHECK),
    ("quote-unmatched", "delta", &[("exports/poses.txt", "+", "\"SMR_1_99_1,1,2,3\n")], CHECK),
    ("key-and-column key=pose", "abb-irb120", &[(C, "\"x\", \"y\", \"z\"]", "\"x\", \"y\", \"z\", \"pose\"]")], CHECK),
    ("z-column-missing", "delta", &[(C, ", \"z\"]", "]")], CHECK),
];

/// Join and log.
const JOINED: &[Case] = &[
    ("join-clock-missing", CMM, &[(C, "by = [\"pose\", \"cycle\"]", "by = \"time\"")], CHECK),
    ("log-column-unknown key=rho3", CMM, &[(C, "rho3_mm =", "rho3 =")], CHECK),
    ("pose-name-empty", CMM, &[("encoders.csv", "\n1,1,", "\n1,,")], CHECK),
    ("pose-name-unprintable", CMM, &[("encoders.csv", "\n1,1,", "\n1,=1+1,")], CHECK),
    ("points-untouched", "dextar", &[("exports/plate.txt", "+", "1,1,W99,1.0,2.0,3.0\n")], CHECK),
    ("exclusion-mixed", CMM, &[(C, "[limits]", "[[identify.exclude]]\nrows = \"3\"\nreason = \"r\"\n[limits]")], CHECK),
    (
        "exclusion-file-unknown",
        CMM,
        &[(C, "[limits]", "[[identify.exclude]]\nfile = \"pose.txt\"\nrows = \"3\"\nreason = \"r\"\n[limits]")],
        CHECK,
    ),
    (
        "limit-without-result limit=accuracy_max_mm",
        CMM,
        &[(C, "position_max_mm = 0.044", "accuracy_max_mm = 0.044")],
        CHECK,
    ),
    ("section-beside-observations", CMM, &[(C, "[log]", "[observations]\nfile = \"o.csv\"\n[log]")], CHECK),
    ("parameter-unknown pattern=d_9", CMM, &[(C, "prior =", "hold = [\"d_9\"]\nprior =")], CHECK),
    ("pose-residuals-not-planar model=delta", "delta", &[(C, "[identify]", "[identify]\nresiduals = \"pose\"")], CHECK),
    (
        "standstill-time-missing",
        CMM,
        &[(C, "[join]", "[log.standstill]\nat_least_s = 1.0\nwithin_mm = 0.1\n[join]")],
        CHECK,
    ),
    (
        "times-missing",
        CMM,
        &[(C, "by = [\"pose\", \"cycle\"]", "by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0")],
        CHECK,
    ),
    (
        "encoder-implausible count=1",
        "draw-wire",
        &[("robot.toml", "a_mm = 70, theta_deg = 0", "a_mm = 70, theta_deg = 1.6")],
        RUN,
    ),
    ("gravity-without-direction", "column-arm", &[("robot.toml", "bending", "gravity = [0, 0, 0]\nbending")], CHECK),
    (
        "joint-angle-unit key=theta_deg unit=deg",
        "draw-wire",
        &[("robot.toml", "a_mm = 70, theta_deg = 0", "a_mm = 70, theta_deg = 1.5708")],
        CHECK,
    ),
    (
        "not-screw-axis",
        "probe-poses",
        &[(
            "robot.toml",
            "{ direction = [0, 0, 1], point_mm = [0, 0, 0] }",
            "{ direction = [0, 0, 1], point_mm = [0, 0, 0], a_mm = 3 }",
        )],
        CHECK,
    ),
    ("joints-twice", "column-arm", &[(C, UNIT, JOINTS)], CHECK),
    ("joints-joined-by-row", "column-arm", &[(C, COLUMN_LOG, ""), (C, UNIT, JOINTS)], CHECK),
    (
        "joints-differ",
        "column-arm",
        &[
            (C, COLUMN_LOG, ""),
            (C, "unit = \"m\"\n", JOINT),
            (C, "exports/world.txt", "exports/poses.txt"),
            (C, "\"L\" }\nlabel", "\"M\" }\nlabel"),
        ],
        CHECK,
    ),
    (
        "joints-need-delimited-text",
        CMM,
        &[
            (C, LOG, ""),
            (C, "by = [\"pose\", \"cycle\"]", "by = \"row\""),
            (C, "unit = \"mm\"\nlabel", "unit = \"mm\"\njoints = { rho1_mm = \"L\" }\nlabel"),
        ],
        CHECK,
    ),
    ("contact-without-targets", "dextar", &[(C, "residuals = \"targets\"", "residuals = \"pose\"")], CHECK),
    (
        "homing-incomplete",
        "delta",
        &[(C, "[identify]", "[homing]\nexpanded_uncertainty_um = 10\ncoverage_factor = 2\n[identify]")],
        CHECK,
    ),
    (
        "rigid-place-missing target=SMR_3",
        "delta",
        &[(
            C,
            "[log]",
            "[[rigid]]\ntargets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]\nplaces_mm = { SMR_1 = [0, 0, 0], SMR_2 = [1, 0, 0] }\nexpanded_uncertainty_um = 10\ncoverage_factor = 2\ntolerance_mm = 1.0\n[log]",
        )],
        CHECK,
    ),
    (
        "rigid-place-unknown target=SMR_9",
        "delta",
        &[(
            C,
            "[log]",
            "[[rigid]]\ntargets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]\nplaces_mm = { SMR_9 = [0, 0, 0] }\nexpanded_uncertainty_um = 10\ncoverage_factor = 2\ntolerance_mm = 1.0\n[log]",
        )],
        CHECK,
    ),
    (
        "rigid-places-need-uncertainty",
        "delta",
        &[(
            C,
            "[log]",
            "[[rigid]]\ntargets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]\nplaces_mm = { SMR_1 = [0, 0, 0], SMR_2 = [1, 0, 0], SMR_3 = [0, 1, 0] }\ntolerance_mm = 1.0\n[log]",
        )],
        CHECK,
    ),
];

/// Geometric calibration.
const GEOMETRIC: &[Case] = &[
    ("geometric-step-missing", GEOMETRY, &[(C, "arc = \"N-{pose}\"", "")], CHECK),
    ("travel-missing", GEOMETRY, &[("robot.toml", "travel_mm = [170.0, 300.0, 300.0]", "")], CHECK),
    ("errors-table-incomplete", GEOMETRY, &[(C, "turn = \"turn-{target}-{pose}\"", "")], CHECK),
    (
        "scale-bar-error",
        GEOMETRY,
        &[(C, "length_mm = 300.0", "length_mm = 300.4\npermissible_error_um = 50.0\nlength_uncertainty_um = 1.0")],
        "run @",
    ),
    ("scale-bar-deviates", GEOMETRY, &[(C, "length_mm = 300.0", "length_mm = 300.4")], "run @"),
    (
        "scale-bar-uncertain",
        GEOMETRY,
        &[(C, "length_mm = 300.0", "length_mm = 300.0\npermissible_error_um = 15.0\nlength_uncertainty_um = 10.0")],
        "run @",
    ),
    (
        "geometric-other-robot",
        GEOMETRY,
        &[
            ("robot.toml", "model = \"prexyt\"", "model = \"prexyt_full\""),
            ("robot.toml", "\nd = 115.0", "\nd1 = 115.0"),
            ("robot.toml", "\ndelta = 1.0", "\ndelta1 = 1.0"),
        ],
        "run @",
    ),
    ("actuator-unknown actuator=4", GEOMETRY, &[(C, "actuator = 3", "actuator = 4")], CHECK),
    (
        "stream-twice stream=corner",
        "prexyt-repeatability",
        &[(C, "[limits]", "[[stream]]\nname = \"corner\"\nfile = \"exports/motion.csv\"\n[limits]")],
        CHECK,
    ),
    (
        "recording-unit",
        "prexyt-repeatability",
        &[(C, "path = \"path.csv\"", "path = \"path.csv\"\nformat = \"polyworks\"")],
        CHECK,
    ),
];

#[test]
fn of_keys_and_values() {
    hold(TOML);
    hold(SERIES);
}

#[test]
fn of_features_and_frames() {
    hold(FRAME);
}

#[test]
fn of_joins_and_logs() {
    hold(JOINED);
}

#[test]
fn of_geometry_and_repeatability() {
    hold(GEOMETRIC);
}
