//! Contact of the target with a socket.

use super::{At, Condition, Equation, Kind, SHORTEST, point};
use etalon_base::pose::{Vector, dot, minus};
use etalon_math::Factor;
use etalon_robots::FreeBase;

/// Contact of the target with a socket. Residuals: the three coordinates of the target minus the
/// coordinates of the socket (mm).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// First of the three coordinates of the socket.
    pub socket: usize,
}

impl Equation for Contact {
    fn rows(&self) -> usize {
        3
    }

    fn unknowns(&self) -> Vec<usize> {
        (self.socket..self.socket + 3).collect()
    }

    fn residuals(&self, at: &At, out: &mut [f64]) {
        out.copy_from_slice(&minus(at.position, point(at.values, self.socket)));
    }

    fn jacobian(&self, at: &At, moved: &[f64], out: &mut [f64]) {
        out.copy_from_slice(moved);
        (0..3).for_each(|i| out[i * at.values.len() + self.socket + i] -= 1.0);
    }

    fn gaps(&self, values: &[f64], p: Vector, left: Vector) -> Vec<(Vector, f64)> {
        let axis = |k: usize| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 });
        (0..3).map(|k| (axis(k), p[k] - values[self.socket + k] - left[k])).collect()
    }
}

/// Targets and sockets, by their first parameters, for which contacts close: linear in both at
/// given joints.
pub(crate) fn locate_contacts(arm: &dyn FreeBase, contacts: &[&Condition], unknown: &[usize], values: &mut [f64]) {
    if unknown.is_empty() {
        return;
    }
    let column = |first: usize| unknown.iter().position(|&u| u == first);
    let (mut a, mut b) = (Vec::new(), Vec::new());
    for c in contacts {
        let Kind::Contact(Contact { socket }) = c.kind else { continue };
        let (flange, target) = (arm.flange(values, &c.joints, c.target), arm.target_place(c.target));
        for i in 0..3 {
            let mut row = vec![0.0; 3 * unknown.len()];
            let mut rest = -flange.translation_mm[i];
            match column(target) {
                Some(k) => row[3 * k..][..3].copy_from_slice(&flange.rotation[i]),
                None => rest -= dot(flange.rotation[i], point(values, target)),
            }
            match column(socket) {
                Some(k) => row[3 * k + i] = -1.0,
                None => rest += values[socket + i],
            }
            a.extend(row);
            b.push(rest);
        }
    }
    let factor = Factor::new(&a, &b, &vec![1.0; 3 * unknown.len()]);
    let Some(found) = factor.damped(SHORTEST).solve() else { return };
    for (k, &first) in unknown.iter().enumerate() {
        values[first..first + 3].copy_from_slice(&found[3 * k..][..3]);
    }
}
