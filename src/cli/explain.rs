//! Command `etalon explain`.

use super::{Output, Verdict};
use crate::tasks;
use etalon_documents::Explanation;
use std::fmt::Write;

/// Explain a message by its id, or list all messages.
#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  etalon explain                        list ids and texts
  etalon explain parameter-twice        meaning, consequence, remedy and an example")]
pub struct Explain {
    /// Id of the message, as shown in brackets: error[ID].
    id: Option<String>,
    /// Print the explanation as JSON.
    #[arg(long)]
    json: bool,
}

impl Explain {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let id = self.id.as_deref();
        let document = tasks::explain(id)?;
        let text = if id.is_some() { explained } else { listed };
        match self.json {
            true => out.print(etalon_documents::to_json(&document)?)?,
            false => out.print_text(&document.messages.iter().map(text).collect::<String>())?,
        }
        Ok(Verdict::Met)
    }
}

fn listed(message: &Explanation) -> String {
    format!("{}: {}\n", message.id, message.text)
}

fn explained(message: &Explanation) -> String {
    let mut out = listed(message);
    let labelled = [("expected", &message.expected), ("hint", &message.hint)];
    for (label, text) in labelled.into_iter().filter_map(|(label, text)| Some((label, text.as_ref()?))) {
        let _ = writeln!(out, "  {label}: {text}");
    }
    let Explanation { meaning, reason, action, example, .. } = message;
    out + &format!("\n{meaning}\n{reason}\n\nTypical case: {example}\nWhat to do: {action}\n")
}
