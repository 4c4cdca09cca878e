### Messages of compare. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: A recorded path was not evaluated in every campaign.
# Matters: Only paths of all campaigns are compared.
# Do: Give streams of one path the same name in all campaigns.
# Example: a stream with `path` in one campaign and without `path` in the other
stream-not-in-all = stream `{ $stream }` is not in every campaign
    .hint = give the stream of one path the same name in all campaigns

# Means: The commanded points of a path differ between the campaigns.
# Matters: AT and RT of different points cannot be compared.
# Do: Use the same path, frame, `path_points` and `near_mm`.
# Example: a path of 100 mm in one campaign, of 110 mm in the other
stream-commands-differ = the commanded points of stream `{ $stream }` differ: AT and RT are not compared
    .hint = use the same path, frame, `path_points` and `near_mm` in all campaigns

# Means: A path has fewer passes than the test of a change was validated with.
# Matters: The intervals of AT and RT may be too narrow, so that a change may be reported without
# cause.
# Do: Drive the path ten times, as ISO 9283 requires.
# Example: four passes of a path
stream-few-passes = AT and RT of stream `{ $stream }` rest on { $passes ->
        [one] 1 pass
       *[other] { $passes } passes
    }; the test of a change is validated with { $validated }
    .hint = drive the path ten times (ISO 9283)

# Means: A change of path accuracy or repeatability is significant.
# Matters: In simulated tests, intervals of AT contain the true value in 93 % to 95 %, those of RT
# in 90 % to 98 %. Confirm a single significant change by a repeated measurement.
# Do: Repeat the test before you act on it.
# Example: AT of a square changes from 0.10 mm to 0.15 mm
path-change-uncertain = significant change: { $names }; in simulated tests, intervals of AT contain the true value in 93 % to 95 %, those of RT in 90 % to 98 %
    .hint = repeat the test before you act on it

# Means: The campaigns have no document in common.
# Matters: There is nothing to compare.
# Do: Run the campaigns with this version.
# Example: a campaign with `parameters.json` and one with `iso9283.json`
nothing-to-compare = the campaigns have no results in common
    .expected = parameters.json, iso9283.json or iso9283-streams.json in the folder of every campaign
    .hint = run the campaigns with this version: `etalon run CAMPAIGN`

# Means: One campaign is named.
# Matters: A change is a difference between two campaigns.
# Do: Name two folders or more.
# Example: `etalon compare 2026/out`
one-campaign = a comparison needs at least two campaigns
    .expected = two folders or more

# Means: The same folder is named twice.
# Matters: A campaign does not differ from itself.
# Do: Name each folder once.
# Example: `etalon compare a/out a/out`
campaign-twice = `{ $folder }` is named twice
    .hint = name each folder once

# Means: The campaigns measured robots of different names.
# Matters: Differences between two robots are not changes of one robot.
# Do: Compare campaigns of one robot. If it is the same robot, give it one `name` in robot.toml and
# run again.
# Example: `name = "R1"` and `name = "R2"`
robots-differ = different robots: `{ $first }` measured `{ $first_robot }`, `{ $second }` `{ $second_robot }`
    .hint = compare campaigns of one robot; if it is the same, give it one `name` in robot.toml and run again

# Means: The campaigns identified different robot models.
# Matters: Parameters of different models cannot be compared.
# Do: Identify both campaigns with one model.
# Example: `model = "serial"` and `model = "urdf"`
models-differ = different robot models: `{ $first }` identified `{ $first_model }`, `{ $second }` `{ $second_model }`
    .hint = identify both with one model

# Means: The campaigns have parameters of different names.
# Matters: A parameter without partner has no change.
# Do: Use the same robot file, targets and model.
# Example: a target `T3` in one campaign only
parameters-differ = `{ $first }` and `{ $second }` have different parameters: { $parameters }
    .hint = use the same robot file, targets and model

# Means: A campaign is named before an older one.
# Matters: A change is the later-named campaign minus the earlier-named one; the signs are reversed.
# Do: Name the earliest campaign first.
# Example: `etalon compare 2026/out 2025/out`
campaigns-out-of-order = `{ $first }` is named before `{ $second }`, but has the later date
    .hint = name the earliest campaign first

# Means: A document is missing in some of the campaigns.
# Matters: Its values are not compared.
# Do: Compare campaigns that all have it.
# Example: [[stream]] in one campaign alone
document-not-in-all = { $document } is not compared: it is missing in { $folders }
    .hint = compare campaigns that all have it

# Means: Poses were not tested in every campaign.
# Matters: Only poses of all campaigns are compared.
# Do: Give the same pose the same name in all campaigns.
# Example: poses 1 to 5 in one campaign, 1 to 4 in the other
poses-not-in-all = not in every campaign: { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = the name of a pose must mean the same pose in all campaigns

homing = homing

# Means: Parameters were identified in some of the campaigns only.
# Matters: In campaigns that held them, similar parameters absorbed their error.
# Do: Identify the same parameters in all campaigns.
# Example: `hold = ["d_3"]` in one campaign
parameters-not-in-all = not every campaign identified { $parameters }
    .hint = identify the same parameters: similar parameters may have absorbed the error of held ones

# Means: The robot files of the campaigns have different nominal values.
# Matters: Held parameters affect the identified ones.
# Do: Use the same robot file in all campaigns.
# Example: `a_2 = 300.0` and `a_2 = 300.5`
nominal-values-differ = nominal values differ between the robot files: { $parameters }
    .hint = use the same robot file: held parameters affect the identified ones

# Means: Residuals exceed the uncertainty of the instrument.
# Matters: The model lacks an effect of the robot. Its parameters depend on the measured poses, so
# that differences are no evidence of a change.
# Do: Identify with a model that describes the robot, and measure the same poses each time.
# Example: an arm with bending links, identified without bending
model-misfits = residuals of { $campaigns } exceed the instrument’s uncertainty: changes of parameters and mean errors are not tested (no p values); the intervals of parameters include the between-series component (Birge ratio up to { $birge })
    .hint = identify with a model that describes the robot, and measure the same poses each time
