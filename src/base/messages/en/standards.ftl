### Messages of standards. Above each message: its explanation (see CONTRIBUTING.md, "A message").

characteristic = { $name ->
        [bootstrap] bootstrap
        [ap-interval] interval of AP
        [rp-interval] interval of RP
        [commanded-path] commanded path
        [exchangeability] exchangeability
        [reading-noise] noise of readings
        [rp-without-noise] repeatability without noise
        [pose-repeatability] pose repeatability
        [reference-targets] reference targets
        [error-ellipsoid] error ellipsoid
        [pose-accuracy] pose accuracy
        [coplanarity] coplanarity
        [distance] distance
        [variation] multi-directional variation
        [static-compliance] static compliance
        [path-accuracy-interval] interval of path accuracy
        [path-repeatability-interval] interval of path repeatability
        [cornering] cornering
        [path-repeatability] path repeatability
        [path-accuracy] path accuracy
        [path-velocity] path velocity
       *[drift] drift
    }

# Means: A characteristic needs more attained positions than there are.
# Matters: With so few positions, the standard deviation or the fit is undefined.
# Do: Measure more cycles; ISO 9283 requires 30.
# Example: one cycle of a pose: repeatability needs two
too-few-positions = { $of }: { $count ->
        [one] 1 attained position
       *[other] { $count } attained positions
    }
    .expected = at least { $least }
    .hint = measure more cycles

# Means: An attained position is infinite or not a number.
# Matters: Means and standard deviations are undefined.
# Do: Correct this row, or remove it.
# Example: `NaN` in a column of coordinates
position-not-finite = { $of }: position { $number } is non-finite
    .hint = correct this position, or remove it

# Means: A characteristic needs more complete passes than the recording contains.
# Matters: With so few passes, the mean or the standard deviation is undefined.
# Do: Record more passes of the path; ISO 9283 requires 10.
# Example: one pass: path repeatability needs two
too-few-passes = { $of }: { $count ->
        [0] no complete pass
        [one] 1 complete pass
       *[other] { $count } complete passes
    } of the path
    .expected = at least { $least }
    .hint = record more passes of the path

# Means: The passes were found with one set of command points and evaluated with another.
# Matters: Passes and command points do not match.
# Do: Use the same command points for finding and for evaluating the passes.
# Example: passes of a path of 100 points, evaluated with 50 points
passes-of-other-path = { $of }: the passes belong to another path
    .hint = use the same command points for finding and for evaluating the passes

# Means: The search for passes has fewer than two command points, or a distance that is not
# positive.
# Matters: A pass crosses a plane at each command point.
# Do: Give at least two command points and a positive distance.
# Example: a search distance of 0 mm
passes-need-points = the search for passes needs two command points and a positive distance
    .hint = give at least two command points and a positive distance

# Means: The given workspace has no size along one of its axes, or is not finite.
# Matters: The cube of the test (ISO 9283, 6.8) needs a box.
# Do: Give the smallest x, y, z first, then the largest.
# Example: `--workspace 0,0,0,500,0,400`
workspace-not-box = the workspace is not a box
    .expected = the smallest x, y, z, then the largest

# Means: An orientation has more or fewer angles than the robot has axes of rotation.
# Matters: The poses of the test cannot be commanded.
# Do: Give one angle for each axis of rotation of the robot.
# Example: `--orientation 0,90` for a spatial robot
angle-count = { $option } has { $count ->
        [one] 1 angle
       *[other] { $count } angles
    }
    .expected = { $angles }

# Means: A test plane is given for a planar robot.
# Matters: A planar robot has only one plane.
# Do: Omit `--plane` for a planar robot.
# Example: `--plane c1-c2-c7-c8` for a five-bar robot
planar-test-plane = a planar robot has only one test plane
    .hint = omit the test plane

# Means: The name of the test plane is unknown.
# Matters: The five poses of the test lie on this plane (ISO 9283, 6.8.2).
# Do: Use one of the planes of the standard.
# Example: `--plane c1-c2`
test-plane-unknown = unknown test plane `{ $name }`
    .expected = { $planes }

# Means: The radius or the duration of a standstill is zero, negative or not a number.
# Matters: The program finds no standstill.
# Do: Choose a radius larger than the noise of the standing robot, and a duration shorter than the
# shortest stop.
# Example: `still_mm = 0`
standstill-thresholds = radius and duration of a standstill must be positive
    .hint = choose a radius larger than the noise of the standing robot, and a duration shorter than the shortest stop

in-sample = sample { $sample }: { $message }

# Means: A recorded motion has fewer than two samples, or columns of different lengths.
# Matters: Velocity and path cannot be computed.
# Do: Record the motion again with a value in every column.
# Example: a recording of one row
stream-too-short = a recorded motion needs at least two samples with the same columns
    .hint = record the motion again

# Means: A coordinate, an angle or the time of a sample is missing or not finite.
# Matters: It is unknown how far the robot moved in this gap.
# Do: Remove this row from the recording.
# Example: an empty cell in the column `x_mm`
stream-value-missing = a coordinate or the time is missing or non-finite
    .hint = remove this sample

# Means: The time stamp of a sample is not later than the time stamp of the previous sample.
# Matters: The velocity is infinite or negative.
# Do: Sort the rows by time, and remove rows that are written twice. If the stamps are coarser than
# the sampling, give the sampling rate.
# Example: two samples at 1.5 s
time-not-increasing = the time does not increase: { $later_s } s after { $earlier_s } s
    .hint = sort the rows by time and remove repeated rows, or record with finer time stamps

# Means: The centre line of the weave has no direction, or the weaving motion is parallel to it.
# Matters: The stroke is measured perpendicular to the centre line (ISO 9283, 11).
# Do: Set `weave_across` to a direction across the centre line.
# Example: a centre line along x and `weave_across = [1, 0, 0]`
weave-direction = weaving: the motion has no direction across the centre line
    .hint = set `weave_across` to a direction across the centre line

# Means: The commanded stroke or frequency of the weave is zero, negative or not a number.
# Matters: Weaving deviations are divided by the commanded values.
# Do: Set the commanded stroke and frequency to positive values.
# Example: `weave_hz = 0`
weave-command = weaving: commanded stroke and frequency must be positive
    .hint = set the commanded stroke and frequency to positive values

# Means: The recording contains no sample of the weave.
# Matters: The stroke and the frequency are unknown.
# Do: Compare the start and the end of the weave with the times of the recording.
# Example: a weave after the end of the recording
weave-without-samples = weaving: the recording contains no samples of the weave
    .hint = check the start and the end of the weave

# Means: The recording contains too few turning points of the weave.
# Matters: The first and the last turning points are excluded; the stroke and the frequency need
# three more.
# Do: Record a longer weave, or check the commanded stroke.
# Example: a weave of one period
weave-too-few-turns = weaving: { $turns ->
        [one] 1 turning point
       *[other] { $turns } turning points
    }
    .expected = at least five, with at least a quarter of the commanded stroke between them
    .hint = record a longer weave

# Means: The half of a leg next to the corner contains no command point.
# Matters: Cornering deviations are evaluated there.
# Do: Add command points near the corner.
# Example: command points at 0 mm and 10 mm, and a corner at 2 mm
corner-without-points = cornering: there is no command point on the half of a leg next to the corner
    .hint = add command points near the corner

# Means: No commanded angle changes along the path.
# Matters: This characteristic needs a path with reorientation.
# Do: Add the commanded angles to the table of the path.
# Example: a commanded path without angle columns
path-without-reorientation = path accuracy on reorientation: no commanded angle changes along the path
    .hint = add the commanded angles to the table of the path

# Means: An angle of the commanded path is missing or not finite.
# Matters: The commanded orientation at this point is unknown.
# Do: Give all angles at every point, or remove the columns of angles.
# Example: an empty cell in the column `rz_deg`
commanded-angle-missing = commanded path: an angle is missing or non-finite
    .hint = give all angles at every point, or no angles

# Means: Two successive points of the commanded path are the same.
# Matters: The path has no direction at this point.
# Do: Remove one of the points. A rotation at one position is not a path.
# Example: the same row twice
commanded-point-repeated = commanded path: points { $first } and { $second } coincide
    .hint = remove one of the two points

# Means: The commanded velocity is zero, negative or not a number.
# Matters: Velocity characteristics are divided by the commanded velocity (ISO 9283, 9.6).
# Do: Set the commanded velocity to a positive value.
# Example: `velocity_mm_s = 0`
velocity-not-positive = path velocity: the commanded velocity must be positive
    .hint = set the commanded velocity to a positive value

# Means: The central part of the path has fewer than three command points.
# Matters: Mean and fluctuation of the velocity need at least two intervals.
# Do: Add command points, or increase the central part.
# Example: four command points and a central part of one half
velocity-too-few-points = path velocity: fewer than three command points in the central part
    .hint = add command points, or increase the central part

# Means: A characteristic compares several sets of measurements, but there are too few sets.
# Matters: A comparison needs at least two sets.
# Do: Measure at least two sets.
# Example: one set of cycles: drift compares sets over time
too-few-of = { $of }: { $sets }
    .expected = at least { $least }
    .hint = measure more sets

sets-of-cycles = { $count ->
        [one] 1 set of cycles
       *[other] { $count } sets of cycles
    }

poses = { $count ->
        [one] 1 pose
       *[other] { $count } poses
    }

approaches = { $count ->
        [one] 1 approach
       *[other] { $count } approaches
    }

epochs = { $count ->
        [0] no measurement
       *[other] { $count } measurements
    }

# Means: Some robots were not measured at all poses.
# Matters: Exchangeability compares the robots at each pose (ISO 9283, 7.5).
# Do: Measure every robot at the same poses.
# Example: robot A at poses 1 to 5, robot B at poses 1 to 4
robots-at-other-poses = exchangeability: the robots do not have the same poses
    .expected = at least two robots, each at every pose

# Means: One robot was not measured at a pose of the other robots.
# Matters: Exchangeability compares the robots at each pose (ISO 9283, 7.5).
# Do: Measure this robot at the pose, or remove the pose for all robots.
# Example: robot B without rows of pose 5
robot-without-pose = exchangeability: robot `{ $robot }` was not measured at pose { $pose }
    .expected = every robot at every pose

# Means: There is only one reading of every visit.
# Matters: The noise of the instrument is computed from several readings of one visit.
# Do: Take at least two readings in each visit.
# Example: one row for each cycle
visits-read-once = repeatability without noise: every visit has only one reading
    .hint = take several readings in each visit

# Means: Three of the four mean positions lie on one line.
# Matters: A plane through these three is undefined, so the distance of the fourth position is
# undefined.
# Do: Choose four poses of which no three lie on one line.
# Example: poses 1, 2 and 3 on an edge of the cube
coplanar-poses-on-line = coplanarity: three of the four mean positions lie on one line
    .hint = choose four poses of which no three lie on one line

# Means: The two poses of a distance were not measured in the same cycles.
# Matters: The distance in a cycle needs the positions of both poses.
# Do: Exclude the cycles in which one of the poses is missing.
# Example: 30 cycles at pose 2, 29 at pose 4
distance-counts-differ = distance: the two poses have { $first } and { $second } positions
    .expected = both poses in the same cycles

# Means: A force is zero, negative or not a number.
# Matters: The direction of the load gives its sign.
# Do: Write the magnitude of the force, and the sign in its direction.
# Example: `force_n = -50`
force-not-positive = static compliance: a force is not positive
    .expected = the magnitude of the force; its direction gives the sign

# Means: A cycle of a load contains no row without force.
# Matters: The deflection is the distance from the unloaded position.
# Do: In each cycle, record the unloaded position with `force_n` = 0.
# Example: a table with forces of 50 N only
unloaded-position-missing = direction { $direction }, cycle { $cycle }: no row without force
    .hint = record the unloaded position of this cycle, with force 0

# Means: No row of the table has a force.
# Matters: Compliance is the deflection divided by the force.
# Do: Write the force of each loaded row into `force_n`.
# Example: a table whose column `force_n` is 0 everywhere
force-missing = no row has a force
    .hint = write the force of each loaded row into `force_n`

no-working-mode-reaches = no working mode reaches it within the joint limits
