### Messages of documents. Above each message: its explanation (see CONTRIBUTING.md, "A message").

action-load-or-compensate = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    } into your own software; for a controller with nominal geometry, correct its programs with `etalon compensate`

# Means: Limits are stated, and the table has rows of several robots.
# Matters: Limits of AP and RP apply to one robot.
# Do: Test each robot separately; only exchangeability is evaluated from all robots together.
# Example: `--rp-limit-mm 0.05` with rows of robots A and B
limits-for-several-robots = limits apply to one robot, but the table has { $robots }
    .hint = test each robot separately; only exchangeability is evaluated from all robots together

# Means: Poses were attained in fewer cycles than ISO 9283 requires.
# Matters: The intervals of AP and RP are wider.
# Do: Measure 30 cycles, or judge with the intervals.
# Example: 10 cycles at pose 1
few-cycles = fewer than { $least } cycles at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = measure 30 cycles (ISO 9283), or judge with the intervals

# Means: A direction was loaded in fewer cycles than ISO 9283 requires.
# Matters: The compliance in this direction is less certain.
# Do: Measure more cycles.
# Example: one cycle in direction +x
few-cycles-of-direction = fewer than { $least } cycles in { $count ->
        [one] direction { $directions }
       *[other] directions { $directions }
    }
    .hint = measure more cycles

# Means: The expanded uncertainty of the instrument exceeds a quarter of the characteristic (ISO
# 9283, 6.6).
# Matters: The instrument causes part of the scatter. RP is an upper bound for the robot; AP is not
# bounded.
# Do: Measure with a better instrument.
# Example: RP of 0.02 mm measured with U = 0.01 mm
instrument-too-coarse = the measurement uncertainty exceeds 25 % of the verified value at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = use the values as upper bounds, or measure with a better instrument

# Means: The positions of a pose change over the cycles by more than their scatter explains (Student's
# test of a straight line, level 0.1 % for all poses together), and no sets of cycles are stated.
# Matters: AP and RP contain this drift: the same test after warming up gives other values.
# Do: State `drift_set`, the number of cycles of a set, to evaluate the drift (ISO 9283, 7.6), or
# warm the robot up before the test.
# Example: thirty cycles from a cold start
positions-drift = the position of pose { $pose } changes by { FIXED($change_mm, 3) } mm from the first to the last cycle: AP and RP contain this drift
    .hint = state `drift_set` in [poses] (`--drift-set`), or warm the robot up before the test

# Means: Poses were approached from several directions.
# Matters: ISO 9283 defines AP and RP for one approach (7.2). Values of all visits contain vAP as
# well.
# Do: Use the values of each approach, which are listed separately.
# Example: pose 1 attained from +x and from −x
several-approaches = several approaches at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }: AP, RP and their intervals include all visits
    .hint = use the values of each approach: values of all visits contain vAP, and their scatter is not Gaussian

# Means: In another unit the coordinates agree with those of the other table: they are not in mm.
# Matters: AP, AD, AT and all other characteristics would be those of the unit.
# Do: Name the columns by their unit (`x_m`), or convert them to mm.
# Example: `x_mm` = 0.4 at a pose that is commanded to x = 400 mm
positions-in-other-unit = { $axes } of the { $table ->
        [commanded] commanded positions
        [robot] positions of the robot { $robot }
       *[attained] attained positions
    } { $count ->
        [one] is
       *[other] are
    } in { $unit }, not in mm: times { $length_mm } { $count ->
        [one] it agrees
       *[other] they agree
    } with the other table
    .hint = name the columns by their unit (`x_m`), or convert them to mm

# Means: The attained positions are as far from the commanded ones as the test is large, and one motion
# brings them together: the tables are in different frames.
# Matters: AP and AT contain the distance of the frames; RP, AD and RT do not.
# Do: Express both tables in one frame, e.g. that of the robot's base.
# Example: commanded poses in a work object, attained poses in the tracker's frame
poses-in-other-frame = the attained positions are { FIXED($deviation_mm, 1) } mm from the commanded ones, because the tables are in different frames: after a shift of the centre by ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm{ $turned ->
        [turned] {" "}and a rotation by { FIXED($turn_deg, 1) } deg
       *[shifted] {""}
    }, { FIXED($left_mm, 3) } mm remain
    .hint = express both tables in one frame; AP and AT contain the distance of the frames, RP and RT do not

# Means: The attained positions are as far from the commanded ones as the test is large; neither another
# unit nor another frame explains it.
# Matters: No robot has such errors: the tables do not belong together.
# Do: Check the names of the poses, and the columns, in both tables.
# Example: two poses exchanged in the table of commanded poses
deviation-as-large-as-test = the attained positions are { FIXED($deviation_mm, 1) } mm from the commanded ones, as far as the test is large ({ FIXED($extent_mm, 1) } mm); farthest: { $poses }
    .hint = check the names of the poses and the columns in both tables

# Means: Two of the three rotations have nearly the same axis there: only the sum or the difference of
# their angles is determined, and noise of the orientation is amplified in each.
# Matters: AP and RP of the angles would be meaningless; they are not given. With a stated order,
# rotation vectors replace them.
# Do: State the order of the rotations, or record the angles in an order whose middle rotation is far
# from this angle.
# Example: b = 90 deg with the order Rz(c) Ry(b) Rx(a), as at the flange of many arms
angles-not-separable = the angles { $first } and { $second } { $place } { $order ->
        [stated] are not separable: their rotations have nearly the same axis, and each angle alone means nothing
       *[unknown] vary together, by far more than their sum or difference: their rotations have nearly the same axis, and each angle alone means nothing
    }
    .hint = { $order ->
        [stated] use the rotation vectors (AP rx to RP rz), or record the angles in another order of rotations
       *[unknown] state the order of all three angles of poses (`--rotation-order "Rz(c) Ry(b) Rx(a)"`, in a campaign `rotation_order`): rotation vectors are then evaluated; or record the angles in another order
    }

angles-of-poses = at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }

angles-of-path = on the path

angles-of-standstills = at { $count ->
        [one] the standstill from { $times_s } s
       *[other] { $count } standstills (from { $times_s } s)
    }

# Means: The recording has no complete pass of the commanded path.
# Matters: AT, RT and velocities cannot be evaluated.
# Do: Check that recording and path are in the same frame and direction; `--near-mm` allows larger
# deviations.
# Example: a path commanded in the base frame, recorded in the world frame
path-without-pass = the recording has no pass of the commanded path
    .expected = a motion through { $planes } planes, each within { $near_mm } mm of the path
    .hint = check frame and direction of recording and path; `--near-mm` allows larger deviations

# Means: The distance of a sample from the previous one is larger than any robot moves in this time.
# Matters: They are errors of the instrument, for example a beam break, and are left out.
# Do: Check the lines in the recording.
# Example: a jump of 0.5 m within 0.01 s
samples-too-fast = { $count ->
        [one] 1 sample
       *[other] { $count } samples
    } left out: faster than a robot moves
    .hint = check the recording at { $count ->
            [one] line { $lines }
           *[other] lines { $lines }
        }

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
# Do: Check whether the recording is cut off. If the robot rounds off a corner widely, a larger
# `near_mm` excludes more of the corner.
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

# Means: The minimum zone is proved to be the narrowest only among neighbouring elements.
# Matters: Another element farther away may have a narrower zone.
# Do: Compare the form deviation with that of the least-squares fit.
# Example: ten points of a cylinder
zone-proved-locally = the minimum zone is proved to be the narrowest only among neighbouring elements ({ $element })
    .hint = compare its form deviation with that of the least-squares fit

# Means: The zone found was not proved to be the narrowest.
# Matters: The true form deviation may be smaller.
# Do: Measure more of the surface.
# Example: nine points that hardly show a cylinder
zone-unproved = a narrower zone of the { $element } cannot be excluded
    .hint = measure more of the surface: the element is hardly visible in the scatter of the points

hold-another = to hold another parameter of the group, name it under `hold` in [identify]; by default the parameter whose tolerance moves the targets least is held

set-up-origin = { $origin ->
        [unit] `unit` of the export
       *[world-frame] `unit` and labels of the points that define it
    }

check-rigid-part = check unit and names in `places_mm`, and whether the part was changed since they were determined

plan-cube = the largest { $shape } in the stated workspace, edges parallel to the axes; C1 to C4 from the smallest x and y
plan-poses = P1: centre; P2 to P5: on the diagonals, at 10 % of their length from the corners of the test plane, in the order of the corners
plan-clauses = P1 to P5, loads, velocities and 30 cycles follow the standard's text; paths, other counts and the order of the corners were not compared with a bought copy
plan-reach-not-examined = motion of all joints between poses, and reachability of the poses, were not examined
plan-reach = reach: nominal parameters and the limits of the robot file; one working mode for each list of poses: the one that reaches most of them; { $moves ->
        [all] all joints move between the poses P1 to P5
       *[some] not all joints move between the poses P1 to P5; the standard requires it
    }
covariance-not-square = its covariance is not a square matrix with one row for each of { $identified } identified parameters
uncertainty-negative = a standard uncertainty or variance is negative or not a number
parameter-listed-twice = it lists the parameter `{ $parameter }` twice

method-levenberg-marquardt = Levenberg-Marquardt on block QR with scaled columns, Gauss-Newton finish
method-enclosing = smallest enclosing element, defined by { $points } points
method-minimum-zone = minimum zone (Chebyshev)
action-add-cycles = visit pose{ $count ->
        [one] {" "}{ $poses }
       *[other] s { $poses }
    } at least { $required } times
action-add-cycles-reason = one pose has only { $least } visits, so that intervals of AP and RP are wide
action-add-effect = add `{ $line }` to robot.toml
action-add-effect-reason = root-mean-square error at left-out poses: { $without } → { $with }
action-add-validation = measure poses that validate the parameters, and name them in `validation` of [identify]
action-add-validation-reason = errors at calibration poses are smaller than errors at new poses
action-agree-rule = agree with the customer on a decision rule for the { $limit }
action-agree-rule-reason = the limit lies within U = { $present }; a decision needs { $required }, about { $times } times as many readings. `decision_rule = "simple-acceptance"` in [limits] compares the value itself
action-compensate = if the controller computes with nominal geometry, load no file: correct its programs with `etalon compensate` and `--field { $file }`, which adds errors that no parameter describes
action-compensate-reason = root-mean-square error at { $count } held-out poses: { $without } → { $with }
action-verify = test the loading: at a few poses, compare the pose that the controller shows with `etalon kinematics direct` for parameters.json. If they differ, restore the file that the controller had
action-verify-reason = save that file before loading. Later, `etalon verify` reports from a few measured poses whether base or robot have changed; `--candidates` chooses these poses
action-finer-instrument = measure with an expanded uncertainty of a position of at most { $uncertainty }
action-finer-instrument-reason = at pose { $pose }, U = { $uncertainty } is { $percent } % of the characteristic; ISO 9283 allows 25 %, which { $count ->
        [one] pose { $poses } exceeds
       *[other] poses { $poses } exceed
    }
action-keep-nominal = { $count ->
        [0] keep the nominal parameters
       *[other] do not load { $formats }
    }
action-keep-nominal-reason = RMS error { $rms }, largest { $max }; nominal parameters: { $nominal_rms } and { $nominal_max }
action-load = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    }
action-load-reason = root-mean-square error ({ $quantity }) at { $count } { $set ->
        [validation] validation
       *[calibration] calibration
    } poses: nominal { $nominal }, identified { $expected }
action-load-synthetic = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    } into a simulated controller, not into a robot: the data are synthetic
action-measure-again = measure { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    } again{ $more ->
        [0] {""}
        [one] {" "}(1 further pose disagrees)
       *[other] {" "}({ $more } further poses disagree)
    }
action-measure-again-reason = pose { $pose } disagrees with the others: { $error }, { $times } σ
action-measure-quantity = measure the quantity of `{ $limit }` at the judged poses, or remove the limit
action-measure-quantity-reason = a limit on a quantity that was not measured cannot be assessed
action-meet-limit = find the cause of the errors: { $limit }
action-meet-limit-at-pose = find the cause of the error at pose { $pose }: { $limit }
action-meet-limit-reason = { $value }, limit { $limit }: exceeded by { $beyond }
action-prove-effects = state `{ $line }` in [identify]
action-reduce-uncertainty = reduce the uncertainty of the { $limit }
action-reduce-uncertainty-by-source = U = { $present }; a decision needs { $required }; largest share: { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present }; a decision needs { $required }
action-resolve = decide how to treat this warning
action-state-limits = state the tolerance of the application in [limits]
action-state-limits-reason = a verdict needs limits
action-warm-up = warm the robot up before the test, and state `warm_up_minutes`
action-warm-up-cold = the robot was tested cold
action-warm-up-drift = AP drifts by { $change } in { $cycles } cycles and has not settled

# Means: The field names a joint, parameter or model that the robot does not have.
# Matters: A field holds for one robot alone.
# Do: Use the robot file and the field of the same campaign.
# Example: `--field` with the field.json of another robot
field-of-other-robot = the residual field belongs to another robot: `{ $name }`
    .hint = use the field.json of the run that identified this robot

# Means: A number of the field is missing, not finite, or out of its range.
# Matters: The errors of the joints cannot be computed.
# Do: Run the campaign again.
# Example: a field.json with a row of the covariance deleted
field-inconsistent = the residual field is inconsistent
    .hint = run the campaign again

field-needs-positions = the readings of a residual field are positions of targets, without conditions, rigid parts, platforms and stated covariances
field-needs-poses = { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    }; a residual field needs { $needed }
field-readings-suspect = at held-out pose { $pose } the error with the field is { FIXED($error_mm, 3) } mm, more than 8 times the median of all poses: its readings are suspect
field-undetermined = the positions do not determine the parameters in every part of the poses
field-not-shown = the residuals show no dependence on the joints: the likelihood rises by { FIXED($rise, 1) }, and { FIXED($threshold, 1) } is required (−2 ln L)
field-not-proven = at held-out poses the position error is { FIXED($without_mm, 3) } mm without and { FIXED($with_mm, 3) } mm with the field (root mean square); the gain is { FIXED($gain, 1) } of its standard uncertainties, and 2.3 are required

zeros-of-the-joints = zeros of the joints
geometry = geometry
gains = gains
harmonics-of-the-transmissions = harmonics of the transmissions
backlash = backlash
coupling = coupling
bending = bending
payload-bending = bending under the payload
torque-bending = bending under the torques of the joints
expansion-with-temperature = expansion with the temperature
drift-with-temperature = drift of the zeros with the temperature
lateral-bending = tilt of the joints across their axes
pedestal-bending = tilt of the base under the arm
