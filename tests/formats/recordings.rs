//! Recordings of ROS 2 and arrays of NumPy and MATLAB as logs and exports of a campaign. All files
//! are synthetic, and written here by the specifications of their formats.

use crate::hostile::logs::with_log;
use crate::support::root;
use etalon::base::message::Problems;
use etalon::campaign::Campaign;
use etalon::formats::propose_file;
use etalon::stages::gather::{Gathered, gather};

/// A message in CDR, little endian: numbers at multiples of their size behind four bytes.
#[derive(Clone)]
pub(crate) struct Cdr(Vec<u8>);

impl Cdr {
    fn new(stamp: (i32, u32)) -> Self {
        Self(vec![0, 1, 0, 0]).put(stamp.0.to_le_bytes()).put(stamp.1.to_le_bytes()).text("base_link")
    }

    fn put<const N: usize>(mut self, bytes: [u8; N]) -> Self {
        self.0.resize((self.0.len() - 4).next_multiple_of(N) + 4, 0);
        self.0.extend(bytes);
        self
    }

    fn text(mut self, text: &str) -> Self {
        self = self.put((text.len() as u32 + 1).to_le_bytes());
        self.0.extend(text.bytes().chain([0]));
        self
    }

    fn numbers(self, values: &[f64]) -> Self {
        values.iter().fold(self, |message, value| message.put(value.to_le_bytes()))
    }

    pub(crate) fn joints(stamp: (i32, u32), names: &[&str], positions: &[f64]) -> Vec<u8> {
        let named = Self::new(stamp).put((names.len() as u32).to_le_bytes());
        let named = names.iter().fold(named, |message, name| message.text(name));
        let placed = named.put((positions.len() as u32).to_le_bytes()).numbers(positions);
        placed.put(0_u32.to_le_bytes()).put(0_u32.to_le_bytes()).0
    }

    fn pose(stamp: (i32, u32), values: [f64; 7]) -> Vec<u8> {
        Self::new(stamp).numbers(&values).0
    }

    pub(crate) fn point(stamp: (i32, u32), values: [f64; 3]) -> Vec<u8> {
        Self::new(stamp).numbers(&values).0
    }
}

/// A recording without chunks: topic, type and data of each message.
pub(super) fn recording(messages: &[(&str, &str, Vec<u8>)]) -> Vec<u8> {
    let text = |text: &str| [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat();
    let record = |kind: u8, body: &[u8]| [&[kind][..], &(body.len() as u64).to_le_bytes(), body].concat();
    let mut out = [&b"\x89MCAP0\r\n"[..], &record(1, &[text("ros2"), text("")].concat())].concat();
    for (id, (topic, message, data)) in (1_u16..).zip(messages) {
        let id = id.to_le_bytes();
        out.extend(record(3, &[&id[..], &text(message), &text("ros2msg"), &text("")].concat()));
        out.extend(record(4, &[&id[..], &id, &text(topic), &text("cdr"), &[0; 4]].concat()));
        out.extend(record(5, &[&id[..], &[0; 20], data].concat()));
    }
    out.extend([record(15, &[0; 4]), record(2, &[0; 20]), b"\x89MCAP0\r\n".to_vec()].concat());
    out
}

pub(super) const JOINTS: &str = "sensor_msgs/msg/JointState";

fn sample() -> Vec<u8> {
    recording(&[
        ("/joint_states", JOINTS, Cdr::joints((100, 250_000_000), &["elbow", "rail"], &[0.5, 1.25])),
        ("/joint_states", JOINTS, Cdr::joints((101, 0), &["rail", "elbow"], &[1.5, -0.5])),
        ("/joint_states", JOINTS, Cdr::joints((101, 1), &["gripper"], &[0.04])),
        ("/pose", "geometry_msgs/msg/PoseStamped", Cdr::pose((100, 0), [1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0])),
    ])
}

/// What a log of these bytes reads as, with these statements.
fn read(bytes: &[u8], stated: &str) -> Result<Gathered, Problems> {
    let scratch = with_log("", stated);
    std::fs::write(scratch.path().join("encoders.csv"), bytes).unwrap();
    gather(&Campaign::read(&scratch.path())?)
}

fn column(imported: &Gathered, name: &str) -> Vec<f64> {
    imported.logs[0].table().numbers(name).unwrap()
}

#[track_caller]
fn refused(bytes: &[u8], stated: &str, id: &str) {
    let said = read(bytes, stated).map(|_| ()).expect_err(stated);
    assert!(said.0.iter().any(|message| message.is(id, &[])), "{id}: {said}");
}

#[test]
fn joints_of_a_topic_are_found_by_name_in_their_units() {
    let stated = "topic = \"/joint_states\"\n\
         columns = { time_s = \"header.stamp\", q1_rad = \"position.elbow\", q2_m = \"position.rail\" }";
    let read_so = read(&sample(), stated).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(column(&read_so, "time_s"), [100.25, 101.0]);
    assert_eq!(column(&read_so, "q1_deg"), [0.5_f64.to_degrees(), (-0.5_f64).to_degrees()]);
    assert_eq!(column(&read_so, "q2_mm"), [1250.0, 1500.0]);
    // the message of the gripper is left out, and listed
    let source = read_so.document.sources.last().unwrap();
    assert_eq!((source.rows_read, source.refused.len()), (3, 1), "{source:?}");
}

#[test]
fn slips_in_the_statement_of_a_topic_are_refused() {
    let bytes = sample();
    let topic = "topic = \"/joint_states\"\n";
    refused(&bytes, "columns = { q1_rad = \"position.elbow\" }", "topic-not-stated");
    refused(&bytes, "topic = \"/joints\"\ncolumns = { q1_rad = \"position.elbow\" }", "topic-missing");
    refused(&bytes, &format!("{topic}columns = {{ q1_rad = \"position.elbo\" }}"), "column-unknown");
    refused(&bytes, &format!("{topic}columns = {{ q1_deg = \"position.elbow\" }}"), "column-unit-differs");
    refused(&bytes, &format!("{topic}columns = {{ q2_mm = \"position.rail\" }}"), "column-unit-differs");
    refused(&bytes, &format!("{topic}columns = {{ time_ns = \"header.stamp\" }}"), "column-unit-differs");
    refused(b"t,a\n1,2\n", &format!("{topic}columns = {{ q1_rad = \"a\" }}"), "recording-missing");
    refused(b"SQLite format 3\0 and more", &format!("{topic}columns = {{ q1_rad = \"a\" }}"), "database-unreadable");
    let empty = recording(&[("/joint_states", JOINTS, Cdr::joints((1, 0), &["elbow"], &[]))]);
    refused(&empty, &format!("{topic}columns = {{ q1_rad = \"position.elbow\" }}"), "topic-without-positions");
}

#[test]
fn a_recording_without_joints_points_or_poses_is_named() {
    let scratch = with_log("", "");
    let file = scratch.path().join("run.mcap");
    std::fs::write(&file, recording(&[("/rosout", "rcl_interfaces/msg/Log", vec![0; 8])])).unwrap();
    let said = propose_file(&file).unwrap_err();
    assert!(said.0[0].is("recording-without-known-topics", &[]), "{said}");
}

#[test]
fn the_proposal_for_a_recording_reads_its_joints_and_poses() {
    let scratch = with_log("", "");
    let file = scratch.path().join("run.mcap");
    std::fs::write(&file, sample()).unwrap();
    let document = propose_file(&file).unwrap();
    assert_eq!((document.kind.as_str(), document.rows), ("log", 3), "{document:?}");
    let name = file.display().to_string();
    let lines: toml::Table = toml::from_str(&document.toml).unwrap_or_else(|e| panic!("{e}: {}", document.toml));
    assert_eq!(lines["log"]["topic"].as_str(), Some("/joint_states"));
    assert_eq!(lines["log"]["columns"]["q1_rad"].as_str(), Some("position.elbow"));
    let log = document.toml.replace(&format!("file = {name:?}\n"), "");
    let log = log.split("[log]").nth(1).unwrap().split("[[export]]").next().unwrap();
    let all = read(&sample(), log).unwrap_err();
    // joints of two nodes: one of them has to be chosen
    assert!(all.0.iter().all(|message| message.is("not-a-number", &[]) || message.place.is_some()), "{all}");
    let export = &lines["export"][0];
    assert_eq!(export["unit"].as_str(), Some("m"));
    let stated: etalon::formats::Format = export["format"].clone().try_into().unwrap();
    let points = etalon::formats::read_file(&file, None, &stated, etalon::formats::dialect::Unit::Metre).unwrap();
    assert_eq!((points.len(), points[0].xyz_mm, points[0].time_s), (1, [1000.0, 2000.0, 3000.0], Some(100.0)));
    let inch = etalon::formats::read_file(&file, None, &stated, etalon::formats::dialect::Unit::Millimetre);
    assert!(inch.unwrap_err().0.iter().any(|message| message.is("unit-differs", &[])));
}

/// An array by NEP 1.
pub fn npy(kind: &str, shape: &str, data: &[u8]) -> Vec<u8> {
    let mut head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}");
    head += &" ".repeat(63 - (10 + head.len()) % 64);
    head.push('\n');
    [b"\x93NUMPY\x01\x00", &(head.len() as u16).to_le_bytes()[..], head.as_bytes(), data].concat()
}

/// A variable of MATLAB in doubles, by the description of level 5.
pub fn variable(name: &str, rows: u32, columns: u32, values: &[f64]) -> Vec<u8> {
    let element = |kind: u32, data: &[u8]| {
        let mut out = [&kind.to_le_bytes()[..], &(data.len() as u32).to_le_bytes(), data].concat();
        out.resize(out.len().next_multiple_of(8), 0);
        out
    };
    let inside = [
        element(6, &[6_u32.to_le_bytes(), [0; 4]].concat()),
        element(5, &[rows.to_le_bytes(), columns.to_le_bytes()].concat()),
        element(1, name.as_bytes()),
        element(9, &values.iter().flat_map(|v| v.to_le_bytes()).collect::<Vec<u8>>()),
    ];
    element(14, &inside.concat())
}

pub fn mat(variables: &[Vec<u8>]) -> Vec<u8> {
    let mut out = b"MATLAB 5.0 MAT-file, synthetic".to_vec();
    out.resize(124, b' ');
    [&out[..], b"\x00\x01IM", &variables.concat()].concat()
}

#[test]
fn arrays_are_logs_and_slips_are_refused() {
    let six: Vec<u8> = [0.1_f64, 0.2, 0.3, 0.4, 0.5, 0.6].iter().flat_map(|v| v.to_le_bytes()).collect();
    let bytes = npy("<f8", "(3, 2)", &six);
    let numpy = "format = \"numpy\"\n";
    let read_so = read(&bytes, &format!("{numpy}columns = {{ q1_mm = \"[:,0]\", q2_m = \"[:,1]\" }}"));
    let read_so = read_so.unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(
        (column(&read_so, "q1_mm"), column(&read_so, "q2_mm")),
        (vec![0.1, 0.3, 0.5], vec![200.0, 400.0, 600.0])
    );
    refused(&bytes, &format!("{numpy}columns = {{ q1_mm = \"[:,2]\" }}"), "array-part-unknown");
    refused(&bytes, &format!("{numpy}columns = {{ q1_mm = \"q[:,0]\" }}"), "array-missing");
    refused(&bytes, &format!("{numpy}delimiter = \";\"\ncolumns = {{ q1_mm = \"[:,0]\" }}"), "log-key-inapplicable");
    refused(&bytes, &format!("{numpy}columns = {{ q1_mm = 1 }}"), "log-columns-missing");
    refused(&bytes, "columns = { q1_mm = \"[:,0]\" }", "file-not-text");
    refused(b"t,a\n1,2\n", &format!("{numpy}columns = {{ q1_mm = \"a\" }}"), "arrays-unreadable");

    let bytes = mat(&[variable("t", 3, 1, &[1.0, 2.0, 3.0]), variable("q", 2, 3, &[4.0, 5.0, 6.0, 7.0, 8.0, 9.0])]);
    let matlab = "format = \"matlab\"\n";
    let read_so = read(&bytes, &format!("{matlab}columns = {{ time_s = \"t\", q1_mm = \"q(2,:)\" }}"));
    assert_eq!(column(&read_so.unwrap_or_else(|e| panic!("{e}")), "q1_mm"), [5.0, 7.0, 9.0]);
    refused(&bytes, &format!("{matlab}columns = {{ time_s = \"t\", q1_mm = \"q(:,1)\" }}"), "array-lengths-differ");
    refused(b"MATLAB 7.3 MAT-file, HDF5", &format!("{matlab}columns = {{ q1_mm = \"q\" }}"), "file-not-text");

    let scratch = with_log("", "");
    let file = scratch.path().join("run.mat");
    std::fs::write(&file, &bytes).unwrap();
    let document = propose_file(&file).unwrap();
    assert_eq!((document.kind.as_str(), document.format.as_deref(), document.rows), ("log", Some("matlab"), 3));
    let columns = "columns = { time_UNIT = \"t\", q1_UNIT = \"q(1,:)\", q2_UNIT = \"q(2,:)\" }";
    assert!(document.toml.contains(columns), "{}", document.toml);
}

#[test]
fn a_kuka_trace_is_read_with_the_file_of_its_numbers() {
    // two axes, measured and commanded, alternate in the file of numbers
    let mut header = "DIAEXTENDED  {@:ENGLISH\n#BEGINGLOBALHEADER\n112,Low -> High\n#ENDGLOBALHEADER\n\
                      #BEGINCHANNELHEADER\n200,Zeit\n202,s\n210,IMPLIZIT\n220,3\n240,0\n241,0.5\n#ENDCHANNELHEADER\n"
        .to_owned();
    for (name, place) in ["AxisPos_CmdIpo1", "AxisPos_CmdIpo2", "AxisPos_Act1", "AxisPos_Act2"].iter().zip(1..) {
        header += &format!(
            "#BEGINCHANNELHEADER\n200,{name}\n202,\u{b0}\n210,EXPLIZIT\n211,log_KRCIpo.r64\n213,BLOCK\n214,REAL64\n\
             220,3\n221,{place}\n#ENDCHANNELHEADER\n"
        );
    }
    let values: Vec<f64> = (0..12).map(f64::from).collect();
    let numbers: Vec<u8> = values.iter().flat_map(|v| v.to_le_bytes()).collect();
    let stated = "format = \"kuka_trace\"\ncolumns = { time_s = \"Zeit\", q1_deg = \"AxisPos_Act1\" }";
    let with_numbers = |stated: &str| {
        let scratch = with_log(&header, stated);
        std::fs::write(scratch.path().join("LOG_KRCIPO.R64"), &numbers).unwrap();
        let campaign = Campaign::read(&scratch.path()).map_err(|e| e.to_string());
        campaign.and_then(|campaign| gather(&campaign).map_err(|e| e.to_string()))
    };
    let gathered = with_numbers(stated).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((column(&gathered, "time_s"), column(&gathered, "q1_deg")), (vec![0.0, 0.5, 1.0], vec![2.0, 6.0, 10.0]));
    // both files are inputs with their hashes
    let inputs: Vec<(&str, usize)> = gathered.document.sources.iter().map(|s| (s.file.as_str(), s.bytes)).collect();
    assert!(inputs.ends_with(&[("encoders.csv", header.len()), ("LOG_KRCIPO.R64", 96)]), "{inputs:?}");
    for (wrong, id) in [
        (stated.replace("q1_deg", "q1_rad"), "column-unit-differs"),
        (stated.replace("AxisPos_Act1", "AxisPos_Act9"), "array-missing"),
        (stated.replace("AxisPos_Act1", "Istposition"), "array-missing"),
    ] {
        let said = with_numbers(&wrong).map(|_| ()).unwrap_err();
        assert!(said.contains(&format!("[{id}]")), "{said}");
    }
    refused(header.as_bytes(), stated, "numbers-file-missing");

    let scratch = with_log("", "");
    let file = scratch.path().join("log_KRCIpo.dat");
    std::fs::write(&file, &header).unwrap();
    std::fs::write(scratch.path().join("log_KRCIpo.r64"), &numbers).unwrap();
    let document = propose_file(&file).unwrap();
    assert_eq!((document.kind.as_str(), document.format.as_deref(), document.rows), ("log", Some("kuka_trace"), 3));
    let lines: toml::Table = toml::from_str(&document.toml).unwrap();
    let columns = &lines["log"]["columns"];
    assert_eq!(
        (columns["time_s"].as_str(), columns["q1_deg"].as_str(), columns["q2_deg"].as_str()),
        (Some("Zeit"), Some("AxisPos_Act1"), Some("AxisPos_Act2"))
    );
}

#[test]
fn real_variables_of_matlab_are_read() {
    let Some(folder) = crate::reference_data("exports/leica_motoman_mat") else { return };
    let document = propose_file(&folder.join("leica_rep_wall1_dataset.mat")).unwrap();
    assert_eq!((document.format.as_deref(), document.kind.as_str()), (Some("matlab"), "log"), "{document:?}");
    println!("{}", document.toml);
}

/// A database with the tables of rosbag2, written by SQLite 3.40 in pages of 512 bytes: messages are longer than a page.
#[test]
fn a_database_of_rosbag2_is_read_like_a_recording() {
    let path = root().join("tests/formats/bags/rosbag2.db3");
    let bytes = std::fs::read(&path).unwrap();
    let stated = "topic = \"/joint_states\"\ncolumns = { time_s = \"header.stamp\", \
                  a_rad = \"position.shoulder_with_a_long_name_0\", b_rad = \"position.shoulder_with_a_long_name_11\" }";
    let read_so = read(&bytes, stated).unwrap_or_else(|e| panic!("{e}"));
    let times: Vec<f64> = (0..40).map(|k| 100.0 + f64::from(k / 10) + 0.1 * f64::from(k % 10)).collect();
    let near = |found: &[f64], right: &[f64]| {
        found.len() == right.len() && found.iter().zip(right).all(|(a, b)| (a - b).abs() < 1e-9)
    };
    assert!(near(&column(&read_so, "time_s"), &times));
    let joint = |of: f64| (0..40).map(|k| (0.01 * f64::from(k) + of).to_degrees()).collect::<Vec<f64>>();
    assert!(near(&column(&read_so, "a_deg"), &joint(0.0)) && near(&column(&read_so, "b_deg"), &joint(11.0)));
    let document = propose_file(&path).unwrap();
    assert_eq!((document.kind.as_str(), document.format.as_deref(), document.rows), ("log", Some("db3"), 40));
    assert!(document.toml.contains("topic = \"/tracker/pose\""), "{}", document.toml);
    refused(&bytes, &stated.replace("/joint_states", "/joints"), "topic-missing");

    // a database that was cut, one with a write-ahead log, and another one
    refused(&bytes[..bytes.len() / 2], stated, "database-unreadable");
    let mut log = bytes.clone();
    log[18..20].fill(2);
    refused(&log, stated, "database-unreadable");
    let mut other = bytes.clone();
    for at in (0..bytes.len() - 8).filter(|at| &bytes[*at..at + 8] == b"messages") {
        other[at..at + 8].copy_from_slice(b"passages");
    }
    let said = read(&other, stated).map(|_| ()).unwrap_err();
    assert!(said.0.iter().any(|m| m.id == "database-unreadable"), "{said}");
    // damage is an error and no panic
    for at in (100..bytes.len()).step_by(37) {
        let mut damaged = bytes.clone();
        damaged[at] ^= 0x5a;
        let _ = read_bytes(&damaged);
    }
}

fn read_bytes(bytes: &[u8]) -> Result<(), Problems> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run.db3");
    std::fs::write(&path, bytes).unwrap();
    propose_file(&path).map(|_| ())
}

/// An array is the sheet of an export; arrays of the same length beside it are further columns.
#[test]
fn an_array_is_an_export() {
    // column by column
    let points = [1.0, 4.0, 7.0, 8.0, 2.0, 5.0, 9.0, 9.5, 3.0, 6.0, 1.5, 2.5];
    let times = variable("t", 4, 1, &[10.0, 20.0, 30.0, 40.0]);
    let bytes = mat(&[times, variable("P", 4, 3, &points), variable("k", 3, 1, &[1.0; 3])]);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("points.mat");
    std::fs::write(&path, bytes).unwrap();
    let document = propose_file(&path).unwrap();
    assert_eq!((document.kind.as_str(), document.doubts.len()), ("export", 1), "{}", document.toml);
    // neither the name nor the step of 10 states the unit of the times
    assert!(document.questions.iter().any(|asked| asked.phrase().is_some_and(|phrase| phrase.id == "ask-time-unit")));
    let answered = document.toml.replace("time_UNIT", "time_s");
    let lines: toml::Table = toml::from_str(&answered).unwrap_or_else(|e| panic!("{e}: {answered}"));
    let stated: etalon::formats::Format = lines["export"][0]["format"].clone().try_into().unwrap();
    let read = |format: &etalon::formats::Format| {
        etalon::formats::read_file(&path, None, format, etalon::formats::dialect::Unit::Metre)
    };
    let read_so = read(&stated).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((read_so[0].xyz_mm, read_so[1].xyz_mm), ([1000.0, 2000.0, 3000.0], [4000.0, 5000.0, 6000.0]));
    assert_eq!(read_so[1].time_s, Some(20.0));
    let other: etalon::formats::Format =
        toml::from_str::<toml::Table>("f = { sheet = \"Q\", header = 1, columns = { x = 1, y = 2 } }").unwrap()["f"]
            .clone()
            .try_into()
            .unwrap();
    assert!(read(&other).unwrap_err().0[0].is("array-missing", &[("column", &"Q")]));
}
