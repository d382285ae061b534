performance-measuring-plate-scan = Evaluating the scan of the plate in orientation { $number }
performance-orientation =
    { $number ->
        [1] Stripe at 45°
       *[other] Stripe turned by 90°
    }
performance-orientation-missing = The plate is not scanned in both orientations yet.
performance-pass-over-plate = Move the stripe slowly over the plate in strips side by side that overlap, then end the scan.
performance-plane-gate =
    { $count ->
        [one] Points take part that lie over the plate, at least { $rim } within its outline and within { $shell } of its plane; one point of the scans does not. None is removed by its residual.
       *[other] Points take part that lie over the plate, at least { $rim } within its outline and within { $shell } of its plane; { $count } points of the scans do not. None is removed by its residual.
    }
performance-plane-is-addition = The form of a plane is an addition: the standard’s test is for area sensors.
performance-plate-form = form { $form }
performance-plate-run = Plate, orientation { $number }
performance-plate-scan-done = The plate is scanned in orientation { $number }.
performance-plate-scan-name = Performance test, plate, orientation { $number }
performance-plate-scanned = The plate is scanned in both orientations.
performance-plate-scans-done = { $done } of { $of } orientations
performance-plate-width = { $width } wide
performance-scan-plate =
    { $number ->
        [1] Turn the sensor so that the stripe lies at about 45° to the edges of the plate or to the axes of the arm. Begin the scan. From here on, plate and limit are fixed.
       *[other] Turn the sensor about its line of sight, so that the stripe lies across its direction in the first scan. Begin the scan.
    }
performance-scan-plate-again = Scan this orientation again
performance-simulation-scans-plate = The simulated operator scans the plate in orientation { $number }
performance-step-plate = Two scans
performance-turn-sensor = Turn the sensor about its line of sight and scan this orientation again
plate-not-in-enough-orientations = the plate was not scanned in { $count } orientations
plate-orientations-alike = the sensor was turned by only { $turn } between the two orientations; { $least } are needed
plate-scan-too-few-points = the scan has only { $count } points; { $least } are needed
plate-scan-too-narrow = the scan shows a strip of the plate only { $width } wide; { $least } are needed
plate-was-not-scanned = the plate was not scanned
scan-plate-in-strips = Scan the plate again, in strips side by side
