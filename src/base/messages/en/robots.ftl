### Meanings of parameters, and titles of drawings.

meaning-axis-displacement = Small displacement of the joint axis, along the axis at the end of the name.
meaning-axis-rotation = Small rotation of the joint axis, about the axis at the end of the name; counterclockwise positive.
meaning-backlash = Backlash of the joint: position after an approach from above minus position after an approach from below, at the same logged value; 0 without backlash.
meaning-ball-distance = Distance between the balls K and L.
meaning-ball-line-angle = Angle from the platform's x axis to the line through the balls K and L; counterclockwise positive.
meaning-base-orientation = Orientation of the base in the world frame, as a rotation vector; counterclockwise positive.
meaning-base-origin = Origin of the base in the world frame, along the axis at the end of the name.
meaning-base-origin-x = Origin of the base in the world frame, along x.
meaning-base-origin-y = Origin of the base in the world frame, along y.
meaning-bending = Bending under gravity: angle of the joint under the largest moment, which occurs with the arm stretched out horizontally; positive in the direction of the load moment.
meaning-carriage-1-place = Position of carriage 1 at actuator value zero, along x.
meaning-carriage-1-travel = Travel of carriage 1 along x per commanded millimetre; nominally 1.
meaning-carriage-2-travel = Travel of carriage 2 per commanded millimetre; nominally 1.
meaning-carriage-3-place = Position of carriage 3 at actuator value zero, along y.
meaning-carriage-3-travel = Travel of carriage 3 per commanded millimetre; nominally 1.
meaning-carriage-offset = Offset of the carriage: added to its height.
meaning-centre-across-balls = Distance of the platform centre C from ball K, perpendicular to the line through the balls.
meaning-centre-along-balls = Distance of the platform centre C from ball K, along the line through the balls.
meaning-coupling = Coupling: motion of the first joint divided by the motion of the second joint that causes it.
meaning-distal-link-1 = Length of the distal link of arm 1, B1 to C.
meaning-distal-link-2 = Length of the distal link of arm 2, B2 to C.
meaning-drift = Drift of the joint zero with the temperature of the robot: change of the joint value if the temperature rises by 10 K.
meaning-encoder-1-offset = Offset of encoder 1: added to its value; counterclockwise positive.
meaning-encoder-2-offset = Offset of encoder 2: added to its value; counterclockwise positive.
meaning-encoder-offset = Offset of the encoder: added to its value; a larger offset lowers the arm.
meaning-expansion = Common thermal expansion of all lengths of the arm: mm per metre and kelvin of the temperature of the robot (steel: 0.0115).
meaning-fixture-place = Position or size of an element fixed in the world frame: coordinate along the axis at the end of the name, or radius.
meaning-foot-aside = Lateral position of the foot of the motor axis or tower, along the y axis of its leg.
meaning-foot-outwards = Distance of the foot of the motor axis or tower from the z axis of the base, along the x axis of its leg; outwards positive.
meaning-gain = Gain of the joint: motion of the joint divided by the change of the logged value; nominally 1.
meaning-guide-angle = Angle of the guide on carriage 1 from the y axis of the base; clockwise positive.
meaning-harmonic = Harmonic of the transmission: amplitude of a joint error that follows the sine or cosine (at the end of the name) of once or twice the joint angle.
meaning-hayati-angle = Hayati angle between nearly parallel axes, about the y axis; replaces the link offset; counterclockwise positive.
meaning-joint-offset = Joint offset: added to the logged joint value, about the z axis; counterclockwise positive.
meaning-lateral = Tilt of the joint across its axis, about the axis at the end of the name (in the frame that the joint moves): angle under a moment of 100 N·m about this axis; positive in the direction of the moment.
meaning-leg-joint-on-base = Centre of the leg's joint on the base, along the base axis at the end of the name.
meaning-leg-joint-on-platform = Centre of the leg's joint on the platform, along the platform axis at the end of the name.
meaning-leg-length = Length of the leg between its joint centres, at joint value zero.
meaning-link-length-before = Length of the link before the joint: distance between its two axes, along the previous x axis.
meaning-link-length-behind = Length of the link after the joint: distance between its two axes, along the new x axis.
meaning-link-offset = Link offset along the z axis of the joint.
meaning-link-twist-before = Twist of the link before the joint: angle from the previous z axis to the joint's z axis, about the previous x axis; counterclockwise positive.
meaning-link-twist-behind = Twist of the link after the joint: angle from the joint's z axis to the next z axis, about the new x axis; counterclockwise positive.
meaning-motor-axis-turn-x = Rotation of the motor axis about the x axis of its leg; counterclockwise positive.
meaning-motor-axis-turn-z = Rotation of the motor axis about the z axis of its leg; counterclockwise positive.
meaning-motor-direction = Direction from motor A1 to motor A2 in the world frame; counterclockwise positive.
meaning-motor-distance = Distance between the motor axes A1 and A2.
meaning-motor-height = Height of the motor axis above the base, along z.
meaning-motors-middle-x = Midpoint between the motors in the world frame, along x.
meaning-motors-middle-y = Midpoint between the motors in the world frame, along y.
meaning-payload = Bending of the joint under the payload: angle under a moment of 100 N·m; positive in the direction of the load moment.
meaning-pedestal = Tilt or torsion of the base about its axis at the end of the name: angle under a moment of 100 N·m about this axis; positive in the direction of the moment.
meaning-proximal-link-1 = Length of the proximal link of arm 1, A1 to B1.
meaning-proximal-link-2 = Length of the proximal link of arm 2, A2 to B2.
meaning-rail-1-angle = Angle of rail 1 from the x axis of the base; counterclockwise positive.
meaning-rail-1-distance = Distance of rail 1 from the origin of the base, along y.
meaning-rail-3-angle = Angle of rail 3 from the y axis of the base; counterclockwise positive.
meaning-rail-3-distance = Distance of rail 3 from rail 2, along x.
meaning-rod-joint = Distance of the rod joint from the z axis of the platform, along the x axis of its leg; outwards positive.
meaning-rod-length = Length of the rod (forearm) between its joint centres.
meaning-station-pose = Pose of a further instrument station in the world frame: its origin, and its orientation as a rotation vector.
meaning-bar-length = Length of a bar between two targets.
meaning-surface-direction = Direction of a surface fixed in the world frame: slope of its trace along the axis at the end of the name.
meaning-target-orientation = Orientation of the target body on the flange, as a rotation vector.
meaning-target-place = Position of the target in the flange or platform frame, along the axis at the end of the name.
meaning-tool-angle = Angle at B2 from C to the tool E; counterclockwise positive.
meaning-tool-distance = Distance of the tool E from B2.
meaning-torque = Bending of the joint under its torque: angle under 100 N·m of the given torque; positive in the direction of the torque. With torques of the drive it is negative, because the joint yields against them.
meaning-tower-turn-x = Rotation of the tower about the x axis of its leg; counterclockwise positive.
meaning-tower-turn-y = Rotation of the tower about the y axis of its leg; counterclockwise positive.
meaning-upper-arm-length = Length of the upper arm, from the motor axis to the rod.
pedestal-or-first-joint = set either `pedestal` or joint { $joint } in `lateral`: both move the arm in nearly the same way
sketch-arm = Arm with all joint values zero: joint axes and link lengths.
sketch-five-bar = Five-bar mechanism seen from above: links and angles (counterclockwise positive). The tool is drawn next to C.
sketch-legs = Robot with all joints at the middle of their travel, and the parameters of leg 1. The other legs have the same parameters.
sketch-link-dh = Link with its standard Denavit-Hartenberg parameters.
sketch-link-mdh = Link with its modified Denavit-Hartenberg parameters.
sketch-table = Table seen from above, with exaggerated tilts: rails, carriages, platform C, and the balls K and L.

measure-all-working-modes = measure every position in each working mode that reaches it, and distribute the positions over the whole workspace

measure-different-angles = measure poses with different values of |theta|, for example 0 and the largest value of the table

out-of-reach = out of reach
out-of-reach-by = out of reach: { FIXED($away_mm, 1) } mm from the first joint; the reach of the arm is { FIXED($reach_mm, 1) } mm
pose-not-finite = the pose contains values that are not finite numbers
no-solution-found = no solution within the joint limits was found from { $starts } starting points
out-of-nominal-reach = out of reach of the nominal robot
joint-beyond-limits = { $joint } = { $q } { $unit } is outside its limits { $lower } and { $upper } { $unit }
angle-beyond-limits = { $joint } = { FIXED($q, 3) } deg is outside its limits { $least } and { $greatest } deg
actuator-beyond-travel = { $actuator } = { $rho } mm is outside its travel of 0 to { $end } mm
legs-apart = the legs cannot reach the platform
arms-do-not-meet = the two arms cannot meet
singularity-near = { FIXED($found, 3) } deg from the singularity of type { $kind } { $kind ->
        [1] (an arm stretched or folded)
       *[2] (the distal links in line)
    }, the required distance is { $margin } deg
links-near = the distance between links is { FIXED($found, 3) } mm; more than { $least } mm is required
command-refused = the controller rejects the command for this pose: { $reason }
joints-admit-no-pose = the robot has no pose at these joint values
no-command-leads-there = no command brings the robot to the target: the smallest error is { SCIENTIFIC($left_mm, 2) } mm
published-arm = another robot: { $title }
table-read-as = the table of joints is read as { $convention } Denavit-Hartenberg parameters
