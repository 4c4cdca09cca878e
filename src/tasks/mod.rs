//! Commands as functions: tables and typed options in, a document out. Nothing is printed.
//!
//! The options of a task are one type: [`cli`](crate::cli) flattens it into its command line, and
//! [`parse_options`] reads it from the keyword arguments of a program.

mod axes;
pub(crate) mod benchmark;
mod bound;
mod call;
mod campaign;
mod cell;
mod check;
pub(crate) mod checks;
mod explain;
mod fit;
mod identify;
mod inputs;
mod iso230;
mod iso9283;
pub(crate) mod kinematics;
pub(crate) mod known_robots;
mod model;
mod path;
mod plan;
mod schema;
pub(crate) mod start;
pub(crate) mod text_format;
pub(crate) mod validity;
mod verify;

pub use crate::stages::verify::predicted::{PredictedOrientation, PredictedPosition, Prediction};
pub use axes::{AxesOptions, axes};
pub use benchmark::{predict, score};
pub use bound::BoundOption;
pub use call::parse_options;
pub use campaign::{Document, GivenParameters, Ran, ValidateOptions, run, validate};
pub use cell::{CellOptions, cell};
pub use check::check;
pub(crate) use check::find;
pub use explain::explain;
pub use fit::{Criterion, Figure, Fitted, fit, named_side, stated_probe};
pub use identify::{Identified, IdentifyOptions, identify};
pub use inputs::{Inputs, Table};
pub(crate) use iso230::evaluate as evaluate_axis;
pub use iso230::iso230;
pub use iso9283::{PoseOptions, TestTables, iso9283};
pub use kinematics::{Arm, Solutions, Twists, inverse, stated_parameters, whole_pose};
pub use known_robots::{default_chain, known_names, known_text, urdf_text};
pub use model::ModelOptions;
pub(crate) use path::evaluate as evaluate_path;
pub use path::{RecordingTables, StreamOptions, iso9283_path};
pub use plan::{PlanOptions, SearchOptions, plan};
pub(crate) use plan::{Simulation, choose, read_candidates};
pub use schema::schema;
pub use text_format::{TableFormat, TextForm, TextFormat};
pub use verify::{VerifyOptions, plan_verification, verify, verify_new};
