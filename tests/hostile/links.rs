//! Symbolic links, devices and rights around everything that is written: a link leads no writer to
//! another folder, and what is carried over keeps mode and owner.

use crate::support::program;
use crate::support::said::Says;
use crate::support::scratch::{Scratch, copy_sample, ends, etalon, said};
use std::collections::BTreeMap;
use std::os::unix::fs::{FileTypeExt, MetadataExt, PermissionsExt, lchown, symlink};
use std::path::{Path, PathBuf};
use std::process::Command;

/// Kind, mode, owner and contents of everything below a folder; the folder itself is `""`.
pub(super) fn state(folder: &Path) -> BTreeMap<PathBuf, (u32, u32, u32, Vec<u8>)> {
    let mut all = BTreeMap::new();
    let mut open = vec![folder.to_owned()];
    while let Some(path) = open.pop() {
        let found = std::fs::symlink_metadata(&path).unwrap();
        let contents = match () {
            () if found.is_symlink() => std::fs::read_link(&path).unwrap().into_os_string().into_encoded_bytes(),
            () if found.is_file() => std::fs::read(&path).unwrap(),
            () => Vec::new(),
        };
        if found.is_dir() {
            open.extend(std::fs::read_dir(&path).unwrap().map(|entry| entry.unwrap().path()));
        }
        let name = path.strip_prefix(folder).unwrap().to_owned();
        all.insert(name, (found.mode(), found.uid(), found.gid(), contents));
    }
    all
}

/// A folder of somebody else, with names that etalon writes.
pub(super) fn victim(at: &Path) -> PathBuf {
    let victim = at.join("victim");
    std::fs::create_dir_all(victim.join("private")).unwrap();
    for name in ["report.html", "controller.json", "batch.html", "campaign.toml.old", "poses.txt", "private/key"] {
        std::fs::write(victim.join(name), "mine").unwrap();
    }
    std::fs::set_permissions(victim.join("private"), PermissionsExt::from_mode(0o700)).unwrap();
    // only root can give a folder away
    let _ = lchown(victim.join("private"), Some(65534), Some(65534));
    victim
}

#[test]
fn no_link_leads_a_run_out_of_its_campaign() {
    let scratch = copy_sample("prexyt-cmm");
    let victim = victim(scratch.root());
    let before = state(&victim);
    let out = scratch.path().join("out");
    let refused = |link: &str| {
        for command in ["check", "run", "batch"] {
            let (code, said) = etalon(&scratch, command);
            assert_eq!(code, Some(2), "{command}: {said}");
            assert!(
                said.contains("output-through-link") || said.contains(&format!("`{link}` is a symbolic link")),
                "{said}"
            );
            assert!(said.contains(&format!("`campaign/{link}`")), "{said}");
        }
        assert!(state(&victim) == before);
    };
    for target in [victim.clone(), "../victim".into(), "nowhere".into(), victim.join("report.html")] {
        symlink(&target, &out).unwrap();
        refused("out");
        assert!(std::fs::symlink_metadata(&out).unwrap().is_symlink());
        std::fs::remove_file(&out).unwrap();
    }
    assert!(!scratch.path().join("nowhere").exists());
    // a folder above the output folder
    scratch.replace("campaign.toml", "[instrument]", "output = \"a/b/out\"\n[instrument]");
    let above = scratch.path().join("a");
    symlink("../victim", &above).unwrap();
    refused("a");
    std::fs::remove_file(&above).unwrap();
    std::fs::create_dir(&above).unwrap();
    symlink("../../victim", above.join("b")).unwrap();
    refused("a/b");
    // also if the link leads to another campaign
    std::fs::write(victim.join("campaign.toml"), "").unwrap();
    ends(&scratch, "run", 2, &["[output-through-link] link=campaign/a/b"]);
    // names of the exchange
    std::fs::remove_file(above.join("b")).unwrap();
    std::fs::create_dir(above.join("b")).unwrap();
    for name in [".out.new", ".out.old"] {
        let link = above.join("b").join(name);
        symlink("../../../victim", &link).unwrap();
        ends(&scratch, "run", 2, &[&format!("`campaign/a/b/{name}` is a symbolic link")]);
        std::fs::remove_file(&link).unwrap();
    }
    std::fs::remove_file(victim.join("campaign.toml")).unwrap();
    assert!(state(&victim) == before);
    ends(&scratch, "run", 0, &[]);
}

#[test]
fn a_campaign_that_a_link_leads_to_works() {
    let scratch = copy_sample("prexyt-cmm");
    let data = scratch.root().join("data");
    symlink(scratch.root(), &data).unwrap();
    symlink(scratch.path(), scratch.root().join("linked")).unwrap();
    for campaign in ["data/campaign", "linked", "linked/campaign.toml", "linked/"] {
        for command in ["check", "run", "batch", "report"] {
            let (code, said) = said(&scratch, &[command, campaign]);
            assert_eq!(code, Some(0), "{command} {campaign}: {said}");
        }
    }
    assert_eq!(said(&scratch, &["export", "data/campaign/out/parameters.json", "--to", "data/files"]).0, Some(0));
    assert!(scratch.root().join("files/controller.json").is_file());
    // an input may be elsewhere
    std::fs::rename(scratch.path().join("exports"), scratch.root().join("measured")).unwrap();
    symlink("../measured", scratch.path().join("exports")).unwrap();
    ends(&scratch, "run", 0, &[]);
}

#[test]
fn what_is_carried_over_keeps_mode_and_owner() {
    let scratch = copy_sample("prexyt-cmm");
    let elsewhere = victim(scratch.root());
    let before = state(&elsewhere);
    let out = scratch.path().join("out");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let private = victim(&out);
    for (name, mode) in [("readonly", 0o555), ("sticky", 0o1777), ("group", 0o2750), ("private", 0o700)] {
        let folder = out.join(name);
        std::fs::create_dir(&folder).unwrap();
        std::fs::write(folder.join("file"), name).unwrap();
        std::fs::set_permissions(folder.join("file"), PermissionsExt::from_mode(0o600)).unwrap();
        std::fs::set_permissions(&folder, PermissionsExt::from_mode(mode)).unwrap();
    }
    symlink("../../victim", out.join("link")).unwrap();
    symlink("../../victim/private", private.join("link")).unwrap();
    symlink("nowhere", out.join("dangling")).unwrap();
    assert!(Command::new("mkfifo").arg(out.join("pipe")).status().unwrap().success());
    std::fs::set_permissions(&out, PermissionsExt::from_mode(0o750)).unwrap();
    let _ = lchown(&out, Some(1234), Some(1234));
    let foreign = |all: BTreeMap<PathBuf, (u32, u32, u32, Vec<u8>)>| {
        let is_foreign = |name: &Path| {
            let ours = ["victim", "readonly", "sticky", "group", "private", "link", "dangling", "pipe"];
            name.as_os_str().is_empty() || ours.iter().any(|own| name.starts_with(own))
        };
        all.into_iter().filter(|(name, _)| is_foreign(name)).collect::<BTreeMap<_, _>>()
    };
    let kept = foreign(state(&out));
    assert_eq!(kept.len(), 21, "{:?}", kept.keys());
    for factor in ["2.5", "3"] {
        let text = std::fs::read_to_string(scratch.path().join("campaign.toml")).unwrap();
        let changed = text.replace("coverage_factor = 2\n", "coverage_factor = 2.5\n");
        let changed =
            if factor == "3" { text.replace("coverage_factor = 2.5\n", "coverage_factor = 3\n") } else { changed };
        std::fs::write(scratch.path().join("campaign.toml"), changed).unwrap();
        ends(&scratch, "run", 0, &[]);
        assert_eq!(said(&scratch, &["report", "campaign"]).0, Some(0));
        assert!(foreign(state(&out)) == kept, "{:?}", foreign(state(&out)));
        assert!(std::fs::symlink_metadata(out.join("pipe")).unwrap().file_type().is_fifo());
    }
    assert!(state(&elsewhere) == before);
    let left: Vec<_> = std::fs::read_dir(scratch.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert!(!left.iter().any(|name| name.to_string_lossy().starts_with('.')), "{left:?}");
}

#[test]
fn no_option_writes_through_a_link_or_over_a_device() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let victim = victim(scratch.root());
    let before = state(&victim);
    let link = scratch.root().join("link");
    symlink("victim", &link).unwrap();
    symlink("victim/report.html", scratch.root().join("page.html")).unwrap();
    symlink("../victim", scratch.path().join("files")).unwrap();
    let commands: [&[&str]; 12] = [
        &["export", "campaign/out/parameters.json", "--to", "link"],
        &["export", "campaign/out/parameters.json", "--to", "link/"],
        &["export", "campaign/out/parameters.json", "--to", "campaign/files/sub"],
        &["batch", "campaign", "--to", "link"],
        &["init", "link"],
        &["init", "campaign/files/new"],
        &["init", "link", "--synthetic"],
        &["report", "--write-templates", "link"],
        &["man", "link"],
        &["compare", "campaign", "campaign/out", "--report", "page.html"],
        &["validate", "campaign", "--report", "page.html"],
        &["recommend", "campaign", "--report", "page.html"],
    ];
    for arguments in commands {
        let (code, said) = said(&scratch, arguments);
        assert_eq!(code, Some(2), "{arguments:?}: {said}");
        // the folder of another may be refused for its files, and a campaign that is compared with itself
        let is_named = ["symbolic link", "[file-exists]", "[campaign-twice]"].iter().any(|part| said.contains(part));
        assert!(is_named, "{arguments:?}: {said}");
        assert!(state(&victim) == before, "{arguments:?}");
    }
    // a device is not replaced by a file
    let pipe = scratch.root().join("pipe.html");
    assert!(Command::new("mkfifo").arg(&pipe).status().unwrap().success());
    let (code, text) = said(&scratch, &["validate", "campaign", "--report", "pipe.html"]);
    assert!(code == Some(2) && text.says("[output-not-a-file]"), "{text}");
    assert!(std::fs::symlink_metadata(&pipe).unwrap().file_type().is_fifo());
    // a file that is replaced keeps its mode
    let page = scratch.root().join("own.html");
    std::fs::write(&page, "").unwrap();
    std::fs::set_permissions(&page, PermissionsExt::from_mode(0o640)).unwrap();
    // the nominal robot misses the limit
    assert_eq!(said(&scratch, &["validate", "campaign", "--report", "own.html"]).0, Some(1));
    assert_eq!(std::fs::metadata(&page).unwrap().mode() & 0o7777, 0o640);
}

#[test]
fn a_report_and_an_export_replace_no_file_of_others() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(said(&scratch, &["batch", "campaign", "--documents"]).0, Some(0));
    let page = scratch.path().join("out/report.html");
    std::fs::write(&page, "mine").unwrap();
    ends(&scratch, "report", 2, &["[foreign-file]: `campaign/out/report.html`"]);
    assert_eq!(std::fs::read(&page).unwrap(), b"mine");
}

#[test]
fn a_simulation_writes_through_no_link() {
    let scratch = copy_sample("prexyt-cmm");
    let victim = victim(scratch.root());
    let before = state(&victim);
    std::fs::remove_dir_all(scratch.path().join("exports")).unwrap();
    symlink("../victim", scratch.path().join("exports")).unwrap();
    ends(&scratch, "simulate", 2, &["[output-through-link] link=campaign/exports"]);
    std::fs::remove_file(scratch.path().join("exports")).unwrap();
    std::fs::remove_file(scratch.path().join("encoders.csv")).unwrap();
    symlink("../victim/report.html", scratch.path().join("encoders.csv")).unwrap();
    // nothing is written before the link is found
    ends(&scratch, "simulate", 2, &["[output-through-link] link=campaign/encoders.csv"]);
    assert!(!scratch.path().join("exports").exists());
    assert!(state(&victim) == before);
}

/// The shell of a user with `ulimit -f` (in blocks of 512 or 1024 bytes).
fn limited(scratch: &Scratch, blocks: usize, arguments: &str) -> (Option<i32>, String) {
    let line = format!("ulimit -f {blocks}; exec {} {arguments}", program());
    let output = Command::new("bash").args(["-c", &line]).current_dir(scratch.root()).output().unwrap();
    (output.status.code(), String::from_utf8(output.stderr).unwrap())
}

#[test]
#[cfg(target_os = "linux")]
fn a_limit_of_file_sizes_leaves_no_lock() {
    let scratch = copy_sample("prexyt-cmm");
    assert_eq!(etalon(&scratch, "run").0, Some(0));
    let before = state(&scratch.path());
    for (blocks, arguments) in [
        (0, "run campaign"),
        (1, "run campaign"),
        (20, "run campaign"),
        (1, "report campaign"),
        (0, "export campaign/out/parameters.json --to files"),
        (1, "batch campaign --newer-than campaign/robot.toml --to files"),
        (1, "validate campaign --report page.html"),
    ] {
        let (code, said) = limited(&scratch, blocks, arguments);
        assert!(code == Some(2), "{blocks} {arguments}: {code:?} {said}");
        let names =
            |folder: &Path| state(folder).into_keys().map(|name| name.display().to_string()).collect::<Vec<_>>();
        let left: Vec<String> =
            names(scratch.root()).into_iter().filter(|name| name.contains("/.") || name.starts_with('.')).collect();
        assert!(left.is_empty(), "{blocks} {arguments}: {left:?}");
        assert!(state(&scratch.path()) == before, "{blocks} {arguments}");
    }
}
