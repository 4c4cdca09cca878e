//! `etalon schema`

use super::{Verdict, print};
use crate::base::message::{Message, Problems};

/// Print the JSON Schema of a document
#[derive(Debug, clap::Args)]
pub struct Schema {
    /// Name of the document, e.g. parameters
    document: String,
    /// Change nothing: a schema is JSON
    #[arg(long)]
    json: bool,
}

impl Schema {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        let all = crate::document::schema::all();
        let (_, text) = all.iter().find(|(name, _)| *name == self.document).ok_or_else(|| {
            let message = Message::error(format!("there is no document `{}`", self.document));
            Problems::from(message.hint_names(&self.document, all.iter().map(|(name, _)| *name)))
        })?;
        print(text)?;
        Ok(Verdict::Met)
    }
}
