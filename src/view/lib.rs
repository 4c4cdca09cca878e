//! The page of `etalon view`: its server on the loopback interface, and the documents that page and
//! program exchange.
//!
//! The server knows no campaign: every request of the page calls a [`Desk`], which the program
//! implements. Whatever reaches the server may come from another page of the user's browser or from
//! another process. It therefore answers requests with its own random token alone, and all sizes,
//! times and numbers of connections are bounded.

mod contract;
mod desk;
mod http;
mod page;
mod shared;
#[cfg(test)]
mod tests;

use http::{answer, connection, events, refusals, request, routes, server};

pub use contract::{
    Asked, Changed, ColumnRead, Download, DroppedFile, FileProposal, Found, Instrument, JointScale, Keep, LargestError,
    Latest, Maximum, Mesh, Named, NamedPose, Next, Parameter, ParameterNow, Place, Point, PointErrors, PointNow, Pose,
    PoseSet, Proposal, Question, QuestionOption, Scene, Severity, ShownMessage, Split, State, Stop, Stroke, Titles,
    Tone, Verdict, Watch, WhatIf, WhatIfAsked,
};
pub use desk::{Answered, Desk, Refusal};
pub use events::{Event, Events};
pub use page::exported;
pub use server::Server;
pub use shared::Limits;
