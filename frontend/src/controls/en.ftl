ui-arm-sensor-detected-automatically-missing-device = Arm and sensor are detected automatically. If one is missing, the reason is shown. It reconnects automatically.
ui-arms-main-button-continues-long-press = The arm's main button continues; a long press on undo goes back one step.
ui-arms-main-button-starts-ends-cloud = The arm's main button starts and ends a cloud. Undo excludes the last one; a long press on undo goes back one step.
ui-arms-main-button-takes-contact-point = The arm's main button takes a contact point. Undo removes it; a long press on undo goes back one step.
ui-arms-main-button-takes-long-press = The arm's main button takes the picture; a long press on undo goes back one step.
ui-arms-main-button-takes-point-undo = The arm's main button takes a point. Undo removes it; a long press on undo goes back one step.
ui-arms-main-button-triggers-large-button = The arm's main button does the same as the large button here.
ui-attention = Attention
ui-check-where-largest-residuals-pose-excluded = Check where the residuals are largest. You can exclude a pose and include it again.
ui-clamp-must-not-move-between-first = Clamp the gauge. It must not move between the first contact point and the last cloud.
ui-clamp-object-cannot-move-until-last = Clamp the object so that it cannot move until the last picture is taken.
ui-copied-in-mm-and-m = Copied in mm and µm
ui-copy-as-csv = Copy as CSV
ui-days = { $n ->
        [one] { $n } day
       *[other] { $n } days
    }
ui-days-ago = { $n ->
        [one] { $n } day ago
       *[other] { $n } days ago
    }
ui-findings = Findings
ui-help = Help
ui-hold-sensor-object-fills-picture-laser = Hold the sensor so that the object fills the picture and the laser line crosses it.
ui-hold-still-place-arms-main-button = Hold still at each place. The arm's main button takes the point.
ui-hours = { $n ->
        [one] { $n } hour
       *[other] { $n } hours
    }
ui-hours-ago = { $n ->
        [one] { $n } hour ago
       *[other] { $n } hours ago
    }
ui-k-1-about-two-three-points = k = 1: about two of three points lie within this uncertainty. k = 2: about nineteen of twenty.
ui-keep-elbow-and-wrist-as-they-are = Keep elbow and wrist of the arm as they are from the points to the pictures: errors of its links then cancel
ui-leave-tip-seat-turn-every-joint = Leave the tip in the seat and turn every joint slowly through its full range. Points are taken automatically.
ui-move-slowly-evenly-green-range-distance = Move slowly and evenly. Stay in the green range of the distance indicator.
ui-no-continue = No, continue
ui-nothing-takes-effect-before-you-accept = Nothing takes effect until you accept it.
ui-part-help-frame = Three faces that are not parallel fix the part. What the frame is known to appears as soon as they are touched.
ui-part-help-next = After the advised touches the next press belongs to the next feature. “Next feature” goes on with fewer; a chip takes any feature in hand.
ui-part-help-review = The inspection folder has everything: crenel inspect gives the same result by it.
ui-part-help-touch = The arm’s main button takes a touch, the undo button takes the last one back; held, it goes a step back.
ui-part-help-u = U is the expanded uncertainty, k = 2. Undecided: the limit is too near for it.
ui-pass-over-place-again-fill-gaps = Pass over a place again to fill gaps. Scanned data is recorded at once and is never lost.
ui-pass-value-within-by-guard-band = Pass: the value is within its limit by more than the guard band. Fail: the value exceeds the limit by more than the guard band. In between, the decision rule below the figures says what holds.
ui-performance-help-end = If sphere or arm have moved by more than the uncertainty allows, no figure is stated.
ui-performance-help-length = The first touch of the next length confirms the one before. Afterwards it stands.
ui-performance-help-limits = Enter the maximum permissible errors (MPE) that the maker of arm or scanner states.
ui-performance-help-location = Within an articulation the stylus keeps its direction; between them, turn wrist and elbow as far as they go.
ui-performance-help-patches = A patch is covered by 20 points from two pictures. Several passes may be made in one scan.
ui-performance-help-places = A touch counts for the nearest free place within 12°; any other is refused.
ui-performance-help-review = All points within the fixed gate count; none is removed for its deviation.
ui-performance-help-scan = The arm's main button begins and ends a scan.
ui-performance-help-sphere = The sphere's file in the folder gauges states diameter, form and their uncertainties by its certificate.
ui-performance-help-temperatures = A change during the test adds to the uncertainty of sizes and lengths. If it is too large, no figure is decided.
ui-performance-help-touch = The arm's main button takes a touch, the undo button takes the last one back.
ui-picture-taken-only-while-arm-still = The picture is taken only while the arm is still. Take your time.
ui-poses-another-tilt-rotation-improve-result = Poses with a different tilt or rotation improve the result. The station suggests the most useful one.
ui-report = Report
ui-seat-cone-three-balls-which-tip = A seat is a cone or three balls in which the tip sits and turns without play.
ui-select-datasheets-clamped-mounted-result-only = Select the datasheets of the arm, tip, object and sensor that are in place. The result is only as accurate as these datasheets.
ui-sensor-selected = Sensor
ui-show-pose = Show pose { $n }
ui-spread-points-over-face-away-edges = Spread the points over each face, away from its edges. Tap a point in the drawing to see or remove it.
ui-stay-green-range-distance-indicator-if = Stay in the green range of the distance indicator. If Too fast appears, slow down: the line is blurred.
ui-the-arms-main-button-begins = The arm's main button begins.
ui-the-arms-main-button-ends-it = The arm's main button ends it.
ui-this-browser-does-not-allow-copying = This browser does not allow copying
ui-time-ago = { $time } ago
ui-use-gauge-certificate-size-form-uncertainty = Use a gauge with a certificate: its size, form and uncertainty enter the decision.
ui-without-contact-points-only-form-size = Without contact points, only form, size and scatter are assessed, not the position.
ui-wrong-tip-object-appears-residuals-later = If the tip or the object is wrong, the residuals show it later and the station reports it.
ui-you-reload-page-switch-another-tablet = You can reload the page or switch to another tablet at any time; nothing is lost.
