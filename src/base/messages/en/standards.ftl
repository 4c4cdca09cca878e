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

# Means: A characteristic has fewer attained positions than its formula needs.
# Matters: A standard deviation or a fit of so few positions is undefined.
# Do: Measure more cycles; ISO 9283 requires 30.
# Example: one cycle of a pose: repeatability needs two
too-few-positions = { $of }: { $count ->
        [one] 1 attained position
       *[other] { $count } attained positions
    }
    .expected = at least { $least }
    .hint = measure more cycles

# Means: An attained position is infinite or not a number.
# Matters: Means and standard deviations would be undefined.
# Do: Remove or correct the row.
# Example: `NaN` in a column of coordinates
position-not-finite = { $of }: position { $number } is non-finite
    .hint = remove or correct this position

# Means: The recorded path has fewer complete passes than the characteristic needs.
# Matters: A mean or standard deviation over so few passes is undefined.
# Do: Record more passes of the path; ISO 9283 requires 10.
# Example: one pass: path repeatability needs two
too-few-passes = { $of }: { $count ->
        [0] no complete pass
        [one] 1 complete pass
       *[other] { $count } complete passes
    } of the path
    .expected = at least { $least }
    .hint = record more passes of the path

# Means: The passes were found with other command points than those of the evaluation.
# Matters: Passes and command points would not match.
# Do: Find passes and evaluate them with the same command points.
# Example: passes of a path of 100 points, evaluated with 50 points
passes-of-other-path = { $of }: the passes belong to another path
    .hint = find and evaluate passes with the same command points

# Means: The search for passes has fewer than two command points, or no positive distance.
# Matters: A pass is found by its crossings of planes at the command points.
# Do: Give at least two command points and a positive distance.
# Example: a search distance of 0 mm
passes-need-points = passes of a path need two command points and a positive distance
    .hint = give at least two command points and a positive distance

# Means: The stated workspace has no extent along one of its axes, or is not finite.
# Matters: The cube of the test (ISO 9283, 6.8) does not fit into it.
# Do: Give the smallest x, y, z, then the largest.
# Example: `--workspace 0,0,0,500,0,400`
workspace-not-box = the workspace is not a box
    .expected = the smallest x, y, z, then the largest

# Means: An orientation has more or fewer angles than the robot has axes of rotation.
# Matters: The poses of the test cannot be commanded.
# Do: Give one finite angle for each axis of rotation.
# Example: `--orientation 0,90` for a spatial robot
angle-count = { $option } has { $count ->
        [one] 1 angle
       *[other] { $count } angles
    }
    .expected = { $angles }

# Means: A test plane is named for a planar robot.
# Matters: A planar robot has one plane only.
# Do: Omit the test plane.
# Example: `--plane c1-c2-c7-c8` for a five-bar robot
planar-test-plane = a planar robot has one test plane
    .hint = omit the test plane

# Means: The name of the test plane is unknown.
# Matters: The five poses of the test lie on this plane (ISO 9283, 6.8.2).
# Do: Use one of the planes that the standard names.
# Example: `--plane c1-c2`
test-plane-unknown = unknown test plane `{ $name }`
    .expected = { $planes }

# Means: Radius or duration of a standstill is zero, negative or not a number.
# Matters: No standstill could be found.
# Do: Give a radius above the noise of a standing robot, and a duration below the shortest stop.
# Example: `still_mm = 0`
standstill-thresholds = radius and duration of a standstill must be positive
    .hint = give a radius above the noise of a standing robot and a duration below the shortest stop

in-sample = sample { $sample }: { $message }

# Means: A recorded motion has fewer than two samples, or columns of different lengths.
# Matters: Velocity and path are undefined.
# Do: Record the motion again with all columns.
# Example: a recording of one row
stream-too-short = a recorded motion needs at least two samples with the same columns
    .hint = record the motion again

# Means: A coordinate, an angle or the time of a sample is missing or not finite.
# Matters: The path has a gap of unknown length.
# Do: Remove the row from the recording.
# Example: an empty cell in the column `x_mm`
stream-value-missing = a coordinate or the time is missing or non-finite
    .hint = remove this sample

# Means: The time stamp of a sample is not later than that of the previous sample.
# Matters: Velocities would be infinite or negative.
# Do: Sort the samples, or record with a finer time stamp.
# Example: two samples at 1.5 s
time-not-increasing = the time does not increase: { $later_s } s after { $earlier_s } s
    .hint = sort the samples, or record with finer time stamps

# Means: The centre line of the weave has no direction, or the swing is parallel to it.
# Matters: The stroke is measured across the centre line (ISO 9283, 11).
# Do: Give a swing direction across the centre line.
# Example: a centre line along x and `weave_across = [1, 0, 0]`
weave-direction = weaving: the swing has no direction across the centre line
    .hint = give a swing direction across the centre line

# Means: The commanded stroke or frequency of the weave is zero, negative or not a number.
# Matters: Weaving deviations are relative to the commanded values.
# Do: Give positive values.
# Example: `weave_hz = 0`
weave-command = weaving: commanded stroke and frequency must be positive
    .hint = give the commanded stroke and frequency

# Means: No sample of the recording belongs to the weave.
# Matters: Stroke and frequency are unknown.
# Do: Check where the weave begins and ends.
# Example: a weave after the end of the recording
weave-without-samples = weaving: no samples
    .hint = check where the weave begins and ends

# Means: The recording has too few turns of the weave.
# Matters: The first and the last turn are excluded; stroke and frequency need three others.
# Do: Record a longer weave.
# Example: a weave of one period
weave-too-few-turns = weaving: { $turns ->
        [one] 1 turn
       *[other] { $turns } turns
    }
    .expected = at least five, a quarter of the commanded stroke apart
    .hint = record a longer weave

# Means: No command point lies on the half of a leg beside the corner.
# Matters: Cornering deviations are evaluated there.
# Do: Give more command points.
# Example: command points at 0 mm and 10 mm, and a corner at 2 mm
corner-without-points = cornering: no command point on the half of a leg beside the corner
    .hint = give more command points

# Means: No commanded angle changes along the path.
# Matters: This characteristic needs a path with reorientation.
# Do: Give the commanded angles of the path.
# Example: a commanded path without angle columns
path-without-reorientation = path accuracy on reorientation: no commanded angle changes along the path
    .hint = give the commanded angles of the path

# Means: An angle of the commanded path is missing or not finite.
# Matters: Orientations along the path are unknown.
# Do: Give all angles at every point, or none.
# Example: an empty cell in the column `rz_deg`
commanded-angle-missing = commanded path: an angle is missing or non-finite
    .hint = give all angles at every point, or none

# Means: Two consecutive points of the commanded path coincide.
# Matters: The path has no direction there.
# Do: Remove one of the points; a rotation in place is not a path.
# Example: the same row twice
commanded-point-repeated = commanded path: points { $first } and { $second } coincide
    .hint = remove one of the two points

# Means: The commanded velocity is zero, negative or not a number.
# Matters: Velocity characteristics are relative to the commanded velocity (ISO 9283, 9.6).
# Do: Give the commanded velocity.
# Example: `velocity_mm_s = 0`
velocity-not-positive = path velocity: the commanded velocity must be positive
    .hint = give the commanded velocity

# Means: The central part of the path has fewer than three command points.
# Matters: Mean and fluctuation of the velocity need at least two intervals.
# Do: Give more command points, or a larger central part.
# Example: four command points and a central part of one half
velocity-too-few-points = path velocity: fewer than three command points in the central part
    .hint = give more command points, or a larger central part

# Means: A characteristic compares several sets, and there are too few.
# Matters: A comparison needs at least two sets.
# Do: Complete the measurements.
# Example: one set of cycles: drift compares sets over time
too-few-of = { $of }: { $sets }
    .expected = at least { $least }
    .hint = complete the measurements

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

# Means: The robots were not all measured at the same poses.
# Matters: Exchangeability compares robots pose by pose (ISO 9283, 7.5).
# Do: Measure every robot at every pose.
# Example: robot A at poses 1 to 5, robot B at poses 1 to 4
robots-at-other-poses = exchangeability: robots do not have the same poses
    .expected = at least two robots, each at every pose

# Means: A robot was not measured at a pose that other robots attained.
# Matters: Exchangeability compares robots pose by pose (ISO 9283, 7.5).
# Do: Measure the robot at this pose, or leave the pose out for all robots.
# Example: robot B without rows of pose 5
robot-without-pose = exchangeability: robot `{ $robot }` did not attain pose { $pose }
    .expected = every robot at every pose

# Means: Every visit of a pose was read once.
# Matters: The noise of the instrument is determined from several readings of one visit.
# Do: Take several readings at each visit.
# Example: one row for each cycle
visits-read-once = repeatability without noise: no visit has two readings
    .hint = take several readings at each visit: they determine the noise of the instrument

# Means: Three of the four mean positions lie on one line.
# Matters: They do not define a plane for the fourth position.
# Do: Name four poses that span a plane.
# Example: poses 1, 2 and 3 on an edge of the cube
coplanar-poses-on-line = coplanarity: three of the four mean positions lie on one line
    .hint = name four poses that span a plane

# Means: The two poses of a distance were not attained in the same cycles.
# Matters: The distance of a cycle needs both positions.
# Do: Exclude cycles that lack one of the poses.
# Example: 30 cycles at pose 2, 29 at pose 4
distance-counts-differ = distance: the two poses have { $first } and { $second } positions
    .expected = both poses in the same cycles

# Means: A force is zero, negative or not a number.
# Matters: The sign of a load is given by its direction.
# Do: Give the magnitude of the force.
# Example: `force_n = -50`
force-not-positive = static compliance: a force is not positive
    .expected = the magnitude of the force; its direction gives the sign

# Means: A cycle of a load has no row without force.
# Matters: The deflection is the distance from the unloaded position.
# Do: Record the unloaded position with force 0 in each cycle.
# Example: a table with forces of 50 N only
unloaded-position-missing = direction { $direction }, cycle { $cycle }: no row without force
    .hint = record the unloaded position with force 0

# Means: No row of the table has a force.
# Matters: Compliance is deflection by force.
# Do: Give the forces in `force_n`.
# Example: a table whose column `force_n` is 0 everywhere
force-missing = no row has a force
    .hint = give the force of each loaded row

no-working-mode-reaches = no working mode reaches it within the limits
