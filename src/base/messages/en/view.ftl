### Messages of view. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: The server of the page has more open connections than it can answer at the same time.
# Matters: This limit protects the measurement from a program that opens connections without end.
# Do: Close other pages of `etalon view`, then load this page again.
# Example: a program that opens 1,000 connections
view-busy = there are more than { $most } connections at the same time
    .hint = close other pages of this program, and load the page again

# Means: The server received something that is not an HTTP/1.1 request, or a document that is not
# the expected JSON.
# Matters: The request had no effect.
# Do: Load the page again. If your own program sent the request, compare it with docs/view.md.
# Example: POST /api/whatif with the body `[1`
view-request-malformed = the request cannot be read
    .hint = load the page again

# Means: The header or the body of a request did not arrive in time.
# Matters: The request had no effect.
# Do: Repeat the action; check the network if the browser is on another machine.
# Example: a connection that sends one byte per second
view-request-slow = the request did not arrive in time
    .hint = send the request again

# Means: A request has a body, but no `Content-Length`.
# Matters: The server limits the size of a file before it receives the file, so it needs the length.
# Do: Set `Content-Length` in your program; browsers set it themselves.
# Example: POST /api/files with `Transfer-Encoding: chunked`
view-request-without-length = the length of the request body is missing
    .hint = set `Content-Length`

# Means: A dropped file or a document exceeds the maximum size of the page.
# Matters: The file was not stored.
# Do: Copy the file into the folder of the campaign, and use its name in campaign.toml.
# Example: a recording of 2 GiB dropped on the page
view-request-too-large = the file is larger than { $mib } MiB
    .hint = copy the file into the folder of the campaign, and load the page again

# Means: The server has no page at this address.
# Matters: The request had no effect.
# Do: Load the page from the address that the program prints.
# Example: GET /favicon.ico
view-request-unknown = the server has no page at this address
    .hint = load the page from the address that the program prints

# Means: The request is for another server than this one.
# Matters: Another web page may have tried to reach this machine under its own name (DNS rebinding).
# Do: Load the page from the address that the program prints.
# Example: a request with `Host: example.com`
view-other-host = the request is for another server
    .expected = { $name }
    .hint = load the page from the address that the program prints

# Means: Another page in the browser sent the request.
# Matters: Other pages must not read measurements or change a campaign.
# Do: Close the other page, then load this page again.
# Example: a request with `Origin: https://example.com`
view-other-origin = the request comes from another page
    .hint = close the other page

# Means: The request has no token, or the token is from an earlier start of the program.
# Matters: The token shows that the page belongs to the user who started the program.
# Do: Open the address that the program prints: it contains the token.
# Example: the page of an earlier start, loaded again
view-token-missing = the token of the page is missing or is from an earlier start
    .hint = open the address that the program prints

# Means: The name of a dropped file contains characters that are not allowed.
# Matters: With such characters, a file could be written outside the folder.
# Do: Rename the file: use letters, digits, spaces, `.`, `-`, `_` and brackets.
# Example: a file named `../points.csv`
view-file-name = the name of the file contains characters that are not allowed
    .expected = a name without folders, and without the characters : * ? " < > |
    .hint = rename the file, and drop it again

# Means: The page does not offer a file with this name.
# Matters: The page offers only the files of the last run.
# Do: Run the campaign, then choose a file from the list.
# Example: GET /api/download?name=campaign.toml
view-download-unknown = the page does not offer a file with this name
    .hint = run the campaign, then choose a file from the list

# Means: The folder already contains a file with the name of the dropped file.
# Matters: The page never overwrites a file of a campaign.
# Do: Rename the dropped file, or delete the other file in the folder.
# Example: points.csv is dropped on a campaign with points.csv
view-file-exists = the folder already contains `{ $name }`
    .hint = rename the dropped file, or delete the other file in the folder

# Means: The number or the size of the dropped files exceeds the limit of the page.
# Matters: The file was not stored.
# Do: Copy the files into the folder of the campaign, and use their names in campaign.toml.
# Example: the 201st file dropped on the page
view-folder-full = more than { $files } files or { $mib } MiB were dropped
    .hint = copy the files into the folder of the campaign, and load the page again

# Means: The request removes a file that was not dropped on this page.
# Matters: The page removes only files that were dropped on it.
# Do: Delete the file in the folder yourself.
# Example: DELETE /api/files?name=campaign.toml
view-file-not-dropped = `{ $name }` was not dropped on this page
    .hint = delete the file in the folder yourself

# Means: None of the dropped files is an export or a log.
# Matters: A campaign is proposed from exports and logs.
# Do: Drop the export of the measuring system and the log of the controller.
# Example: a click on the proposal of an empty page
view-nothing-dropped = no file with measurements was dropped
    .hint = drop the export of the measuring system, and the log of the controller

# Means: The folder already contains a campaign.toml.
# Matters: A proposal never overwrites a campaign.
# Do: Edit campaign.toml, or start `etalon view` with a new folder.
# Example: a proposal is accepted twice
view-campaign-exists = the folder already contains a campaign.toml
    .hint = edit campaign.toml, or start `etalon view` with a new folder

# Means: The request needs a campaign, but the folder contains no readable one.
# Matters: Nothing was computed.
# Do: Drop files and accept the proposal, or correct the errors in campaign.toml.
# Example: a run on an empty page
view-without-campaign = the folder contains no readable campaign
    .hint = drop files and accept the proposal, or correct campaign.toml

# Means: A run was started while another run is computing.
# Matters: Two runs cannot write to the same output folder.
# Do: Wait until the first run has ended, then start again.
# Example: two clicks on the same button
view-run-in-progress = a run is in progress
    .hint = wait until it has ended

# Means: The campaign has no identification, so there is nothing to compare a change with.
# Matters: Nothing was computed.
# Do: Correct the errors of the campaign, or add [identify]. A test to ISO 9283 alone identifies no
# parameters.
# Example: a question about parameters of a campaign without [identify]
view-not-identified = the campaign has no identification to compare with
    .hint = correct the errors of the campaign, or add [identify]

# Means: No measured pose has this name.
# Matters: Nothing was computed.
# Do: Choose a pose from the list.
# Example: `"leave_out_poses": ["9999"]`
view-pose-unknown = pose `{ $name }` was not measured
    .hint = choose a measured pose

# Means: A change of the campaign has no reason.
# Matters: The report contains the reason. Without a reason, an exclusion cannot be justified.
# Do: Write the reason as one sentence.
# Example: an exclusion with the reason `" "`
view-reason-missing = the change has no reason
    .hint = write the reason for this change

# Means: The request changes nothing in the campaign.
# Matters: Nothing was written.
# Do: Exclude a pose or a target, hold or free a parameter, or change a limit.
# Example: `"asked": {}`
view-nothing-asked = the request changes nothing
    .hint = exclude a pose or a target, hold or free a parameter, or change a limit

# Means: A key in campaign.toml is written in a form that the page cannot change.
# Matters: Nothing was written.
# Do: Edit campaign.toml yourself, for example write [identify] as a separate section.
# Example: `identify = { calibration = "all" }` on one line
view-campaign-not-editable = the page cannot change `{ $key }` in campaign.toml
    .hint = edit campaign.toml, for example write [identify] as a separate section

# Means: A parameter should be identified, but a pattern in `hold`, the choice of effects or the
# data hold it.
# Matters: The identification does not change.
# Do: Change `hold` or `effects` in campaign.toml yourself.
# Example: `hold = ["delta*"]`, but `delta_1` should be identified
view-parameter-stays-held = parameter `{ $name }` is held, but `hold` does not contain its name
    .hint = edit `hold` or `effects` in [identify]

# Means: The server cannot use this port.
# Matters: The page cannot be shown.
# Do: Choose another port, or omit `--port` to use any free port.
# Example: `--port 80` without the right to use it
view-port-unavailable = the server cannot use port { $port }: { $error }
    .hint = choose another `--port`, or omit it to use any free port

# Means: The program could not start the browser.
# Matters: The server is running, but the page is not open.
# Do: Copy the address into a browser.
# Example: a server without a desktop
view-browser-not-opened = the browser could not be opened
    .hint = open { $url }

# Means: The newest pose differs from its prediction by more than the uncertainty of the measurement
# and of the model.
# Matters: An outlier, a moved instrument or a wrong joint value makes the calibration wrong.
# Do: Measure this pose again before you move to the next one.
# Example: a reflector that was touched at its edge
watch-disagrees = pose { $pose } disagrees: { FIXED($error_um, 0) } µm at { $target }, expected at most { FIXED($expected_um, 0) } µm
    .hint = measure the pose again, and check target and joint values

# Means: The newest pose agrees with its prediction if two of its targets are swapped.
# Matters: Swapped labels make the calibration wrong.
# Do: Correct the labels in the measuring system, or measure the pose again.
# Example: SMR_1 was measured as SMR_2
watch-labels-exchanged = pose { $pose } agrees if `{ $first }` and `{ $second }` are swapped
    .hint = correct the labels in the measuring system, or measure the pose again

# Means: The newest pose agrees with the joint values of another pose.
# Matters: The log is too early or too late: its rows belong to other poses.
# Do: Check when the controller writes the row of the log.
# Example: the log is written before the robot stands still
watch-joints-of-other-pose = pose { $pose } agrees with the joint values of pose { $other }
    .hint = check when the controller writes the log: it may be late

# Means: The newest pose does not contain a target that most other poses contain.
# Matters: The pose contributes less information, or its orientation is unknown.
# Do: Turn the target to the instrument, and measure the pose again.
# Example: a reflector that is turned away from the tracker
watch-target-missing = pose { $pose } does not contain { $targets }
    .hint = turn the target to the instrument, and measure the pose again

# Means: Readings of poses that were there at the last look are gone: a file vanished, or is shorter.
# Matters: The poses no longer identify. The page shows the result without them.
# Do: Put the file back, or measure the poses again.
# Example: a file of a pose is deleted while the campaign is watched
watch-poses-gone = { $count ->
        [one] pose { $poses } is gone
       *[other] { $count } poses are gone: { $poses }
    }
    .hint = put the file back, or measure the poses again

view-opened = page: { $url }
view-next = close the page or press Ctrl-C to end the program
view-run-begins = reading files
view-run-writes = writing the report
view-next-drop = drop the export of the measuring system and the log of the controller on the page
view-verdict-limit = { $limit }: { FIXED($value, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } (k = 2), limit { FIXED($bound, 4) } { $unit }
view-verdict-limit-unknown = { $limit }: { FIXED($value, 4) } { $unit }, limit { FIXED($bound, 4) } { $unit }
view-verdict-no-limit = there is no limit
view-download-report = report ({ $kind })
view-download-file = file for a controller or another program
view-question-instrument = What is the name of the measuring system?
view-question-uncertainty = What is the expanded uncertainty of one coordinate (µm, k = 2)? It is in the calibration certificate.
view-question-rotation = What is the expanded uncertainty of a measured orientation (°)?
view-question-unit = What is the unit of the lengths in { $file }?
view-question-joint-unit = What is the unit of the joint values in { $file }?
view-question-time-unit = What is the unit of the times in { $file }?
view-question-angle-unit = What is the unit of the measured rotations in { $file }?
view-question-rotation-order = In which order do the three angles in { $file } turn (`zyx`, `fixed xyz`), or are they a rotation vector (`vector`)?
view-question-world = Did the instrument measure in the frame of the robot? If not, define the frame from points in [frame.world].
view-question-robot = Which robot was measured?
view-question-key = What is the value of `{ $key }` in [{ $section }]?
watch-waiting = waiting for the first pose
watch-few = { $received ->
        [one] { $received } pose: too few for an identification
       *[other] { $received } poses: too few for an identification
    }
watch-agrees = pose { $pose } agrees: { FIXED($error_um, 0) } µm, expected at most { FIXED($expected_um, 0) } µm
watch-first = { $received ->
        [one] { $received } pose identified
       *[other] { $received } poses identified
    }
watch-stop-met = the limit is met, including its guard band: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limit { FIXED($limit_um, 0) } µm
watch-stop-open = the limit is not yet met: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limit { FIXED($limit_um, 0) } µm
watch-stop-no-limit = there is no limit: set `position_max_mm` in [limits]
watch-next-of-plan = next pose of the plan
watch-next-of-most-information = of the remaining poses, this pose reduces the uncertainty of the parameters most
