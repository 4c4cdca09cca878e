### Messages of compare. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: A recorded path was not evaluated in every campaign.
# Matters: The comparison uses only paths that every campaign evaluated.
# Do: Set the same `name` for the [[stream]] of this path in every campaign.
# Example: a stream with `path` in one campaign and without `path` in the other
stream-not-in-all = stream `{ $stream }` is not in every campaign
    .hint = give the [[stream]] of this path the same name in all campaigns

# Means: The commanded points of a path differ between the campaigns.
# Matters: AT and RT of different points cannot be compared.
# Do: Use one table of commanded points, and the same `path_points` and `near_mm`, in all campaigns.
# Example: a path of 100 mm in one campaign, of 110 mm in the other
stream-commands-differ = the commanded points of stream `{ $stream }` differ: AT and RT are not compared
    .hint = use the same path, frame, `path_points` and `near_mm` in all campaigns

# Means: A path has fewer passes than the tests of a change were validated for.
# Matters: The intervals of AT and RT may be too narrow, so a change may be reported although the
# robot has not changed.
# Do: Drive the path ten times in the next test, as ISO 9283 requires.
# Example: four passes of a path
stream-few-passes = AT and RT of stream `{ $stream }` come from { $passes ->
        [one] 1 pass
       *[other] { $passes } passes
    }; the test of a change needs { $validated } passes
    .hint = drive the path ten times (ISO 9283)

# Means: A change of path accuracy or repeatability is significant.
# Matters: In simulated tests, 93 % to 95 % of the intervals of AT contain the true value, and 90 %
# to 98 % of the intervals of RT.
# Do: Repeat the test. Act only if the second test shows the same change.
# Example: AT of a square changes from 0.10 mm to 0.15 mm
path-change-uncertain = significant change: { $names }; in simulated tests, 93 % to 95 % of the intervals of AT and 90 % to 98 % of the intervals of RT contain the true value
    .hint = repeat the test before you act on it

# Means: The campaigns have no result document in common.
# Matters: There is nothing to compare.
# Do: Run all campaigns with this version of etalon.
# Example: a campaign with `parameters.json` and one with `iso9283.json`
nothing-to-compare = the campaigns have no results in common
    .expected = parameters.json, iso9283.json or iso9283-streams.json in the folder of every campaign
    .hint = run the campaigns with this version: `etalon run CAMPAIGN`

# Means: The command has only one campaign.
# Matters: A change is a difference between two campaigns.
# Do: Add the output folder of another campaign.
# Example: `etalon compare 2026/out`
one-campaign = a comparison needs at least two campaigns
    .expected = two folders or more

# Means: The same folder is given twice.
# Matters: A campaign cannot differ from itself.
# Do: Give each folder once.
# Example: `etalon compare a/out a/out`
campaign-twice = `{ $folder }` is given twice
    .hint = give each folder once

# Means: Two folders contain the very same readings.
# Matters: A copy of a campaign shows no change of the robot.
# Do: Replace exports and logs of the later campaign by the files of its own measurement.
# Example: `etalon compare campaign copy`
campaigns-with-same-readings = { $count ->
        [one] two folders contain
       *[other] folders contain
    } the same readings: { $pairs }
    .hint = replace exports and logs of the later campaign by the files of its own measurement
same-readings = `{ $first }` and `{ $second }`

# Means: The robot files of the campaigns have different names.
# Matters: Differences between two robots are not changes of one robot.
# Do: Compare campaigns of one robot. If only the name differs, correct `name` in robot.toml and run
# again.
# Example: `name = "R1"` and `name = "R2"`
robots-differ = different robots: `{ $first }` measured `{ $first_robot }`, `{ $second }` measured `{ $second_robot }`
    .hint = compare campaigns of one robot; if only the name differs, correct `name` in robot.toml and run again

# Means: The campaigns identified different robot models.
# Matters: Parameters of different models cannot be compared.
# Do: Run one of the campaigns again with the model of the other.
# Example: `model = "serial"` and `model = "urdf"`
models-differ = different robot models: `{ $first }` identified `{ $first_model }`, `{ $second }` `{ $second_model }`
    .hint = identify both campaigns with one model

# Means: A parameter exists in one campaign only.
# Matters: Its change cannot be computed.
# Do: Use the same robot file and the same names of targets, and run again.
# Example: a target `T3` in one campaign only
parameters-differ = `{ $first }` and `{ $second }` have different parameters: { $parameters }
    .hint = use the same robot file, targets and model

# Means: A newer campaign is given before an older one.
# Matters: A change is the second campaign minus the first; in this order, all signs are reversed.
# Do: Give the oldest campaign first.
# Example: `etalon compare 2026/out 2025/out`
campaigns-out-of-order = `{ $first }` is given before `{ $second }`, but its date is later
    .hint = give the oldest campaign first

# Means: Some of the campaigns do not have this document.
# Matters: Its values are not compared.
# Do: To compare it, measure the same kind of test in all campaigns.
# Example: [[stream]] in one campaign alone
document-not-in-all = { $document } is not compared: it is missing in { $folders }
    .hint = compare campaigns that all have this document

# Means: Some poses were not tested in every campaign.
# Matters: The comparison uses only poses that every campaign has.
# Do: If the poses are the same, give them the same names in all campaigns.
# Example: poses 1 to 5 in one campaign, 1 to 4 in the other
poses-not-in-all = not in every campaign: { $count ->
        [one] pose { $poses }
       *[other] poses { $poses }
    }
    .hint = the name of a pose must mean the same pose in all campaigns

homing = homing

# Means: Some parameters were identified in one campaign and held in another.
# Matters: If a parameter is held, similar parameters absorb its error.
# Do: Use the same `hold` in all campaigns.
# Example: `hold = ["d_3"]` in one campaign
parameters-not-in-all = not every campaign identified { $parameters }
    .hint = identify the same parameters: if a parameter is held, similar parameters absorb its error

# Means: The robot files of the campaigns have different nominal values.
# Matters: The values of held parameters influence the identified parameters.
# Do: Use the same robot file in all campaigns.
# Example: `a_2 = 300.0` and `a_2 = 300.5`
nominal-values-differ = nominal values differ between the robot files: { $parameters }
    .hint = use the same robot file: held parameters influence the identified ones

# Means: Residuals exceed the uncertainty of the instrument.
# Matters: The model does not describe an effect of the robot. Its parameters then depend on the
# measured poses, so different parameters do not show that the robot changed.
# Do: Add the missing effect to the model (`etalon recommend`), and measure the same poses each
# time.
# Example: an arm with bending links, identified without bending
model-misfits = residuals of { $campaigns } exceed the instrument’s uncertainty: changes of parameters and mean errors are not tested (no p values); the intervals of parameters include the between-series component (Birge ratio up to { $birge })
    .hint = add the missing effect to the model, and measure the same poses each time
