//! Parallel projection of points from a direction of view to paper.

use super::axis::range;
use super::svg::Place;
use etalon_base::pose::Vector;

/// A direction of view.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    /// Azimuth of the viewer about z from x, and elevation above the horizon (rad).
    pub azimuth_rad: f64,
    pub elevation_rad: f64,
}

/// View from the front, the right and above: x to the right, y away, z up.
pub(super) const ASLANT: View = View { azimuth_rad: -1.0, elevation_rad: 0.5 };
/// View onto the plane z = 0.
pub(super) const ABOVE: View =
    View { azimuth_rad: -std::f64::consts::FRAC_PI_2, elevation_rad: std::f64::consts::FRAC_PI_2 };

impl View {
    /// Horizontal and vertical position (mm).
    pub fn flat(self, [x, y, z]: Vector) -> Place {
        let ((sin_a, cos_a), (sin_e, cos_e)) = (self.azimuth_rad.sin_cos(), self.elevation_rad.sin_cos());
        (cos_a * y - sin_a * x, cos_e * z - sin_e * (cos_a * x + sin_a * y))
    }
}

/// Positions on paper, fitted into a width.
#[derive(Clone, Copy, Debug)]
pub(super) struct Paper {
    /// Units of the figure per mm.
    pub scale: f64,
    middle: Place,
    centre: Place,
    pub height: f64,
}

impl Paper {
    /// Fits `flat` (mm) into `width` units minus a margin on every side, and at most `most` units
    /// of height.
    pub fn around(flat: &[Place], width: f64, most: f64, margin: f64) -> Self {
        let [x0, x1] = range(flat.iter().map(|p| p.0)).unwrap_or_default();
        let [y0, y1] = range(flat.iter().map(|p| p.1)).unwrap_or_default();
        let room = |units: f64, mm: f64| (units - 2.0 * margin) / mm.max(1e-9);
        let scale = room(width, x1 - x0).min(room(most, y1 - y0)).min(1e6);
        let height = (y1 - y0) * scale + 2.0 * margin;
        Self { scale, middle: ((x0 + x1) / 2.0, (y0 + y1) / 2.0), centre: (width / 2.0, height / 2.0), height }
    }

    /// Position of a point on paper.
    pub fn at(&self, flat: Place) -> Place {
        let along = |k: f64, middle: f64| self.scale * (k - middle);
        (self.centre.0 + along(flat.0, self.middle.0), self.centre.1 - along(flat.1, self.middle.1))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn from_above_x_is_right_and_y_is_up_and_aslant_z_is() {
        let near = |(a, b): Place, (c, d): Place| (a - c).abs() < 1e-12 && (b - d).abs() < 1e-12;
        assert!(near(ABOVE.flat([2.0, 3.0, 9.0]), (2.0, 3.0)));
        let (x, y) = ASLANT.flat([0.0, 0.0, 1.0]);
        assert!(x.abs() < 1e-12 && y > 0.5);
        assert!(ASLANT.flat([1.0, 0.0, 0.0]).0 > 0.5 && ASLANT.flat([0.0, 1.0, 0.0]).1 > 0.3);
    }
}
