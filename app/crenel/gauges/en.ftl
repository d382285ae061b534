against-limits = Comparison with the limits
arm-temperature = Temperature of the arm
artefact-missing = the plan names no artefact
artefact-temperature = Temperature of the artefact
bar-without-sphere-diameter = the file of the ball bar states no diameter of its spheres: enter sphere_diameter_mm
begin-again = Start again
cancel-test = Cancel the test
clouds-enough = { $clouds_most } clouds are sufficient.
decision = Decision
figure = Figure
has-touches =
    { $shape ->
        [sphere] The sphere has { $count } contact points
       *[plane] The plane has { $count } contact points
    }
implied-offset = Error of the probe matrix that the centres imply
no-certificate-stated = no certificate stated
no-touch-taken-yet = No contact point has been taken yet.
only-ball-bars-are-scanned = only the spheres of a ball bar are measured by scan, and this standard has none
performance-accept = Finish the test
performance-all-touched = All places of this step are touched. Continue.
performance-another-step =
    { $step ->
        [artefact] This belongs to another step; the test is at 'Artefact and limits'.
        [pattern] This belongs to another step; the test is at '25 touches'.
        [location] This belongs to another step; the test is at 'Location by touch'.
        [scan] This belongs to another step; the test is at 'Five scans'.
        [end] This belongs to another step; the test is at 'Touch again'.
        [lengths] This belongs to another step; the test is at 'Lengths'.
        [plate] This belongs to another step; the test is at 'Two scans'.
        [diameter] This belongs to another step; the test is at 'Master sphere'.
        [seats] This belongs to another step; the test is at 'Three seats'.
        [bar] This belongs to another step; the test is at 'Ball bar'.
        [temperatures] This belongs to another step; the test is at 'Temperatures'.
       *[review] This belongs to another step; the test is at 'Result'.
    }
performance-artefact-is-ready =
    { $test ->
        [lengths] The standard is ready
        [plane] The plate lies still
        [contact] The artefacts are ready
       *[other] The sphere is fixed
    }
performance-aside-note = { $title }: { $reason }
performance-bar-of-contact-test = Only the contact test has a ball bar beside its sphere.
performance-begin-scan = Begin the scan
performance-by-touch-alone = The lengths of this test are measured by touch alone.
performance-cancelled-device = Cancelled: a device failed.
performance-cancelled-moved = Cancelled: the artefact or the arm moved.
performance-cancelled-operating = Cancelled: operating error, repeated.
performance-cancelled-other = Cancelled by the operator.
performance-cancelled-plan = Cancelled: plan, calibration or settings were changed.
performance-cap-not-below-a = The cap B of the limit must not be smaller than A.
performance-change-temperatures = Change the temperatures
performance-choose-artefact =
    { $test ->
        [lengths] Choose a length standard first.
        [plane] Choose a plate first.
        [contact] Choose a sphere or a ball bar first.
       *[other] Choose a sphere first.
    }
performance-confirm-temperatures = Confirm the temperatures
performance-correct-gauge = Correct the file in the folder gauges, or choose another one.
performance-do-artefact-and-limits =
    { $test ->
        [lengths] Choose the length standard. Enter A, K and B from the datasheet if the lengths are to be judged.
        [plane] Choose the plate and lay it within the arm's reach. Enter the limit if its form is to be judged.
        [contact] Choose the master sphere and the ball bar, and fix the sphere in the middle of the arm's reach. What is not at hand is left out. Enter the limits from the datasheet if they are to be judged.
       *[other] Choose the test sphere and fix it within the arm's reach. Enter the limits from the datasheet if they are to be judged.
    }
performance-do-review =
    { $test ->
        [lengths] The errors of all lengths against the permissible error.
        [plane] The form of the plate by scan: the narrowest slab that holds 95 % of all points, in the worse orientation.
        [contact] Effective diameter, single-point articulation and volumetric length.
       *[other] Size, form and location of the sphere by touch, by scan, and both together.
    }
performance-do-temperatures = Measure the temperatures of artefact and arm once more. Those of the beginning are filled in; change what has changed, then confirm.
performance-drop-scan = Discard the scan
performance-dropping-scan = Discarding the scan
performance-end-scan = End the scan
performance-evaluating = Calculating the figures
performance-finish-scan-first = End or discard the running scan first.
performance-go-on = Continue
performance-is-closed = This test is closed. Begin a new one.
performance-is-evaluated = The figures are still being calculated.
performance-last-error = Error of the last length, { $length }
performance-leave-question = Cancel this test? It is kept and listed with the reason.
performance-length-is-confirmed = The last length is confirmed by the first touch of the next one or by the first scan; its touches stand.
performance-let-temperatures-settle =
    { $when ->
        [end] No figure will be decided. Repeat the test once the temperatures are steady.
       *[begin] No figure will be decided. Let artefact and arm settle, and measure again.
    }
performance-no-artefact =
    { $test ->
        [lengths] There is no length standard in the folder gauges yet.
        [plane] There is no plate in the folder gauges yet.
        [contact] There is neither a sphere nor a ball bar in the folder gauges yet.
       *[other] There is no sphere in the folder gauges yet.
    }
performance-no-scan-runs = No scan is running.
performance-no-way-back = What was measured stands: the test does not go back after its first touch or scan.
performance-only-lengths-have-choice = Only the test of lengths can be done by touch alone or by scan, too.
performance-other-calibration = The calibration in use has changed since the test began.
performance-plan-changed = The plan of this test was changed after its first touch or scan.
performance-plan-is-frozen = Artefact and limits are fixed since the first touch or scan.
performance-put-back = Put the touch back
performance-repeat = Repeat the test
performance-repeat-question = Repeat the test? This run is kept and listed as repeated.
performance-run-dropped = Discarded by the operator while it was scanned.
performance-run-repeated = Repeated by the operator.
performance-scan-bar-first = Scan the bar in this place first.
performance-scanned-length = { $length } (error { $error })
performance-set-is-invalid = What was measured belongs to the old state and is invalid as a test. Begin again; the data are kept.
performance-settings-changed = The settings for scans were changed after the first touch or scan of this test.
performance-simulation-touches =
    { $test ->
        [lengths] The simulated operator touches the length standard: { $done } of { $of }
       *[other] The simulated operator touches the sphere: { $done } of { $of }
    }
performance-standard-lengths =
    { $kind ->
        [step-gauge] Step gauge
       *[other] Bar
    }, { $count ->
        [one] one length, { $longest }
       *[other] { $count } lengths, { $shortest } to { $longest }
    }
performance-status-no-conformity-claimed = Procedure after ISO 10360-12:2016, ISO 10360-8:2013 and ASME B89.4.22-2004 as described in Crenel’s manual; no conformity with these standards is claimed.
performance-step-artefact = Artefact and limits
performance-step-temperatures = Temperatures
performance-test =
    { $kind ->
        [lengths] Performance test: lengths
        [plane] Performance test: plane
        [contact] Performance test: contact tests
       *[sphere] Performance test: one sphere
    }
performance-touch-taken =
    { $test ->
        [lengths] Touch { $count } of the lengths
        [contact] Touch { $count } of this step
       *[other] Touch { $count } on the sphere
    }
performance-touches-taken-back =
    { $count ->
        [one] One touch was taken back by the operator.
       *[other] { $count } touches were taken back by the operator.
    }
performance-valid-until = certificate valid until { $until }
plan-without-artefact =
    { $which ->
        [master] the plan names no master sphere
        [sphere] the plan names no sphere
        [lengths] the plan names no length standard
        [plane] the plan names no plate
       *[bar] the plan names no ball bar
    }
plate-by-certificate = flat to { $flatness }
put-certificate-into-folder-gauges = Add the datasheet of a gauge, or the digital certificate (DCC) of a sphere, under Datasheets.
reasons = Reasons
record-no-longer-in-data-folder = The record is no longer in the data folder.
sessions-gauge-arm-cannot-read-any = The session's gauge or arm can no longer be read
sphere-of-diameter = sphere, { $diameter }
take-touch = Take the point
there-no-calibration-use-calibrate-first = There is no calibration in use. Calibrate first.
there-no-limit = { $title }: { $value }; there is no limit.
there-no-such-gauge = There is no such gauge.
titled-text = { $title }: { $text }
touches = { $done } of { $of } contact points
undo = Undo
