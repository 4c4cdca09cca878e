//! Synthetic campaigns: a sample with another seed, evaluated from its exports to its documents.

use etalon::campaign::Campaign;
use etalon::run::pipeline::{Evaluated, evaluate};
use etalon::simulate::{Truth, Unmodelled, simulate};
use rayon::prelude::*;
use std::fs;
use std::path::{Path, PathBuf};

/// Changes of a sample: its truth, and texts of campaign.toml to replace.
#[derive(Clone, Default)]
pub struct Changes<'a> {
    pub campaign: Vec<(&'a str, &'a str)>,
    pub cycles: Option<i64>,
    /// Errors that no parameter describes.
    pub unmodelled: Option<Unmodelled>,
    /// Exports that are taken from the campaign with this seed: what is measured once.
    pub once: Option<(&'a str, u64)>,
}

pub fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("samples").join(name)
}

pub fn truth(name: &str) -> Truth {
    Truth::read(&sample(name).join("truth.toml")).expect("truth")
}

/// The sample `name` with noise from `seed`; `read` takes what is wanted from its folder and what was evaluated.
pub fn campaign<T>(name: &str, changes: &Changes, seed: u64, read: impl Fn(&Path, &Evaluated) -> T) -> T {
    let folder = tempfile::tempdir().expect("folder");
    let here = folder.path();
    fs::create_dir_all(here.join("exports")).expect("folder");
    for entry in fs::read_dir(sample(name)).expect("sample").flatten().filter(|e| e.path().is_file()) {
        fs::copy(entry.path(), here.join(entry.file_name())).expect("copy");
    }
    for entry in fs::read_dir(sample(name).join("exports")).expect("sample").flatten() {
        fs::copy(entry.path(), here.join("exports").join(entry.file_name())).expect("copy");
    }
    let path = here.join("campaign.toml");
    let text = fs::read_to_string(&path).expect("campaign");
    let text = changes.campaign.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{name}: campaign.toml has no `{from}`");
        text.replace(from, to)
    });
    fs::write(&path, text).expect("campaign");
    let mut truth = truth(name);
    truth.cycles = changes.cycles.unwrap_or(truth.cycles);
    truth.unmodelled.clone_from(&changes.unmodelled);
    let campaign = Campaign::read(here).expect("campaign");
    let mut write = |seed: u64| {
        truth.seed = seed;
        simulate(&campaign, &truth).expect("simulated");
    };
    let first = changes.once.map(|(file, seed)| {
        write(seed);
        (here.join(file), fs::read(here.join(file)).expect("export"))
    });
    write(seed);
    if let Some((file, bytes)) = first {
        fs::write(file, bytes).expect("export");
    }
    let evaluated = evaluate(&campaign).unwrap_or_else(|problems| panic!("{name}, seed {seed}: {problems}"));
    read(here, &evaluated)
}

/// One for each draw, on all threads; seeds of other samples and of the samples themselves are not used.
pub fn campaigns<T: Send>(
    name: &str,
    changes: &Changes,
    draws: u64,
    read: impl Fn(&Path, &Evaluated) -> T + Sync,
) -> Vec<T> {
    (0..draws).into_par_iter().map(|draw| campaign(name, changes, 10_000 + draw, &read)).collect()
}
