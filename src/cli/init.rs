//! `etalon init`

use super::{Verdict, print};
use crate::files;
use crate::message::{Message, Problems};
use std::path::PathBuf;

/// Write a commented campaign to start from
#[derive(Debug, clap::Args)]
pub struct Init {
    /// New folder of the campaign
    folder: PathBuf,
}

const FILES: [(&str, &str); 2] =
    [("campaign.toml", include_str!("init/campaign.toml")), ("robot.toml", include_str!("init/robot.toml"))];

impl Init {
    pub(super) fn run(self) -> anyhow::Result<Verdict> {
        for (name, _) in FILES {
            let path = self.folder.join(name);
            if path.exists() {
                let message = Message::error(format!("`{}` is there already", path.display()));
                return Err(Problems::from(message.hint("name a new folder")).into());
            }
        }
        for (name, text) in FILES {
            let path = self.folder.join(name);
            files::write(&path, text.as_bytes())?;
            print(format!("{}\n", path.display()))?;
        }
        Ok(Verdict::Met)
    }
}
