//! Commands by task, as `etalon --help` lists them.

use clap::builder::{StyledStr, Styles};
use std::fmt::Write;

/// Tasks in the order of a calibration, each with its commands.
const GROUPS: [(&str, &[&str]); 7] = [
    ("Start a campaign", &["init", "formats", "check", "simulate"]),
    ("Calibrate", &["run", "batch", "identify", "axes", "cell", "fit"]),
    ("Judge the result", &["view", "recommend", "validate", "verify", "uncertainty", "compare", "benchmark", "report"]),
    ("Load it into a controller", &["export", "compensate", "axis-table", "kinematics", "robot"]),
    ("Test by a standard", &["iso9283", "iso230"]),
    ("Plan measurements", &["plan", "study"]),
    ("Set up", &["selftest", "explain", "completions", "man", "schema", "help"]),
];

/// Widest line of the list.
const WIDTH: usize = 100;

/// The command line, its list of commands grouped by task.
pub(super) fn grouped(command: clap::Command) -> clap::Command {
    let mut command = command.styles(Styles::styled());
    command.build();
    let list = list(&command);
    command.help_template(format!(
        "{{about-with-newline}}\n{{usage-heading}} {{usage}}\n\n{list}\n\u{1b}[1m\u{1b}[4mOptions:\u{1b}[0m\n{{options}}{{after-help}}"
    ))
}

/// Groups of commands with the first line of their help.
fn list(command: &clap::Command) -> String {
    let header = command.get_styles().get_header();
    let name_style = command.get_styles().get_literal();
    let mut text = String::new();
    for (task, names) in GROUPS {
        let _ = writeln!(text, "{header}{task}:{header:#}");
        for name in names {
            let about = command.find_subcommand(name).and_then(clap::Command::get_about).map(StyledStr::to_string);
            let lines = wrap(&about.unwrap_or_default(), WIDTH - 15);
            let _ = writeln!(text, "  {name_style}{name:<11}{name_style:#}  {}", lines.join("\n               "));
        }
        text.push('\n');
    }
    text.truncate(text.trim_end().len() + 1);
    text
}

/// Lines of at most `width` characters.
fn wrap(text: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.chars().count() + 1 + word.chars().count() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::GROUPS;
    use clap::CommandFactory;

    #[test]
    fn every_command_is_in_one_group() {
        let mut grouped: Vec<&str> = GROUPS.iter().flat_map(|(_, names)| names.iter().copied()).collect();
        grouped.sort_unstable();
        let command = crate::cli::Arguments::command();
        let mut all: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).chain(["help"]).collect();
        all.sort_unstable();
        assert_eq!(grouped, all);
    }

    #[test]
    fn the_help_lists_commands_by_task() {
        let help = crate::cli::command().render_help().to_string();
        let place = |text: &str| help.find(text).unwrap_or_else(|| panic!("{text} is missing:\n{help}"));
        assert!(place("Start a campaign:") < place("  init ") && place("  init ") < place("Calibrate:"), "{help}");
        assert!(place("  schema ") < place("Options:") && place("Options:") < place("Examples:"), "{help}");
        assert!(help.lines().all(|line| line.chars().count() <= 110), "{help}");
    }
}
