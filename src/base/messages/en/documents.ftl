### Messages of documents. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: Limits are stated, and the table has rows of several robots.
# Matters: AP and RP limits are those of one robot.
# Do: Test each robot by itself; all together give the exchangeability.
# Example: `--rp-limit-mm 0.05` with rows of robots A and B
limits-for-several-robots = limits are stated for one robot, and the table has { $robots }
    .hint = test each robot by itself; all together give the exchangeability

# Means: Poses were attained in fewer cycles than ISO 9283 requires.
# Matters: The intervals of AP and RP are wider.
# Do: Measure 30 cycles, or judge with the intervals.
# Example: 10 cycles at pose 1
few-cycles = fewer than { $least } cycles at pose { $poses }
    .hint = measure 30 cycles (ISO 9283), or judge with the intervals

# Means: A direction was loaded in fewer cycles than ISO 9283 requires.
# Matters: The compliance in this direction is less certain.
# Do: Measure more cycles.
# Example: one cycle in direction +x
few-cycles-of-direction = fewer than { $least } cycles in direction { $directions }
    .hint = measure more cycles

# Means: The expanded uncertainty of the instrument exceeds a quarter of the verified value (ISO
# 9283, 6.6).
# Matters: The scatter is partly that of the instrument: the values are upper bounds of the robot's.
# Do: Measure with a better instrument.
# Example: RP of 0.02 mm measured with U = 0.01 mm
instrument-too-coarse = the measurement uncertainty exceeds 25 % of the verified value at pose { $poses }
    .hint = use the values as upper bounds, or measure with a better instrument

# Means: Poses were approached from several directions.
# Matters: ISO 9283 defines AP and RP for one approach (7.2). Values of all visits contain vAP as
# well.
# Do: Use the values of each approach, which are listed beside.
# Example: pose 1 attained from +x and from −x
several-approaches = several approaches at pose { $poses }: AP, RP and their intervals are those of all visits together
    .hint = use the values of each approach: those of all visits contain vAP, and their scatter is not Gaussian

# Means: The recording has no complete pass of the commanded path.
# Matters: AT, RT and velocities cannot be evaluated.
# Do: Check that recording and path are in the same frame and direction; `--near-mm` allows larger
# deviations.
# Example: a path commanded in the base frame, recorded in the world frame
path-without-pass = the recording has no pass of the commanded path
    .expected = a motion through { $planes } planes, each within { $near_mm } mm of the path
    .hint = check frame and direction of recording and path; `--near-mm` allows larger deviations

# Means: Samples lie farther from the one before than a robot moves in this time.
# Matters: They are errors of the instrument, for example a beam break, and are left out.
# Do: Check the lines in the recording.
# Example: a jump of 1 m between two samples at 1 kHz
samples-too-fast = { $count ->
        [one] 1 sample
       *[other] { $count } samples
    } left out: faster than a robot moves
    .hint = check line { $lines }

# Means: A velocity is commanded for a path that is the centre line of a weave.
# Matters: The tool moves along the weave, not along the centre line.
# Do: Drive the path without weaving to evaluate velocities.
# Example: `velocity_mm_s` and `weave_hz` together
weave-velocity-not-compared = the commanded velocity is not compared: the path is the centre line of a weave
    .hint = drive the path without weaving to evaluate velocities

# Means: The robot does not stay within the limit band after an arrival.
# Matters: Stabilisation time and overshoot of these arrivals are undefined.
# Do: State a limit band wider than the noise of the standing robot.
# Example: `band_mm = 0.001` with noise of 0.01 mm
arrivals-unsettled = arrivals that do not settle within the limit band: at { $times_s } s
    .hint = state a limit band wider than the noise of the standing robot

# Means: Passes of the path were begun and not completed.
# Matters: They are left out of AT and RT.
# Do: Check whether the recording is cut off. Where the robot rounds off a corner widely, a larger
# `near_mm` leaves out more of it.
# Example: a recording that ends in the middle of the path
passes-incomplete = { $count ->
        [one] 1 pass
       *[other] { $count } passes
    } begun and not completed: left out
    .hint = check whether the recording is cut off; where corners are rounded off widely, state a larger near_mm (`--near-mm`)

# Means: The part of the path where velocities are evaluated holds a corner.
# Matters: A robot that slows down there has worse AV, RV and FV.
# Do: State a path without the corner, or a smaller central part.
# Example: an L-shaped path
corner-in-central-part = the central part of the path holds a corner at { FIXED($at_mm, 3) } mm
    .hint = state a path without the corner, or a smaller central part: slowing down there affects AV, RV and FV

# Means: The minimum zone is proved to be the narrowest among neighbouring elements only.
# Matters: Another element farther away may have a narrower zone.
# Do: Compare the form deviation with that of the least-squares fit.
# Example: a short arc with large form deviation
zone-proved-locally = the minimum zone is proved the narrowest among neighbouring elements ({ $element }) only
    .hint = compare its form deviation with that of the least-squares fit

# Means: It was not proved that the found zone is the narrowest.
# Matters: The true form deviation may be smaller.
# Do: Measure more of the surface.
# Example: points that hardly show the element
zone-unproved = it was not proved that no other { $element } has a narrower zone
    .hint = measure more of the surface: points this scattered hardly show the element

hold-another = to hold another parameter of such a group, name it under `hold` in [identify]; by default the last one of the model is held

set-up-origin = { $origin ->
        [unit] `unit` of the export
       *[world-frame] `unit` and labels of the points that define it
    }

check-rigid-part = check unit and names in `places_mm`, and whether the part was changed since they were determined

# Means: Points are farther from the element of all others than noise explains, and are not used.
# Matters: The element and its uncertainty are those of the other points.
# Do: Look at these points; remove them where the cause is known.
# Example: dust under the probe at one of 60 points
points-set-aside = { $count ->
        [one] 1 point is set aside
       *[other] { $count } points are set aside
    }: { $points }
    .hint = they are farther from the element of all others than noise explains

# Means: Some points are far from the element of all others, and shift the fit by more than its
# uncertainty.
# Matters: Least squares spreads the error of a foreign point over the element; form and uncertainty
# are those of the foreign points.
# Do: Look at these points. Fit with `--robust`, which sets them aside and lists them, or remove them.
# Example: one point of the edge among those of a plane
foreign-points = { $count ->
        [one] 1 point is
       *[other] { $count } points are
    } far from the element of all others ({ $points }): the fit is shifted by { FIXED($shift, 1) } standard uncertainties
    .hint = look at them; `--robust` sets them aside
