//! Events of the program to all open pages (server-sent events, HTML 9.2).

use crate::contract::Watch;
use serde::Serialize;
use std::sync::mpsc::{Receiver, SyncSender, TrySendError, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};

/// An event.
#[derive(Clone, Debug)]
pub enum Event {
    /// Progress of a run.
    Progress {
        /// Text of the step.
        text: String,
        /// Share of the work that is done.
        share: Option<f64>,
    },
    /// The state has changed.
    State {
        /// Its version.
        version: u64,
    },
    /// State of a measurement in progress.
    Watch(Box<Watch>),
    /// The program ends.
    Bye,
}

/// Events that a page may leave unread before it is taken for closed.
const UNREAD: usize = 64;

/// All open pages.
#[derive(Clone, Debug, Default)]
pub struct Events(Arc<Mutex<Pages>>);

/// Open pages, and the last event about a measurement for pages that open later.
#[derive(Debug, Default)]
struct Pages {
    senders: Vec<SyncSender<Arc<str>>>,
    watch: Option<Arc<str>>,
}

impl Events {
    /// Sends an event to all pages.
    pub fn send(&self, event: &Event) {
        let Some(text) = event.text() else { return };
        let text: Arc<str> = text.into();
        let mut pages = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if matches!(event, Event::Watch(_)) {
            pages.watch = Some(text.clone());
        }
        // a page that reads nothing is closed
        pages.senders.retain(|page| match page.try_send(text.clone()) {
            Ok(()) => true,
            Err(TrySendError::Full(_) | TrySendError::Disconnected(_)) => false,
        });
    }

    /// Events from now on, for one page.
    pub(crate) fn listen(&self) -> Receiver<Arc<str>> {
        let (sender, receiver) = sync_channel(UNREAD);
        let mut pages = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        pages.watch.iter().for_each(|last| drop(sender.try_send(last.clone())));
        pages.senders.push(sender);
        receiver
    }
}

impl Event {
    /// The event as a page receives it; `None` if it cannot be written as JSON.
    fn text(&self) -> Option<String> {
        #[derive(Serialize)]
        struct Progress<'a> {
            text: &'a str,
            #[serde(skip_serializing_if = "Option::is_none")]
            share: Option<f64>,
        }
        #[derive(Serialize)]
        struct Version {
            version: u64,
        }
        let (name, data) = match self {
            Self::Progress { text, share } => ("progress", serde_json::to_string(&Progress { text, share: *share })),
            Self::State { version } => ("state", serde_json::to_string(&Version { version: *version })),
            Self::Watch(watch) => ("watch", serde_json::to_string(watch)),
            Self::Bye => ("bye", Ok("{}".to_owned())),
        };
        // JSON has no line feeds: it is one line of data
        Some(format!("event: {name}\ndata: {}\n\n", data.ok()?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_page_that_reads_nothing_is_dropped_and_others_read_on() {
        let events = Events::default();
        let (deaf, page) = (events.listen(), events.listen());
        for version in 0..UNREAD as u64 + 8 {
            events.send(&Event::State { version });
            assert_eq!(&*page.recv().unwrap(), format!("event: state\ndata: {{\"version\":{version}}}\n\n"));
        }
        assert_eq!(deaf.iter().count(), UNREAD, "the channel of a deaf page is closed");
    }

    #[test]
    fn a_page_that_opens_during_a_measurement_learns_its_state() {
        let events = Events::default();
        events.send(&Event::Watch(Box::new(Watch { received: 7, ..Watch::default() })));
        assert!(events.listen().recv().unwrap().contains("\"received\":7"));
    }
}
