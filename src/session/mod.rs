//! An open page of `etalon view`: its folder, the campaign in it as last identified, and the events
//! that the page receives.

mod changes;
mod covariance;
mod files;
mod meshes;
mod opened;
mod proposal;
mod run;
mod scene;
mod visits;
mod watch;
mod words;

pub(crate) use watch::Planned;

use crate::tasks::{find, known_names};
use etalon_base::error;
use etalon_base::message::{Message, Problems, Result};
use etalon_campaign::Campaign;
use etalon_view::{
    Answered, Asked, Desk, Event, Events, Found, Mesh, Proposal, Refusal, ShownMessage, State, Titles, WhatIf,
    WhatIfAsked,
};
use files::Dropped;
use opened::Opened;
use run::Ran;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An open page.
pub struct Session {
    folder: PathBuf,
    /// Pages that show it.
    pub events: Events,
    shown: Mutex<Shown>,
    running: AtomicBool,
    watching: AtomicBool,
    /// The session itself, for work that goes on after an answer.
    own: std::sync::Weak<Self>,
}

/// Contents of the page.
#[derive(Default)]
struct Shown {
    version: u64,
    dropped: Dropped,
    campaign: Option<Arc<Campaign>>,
    opened: Option<Arc<Opened>>,
    ran: Option<Ran>,
    messages: Vec<Message>,
}

impl Session {
    /// Opens the page of a folder, with the campaign in it, if there is one.
    pub fn open(folder: &Path) -> Arc<Self> {
        let session = Arc::new_cyclic(|own| Self {
            folder: folder.to_owned(),
            events: Events::default(),
            shown: Mutex::default(),
            running: AtomicBool::new(false),
            watching: AtomicBool::new(false),
            own: own.clone(),
        });
        session.reopen();
        session
    }

    fn shown(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn has_campaign(&self) -> bool {
        self.folder.join("campaign.toml").is_file()
    }

    /// Reads the campaign again, and tells the page.
    fn reopen(&self) {
        if self.has_campaign() {
            let read = Contents::read(&self.folder, Depth::Whole);
            let mut shown = self.shown();
            (shown.campaign, shown.opened, shown.ran) = (read.campaign, read.opened, read.ran);
            shown.messages = read.messages;
        }
        self.tell();
    }

    /// Tells the page that its state has changed.
    fn tell(&self) {
        let version = {
            let mut shown = self.shown();
            shown.version += 1;
            shown.version
        };
        self.events.send(&Event::State { version });
    }

    /// Messages of the program in the language of the page.
    fn refusal(&self, problems: &Problems) -> Refusal {
        Refusal(words::shown(&problems.0, self.language()))
    }

    fn opened(&self) -> Answered<Arc<Opened>> {
        // the lock is released before the refusal asks for the language
        let opened = self.shown().opened.clone();
        opened.ok_or_else(|| self.refusal(&error!("view-not-identified").into()))
    }
}

/// Folder of the page as the user named it; the present one by its own name.
fn shown_folder(folder: &Path) -> String {
    let present = || Some(folder.canonicalize().ok()?.file_name()?.to_string_lossy().into_owned());
    let named = Some(folder).filter(|folder| *folder != Path::new("."));
    named.map(|folder| folder.display().to_string()).or_else(present).unwrap_or_default()
}

/// A campaign as far as it can be read.
#[derive(Default)]
struct Contents {
    campaign: Option<Arc<Campaign>>,
    opened: Option<Arc<Opened>>,
    ran: Option<Ran>,
    messages: Vec<Message>,
}

/// Depth of reading a campaign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Depth {
    /// With the last run, outliers, and every error.
    Whole,
    /// Between two poses of a measurement: the identification, or the first error.
    Quick,
}

impl Contents {
    fn read(folder: &Path, depth: Depth) -> Self {
        let all_problems = |folder: &Path, first: Problems| match depth {
            Depth::Whole => all_problems(folder, first),
            Depth::Quick => first.0,
        };
        let (campaign, problems) = match Campaign::recover(folder) {
            Ok(found) => found,
            Err(problems) => return Self { messages: problems.0, ..Self::default() },
        };
        let Some(campaign) = campaign.filter(|_| problems.0.is_empty()) else {
            return Self { messages: all_problems(folder, problems), ..Self::default() };
        };
        let ran = if depth == Depth::Whole { Ran::stored(&campaign) } else { None };
        let campaign = Arc::new(campaign);
        if !campaign.identifies() {
            let messages = ran.as_ref().map_or_else(|| all_problems(folder, problems), |ran| ran.messages.clone());
            return Self { messages, campaign: Some(campaign), ran, opened: None };
        }
        match Opened::new(&campaign, depth == Depth::Whole) {
            Ok(opened) => {
                let messages = ran.as_ref().map_or_else(|| opened.messages(), |ran| ran.messages.clone());
                Self { campaign: Some(campaign), opened: Some(Arc::new(opened)), ran, messages }
            }
            Err(problems) => {
                Self { messages: all_problems(folder, problems), campaign: Some(campaign), ran: None, opened: None }
            }
        }
    }
}

/// Messages of a check, which finds every error; `first` if it finds none.
fn all_problems(folder: &Path, first: Problems) -> Vec<Message> {
    let (_, found) = find(&folder.join("campaign.toml"));
    if found.0.is_empty() { first.0 } else { found.grouped().0 }
}

impl Desk for Session {
    fn language(&self) -> &'static str {
        let campaign = self.shown().campaign.clone();
        campaign.map_or_else(words::language_of_user, |campaign| campaign.file.report.language.code())
    }

    fn state(&self) -> State {
        let language = self.language();
        let has_campaign = self.has_campaign();
        let shown = self.shown();
        let campaign = shown.campaign.as_deref();
        let opened = shown.opened.as_deref();
        State {
            version: shown.version,
            etalon: env!("CARGO_PKG_VERSION").to_owned(),
            language: language.to_owned(),
            mode: match (has_campaign, files::inputs(&self.folder, &shown.dropped).is_empty()) {
                (true, _) => "campaign",
                (false, false) => "proposed",
                (false, true) => "empty",
            },
            folder: shown_folder(&self.folder),
            titles: Titles {
                name: campaign.map(|campaign| campaign.file.name.clone()),
                synthetic: campaign.map(|campaign| campaign.file.synthetic.is_some()),
                watching: self.watching.load(Ordering::SeqCst),
                robots: if has_campaign { Vec::new() } else { known_names().unwrap_or_default() },
            },
            files: files::listed(&self.folder, campaign, &shown.dropped),
            messages: words::shown(&shown.messages, language),
            verdict: shown.ran.as_ref().map(|ran| ran.verdict.clone()),
            downloads: shown.ran.as_ref().map_or_else(Vec::new, |ran| ran.downloads.clone()),
            meshes: Vec::new(),
            found: Found {
                scene: opened.map(|opened| opened.scene.clone()),
                parameters: opened.map(|opened| opened.parameters(language)),
                maximum: opened.and_then(Opened::maximum),
                split: opened.and_then(Opened::split),
            },
        }
    }

    fn meshes(&self) -> Vec<Mesh> {
        // a large mesh takes a while: the page goes on
        let meshes = self.shown().opened.as_ref().map(|opened| opened.meshes.clone());
        meshes.unwrap_or_default().read()
    }

    fn add_file(&self, name: &str, bytes: &[u8]) -> Answered<State> {
        let added = self.shown().dropped.add(&self.folder, name, bytes);
        added.map_err(|problems| self.refusal(&problems))?;
        self.tell();
        Ok(self.state())
    }

    fn remove_file(&self, name: &str) -> Answered<State> {
        let removed = self.shown().dropped.remove(&self.folder, name);
        removed.map_err(|problems| self.refusal(&problems))?;
        self.tell();
        Ok(self.state())
    }

    fn propose(&self, asked: &Asked) -> Answered<Proposal> {
        let language = self.language();
        // a proposal may take seconds: the page goes on
        let dropped = self.shown().dropped.clone();
        let proposed = proposal::propose(&self.folder, &dropped, asked, language);
        proposed.map_err(|problems| self.refusal(&problems))
    }

    fn accept(&self, asked: &Asked) -> Answered<State> {
        let dropped = self.shown().dropped.clone();
        let accepted = proposal::accept(&self.folder, &dropped, asked);
        accepted.map_err(|problems| self.refusal(&problems))?;
        self.reopen();
        Ok(self.state())
    }

    fn check(&self) -> Vec<ShownMessage> {
        if !self.has_campaign() {
            return words::shown(&[error!("view-without-campaign")], self.language());
        }
        let (checked, problems) = find(&self.folder);
        let warnings = checked.map_or_else(Vec::new, |checked| checked.inputs.messages);
        let all = Problems(problems.0.into_iter().chain(warnings).collect()).grouped();
        words::shown(&all.0, self.language())
    }

    fn run(&self) -> Answered<()> {
        let (true, Some(session)) = (self.has_campaign(), self.own.upgrade()) else {
            return Err(self.refusal(&error!("view-without-campaign").into()));
        };
        if self.running.swap(true, Ordering::SeqCst) {
            return Err(self.refusal(&error!("view-run-in-progress").into()));
        }
        let work = move || {
            session.compute();
            session.running.store(false, Ordering::SeqCst);
            session.tell();
        };
        if std::thread::Builder::new().name("run".to_owned()).spawn(work).is_err() {
            self.running.store(false, Ordering::SeqCst);
        }
        Ok(())
    }

    fn what_if(&self, asked: &WhatIfAsked) -> Answered<WhatIf> {
        let opened = self.opened()?;
        changes::what_if(&opened, asked, self.language()).map_err(|problems| self.refusal(&problems))
    }

    fn keep(&self, asked: &WhatIfAsked, reason: &str) -> Answered<String> {
        let opened = self.opened()?;
        let kept = changes::keep(&opened, asked, reason).map_err(|problems| self.refusal(&problems))?;
        self.reopen();
        Ok(kept)
    }

    fn download(&self, name: &str) -> Option<Vec<u8>> {
        let shown = self.shown();
        let ran = shown.ran.as_ref()?;
        ran.downloads.iter().find(|offered| offered.name == name)?;
        etalon_base::files::read(&ran.folder.join(name)).ok()
    }
}

impl Session {
    /// Runs the campaign, and shows its results.
    fn compute(&self) {
        let language = self.language();
        let done = self.compute_results(&|text| {
            self.events.send(&Event::Progress { text: text.text(language), share: None });
        });
        match done {
            Ok(contents) => {
                let mut shown = self.shown();
                (shown.campaign, shown.opened, shown.ran) = (contents.campaign, contents.opened, contents.ran);
                shown.messages = contents.messages;
            }
            Err(problems) => {
                let mut shown = self.shown();
                shown.ran = None;
                shown.messages = problems.0;
            }
        }
    }

    fn compute_results(&self, progress: &dyn Fn(etalon_base::catalogue::Phrase)) -> Result<Contents> {
        let campaign = Campaign::read(&self.folder)?;
        let ran = Ran::new(&campaign, progress)?;
        let opened = Opened::new(&campaign, true).ok().map(Arc::new);
        let messages = ran.messages.clone();
        Ok(Contents { campaign: Some(Arc::new(campaign)), opened, ran: Some(ran), messages })
    }
}
