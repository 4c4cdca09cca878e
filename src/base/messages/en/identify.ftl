### Messages of identify. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: The identification received neither observations nor conditions.
# Matters: No parameter can be identified without observations.
# Do: Check which poses `calibration` selects, and which poses are excluded.
# Example: a selection of calibration poses that were all excluded
no-observations = there are no observations from which parameters can be identified
    .hint = check which poses are selected and which are excluded

# Means: `residuals = "pose"` is set, but the standard uncertainty of a coordinate is missing.
# Matters: Lengths and angles have no common scale without it.
# Do: Add the uncertainty of the instrument, or set `residuals = "targets"`.
# Example: residuals of the pose of a planar platform without an instrument uncertainty
pose-residuals-without-uncertainty = residuals of the pose contain mm and rad: they need the standard uncertainty of a coordinate

# Means: A common uncertainty of several observations is given without the uncertainty of a single
# observation, or together with residuals of the pose.
# Matters: The covariance of the residuals is undefined.
# Do: Add the uncertainty of a single observation, and set `residuals = "targets"`.
# Example: the uncertainty of a reference point without the repeatability of its contacts
common-uncertainty-alone = a common uncertainty of several observations needs residuals of targets and the uncertainty of a single observation

# Means: `hold` contains a parameter that the robot model does not have.
# Matters: Probably another parameter was meant; without a correct name it would be identified.
# Do: Use the name of a parameter of the model; `*` matches any text.
# Example: `hold = ["d_9"]` of a six-axis arm
parameter-unknown = `{ $pattern }` is not a parameter of this robot

# Means: The observations are orientations, distances, contacts, surfaces or joint values, but the
# robot is not a spatial arm.
# Matters: These kinds of observations exist for arms only.
# Do: Observe positions of targets instead.
# Example: an observed orientation of a planar platform
observations-need-arm = orientations, distances, contacts, surfaces and joint values are for spatial arms, not for `{ $model }`

# Means: Orientations, distances, contacts, surfaces or joint values are combined with residuals of
# the pose or a common uncertainty.
# Matters: The weights of these observations are then undefined.
# Do: Set `residuals = "targets"`, and omit the common uncertainty.
# Example: an observed distance and residuals of the pose
kinds-need-target-residuals = orientations, distances, contacts, surfaces and joint values need residuals of targets without a common uncertainty
    .hint = set `residuals = "targets"`, and omit the common uncertainty

# Means: There are several kinds of observations, and the standard uncertainty of a coordinate is
# missing.
# Matters: Observations in mm and in rad have no common scale without it.
# Do: Add the uncertainty of the instrument.
# Example: positions and orientations without an instrument uncertainty
kinds-without-uncertainty = observations of several kinds need the standard uncertainty of a coordinate

# Means: Readings have individual uncertainties, but `residuals = "pose"` or a common uncertainty is
# given.
# Matters: Individual uncertainties can only weight residuals of targets.
# Do: Set `residuals = "targets"`, or remove the uncertainties of the readings.
# Example: readings with covariances and residuals of the pose
own-uncertainties-unusable = readings with individual uncertainties need residuals of targets and no common uncertainty

# Means: Some readings have an uncertainty, others have none, and no common value is given.
# Matters: The weight of readings without an uncertainty is unknown.
# Do: Add the uncertainty of every reading, or one value for the other readings.
# Example: 3 of 40 readings without an uncertainty
readings-without-uncertainty = { $without } of { $readings } readings have no uncertainty

# Means: `residuals = "pose"` is set for a spatial robot.
# Matters: Residuals of the pose exist for planar platforms only.
# Do: Set `residuals = "targets"`.
# Example: `residuals = "pose"` in [identify] of a six-axis arm
pose-residuals-not-planar = residuals of the pose are for planar robots, not for `{ $model }`

# Means: The tool point is given in the frame of a part that the robot does not have.
# Matters: The position of the point on the robot is unknown.
# Do: Give the point in the frame of a part of this robot, for example the platform.
# Example: a tool point in the frame of the flange for a planar platform
tool-part-missing = the tool point is given in the frame of the { $part }, but `{ $model }` has no { $part }

# Means: The poses of a plan do not determine the parameters.
# Matters: No uncertainty can be predicted.
# Do: Choose more poses, or add parameters to `hold`.
# Example: 2 poses for 24 parameters
too-few-poses-planned = { $poses } poses do not determine { $parameters } parameters

# Means: All parameters are held, or no observation depends on a free parameter.
# Matters: There is no unknown to solve for.
# Do: Hold fewer parameters. If the message contains a cause, remove it first.
# Example: `*` as the pattern of parameters to hold
nothing-to-identify = no parameter is left to identify{ $cause ->
        [none] {""}
       *[other] : { $cause }
    }

hold-fewer-parameters = hold fewer parameters

# Means: The observations determine fewer parameters than are to be identified.
# Matters: The solution is not unique.
# Do: Measure more poses, or hold the parameters in the following lines.
# Example: 6 residuals from one pose for 12 parameters
parameters-undetermined = { $residuals ->
        [one] 1 residual
       *[other] { $residuals } residuals
    } from { $poses ->
        [one] 1 pose
       *[other] { $poses } poses
    }, { $independent } of them independent, do not determine { $parameters ->
        [one] 1 parameter
       *[other] { $parameters } parameters
    }

# Means: No observation depends on a parameter.
# Matters: Its value cannot be identified.
# Do: Hold the parameter, or measure poses in which it matters.
# Example: the last joint of an arm whose only target is on its axis
parameter-without-effect = no observation depends on `{ $parameter }`

# Means: A change of this parameter has the same effect on all observations as a change of the
# others.
# Matters: Only their combination can be identified.
# Do: Hold one of them, or measure poses in which their effects differ.
# Example: the rotation of the base and the zero of the first joint
parameters-inseparable = `{ $parameter }` is not separately identifiable from { $others }

# Means: The solver ended without a result.
# Matters: No parameters are identified.
# Do: Check units, order and signs of the joints, and the nominal parameters.
# Example: coordinates of 1e170 mm
identification-without-result = the identification ended without a result: { $reason }

solver-ended = { $termination ->
        [iteration-limit] not converged within the iteration limit
        [not-a-number] a residual is not a number
        [rank-deficient] some parameters are not separately identifiable
        [unsteady] the set of separately identifiable parameters changes from one step of the solver to the next
        [too-few-equations] there are fewer equations than parameters
       *[converged] converged, but the result is not unique
    }

readings-contradict = most readings fit, but the readings of { $poses } do not{ $count ->
        [0] {""}
       *[other] {""}: the joint values of poses { $pairs } are swapped
    }{ $wrong ->
        [0] {""}
       *[other] {""}: { $coordinates }
    }

wrong-coordinate = { $axis } of { $target } at pose { $pose } (cycle { $cycle }) is { FIXED($measured_mm, 3) } mm, and { FIXED($changed_mm, 3) } mm agrees

change-of-reference = a motion of base or measuring system

change-of-target = a motion of target `{ $target }` on its carrier

change-of-zero = another zero of joint `{ $joint }`

change-or-another = { $message }; the measurements agree as well with { $others }

named-poses = { $count ->
        [one] pose { $poses }
       *[other] { $count } poses ({ $poses })
    }

poses-unreachable = the nominal robot has no pose at the joint values of { $poses }

extents-differ = the measured points span { FIXED($measured_mm, 0) } mm, the predicted points { FIXED($model_mm, 0) } mm

assembly-mode-contradicted = the measured position contradicts the assembly mode in { $poses }: for pose { $worst }, the residual is { FIXED($stated_mm, 1) } mm with the given mode { $stated }, and { FIXED($other_mm, 1) } mm with mode { $other }

# Means: No observation contains a length.
# Matters: A robot of twice the size fits equally well, so the scale comes from the nominal lengths.
# Do: Measure a distance, or the position of a target.
# Example: a ball in four sockets whose distances were not measured
scale-unobserved = no observation contains a length: the scale of the robot comes from its nominal lengths{ $lengths ->
        [none] {""}
       *[other] {" "}({ $lengths })
    }
    .hint = measure a distance between two sockets or to a fixed point, or the position of a target

# Means: Readings are weighted by their individual standard uncertainties.
# Matters: Precise readings have more influence than others.
# Do: Nothing, if these uncertainties are right. Otherwise remove their columns.
# Example: a tracker export with an uncertainty for each point
readings-weighted = { $own } of { $readings } readings are weighted by their individual standard uncertainties: { FIXED($least_mm, 4) } to { FIXED($most_mm, 4) } mm per coordinate

# Means: The distance between two targets differs from their given positions on a rigid part by more
# than the uncertainty.
# Matters: The part has changed since its positions were determined, or two targets are swapped.
# Do: Check the unit and the names in the given positions, and whether the part has changed.
# Example: given positions in inches
rigid-part-contradicted = { $places } of { $targets } contradict the measurements by more than their uncertainty: the distance from `{ $first }` to `{ $second }` is { FIXED($found_mm, 4) } mm { $by ->
        [identification] identified without them
       *[measurement] measured
    }, { FIXED($stated_mm, 4) } mm stated

stated-positions = stated positions

# Means: Parameters are compared with given ones, but the standard uncertainty of a coordinate is
# missing.
# Matters: It is unknown whether the differences are significant.
# Do: Add the standard uncertainty of the instrument.
# Example: a verification without an instrument uncertainty
comparison-without-uncertainty = a comparison with given parameters needs the standard uncertainty of a coordinate
    .hint = add the standard uncertainty of the instrument

# Means: With these parameters, the robot has no pose at some of the joint values.
# Matters: Measured and predicted positions cannot be compared.
# Do: Check unit, sign and offset of the joint values, and whether the parameters belong to this
# robot.
# Example: joint values in radians read as degrees
robot-not-at-joints = the robot has no pose at these joint values with { $parameters ->
        [nominal] nominal
       *[given] the given
    } parameters
    .hint = check unit, sign and offset of the joint values, and that the parameters belong to this robot

# Means: The given covariance of the parameters is not positive definite.
# Matters: No set of measured parameters has such a covariance.
# Do: Use the covariance from the identification, without changes.
# Example: a correlation edited by hand to 1.2
covariance-not-positive-definite = the covariance of the parameters is not positive definite
    .hint = use the covariance from the identification, without changes

# Means: The number of equations equals the number of parameters.
# Matters: All residuals are zero, so the uncertainty of the parameters is unknown.
# Do: Measure more poses, or add the uncertainty of the instrument.
# Example: 4 positions in space for 12 parameters
no-redundant-observations = there are only as many equations as parameters: the uncertainty of the parameters is unknown
    .hint = measure more poses, or add the uncertainty of the instrument

# Means: Residuals of the same pose are more similar than independent errors would be.
# Matters: Computed from independent readings, the standard uncertainties are too small. They are
# computed from the scatter of the poses instead.
# Do: Measure more poses, or add the common error to the model.
# Example: errors of 0.4 µm common to all readings of a pose, and noise of 1.35 µm
pose-residuals-correlated = residuals of one pose are correlated: standard uncertainties are estimated from the scatter of the poses, { FIXED($ratio, 1) } times those from the instrument
    .hint = the model does not describe an error of the robot, or all readings of a pose share an error of the instrument

# Means: `series` is given, but the scatter between series cannot be estimated. There are fewer than
# eight poses, or a reading belongs to several poses.
# Matters: The uncertainties do not include differences between set-ups, days or files.
# Do: Measure at least eight poses. Otherwise make one campaign for each series, and compare them
# with `etalon compare`.
# Example: `series = ["1-3", "4-6"]` with 6 poses
series-not-estimated = the uncertainties do not include the scatter between series: there are fewer than eight poses, or a reading belongs to several poses

# Means: Residuals are significantly smaller than the stated uncertainty of the instrument
# (chi-square test).
# Matters: Standard uncertainties of all results are too large.
# Do: Check value, unit and coverage factor of the instrument's uncertainty. Errors common to all
# poses are not visible in residuals.
# Example: an expanded uncertainty stated as a standard uncertainty
instrument-uncertainty-too-large = residuals are { FIXED($ratio, 2) } times the stated uncertainty of the readings (chi-square { FIXED($chi_square, 1) }, { $degrees } degrees of freedom): standard uncertainties are too large
    .hint = check the instrument's uncertainty, its unit and its coverage factor; errors common to all poses are not visible in residuals

# Means: Residuals are significantly larger than the stated uncertainty of the instrument
# (chi-square test).
# Matters: The robot has errors that the model does not describe, or the stated uncertainty is too
# small. Standard uncertainties are enlarged accordingly.
# Do: Check outliers and the model; check the uncertainty of the instrument.
# Example: elastic joints in a geometric model
residuals-exceed-uncertainty = residuals are { FIXED($ratio, 1) } times the stated uncertainty of the readings (chi-square { FIXED($chi_square, 0) }, { $degrees } degrees of freedom): standard uncertainties { $from ->
        [poses] are estimated from the scatter of the poses
        [regions] are estimated from the scatter of regions of the workspace
       *[residuals] are enlarged, with the residuals of a pose taken as independent
    } ({ FIXED($inflation, 1) } times those from the stated uncertainty, median)
    .hint = check outliers and the model: the robot has errors that the model does not describe, or the stated uncertainty is too small

# Means: Some parameters of the robot have the same effect as the pose of the base or the positions
# of the targets.
# Matters: These parameters are held at nominal. Base and targets absorb their deviations. Predicted
# positions do not change.
# Do: Nothing. To hold another parameter of a group, list it under `hold`. If axes are nearly
# parallel, as in a SCARA, a length is held and `base_z` is free. To identify this length, measure
# the height of the base, set it as `base_z` under `[nominal]`, and hold `base_z`.
# Example: the zero of the first joint and the rotation of the base
parameters-fixed-by-frames = the data cannot separate { $count } parameters from base and targets; they are held at their nominal values: { $parameters }

# Means: A shift of a target and the opposite shift of the base have the same effect on all
# readings. The position of the target on the robot is unobservable.
# Matters: The target is set to 0, and the base absorbs its position. Positions in the base frame
# are then positions of this target. Errors and other parameters do not change.
# Do: If programs need positions of the platform, measure the target on the platform. Add its
# coordinates under [nominal] in robot.toml, and list them under `hold`.
# Example: three reflectors on a delta, whose platform keeps its orientation
target-place-free = the data cannot separate { $parameters } from the base: set to 0, so positions in the base frame are positions of this target
    .hint = to refer positions to the platform, measure the target on it, add its coordinates under [nominal] in robot.toml, and `hold` them

# Means: No observation depends on a parameter.
# Matters: The parameter is held at its nominal value.
# Do: If you need its value, measure poses in which it matters.
# Example: one reading of one target of an arm
parameter-held-without-effect = no observation depends on `{ $parameter }`: it is held at its nominal value

# Means: A change of this parameter has the same effect on all observations as a change of the
# others.
# Matters: One of them is held at its nominal value, and the others absorb its deviation. Predicted
# positions do not change.
# Do: If you need the single values, measure poses in which their effects differ.
# Example: the offset of a joint that never moves and the next link of an arm
parameter-held-inseparable = `{ $parameter }` and { $others } are not separately identifiable: `{ $parameter }` is held at its nominal value

# Means: The poses separate this parameter from others only with a large uncertainty.
# Matters: Its nominal value is more accurate than an identified value, so the parameter is held.
# Do: Measure poses in which the effects of these parameters differ, for example over a wider range
# of the joint.
# Example: poses in which a joint moves by 2 degrees only
parameter-separable-poorly = `{ $parameter }` is identifiable separately from { $others } only with a standard uncertainty of { FIXED($uncertainty, 2) }{ $unit ->
        [mm] {" "}{ $unit }
        [deg] {" "}{ $unit }
       *[other] {""}
    }: { $held ->
        [placed] it keeps its starting value
       *[nominal] it is held at its nominal value, which is more accurate
    }
    .hint = measure poses in which their effects differ

# Means: The tool point is given in the frame of the targets, but the targets do not define a frame.
# Matters: The position of the point is unknown.
# Do: Give the point in the frame of the flange, or use the first target as the point.
# Example: balls K and L of a PreXYT at the same position
tool-targets-collinear = the targets define no frame for the tool point: a spatial robot needs three targets that are not collinear, a planar robot two targets
    .hint = give the point in the frame of the flange, or use the first target itself ([0, 0, 0])

# Means: The difference between the nominal robot and the measurements is larger than the tolerances
# of its parameters allow.
# Matters: Probably the set-up is wrong, not the robot. Identified parameters absorb the mistake.
# Do: Check signs, units and order of the joints, then the nominal values, then the join of joint
# values and points.
# Example: one joint with the wrong sign
nominal-robot-far = the difference between the nominal robot and the measurements is { FIXED($left_mm, 3) } mm (root mean square, base and targets fitted); the tolerances allow { FIXED($allowed_mm, 3) } mm
    .hint = check signs, units and order of the joints, the nominal values, and the join of joint values and points

# Means: The nominal robot has no pose for some of the joint values.
# Matters: Measured and predicted positions cannot be compared.
# Do: Check signs, units and order of the joints, then the nominal values.
# Example: joint values in radians read as degrees
nominal-robot-not-at-joints = the nominal robot has no pose at these joint values
    .hint = check signs, units and order of the joints, the nominal values, and the join of joint values and points

# Means: With every position of base and targets, the nominal robot is far from the measurements.
# Matters: Probably the set-up is wrong. Identified parameters absorb the mistake.
# Do: Check units, order, signs and offsets of the joints, and nominal parameters.
# Example: `hold = ["base_rz", "base_ry"]`, but the base is rotated
placement-unexplained = no position of base and targets agrees with the measurements: residuals are { FIXED($left_mm, 1) } mm, the measured points span { FIXED($spread_mm, 1) } mm
    .hint = check units, order, signs and offsets of the joints, held parameters of base and targets, and the nominal parameters of the robot

# Means: From one pose on, the true value of one joint differs from the logged value by a constant.
# Matters: The joint lost its zero during the measurement: a new mastering, an empty battery of an
# encoder, a belt that slipped. Identified parameters absorb the change.
# Do: Check encoder and mastering of the joint. Identify the poses before and after the change
# separately, or measure again.
# Example: joint 3 was mastered again after pose 40
joint-zero-shifted = from pose { $pose } on, true minus logged values of joint `{ $joint }` differ by { FIXED($change, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } from the poses up to { $previous }: the change of the zero explains { FIXED($share_percent, 0) } % of the residuals
    .hint = check encoder and mastering of the joint: identify the poses before and after the change separately, or measure again

# Means: From one pose on, all measured positions have the same shift.
# Matters: The base or the measuring system moved during the measurement. Identified parameters
# absorb the shift.
# Do: Identify the poses before and after the shift separately, or measure again.
# Example: a tripod that was touched after pose 21
reference-moved = from pose { $pose } on, measured positions are shifted by { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm) compared with the poses up to { $previous }: the shift explains { FIXED($share_percent, 0) } % of the residuals
    .hint = base or measuring system moved: identify the poses before and after the shift separately, or measure again

# Means: From one pose on, one target has another position on the part that carries it.
# Matters: The target moved during the measurement. Identified parameters absorb the shift.
# Do: Give the target another name from this pose on, or measure these poses again.
# Example: a reflector nest that moved after pose 40
target-shifted = from pose { $pose } on, the target `{ $target }` is shifted by { FIXED($shift_mm, 3) } mm ± { FIXED($expanded_mm, 3) } mm ({ $vector_mm } mm in the frame of the flange) compared with its position up to pose { $previous }: the shift explains { FIXED($share_percent, 0) } % of the residuals
    .hint = the target moved on its carrier: give it another name from this pose on, or measure again

# Means: The measured positions of two poses agree with the joint values of the other pose.
# Matters: Rows of the log or names of the poses are swapped. Identified parameters absorb the
# error.
# Do: Swap the joint values, or exclude the poses.
# Example: rows 12 and 30 of a log are swapped
poses-exchanged = { $count ->
        [one] the joint values of poses { $pairs } are swapped
       *[other] the joint values of { $count } pairs of poses are swapped: { $pairs }
    }: after the swap they are no outliers
    .hint = check the order of the rows of the log and the names of the poses

# Means: With a change of the set-up, the robot agrees with the measurements clearly better.
# Matters: The identified parameters absorb a mistake of the set-up. Away from the measured poses,
# the robot is wrong.
# Do: Check each change in the hint on the robot, and correct the campaign.
# Example: joints 5 and 6 are swapped, and the orientation of the flange hardly changes
set-up-contradicted = the measurements contradict the given set-up
    .hint = check the changes that agree with the measurements

# Means: With each of these changes, a robot within its tolerances agrees with the measurements as
# well as with the given set-up.
# Matters: If one of these changes is a mistake of the set-up, the data do not show it. The
# controller then computes a wrong position of the flange.
# Do: Check the directions and the order of the joints on the robot. Or measure a second target away
# from the axis of the last joint, in poses that move all joints.
# Example: the direction of the last joint with one reflector on its axis
set-up-untested = the data do not test these changes: { $changes }
    .hint = check these on the robot, or measure a second target away from the axis of the last joint, in poses that move all joints

untested-change = { $change } (standard deviation of a coordinate { FIXED($changed_mm, 3) } mm instead of { FIXED($stated_mm, 3) } mm; the position of the flange changes by up to { FIXED($flange_mm, 0) } mm and { FIXED($flange_deg, 0) } deg)
pair-of-poses = { $first } and { $second }

# Means: The poses separate a group of parameters poorly.
# Matters: The standard uncertainties of these parameters are large. At poses near the measured
# poses, the errors of the parameters cancel.
# Do: Measure poses in which the effects of these parameters differ, over a wider range of the
# joints. If you hold a parameter instead, its error remains and its uncertainty is not reported.
# Example: a ball in four sockets whose distances were not measured
parameters-weakly-identifiable = { $groups } are weakly identifiable from these poses: standard uncertainties { $uncertainties } (correlation { FIXED($correlation, 6) })

# Means: The poses separate several groups of parameters poorly.
# Matters: The standard uncertainties of these parameters are large. At poses near the measured
# poses, the errors of the parameters cancel.
# Do: Measure poses in which the effects of the parameters of a group differ, over a wider range of
# the joints. If you hold a parameter instead, its error remains and its uncertainty is not
# reported.
# Example: all poses measured in a small region
parameter-groups-weakly-identifiable = { $count } groups of parameters are weakly identifiable from these poses (largest standard uncertainties: { $uncertainties }; errors within a group cancel near these poses): { $groups }

uncertainty-of-parameter = u({ $parameter }) = { FIXED($u, 3) } { $unit }

uncertainty-of-ratio = u({ $parameter }) = { SCIENTIFIC($u, 1) }

parameter-group = { $first } and { $second }

parameter-groups = { $first }; { $others }

separate-parameters = measure poses in which the effects of these parameters differ

separate-parameters-by-joints = measure poses over a wider range of { $joints }, in which the effects of these parameters differ

# Means: The number of positions to choose is zero, or exceeds the number of candidates.
# Matters: A plan of this size is impossible.
# Do: Choose fewer positions, or add candidates.
# Example: 40 positions of 30 candidates
too-many-positions = { $positions } positions cannot be chosen from { $candidates } candidates
    .expected = a number from 1 to { $candidates }

# Means: A pose of the given start is not a candidate.
# Matters: The search cannot start.
# Do: Use poses from the table of candidates.
# Example: a start from pose 99 of 30 candidates
start-pose-unknown = pose { $pose } of the start is not a candidate
    .hint = use poses from the table of candidates

# Means: The given start has more poses than the plan.
# Matters: The plan cannot contain all poses of the start.
# Do: Reduce the start, or choose more positions.
# Example: a start from 5 poses for a plan of 4
start-too-large = the start has { $start } candidates, more than the { $positions } positions to choose
    .hint = reduce the start, or choose more positions

# Means: The positions of a study do not determine all parameters.
# Matters: The errors of the identified robot cannot be simulated.
# Do: Choose more positions, or add priors (tolerances).
# Example: three of four positions differ in one actuator only, and there are no priors
study-too-few-positions = { $positions } positions do not determine all parameters
    .hint = choose more positions

# Means: The table of candidates has no pose.
# Matters: Nothing can be planned.
# Do: Add rows with joint values to the table of candidates.
# Example: a table with a header alone
no-candidates = there are no candidates
    .hint = check the table of candidates

# Means: The nominal robot cannot reach any candidate.
# Matters: Nothing can be planned.
# Do: Check the joint values, their units, and the limits in robot.toml.
# Example: candidates in radians read as degrees
candidates-unreachable = no candidate is within reach: pose { $pose } ({ $reason })
    .hint = check joint values, their units, and the limits of the robot

# Means: The nominal robot cannot reach some candidates.
# Matters: The plan never contains these candidates.
# Do: Nothing, if the limits of the robot are right.
# Example: a candidate beyond the travel of a joint
candidates-left-out = { $count ->
        [one] 1 candidate is
       *[other] { $count } candidates are
    } out of reach and never chosen: { $candidates }

candidate-violation = pose { $pose } ({ $reason })

at-geometric-step = { $step ->
        [lead-1] lead of actuator 1
        [lead-2] lead of actuator 2
        [lead-3] lead of actuator 3
        [base] base frame
        [mobile] mobile frame
        [shaft] shaft
       *[offsets] offsets
    }: { $message }

# Means: A step of the geometric method was measured, but steps that it needs were not.
# Matters: The dimensions of this step cannot be computed.
# Do: Measure the missing steps, or omit this step.
# Example: the shaft without the arc of ball N
geometric-step-alone = { $step ->
        [shaft] the shaft needs the arc of ball N
       *[offsets] the displacement of actuator 1 needs the arc of ball N, the rotated platform and the shaft
    }
    .hint = measure the missing steps, or omit this step

# Means: Some steps of the geometric method were not measured.
# Matters: The complete geometry cannot be computed.
# Do: Measure every step at least once.
# Example: a calibration without the rotated platform
geometry-incomplete = the complete geometry needs the arc of ball N, the rotated platform, the shaft in two positions and a displacement of actuator 1
    .expected = at least one repeat of each

# Means: A ball has the same position before and after the displacement of an actuator.
# Matters: The direction of the displacement is undefined.
# Do: Move the actuator to its end, then measure the ball again.
# Example: the measurement of ball R at home, stored twice
ball-unmoved = { $ball ->
        [R] ball R did not move while actuator 2 moved to its end
       *[K] ball K moved by less than 1 mm along x while actuator 1 moved to its end
    }
    .hint = measure ball { $ball } again after moving actuator { $actuator } alone to its end

# Means: The positions do not determine the lead of an actuator.
# Matters: The transmission error of the actuator remains unknown.
# Do: Measure at least three positions, at two or more displacements.
# Example: three readings at one displacement
lead-undetermined = these positions do not determine the lead of the actuator
    .expected = at least three readings, at two or more commanded displacements

# Means: The axes of the shaft in its two positions are parallel.
# Matters: The distance s is computed from the intersection of these axes, which does not exist.
# Do: Move actuator 2 to its end between the two measurements of the shaft.
# Example: one position of the shaft, measured twice
shaft-positions-parallel = the two positions of the shaft are parallel: their axes do not intersect
    .hint = between the two measurements, move only actuator 2, to its end

# Means: The points do not determine the element that is fitted to them.
# Matters: The uncertainty of this element is infinite.
# Do: Distribute the positions over the whole travel or rotation.
# Example: an arc measured at one angle
points-undetermined = these points do not determine the fitted element
    .hint = distribute the positions over the whole travel or rotation

slip-reversed = { $joint } reversed

slip-exchanged = { $first } and { $second } swapped
slip-branches-exchanged = the targets of { $first } and { $second } swapped

slip-joint-order = the joints { $order ->
        [reversed] in reverse order
        [left] shifted by one position
       *[right] shifted by one position in the other direction
    }

slip-joint-block = the joints { $first } to { $last } { $order ->
        [left] shifted by one position
       *[right] shifted by one position in the other direction
    }

slip-offset = { $degrees } deg added to { $joint }

slip-unit = { $quantity ->
        [all-joints] all joints
        [joints-of-kind] all joints of this kind
        [lengths] all measured lengths
        [distances] the measured distances
        [points] the measured points
       *[other] { $quantity }
    } { $slip ->
        [m-mm] in metres instead of millimetres
        [mm-m] in millimetres instead of metres
        [inch-mm] in inches instead of millimetres
        [mm-inch] in millimetres instead of inches
        [rad-deg] in radians instead of degrees
        [gon-deg] in gon instead of degrees
        [deg-gon] in degrees instead of gon
       *[deg-rad] in degrees instead of radians
    }

slip-unit-of-targets = the measured points of { $targets } { $slip ->
        [m-mm] in metres instead of millimetres
        [mm-m] in millimetres instead of metres
        [inch-mm] in inches instead of millimetres
       *[mm-inch] in millimetres instead of inches
    }

slip-points = { $change ->
        [mirrored] the measured points mirrored (a left-handed frame, or two coordinates swapped)
        [exchanged] x and y of the measured points swapped
        [x] x of the measured points reversed
       *[y] y of the measured points reversed
    }

slip-poses-inverse = inverse of the measured poses (pose of the instrument in the frame of the target)
slip-targets = the targets { $first } and { $second } swapped
slip-fixtures-exchanged = the points or surfaces { $first } and { $second } exchanged

slip-neighbour = the joint values of each pose taken from the { $neighbour ->
        [previous] previous
       *[next] next
    } pose

slip-world-frame = the world frame rotated by { FIXED($angle_deg, 1) } deg and shifted by ({ FIXED($x_mm, 1) }, { FIXED($y_mm, 1) }) mm

slip-reading = the reading of `{ $target }` at pose { $pose } left out
slip-pair = { $first }, and { $second }
slip-nominal = `{ $parameter }` = { FIXED($found, 2) } { $unit } instead of { FIXED($nominal, 2) } { $unit }

with-slip = { $slip }{ $origin ->
        [none] {""}
       *[other] {" "}({ $origin })
    }

set-up-slip = { $others ->
        [none] one change agrees with the measurements: { $first }
       *[other] each of these changes agrees with the measurements: { $first }; { $others }
    }. { $stated ->
        [unreachable] Without the change, poses are out of reach; with the change, the standard deviation of a coordinate is { FIXED($changed_mm, 3) } mm
        [angles] The standard deviation of orientations falls from { FIXED($stated_deg, 2) } deg to { FIXED($changed_deg, 2) } deg
        [tolerances] With the change, the standard deviation of a coordinate is { FIXED($changed_mm, 3) } mm, and parameters stay within their tolerances
       *[residuals] The standard deviation of a coordinate falls from { FIXED($stated_mm, 3) } mm to { FIXED($changed_mm, 3) } mm
    } (at held-out poses): check that first

index-o1 = O1 = (s1...sm)^(1/m) / sqrt(n), m parameters, n poses; Jacobian in mm per mm, rad and 1
index-o2 = O2 = smin / smax; Jacobian in mm per mm, rad and 1
index-o3 = O3 = smin; Jacobian in mm per mm, rad and 1
index-o4 = O4 = smin^2 / smax; Jacobian in mm per mm, rad and 1
index-o5 = O5 = 1 / (1/s1 + ... + 1/sm); Jacobian in mm per mm, rad and 1
index-d = D = (s1...sm)^(1/m); Jacobian in mm per mm, rad and 1
index-a = A = 1 / sqrt(tr((J'J)^-1)); columns of J divided by their norms over all candidates
index-e = E = smin; columns of J divided by their norms over all candidates
index-i = I = 1 / root mean square standard uncertainty of position over all candidates, per mm of noise
