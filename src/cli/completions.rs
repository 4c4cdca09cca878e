//! `etalon completions`.

use super::{Output, Verdict};
use clap_complete::aot::{Shell, generate};

/// Print the completions of a shell.
#[derive(Debug, clap::Args)]
#[command(after_help = "To load them:
  bash        etalon completions bash > ~/.local/share/bash-completion/completions/etalon
  zsh         etalon completions zsh > \"${fpath[1]}/_etalon\"
  fish        etalon completions fish > ~/.config/fish/completions/etalon.fish
  powershell  etalon completions powershell >> $PROFILE")]
pub struct Completions {
    /// Shell.
    shell: Shell,
}

impl Completions {
    pub(super) fn run(self, out: &Output) -> anyhow::Result<Verdict> {
        let mut script = Vec::new();
        generate(self.shell, &mut super::command(), "etalon", &mut script);
        out.print(script)?;
        Ok(Verdict::Met)
    }
}
