//! Messages about truth.toml and `etalon simulate`.

use super::{Case, hold};

const C: &str = "campaign.toml";
const T: &str = "truth.toml";
const CMM: &str = "prexyt-cmm";
const WIRE: &str = "draw-wire";
const TABLE: &str = "[observations]\nfile = \"observations.csv\"\n";
const ANCHOR: &str = "kind = \"distance\"\ntarget = \"ball\"\nother = \"anchor_A\"";
const SIMULATE: &str = "simulate @";
const HOME: &str = "home = [0.0, 0.0, 0.0]";
const TEST: &str = "\n[repeatability]\nexport = \"exports/visits.txt\"\ntarget = \"K\"\nplay_x_um = [7.0, 0.0, 0.0]\nplay_y_um = [0.0, 44.0, 10.0]\nhome = [0.0, 0.0, 0.0]\nhomings = 10\nhoming_um = 0.3\npose = []\n";

const CASES: &[Case] = &[
    (
        "export-without-points",
        CMM,
        &[(C, "[log]", "[[export]]\nfile = \"exports/more.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\n[log]")],
        SIMULATE,
    ),
    (
        "simulate-utf8",
        CMM,
        &[(C, "unit = \"mm\"\nlabel", "unit = \"mm\"\nencoding = \"windows-1252\"\nlabel")],
        SIMULATE,
    ),
    (
        "simulate-not-written",
        CMM,
        &[(C, "[join]", "[log.standstill]\nat_least_s = 1.0\nwithin_mm = 0.1\n[join]")],
        SIMULATE,
    ),
    (
        "simulated-column-unknown",
        CMM,
        &[(C, "rho3_mm = \"RP3\"", "rho3_mm = \"RP3\", temperature_c = \"T\"")],
        SIMULATE,
    ),
    ("simulated-column-clash", CMM, &[(C, "rho3_mm = \"RP3\"", "rho3_mm = \"RP2\"")], SIMULATE),
    ("format-not-simulated", CMM, &[(C, "format = \"polyworks\"", "format = \"qif\"")], SIMULATE),
    (
        "format-without-unit",
        CMM,
        &[(C, "format = \"polyworks\"\nunit = \"mm\"", "format = \"pcdmis_xyz\"\nunit = \"m\"")],
        SIMULATE,
    ),
    (
        "several-tables",
        WIRE,
        &[(C, TABLE, "[[observations]]\nfile = \"observations.csv\"\n[[observations]]\nfile = \"more.csv\"\n")],
        SIMULATE,
    ),
    (
        "table-without-observe",
        WIRE,
        &[(T, "", "seed = 1\ncycles = 1\ndecimals = 6\n[parameters]\n[[poses]]\njoints = [[0, 0, 0, 0, 0, 0]]\n")],
        SIMULATE,
    ),
    (
        "observe-without-table",
        "delta",
        &[(
            T,
            "[[point]]\nlabel = \"floor_1\"",
            "[[observe]]\nkind = \"point\"\ntarget = \"SMR_1\"\n[[point]]\nlabel = \"floor_1\"",
        )],
        SIMULATE,
    ),
    ("truth-parameters-missing", WIRE, &[(T, "anchor_A_x = 900.0\n", "")], SIMULATE),
    ("truth-parameter-unknown parameter=s_9", WIRE, &[(T, "gain_6 = 1.0001", "gain_6 = 1.0001\ns_9 = 1.0")], SIMULATE),
    ("truth-joint-count", CMM, &[(T, "    [0.0, 300.0, 300.0],", "    [0.0, 300.0],")], SIMULATE),
    (
        "truth-circles-not-planar",
        "delta",
        &[(T, "+", "[[poses]]\ncircles = [{ center_mm = [0, 0], diameter_mm = 10, count = 3 }]\n")],
        SIMULATE,
    ),
    (
        "truth-label-with-circles",
        CMM,
        &[(T, "theta_deg = [0.0, -15.0, 15.0]", "theta_deg = [0.0]\nlabel = \"A\"")],
        SIMULATE,
    ),
    (
        "truth-point-unknown label=P99",
        CMM,
        &[(T, "+", "\n[[poses]]\nlabel = \"P99\"\njoints = [[0.0, 0.0, 0.0]]\n")],
        SIMULATE,
    ),
    ("truth-pose-out-of-reach", CMM, &[(T, "    [0.0, 300.0, 300.0],", "    [0.0, 900.0, 300.0],")], SIMULATE),
    ("truth-home-count", "prexyt-repeatability", &[(T, HOME, "home = [0.0, 0.0]")], SIMULATE),
    ("truth-target-unknown target=T9", "prexyt-repeatability", &[(T, "target = \"K\"", "target = \"T9\"")], SIMULATE),
    ("truth-pose-missing pose=6", "prexyt-repeatability", &[(C, "4, 1, 5]", "4, 1, 6]")], SIMULATE),
    ("truth-repeatability-without-campaign", CMM, &[(T, "+", TEST)], SIMULATE),
    (
        "coordinates-of-other-kind",
        WIRE,
        &[(T, ANCHOR, "kind = \"distance\"\ncoordinates = \"xy\"\ntarget = \"ball\"\nother = \"anchor_A\"")],
        SIMULATE,
    ),
    ("coordinates-unknown text=h", "surfaces", &[(T, "coordinates = \"z\"", "coordinates = \"h\"")], SIMULATE),
    ("observe-key-missing column=other", WIRE, &[(T, ANCHOR, "kind = \"distance\"\ntarget = \"ball\"")], SIMULATE),
    ("angle-uncertainty-missing", "probe-poses", &[(C, "expanded_rotation_uncertainty_deg = 0.02\n", "")], SIMULATE),
    (
        "known-unsupported kind=contact",
        WIRE,
        &[(T, "+", "\n[[known]]\nkind = \"contact\"\ntarget = \"anchor_A\"\nu_um = 1.0\n")],
        SIMULATE,
    ),
    (
        "near-without-surface",
        WIRE,
        &[(T, "+", "\n[[known]]\nkind = \"point\"\ntarget = \"anchor_A\"\nnear_mm = [0, 0, 0]\nu_um = 1.0\n")],
        SIMULATE,
    ),
    (
        "near-missing kind=plane",
        "surfaces",
        &[(T, "+", "\n[[known]]\nkind = \"plane\"\ntarget = \"table\"\nu_um = 1.0\n")],
        SIMULATE,
    ),
    (
        "joints-and-points-together",
        "delta",
        &[
            (
                C,
                "[log]\nfile = \"encoders.csv\"\n\n[log.columns]\npose = \"pose\"\ncycle = \"cycle\"\ntheta1_deg = \"J1\"\ntheta2_deg = \"J2\"\ntheta3_deg = \"J3\"\n",
                "",
            ),
            (C, "by = [\"pose\", \"cycle\"]", "by = \"row\""),
            (
                C,
                "unit = \"mm\"\nlabel",
                "unit = \"mm\"\njoints = { theta1_deg = 5, theta2_deg = 6, theta3_deg = 7 }\nlabel",
            ),
        ],
        SIMULATE,
    ),
];

#[test]
fn of_truths() {
    hold(CASES);
}
