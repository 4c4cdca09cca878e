//! Calls of the page that the program answers.

use crate::contract::{Asked, Mesh, Proposal, ShownMessage, State, WhatIf, WhatIfAsked};

/// Reasons why a call is rejected.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal(pub Vec<ShownMessage>);

/// Answer to a call.
pub type Answered<T> = Result<T, Refusal>;

/// The program behind the page. Names of files have no separators of folders.
pub trait Desk: Send + Sync {
    /// All that the page shows.
    fn state(&self) -> State;

    /// Meshes of the parts that the scene names.
    fn meshes(&self) -> Vec<Mesh>;

    /// Stores a file in the folder of the page.
    ///
    /// # Errors
    /// Rejects a name that another file has, and files beyond the bounds of the folder.
    fn add_file(&self, name: &str, bytes: &[u8]) -> Answered<State>;

    /// Removes a file that was dropped on the page.
    ///
    /// # Errors
    /// Rejects every other file.
    fn remove_file(&self, name: &str) -> Answered<State>;

    /// Proposes a campaign from the dropped files.
    ///
    /// # Errors
    /// Rejects files without measurements.
    fn propose(&self, asked: &Asked) -> Answered<Proposal>;

    /// Writes the proposed campaign with these answers.
    ///
    /// # Errors
    /// Rejects like [`Desk::propose`].
    fn accept(&self, asked: &Asked) -> Answered<State>;

    /// Checks the campaign without computing.
    fn check(&self) -> Vec<ShownMessage>;

    /// Starts a run, whose progress and end are events.
    ///
    /// # Errors
    /// Rejects without a campaign, or while a run is in progress.
    fn run(&self) -> Answered<()>;

    /// Identifies again with other data or parameters.
    ///
    /// # Errors
    /// Rejects unknown names, and what leaves nothing to identify.
    fn what_if(&self, asked: &WhatIfAsked) -> Answered<WhatIf>;

    /// Writes `asked` into the campaign, and returns the difference.
    ///
    /// # Errors
    /// Rejects an exclusion without a reason.
    fn keep(&self, asked: &WhatIfAsked, reason: &str) -> Answered<String>;

    /// A file of the output folder that [`State::downloads`] lists; `None` for any other name.
    fn download(&self, name: &str) -> Option<Vec<u8>>;

    /// Language of messages.
    fn language(&self) -> &'static str;
}
