//! Convex hull of points in the plane, and the narrowest strip that holds them.

/// Corners of the convex hull, anticlockwise, as indices; two for points on a line, one for identical points.
///
/// Andrew's monotone chain (1979).
pub(super) fn hull(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&i, &j| points[i][0].total_cmp(&points[j][0]).then(points[i][1].total_cmp(&points[j][1])));
    order.dedup_by(|i, j| points[*i] == points[*j]);
    if order.len() < 3 {
        return order;
    }
    let mut corners = half(points, order.iter().copied());
    corners.extend(half(points, order.into_iter().rev()));
    corners
}

/// One side of the hull without its last corner.
fn half(points: &[[f64; 2]], order: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut chain: Vec<usize> = Vec::new();
    for i in order {
        while let [.., a, b] = chain[..]
            && cross(between(points[a], points[b]), between(points[a], points[i])) <= 0.0
        {
            chain.pop();
        }
        chain.push(i);
    }
    chain.pop();
    chain
}

/// The narrowest strip that holds the points.
pub(super) struct Strip {
    /// Ends of the edge on one side.
    pub edge: [usize; 2],
    pub width: f64,
}

/// One side of the narrowest strip is an edge of the hull (Houle & Toussaint 1988): every edge is tried, the corner
/// opposite moving on with it. `None` for identical points.
pub(super) fn narrowest_strip(points: &[[f64; 2]]) -> Option<Strip> {
    let corners = hull(points);
    let count = corners.len();
    let corner = |k: usize| points[corners[k % count]];
    let mut best: Option<Strip> = None;
    let mut far = 1;
    for k in 0..if count < 2 { 0 } else { count } {
        let edge = between(corner(k), corner(k + 1));
        far = far.max(k + 1);
        while far < k + count && cross(edge, between(corner(far), corner(far + 1))) > 0.0 {
            far += 1;
        }
        let width = cross(edge, between(corner(k), corner(far))) / edge[0].hypot(edge[1]);
        if best.as_ref().is_none_or(|b| width < b.width) {
            let index = |k: usize| corners[k % count];
            best = Some(Strip { edge: [index(k), index(k + 1)], width });
        }
    }
    best
}

pub(super) fn between(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [b[0] - a[0], b[1] - a[1]]
}

pub(super) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
