//! Files from anywhere: whatever they hold, an error with what to do, and no long wait.

use std::path::Path;
use std::process::Command;
use std::time::Instant;

/// What `etalon formats FILE` says, its exit code, and how many seconds it took.
fn formats(folder: &Path, file: &str) -> (Option<i32>, String, f64) {
    let begun = Instant::now();
    let output = Command::new(crate::support::program()).args(["formats", file]).current_dir(folder).output().unwrap();
    let said = String::from_utf8(output.stderr).unwrap() + &String::from_utf8(output.stdout).unwrap();
    (output.status.code(), said, begun.elapsed().as_secs_f64())
}

#[test]
fn what_is_no_text_with_numbers_is_an_error_with_a_reason_and_not_a_long_wait() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| std::fs::write(folder.path().join(name), bytes).unwrap();
    write("empty.txt", b"");
    write("blank.txt", b"\n\n  \n");
    write("words.txt", b"no numbers here\n");
    write("lists.txt", b"P0: [0.1, 0.2] [3, 4, 5]\nP1: [0.3, 0.4] [6, 7, 8]\n");
    write("nul.txt", b"1 2 3\n4 \x005 6\n");
    write("random.bin", &(0..9000u32).map(|i| (i * i % 251) as u8).collect::<Vec<_>>());
    write("a.xls", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1");
    write("cut.xlsx", b"PK\x03\x04\x14\x00");
    write("bomb.xml", b"<!DOCTYPE a [<!ENTITY b \"bbbb\">]><a>&b;</a>");
    std::fs::create_dir(folder.path().join("exports")).unwrap();
    // a gigabyte without a line, which takes no place on the disk
    std::fs::File::create(folder.path().join("huge.txt")).unwrap().set_len(1 << 30).unwrap();
    for (file, part) in [
        ("empty.txt", "error[file-empty]"),
        ("blank.txt", "error[no-rows-of-numbers]"),
        ("words.txt", "error[no-rows-of-numbers]"),
        ("lists.txt", "error[numbers-in-brackets]"),
        ("nul.txt", "[nul-byte]"),
        ("random.bin", "[encoding-invalid]"),
        ("a.xls", "[file-not-text]"),
        ("cut.xlsx", "[workbook-unreadable]"),
        ("bomb.xml", "error[file-without-points]"),
        ("exports", "[input-is-folder]: `exports`"),
        ("huge.txt", "[line-too-long]"),
        ("nowhere.txt", "[input-missing]"),
    ] {
        let (code, said, seconds) = formats(folder.path(), file);
        assert!(code == Some(2) && said.contains(part) && said.starts_with("error"), "{file}: {code:?} {said}");
        assert!(seconds < 60.0, "{file} took {seconds:.2} s");
    }
}

#[test]
fn a_file_cut_off_anywhere_is_read_or_refused_and_never_more_than_it_holds() {
    use etalon::formats::Format;
    use etalon::formats::dialect::Unit;
    #[derive(serde::Deserialize)]
    struct Stated {
        format: Format,
    }
    let text = "Name;X;Y;Z\nKügelchen 1;1,25;-2,5;3,75\n\"a;b\";4,5;5,5;6,5\n";
    let stated =
        "format = { delimiter = \";\", decimal = \",\", header = 1, columns = [\"label\", \"x\", \"y\", \"z\"] }";
    let format = toml::from_str::<Stated>(stated).unwrap().format;
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cut.txt");
    let whole = text.as_bytes();
    for cut in 0..=whole.len() {
        std::fs::write(&file, &whole[..cut]).unwrap();
        let rows = etalon::formats::read_file(&file, None, &format, Unit::Millimetre).map_or(0, |points| points.len());
        let lines = whole[..cut].iter().filter(|b| **b == b'\n').count();
        assert!(rows <= lines.min(2) + 1, "{cut} bytes give {rows} rows");
    }
}
