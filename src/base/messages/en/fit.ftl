### Messages of fit. Above each message: its explanation (see CONTRIBUTING.md, "A message").

element = { $name ->
        [enclosing-circle] smallest enclosing circle
        [enclosing-sphere] smallest enclosing sphere
        [rigid-transform] rigid transform
       *[other] { $name }
    }

# Means: The name of a geometric element is unknown.
# Matters: The command cannot fit an unknown element.
# Do: Use one of the names that the hint proposes.
# Example: `etalon fit cylindre points.txt`
element-unknown = unknown element `{ $name }`

# Means: The stated standard uncertainty of a point is zero, negative or not a number.
# Matters: The uncertainty of the element is proportional to this value.
# Do: Give the standard uncertainty of a touch in micrometres, for example from the certificate of the
# machine. Without it, the residuals give the uncertainty.
# Example: `--standard-uncertainty-um 0`
point-uncertainty-not-positive = the standard uncertainty of a point is { $uncertainty_mm } mm
    .expected = a positive number
    .hint = give the standard uncertainty of one point, or omit it: the residuals then give the uncertainty

# Means: The given radius of the probe is zero, negative or not a number.
# Matters: The probe radius moves the measured centres to the surface.
# Do: Give the qualified radius of the probe in mm. If the points are contact points, omit it.
# Example: `probe_radius_mm = -1.5`
probe-radius-not-positive = the probe radius is { $radius } mm
    .expected = a positive number
    .hint = give the qualified radius of the probe, not its diameter; omit it for contact points

# Means: The side of the probe is given as inside or outside, but the element has no inside.
# Matters: The command moves the plane or line by the probe radius to an unknown side.
# Do: Give the direction from the element to the probe, as three numbers.
# Example: `side = "inside"` for a plane
probe-side-needs-direction = element { $element } has no inside and no outside
    .expected = the direction from the element to the probe
    .hint = give three numbers, for example 0,0,1 for a probe above

# Means: The side of the probe is given as a direction, but the element needs inside or outside.
# Matters: A direction does not determine whether the probe radius is added or subtracted.
# Do: Use `inside` for a bore, or `outside` for a shaft.
# Example: `side = [0, 0, 1]` for a cylinder
probe-side-needs-inside = a direction does not define the side of the probe for element { $element }
    .expected = inside (a bore) or outside (a shaft)
    .hint = use inside or outside

# Means: The direction to the probe is zero or not finite.
# Matters: The side of the probe is unknown.
# Do: Give three numbers that point from the surface to the probe; they need not have the length 1.
# Example: `side = [0, 0, 0]`
probe-direction-zero = the direction { $direction } to the probe has no length
    .expected = three finite numbers, not all zero
    .hint = give the direction from the surface to the probe

# Means: The direction to the probe is parallel to the element.
# Matters: It does not define the side of the probe.
# Do: Give a direction that points from the surface to the probe, for example its normal.
# Example: `side = [1, 0, 0]` for the plane z = 0
probe-direction-along-element = the direction { $direction } to the probe is parallel to element { $element }
    .expected = a direction away from the element
    .hint = give the direction from the surface to the probe

# Means: The centres of the probe lie on a radius that is smaller than the probe radius.
# Matters: If a probe touches the element from outside, its centres lie on a larger radius than the
# probe radius.
# Do: Set the side to `inside`, or correct the probe radius.
# Example: centres on a radius of 1 mm, `probe_radius_mm = 1.5`, `side = "outside"`
probe-larger-than-element = a probe of radius { $probe_mm } mm cannot touch element { $element } from outside
    .expected = centres at a radius larger than the probe radius; the radius is { FIXED($centres_mm, 6) } mm
    .hint = set the side to inside, or correct the probe radius

# Means: The fit is already corrected for the radius of the probe.
# Matters: A second correction moves the element off the surface.
# Do: Correct the fit for the probe only once: in the settings, or with `compensated`.
# Example: `compensated` called for a fit with a probe in its settings
compensated-twice = the fit is already compensated for the probe
    .expected = a fit to probe centres
    .hint = compensate for the probe only once

# Means: A fixed radius is given for an element without a radius.
# Matters: The radius has no effect; probably the element is wrong.
# Do: Omit the radius, or choose an element with a radius.
# Example: `radius_mm = 10` for a plane
held-radius-unsupported = element { $element } has no radius
    .expected = no radius
    .hint = omit the radius

# Means: The fixed radius is zero, negative or not a number.
# Matters: There is no element with this radius.
# Do: Give the radius in millimetres, as a positive number.
# Example: `radius_mm = 0`
held-radius-not-positive = the fixed radius is { $radius } mm
    .expected = a positive number
    .hint = give the radius in millimetres

# Means: The probe is too large for the inside of an element with the fixed radius.
# Matters: The probe centres lie on a radius of zero or less.
# Do: Set the side of the probe to `outside`, or correct the radius.
# Example: `radius_mm = 1`, `probe_radius_mm = 1.5`, `side = "inside"`
held-radius-below-probe = inside element { $element } of radius { $radius } mm, the probe centres would lie on a radius of { $centres } mm
    .expected = a probe radius smaller than the fixed radius
    .hint = set the other side of the probe, or correct the radius

# Means: A fixed axis is given for an element without an axis.
# Matters: The axis has no effect; probably the element is wrong.
# Do: Omit the axis, or choose an element with an axis.
# Example: `axis = [0, 0, 1]` for a sphere
held-axis-unsupported = element { $element } has no axis
    .expected = no axis
    .hint = omit the axis

# Means: The fixed axis is zero or not finite.
# Matters: The axis has no direction.
# Do: Give the direction of the axis as three numbers.
# Example: `axis = [0, 0, 0]`
held-axis-zero = the fixed axis { $axis } has no direction
    .expected = three numbers, not all zero
    .hint = give the direction of the axis

# Means: Two different elements of the same type fit the points about equally well.
# Matters: The radius and the axis may belong to the other element.
# Do: Measure more points on the uncovered part of the element, or fix its axis.
# Example: six points of a cylinder in two groups
element-ambiguous = another { $element } fits the points about equally well
    .hint = measure more points on the uncovered part of the element, or fix the axis

# Means: The fit did not converge, or the points do not determine the element.
# Matters: The parameters of the element have no finite uncertainty.
# Do: Check the points: the arc may be too short or too straight, or the element may be wrong.
# Otherwise fix the radius or the axis.
# Example: three points for a circle, on a line to within 1e-10 mm
element-not-determined = no { $element } could be fitted: { $termination }
    .expected = points that determine a { $element }
    .hint = check the points (short arc, straight line, wrong element), or fix the radius or the axis

# Means: A plane fits the points as closely as the element does.
# Matters: The minimum zone is then the zone between two planes, and the radius of the element has
# no upper limit.
# Do: Measure more of the surface, or evaluate the minimum zone of a plane instead.
# Example: points of a sphere of 1 m radius, all within 5 mm
zone-flat = no minimum zone of a { $element }: the points fit a plane equally well
    .expected = a measured part of the surface whose height exceeds the form deviation
    .hint = measure more of the surface, or evaluate the minimum zone of a plane

# Means: A line fits the points as closely as the circle does.
# Matters: The minimum zone is then the zone between two lines, and the radius of the circle has no
# upper limit.
# Do: Measure a longer arc, or evaluate the minimum zone of a line instead.
# Example: points of a circle of 1 m radius, all within 5 mm
zone-straight = no minimum zone of a circle: the points fit a line equally well
    .expected = a measured arc whose height exceeds the form deviation
    .hint = measure a longer arc, or evaluate the minimum zone of a line

# Means: etalon cannot compute the minimum zone of this element.
# Matters: The minimum zone (ISO 1101) exists only for the elements in the message.
# Do: Omit `--minimum-zone` for this element.
# Example: `etalon fit --minimum-zone torus points.txt`
zone-unsupported = the minimum zone of a { $element } is not available
    .expected = line2d, plane, circle2d, circle3d, sphere, cylinder or cone
    .hint = use the least-squares fit

# Means: Two lists of points have different lengths.
# Matters: The points are paired in their order.
# Do: Write each target once in both lists.
# Example: 5 targets before, 4 after
point-counts-differ = { $from } points cannot be paired with { $to }
    .expected = the same number of points in the same order
    .hint = write each target once in both lists

# Means: More than one rotation moves one set of points equally close to the other set.
# Matters: The transform is not unique.
# Do: Check the order of the targets. A mirror image and symmetric targets have no unique rotation.
# Example: the corners of a tetrahedron and their mirror images
rotation-ambiguous = no rigid transform can be fitted: more than one rotation fits equally well
    .expected = two sets of points of the same shape
    .hint = check that both lists have the targets in the same order, and that neither is a mirror image

# Means: With these residuals, the uncertainty of the rotation is larger than about one degree.
# Matters: Frames computed from this rotation have the same uncertainty.
# Do: Use targets that are farther apart, and check their names.
# Example: two targets swapped in one list
rotation-uncertain = the rotation has an expanded uncertainty of { FIXED($expanded_deg, 1) } deg (k = 2)
    .hint = use targets that are farther apart, and check whether two names are swapped

# Means: The element needs more points than it has.
# Matters: The points do not determine the element.
# Do: Measure more points, or add all points that belong to the feature.
# Example: two points for a plane
too-few-points = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } given for a { $element }
    .expected = at least { $minimum } points
    .hint = measure more points, or add all points that belong to the feature

# Means: A coordinate is infinite, undefined or far too large.
# Matters: The result of the fit is undefined.
# Do: Find this point in the export, and correct or remove it.
# Example: a point with x = 1e300
point-not-finite = point { $number } of the { $element } is { $coordinates }
    .expected = finite coordinates in millimetres
    .hint = check this point in the export

# Means: The points lie at one position, on one line or in one plane; the element needs more.
# Matters: The points do not determine the element.
# Do: Measure points that are distributed over the whole feature.
# Example: all points of a plane on one line
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
    .hint = distribute the points over the whole feature

# Means: The weights of the points are incomplete, not positive, or too different.
# Matters: Weighted least squares need one positive weight for each point.
# Do: Set the weight of each point to 1/u². Omit a point instead of giving it the weight zero.
# Example: a weight of 0
weights-unusable = the { $weights } weights of the { $element } cannot be used for its { $points } points
    .expected = one positive finite weight for each point, within a factor 1e12 of each other
    .hint = set the weight of each point to 1/u²; omit a point instead of giving it the weight zero

# Means: The number of points equals the number of parameters of the element.
# Matters: Without residuals, only the stated uncertainty of the points shows its uncertainty.
# Do: Measure at least one more point; ten to twenty are usual.
# Example: three points of a plane
element-without-redundancy = the { $element } has no redundant point: residuals are zero and its uncertainty is unknown
    .hint = measure more points than the minimum

# Means: The residuals are larger than the stated uncertainty of the points explains.
# Matters: The surface has a form deviation, some points are outliers, or the stated uncertainty is too
# small. The uncertainty of the element does not contain this.
# Do: Look at the residuals. Omit the stated uncertainty, so that the residuals give the uncertainty.
# Example: a ball with a form deviation of 5 µm and a stated uncertainty of 1 µm
residuals-exceed-points = residuals of the { $element } are { FIXED($times, 1) } × the stated uncertainty of the points
    .hint = check form and outliers; if the form counts, omit `--standard-uncertainty-um`: the residuals then give the uncertainty

# Means: Some points equal an earlier point in every digit: rows of the table were copied.
# Matters: Copies are no further measurements, so the uncertainty of the element is too small.
# Do: Remove the copied rows.
# Example: the touches of a ball twice in one file
points-repeated = { $count ->
        [one] 1 point repeats
       *[other] { $count } points repeat
    } an earlier point digit for digit, so the uncertainty is too small: { $points }
    .hint = remove the copied points: they are no further measurements

# Means: The expanded uncertainty of the radius exceeds a tenth of the radius.
# Matters: The points determine the size and the centre of the element poorly.
# Do: Measure a longer arc, or fix the radius at its nominal value.
# Example: a circle of 100 mm radius measured over 10 deg
radius-uncertain = the radius { FIXED($radius_mm, 6) } mm of the { $element } has an expanded uncertainty of { SCIENTIFIC($expanded_mm, 2) } mm (95 %){ $covered_deg ->
        [none] {""}
       *[other] {" "}over { $covered_deg } deg
    }
    .hint = measure a longer arc, or fix the radius at its nominal value

# Means: The expanded uncertainty of the direction of the element exceeds a tenth of a radian.
# Matters: The points determine this direction poorly: for the noise of the points, the measured
# area is too narrow or too short. Every frame that is aligned with the element has the same error.
# Do: For a line, measure points farther apart. For a plane, measure along both of its directions.
# Otherwise fix the direction.
# Example: a plane through a strip 0.1 mm wide with noise of 0.02 mm
element-direction-uncertain = the direction of the { $element } has an expanded uncertainty of { FIXED($expanded_deg, 1) } deg (95 %)
    .hint = measure points farther apart, along both directions of a plane, or fix the direction

# Means: The apex angle of the cone is smaller than its expanded uncertainty.
# Matters: The apex and the apex angle are not determined.
# Do: Fit a cylinder to these points.
# Example: a cone through points of a cylinder
cone-is-cylinder = the apex angle of the cone is not distinguishable from zero (k = 2)
    .hint = fit a cylinder

# Means: The apex angle of the cone differs from 180 deg by less than its expanded uncertainty.
# Matters: Apex, radius and the direction in which the cone widens are not determined.
# Do: Fit a plane to these points.
# Example: a cone through points of a plane
cone-is-plane = the apex angle of the cone is not distinguishable from 180 deg (k = 2): the cone is a plane
    .hint = fit a plane

# Means: Some points are outliers: they are farther from the element than noise can explain. They
# are excluded.
# Matters: The element and its uncertainty come from the other points.
# Do: Look at these points. Remove them from the file if you know the cause.
# Example: dust under the probe at one of 60 points
points-set-aside = { $count ->
        [one] 1 point is excluded
       *[other] { $count } points are excluded
    }: { $points }
    .hint = they are farther from the element than noise can explain

# Means: Some points are far from the element that fits all other points, and shift the fit by more
# than its uncertainty.
# Matters: Least squares distributes the error of an outlier over the whole element, so form and
# uncertainty are wrong.
# Do: Look at these points. Use `--robust` to exclude and list them, or remove them from the file.
# Example: one point of an edge among the points of a plane
points-outlying = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } far from the element of all others ({ $points }): the fit is shifted by { FIXED($shift, 1) } standard uncertainties
    .hint = look at them; `--robust` excludes them

# Means: A robust fit needs three times as many points as the element has at least.
# Matters: With so few points, outliers cannot be recognised.
# Do: Measure more points, or omit `--robust`.
# Example: a sphere through eight points with `--robust`
robust-few-points = a robust fit of the { $element } needs { $needed } points, not { $points }
    .hint = measure more points, or omit --robust to fit all of them
method-principal-directions = principal directions of the centred points
method-orthogonal-distance = orthogonal distance, Gauss-Newton in a trust region
method-circle-in-plane = least-squares plane, projection, circle in the plane by orthogonal distance
