//! Files of three builds of one machine, as their makers export them: another program, other headings, units and tables.

use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A reading of a target: name of the target, pose, and position (mm) as written.
struct Reading<'a> {
    target: &'a str,
    pose: &'a str,
    xyz: [&'a str; 3],
}

/// The sample's export and log.
struct Measured {
    export: String,
    log: String,
}

impl Measured {
    fn read() -> Self {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/hexapod");
        let read = |file: &str| std::fs::read_to_string(folder.join(file)).unwrap();
        Self { export: read("exports/poses.txt"), log: read("encoders.csv") }
    }

    fn readings(&self) -> impl Iterator<Item = Reading<'_>> {
        self.export.lines().map(|line| {
            let [label, x, y, z] = line.split(',').collect::<Vec<_>>()[..] else { panic!("{line}") };
            let [_, pose, target] = label.rsplitn(3, '_').collect::<Vec<_>>()[..] else { panic!("{label}") };
            Reading { target, pose, xyz: [x, y, z] }
        })
    }

    /// Pose and lengths of the legs (mm), as written.
    fn legs(&self) -> impl Iterator<Item = (&str, Vec<&str>)> {
        self.log.lines().skip(1).map(|line| {
            let cells: Vec<&str> = line.split(',').collect();
            (cells[7], cells[1..7].to_vec())
        })
    }
}

/// Numbers with a decimal comma.
fn commas(numbers: &[&str]) -> String {
    numbers.iter().map(|number| number.replace('.', ",")).collect::<Vec<_>>().join(";")
}

/// Files of a build by their names.
pub type Build = Vec<(&'static str, Vec<u8>)>;

/// A German program: UTF-16, a title, decimal commas; the log has tabs and German headings.
fn german(measured: &Measured) -> Build {
    let mut points = "Messprotokoll\tHalle 4\r\n\r\nPunkt;X [mm];Y [mm];Z [mm]\r\n".to_owned();
    for Reading { target, pose, xyz } in measured.readings() {
        let _ = write!(points, "{target}_{pose}_1;{}\r\n", commas(&xyz));
    }
    let mut log =
        "Pose\tZyklus\tBein 1 [mm]\tBein 2 [mm]\tBein 3 [mm]\tBein 4 [mm]\tBein 5 [mm]\tBein 6 [mm]\n".to_owned();
    for (pose, legs) in measured.legs() {
        let _ = writeln!(log, "{pose}\t1\t{}", commas(&legs).replace(';', "\t"));
    }
    let utf_16 = points.encode_utf16().flat_map(u16::to_le_bytes);
    vec![("Messung.txt", [0xff, 0xfe].into_iter().chain(utf_16).collect()), ("Achsen.tsv", log.into_bytes())]
}

/// Metres in a row of units, target and pose in columns.
fn in_metres(measured: &Measured) -> Build {
    let mut points = "Target,Pose,X,Y,Z\n,,m,m,m\n".to_owned();
    for Reading { target, pose, xyz } in measured.readings() {
        let [x, y, z] = xyz.map(|mm| mm.parse::<f64>().unwrap() / 1000.0);
        let _ = writeln!(points, "{target},{pose},{x:.9},{y:.9},{z:.9}");
    }
    let mut log = "pose,leg1_mm,leg2_mm,leg3_mm,leg4_mm,leg5_mm,leg6_mm\n".to_owned();
    for (pose, legs) in measured.legs() {
        let _ = writeln!(log, "{pose},{}", legs.join(","));
    }
    vec![("tracker.csv", points.into_bytes()), ("legs.csv", log.into_bytes())]
}

/// One table of a spreadsheet: legs and all targets of a pose in a row.
fn one_table(measured: &Measured) -> Build {
    let legs: String = (1..=6).map(|leg| format!(";leg{leg} (mm)")).collect();
    let targets: String = (1..=3).flat_map(|k| ["X", "Y", "Z"].map(|axis| format!(";SMR_{k} {axis} (mm)"))).collect();
    let mut table = format!("Nr{legs}{targets}\n");
    for (pose, legs) in measured.legs() {
        let own: Vec<&str> = measured.readings().filter(|r| r.pose == pose).flat_map(|r| r.xyz).collect();
        let _ = writeln!(table, "{pose};{};{}", commas(&legs), commas(&own));
    }
    vec![("all.csv", table.into_bytes())]
}

/// Writes the three builds into folders, each with the robot; returns their files.
pub fn write(folder: &Path) -> Vec<Vec<PathBuf>> {
    let measured = Measured::read();
    let robot = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("samples/hexapod/robot.toml")).unwrap();
    let builds = [german(&measured), in_metres(&measured), one_table(&measured)];
    let written = builds.into_iter().enumerate().map(|(i, build)| {
        let own = folder.join(i.to_string());
        std::fs::create_dir(&own).unwrap();
        let files = build.into_iter().chain([("robot.toml", robot.clone())]);
        files
            .map(|(name, bytes)| {
                std::fs::write(own.join(name), bytes).unwrap();
                own.join(name)
            })
            .collect()
    });
    written.collect()
}
