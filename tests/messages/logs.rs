//! Messages about joins by time, tables and formats of rows.

use super::{CHECK, Case, hold};

const C: &str = "campaign.toml";
const E: &str = "exports/poses.txt";
pub(super) const L: &str = "encoders.csv";
const CMM: &str = "prexyt-cmm";
/// A campaign whose points and rows have times.
pub(super) const TIMED: (&str, &str, &str) = (
    C,
    "",
    "name = \"timed\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\ncoverage_factor = 2\n\
     [[export]]\nfile = \"exports/poses.txt\"\nformat = { delimiter = \";\", columns = [\"target\", \"time_s\", \"x\", \"y\", \"z\"] }\nunit = \"mm\"\n\
     [log]\nfile = \"encoders.csv\"\ncolumns = { time_s = \"t\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n\
     [join]\nby = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0\n[frame.world]\nas_exported = true\n[identify]\ncalibration = \"all\"\n",
);
pub(super) const POINTS: (&str, &str, &str) = (E, "", "K;10.2;1;2;0\nL;10.2;3;4;0\nK;20.2;5;6;0\nL;20.2;7;8;0\n");
const ROWS: &str = "t,RP1,RP2,RP3\n10,0,300,300\n20,0,0,256\n";
/// The points are near the nominal robot.
const COARSE: (&str, &str, &str) = (C, "expanded_uncertainty_um = 2\n", "expanded_uncertainty_um = 2000\n");
const MEASURED: (&str, &str, &str) =
    (E, "", "K;10.2;66.7767;342.3232;0\nL;10.2;212.7986;342.6090;0\nK;20.2;38.5895;66.4283;0\n");
const WORLD: &str = "columns = [\"label\", \"x\", \"y\", \"z\"]";

/// An expression of 300 levels.
const NESTED: &str = "{{ not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not not 1 }}";

const CASES: &[Case] = &[
    ("log-times-not-increasing row=3", CMM, &[TIMED, POINTS, (L, "", ROWS), (L, "+", "15,0,300,44\n")], CHECK),
    (
        "target-time-twice target=K",
        CMM,
        &[
            TIMED,
            POINTS,
            (C, "tolerance_s = 1.0", "tolerance_s = 20.0\ninterpolate = true"),
            (L, "", ROWS),
            (L, "+", "30,0,300,44\n"),
            (E, "+", "K;20.2;5;6;0\n"),
        ],
        CHECK,
    ),
    (
        "join-by-time-empty",
        CMM,
        &[TIMED, POINTS, (L, "", ROWS), (C, "clock_offset_s = 0.0", "clock_offset_s = 3600.0")],
        CHECK,
    ),
    (
        "join-by-time-empty hint=both-rows-near",
        CMM,
        &[TIMED, POINTS, (L, "", ROWS), (C, "tolerance_s = 1.0", "tolerance_s = 1.0\ninterpolate = true")],
        CHECK,
    ),
    (
        "partial-coordinates",
        "surfaces",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --standard-uncertainty-um 20",
    ),
    (
        "changes-at-standstill column=pose",
        CMM,
        &[
            TIMED,
            POINTS,
            (C, "time_s = \"t\",", "time_s = \"t\", pose = \"p\","),
            (C, "[join]", "[log.standstill]\nat_least_s = 1.0\nwithin_mm = 0.1\n[join]"),
            (L, "", "t,p,RP1,RP2,RP3\n9,1,0,300,300\n10,1,0,300,300\n11,2,0,300,300\n12,2,0,300,300\n"),
        ],
        CHECK,
    ),
    (
        "orientation-incomplete",
        "delta",
        &[
            (C, WORLD, "columns = [\"label\", \"x\", \"y\", \"z\", \"qw\", \"qx\", \"qy\", \"qz\"]"),
            ("exports/world.txt", "", "floor_1,0,0,0,1,0,0,\n"),
        ],
        CHECK,
    ),
    (
        "coordinate-type-unknown name=3",
        "delta",
        &[
            (
                C,
                WORLD,
                "columns = [\"label\", \"type\", \"c1\", \"c2\", \"c3\"], types = { 0 = [\"x\", \"y\", \"z\"] }",
            ),
            ("exports/world.txt", "", "floor_1,3,0,0,0\n"),
        ],
        CHECK,
    ),
    ("origin-not-measured line=1", CMM, &[(E, "357.15901 493.95605 138.80533", "0 0 0")], CHECK),
    ("log-without-values column=rho1_mm", CMM, &[(L, "", "run,pose,RP1,RP2,RP3\n1,1,,300,300\n1,2,-,0,256\n")], CHECK),
    (
        "log-constant-invalid column=cycle",
        CMM,
        &[(C, "cycle = \"run\", ", ""), (C, "\"RP3\" }\n", "\"RP3\" }\nconstants = { cycle = 1.5 }\n")],
        CHECK,
    ),
    (
        "database-unreadable fault=end",
        CMM,
        &[(C, "\"encoders.csv\"", "\"encoders.csv\"\ntopic = \"/joints\""), (L, "", "SQLite format 3\0 and no more")],
        CHECK,
    ),
    ("station-join-by-label station=B", "dextar", &[(C, "unit = \"mm\"\n", "unit = \"mm\"\nstation = \"B\"\n")], CHECK),
    ("joint-values-repeat", CMM, &[(L, ",2,0.000000,0.000000,256.000000", ",2,0.000000,300.000000,300.000000")], CHECK),
    ("repeats-scatter", CMM, &[(C, "_um = 2.7", "_um = 0.27")], CHECK),
    ("template-too-nested", "prexyt-cmm+out", &[("t/report.html", "", NESTED)], "report @/out --templates @/t"),
    ("lock-foreign", CMM, &[(".out.lock/file", "", "")], "run @"),
    (
        "assembly-modes-assumed",
        "dextar+out",
        &[("out/observations.csv", "assembly", "ignored")],
        "identify --robot @/robot.toml --observations @/out/observations.csv --standard-uncertainty-um 5",
    ),
    (
        "template-invalid",
        "prexyt-cmm+out",
        &[("t/report.html", "", "{{ title | upppercase }}")],
        "report @ --templates @/t",
    ),
    ("rows-without-point count=1", CMM, &[TIMED, COARSE, MEASURED, (L, "", ROWS), (L, "+", "99,0,300,44\n")], CHECK),
    (
        "several-rows-near count=3",
        CMM,
        &[TIMED, COARSE, MEASURED, (L, "", ROWS), (C, "tolerance_s = 1.0", "tolerance_s = 20.0")],
        CHECK,
    ),
    (
        "time-invalid",
        CMM,
        &[
            TIMED,
            (E, "", "K;26.11.2026 25:00:00;1;2;0\n"),
            (L, "", ROWS),
            (C, "\"target\", \"time_s\"", "\"target\", \"timestamp\""),
        ],
        CHECK,
    ),
    ("cannot-write-folder", CMM, &[("out", "", "a file")], "run @"),
];

#[test]
fn of_times_and_rows() {
    hold(CASES);
}
