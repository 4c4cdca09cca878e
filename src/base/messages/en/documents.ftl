### Messages of documents. Above each message: its explanation (see CONTRIBUTING.md, "A message").

action-load-or-compensate = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    } into your own software: no controller reads it. For a controller, add its format to `controllers`, or correct its programs with `etalon compensate`

# Means: Limits are given, but the table contains rows of several robots.
# Matters: The limits of AP and RP apply to a single robot.
# Do: Test each robot separately. Only exchangeability is evaluated from all robots together.
# Example: `--rp-limit-mm 0.05` with rows of robots A and B
limits-for-several-robots = limits apply to a single robot, but the table contains { $robots }
    .hint = test each robot separately; only exchangeability is evaluated from all robots together

# Means: Some poses were measured in fewer cycles than ISO 9283 requires.
# Matters: The intervals of AP and RP are wider.
# Do: Measure 30 cycles; otherwise use the intervals of AP and RP for the decision.
# Example: 10 cycles at pose 1
few-cycles = fewer than { $least } cycles at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }

decide-by-intervals = measure 30 cycles (ISO 9283), or use the intervals for the decision
measure-cycles = measure 30 cycles (ISO 9283): one or two cycles have no intervals

# Means: A limit is decided, but the uncertainty of the instrument is not given.
# Matters: The guard band contains the scatter of the cycles alone, so a robot may pass that does
# not meet the limit. The 25 % rule of ISO 9283 is not checked.
# Do: Give the expanded uncertainty (k = 2) of a measured coordinate.
# Example: `--ap-limit-mm 0.4` without `--expanded-uncertainty-um`
limits-without-instrument = the limits are decided without the uncertainty of the instrument: U contains the scatter of the cycles alone
    .hint = give the expanded uncertainty of a measured coordinate: `--expanded-uncertainty-um`

# Means: A direction was loaded in fewer cycles than ISO 9283 requires.
# Matters: The compliance in this direction has a larger uncertainty.
# Do: Measure more cycles with a load in this direction.
# Example: one cycle in direction +x
few-cycles-of-direction = fewer than { $least } cycles in { $count ->
        [one] direction { $directions }
       *[other] directions { $directions }
    }
    .hint = measure more cycles with a load in this direction

# Means: The expanded uncertainty of the instrument exceeds a quarter of the characteristic (ISO
# 9283, clause 6).
# Matters: The instrument causes part of the scatter. RP is larger than the robot's
# repeatability; AP is not bounded.
# Do: Use the upper end of the interval of RP, or measure with a more accurate instrument.
# Example: RP of 0.02 mm measured with U = 0.01 mm
instrument-too-coarse = the measurement uncertainty exceeds 25 % of the verified value at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = use the upper end of the interval of RP, or measure with a more accurate instrument

# Means: The position of a pose changes systematically over the cycles, and no sets of cycles are
# given. The test is Student's test of a straight line, level 0.1 % for all poses together.
# Matters: AP and RP include this drift: after warming up, the same test gives other values.
# Do: Set `drift_set`, the number of cycles of a set, to evaluate the drift (ISO 9283, 7.6), or warm
# the robot up before the test.
# Example: thirty cycles from a cold start
positions-drift = the position of pose { $pose } changes by { LENGTH($change_mm) } from the first to the last cycle: AP and RP include this drift
    .hint = set `drift_set` in [poses] (`--drift-set`), or warm the robot up before the test

# Means: Some poses were approached from several directions.
# Matters: ISO 9283 defines AP and RP for one approach (7.2). Values of all visits together also
# include vAP. Intervals, limits and the 25 % rule therefore apply to each approach by itself.
# Do: Use the values of each approach: the report gives them separately.
# Example: pose 1 attained from +x and from −x
several-approaches = several approaches at { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }: intervals, limits and the 25 % rule apply to each approach
    .hint = use the values of each approach: values of all visits together include vAP

# Means: The coordinates of one table are in another unit than mm: after a conversion they agree
# with the other table.
# Matters: AP, AD, AT and all other characteristics are wrong by the factor between the units.
# Do: Write the unit into the names of the columns (`x_m`, `x_inch`), or convert the values to mm.
# Example: `x_mm` = 0.4 at a pose that is commanded to x = 400 mm
positions-in-other-unit = { $axes } of the { $table ->
        [commanded] commanded positions
        [robot] positions of the robot { $robot }
       *[attained] attained positions
    } { $count ->
        [one] is
       *[other] are
    } in { $unit }, not in mm: multiplied by { $length_mm } { $count ->
        [one] it agrees
       *[other] they agree
    } with the other table
    .hint = { $unit ->
        [cm] multiply these columns by 10
       *[other] write the unit into the names of the columns (`x_{ $unit }`), or convert the values to mm
    }

# Means: The attained positions agree with the commanded ones after a change of the columns of one
# table. Two columns are swapped, all have another order, or one has the other sign.
# Matters: AP, AD and AT contain the wrong coordinates; RP of the position does not.
# Do: Correct the columns of the table that is wrong. In Python `columns` gives each table its own
# headings.
# Example: the headings `x_mm` and `y_mm` are swapped in the table of attained poses
coordinates-exchanged = the attained positions are { FIXED($deviation_mm, 1) } mm from the commanded ones; with { $change ->
        [swapped] { $columns } of one table swapped
        [order] x, y, z in the columns { $columns } of the attained positions
       *[sign] the other sign of { $columns } in one table
    }, { FIXED($left_mm, 3) } mm remain
    .hint = correct these columns in the table that is wrong; until then AP and AT are wrong, and RP of the position is right

# Means: A common shift and rotation of all positions explains nearly all of the deviation of the
# attained positions from the commanded ones. Usually the tables are in different frames.
# Matters: AP and AT contain the distance between the frames; RP, AD and RT do not.
# Do: Express both tables in one frame, for example the base frame of the robot. If they are in one
# frame, base or tool of the robot are wrong by this motion.
# Example: commanded poses in a work object, attained poses in the tracker's frame
poses-in-other-frame = attained positions are { FIXED($deviation_mm, 1) } mm from commanded ones; without their common shift of ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }, { FIXED($z_mm, 1) }) mm{ $turned ->
        [turned] {" "}and rotation of { FIXED($turn_deg, 1) } deg
       *[shifted] {""}
    }, { FIXED($left_mm, 3) } mm remain
    .hint = express both tables in one frame; AP and AT contain the distance between the frames, RP and RT do not

# Means: The distances between attained and commanded positions are as large as the whole test.
# No other unit, order of the columns or frame explains them.
# Matters: No robot has such errors, so the two tables do not belong together.
# Do: Compare the names of the poses and the columns in both tables: two poses may be swapped.
# Example: two poses swapped in the table of commanded poses
deviation-as-large-as-test = the attained positions are { FIXED($deviation_mm, 1) } mm from the commanded ones; the whole test spans { FIXED($extent_mm, 1) } mm; largest distances at: { $poses }
    .hint = check the names of the poses and the columns in both tables

# Means: The angles of one table are radians under headings of degrees: multiplied by 57.3 they
# agree with the other table.
# Matters: AP and RP of all angles are wrong by this factor.
# Do: Write the unit into the names of the columns (`a_rad`), or convert the values to degrees.
# Example: `c_deg` = 0.5236 at a pose that is commanded to c = 30 deg
angles-in-other-unit = the { $table ->
        [commanded] commanded
       *[attained] attained
    } { $count ->
        [one] angle { $angles } is
       *[other] angles { $angles } are
    } in radians, not in degrees: multiplied by 57.29578 { $count ->
        [one] it agrees
       *[other] they agree
    } with the other table
    .hint = write the unit into the names of the columns (`a_rad`), or convert the values to degrees

# Means: At some poses an attained angle is more than 5 deg from the commanded one.
# Matters: No robot has such errors, so the angles of the two tables do not belong together. AP of
# the angles is wrong; RP of the angles is correct.
# Do: Compare columns, order of the rotations and frame of the angles in both tables.
# Example: the columns `a_deg` and `c_deg` are swapped in one table
angles-far-from-commanded = attained angles ({ $angles }) are up to { FIXED($deviation_deg, 1) } deg from the commanded ones; largest deviations at: { $poses }
    .hint = check that the columns a, b, c of both tables belong to the same rotations, in the same order and frame

# Means: The text is not an order of the rotations a, b, c.
# Matters: Orientations, and angles that are not separable, depend on this order.
# Do: Write the three rotations in the order of multiplication, each about an axis by one of the
# angles. `Rz(c) Ry(b) Rx(a)` turns by a about the fixed x axis first.
# Example: `rotation_order = "zyx"`
rotation-order-unknown = `{ $text }` is not an order of the rotations a, b, c
    .expected = three rotations about x, y or z by a, b and c, multiplied from left to right

rotation-orders = `rotation_order = "Rz(c) Ry(b) Rx(a)"` (option --rotation-order) if a, b, c turn about the fixed axes x, y, z; `rotation_order = "Rz(a) Ry(b) Rx(c)"` if they turn about z, y, x of the moved body
rotation-orders-of-axes = `rotation_order = "{ $by_axis }"` (option --rotation-order) if a, b, c are the angles about x, y, z; `rotation_order = "{ $by_place }"` if a, b, c are the angles in the order of these axes

# Means: Some readings are far from all others of their pose, and from the readings before and
# after them.
# Matters: AP and RP contain these readings: a single one may be most of RP. ISO 9283 excludes no
# reading.
# Do: Check labels and values: exchanged labels, a placeholder, a motion. If the cause is known,
# correct or remove the row and record the reason; otherwise repeat the test.
# Example: pose P3 of cycle 9 is 5.0 mm from the others, whose distances are 0.02 mm
readings-outlying = { $count ->
        [one] 1 reading is
       *[other] { $count } readings are
    } far from all others of the pose, and AP and RP contain { $count ->
        [one] it
       *[other] them
    }: { $readings }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
    .hint = check labels and values: correct or remove a row only if the cause is known, and record the reason; otherwise repeat the test

outlying-reading = pose { $pose } in cycle { $cycle }, { LENGTH($distance_mm) } (median distance { LENGTH($median_mm) })
outlying-reading-near = pose { $pose } in cycle { $cycle }, { LENGTH($distance_mm) } (median distance { LENGTH($median_mm) }; nearer to pose { $near })

# Means: Some runs are far from all others of their position and direction, and from the runs before
# and after them.
# Matters: A and R contain these runs: a single one may be most of A. ISO 230-2 excludes no run.
# Do: Check the values: another position, a lost signal, a wrong digit. If the cause is known, correct
# or remove the row and record the reason. Otherwise repeat the test.
# Example: run 4 to 200 mm is 0.2 mm from the other runs, which scatter by 0.001 mm
runs-outlying = { $count ->
        [one] 1 run is
       *[other] { $count } runs are
    } far from all others of the position and direction, and A and R contain { $count ->
        [one] it
       *[other] them
    }: { $runs }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
    .hint = check these values: correct or remove a row only if the cause is known, and record the reason; otherwise repeat the test

outlying-run = run { $run } to { $position_mm } mm in direction { $direction }, { FIXED($distance_mm, 4) } mm (median distance { FIXED($median_mm, 4) } mm)

# Means: All runs of the table occur several times, equal in every digit: the rows were copied.
# Matters: Copies are no further measurements. The estimated scatter is too small, and so are R and A.
# Do: Remove the copied rows.
# Example: two files of the same test, one behind the other
runs-repeated = the table contains the same runs { $times } times, digit for digit: R and A are too small
    .hint = remove the copied rows

# Means: The axis was measured at fewer positions, or with fewer runs, than ISO 230-2 requires.
# Matters: R and A of few runs and positions have a large uncertainty.
# Do: Measure at least five positions, each five times in each direction.
# Example: three positions with two runs in each direction
axis-test-short = the axis has { $positions } positions with at least { $runs } runs in each direction; ISO 230-2 requires { $least } of both
    .hint = measure at least { $least } positions with { $least } runs in each direction

# Means: Some readings equal an earlier reading of their pose in every digit: rows were copied.
# Matters: Copies are no further cycles. RP is wrong, and its interval is too narrow.
# Do: Remove the copied rows.
# Example: the same table twice, with cycles counted by `cycle = "visit"`
readings-repeated = { $count ->
        [one] 1 reading repeats
       *[other] { $count } readings repeat
    } an earlier reading digit for digit: { $readings }{ $more ->
        [0] {""}
       *[other] {" "}and { $more } more
    }
    .hint = remove the copied rows: they are no further cycles

repeated-reading = pose { $pose } in cycle { $cycle } as in cycle { $first }

# Means: The mean velocity on the path differs from the commanded one by more than a factor of five.
# Matters: No robot has such an error: AV is wrong, because a velocity or a time is in another unit.
# Do: Give the commanded velocity in mm/s, and the time stamps in s.
# Example: `--velocity-mm-s 0.25` for 250 mm/s
path-velocity-far = the mean velocity on the path is { FIXED($mean_mm_s, 3) } mm/s, the commanded one { FIXED($commanded_mm_s, 3) } mm/s
    .hint = give the commanded velocity in mm/s (`--velocity-mm-s`) and the time stamps in s

# Means: Two of the three rotations have nearly the same axis at these poses. Only the sum or the
# difference of their angles is determined; noise of the orientation is amplified in each angle.
# Matters: AP and RP of these angles have no meaning and are not computed. If the order of rotations
# is given, rotation vectors replace them.
# Do: Give the order of rotations, or record the angles in an order whose middle rotation is far
# from this angle.
# Example: b = 90 deg with the order Rz(c) Ry(b) Rx(a), as at the flange of many arms
angles-not-separable = the angles { $first } and { $second } { $place } { $order ->
        [stated] are not separable: their rotations have nearly the same axis, so a single angle has no meaning
       *[unknown] vary together, far more than their sum or difference: their rotations have nearly the same axis, so a single angle has no meaning
    }
    .hint = { $order ->
        [stated] use the rotation vectors (AP rx to RP rz), or record the angles in another order of rotations
       *[unknown] give the order of all three angles of poses (`--rotation-order "Rz(c) Ry(b) Rx(a)"`, in a campaign `rotation_order`): rotation vectors are then evaluated; or record the angles in another order
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
# Do: Check that the recording and the path have the same frame and the same direction. `--near-mm`
# allows larger deviations.
# Example: a path commanded in the base frame, recorded in the world frame
path-without-pass = the recording has no pass of the commanded path
    .expected = a motion through { $planes } planes, each within { $near_mm } mm of the path
    .hint = check the frame and the direction of recording and path; `--near-mm` allows larger deviations

# Means: Some samples are farther from the previous sample than any robot can move in this time.
# Matters: These samples are errors of the instrument, for example after a beam break. They are
# excluded.
# Do: Look at these lines of the recording. If the samples are right, check the unit of length and
# of time.
# Example: a jump of 0.5 m within 0.01 s
samples-too-fast = { $count ->
        [one] 1 sample
       *[other] { $count } samples
    } excluded: faster than any robot moves
    .hint = check the recording at { $count ->
            [one] line { $lines }
           *[other] lines { $lines }
        }

# Means: A velocity is commanded, but the path is the centre line of a weave.
# Matters: The tool moves along the weave, not along the centre line.
# Do: To evaluate velocities, record the path without weaving.
# Example: `velocity_mm_s` and `weave_hz` together
weave-velocity-not-compared = the commanded velocity is not compared: the path is the centre line of a weave
    .hint = to evaluate velocities, record the path without weaving

# Means: After some arrivals, the robot does not stay within the limit band.
# Matters: Stabilisation time and overshoot of these arrivals are undefined.
# Do: Increase `band_mm` until it exceeds the noise of the standing robot.
# Example: `band_mm = 0.001` with noise of 0.01 mm
arrivals-unsettled = arrivals that do not settle within the limit band: at { $times_s } s
    .hint = give a limit band that is wider than the noise of the standing robot

# Means: The recording contains incomplete passes of the path.
# Matters: AT and RT do not include these passes.
# Do: Check whether the recording ends too early. If the robot rounds off a corner, a larger
# `near_mm` excludes more of the corner.
# Example: a recording that ends in the middle of the path
passes-incomplete = { $count ->
        [one] 1 pass
       *[other] { $count } passes
    } incomplete: excluded
    .hint = check whether the recording ends too early; if corners are rounded off widely, give a larger near_mm (`--near-mm`)

# Means: The recording contains fewer passes of the path than ISO 9283 requires.
# Matters: The intervals of AT and RT are wider.
# Do: Measure 10 passes; otherwise use the intervals of AT and RT for the decision.
# Example: 4 passes
few-passes = { $count ->
        [one] 1 pass
       *[other] { $count } passes
    } of the path, fewer than { $least }
    .hint = measure { $least } passes (ISO 9283), or use the intervals of AT and RT for the decision

# Means: The part of the path in which velocities are evaluated contains a corner.
# Matters: If the robot slows down at the corner, AV, RV and FV are worse.
# Do: Use a path without the corner, or a smaller central part.
# Example: an L-shaped path
corner-in-central-part = the central part of the path contains a corner at { FIXED($at_mm, 3) } mm
    .hint = use a path without the corner, or a smaller central part: slowing down there affects AV, RV and FV

# Means: The minimum zone was compared only with zones of neighbouring elements.
# Matters: A different element may have a narrower zone.
# Do: Compare the form deviation with the form deviation of the least-squares fit.
# Example: ten points of a cylinder
zone-proved-locally = no neighbouring element has a narrower zone ({ $element }); other elements were not compared
    .hint = compare the form deviation with the least-squares fit

# Means: It is not shown that the minimum zone is the narrowest one.
# Matters: The true form deviation may be smaller.
# Do: Measure more of the surface, then repeat the fit.
# Example: nine points that hardly show a cylinder
zone-unproved = a narrower zone of the { $element } cannot be excluded
    .hint = measure more of the surface: the scatter of the points hides the shape of the element

hold-another = to hold another parameter of the group, list it under `hold` in [identify]; by default, the parameter whose tolerance moves the targets least is held

set-up-origin = { $origin ->
        [unit] `unit` of the export
       *[world-frame] `unit` and labels of the points that define it
    }

check-rigid-part = check the unit and the names in `places_mm`, and whether the part has changed since these positions were determined

plan-cube = the largest { $shape } in the given workspace, edges parallel to the axes; C1 to C4 start at the smallest x and y
plan-poses = P1: centre; P2 to P5: on the diagonals, 10 % of their length away from the corners of the test plane, in the order of the corners
plan-clauses = P1 to P5, loads, velocities and 30 cycles follow the text of the standard; paths, other counts and the order of the corners were not compared with a purchased copy
plan-reach-not-examined = not examined: whether the robot reaches the poses, and whether all joints move between them
plan-reach = reach: computed with nominal parameters and the limits of the robot file; each list of poses uses the working mode that reaches most of its poses; { $moves ->
        [all] all joints move between the poses P1 to P5
       *[some] the standard requires that all joints move between the poses P1 to P5, and some do not
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
action-add-cycles-reason = one pose has only { $least } visits, so the intervals of AP and RP are wide
action-add-effect = add `{ $line }` to robot.toml, before its first table
action-add-effect-first = load nothing yet: add `{ $line }` to robot.toml, before its first table, and run again
action-add-effect-not-in-file = root-mean-square error at held-out poses: { $without } → { $with }. No controller file of this campaign can contain { $effect }: the gain needs another format, or programs corrected with `etalon compensate`
action-add-effect-reason = root-mean-square error at held-out poses: { $without } → { $with }
action-add-validation = measure poses for validation, and list them in `validation` of [identify]
action-add-validation-reason = errors at calibration poses are smaller than errors at new poses
action-add-validation-unknown = root-mean-square position error { $calibration } at calibration poses, { $left_out } at held-out ones: only further poses show the errors at other places
action-agree-rule = agree with the customer on a decision rule for the { $limit }
action-agree-rule-reason = the limit lies within U = { $present }; a decision needs { $required }, that is about { $times } times as many readings. `decision_rule = "simple-acceptance"` in [limits] compares the value itself
action-compensate = if the controller computes with nominal geometry, load no file: correct its programs with `etalon compensate` and `--field { $file }`. The field contains errors that no parameter describes
action-compensate-reason = root-mean-square error at { $count } held-out poses: { $without } → { $with }
action-verify = test the loaded file: command a few poses with it, measure them, and compare their errors with the expected error. If they are larger, restore the previous file of the controller
action-verify-moved = loading moves taught positions by up to { $change } at the measured poses (flange in the base frame, pose { $pose }): check clearances, and teach work objects again. { $count ->
        [0] Name the saved file as `controller_backup` in [conditions]: the report then gives its SHA-256
       *[other] The previous file is `{ $file }`; the same section gives its SHA-256
    }
action-verify-reason = save the previous file before you load; `controller_backup` in [conditions] adds its SHA-256
action-verify-at-pose = test the loaded file at pose { $pose }: “Test after loading, and way back” gives the pose on the display and its tolerance. If it differs, restore the previous file of the controller
action-verify-software-at-pose = test the file in your software, or the first corrected program, at pose { $pose }: “Test after loading, and way back” gives poses and tolerance. If they differ, restore what was there before
action-verify-backup = the previous file is `{ $file }`; the same section gives its SHA-256
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
action-load = save what the controller has now, then load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    }
action-load-reason = root-mean-square error ({ $quantity }) at { $count } { $set ->
        [validation] validation
        [held-out] held-out calibration
       *[calibration] calibration
    } poses: nominal { $nominal }, with this file { $expected }
action-load-with-inputs = { $action }. The software that applies the file must evaluate it at each pose with { $inputs }: joint values alone are not enough
action-load-synthetic = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    } into a simulated controller, not into a robot: the data are synthetic
action-load-synthetic-software = load `{ $file }`{ $count ->
        [0] {""}
       *[other] {" "}(or { $others })
    } into your own software, and move no robot with it: the data are synthetic, and no controller reads this file
action-measure-again = measure { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    } again{ $more ->
        [0] {""}
        [one] {" "}(1 further pose disagrees)
       *[other] {" "}({ $more } further poses disagree)
    }
action-measure-again-reason = pose { $pose } disagrees with the others: { $error }, { $times } σ
action-measure-quantity = measure the quantity that `{ $limit }` limits at the judged poses, or remove the limit
action-measure-quantity-reason = without measurements of its quantity, a limit cannot be assessed
action-meet-limit = find the cause of the errors: { $limit }
action-meet-limit-at-pose = find the cause of the error at pose { $pose }: { $limit }
action-meet-limit-reason = { $value }, limit { $limit }: exceeded by { $beyond }
action-use-all-parameters = let the controller use all identified parameters, by another format or by `etalon compensate`: { $limit }
action-use-all-parameters-reason = { $value } with the values of this file, { $whole } with all identified parameters; limit { $limit }
action-prove-effects = set `{ $line }` in [identify]
action-prove-effects-first = load nothing yet: set `{ $line }` in [identify], and run again
action-reduce-uncertainty = reduce the uncertainty of the { $limit }
action-reduce-uncertainty-by-source = U = { $present }; a decision needs { $required }; largest share: { $source } ({ $percent } %)
action-reduce-uncertainty-reason = U = { $present }; a decision needs { $required }
action-resolve = decide how to treat this warning
action-run-again = after a change, run again, and load only a file that the new verdict names
action-run-again-backup = until then the controller keeps its values. If values of this campaign are loaded, restore `{ $file }`
action-run-again-reason = until then the controller keeps its values. If values of this campaign are loaded, restore the previous file of the controller
action-state-limits = give the tolerance of the application in [limits]
action-state-limits-reason = a verdict needs limits
action-state-limits-to-accept = only limits show whether the accuracy suffices for the application
action-warm-up = warm the robot up before the test, and set `warm_up_minutes`
action-warm-up-cold = the robot was tested cold
action-warm-up-drift = AP of pose { $pose } changes by { $change } from the first to the last of { $sets } sets of cycles, and stabilisation is not shown

# Means: The residual field refers to a joint, parameter or model that the robot does not have.
# Matters: A residual field describes a single robot.
# Do: Use the robot file and the field.json of the same run.
# Example: `--field` with the field.json of another robot
field-of-other-robot = the residual field belongs to another robot: `{ $name }`
    .hint = use the field.json of the run that identified this robot

# Means: A number of the field is missing, not finite, or out of its range.
# Matters: The errors of the joints cannot be computed.
# Do: Run the campaign again to write a new field.json.
# Example: a field.json with a row of the covariance deleted
field-inconsistent = the residual field is inconsistent
    .hint = run the campaign again

field-needs-positions = a residual field is computed only from positions of targets, without conditions, rigid parts, platforms or given covariances
field-needs-poses = { $poses ->
        [one] { $poses } pose
       *[other] { $poses } poses
    }; a residual field needs { $needed }
field-readings-suspect = at held-out pose { $pose } the error with the field is { FIXED($error_mm, 3) } mm, more than 8 times the median of all poses: its readings are suspect
field-undetermined = if one part of the poses is omitted, the positions no longer determine the parameters
field-not-shown = the residuals show no dependence on the joints: the likelihood rises by { FIXED($rise, 1) }, and { FIXED($threshold, 1) } is required (−2 ln L)
field-not-proven = at held-out poses the position error (root mean square) is { FIXED($without_mm, 3) } mm without the field and { FIXED($with_mm, 3) } mm with it; the gain is { FIXED($gain, 1) } times its standard uncertainty, and 2.3 times is required

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
reading-payload-mass = payload
reading-payload-centre = centre of the payload in the flange
reading-torque = torques of the joints
reading-temperature = temperature of the robot
reading-in-unit = { $quantity } ({ $unit })
