//! Drawn tables, archives, templates and values of the environment: each command that reads one ends
//! within [`LIMIT`], with an exit code, and without a panic. `ETALON_DRAWS` states how many are drawn (10,000 without it),
//! `ETALON_DRAWS_SECONDS` for how long at most, `ETALON_ATTACK_SEED` the seed and `ETALON_ATTACK_ONLY` one draw by its number.

use crate::formats::recordings::Cdr;
use crate::support::scratch::{Scratch, copy_sample};
use crate::support::{program, run_for};
use etalon::base::noise::Noise;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use std::fmt::Write as _;
use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::{Duration, Instant};
use zip::write::SimpleFileOptions;

/// Longest answer.
const LIMIT: Duration = Duration::from_secs(20);

/// A draw in a folder of its own: it writes files and returns the commands to try on them.
struct Draw {
    noise: Noise,
    scratch: Scratch,
    variables: Vec<(&'static str, String)>,
}

/// Arguments of a command.
type Arguments = Vec<String>;

type Kind = (&'static str, fn(&mut Draw) -> Vec<Arguments>);

const KINDS: [Kind; 9] = [
    ("wide tables", Draw::wide_table),
    ("odd tables", Draw::odd_table),
    ("targets that coincide", Draw::coinciding_targets),
    ("arrays of NumPy", Draw::numpy),
    ("variables of MATLAB", Draw::matlab),
    ("workbooks", Draw::workbook),
    ("recordings", Draw::recording),
    ("templates", Draw::template),
    ("values of the environment", Draw::environment),
];

fn words(line: &str) -> Arguments {
    line.split(' ').map(str::to_owned).collect()
}

/// Commands that read a table or an archive, by its path in the folder.
fn readers(file: &str) -> Vec<Arguments> {
    let lines = [
        "formats @",
        "formats @ --robot campaign/robot.toml",
        "fit plane @",
        "fit sphere @ --by-label",
        "init new --robot ur5e --from @",
        "identify --robot campaign/robot.toml --observations @",
        "kinematics direct @ --robot campaign/robot.toml",
        "kinematics inverse @ --robot campaign/robot.toml",
        "axes @",
        "iso230 @",
        "plan --robot campaign/robot.toml --candidates @",
        "check campaign",
        "run campaign",
    ];
    lines.map(|line| words(&line.replace('@', file))).to_vec()
}

/// Formats of the log and of the export that a campaign states for a drawn file.
impl Draw {
    fn below(&mut self, bound: usize) -> usize {
        (((self.noise.uniform(1.0) + 1.0) * 0.5 * bound as f64) as usize).min(bound.saturating_sub(1))
    }

    fn of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// A number of things: mostly few, sometimes as many as `most`.
    fn count(&mut self, most: usize) -> usize {
        let share = (self.noise.uniform(1.0) + 1.0) * 0.5;
        (most as f64).powf(share) as usize
    }

    /// Writes a file, also in the place of the sample's log or export, and returns the commands that read it.
    fn files(&mut self, name: &str, bytes: &[u8]) -> Vec<Arguments> {
        std::fs::write(self.scratch.root().join(name), bytes).unwrap();
        let place = self.of(&["encoders.csv", "exports/poses.txt", "exports/world.txt"]);
        std::fs::write(self.scratch.path().join(place), bytes).unwrap();
        if name.ends_with(".mcap") {
            self.scratch.replace("campaign.toml", "file = \"encoders.csv\"", "file = \"encoders.csv\"\ntopic = \"/j\"");
        } else if let Some(format) =
            [(".npz", "numpy"), (".mat", "matlab")].into_iter().find(|(end, _)| name.ends_with(end))
        {
            let stated = format!("file = \"encoders.csv\"\nformat = \"{}\"", format.1);
            self.scratch.replace("campaign.toml", "file = \"encoders.csv\"", &stated);
        }
        readers(name)
    }

    fn number(&mut self) -> String {
        let odd =
            ["", "nan", "inf", "-0", "1e308", "1e-320", "1,5", "9223372036854775808", "x", "=1+1", "\"", "12:30", "±"];
        match self.below(12) {
            0 => self.of(&odd).to_owned(),
            1 => self.below(10).to_string(),
            _ => format!("{:.3}", self.noise.uniform(500.0)),
        }
    }

    fn wide_table(&mut self) -> Vec<Arguments> {
        let (columns, rows) = (1 + self.count(20_000), 1 + self.below(4));
        let between = self.of(&[",", ";", "\t", " "]);
        let heading = self.of(&["c", "x_mm_", "q", "", "P 1 "]);
        let mut text = String::new();
        for i in 0..columns {
            let number = if heading == "x_mm_" { i / 2 } else { i };
            let _ = write!(text, "{}{heading}{number}", if i == 0 { "" } else { between });
        }
        for _ in 0..rows {
            text.push('\n');
            let cells: Vec<String> = (0..columns).map(|_| format!("{:.2}", self.noise.uniform(500.0))).collect();
            text += &cells.join(between);
        }
        self.files("t.csv", text.as_bytes())
    }

    fn odd_table(&mut self) -> Vec<Arguments> {
        let (columns, rows) = (1 + self.below(12), 1 + self.count(20_000));
        let heads =
            ["x_mm", "y_mm", "z_mm", "pose", "target", "label", "q1_deg", "time_s", "cycle", "x", "y", "z", "rho1_mm"];
        let mut text: String = (0..columns).map(|_| format!("{},", self.of(&heads))).collect();
        for i in 0..rows {
            text.push('\n');
            let cut = if self.below(50) == 0 { self.below(columns) } else { columns };
            for j in 0..cut {
                let cell =
                    if j == 0 && self.below(2) == 0 { format!("K_{i}_{}", self.below(3)) } else { self.number() };
                let _ = write!(text, "{cell},");
            }
        }
        self.files("t.csv", text.as_bytes())
    }

    /// Targets at one place, in some poses: every target is near every other.
    fn coinciding_targets(&mut self) -> Vec<Arguments> {
        let (targets, poses) = (1 + self.count(400), 1 + self.below(60));
        let scatter = self.of(&[0.0, 1e-6, 0.05]);
        let mut rows = "pose,target,q1_deg,q2_deg,q3_deg,q4_deg,q5_deg,q6_deg,x_mm,y_mm,z_mm\n".to_owned();
        let mut points = String::new();
        for pose in 1..=poses {
            let q: Vec<String> = (0..6).map(|_| format!("{:.4}", self.noise.uniform(60.0))).collect();
            let place = [0; 3].map(|_| self.noise.uniform(800.0));
            for target in 0..targets {
                let at = place.map(|v| format!("{:.6}", v + self.noise.gaussian(scatter)));
                let _ = writeln!(rows, "{pose},T{target},{},{}", q.join(","), at.join(","));
                let _ = writeln!(points, "T{target}_{pose}_1 {}", at.join(" "));
            }
        }
        self.scratch = copy_sample("draw-wire");
        std::fs::write(self.scratch.path().join("observations.csv"), &rows).unwrap();
        std::fs::write(self.scratch.root().join("t.csv"), &rows).unwrap();
        std::fs::write(self.scratch.root().join("p.txt"), &points).unwrap();
        let mut all = readers("t.csv");
        all.extend(["formats p.txt", "fit plane p.txt", "check campaign", "check campaign"].map(words));
        all
    }

    /// A size of numbers that pack well: mostly small, sometimes a bomb.
    fn packed_size(&mut self) -> usize {
        let most = self.of(&[1 << 10, 1 << 16, 1 << 22, 1 << 27]);
        self.count(most)
    }

    fn numpy(&mut self) -> Vec<Arguments> {
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for i in 0..1 + self.below(3) {
            let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
            let name = format!("{}.npy", self.of(&["t", "q", "rho1_mm", "RP1"]).to_owned() + &i.to_string());
            zip.start_file(name, options).unwrap();
            let (count, columns) = (self.packed_size() / 8, 1 + self.below(6));
            let kind = self.of(&["<f8", "|u1", ">i4", "<f4", "|O", "<U3", "<i8"]);
            let shape = match self.below(3) {
                0 => format!("({count},)"),
                1 => format!("({}, {columns})", count / columns),
                _ => format!("({}, {}, 2)", self.count(1 << 40), count),
            };
            let head = format!("{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}\n");
            let bytes = [b"\x93NUMPY\x01\x00", &(head.len() as u16).to_le_bytes()[..], head.as_bytes()].concat();
            zip.write_all(&bytes).unwrap();
            zip.write_all(&vec![self.below(2) as u8; 8 * count]).unwrap();
        }
        let bytes = self.damaged(zip.finish().unwrap().into_inner());
        self.files("t.npz", &bytes)
    }

    fn matlab(&mut self) -> Vec<Arguments> {
        let mut bytes = b"MATLAB 5.0 MAT-file".to_vec();
        bytes.resize(124, b' ');
        bytes.extend(b"\x00\x01IM");
        for i in 0..1 + self.below(3) {
            let count = (self.packed_size() / 8) as u32;
            let element = |kind: u32, data: &[u8]| {
                let mut all = [&kind.to_le_bytes()[..], &(data.len() as u32).to_le_bytes(), data].concat();
                all.resize(all.len().next_multiple_of(8), 0);
                all
            };
            let whole = |numbers: &[u32]| numbers.iter().flat_map(|n| n.to_le_bytes()).collect::<Vec<u8>>();
            let class = self.of(&[6, 9, 2, 1]);
            let columns = 1 + self.below(4) as u32;
            let inside = [
                element(6, &whole(&[class, 0])),
                element(5, &whole(&[count / columns, columns])),
                element(1, format!("q{i}").as_bytes()),
                element(9, &vec![0; 8 * (count / columns * columns) as usize]),
            ];
            let mut matrix = element(14, &inside.concat());
            if self.below(4) == 0 {
                matrix.extend(vec![0; self.packed_size()]);
            }
            let mut packed = ZlibEncoder::new(Vec::new(), Compression::fast());
            packed.write_all(&matrix).unwrap();
            let packed = packed.finish().unwrap();
            bytes.extend([&15_u32.to_le_bytes()[..], &(packed.len() as u32).to_le_bytes(), &packed].concat());
        }
        let bytes = self.damaged(bytes);
        self.files("t.mat", &bytes)
    }

    fn workbook(&mut self) -> Vec<Arguments> {
        let main = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
        let related = "http://schemas.openxmlformats.org/officeDocument/2006/relationships";
        let package = "http://schemas.openxmlformats.org/package/2006";
        let (sheets, rows) = (1 + self.count(300), self.count(20_000));
        let mut files = vec![
            ("[Content_Types].xml".to_owned(), format!("<Types xmlns=\"{package}/content-types\"/>")),
            (
                "_rels/.rels".to_owned(),
                format!(
                    "<Relationships xmlns=\"{package}/relationships\"><Relationship Id=\"r0\" Type=\"{related}/officeDocument\" \
                     Target=\"xl/workbook.xml\"/></Relationships>"
                ),
            ),
        ];
        let (mut named, mut relations) = (String::new(), String::new());
        for i in 1..=sheets {
            let _ = write!(named, "<sheet name=\"S{i}\" sheetId=\"{i}\" r:id=\"r{i}\"/>");
            let _ = write!(
                relations,
                "<Relationship Id=\"r{i}\" Type=\"{related}/worksheet\" Target=\"worksheets/sheet{i}.xml\"/>"
            );
        }
        files.push((
            "xl/workbook.xml".to_owned(),
            format!("<workbook xmlns=\"{main}\" xmlns:r=\"{related}\"><sheets>{named}</sheets></workbook>"),
        ));
        files.push((
            "xl/_rels/workbook.xml.rels".to_owned(),
            format!("<Relationships xmlns=\"{package}/relationships\">{relations}</Relationships>"),
        ));
        let length = self.packed_size() >> 6;
        let text = "x".repeat(length);
        files.push((
            "xl/sharedStrings.xml".to_owned(),
            format!("<sst xmlns=\"{main}\" count=\"1\" uniqueCount=\"1\"><si><t>{text}</t></si></sst>"),
        ));
        let column = self.of(&["A", "Z", "ALL", "XFD"]);
        let cell = self.of(&["t=\"s\"><v>0</v>", "><v>1.5</v>", "t=\"inlineStr\"><is><t>K_1_1</t></is>"]);
        let cells: String =
            (1..=rows).map(|r| format!("<row r=\"{r}\"><c r=\"{column}{r}\" {cell}</c></row>")).collect();
        for i in 1..=sheets {
            let data = if i == 1 || sheets < 20 { cells.as_str() } else { "" };
            files.push((
                format!("xl/worksheets/sheet{i}.xml"),
                format!("<worksheet xmlns=\"{main}\"><sheetData>{data}</sheetData></worksheet>"),
            ));
        }
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        for (name, content) in files {
            let options = SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
            zip.start_file(name, options).unwrap();
            zip.write_all(content.as_bytes()).unwrap();
        }
        let bytes = self.damaged(zip.finish().unwrap().into_inner());
        self.files("t.xlsx", &bytes)
    }

    fn recording(&mut self) -> Vec<Arguments> {
        let text = |text: &str| [&(text.len() as u32).to_le_bytes(), text.as_bytes()].concat();
        let record = |kind: u8, body: &[u8]| [&[kind][..], &(body.len() as u64).to_le_bytes(), body].concat();
        let mut out = [&b"\x89MCAP0\r\n"[..], &record(1, &[text("ros2"), text("")].concat())].concat();
        let topics = 1 + self.count(200) as u16;
        for id in 0..topics {
            let own = id.to_le_bytes();
            let topic = if id == 0 { "/j".to_owned() } else { format!("/t{id}") };
            out.extend(record(
                3,
                &[&own[..], &text("sensor_msgs/msg/JointState"), &text("ros2msg"), &text("")].concat(),
            ));
            out.extend(record(4, &[&own[..], &own, &text(&topic), &text("cdr"), &[0; 4]].concat()));
        }
        let filler = record(0x80, &vec![0; self.packed_size()]);
        for i in 0..1 + self.count(60) {
            let mut inside = Vec::new();
            for k in 0..1 + self.below(20) {
                let id = (self.below(topics as usize) as u16).to_le_bytes();
                let joints = 1 + self.count(300);
                let same = self.below(2) == 0;
                let names: Vec<String> =
                    (0..joints).map(|j| if same { format!("j{j}") } else { format!("j{i}_{k}_{j}") }).collect();
                let names: Vec<&str> = names.iter().map(String::as_str).collect();
                let data = Cdr::joints((i as i32, k as u32), &names, &vec![0.5; joints]);
                inside.extend(record(5, &[&id[..], &[0; 20], &data].concat()));
            }
            inside.extend(&filler);
            let packed = zstd::encode_all(&inside[..], 1).unwrap();
            let size = if self.below(30) == 0 { u64::MAX } else { inside.len() as u64 };
            let head =
                [&[0; 16][..], &size.to_le_bytes(), &[0; 4], &text("zstd"), &(packed.len() as u64).to_le_bytes()]
                    .concat();
            out.extend(record(6, &[head, packed].concat()));
        }
        out.extend([record(15, &[0; 4]), record(2, &[0; 20]), b"\x89MCAP0\r\n".to_vec()].concat());
        let bytes = self.damaged(out);
        self.files("t.mcap", &bytes)
    }

    /// The bytes, one time in three with some damage.
    fn damaged(&mut self, mut bytes: Vec<u8>) -> Vec<u8> {
        for _ in 0..self.of(&[0, 0, 1]) * (1 + self.below(4)) {
            let at = self.below(bytes.len());
            match self.below(3) {
                0 => bytes.truncate(at.max(8)),
                1 => bytes[at] = self.below(256) as u8,
                _ => drop(bytes.splice(at..at, [0xff; 4])),
            }
        }
        bytes
    }

    fn template(&mut self) -> Vec<Arguments> {
        let many = 1 + self.count(200_000);
        let pieces = [
            "(",
            "[",
            "not ",
            "-",
            "'x' ~ ",
            "x.",
            "1 if 1 else ",
            "'x'|upper|",
            "{% if 1 %}",
            "{% for i in [1] %}",
            "{#",
        ];
        let wide = [
            "{{ 'a\nb'|indent(@) }}",
            "{{ '%@d'|format(1) }}",
            "{{ 'a'|right(@) }}",
            "{{ 1.5|fixed(@) }}",
            "{{ 1.5|scientific(@) }}",
            "{{ 'x' * @ }}",
            "{% for i in range(@) %}{{ 'x' * 1000 }}{% endfor %}",
            "{% for i in range(@) %}{% for j in range(@) %}{% endfor %}{% endfor %}",
            "{{ range(@)|batch(@)|list|length }}",
        ];
        let body = match self.below(4) {
            0 => {
                let piece = self.of(&pieces);
                if piece.starts_with('{') { piece.repeat(many) } else { format!("{{{{ {}1 }}}}", piece.repeat(many)) }
            }
            1 => format!("{{{{ 'aaaaaaaa'{} }}}}", "|replace('a', 'aaaaaaaa')".repeat(self.below(30))),
            2 => {
                let size = self.of(&["7", "9999", "65535", "65536", "99999999", "99999999999999999999"]);
                self.of(&wide).replace('@', size)
            }
            _ => "{% set ns = namespace(x='x') %}{% for i in range(@) %}{% set ns.x = ns.x ~ ns.x %}{% endfor %}"
                .replace('@', &self.below(20).to_string()),
        };
        std::fs::write(self.scratch.root().join("t.txt.j2"), format!("{{# holds: * #}}\n{body}\n")).unwrap();
        let own = self.scratch.root().join("own");
        std::fs::create_dir_all(&own).unwrap();
        std::fs::write(own.join("report.html"), body).unwrap();
        let ran = Command::new(program())
            .args(["batch", "campaign", "--documents"])
            .current_dir(self.scratch.root())
            .output();
        assert_eq!(ran.unwrap().status.code(), Some(0));
        let export = "export campaign/out/parameters.json --robot campaign/robot.toml --template t.txt.j2 --to files";
        [export, "validate campaign --templates own --report page.html"].map(words).to_vec()
    }

    fn environment(&mut self) -> Vec<Arguments> {
        let names = [
            "RAYON_NUM_THREADS",
            "POLARS_MAX_THREADS",
            "SOURCE_DATE_EPOCH",
            "COLUMNS",
            "LANG",
            "LC_ALL",
            "HOME",
            "TMPDIR",
            "TERM",
            "NO_COLOR",
            "RUST_BACKTRACE",
        ];
        let values = [
            "",
            "0",
            "1",
            "-1",
            "7",
            "1000000",
            "99999999999999999999999",
            "1e3",
            "nan",
            "/nowhere",
            "\u{1b}[31m",
            " 4 ",
            "253402300800",
            "-62135596801",
            "9223372036854775807",
            "é",
        ];
        self.variables = (0..1 + self.below(3)).map(|_| (self.of(&names), self.of(&values).to_owned())).collect();
        ["check campaign", "run campaign", "run campaign", "batch campaign", "formats campaign/encoders.csv"]
            .map(words)
            .to_vec()
    }

    /// Runs one of the commands.
    fn ends(&mut self, what: &str, commands: &[Arguments]) {
        let arguments = &commands[self.below(commands.len())];
        let mut command = Command::new(program());
        command.args(arguments).envs(self.variables.iter().map(|(n, v)| (n, v))).current_dir(self.scratch.root());
        let begun = Instant::now();
        let kept = || keep(self.scratch.root());
        let Some(ended) = run_for(&mut command, LIMIT) else {
            panic!("{what}: {arguments:?} takes over {LIMIT:?} {:?}, {:?}", self.variables, kept());
        };
        let sound = matches!(ended.code, Some(0..=2)) && !ended.stderr.contains("panicked");
        assert!(sound, "{what}: {arguments:?} {:?} {:?}, {:?}: {ended:?}", self.variables, begun.elapsed(), kept());
        assert!(ended.code != Some(2) || !ended.stderr.is_empty(), "{what}: {arguments:?} says nothing");
    }
}

/// Copies the folder of a draw that failed, so that it can be looked at.
fn keep(folder: &Path) -> PathBuf {
    let to = std::env::temp_dir().join("etalon-draw");
    let _ = std::fs::remove_dir_all(&to);
    let _ = Command::new("cp").arg("-r").arg(folder).arg(&to).status();
    to
}

#[test]
fn drawn_files_are_answered_in_time() {
    let number = |name: &str| std::env::var(name).ok().and_then(|text| text.parse::<u64>().ok());
    let seed = number("ETALON_ATTACK_SEED").unwrap_or(59);
    let (most, lasts) = (number("ETALON_DRAWS").unwrap_or(10_000), number("ETALON_DRAWS_SECONDS").unwrap_or(15));
    let only = number("ETALON_ATTACK_ONLY");
    let (begun, mut counts) = (Instant::now(), [0; KINDS.len()]);
    for number in only.unwrap_or(0)..only.map_or(most, |only| only + 1) {
        if begun.elapsed() > Duration::from_secs(lasts) && only.is_none() {
            break;
        }
        let mut draw =
            Draw { noise: Noise::new(seed, number), scratch: copy_sample("prexyt-cmm"), variables: Vec::new() };
        let kind = draw.below(KINDS.len());
        let what = format!("ETALON_ATTACK_SEED={seed} ETALON_ATTACK_ONLY={number} drawn_files ({})", KINDS[kind].0);
        let commands = KINDS[kind].1(&mut draw);
        draw.ends(&what, &commands);
        counts[kind] += 1;
    }
    let counts: Vec<String> = KINDS.iter().zip(counts).map(|((name, _), count)| format!("{count} {name}")).collect();
    println!("draws: {}", counts.join(", "));
}
