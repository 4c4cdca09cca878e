//! Points on elements, from a seed.

use etalon::fit::Element;
use etalon::base::noise::Noise;

/// The truth: radius 50 mm about (300, -200, 100) mm, along (0.6, 0, 0.8), with 5 µm of noise.
const CENTER: [f64; 3] = [300.0, -200.0, 100.0];
const RADIUS: f64 = 50.0;
const NOISE: f64 = 0.005;

/// Where peers that need a start begin: off by half a millimetre, one degree and 2 %.
pub const START_CENTER: [f64; 3] = [300.5, -200.4, 100.0];
pub const START_AXIS: [f64; 3] = [0.61, 0.012, 0.79];
pub const START_RADIUS: f64 = 51.0;

pub enum Points {
    Plane(Vec<[f64; 2]>),
    Space(Vec<[f64; 3]>),
}

impl Points {
    /// `count` points over the whole element; a plane and a cylinder are 100 mm long.
    pub fn on(element: Element, count: usize) -> Self {
        let mut noise = Noise::new(26, 1);
        let mut local = || {
            let (sin, cos) = noise.uniform(std::f64::consts::PI).sin_cos();
            let (h, radius) = (noise.uniform(1.0), RADIUS + noise.gaussian(NOISE));
            match element {
                Element::Plane => [50.0 * h, noise.uniform(50.0), radius - RADIUS],
                Element::Sphere => {
                    let ring = (1.0 - h * h).sqrt();
                    [radius * ring * cos, radius * ring * sin, radius * h]
                }
                _ => [radius * cos, radius * sin, 50.0 * h],
            }
        };
        let [x, y, z] = CENTER;
        if element == Element::Circle2d {
            let flat = |[u, v, _]: [f64; 3]| [x + u, y + v];
            return Self::Plane((0..count).map(|_| flat(local())).collect());
        }
        let turned = |[u, v, w]: [f64; 3]| [x + 0.8 * u + 0.6 * w, y + v, z - 0.6 * u + 0.8 * w];
        Self::Space((0..count).map(|_| turned(local())).collect())
    }

    pub fn flat(&self) -> &[f64] {
        match self {
            Self::Plane(points) => points.as_flattened(),
            Self::Space(points) => points.as_flattened(),
        }
    }

    /// As raw numbers, lowest byte first.
    pub fn bytes(&self) -> Vec<u8> {
        self.flat().iter().flat_map(|x| x.to_le_bytes()).collect()
    }
}
