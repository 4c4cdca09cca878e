//! Reports to look at: of samples, in every language, of a campaign whose names are hostile, and one that compares it.

use crate::support::scratch::copy_sample;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Pages, in a folder that goes away with them.
pub struct Pages {
    pub pages: Vec<PathBuf>,
    /// A comparison, which has no marks of poses to point at.
    pub comparison: PathBuf,
    /// Of a robot in space.
    pub spatial: Option<PathBuf>,
    /// The page over three campaigns.
    pub batch: PathBuf,
    pub folder: tempfile::TempDir,
}

/// The page whose names are hostile.
pub fn hostile(folder: &tempfile::TempDir) -> PathBuf {
    folder.path().join("hostile.html")
}

/// Every page.
pub fn all() -> Pages {
    let folder = tempfile::tempdir().unwrap();
    let mut pages = Vec::new();
    let mut report = |campaign: &Path, name: &str, language: &str| {
        etalon(&["report".as_ref(), campaign.join("out").as_os_str(), "--language".as_ref(), language.as_ref()]);
        let page = folder.path().join(format!("{name}.html"));
        std::fs::copy(campaign.join("out/report.html"), &page).unwrap();
        pages.push(page);
    };
    for (sample, languages) in [
        ("prexyt-cmm", &["en", "fr", "de"][..]),
        ("prexyt-repeatability", &["en", "fr", "de"]),
        ("prexyt-geometric", &["de"]),
        ("pose-test", &["en", "fr", "de"]),
    ] {
        let scratch = copy_sample(sample);
        etalon(&["run".as_ref(), scratch.path().as_os_str()]);
        languages.iter().for_each(|language| report(&scratch.path(), &format!("{sample}-{language}"), language));
    }
    let scratch = copy_sample("hexapod");
    run(&scratch);
    report(&scratch.path(), "hexapod", "fr");
    let scratch = copy_sample("prexyt-cmm");
    make_hostile(&scratch);
    etalon(&["run".as_ref(), scratch.path().as_os_str()]);
    report(&scratch.path(), "hostile", "fr");
    let sound = copy_sample("prexyt-cmm");
    etalon(&["run".as_ref(), sound.path().as_os_str()]);
    let page = folder.path().join("compare.html");
    let campaigns = [sound.path(), scratch.path()];
    let [a, b] = campaigns.each_ref().map(|path| path.as_os_str());
    etalon(&["compare".as_ref(), a, b, "--language".as_ref(), "de".as_ref(), "--report".as_ref(), page.as_os_str()]);
    let tested = copy_sample("pose-test");
    let c = tested.path();
    let to = folder.path().as_os_str();
    etalon(&["batch".as_ref(), a, b, c.as_os_str(), "--to".as_ref(), to, "--language".as_ref(), "fr".as_ref()]);
    let batch = folder.path().join("batch.html");
    let spatial = pages.iter().position(|page| page.ends_with("hexapod.html")).map(|i| pages.remove(i));
    Pages { pages, comparison: page, spatial, batch, folder }
}

/// Runs a campaign, whatever its limits come to.
pub fn run(scratch: &crate::support::scratch::Scratch) {
    let output = Command::new(crate::support::program()).arg("run").arg(scratch.path()).output().unwrap();
    assert!(output.status.code() < Some(2), "{}", String::from_utf8_lossy(&output.stderr));
}

fn etalon(arguments: &[&std::ffi::OsStr]) {
    let output = Command::new(crate::support::program()).args(arguments).output().unwrap();
    assert!(output.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
}

/// Names wherever a campaign has names: script, formula, right to left, 200 letters without a gap.
pub fn make_hostile(scratch: &crate::support::scratch::Scratch) {
    let script = "<script>owned=1</script><img src=x onerror=owned=1>\"'&amp;";
    let hebrew = "\u{202e}\u{5e8}\u{5d5}\u{5d1}\u{5d5}\u{5d8} =HYPERLINK(\"http://x.invalid\";\"y\")";
    let long = "n".repeat(200);
    let quoted = |text: &str| serde_json::to_string(text).unwrap();
    scratch.replace("campaign.toml", "\"PreXYT, CMM (synthetic)\"", &quoted(&format!("{script} {hebrew}")));
    scratch.replace(
        "campaign.toml",
        "[instrument]",
        &format!(
            "operator = {}\nnotes = {}\ndate = {}\n\n[conditions]\nrobot = {}\ndeviations = [{}, {}]\n\n[instrument]",
            quoted(hebrew),
            quoted(&long),
            quoted(&format!("2026-03-02 {script}")),
            quoted(&long),
            quoted(script),
            quoted(hebrew)
        ),
    );
    scratch.replace("campaign.toml", "\"Mitutoyo BRIGHT-STRATO 7106\"", &quoted(&long));
    let feature = format!("{script}{long}");
    scratch.replace("campaign.toml", "[feature.rails]", &format!("[feature.{}]", quoted(&feature)));
    scratch.replace("campaign.toml", "plane = \"rails\"", &format!("plane = {}", quoted(&feature)));
    let label = "=cmd|'/C'!A0<script>owned=1</script>";
    scratch.replace("campaign.toml", "\"rail2_a\"", &quoted(label));
    scratch.replace("exports/world.txt", "rail2_a", label);
    let file = "exports/=1+1 <img src=x onerror=owned=1>.txt";
    std::fs::rename(scratch.path().join("exports/world.txt"), scratch.path().join(file)).unwrap();
    scratch.replace("campaign.toml", "\"exports/world.txt\"", &quoted(file));
}
