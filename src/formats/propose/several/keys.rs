//! Joins of exports with logs by the keys of their rows.

use super::part::Part;
use crate::export::{LabelNames, Pattern};
use crate::propose::labels::{ALONE, Labels, NUMBER, are_numbers};
use crate::propose::meaning::Meaning;
use std::collections::BTreeSet;

/// Keys of the rows of a file by which it can be joined.
#[derive(Default)]
pub(in crate::propose) struct Keys {
    pub rows: usize,
    pub poses: Option<Vec<String>>,
    /// `true` if the poses are the numbers of the rows.
    pub by_row: bool,
    pub cycles: Option<Vec<String>>,
    pub labels: Option<Vec<String>>,
    pub times: Option<Vec<f64>>,
    /// Form of the labels, and the targets that the labels name.
    pub form: Option<(String, Vec<String>)>,
    /// Labels of stationary points among the labels of targets.
    pub still: Vec<String>,
}

/// Join of an export with a log.
pub(in crate::propose) struct Join {
    pub by: &'static str,
    /// Number of rows of the export with a key, and of those with a row of the log.
    pub keys: usize,
    pub matching: usize,
    /// Rows of export and log that belong together.
    pub pairs: Vec<(usize, usize)>,
    /// Form of the labels whose `{pose}` is the label of the log.
    pub form: Option<String>,
    /// `true` if the labels of the log are names of poses.
    pub names_poses: bool,
}

impl Keys {
    pub fn new(part: &Part) -> Self {
        let Some((table, found)) = &part.read else {
            return Self { rows: part.document.rows, ..Self::default() };
        };
        let column = |meaning: Meaning| found.first(meaning).map(|at| table.columns[at].texts());
        let labels = column(Meaning::Label);
        // of a column of targets, each may have the number of a pose once
        let of_targets = |labels: &Vec<String>| {
            let targets = column(Meaning::Target)?;
            let rows: BTreeSet<(&String, &String)> = targets.iter().zip(labels).collect();
            (are_numbers(labels) && rows.len() == labels.len()).then(|| (NUMBER.to_owned(), Vec::new()))
        };
        let mut still = Vec::new();
        let form = labels.as_ref().and_then(|labels| {
            of_targets(labels).or_else(|| {
                let found = Labels::new(labels)?;
                still = found.still;
                Some((found.form, found.targets))
            })
        });
        let pattern = form.as_ref().and_then(|(form, _)| Pattern::parse(form).ok());
        let of_labels = |of: &dyn Fn(LabelNames) -> Option<String>| -> Option<Vec<String>> {
            let pattern = pattern.as_ref()?;
            let key = |label: &String| match still.contains(label) {
                true => Some(String::new()),
                false => of(pattern.read(label, |_| false)?),
            };
            labels.as_ref()?.iter().map(key).collect()
        };
        let is_log = part.document.kind == "log";
        // a log contains poses in a column
        let of_labels = |of: &dyn Fn(LabelNames) -> Option<String>| of_labels(of).filter(|_| !is_log);
        let mut poses = column(Meaning::Pose).or_else(|| of_labels(&|named| Some(named.pose?.to_string())));
        let by_row = poses.is_none() && labels.is_none() && part.document.kind == "export";
        if by_row {
            poses = Some((1..=table.rows).map(|row| row.to_string()).collect());
        }
        let cycles = column(Meaning::Cycle).or_else(|| of_labels(&|named| Some(named.cycle?.to_string())));
        let ordered = |at: &usize| table.columns[*at].is_ordered();
        let times = found.first(Meaning::Time).filter(ordered).map(|at| table.columns[at].values.clone());
        Self { rows: table.rows, poses, by_row, cycles, labels, times, form, still }
    }

    /// Number of poses that the rows name.
    pub fn pose_count(&self) -> usize {
        self.poses.iter().flatten().filter(|pose| !pose.is_empty()).collect::<BTreeSet<&String>>().len()
    }

    /// Targets that the labels name.
    pub fn targets(&self) -> &[String] {
        self.form.as_ref().map_or(&[], |(_, targets)| targets)
    }

    /// Names of points that were measured several times, if the labels name no pose.
    pub fn stationary(&self) -> Option<&[String]> {
        let (form, names) = self.form.as_ref()?;
        (form == ALONE).then_some(names)
    }
}
