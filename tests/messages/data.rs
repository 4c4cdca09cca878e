//! Messages about what measurements show: frames, joins, fits and residuals.

use super::logs::{L, POINTS, TIMED};
use super::{CHECK, Case, Edits, RUN, hold};

/// A single load, with readings at 0, 1.5 and 3 kg.
const LOADED: Edits = &[("campaign.toml", "[limits]", "[conditions]\nload_kg = 1.0\n\n[limits]")];

const C: &str = "campaign.toml";
const CMM: &str = "prexyt-cmm";
const E: &str = "exports/poses.txt";
const TEST: &str = "prexyt-repeatability";

/// A campaign whose world frame is measured at each pose.
const EACH: (&str, &str, &str) = (
    C,
    "",
    "name = \"each\"\nrobot = \"robot.toml\"\n[instrument]\nname = \"i\"\nexpanded_uncertainty_um = 2\ncoverage_factor = 2\n\
     [[export]]\nfile = \"exports/poses.txt\"\nformat = \"polyworks\"\nunit = \"mm\"\nlabel = \"{target}_{pose}_{cycle}\"\n\
     [log]\nfile = \"encoders.csv\"\ncolumns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n\
     [join]\nby = [\"pose\", \"cycle\"]\n[frame.world]\ntargets = [\"A\", \"B\", \"D\"]\neach = \"pose\"\n[identify]\ncalibration = \"all\"\n",
);
/// Frame target D is missing at pose 2.
const FRAMED: (&str, &str, &str) = (
    E,
    "",
    "A_1_1 1 0 0\nB_1_1 101 0 0\nD_1_1 1 100 0\nK_1_1 1 2 0\nL_1_1 3 4 0\nA_2_1 1 0 0\nB_2_1 101 0 0\nK_2_1 5 6 0\nL_2_1 7 8 0\n",
);

/// Frames and joins.
const GATHERED: &[Case] = &[
    (
        "rigid-row-refused target=SMR_1",
        "delta",
        &[
            (C, "[log]\n", "[[rigid]]\ntargets = [\"SMR_1\", \"SMR_2\", \"SMR_3\"]\ntolerance_mm = 1.0\n[log]\n"),
            (E, "SMR_1_1_1,2461.392979", "SMR_1_1_1,2471.392979"),
        ],
        CHECK,
    ),
    (
        "decimal-mark-wrong target=SMR_1 axis=x",
        "delta",
        &[(E, "SMR_1_1_1,2461.392979", "SMR_1_1_1,2461392.979")],
        CHECK,
    ),
    (
        "rows-not-measured by=line",
        "torque-arm",
        &[("observations.csv", ",2203.652999,-1037.171434,-120.957270", ",,,")],
        "identify --robot @/robot.toml --observations @/observations.csv --standard-uncertainty-um 20",
    ),
    (
        "positions-repeat",
        CMM,
        &[(E, "K_2_1 346.83668 216.81931 137.72967", "K_2_1 357.15901 493.95605 138.80533")],
        CHECK,
    ),
    (
        "repeatability-frame",
        CMM,
        &[
            EACH,
            FRAMED,
            (E, "+", "D_2_1 1 100 0\n"),
            (
                C,
                "[log]\nfile = \"encoders.csv\"\ncolumns = { pose = \"pose\", cycle = \"run\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\" }\n[join]\nby = [\"pose\", \"cycle\"]\n",
                "",
            ),
            (
                C,
                "[identify]\ncalibration = \"all\"\n",
                "[repeatability]\nlabel = \"K_{pose}_{cycle}\"\ntrajectory = [1, 2]\n",
            ),
        ],
        RUN,
    ),
    (
        "join-key-missing key=pose",
        CMM,
        &[
            TIMED,
            POINTS,
            (L, "", "t,p,c,RP1,RP2,RP3\n10,1,1,0,300,300\n20,2,1,0,0,256\n"),
            (C, "time_s = \"t\",", "pose = \"p\", cycle = \"c\","),
            (C, "by = \"time\"\nclock_offset_s = 0.0\ntolerance_s = 1.0\n", "by = [\"pose\", \"cycle\"]\n"),
        ],
        CHECK,
    ),
    (
        "pose-without-frame count=1",
        CMM,
        &[
            EACH,
            (C, "expanded_uncertainty_um = 2\n", "expanded_uncertainty_um = 2000\n"),
            (
                E,
                "",
                "A_1_1 1 0 0\nB_1_1 101 0 0\nD_1_1 1 100 0\nK_1_1 67.7767 342.3232 0\nL_1_1 213.7986 342.6090 0\nA_2_1 1 0 0\nB_2_1 101 0 0\nK_2_1 39.5895 66.4283 0\n",
            ),
        ],
        CHECK,
    ),
    (
        "join-by-label-frame",
        "dextar",
        &[
            EACH,
            (C, "exports/poses.txt", "exports/p.txt"),
            (C, "file = \"encoders.csv\"", "file = \"e.csv\""),
            (
                C,
                "pose = \"pose\", cycle = \"run\", rho1_mm = \"RP1\", rho2_mm = \"RP2\", rho3_mm = \"RP3\"",
                "label = \"label\", theta1_deg = \"a\", theta2_deg = \"b\"",
            ),
            (C, "by = [\"pose\", \"cycle\"]", "by = \"label\"\ntargets = [\"T\"]"),
            ("e.csv", "", "label,a,b\nT_1_1,10,20\nT_2_1,30,40\n"),
            (
                "exports/p.txt",
                "",
                "A_1_1 1 0 0\nB_1_1 101 0 0\nD_1_1 1 100 0\nT_1_1 67 342 0\nA_2_1 1 0 0\nB_2_1 101 0 0\nD_2_1 1 100 0\nT_2_1 39 66 0\n",
            ),
        ],
        CHECK,
    ),
    (
        "direction-uncertain",
        CMM,
        &[
            (C, "expanded_uncertainty_um = 2.7", "expanded_uncertainty_um = 9000"),
            ("exports/world.txt", "rail2_a 323.26492 108.80135 95.27373", "rail2_a 323.26492 108.80135 100.0"),
        ],
        CHECK,
    ),
    (
        "table-without-poses",
        "prexyt-geometric",
        &[
            (E, "L_9_", "M_9_"),
            (E, "L_10_", "M_10_"),
            (E, "L_11_", "M_11_"),
            (E, "L_12_", "M_12_"),
            (E, "L_13_", "M_13_"),
        ],
        RUN,
    ),
    ("step-scatters", "prexyt-geometric", &[(C, "12.73", "1.273")], RUN),
    ("homing-instrument-too-coarse", TEST, &[], RUN),
    (
        "pose-of-several-targets",
        TEST,
        &[
            (C, "\"P{pose}-{cycle}\"", "\"{target}{pose}-{cycle}\""),
            ("exports/visits.txt", "+", "Q2-1 465.66580 406.26423 106.13449\n"),
        ],
        RUN,
    ),
    ("identify-missing", TEST, &[], "validate @"),
    (
        "frame-point-off point=floor_4",
        "delta",
        &[
            (
                C,
                "\"floor_3\"]",
                "\"floor_3\", \"floor_4\"]\nnominal_mm = { floor_1 = [0, 0, 0], floor_2 = [1000, 0, 0], floor_3 = [0, 1000, 0], floor_4 = [1000, 1000, 0] }\ntolerance_mm = 0.1",
            ),
            ("exports/world.txt", "", "floor_1,1,0,0\nfloor_2,1001,0,0\nfloor_3,1,1000,0\nfloor_4,1001,1000,5\n"),
        ],
        CHECK,
    ),
];

/// Residuals and parameters.
const IDENTIFIED: &[Case] = &[
    ("parameter-held-inseparable", "column-arm", &[], RUN),
    ("target-place-free", "linear-delta", &[], RUN),
    ("parameter-groups-weakly-identifiable", "column-arm", &[], RUN),
    ("parameters-fixed-by-frames", "draw-wire", &[], RUN),
    (
        "robust-fit-disagrees-at-poses",
        CMM,
        &[(E, "K_2_1 346.83668", "K_2_1 346.93668"), (E, "K_2_2 346", "K_2_2 347")],
        RUN,
    ),
    ("limit-not-assessable", "draw-wire", &[(C, "distance_max_mm = 0.4", "position_max_mm = 0.4")], RUN),
    ("largest-residuals", CMM, &[(C, "_um = 2.7", "_um = 1.35")], RUN),
    ("outliers", CMM, &[(E, "K_2_1 346.83668", "K_2_1 346.93668")], RUN),
    ("validation-outliers", CMM, &[(E, "K_20_1 418.98933", "K_20_1 419.48933")], RUN),
    ("few-poses-to-leave-out count=2", "draw-wire", &[(C, "\"1-60\"", "\"1-2\"")], "recommend @"),
    ("placement-unexplained", "column-arm", &[(C, "[identify]", "[identify]\nhold = [\"base_rz\", \"base_ry\"]")], RUN),
    (
        "robust-fit-disagrees parameter=shoulder_pan_rx",
        "column-arm",
        &[(C, "[identify]", "[identify]\nhold = [\"base_*\", \"SMR_*\"]")],
        RUN,
    ),
    (
        "parameters-weakly-identifiable",
        "warming-arm",
        &[(C, "[identify]", "[identify]\nhold = [\"q1_rx\", \"q4_rz\"]")],
        RUN,
    ),
    (
        "scale-unobserved",
        "contacts",
        &[(C, "file = \"observations.csv\"", "file = \"observations.csv\"\nwithout = { kind = [\"distance\"] }")],
        RUN,
    ),
    (
        "common-errors-of-conditions",
        "draw-wire",
        &[(C, "coverage_factor = 2", "coverage_factor = 2\nexpanded_scale_uncertainty_um_per_m = 10")],
        "uncertainty @ --draws 100 --resamples 0",
    ),
    (
        "parameter-held-without-effect",
        "turntable",
        &[("t.csv", "", ONE_ROW), ("t.csv", "+", "1,2,\n2,A,10,0,0,0,0,0,0,1,3,\n")],
        "identify --robot @/robot.toml --observations @/t.csv --standard-uncertainty-um 10",
    ),
    (
        "table-value-missing",
        "turntable",
        &[("t.csv", "", ONE_ROW), ("t.csv", "+", ",,\n")],
        "identify --robot @/robot.toml --observations @/t.csv --standard-uncertainty-um 10",
    ),
    (
        "identification-without-result reason=extents-differ",
        "turntable",
        &[("t.csv", "", ONE_ROW), ("t.csv", "+", "1e170,1e170,2e170\n2,A,9,8,7,6,5,4,3,1e170,-1e170,1e170\n")],
        "identify --robot @/robot.toml --observations @/t.csv --standard-uncertainty-um 10",
    ),
    (
        "target-far-from-given target=probe",
        "probe-poses",
        &[("robot.toml", "+", "\n[nominal]\nprobe_x = 900\nprobe_y = 0\nprobe_z = 0\n")],
        "identify --robot @/robot.toml --observations @/observations.csv --standard-uncertainty-um 20 --rotation-uncertainty-deg 0.01",
    ),
    (
        "columns-inverted",
        "draw-wire",
        &[("t.csv", "", "no,target,q1_deg,x_mm\n1,A,0,0\n")],
        "identify --robot @/robot.toml --observations @/t.csv --column no=pose",
    ),
    (
        "kinds-need-target-residuals",
        "draw-wire",
        &[],
        "identify --robot @/robot.toml --observations @/observations.csv --standard-uncertainty-um 20 --pose-residuals",
    ),
    ("place-without-nominal", "column-arm", &[], "validate @ --frames given"),
    ("payload-column-missing column=load_kg", "payload-arm", &[("observations.csv", "load_kg", "mass_kg")], RUN),
    ("payload-column-missing column=load_z_mm", "payload-arm", &[("observations.csv", "load_z_mm", "lz_mm")], RUN),
    (
        "load-columns-slip",
        "payload-arm",
        &[("observations.csv", "load_x_mm,load_y_mm,load_z_mm", "load_z_mm,load_y_mm,load_x_mm")],
        RUN,
    ),
    ("payload-invalid column=load_kg value=-3", "payload-arm", &[("observations.csv", ",3.000000,", ",-3.0,")], RUN),
    ("payload-invalid column=load_kg value=missing", "payload-arm", &[("observations.csv", ",3.000000,", ",,")], RUN),
    ("load-elsewhere", "payload-arm", LOADED, CHECK),
    ("torque-column-missing joint=q3", "torque-arm", &[("observations.csv", "tau3_nm", "tau_3")], RUN),
    ("torque-invalid column=tau1_nm value=missing", "torque-arm", &[("observations.csv", ",-0.033380,", ",,")], RUN),
    (
        "temperature-column-missing column=temperature_c",
        "warming-arm",
        &[("observations.csv", "temperature_c", "temp")],
        RUN,
    ),
    (
        "temperature-invalid column=temperature_c value=-999",
        "warming-arm",
        &[("observations.csv", ",19.500000,", ",-999,")],
        RUN,
    ),
    (
        "base-off-nominal",
        "probe-poses",
        &[(
            "robot.toml",
            "convention",
            "nominal = { base_x = 0, base_y = 0, base_z = 0, base_rx = 0, base_ry = 0, base_rz = 0 }\nconvention",
        )],
        RUN,
    ),
];

const ONE_ROW: &str = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,q7_deg,x_mm,y_mm,z_mm\n1,A,0,0,0,0,0,0,0,";

pub(super) const QIF: &str = "<QIFDocument versionQIF=\"3.0.0\"><FileUnits><PrimaryUnits><LinearUnit><UnitName>mm</UnitName><UnitConversion><Factor>0.001</Factor></UnitConversion></LinearUnit></PrimaryUnits></FileUnits>\n<Results><MeasuredFeatures n=\"1\"><PlaneFeatureMeasurement id=\"1\">\n<PointList n=\"1\"><WholePointSetId>2</WholePointSetId></PointList></PlaneFeatureMeasurement></MeasuredFeatures>\n<MeasuredPointSet id=\"2\" count=\"4\"><Points>0 0 0 1 0 0 0 1 0 1 1 0.001</Points><Compensated>true</Compensated></MeasuredPointSet></Results></QIFDocument>";

/// Commands with a table of a few rows.
const TABLES: &[Case] = &[
    (
        "header-is-data rows=1",
        CMM,
        &[(
            C,
            "file = \"exports/poses.txt\"\nformat = \"polyworks\"",
            "file = \"exports/poses.txt\"\nformat = { delimiter = \"blank\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"] }",
        )],
        CHECK,
    ),
    ("columns-not-read count=1", "surfaces", &[("observations.csv", "offset_mm,u_mm", "offset_mm,um_mm")], RUN),
    (
        "proposal-not-toml",
        "",
        &[
            ("a.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n1,0,0,1\n"),
            ("b.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n1,0,0,1\n"),
            ("c.csv", "", "pose,x_mm,y_mm,z_mm\n1,0,0,0\n"),
        ],
        "init @/new --robot ur5e --from @/a.csv @/b.csv @/c.csv",
    ),
    ("nothing-recognised name=README.md", CMM, &[], "init @/new --robot ur5e --from @/README.md"),
    (
        "axis-table-too-short positions=1",
        "",
        &[("t.csv", "", "position_mm,measured_mm,direction\n0,0.001,1\n0,0.002,1\n0,0.001,-1\n0,0.002,-1\n")],
        "iso230 @/t.csv --compensation sinumerik",
    ),
    (
        "deviation-steep",
        "",
        &[(
            "t.csv",
            "",
            "position_mm,measured_mm,direction\n0,0,1\n0,0,1\n0,0,-1\n0,0,-1\n10,12,1\n10,12,1\n10,12,-1\n10,12,-1\n",
        )],
        "iso230 @/t.csv",
    ),
    (
        "convert-gains-not-held",
        "draw-wire+out",
        &[],
        "robot convert @/robot.toml --to urdf --parameters @/out/parameters.json",
    ),
    ("convert-shared-joints", "column-arm", &[], "robot convert @/robot.toml --to poe"),
    ("convert-travel-unknown", "rail-arm", &[], "robot convert @/robot.toml --to urdf"),
    (
        "table-base-not-held",
        "probe-poses",
        &[(
            "robot.toml",
            "{ direction = [0, 0, 1], point_mm = [0, 0, 0] }",
            "{ direction = [0, 0, 1], point_mm = [40, 30, 0] }",
        )],
        "robot convert @/robot.toml --to dh",
    ),
    (
        "cell-empty column=cycle",
        "",
        &[("t.csv", "", "pose,cycle,x_mm,y_mm,z_mm\n1,1,0,0,0\n1,,0,0,0.1\n")],
        "iso9283 pose @/t.csv",
    ),
    (
        "corner-in-central-part",
        "",
        &[
            (
                "t.csv",
                "",
                "time_s,x_mm,y_mm,z_mm\n0,-1,0,0\n1,20,0,0\n2,40,0,0\n3,60,0,0\n4,80,0,0\n5,100,0,0\n6,100,20,0\n7,100,40,0\n8,100,60,0\n9,100,80,0\n10,100,101,0\n",
            ),
            ("path.csv", "", "x_mm,y_mm,z_mm\n0,0,0\n100,0,0\n100,100,0\n"),
        ],
        "iso9283 path @/t.csv --path @/path.csv --near-mm 5 --velocity-mm-s 20",
    ),
    ("arrivals-unsettled", TEST, &[(C, "band_mm = 0.02", "band_mm = 0.0001")], RUN),
    (
        "joint-direction-invalid",
        "rail-arm",
        &[(
            "t.csv",
            "",
            "pose,target,q1_mm,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,q7_deg,q2_direction,q3_direction,q4_direction,x_mm,y_mm,z_mm\n1,A,0,0,0,0,0,0,0,0,1,1,300,0,600\n",
        )],
        "identify --robot @/robot.toml --observations @/t.csv",
    ),
    (
        "base-not-in-world",
        "delta+out",
        &[("t.csv", "", "pose,x_mm,y_mm,z_mm,qw,qx,qy,qz\n1,0,0,-300,1,0,0,0\n")],
        "compensate @/t.csv --robot @/robot.toml --parameters @/out/parameters.json --frame world",
    ),
    ("reach-unknown", "draw-wire", &[], "iso9283 plan --workspace-mm 300,-250,100,900,350,500 --robot @/robot.toml"),
    (
        "direction-zero",
        "",
        &[("b.qif", "", QIF), ("b.qif", "<PointList n", "<Normal>0 0 0</Normal><PointList n")],
        "fit plane @/b.qif",
    ),
    ("qif-robust", "", &[("b.qif", "", QIF)], "fit plane @/b.qif --robust"),
    ("no-feature-fitted", "", &[("b.qif", "", QIF)], "fit sphere @/b.qif"),
    (
        "probe-of-feature-unknown",
        "",
        &[("b.qif", "", QIF), ("b.qif", "<Compensated>true", "<Compensated>false")],
        "fit plane @/b.qif",
    ),
    (
        "start-too-large",
        "draw-wire",
        &[("t.csv", "", "pose,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg\n1,0,0,0,0,0,0\n2,9,9,0,0,0,0\n")],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1 --start 1,2",
    ),
    (
        "candidate-positions-unreachable",
        "dextar",
        &[("t.csv", "", "pose,x_mm,y_mm\n1,9000,9000\n")],
        "plan --robot @/robot.toml --candidates @/t.csv --target A --positions 1",
    ),
    (
        "coordinates-of-rows-missing by=line",
        "surfaces",
        &[(
            "t.csv",
            "",
            "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n1,A,0,0,0,0,0,0,374,0,630\n2,A,10,0,0,0,0,0,nan,65,630\n",
        )],
        "identify --robot @/robot.toml --observations @/t.csv",
    ),
    (
        "joints-do-not-move rows=2",
        "surfaces",
        &[(
            "t.csv",
            "",
            "pose,cycle,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n1,1,A,0,0,0,0,0,0,374,0,630\n1,2,A,0,0,0,0,0,0,374.01,0,630\n",
        )],
        "identify --robot @/robot.toml --observations @/t.csv",
    ),
    (
        "arms-apart",
        "dextar",
        &[("t.csv", "", "pose,target,theta1_deg,theta2_deg,x_mm,y_mm\n1,tool,180,0,0,0\n")],
        "identify --robot @/robot.toml --observations @/t.csv",
    ),
    (
        "kind-of-arms kind=joints",
        CMM,
        &[(
            "t.csv",
            "",
            "kind,pose,target,rho1_mm,rho2_mm,rho3_mm,joint,value_mm,x_mm,y_mm\njoints,1,K,0,0,0,rho1,0.1,,\n",
        )],
        "identify --robot @/robot.toml --observations @/t.csv --standard-uncertainty-um 5",
    ),
];

const GEOMETRIC: &str = "\n[geometric.arc]\nball_mm = [500.0, 3.0, 30.0]\nrho3_end_mm = 276.0\ncount = 36\n[geometric.turn]\nball_mm = [85.0, 12.0, 25.0]\ntarget_height_mm = 42.0\nat_mm = [201.0, 150.0]\ntheta_deg = 35.0\ncount = 36\n[geometric.shaft]\nradius_mm = 9.525\nheight_mm = 30.0\nrings_mm = [60.0, 370.0]\nrings = 5\npoints = 8\nrho2_mm = [0.0, 300.0]\nrho3_mm = 150.0\nrepeats = 5\n[geometric.offsets]\nrho23_mm = 150.0\nrho1_end_mm = 170.0\nrepeats = 5\nhoming_um = 0.67\n[[geometric.lead]]\nactuator = 1\nball_mm = [140.0, -20.0, 20.0]\npositions_mm = [0.0, 28.0, 56.0, 84.0, 112.0, 140.0, 168.0]\npasses = 10\n[[geometric.lead]]\nactuator = 2\nball_mm = [5.0, 0.0, 20.0]\npositions_mm = [0.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0]\npasses = 10\n[[geometric.lead]]\nactuator = 3\nball_mm = [420.0, -10.0, 20.0]\npositions_mm = [0.0, 50.0, 100.0, 150.0, 200.0, 250.0, 300.0]\npasses = 10\n[[geometric.scale_bar]]\nfrom_mm = [60.0, -80.0, 60.0]\ndirection = [1.0, 0.0, 0.0]\nlength_mm = 300.0\nrepeats = 10\n[[geometric.scale_bar]]\nfrom_mm = [-60.0, 20.0, 60.0]\ndirection = [0.0, 1.0, 0.0]\nlength_mm = 300.0\nrepeats = 10\n[[geometric.ball]]\nat_mm = [270.0, 80.0, 42.0]\nrepeats = 10\n";

const STUDY: &str = "robot = \"robot.toml\"\ntargets = [\"K\", \"L\"]\nframe = \"base\"\nseed = 1\nruns = 1\ndraws = 2\nnoise_um = [5.0]\n[parameters]\n[[workspace]]\njoints = [[10,150,150]]\n[[set]]\nname = \"a\"\n[[set.poses]]\njoints = [[10,150,150],[20,150,150]]\n";

/// Truths and studies.
const SIMULATED: &[Case] = &[
    ("study-too-few-poses", CMM, &[("study.toml", "", STUDY)], "study @/study.toml"),
    (
        "study-not-by-position model=serial",
        "draw-wire",
        &[
            ("study.toml", "", STUDY),
            ("study.toml", "\"K\", \"L\"", "\"ball\""),
            ("study.toml", "joints = [[10,150,150]]", "positions_mm = [[300, 0]]"),
        ],
        "study @/study.toml",
    ),
    (
        "study-too-few-positions",
        CMM,
        &[(
            "t.csv",
            "",
            "pose,rho1_mm,rho2_mm,rho3_mm\n1,10,150,150\n2,20,150,150\n3,30,150,150\n4,10,150.001,150.001\n",
        )],
        "plan --robot @/robot.toml --candidates @/t.csv --target K --positions 4 --truth @/truth.toml --standard-uncertainty-um 20 --prior none",
    ),
    (
        "simulated-rows-lost",
        CMM,
        &[
            ("truth.toml", "decimals = 5", "decimals = 0\nnoise_um = 0.0"),
            ("truth.toml", "at_mm = [8.0, -40.0, 0.0]", "at_mm = [0, 0, 0]"),
            ("truth.toml", "xyz_mm = [312.7, 148.2, 95.4]", "xyz_mm = [0, 0, 0]"),
        ],
        "simulate @",
    ),
    ("truth-geometric-without-campaign", CMM, &[("truth.toml", "+", GEOMETRIC)], "simulate @"),
    ("truth-not-touching", "surfaces", &[("truth.toml", "wall_x = 620.0", "wall_x = 9620.0")], "simulate @"),
    (
        "study-set-empty",
        "dextar",
        &[(
            "study.toml",
            "",
            "robot = \"robot.toml\"\nframe = \"base\"\nseed = 1\nruns = 1\ndraws = 2\nnoise_um = [5.0]\n[parameters]\n[[workspace]]\npositions_mm = [[9000, 0]]\n[[set]]\nname = \"a\"\n[[set.poses]]\npositions_mm = [[9000, 0]]\n",
        )],
        "study @/study.toml",
    ),
    (
        "truth-point-out-of-reach",
        "dextar",
        &[("truth.toml", "at_mm = [50.8, 355.6, 0.0]", "at_mm = [9050.8, 355.6, 0.0]")],
        "simulate @",
    ),
];

#[test]
fn of_frames_and_joins() {
    hold(GATHERED);
}

#[test]
fn of_residuals_and_parameters() {
    hold(IDENTIFIED);
}

#[test]
fn of_tables_and_fits() {
    hold(TABLES);
}

#[test]
fn of_studies() {
    hold(SIMULATED);
}
