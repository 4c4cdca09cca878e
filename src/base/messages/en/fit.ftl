### Messages of fit. Above each message: its explanation (see CONTRIBUTING.md, "A message").

element = { $name ->
        [enclosing-circle] smallest enclosing circle
        [enclosing-sphere] smallest enclosing sphere
        [rigid-transform] rigid transform
       *[other] { $name }
    }

# Means: The name of a geometric element is unknown.
# Matters: Without the element nothing can be fitted.
# Do: Use one of the names that the hint proposes.
# Example: `etalon fit cylindre points.txt`
element-unknown = unknown element `{ $name }`

# Means: The stated radius of the probe is zero, negative or not a number.
# Matters: Measured centres are moved to the surface by this radius.
# Do: State the qualified radius of the probe in mm, or omit it if the points are contact points.
# Example: `probe_radius_mm = -1.5`
probe-radius-not-positive = the probe radius is { $radius } mm
    .expected = a positive number
    .hint = state the qualified radius of the probe, not its diameter; omit it for contact points

# Means: The side of the probe is stated as inside or outside for an element without an inside.
# Matters: The plane or line would be moved by the probe radius to an unknown side.
# Do: State the direction from the element to the probe.
# Example: `side = "inside"` for a plane
probe-side-needs-direction = inside and outside are undefined for element { $element }
    .expected = the direction from the element to the probe
    .hint = state three numbers, for example 0,0,1 for a probe above

# Means: The side of the probe is stated by a direction for an element that has an inside.
# Matters: A direction does not determine whether the probe radius is added or subtracted.
# Do: State `inside` (a bore) or `outside` (a shaft).
# Example: `side = [0, 0, 1]` for a cylinder
probe-side-needs-inside = a direction does not define the side of the probe for element { $element }
    .expected = inside (a bore) or outside (a shaft)
    .hint = state the side of the probe: inside or outside

# Means: The direction to the probe is zero or not finite.
# Matters: The side of the probe remains unknown.
# Do: State the direction from the surface to the probe.
# Example: `side = [0, 0, 0]`
probe-direction-zero = the direction { $direction } to the probe has no length
    .expected = three finite numbers, not all zero
    .hint = state the direction from the surface to the probe

# Means: The direction to the probe is parallel to the element.
# Matters: It does not define the side of the probe.
# Do: State a direction that points away from the element.
# Example: `side = [1, 0, 0]` for the plane z = 0
probe-direction-along-element = the direction { $direction } to the probe is parallel to element { $element }
    .expected = a direction away from the element
    .hint = state the direction from the surface to the probe

# Means: The centres of the probe lie on a radius smaller than that of the probe.
# Matters: Centres of a probe outside the element lie on a larger radius.
# Do: State the other side: the probe was inside.
# Example: centres on a radius of 1 mm, `probe_radius_mm = 1.5`, `side = "outside"`
probe-larger-than-element = a probe of radius { $probe_mm } mm cannot touch element { $element } from outside
    .expected = centres at a radius larger than the probe radius; the radius is { FIXED($centres_mm, 6) } mm
    .hint = state the other side: the probe was inside

# Means: The fit is already corrected for the radius of the probe.
# Matters: A second correction would move the element off the surface.
# Do: Correct for the probe once.
# Example: `compensated` called for a fit with a probe in its settings
compensated-twice = the fit is already compensated for the probe
    .expected = a fit to probe centres
    .hint = compensate once

# Means: A radius is held for an element without a radius.
# Matters: The statement has no effect; the element is probably wrong.
# Do: Omit the radius.
# Example: `radius_mm = 10` for a plane
held-radius-unsupported = element { $element } has no radius
    .expected = no radius
    .hint = omit the radius

# Means: The held radius is zero, negative or not a number.
# Matters: No such element exists.
# Do: State the radius in millimetres.
# Example: `radius_mm = 0`
held-radius-not-positive = the held radius is { $radius } mm
    .expected = a positive number
    .hint = state the radius in millimetres

# Means: The probe does not fit inside an element of the held radius.
# Matters: Its centres would lie at a radius of zero or less.
# Do: State the other side of the probe, or correct the radius.
# Example: `radius_mm = 1`, `probe_radius_mm = 1.5`, `side = "inside"`
held-radius-below-probe = a probe inside element { $element } of radius { $radius } mm has its centres at { $centres } mm
    .expected = a probe smaller than the held radius
    .hint = state the other side of the probe, or correct the radius

# Means: An axis is held for an element without an axis.
# Matters: The statement has no effect; the element is probably wrong.
# Do: Omit the axis.
# Example: `axis = [0, 0, 1]` for a sphere
held-axis-unsupported = element { $element } has no axis
    .expected = no axis
    .hint = omit the axis

# Means: The held axis is zero or not finite.
# Matters: Such an axis has no direction.
# Do: State the axis as three numbers, not all zero.
# Example: `axis = [0, 0, 0]`
held-axis-zero = the held axis { $axis } has no direction
    .expected = three numbers, not all zero
    .hint = state the axis

# Means: Another element of the same type fits the points about equally well.
# Matters: Radius and axis may be those of the other element.
# Do: Measure more points where the element is not covered, or hold its axis.
# Example: six points of a cylinder in two groups
element-ambiguous = another { $element } fits the points about equally well
    .hint = measure more points where the element is not covered, or hold the axis

# Means: The fit did not converge, or the points do not determine the element.
# Matters: Its parameters have no finite uncertainty.
# Do: Check the points: the arc may be too short or too straight, or the element may be wrong;
# otherwise hold the radius or the axis.
# Example: three points on a line, apart from 1e-10 mm, for a circle
element-not-determined = no { $element } could be fitted: { $termination }
    .expected = points that determine a { $element }
    .hint = check the points (short arc, straight line, wrong element), or hold the radius or the axis

# Means: The points lie as close to a plane as to the element.
# Matters: A plane then bounds the minimum zone, and the radius of the element has no upper limit.
# Do: Measure more of the surface, or evaluate the minimum zone of a plane.
# Example: points of a sphere of 1 m radius within 5 mm
zone-flat = no minimum zone of a { $element }: the points fit a plane equally well
    .expected = a measured part of the surface whose height exceeds the form deviation
    .hint = measure more of the surface, or evaluate the minimum zone of a plane

# Means: The points lie as close to a line as to a circle.
# Matters: Lines then bound the minimum zone, and the radius of the circle has no upper limit.
# Do: Measure a longer arc, or evaluate the minimum zone of a line.
# Example: points of a circle of 1 m radius within 5 mm
zone-straight = no minimum zone of a circle: the points fit a line equally well
    .expected = a measured arc whose height exceeds the form deviation
    .hint = measure a longer arc, or evaluate the minimum zone of a line

# Means: etalon has no minimum zone for this element.
# Matters: The form deviation by minimum zone (ISO 1101) is available for other elements only.
# Do: Use the least-squares fit of this element.
# Example: `etalon fit --minimum-zone torus points.txt`
zone-unsupported = the minimum zone of a { $element } is not available
    .expected = line2d, plane, circle2d, circle3d, sphere, cylinder or cone
    .hint = use the least-squares fit

# Means: Two sets of points have different numbers of points.
# Matters: Points are paired by their order.
# Do: Name each target once in both lists.
# Example: 5 targets before, 4 after
point-counts-differ = { $from } points cannot be paired with { $to }
    .expected = the same number of points in the same order
    .hint = name each target once in both lists

# Means: More than one rotation brings one set of points equally close to the other.
# Matters: The transform is not determined.
# Do: Check the order of the targets; a mirror image or symmetric targets have no single rotation.
# Example: the corners of a tetrahedron and their mirror images
rotation-ambiguous = no rigid transform can be fitted: more than one rotation fits equally well
    .expected = two sets of points of the same shape
    .hint = check that both lists name the targets in the same order and that neither is a mirror image

# Means: Residuals leave the rotation uncertain by more than about a degree.
# Matters: Frames computed from the rotation have the same uncertainty.
# Do: Use targets farther apart, and check their names.
# Example: two targets exchanged in one list
rotation-uncertain = the rotation has an expanded uncertainty of { FIXED($expanded_deg, 1) } deg (k = 2)
    .hint = use targets farther apart, and check that their names are not exchanged

# Means: The element has fewer points than its parameters need.
# Matters: It is not determined.
# Do: Measure more points, or name all points that belong to the feature.
# Example: two points for a plane
too-few-points = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } given for a { $element }
    .expected = at least { $minimum } points
    .hint = measure more points, or name all points that belong to the feature

# Means: A coordinate is infinite, not a number or absurdly large.
# Matters: The fit would be undefined.
# Do: Check this point in the export.
# Example: a point with x = 1e300
point-not-finite = point { $number } of the { $element } is { $coordinates }
    .expected = finite coordinates in millimetres
    .hint = check this point in the export

# Means: The points span fewer dimensions than the element needs.
# Matters: The element is not determined.
# Do: Spread the points over the feature.
# Example: a plane through points of one line
points-degenerate = no { $element } can be fitted: { $spanned ->
        [0] all points are identical
        [1] all points lie on one line
       *[other] all points lie in one plane
    }
    .expected = points that are { $spanned ->
            [0] at different positions
            [1] not on one line
           *[other] not in one plane
        }
    .hint = spread the points over the feature

# Means: The weights of points are missing, not positive or too different.
# Matters: Weighted least squares need one positive weight for each point.
# Do: Use 1/u² of each point; omit a point instead of giving it the weight zero.
# Example: a weight of 0
weights-unusable = the { $weights } weights of the { $element } do not fit its { $points } points
    .expected = one positive finite weight for each point, within a factor 1e12 of each other
    .hint = use 1/u² of each point; omit a point instead of giving it the weight zero

# Means: The element has as many points as parameters.
# Matters: Residuals are zero, and no uncertainty can be stated.
# Do: Measure more points than the minimum.
# Example: three points of a plane
element-without-redundancy = the { $element } has no redundant point: residuals are zero and its uncertainty is unknown
    .hint = measure more points than the minimum

# Means: The expanded uncertainty of the radius exceeds a tenth of the radius.
# Matters: Size and centre of the element are poorly determined.
# Do: Measure a longer arc, or hold the radius at its nominal value.
# Example: a circle of 100 mm radius measured over 10 deg
radius-uncertain = the radius { FIXED($radius_mm, 6) } mm of the { $element } has an expanded uncertainty of { SCIENTIFIC($expanded_mm, 2) } mm (k = 2){ $covered_deg ->
        [none] {""}
       *[other] {" "}over { $covered_deg } deg
    }
    .hint = measure a longer arc, or hold the radius at its nominal value

# Means: The direction of the element has an expanded uncertainty of more than a tenth of a radian.
# Matters: The points barely determine it: they are as wide across the direction as their noise, or
# too short along it. Whatever is aligned with it turns by as much.
# Do: Measure points farther apart along a line, or over both directions of a plane; or hold the
# direction.
# Example: a plane through a strip 0.1 mm wide with noise of 0.02 mm
element-direction-uncertain = the direction of the { $element } has an expanded uncertainty of { FIXED($expanded_deg, 1) } deg (k = 2)
    .hint = measure points farther apart, over both directions of a plane, or hold the direction

# Means: The apex angle of the cone is smaller than its expanded uncertainty.
# Matters: Apex and angle are not determined.
# Do: Fit a cylinder.
# Example: a cone through points of a cylinder
cone-is-cylinder = the apex angle of the cone is not distinguishable from zero (k = 2)
    .hint = fit a cylinder

# Means: The apex angle of the cone differs from 180 deg by less than its expanded uncertainty.
# Matters: Apex, radius and the direction in which the cone widens are not determined.
# Do: Fit a plane.
# Example: a cone through points of a plane
cone-is-plane = the apex angle of the cone is not distinguishable from 180 deg (k = 2): the cone is a plane
    .hint = fit a plane

# Means: Points are farther from the element of all others than noise explains, and are not used.
# Matters: The element and its uncertainty are those of the other points.
# Do: Look at these points; remove them where the cause is known.
# Example: dust under the probe at one of 60 points
points-set-aside = { $count ->
        [one] 1 point is excluded
       *[other] { $count } points are excluded
    }: { $points }
    .hint = they are farther from the element of all others than noise explains

# Means: Some points are far from the element of all others, and shift the fit by more than its
# uncertainty.
# Matters: Least squares spreads the error of an outlier over the element; form and uncertainty
# are then wrong.
# Do: Look at these points. Fit with `--robust`, which sets them aside and lists them, or remove them.
# Example: one point of the edge among those of a plane
foreign-points = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } far from the element of all others ({ $points }): the fit is shifted by { FIXED($shift, 1) } standard uncertainties
    .hint = look at them; `--robust` sets them aside

# Means: A robust fit has fewer points than three times the minimum of the element.
# Matters: So few points do not show which of them are outliers.
# Do: Measure more points, or fit without `--robust`.
# Example: a sphere through eight points with `--robust`
robust-few-points = a robust fit of the { $element } needs { $needed } points, not { $points }
    .hint = measure more points, or fit all of them without setting any aside
method-principal-directions = principal directions of the centred points
method-orthogonal-distance = orthogonal distance, Gauss-Newton in a trust region
method-circle-in-plane = least-squares plane, projection, circle in the plane by orthogonal distance
