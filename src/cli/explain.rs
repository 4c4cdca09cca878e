//! Command `etalon explain`.

use super::{Output, Verdict};
use etalon_base::catalogue::{Entry, entries};
use etalon_base::error;
use etalon_base::message::Problems;
use etalon_documents::{Explanation, ExplanationDocument};
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
        let messages: Vec<Entry> = entries().into_iter().filter(Entry::is_message).collect();
        let Some(id) = &self.id else {
            let document = ExplanationDocument::new(&messages);
            return answer(self.json, out, &document, |all| {
                all.iter().map(|message| format!("{}: {}\n", message.id, message.text)).collect()
            });
        };
        let entry = messages.iter().find(|entry| entry.id == id).ok_or_else(|| {
            let message = error!("message-unknown", id);
            Problems::from(message.hint_names(id, messages.iter().map(|entry| entry.id)))
        })?;
        answer(self.json, out, &ExplanationDocument::new([entry]), |all| all.iter().map(explained).collect())
    }
}

fn answer(
    json: bool,
    out: &Output,
    document: &ExplanationDocument,
    text: impl Fn(&[Explanation]) -> String,
) -> anyhow::Result<Verdict> {
    match json {
        true => out.print(etalon_documents::to_json(document)?)?,
        false => out.print_text(&text(&document.messages))?,
    }
    Ok(Verdict::Met)
}

fn explained(message: &Explanation) -> String {
    let mut out = format!("{}: {}\n", message.id, message.text);
    let labelled = [("expected", &message.expected), ("hint", &message.hint)];
    for (label, text) in labelled.into_iter().filter_map(|(label, text)| Some((label, text.as_ref()?))) {
        let _ = writeln!(out, "  {label}: {text}");
    }
    let Explanation { meaning, reason, action, example, .. } = message;
    out + &format!("\n{meaning}\n{reason}\n\nTypical case: {example}\nWhat to do: {action}\n")
}
