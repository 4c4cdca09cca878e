//! Bodies in the way of the instrument, from options.

use super::*;
use etalon_base::pose::Pose;
use etalon_identify::plan::obstacles::Shape;

/// A body that does not move.
#[derive(Clone, Debug)]
pub(in crate::cli::plan) struct StatedObstacle {
    name: String,
    shape: Shape,
    /// Shape and numbers of the option.
    text: String,
}

/// The link that a joint moves.
#[derive(Clone, Debug)]
pub(in crate::cli::plan) struct StatedLink {
    joint: String,
    radius_mm: f64,
    /// Ends in the base at joint values zero; by default origins of frames.
    ends_mm: Option<[Vector; 2]>,
    text: String,
}

impl Generation {
    /// Bodies in the way of the instrument: first the bodies that do not move, then links.
    pub(super) fn obstacles(&self, robot: &dyn Robot, instrument_mm: Vector) -> Result<Vec<Obstacle>> {
        let mut all: Vec<Obstacle> = Vec::new();
        for stated in &self.obstacles {
            if stated.shape.contains(instrument_mm) {
                return Err(error!("instrument-inside-obstacle", name = &stated.name).into());
            }
            all.push(Obstacle { name: stated.name.clone(), shape: stated.shape.clone(), joint: None });
        }
        for stated in &self.links {
            all.push(self.link(robot, stated)?);
        }
        let twice = (1..all.len()).find(|&i| all[..i].iter().any(|before| before.name == all[i].name));
        twice.map_or(Ok(()), |i| Err(error!("obstacle-twice", name = &all[i].name)))?;
        Ok(all)
    }

    fn link(&self, robot: &dyn Robot, stated: &StatedLink) -> Result<Obstacle> {
        let joints = robot.joints();
        let chain = robot.joint_chain(&robot.nominal()).filter(|chain| chain.joints.len() == joints.len());
        let chain = chain.ok_or_else(|| error!("links-unsuited", model = robot.model()))?;
        let names = joints.iter().map(|joint| joint.name.as_str());
        let Some(joint) = names.clone().position(|name| name == stated.joint) else {
            return Err(error!("link-joint-unknown", joint = &stated.joint).hint_names(&stated.joint, names).into());
        };
        let next = chain.joints.get(joint + 1).map_or(&chain.flange, |next| &next.origin);
        let ends = match stated.ends_mm {
            Some(ends) => {
                let back = chain.frames(&vec![0.0; joints.len()])[joint].inverse();
                ends.map(|end| back.apply(end))
            }
            None => [[0.0; 3], next.translation_mm],
        };
        let shape = Shape::Capsule { ends, radius: stated.radius_mm };
        if joint + 1 == joints.len() {
            self.check_reflectors(robot, &chain.flange, &shape, &stated.joint)?;
        }
        Ok(Obstacle { name: stated.joint.clone(), shape, joint: Some(joint) })
    }

    /// Rejects reflectors inside the link that carries them.
    fn check_reflectors(&self, robot: &dyn Robot, flange: &Pose, link: &Shape, joint: &str) -> Result<()> {
        let (Some(arm), nominal) = (robot.free_base(), robot.nominal()) else { return Ok(()) };
        for (target, reflector) in self.reflectors.iter().enumerate() {
            let first = arm.target_place(target);
            if link.contains(flange.apply([0, 1, 2].map(|i| nominal[first + i]))) {
                return Err(error!("reflector-inside-link", reflector = &reflector.name, joint).into());
            }
        }
        Ok(())
    }

    pub(super) fn planned_obstacles(&self, found: &Generated) -> Vec<PlannedObstacle> {
        let fixed = self.obstacles.iter().map(|stated| (&stated.name, &stated.text, false));
        let links = self.links.iter().map(|stated| (&stated.joint, &stated.text, true));
        let hidden = found.losses.hidden.iter();
        fixed
            .chain(links)
            .zip(hidden)
            .map(|((name, text, is_link), hidden)| PlannedObstacle {
                name: name.clone(),
                stated: text.clone(),
                is_link,
                hidden: *hidden,
            })
            .collect()
    }
}

/// Parses NAME=cylinder:RADIUS,X,Y,Z,X,Y,Z or NAME=box:DX,DY,DZ,X,Y,Z[,DEG].
pub(in crate::cli::plan) fn obstacle(text: &str) -> Parsed<StatedObstacle, String> {
    let expected = || {
        "expected NAME=cylinder:RADIUS,X,Y,Z,X,Y,Z or NAME=box:DX,DY,DZ,X,Y,Z[,DEG] with positive sizes (mm)".to_owned()
    };
    let (name, stated) = text.split_once('=').ok_or_else(expected)?;
    let (shape, numbers) = stated.split_once(':').ok_or_else(expected)?;
    let numbers: Option<Vec<f64>> = numbers.split(',').map(number).collect();
    let shape = match (shape.trim(), numbers.as_deref()) {
        ("cylinder", Some(&[radius, ref ends @ ..])) => {
            let ends = two_ends(ends).filter(|[from, to]| radius > 0.0 && from != to).ok_or_else(expected)?;
            Shape::Cylinder { ends, radius }
        }
        ("box", Some(&[dx, dy, dz, x, y, z, ref turned @ ..])) if turned.len() < 2 && dx.min(dy).min(dz) > 0.0 => {
            let turned = Pose::identity().turn_z(turned.first().map_or(0.0, |deg| deg.to_radians()));
            let centre = Pose { translation_mm: [x, y, z], ..turned };
            Shape::Box { centre, half: [dx, dy, dz].map(|edge| 0.5 * edge) }
        }
        _ => return Err(expected()),
    };
    let name = name.trim().to_owned();
    if name.is_empty() { Err(expected()) } else { Ok(StatedObstacle { name, shape, text: stated.to_owned() }) }
}

/// Parses JOINT=RADIUS or JOINT=RADIUS,X,Y,Z,X,Y,Z.
pub(in crate::cli::plan) fn link(text: &str) -> Parsed<StatedLink, String> {
    let expected = || "expected JOINT=RADIUS or JOINT=RADIUS,X,Y,Z,X,Y,Z with a positive radius (mm)".to_owned();
    let (joint, stated) = text.split_once('=').ok_or_else(expected)?;
    let numbers: Option<Vec<f64>> = stated.split(',').map(number).collect();
    let (radius_mm, ends_mm) = match numbers.as_deref() {
        Some(&[radius]) => (radius, None),
        Some(&[radius, ref ends @ ..]) => (radius, Some(two_ends(ends).ok_or_else(expected)?)),
        _ => return Err(expected()),
    };
    match radius_mm > 0.0 {
        true => Ok(StatedLink { joint: joint.trim().to_owned(), radius_mm, ends_mm, text: stated.to_owned() }),
        false => Err(expected()),
    }
}

/// Two points.
fn two_ends(numbers: &[f64]) -> Option<[Vector; 2]> {
    match *numbers {
        [a, b, c, d, e, f] => Some([[a, b, c], [d, e, f]]),
        _ => None,
    }
}
