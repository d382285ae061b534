element-calibration-not-there = The calibration of this scan is not on this station.
element-cloud-of-other-calibration = The cloud was not made with the calibration of its scan.
element-frames-without-readings = Readings of the arm are missing beside the cloud.
element-has-few-points = too few points lie on it
element-no-shape-stands-out = no such shape stands out of the points
element-pick-more-of-it = draw the rectangle closer around it, or scan more of it
element-points-of-several-calibrations = The points are of several calibrations: what their errors have in common is not known.
element-scan-without-readings = This scan has no readings of the arm beside its cloud. To have them, rebuild cloud.ply with crenel reconstruct.
