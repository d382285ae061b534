ui-95-percent-within = 95 % within
ui-a-record-not-live = A record, not what is scanned now
ui-a-scan-is-running = A scan is running.
ui-accepted = Accepted
ui-active = active
ui-against-previous-calibration-dashed-uncertainties-both = compared with the previous calibration; dashed: the change that the uncertainties of both explain if the sensor did not move (k = 2)
ui-all-records = All records
ui-back-to-live = Back to live
ui-begun = Started
ui-beyond = above the limit of { $limit }
ui-cannot-displayed-files-missing-data-folder = This record cannot be shown: its files are missing from the data folder, or the station is offline.
ui-changes-between-calibrations-appear-second-one = Changes appear here after the second calibration.
ui-choose-another-scan = Choose another scan to merge or compare them.
ui-choose-none = Choose none
ui-choose-record = Choose { $name }
ui-compare-with = Compare with
ui-compared-points = Compared
ui-comparison = Comparison
ui-comparison-is-scatter-and-change = Each point from the plane through its neighbours on the other scan: the scatter of both scans, and what changed or moved between them. It is no measurement uncertainty.
ui-comparison-of-two-calibrations = The scans have different calibrations, whose errors are in it.
ui-continue-this-scan = Continue this scan
ui-customer = Customer
ui-delete = Delete
ui-delete-recording-points-removed-disk-permanently = Delete { $name }? Its recording and its { $points } points are removed from the disk permanently.
ui-deviation-from = Deviations from { $name }, positive outside.
ui-do-not-continue = Do not continue
ui-duration = Duration
ui-end-comparison = End the comparison
ui-fetch = Fetch
ui-fetch-it-from-the-archive-first = Fetch it from the archive first.
ui-files-of-record = Files
ui-in-use = In use.
ui-laser-rotation = Laser rotation
ui-laser-shift = Laser shift
ui-latest = { $figure }, latest: { $value }
ui-loading-the-calibration = Loading the calibration…
ui-loading-the-record = Loading the record…
ui-mean-deviation = Mean
ui-merge-into-one-cloud = Merge into one cloud
ui-merged-of = Made of
ui-n-of-all-scans = { $n } of { $all }
ui-n-of-all-too-fast = { $n } of { $all } pictures too fast
ui-n-pictures = { $n ->
        [one] { $n } picture
       *[other] { $n } pictures
    }
ui-n-pictures-lost =
    { $n ->
        [one] { $n } picture lost
       *[other] { $n } pictures lost
    }
ui-n-pictures-without-points =
    { $n ->
        [one] { $n } picture without points
       *[other] { $n } pictures without points
    }
ui-n-scans =
    { $n ->
        [one] { $n } scan
       *[other] { $n } scans
    }
ui-n-scans-chosen = { $n } scans chosen
ui-n-scans-merged = { $n } scans merged
ui-name-part = Name the part
ui-new-name-of = New name of { $name }
ui-next-scan-is-added-to = The next scan is added to a record
ui-no-longer-in-use = No longer in use.
ui-no-picture = no picture
ui-no-scan-is-like-that = No scan is like that.
ui-not-measured = not measured
ui-not-on-the-other = Beside the other scan
ui-not-stated = not stated
ui-open-in-the-3d-view = Open in the 3D view
ui-open-to-turn-it = Open it in the 3D view to turn it, play it again or compare it.
ui-order = Order
ui-order-of = order { $order }
ui-part = Part
ui-part-of-next-scans = Part of the next scans
ui-part-of-this-scan = Part of this scan
ui-pause = Pause
ui-planes-flat-to = { $radius } wide, left by { $flatness }
ui-planes-of-comparison = Planes
ui-play = Play
ui-rename = Rename
ui-replay = Replay
ui-rotation-of-the-laser-plane = Rotation of the laser plane
ui-rotation-of-the-measuring-volume = Rotation of the measuring volume
ui-save = Save
ui-saved-clouds-appear-newest-first-start = Saved clouds appear here, newest first. Start a scan on the Scan page.
ui-sensor-rotation = Sensor rotation
ui-sensor-shift = Sensor shift
ui-serial-number-of = no. { $number }
ui-shift-centre-measuring-volume-frame-arms = Shift of the centre of the measuring volume in the frame of the arm's last joint
ui-shift-laser-plane-along-normal = Shift of the laser plane along its normal
ui-show-more-of =
    { $n ->
        [one] Show { $n } more
       *[other] Show more of { $n }
    }
ui-shown-in-the-3d-view = Shown in the 3D view.
ui-standard-uncertainty-dashed-good = Standard uncertainty of a scanned point, k = 1; dashed: limit for good
ui-temperature-at-acceptance = Temperature at acceptance
ui-the-part-is-not-named = The part is not named.
ui-there-is-no-such-record = This record is not there, or could not be loaded.
ui-time-of-the-scan = Time of the scan
ui-times-speed = { $n } ×
ui-uncertainty-scanned-point-k-1 = Uncertainty of a scanned point (k = 1)
ui-within = within the limit of { $limit }
