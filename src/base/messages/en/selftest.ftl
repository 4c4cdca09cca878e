### Messages of selftest. Above each message: its explanation (see CONTRIBUTING.md, "A message").

# Means: The reference data inside the program cannot be read.
# Matters: Without these data the installation cannot be validated. The program file is damaged.
# Do: Install etalon again. Then compare the SHA-256 of the program file with the SHA-256 of the
# release.
# Example: a program file with a changed byte
selftest-data-unreadable = the reference data `{ $name }` in the program cannot be read: { $reason }
    .hint = install etalon again

# Means: The validation cannot write to the folder for temporary files.
# Matters: The validation writes a campaign there, runs it, and removes it.
# Do: Free space on the disk, or set `TMPDIR` (`TEMP` on Windows) to a folder where you may write.
# Example: `TMPDIR=/missing etalon selftest`
selftest-folder-not-written = `{ $folder }` cannot be written: { $reason }
    .hint = set `TMPDIR` (`TEMP` on Windows) to a folder where you may write

selftest-hash-expected = a SHA-256: 64 hexadecimal digits

## Requirements
selftest-fits = Geometric elements: fits agree with an independent program (60 digits), minimum zones and enclosing circles with exact values
selftest-solver = Solver: published nonlinear least-squares problems reach their published minima
selftest-frames = Frames: orientations and transforms agree with exact values
selftest-kinematics = Kinematics: each model agrees with an independent program (60 digits), with its inverse, with numeric derivatives and with the exported code
selftest-identification = Identification: exact observations return the parameters; a whole campaign returns the true values within their uncertainty
selftest-reference = Reference campaigns: parameters, covariance and errors agree with an independent program (110 digits)
selftest-uncertainty = Uncertainties: published examples of the GUM (H.1 to H.3) and of JCGM 101 (9.2 to 9.5) are reproduced
selftest-standards = ISO 9283 and ISO 230-2: characteristics agree with independent programs
selftest-coverage = Coverage: 95 % intervals contain the true value in 95 % of simulated campaigns
selftest-formats = Exports of measuring systems: known texts give their known coordinates; every written format reads back without changes
selftest-exports = Controller files: the written values read back without changes
selftest-threads = Threads: identical input gives identical output on one thread and on many
selftest-nist = Reference data of NIST: fitted elements agree with the published ones

## Tests
selftest-not-made = { $name }: not possible: { $reason }
selftest-fit-point = { $name }: point
selftest-fit-direction = { $name }: direction
selftest-fit-size = { $name }: radius or angle
selftest-fit-squares = { $name }: sum of squares
selftest-fit-uncertainty = { $name }: standard uncertainty of the radius
selftest-zone = { $name }: minimum zone
selftest-enclosing = { $name }: smallest enclosing radius
selftest-sum-of-squares = { $name }: sum of squares at the minimum
selftest-solution = { $name }: parameters at the minimum
selftest-covariance = { $name }: covariance
selftest-quaternion = quaternion of a rotation
selftest-quaternion-back = rotation of a quaternion
selftest-rotation-vector = rotation matrix of a rotation vector
selftest-rotation-vector-back = rotation vector of a rotation matrix
selftest-rpy = rotation matrix of roll, pitch, yaw
selftest-rpy-back = roll, pitch, yaw of a rotation matrix
selftest-apply = transform of a point
selftest-inverse = transform composed with its inverse
selftest-rigid = transform between two sets of points
selftest-rigid-rms = residuals of this transform
selftest-positions = { $name }: positions of the targets
selftest-jacobian = { $name }: derivatives compared with numeric derivatives
selftest-inverse-none = { $name }: the inverse finds no joint values
selftest-direct-of-inverse = { $name }: direct(inverse(pose)) minus pose
selftest-inverse-of-direct = { $name }: inverse(direct(joints)) minus joints
selftest-code = { $name }: position computed by the exported `{ $format }`
selftest-recovered = { $name }: positions with the parameters identified from exact observations
selftest-truth = { $name }: largest deviation of a parameter from its true value, divided by its uncertainty
selftest-chi-square = chi-square over degrees of freedom
selftest-certified-values = { $name }: { $count } parameters
selftest-certified-uncertainties = { $name }: standard uncertainties
selftest-certified-status = { $name }: parameters that are wrongly held or identified
selftest-certified-covariance = { $name }: covariance
selftest-certified-residuals = { $name }: root mean square and chi-square
selftest-certified-errors = { $name }: errors before and after
selftest-gum = { $name }
selftest-draws-mean = { $name }: mean of the draws
selftest-draws-u = { $name }: standard uncertainty of the draws
selftest-draws-interval = { $name }: interval of { $percent } %
selftest-draws-shortest = { $name }: shortest interval of { $percent } %
selftest-linear-u = { $name }: first-order standard uncertainty
selftest-chi-square-table = quantiles of chi-square
selftest-f-table = quantile of the F distribution
selftest-conformity = probability of conformity
selftest-characteristic = { $name }
selftest-shares = proportion of intervals that contain the true value, { $parameters } parameters, { $draws } campaigns
selftest-mean-chi-square = mean chi-square over degrees of freedom, { $draws } campaigns
selftest-read = { $name } in { $unit }: known text
selftest-written-read = { $name } in { $unit }: written and read
selftest-listed = { $format }: each value next to its name
selftest-file-robot = { $format }: robot that the file describes
selftest-same-bytes = files that differ between 1 and { $threads } threads, of { $files }
selftest-files-written = all files are written
selftest-nist-sets = { $name }: largest deviation in { $count } data sets

## Slips
selftest-wrong-digit = wrong digit: significant digit { $digit } of `{ $place }`
selftest-swapped = swapped: `{ $first }` and `{ $second }`
selftest-wrong-unit = wrong unit: `{ $place }` multiplied by { SCIENTIFIC($factor, 3) }

## Causes
selftest-other-version = etalon { $before } wrote the stored document; this program is etalon { $after }
selftest-other-input = `{ $file }` has changed
selftest-new-input = `{ $file }` is a new input
selftest-missing-input = `{ $file }` is no longer an input
selftest-other-model = the robot model was { $before } and is now { $after }

## Protocol
selftest-title = Validation of the installation
selftest-subtitle = etalon { $version } on { $system } { $architecture }; validation of software before use (ISO/IEC 17025:2017, 7.11.2)
selftest-passed = { $checks } tests of { $requirements } requirements passed; { $slips } of { $slips } seeded faults were detected
selftest-failed = { $failed ->
        [one] { $failed } of { $checks } tests failed
       *[other] { $failed } of { $checks } tests failed
    }
selftest-slips-missed = { $missed ->
        [one] { $missed } of { $slips } seeded faults was not detected
       *[other] { $missed } of { $slips } seeded faults were not detected
    }
selftest-program-changed = the program file does not have the given SHA-256
selftest-program-unreadable = the program file cannot be read
selftest-reference-changed = changed reference data: { $files }
selftest-values-same = campaign { $campaign }: { $compared } parameters agree with the stored document
selftest-values-moved = { $moved ->
        [one] campaign { $campaign }: { $moved } value differs from the stored document
       *[other] campaign { $campaign }: { $moved } values differ from the stored document
    }
selftest-statement = This record applies to the program file with this SHA-256, on this machine.
selftest-overview = Requirements
selftest-failed-tests = Failed tests
selftest-installation = Installation (IQ)
selftest-operation = Operation (OQ)
selftest-slips = Seeded faults that must be detected
selftest-performance = Performance (PQ)
selftest-program-hash = SHA-256 of the program
selftest-stated-hash = given SHA-256
selftest-system = system
selftest-threads-offered = threads available
selftest-packages = packages
selftest-packages-note = Packages of Cargo.lock from which the program, its build scripts and its tests are built.
selftest-nist-absent = reference data of NIST: not present (set `ETALON_REFERENCE` to a folder that contains them)
selftest-nist-present = reference data of NIST: present
selftest-requirement = requirement
selftest-tests = tests
selftest-test = test
selftest-source = source
selftest-expected = expected
selftest-found = obtained
selftest-deviation = deviation
selftest-permissible = maximum deviation
selftest-result = result
selftest-result-pass = pass
selftest-result-fail = fail
selftest-slip = seeded fault
selftest-tests-failed = failed tests
selftest-as-it-must = fails, as expected
selftest-missed = not detected
selftest-reference-data = reference data
selftest-package = package
selftest-version = version
selftest-quantity = quantity
selftest-over-u = difference / u
selftest-tolerance = Maximum deviation: { SCIENTIFIC($of_uncertainty, 0) } standard uncertainties for a value, { SCIENTIFIC($of_uncertainty, 0) } (relative) for an uncertainty, { SCIENTIFIC($relative, 0) } (relative) for a value without uncertainty.
selftest-cause = Known difference: { $cause }.
selftest-cause-unknown = No known difference: version, model and inputs are the same.
