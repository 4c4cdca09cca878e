//! Proposals for files of public repositories, which `ETALON_CORPUS` holds: `fetch_public.py` fetches
//! them.

use super::{Right, wrong};
use crate::support::root;
use etalon::formats::propose_file;
use serde::Deserialize;
use std::path::PathBuf;

#[derive(Deserialize)]
struct Public {
    file: Vec<Listed>,
}

#[derive(Deserialize)]
struct Listed {
    repository: String,
    path: String,
    sha256: String,
    #[serde(flatten)]
    right: Right,
}

fn listed() -> Vec<Listed> {
    let list = root().join("tests/formats/public.toml");
    toml::from_str::<Public>(&std::fs::read_to_string(list).unwrap()).unwrap().file
}

/// Half of the files of `formats` are real ones, of more than one origin.
#[test]
fn the_list_of_public_files_is_long_and_of_several_origins() {
    let files = listed();
    let mut repositories: Vec<&str> = files.iter().map(|file| file.repository.as_str()).collect();
    repositories.dedup();
    assert!(files.len() >= 30 && repositories.len() >= 8, "{} files, {repositories:?}", files.len());
}

/// A file whose right reading is stated is proposed so, and every other one in doubt.
#[test]
fn public_files_are_proposed_right_or_in_doubt() {
    let Some(folder) = std::env::var_os("ETALON_CORPUS").map(PathBuf::from) else {
        return crate::support::skipped("ETALON_CORPUS");
    };
    let (mut right, mut right_in_doubt, mut doubt, mut wrongly) = (0, 0, 0, Vec::new());
    for file in listed() {
        let path = folder.join(file.repository.replace('/', "+")).join(&file.path);
        let bytes = std::fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        assert_eq!(etalon::base::files::sha256(&bytes), file.sha256, "{}: another file", path.display());
        let found = wrong(&file.right, &path);
        let is_doubted = propose_file(&path).is_ok_and(|proposal| !proposal.doubts.is_empty());
        let asks =
            file.right.questions_alone && propose_file(&path).is_ok_and(|proposal| !proposal.questions.is_empty());
        match found {
            Ok(()) if file.right.doubt && (is_doubted || asks) => right_in_doubt += 1,
            Err(_) if file.right.doubt && (is_doubted || asks) => doubt += 1,
            Ok(()) if !file.right.doubt => right += 1,
            found => wrongly.push(format!("{}: {}", file.path, found.err().unwrap_or_else(|| "no doubt".to_owned()))),
        }
    }
    println!("{right} right, {right_in_doubt} right in doubt, {doubt} others in doubt, {} wrong", wrongly.len());
    assert!(wrongly.is_empty(), "{} wrong:\n{}", wrongly.len(), wrongly.join("\n"));
}
