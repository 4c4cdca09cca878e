### Messages of view. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: More connections are open than the server of the page answers at the same time.
# Matters: The bound protects the measurement from a program that opens connections without end.
# Do: Close other pages of `etalon view`, and load the page again.
# Example: a program that opens 1,000 connections
view-busy = more than { $most } connections at the same time
    .hint = close other pages of this program, and load the page again

# Means: A request is no request of HTTP/1.1, or its document is not the expected JSON.
# Matters: Nothing of the request was carried out.
# Do: Load the page again. Programs send the documents that docs/view.md describes.
# Example: POST /api/whatif with the body `[1`
view-request-malformed = the request cannot be read
    .hint = load the page again

# Means: The head or the body of a request did not arrive in time.
# Matters: Nothing of the request was carried out.
# Do: Send the request again.
# Example: a connection that sends one byte a second
view-request-slow = the request did not arrive in time
    .hint = send the request again

# Means: A request has a body, but does not give its length.
# Matters: Without a length the size of a file cannot be bounded before it is received.
# Do: Set `Content-Length`; browsers do so by themselves.
# Example: POST /api/files with `Transfer-Encoding: chunked`
view-request-without-length = the request does not give the length of its body
    .hint = set `Content-Length`

# Means: A dropped file or a document is larger than the page accepts.
# Matters: The file was not stored.
# Do: Copy the file into the folder of the campaign, and name it in campaign.toml.
# Example: a recording of 2 GiB that is dropped on the page
view-request-too-large = the file is larger than { $mib } MiB
    .hint = copy the file into the folder of the campaign, and load the page again

# Means: The server does not know the address of the request.
# Matters: Nothing was carried out.
# Do: Load the page from the address that the program prints.
# Example: GET /favicon.ico
view-request-unknown = the server does not know this address
    .hint = load the page from the address that the program prints

# Means: The request names another server than this one.
# Matters: Another page may have given its own name to this machine (DNS rebinding).
# Do: Load the page from the address that the program prints.
# Example: a request with `Host: example.com`
view-other-host = the request names another server
    .expected = { $name }
    .hint = load the page from the address that the program prints

# Means: Another page of the browser sent the request.
# Matters: Other pages must neither read measurements nor change a campaign.
# Do: Close the other page.
# Example: a request with `Origin: https://example.com`
view-other-origin = the request comes from another page
    .hint = close the other page

# Means: The request has no token, or the token of an earlier start.
# Matters: The token proves that the page belongs to the user who started the program.
# Do: Open the address that the program prints, with its token.
# Example: the page of an earlier start is loaded again
view-token-missing = the token of the page is missing or is from an earlier start
    .hint = open the address that the program prints

# Means: The name of a dropped file is not a plain name of a file.
# Matters: Names with separators, control characters or signs of markup could leave the folder.
# Do: Rename the file: letters, digits, spaces, `.`, `-`, `_` and brackets.
# Example: a file named `../points.csv`
view-file-name = the name of the file is not a plain file name
    .expected = a name without folders, and without the characters : * ? " < > |
    .hint = rename the file, and drop it again

# Means: The page offers no file of this name.
# Matters: The page offers nothing but the files of the last run.
# Do: Run the campaign, and choose a file of the list.
# Example: GET /api/download?name=campaign.toml
view-download-unknown = the page offers no file of this name
    .hint = run the campaign, and choose a file of the list

# Means: A file was dropped whose name another file of the folder has.
# Matters: No file of a campaign is overwritten.
# Do: Rename the dropped file, or remove the other one.
# Example: points.csv is dropped on a campaign with points.csv
view-file-exists = `{ $name }` exists in the folder already
    .hint = rename the dropped file, or remove the other one from the folder

# Means: More or larger files were dropped than the page accepts.
# Matters: The file was not stored.
# Do: Copy the files into the folder of the campaign, and name them in campaign.toml.
# Example: the 201st file that is dropped on the page
view-folder-full = more than { $files } files or { $mib } MiB were dropped
    .hint = copy the files into the folder of the campaign, and load the page again

# Means: The page was asked to remove a file that was not dropped on it.
# Matters: The page removes no file of the user.
# Do: Remove the file in the folder.
# Example: DELETE /api/files?name=campaign.toml
view-file-not-dropped = `{ $name }` was not dropped on this page
    .hint = remove the file in the folder itself

# Means: No file was dropped from which a campaign could be proposed.
# Matters: A campaign is proposed from exports and logs.
# Do: Drop the export of the measuring system, and the log of the controller.
# Example: a click on the proposal of an empty page
view-nothing-dropped = no file with measurements was dropped
    .hint = drop the export of the measuring system, and the log of the controller

# Means: The folder has a campaign.toml already.
# Matters: A proposal does not overwrite a campaign.
# Do: Change the campaign itself, or start `etalon view` with a new folder.
# Example: a proposal is accepted twice
view-campaign-exists = the folder has a campaign.toml already
    .hint = change campaign.toml itself, or start `etalon view` with a new folder

# Means: The request needs a campaign, and the folder has none that can be read.
# Matters: Nothing was computed.
# Do: Drop files and accept the proposal, or correct campaign.toml.
# Example: a run of an empty page
view-without-campaign = the folder has no campaign that can be read
    .hint = drop files and accept the proposal, or correct campaign.toml

# Means: A run is asked for while another one computes.
# Matters: Two runs would write the same output folder.
# Do: Wait for the end of the run.
# Example: two clicks on the same button
view-run-in-progress = a run is in progress
    .hint = wait for its end

# Means: The campaign has no identification that another one could be compared with.
# Matters: Nothing was computed.
# Do: Correct the errors of the campaign; a test to ISO 9283 alone identifies nothing.
# Example: a question about parameters of a campaign without [identify]
view-not-identified = the campaign has no identification to compare with
    .hint = correct the errors of the campaign, or add [identify]

# Means: No pose of this name was measured.
# Matters: Nothing was computed.
# Do: Choose a pose of the list.
# Example: `"leave_out_poses": ["9999"]`
view-pose-unknown = pose `{ $name }` was not measured
    .hint = choose a measured pose

# Means: A change of the campaign has no reason.
# Matters: The report repeats the reason, and an exclusion without one cannot be defended.
# Do: Write the reason in a sentence.
# Example: an exclusion with the reason `" "`
view-reason-missing = the change has no reason
    .hint = write why the campaign is changed

# Means: A change of the campaign was asked for that changes nothing.
# Matters: Nothing was written.
# Do: Leave out a pose or target, hold or free a parameter, or give another limit.
# Example: `"asked": {}`
view-nothing-asked = nothing was asked to be changed
    .hint = leave out a pose or a target, hold or free a parameter, or give another limit

# Means: campaign.toml gives a key in a form that the page cannot change.
# Matters: Nothing was written.
# Do: Change campaign.toml by hand.
# Example: `identify = { calibration = "all" }` on one line
view-campaign-not-editable = `{ $key }` cannot be changed in campaign.toml by the page
    .hint = change campaign.toml by hand, for example with [identify] as a section of its own

# Means: A parameter is to be identified, but a pattern in `hold`, the effects or the data hold it.
# Matters: The other identification would be the same.
# Do: Change `hold` or `effects` in campaign.toml.
# Example: `hold = ["delta*"]`, and `delta_1` is to be free
view-parameter-stays-held = parameter `{ $name }` is not held by its name in `hold`
    .hint = change `hold` or `effects` in [identify] by hand

# Means: The server cannot listen at the port.
# Matters: The page cannot be shown.
# Do: Give another port, or none for a free one.
# Example: `--port 80` without the right to use it
view-port-unavailable = the server cannot listen at port { $port }: { $error }
    .hint = give another `--port`, or none for a free one

# Means: The browser could not be started.
# Matters: The server runs; the page is not open.
# Do: Open the address by hand.
# Example: a server without a desktop
view-browser-not-opened = the browser could not be opened
    .hint = open { $url }

# Means: The newest pose differs from the prediction by more than measurement and model explain.
# Matters: An outlier, a moved instrument or a wrong joint value would spoil the calibration.
# Do: Measure the pose again before the next one.
# Example: a target that was touched at its rim
watch-disagrees = pose { $pose } disagrees: { FIXED($error_um, 0) } µm at { $target }, expected at most { FIXED($expected_um, 0) } µm
    .hint = measure the pose again, and check target and joint values

# Means: The newest pose fits if two of its targets are exchanged.
# Matters: Exchanged labels spoil the calibration.
# Do: Correct the labels in the measuring system.
# Example: SMR_1 was measured as SMR_2
watch-labels-exchanged = pose { $pose } fits if `{ $first }` and `{ $second }` are exchanged
    .hint = correct the labels in the measuring system, or measure the pose again

# Means: The newest pose fits with the joint values of another pose.
# Matters: The log is late or early: its rows belong to other poses.
# Do: Check when the controller writes the log.
# Example: the log is written before the robot stands still
watch-joints-of-other-pose = pose { $pose } fits with the joint values of pose { $other }
    .hint = check when the controller writes the log: it may be late

# Means: The newest pose lacks a target that was measured at most other poses.
# Matters: The pose contributes less, or its orientation is unknown.
# Do: Make the target visible, and measure the pose again.
# Example: a reflector that is turned away from the tracker
watch-target-missing = pose { $pose } lacks { $targets }
    .hint = turn the target to the instrument, and measure the pose again

view-opened = page: { $url }
view-next = close the page or press Ctrl-C to end the program
view-run-begins = reading files
view-run-writes = writing the report
view-next-drop = drop the export of the measuring system and the log of the controller on the page
view-verdict-limit = { $limit }: { FIXED($value, 4) } { $unit } ± { FIXED($expanded, 4) } { $unit } (k = 2), limit { FIXED($bound, 4) } { $unit }
view-verdict-limit-unknown = { $limit }: { FIXED($value, 4) } { $unit }, limit { FIXED($bound, 4) } { $unit }
view-verdict-no-limit = no limit is given
view-download-report = report ({ $kind })
view-download-file = file for a controller or another program
view-question-instrument = What is the measuring system called?
view-question-uncertainty = What is the expanded uncertainty of one coordinate (µm, k = 2)? The calibration certificate gives it.
view-question-rotation = What is the expanded uncertainty of a measured orientation (°)?
view-question-unit = Which unit do the lengths in { $file } have?
view-question-joint-unit = Which unit do the joint values in { $file } have?
view-question-robot = Which robot was measured?
view-question-key = What is `{ $key }` in [{ $section }]?
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
watch-stop-met = limit met with its guard band: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limit { FIXED($limit_um, 0) } µm
watch-stop-open = not yet: { FIXED($value_um, 0) } µm ± { FIXED($expanded_um, 0) } µm (k = 2), limit { FIXED($limit_um, 0) } µm
watch-stop-no-limit = no limit is given: set `position_max_mm` in [limits]
watch-next-of-plan = next pose of the plan
watch-next-of-most-information = of the remaining poses, this one reduces the uncertainty of the parameters most
