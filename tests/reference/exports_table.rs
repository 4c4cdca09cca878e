//! How each file of the reference exports and robots is read, or why it is not.

/// What becomes of a file.
pub enum As {
    /// `format` and `unit` as the campaign states them, rows, and how many of them were not measured.
    Points(&'static str, &'static str, usize, usize),
    /// Joint values without a header: delimiter, number of the first joint's column, unit, rows.
    Log(&'static str, usize, &'static str, usize),
    /// Read as this format and unit it is an error, in these words.
    Refused(&'static str, &'static str, &'static str),
    /// No measurement: `etalon formats` says so, in these words.
    Nothing(&'static str),
    /// Another test of this folder reads it.
    Elsewhere,
}

use As::{Elsewhere, Log, Nothing, Points, Refused};

const SA: &str = "\"spatialanalyzer\"";
const XYZ: &str = "\"xyz\"";
const XYZIJK: &str = "\"xyzijk\"";
const PLATE: &str = "\"sdss-plate\"";
const LEICA: &str = "\"leica-emscon\"";
const LIST: &str = "\"tracker-semicolon\"";
/// SpatialAnalyzer with a time stamp behind the coordinates, and no comment that names the columns.
const SA_TIMED: &str =
    "{ delimiter = \",\", comment = \"//\", columns = [\"label\", \"label\", \"label\", \"x\", \"y\", \"z\", \"-\"] }";
/// Three reflectors a row, of which a dialect reads one; zeros and joints behind them.
const FIRST_OF_21: &str = "{ delimiter = \"blank\", columns = [\"x\", \"y\", \"z\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \
     \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\", \"-\"] }";

/// Pattern of files, what becomes of them, and why: counts and units come from their README, or from `wc -l`.
#[rustfmt::skip]
pub const TABLE: &[(&str, As, &str)] = &[
    // spatialanalyzer: comments state version, frame and unit
    ("exports/spatialanalyzer/SM6_nominal.txt", Points(SA, "mm", 92, 0), "92 targets of SM6"),
    ("exports/spatialanalyzer/SM6_SM6_SCOD.txt", Points(SA, "mm", 232, 0), "five groups, rewritten by nova without blanks"),
    ("exports/spatialanalyzer/SM6_reference_ccl.txt", Points(SA, "mm", 32, 0), "two groups of 16"),
    ("exports/spatialanalyzer/SM6_reference_ccl_IO.txt", Points(SA, "mm", 16, 0), "16 rows under the header"),
    ("exports/spatialanalyzer/SM6_nominal_ccl.txt", Points(SA, "mm", 16, 0), "16 rows under the header"),
    ("exports/spatialanalyzer/SM7_SM7_SCOD.txt", Points(SA, "mm", 48, 0), "three groups of 16"),
    ("exports/spatialanalyzer/SM7_nominal_ccl.txt", Points(SA, "mm", 16, 0), "16 rows under the header"),
    ("exports/spatialanalyzer/SM7_reference_ccl.txt", Points(SA, "mm", 16, 0), "16 rows under the header"),
    ("exports/spatialanalyzer/TFC1*_ccl.txt", Points(SA, "mm", 8, 0), "8 rows under the header"),
    ("exports/spatialanalyzer/inspec_converted_for_SA_group_point_xyz.csv", Points(SA, "mm", 19_474, 0), "Group,Point,X,Y,Z, no header"),
    // Leica through emScon
    ("exports/leica_tracker_cesapi/measurements_2025-09-15.csv", Points(LEICA, "mm", 11, 0), "types 0 and 7 mixed"),
    ("exports/leica_tracker_cesapi/measurements_2025-09-16.csv", Points(LEICA, "mm", 29, 0), "all of type 7"),
    ("exports/leica_tracker_cesapi/measurements_2025-09-12.csv", Refused(LEICA, "mm", "column-unknown"), "spherical, and nothing in the file says so"),
    ("exports/leica_tracker_cesapi/measurements_2025-09-15calc.csv", Points(LEICA, "mm", 11, 0), "after Excel: digits cut, results of formulas in columns without a name"),
    // Leica and Motoman: binary tables, whose columns only a text beside them explains
    ("exports/leica_motoman_mat/leica_*_dataset.mat", Refused(XYZ, "m", "file-not-text"), "binary"),
    ("exports/leica_motoman_mat/leica_dataset_description.txt", Nothing("no reading"), "the meaning of the columns, in words"),
    ("exports/leica_motoman_mat/mrc_template_example.csv", Refused(LIST, "mm", "row-field-count"), "a template of a toolbox: random numbers in ragged rows"),
    // laser tracker and KUKA (RABKKK)
    ("exports/laser_tracker_kuka_rabkkk/ToolOrientDef.xyz", Points(LIST, "mm", 3, 0), "P5;..;..;..;;;; decimal point"),
    ("exports/laser_tracker_kuka_rabkkk/ToolTransPose.xyz", Points(LIST, "mm", 16, 0), "the same"),
    ("exports/laser_tracker_kuka_rabkkk/WorldDef.xyz", Points(LIST, "mm", 4, 0), "the same"),
    ("exports/laser_tracker_kuka_rabkkk/N1N2N3Jval.csv", Points(FIRST_OF_21, "mm", 36, 0), "36 poses x 21 columns, blanks in spite of the name"),
    ("exports/laser_tracker_kuka_rabkkk/TransToolPosit.csv", Points(XYZ, "mm", 2, 0), "two places"),
    ("exports/laser_tracker_kuka_rabkkk/Trans*0.csv", Refused(XYZ, "mm", "row-field-count"), "3 x 4 matrices, no points"),
    ("exports/laser_tracker_kuka_rabkkk/RobPoseatRef.csv", Refused(XYZIJK, "mm", "direction-not-unit"), "a pose with three angles, which are no direction"),
    // FARO tracker and ABB IRB 120: rows joined by position across files
    ("exports/faro_tracker_abb_irb120/measured_SMR_*.txt", Points(XYZ, "mm", 1000, 0), "1000 configurations"),
    ("exports/faro_tracker_abb_irb120/measured_base_1.txt", Points(XYZ, "mm", 1000, 0), "1000 configurations"),
    ("exports/faro_tracker_abb_irb120/measured_base_2.txt", Points(XYZ, "mm", 1000, 0), "0 0 0 in rows 251, 708: refused by the campaign, reference/irb120.rs"),
    ("exports/faro_tracker_abb_irb120/measured_base_3.txt", Points(XYZ, "mm", 1000, 0), "0 0 0 in eleven rows, another reflector in five"),
    ("exports/faro_tracker_abb_irb120/processed_SMR_1.txt", Points(XYZ, "mm", 982, 0), "18 rows removed by the authors"),
    ("exports/faro_tracker_abb_irb120/processed_SMR_2.txt", Points(XYZ, "mm", 982, 0), "the same"),
    ("exports/faro_tracker_abb_irb120/processed_SMR_3.txt", Points(XYZ, "mm", 982, 0), "the same"),
    ("exports/faro_tracker_abb_irb120/processed_SMR_*_wrt_base.txt", Points(XYZ, "m", 982, 0), "read, and numerically broken: the robot's README"),
    ("exports/faro_tracker_abb_irb120/basic_position_SMR_base.txt", Points(XYZ, "mm", 3, 0), "three nests"),
    ("exports/faro_tracker_abb_irb120/basic_position_SMR_1.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("exports/faro_tracker_abb_irb120/basic_position_SMR_2.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("exports/faro_tracker_abb_irb120/basic_position_SMR_3.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("exports/faro_tracker_abb_irb120/basic_result_SMR_*.txt", Refused(XYZ, "mm", "row-field-count"), "parameters, one a line"),
    ("exports/faro_tracker_abb_irb120/measured_joints.txt", Log("blank", 1, "deg", 1000), "read back"),
    ("exports/faro_tracker_abb_irb120/commanded_joints.txt", Log("blank", 1, "deg", 1000), "commanded"),
    ("exports/faro_tracker_abb_irb120/processed_joints.txt", Log("blank", 1, "deg", 982), "18 rows removed"),
    ("exports/faro_tracker_abb_irb120/basic_joints_SMR_tool.txt", Log("blank", 1, "deg", 8), "eight poses"),
    ("exports/faro_tracker_abb_irb120/FARO_TEST_OUT.txt", Nothing("[numbers-in-brackets]"), "a console of Matlab"),
    // plates, points with normals
    ("exports/xyzijk_cmm_plain/C3-76-018726-1-A21-00*.xyz", Points(XYZIJK, "mm", 121, 0), "121 points each"),
    ("exports/xyzijk_cmm_plain/C3-69-12345-6-P21-*.xyz", Points(XYZIJK, "mm", 121, 0), "the same"),
    ("exports/xyzijk_cmm_plain/fixture.xyz", Points(XYZIJK, "mm", 121, 0), "the surface to subtract"),
    // SDSS plates in columns of fixed width, some without a date
    ("exports/cmm_fixed_width_sdss/D1396A1", Points(PLATE, "mm", 637, 0), "637 holes"),
    ("exports/cmm_fixed_width_sdss/D1413_1", Points(PLATE, "mm", 37, 0), "37 holes"),
    ("exports/cmm_fixed_width_sdss/D1597A*", Points(PLATE, "mm", 650, 0), "650 holes, measured four times"),
    ("exports/cmm_fixed_width_sdss/D2130A1", Points(PLATE, "mm", 635, 0), "635 holes"),
    ("exports/cmm_fixed_width_sdss/D2130_1", Points(PLATE, "mm", 37, 0), "37 holes"),
    ("exports/cmm_fixed_width_sdss/D813*", Points(PLATE, "mm", 82, 0), "82 holes"),
    ("exports/cmm_fixed_width_sdss/D8300_1", Points(PLATE, "mm", 53, 0), "53 holes"),
    ("exports/cmm_fixed_width_sdss/fit_*.txt", Refused(PLATE, "mm", "header-words-missing"), "results of a fit, see exports.rs"),
    // roughness, no coordinates
    ("exports/mitutoyo_sj410_decimal_comma/*.TXT", Nothing("error[file-without-points] kind=roughness"), "kept for its decimal commas"),
    // certificates: what others measured of an instrument, no points
    ("exports/dcc/lutaml_2023-03-31-PLATINUM-examples-1.xml", Nothing("error[file-without-points] kind=xml"), "examples of D-SI"),
    ("exports/dcc/dfm_*.xml", Nothing("error[file-without-points] kind=certificate"), "certificates of DFM"),
    ("exports/dcc/lutaml_e*.xml", Nothing("error[file-without-points] kind=certificate"), "example"),
    ("exports/dcc/lutaml_s*.xml", Nothing("error[file-without-points] kind=certificate"), "silicon sphere"),
    ("exports/dcc/lutaml_v*.xml", Nothing("error[file-without-points] kind=certificate"), "valid ones"),
    ("exports/dcc/ptb_*.xml", Nothing("error[file-without-points] kind=certificate"), "good practice of PTB"),
    ("exports/dcc/csir_*.xml", Nothing("error[file-without-points] kind=certificate"), "CSIR-NPL"),
    // dedicated readers: one row a folder
    ("exports/qif/*", Elsewhere, "reference/qif.rs"),
    ("exports/calypso/*", Elsewhere, "reference/readers.rs"),
    ("exports/dmis/*", Elsewhere, "reference/readers.rs"),
    ("exports/galil/*", Elsewhere, "reference/logs.rs"),
    ("exports/geopak_mitutoyo/*", Elsewhere, "reference/readers.rs"),
    ("exports/kuka_rsi/*", Elsewhere, "reference/logs.rs"),
    ("exports/microvu_inspec/*", Elsewhere, "reference/readers.rs"),
    ("exports/polyworks/*", Elsewhere, "reference/readers.rs"),
    ("exports/ros_csv/*", Elsewhere, "reference/logs.rs"),
    ("exports/twincat_scope/*", Elsewhere, "reference/logs.rs"),
    ("exports/ur_rtde/*", Elsewhere, "reference/logs.rs"),
    ("exports/vda_fs/*", Elsewhere, "reference/readers.rs"),
    // IRB 120 again, as the robot's data set
    ("robots/hilti_column/trailblazer.urdf", Nothing("error[file-without-points] kind=xml"), "a model, no measurement"),
    ("robots/hilti_column/waypoints.csv", Points("{ delimiter = \",\", header = 1, columns = { label = \"waypoint\", x = \"prism_x_m\", y = \"prism_y_m\", z = \"prism_z_m\" } }", "m", 444, 0), "444 waypoints of a prism"),
    ("robots/irb120_faro_ets/basic/commanded_joints_full.txt", Log("blank", 1, "deg", 1000), "1000 x 6"),
    ("robots/irb120_faro_ets/basic/generated_joints.txt", Log("blank", 1, "deg", 277), "277 rows"),
    ("robots/irb120_faro_ets/basic/joints_SMR_tool.txt", Log("blank", 1, "deg", 8), "eight poses"),
    ("robots/irb120_faro_ets/basic/position_SMR_base.txt", Points(XYZ, "mm", 3, 0), "three nests"),
    ("robots/irb120_faro_ets/basic/position_SMR_1.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("robots/irb120_faro_ets/basic/position_SMR_2.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("robots/irb120_faro_ets/basic/position_SMR_3.txt", Points(XYZ, "mm", 8, 0), "eight poses"),
    ("robots/irb120_faro_ets/full_filtered/processed_SMR_*.txt", Points(XYZ, "mm", 982, 0), "982 rows kept"),
    ("robots/irb120_faro_ets/full_filtered/processed_joints.txt", Log("blank", 1, "deg", 982), "982 rows kept"),
    ("robots/irb120_faro_ets/full_raw/measured_SMR_*.txt", Points(XYZ, "mm", 1000, 0), "1000 x 3"),
    ("robots/irb120_faro_ets/full_raw/measured_base_*.txt", Points(XYZ, "mm", 1000, 0), "1000 x 3"),
    ("robots/irb120_faro_ets/full_raw/measured_joints.txt", Log("blank", 1, "deg", 1000), "1000 x 6"),
    ("robots/irb120_faro_ets/irb120_model.urdf", Nothing("error[file-without-points] kind=xml"), "a model, no measurement"),
    // KIT: reflectors of a standing and a moving robot
    ("robots/kit_iso9283_tracker/tracker/pose*.txt", Points(SA, "mm", 30, 0), "3 reflectors x 10 repeats"),
    ("robots/kit_iso9283_tracker/tracker/anfahrt_pose1.txt", Points(SA, "mm", 30, 0), "3 reflectors x 10 repeats"),
    ("robots/kit_iso9283_tracker/tracker/Trajektoriezw1u2_vel100.txt", Points(SA_TIMED, "mm", 13_545, 0), "13545 samples"),
    ("robots/kit_iso9283_tracker/tracker/Trajektoriezw1u2_vel50.txt", Points(SA_TIMED, "mm", 20_445, 0), "20445 samples"),
    ("robots/kit_iso9283_tracker/tracker/Pose1Stationaer_fest.txt", Points(SA_TIMED, "mm", 3999, 0), "2.4k to 4k samples"),
    ("robots/kit_iso9283_tracker/tracker/Pose1Stationaer_freedrive.txt", Points(SA_TIMED, "mm", 2411, 0), "2.4k to 4k samples"),
    ("robots/kit_iso9283_tracker/tracker/PoseAussenStationaer_fest.txt", Points(SA_TIMED, "mm", 3209, 0), "2.4k to 4k samples"),
    ("robots/kit_iso9283_tracker/tracker/PoseAussenStationaer_freedrive.txt", Points(SA_TIMED, "mm", 3515, 0), "2.4k to 4k samples"),
    ("robots/kit_iso9283_tracker/results/*.txt", Refused(XYZ, "mm", "row-field-count"), "printed results, see iso9283.rs"),
    // QKM: points of PolyWorks as text, joints with blanks and tabs mixed
    ("robots/qkm_polyworks/2020-01-19__re_ref.txt", Points("\"polyworks\"", "mm", 3, 0), "3 reference reflectors"),
    ("robots/qkm_polyworks/2020-01-19__re_smr.txt", Points("\"polyworks\"", "mm", 3, 0), "3 tool reflectors"),
    ("robots/qkm_polyworks/2020-01-19__re_poses.txt", Points("\"polyworks\"", "mm", 50, 0), "50 points"),
    ("robots/qkm_polyworks/2020-01-19__re_test.txt", Points("\"polyworks\"", "mm", 9, 0), "verification"),
    ("robots/qkm_polyworks/2020-01-19__test_points.txt", Log(",", 1, "deg", 9), "six joints and the reflector"),
    ("robots/qkm_polyworks/2020-01-19__angle_info.txt", Refused(XYZ, "mm", "row-field-count"), "a program of the controller"),
    ("robots/qkm_polyworks/data_points_cali__c_angles.txt", Log("blank", 1, "deg", 46), "46 x 7, one line with a blank for a tab"),
    ("robots/qkm_polyworks/data_points_cali__c_poses.txt", Points("\"polyworks\"", "mm", 46, 0), "46 x 3"),
    ("robots/qkm_polyworks/data_points_cali__re_poses.txt", Points("\"polyworks\"", "mm", 50, 0), "50 points"),
    ("robots/qkm_polyworks/data_points_cali__re_ref.txt", Points("\"polyworks\"", "mm", 3, 0), "3 reference reflectors"),
    ("robots/qkm_polyworks/data_points_cali__re_smr.txt", Points("\"polyworks\"", "mm", 3, 0), "3 tool reflectors"),
    ("robots/qkm_polyworks/data_points_cali__re_test.txt", Points("\"polyworks\"", "mm", 9, 0), "verification"),
    ("robots/qkm_polyworks/data_points_cali__test_points.txt", Log(",", 1, "deg", 9), "six joints and the reflector"),
    ("robots/qkm_polyworks/data_points_cali__test_poses.txt", Points("{ delimiter = \",\", columns = [\"x\", \"y\", \"z\"] }", "mm", 9, 0), "commas here, blanks in the files beside it"),
    ("robots/qkm_polyworks/data_pose_cali__AnglesInDeg.txt", Log("blank", 1, "deg", 10), "10 poses"),
    ("robots/qkm_polyworks/data_pose_cali__POSES.txt", Points("\"polyworks\"", "mm", 30, 0), "10 poses x 3"),
    ("robots/qkm_polyworks/data_pose_cali__init_SMRs.txt", Points("\"polyworks\"", "mm", 3, 0), "3 reflectors"),
    ("robots/qkm_polyworks/data_pose_cali__init_ang.txt", Log("blank", 1, "deg", 1), "one pose, no line end"),
    ("robots/qkm_polyworks/data_pose_cali__ref.txt", Points("\"polyworks\"", "mm", 3, 0), "3 reflectors"),
    ("robots/qkm_polyworks/data_pose_cali__test_angles.txt", Log("blank", 1, "rad", 10), "10 poses in rad: the largest is 2.1"),
    ("robots/qkm_polyworks/polyworks_inspector_project_description.txt", Elsewhere, "reference/readers.rs"),
    ("robots/qkm_polyworks/workspace1.pwk", Nothing("error[file-without-points] kind=xml"), "a workspace"),
    ("robots/qkm_polyworks/polyworks_objectmodel.xml.gz", Nothing("error[file-not-text] kind=gzip"), "an object model"),
    // two-axis positioner: poses of a camera in YAML
    ("robots/rct_two_axis_positioner/initial_guess.launch.xml", Nothing("error[file-without-points] kind=xml"), "initial transforms"),
    ("robots/rct_two_axis_positioner/positioner_kinematic_measurements.yaml", Nothing("error[file-without-points] kind=yaml"), "poses as YAML, one number a line"),
];
