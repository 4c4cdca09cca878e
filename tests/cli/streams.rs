//! Recorded motions inside a campaign.

use super::{etalon, rows, text, text_of};
use crate::support::said::Says;
use crate::support::scratch::copy_sample;
use etalon::documents::{ImportDocument, Iso9283StreamsDocument};

#[test]
fn a_campaign_tells_what_its_recorded_motion_says_and_the_report_shows_it() {
    let scratch = copy_sample("prexyt-repeatability");
    let done = etalon(scratch.root(), &["run", "campaign"]);
    assert!(done.status.success(), "{}", text_of(&done));
    let shown = text(&done.stdout);
    for part in ["\ncorner\n", "path: 300.0 mm, 10 passes\n", "path accuracy AT: ", "path repeatability RT: "] {
        assert!(shown.contains(part), "{part}: {shown}");
    }
    assert!(rows(&shown).iter().any(|row| row.starts_with("1 2 10 223.607 299.7 1.81")), "posing time: {shown}");
    let document: Iso9283StreamsDocument = scratch.document("iso9283-streams.json");
    let stream = &document.streams[0].stream;
    let path = stream.path.as_ref().unwrap();
    // the path is off by the rounded corner and a wave of 30 µm; passes scatter by 6 µm
    assert!(path.passes == 10 && (0.03..0.5).contains(&path.at_mm), "{}", path.at_mm);
    let (rt, interval) = (path.rt_mm.unwrap(), path.rt_interval.unwrap());
    assert!((0.01..0.06).contains(&rt) && interval.low_mm < rt && interval.high_mm > 0.01, "{rt} {interval:?}");
    assert!(path.velocity.as_ref().unwrap().av_percent.abs() < 1.0);
    assert_eq!(path.corners.len(), 1);
    let poses: Vec<(i64, usize)> = stream.settling.iter().map(|s| (s.pose.number().unwrap(), s.arrivals)).collect();
    assert_eq!(poses, [(1, 9), (2, 10)], "the recording begins at pose 1");
    // 0.15 mm that die away within 80 ms are below 20 µm after 0.16 s, and 9 Hz swing about it
    assert!(stream.settling.iter().all(|s| (0.1..0.25).contains(&s.stabilisation_s)), "{:?}", stream.settling);
    let shown: Vec<i64> = stream.arrivals.iter().map(|a| a.pose.number().unwrap()).collect();
    assert_eq!(shown.iter().filter(|p| **p == 2).count(), 3);
    let import: ImportDocument = scratch.document("import.json");
    let sources: Vec<&str> =
        import.sources.iter().filter(|s| s.kind.name() == "stream").map(|s| s.file.as_str()).collect();
    assert_eq!(sources, ["exports/motion.csv", "commanded.csv", "path.csv"]);

    let report = scratch.path().join("out/report.html");
    let html = std::fs::read_to_string(&report).unwrap();
    for part in ["Deviation along the path", "Visits over time", "Arrivals", "id=\"streams\""] {
        assert!(html.contains(part), "{part}");
    }
    assert!(etalon(scratch.root(), &["report", "campaign/out"]).status.success());
    assert_eq!(std::fs::read_to_string(&report).unwrap(), html, "the report is made again from the documents alone");
}

/// Ten seconds at 2 mm/s with 2.5 mm to either side at 3 Hz: two stated mm less, a stated Hz more.
#[test]
fn a_weave_in_a_campaign_tells_what_the_command_tells() {
    let scratch = copy_sample("prexyt-repeatability");
    let mut seam = "time_s,x_mm,y_mm\n".to_owned();
    for i in 0..5000 {
        let t = f64::from(i) / 500.0;
        seam += &format!("{t:.3},{:.5},{:.5}\n", 2.0 * t, 2.5 * (std::f64::consts::TAU * 3.0 * t).sin());
    }
    std::fs::write(scratch.path().join("seam.csv"), seam).unwrap();
    std::fs::write(scratch.path().join("seam-path.csv"), "x_mm,y_mm\n1,0\n19,0\n").unwrap();
    let stated = "name = \"seam\"\nfile = \"seam.csv\"\npath = \"seam-path.csv\"\nweave_stroke_mm = 4\nweave_hz = 2.5";
    scratch.replace(
        "campaign.toml",
        "[[stream]]",
        &format!("[[stream]]\n{stated}\nweave_across = [0, 1, 0]\n\n[[stream]]"),
    );
    let done = etalon(scratch.root(), &["run", "campaign"]);
    assert!(done.status.success(), "{}", text_of(&done));
    let document: Iso9283StreamsDocument = scratch.document("iso9283-streams.json");
    let weave = document.streams[0].stream.weaving.as_ref().unwrap();
    assert!((weave.stroke_mm - 5.0).abs() < 2e-3 && (weave.frequency_hz - 3.0).abs() < 5e-3, "{weave:?}");
    assert!((weave.ws_percent - 25.0).abs() < 0.1 && (weave.wf_percent - 20.0).abs() < 0.2, "{weave:?}");
    assert_eq!((weave.commanded_stroke_mm, weave.commanded_frequency_hz), (4.0, 2.5));
    let html = std::fs::read_to_string(scratch.path().join("out/report.html")).unwrap();
    assert!(html.has_phrase("weaving-stroke") && html.contains("mm, commanded 4.000 mm: WS "), "{html}");
    let alone =
        "iso9283 --stream seam.csv --path seam-path.csv --weave-stroke-mm 4 --weave-hz 2.5 --weave-across 0,1,0 --json";
    let alone = etalon(&scratch.path(), &alone.split(' ').collect::<Vec<_>>());
    let alone: etalon::documents::Iso9283StreamDocument = serde_json::from_slice(&alone.stdout).unwrap();
    assert_eq!(alone.weaving.as_ref(), Some(weave));
}

#[test]
fn what_is_wrong_with_a_recorded_motion_is_told_by_check_with_its_place() {
    for (file, from, to, parts) in [
        ("campaign.toml", "exports/motion.csv", "exports/no.csv", &["exports/no.csv", "campaign.toml:"][..]),
        (
            "campaign.toml",
            "band_mm = 0.02",
            "band_mm = -1",
            &["error[option-not-positive]: `band_mm`", "campaign.toml:"],
        ),
        ("campaign.toml", "path = \"path.csv\"", "", &["error[path-not-stated]: `velocity_mm_s`"]),
        ("campaign.toml", "band_mm = 0.02", "band = 0.02", &["[unknown-key]", "`band`"]),
        (
            "campaign.toml",
            "band_mm = 0.02",
            "weave_hz = 2",
            &["error[weave-incomplete]", "`weave_stroke_mm`", "[weave-incomplete]", "`weave_across`"],
        ),
        (
            "campaign.toml",
            "path = \"path.csv\"",
            "weave_stroke_mm = 2\nweave_hz = 3\nweave_across = [0, 1]",
            &["error[path-not-stated]: `weave_stroke_mm`", "error[weave-direction-count]"],
        ),
        ("campaign.toml", "band_mm = 0.02", "unit = \"mm\"", &["error[recording-unit]"]),
        ("path.csv", "250,50\n", "250,fifty\n", &["path.csv", "fifty"]),
        ("exports/motion.csv", "0.03,", "0.01,", &["motion.csv:5", "error[time-not-increasing]"]),
    ] {
        let scratch = copy_sample("prexyt-repeatability");
        let path = scratch.path().join(file);
        let whole = std::fs::read_to_string(&path).unwrap();
        assert!(whole.contains(from), "{file} has no {from}");
        std::fs::write(&path, whole.replacen(from, to, 1)).unwrap();
        for command in ["check", "run"] {
            let refused = etalon(scratch.root(), &[command, "campaign"]);
            let said = text_of(&refused);
            assert_eq!(refused.status.code(), Some(2), "{command} {to}: {said}");
            parts.iter().for_each(|part| assert!(said.says(part), "{command}: no {part:?} in {said}"));
        }
    }
}
