//! Tables of a test of poses, as a command is given them or a campaign names them: what was attained, what was commanded, and
//! targets that stand still.

use crate::base::message::{Problems, Result};
use crate::campaign::PosesDefinition;
use crate::document::{Iso9283Document, Iso9283Visit};
use crate::import::tables::reference_targets::{CarriedBack, carry_back};
use crate::import::tables::visits::Visits;
use crate::stages::iso9283::pose::{self, Settings};
use crate::stages::table_file::{CampaignTables, TableFile};
use std::path::Path;
use toml::Spanned;

/// The tables.
pub(crate) struct PoseTables {
    attained: TableFile,
    commanded: TableFile,
    reference: Option<TableFile>,
}

/// Their visits, compensated for the drift of the set-up where reference targets are among them.
#[derive(Clone, Debug)]
pub(crate) struct Ready {
    visits: Visits,
    carried: CarriedBack,
}

impl PoseTables {
    /// Those of a command.
    pub fn read(attained: &Path, commanded: &Path, reference: Option<&Path>) -> Result<Self> {
        Ok(Self {
            attained: TableFile::read(attained)?,
            commanded: TableFile::read(commanded)?,
            reference: reference.map(TableFile::read).transpose()?,
        })
    }

    /// Those of a campaign; everything that does not read is reported.
    pub fn of_campaign(files: &mut CampaignTables, definition: &PosesDefinition) -> Result<Self> {
        let mut problems = Problems::default();
        let mut read = |file: &Spanned<String>, holds: &str| {
            files.read(file, holds).map_err(|more| problems.0.extend(more.0)).ok()
        };
        let attained = read(&definition.attained, "attained poses");
        let commanded = read(&definition.commanded, "commanded poses");
        let reference = definition.reference.as_ref().map(|file| read(file, "reference targets"));
        let (Some(attained), Some(commanded)) = (attained, commanded) else { return Err(problems) };
        problems.check()?;
        Ok(Self { attained, commanded, reference: reference.flatten() })
    }

    /// The visits that they tell, with everything that is wrong with them at its line.
    pub fn visits(&self, rotation_order: Option<&str>) -> Result<Ready> {
        let (attained, commanded) = (&self.attained, &self.commanded);
        let mut visits =
            Visits::from_tables(attained.named(), commanded.named()).map_err(|p| commanded.place(attained.place(p)))?;
        let carried = match &self.reference {
            None => CarriedBack::default(),
            Some(targets) => carry_back(&mut visits, targets.named(), rotation_order).map_err(|p| targets.place(p))?,
        };
        Ok(Ready { visits, carried })
    }
}

impl Ready {
    /// All characteristics of these visits.
    pub fn evaluate(&self, settings: &Settings) -> Result<Iso9283Document> {
        let Self { visits, carried } = self;
        let mut document = pose::evaluate(visits, settings)?;
        if !carried.epochs.is_empty() {
            let said = match (carried.turned, visits.angles.is_empty()) {
                (true, _) => "positions and orientations are carried back by reference targets",
                (false, true) => "positions are carried back by reference targets",
                (false, false) => "positions are carried back by reference targets; angles are not",
            };
            document.conventions.push(said.to_owned());
        }
        document.reference.clone_from(&carried.epochs);
        Ok(document)
    }

    /// Whether there are enough cycles for the drift over sets of so many.
    pub fn drifts(&self, set: usize) -> Result<()> {
        pose::drifts(&self.visits, Some(set)).map(|_| ())
    }

    /// Every visit that is told of, pose by pose.
    pub fn told(&self) -> Vec<Iso9283Visit> {
        let of_pose = |p: &crate::import::tables::visits::PoseVisits| {
            let pose = p.pose;
            let told = move |v: &crate::import::tables::visits::Visit| Iso9283Visit {
                pose,
                cycle: v.cycle,
                approach: v.approach.clone(),
                attained_mm: v.position_mm,
            };
            p.visits.iter().map(told).collect::<Vec<_>>()
        };
        pose::of_first_robot(&self.visits).poses.iter().flat_map(of_pose).collect()
    }
}
