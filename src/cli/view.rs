//! Command `etalon view`.

use super::{Output, Verdict};
use crate::session::{Planned, Session};
use etalon_base::message::Problems;
use etalon_base::{error, files, phrase, warning};
use etalon_view::{Desk, Limits, Server, State, exported};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

/// Show a campaign in the browser, with its robot, its errors and open questions; or start one from
/// files.
///
/// Only this machine can open the page, and no network is needed. The command ends with Ctrl-C, or
/// one minute after the page is closed.
#[derive(Debug, clap::Args)]
pub struct View {
    /// Folder of a campaign, its campaign.toml, or files to start a campaign from; by default the
    /// current folder.
    #[arg(value_name = "FOLDER|FILES")]
    paths: Vec<PathBuf>,
    /// Print the address without opening a browser.
    #[arg(long)]
    no_open: bool,
    /// Port of the server; by default a free one.
    #[arg(long, default_value_t = 0, hide_default_value = true)]
    port: u16,
    /// Follow the files of the campaign while they grow: each new pose is compared with the earlier
    /// ones.
    #[arg(long, conflicts_with = "export")]
    watch: bool,
    /// Poses in the order of measurement, for `--watch`: a table with pose and joints, as `etalon
    /// plan --poses` writes it.
    #[arg(long, value_name = "FILE", requires = "watch", conflicts_with = "candidates")]
    plan: Option<PathBuf>,
    /// Candidates for the next pose: `--watch` shows which one gives the most information. A table
    /// with pose and joints.
    #[arg(long, value_name = "FILE", requires = "watch")]
    candidates: Option<PathBuf>,
    /// Write the page, with the results, to one file that needs no server.
    #[arg(long, value_name = "FILE", conflicts_with_all = ["no_open", "port"])]
    export: Option<PathBuf>,
}

/// Folder of a campaign that is started from files.
const STARTED: &str = "first-campaign";

impl View {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let folder = self.folder()?;
        if let Some(file) = &self.export {
            return export(&Session::open(&folder), &folder, file, out);
        }
        let server = Server::listen(self.port, Limits::default()).map_err(|e| {
            Problems::from(error!("view-port-unavailable", port = i64::from(self.port), error = e.to_string()))
        })?;
        let session = Session::open(&folder);
        let url = server.url();
        out.print_text(&format!("{}\n", phrase!("view-opened", url = &url)))?;
        if !folder.join("campaign.toml").is_file() && self.paths.is_empty() {
            out.next_step(false, phrase!("view-next-drop"));
        }
        out.next_step(false, phrase!("view-next"));
        if !self.no_open && !open_browser(&url) {
            out.remark(&[warning!("view-browser-not-opened", url)]);
        }
        if self.watch {
            let planned = |file: &PathBuf, in_order| Planned { file: file.clone(), in_order };
            let plan = self.plan.as_ref().map(|file| planned(file, true));
            session.follow(plan.or(self.candidates.as_ref().map(|file| planned(file, false))));
        }
        let events = session.events.clone();
        server.serve(session, events)?;
        Ok(Verdict::Met)
    }

    /// The folder of the page; files are copied into a new one.
    fn folder(&self) -> anyhow::Result<PathBuf> {
        match &self.paths[..] {
            [] => Ok(PathBuf::from(".")),
            [one] if one.is_dir() => Ok(one.clone()),
            [one] if one.file_name().is_some_and(|name| name == "campaign.toml") && one.is_file() => {
                Ok(one.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new(".")).to_owned())
            }
            several => start(several),
        }
    }
}

/// Copies files into a new folder.
fn start(paths: &[PathBuf]) -> anyhow::Result<PathBuf> {
    let numbered = |n: usize| if n == 1 { STARTED.to_owned() } else { format!("{STARTED}-{n}") };
    let mut copied: Vec<(String, Vec<u8>)> = Vec::new();
    for path in paths {
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if copied.iter().any(|(other, _)| *other == name) {
            return Err(Problems::from(error!("two-files-of-one-name", name)).into());
        }
        copied.push((name, files::read(path)?));
    }
    let free = (1..).map(numbered).map(PathBuf::from).find(|folder| !folder.exists());
    let folder = free.unwrap_or_else(|| PathBuf::from(STARTED));
    files::write_new(&folder, &copied)?;
    Ok(folder)
}

/// Writes the page with the results inside.
fn export(session: &Arc<Session>, folder: &Path, file: &Path, out: &Output) -> anyhow::Result<Verdict> {
    let state = State { meshes: session.meshes(), ..session.state() };
    if state.found.scene.is_none() && state.verdict.is_none() {
        let (_, problems) = crate::tasks::find(&folder.join("campaign.toml"));
        problems.check()?;
        return Err(Problems::from(error!("view-without-campaign")).into());
    }
    let inputs: Vec<PathBuf> = state.files.iter().map(|input| folder.join(&input.name)).collect();
    files::refuse_overwriting([&file.to_path_buf()], inputs.iter())?;
    files::write(file, exported(&state)?.as_bytes())?;
    Ok(out.print_after_writing(format!("{}\n", file.display()), Verdict::Met))
}

/// Opens an address in the user's browser; `false` if no program could be started.
fn open_browser(url: &str) -> bool {
    let commands: &[(&str, &[&str])] = match std::env::consts::OS {
        "macos" => &[("open", &[])],
        "windows" => &[("rundll32", &["url.dll,FileProtocolHandler"])],
        _ => &[("xdg-open", &[]), ("wslview", &[])],
    };
    let started = |(program, arguments): &(&str, &[&str])| {
        let silent = || Stdio::null();
        let mut child = Command::new(program);
        child.args(*arguments).arg(url).stdin(silent()).stdout(silent()).stderr(silent());
        let Ok(mut child) = child.spawn() else { return false };
        // without a browser xdg-open ends at once: the thread collects its exit status
        std::thread::spawn(move || drop(child.wait()));
        true
    };
    commands.iter().any(started)
}
