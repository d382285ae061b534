ui-after = After
ui-after-lowercase = after
ui-arm-checks-max-min-2-worst = Arm checks: (max − min)/2 on the worst axis
ui-arm-identification = Arm identification
ui-arm-identifications = Arm identifications
ui-arm-swings-side-side-while-tip = An arm swings from side to side while its tip stays in a seat
ui-artefact = Artefact
ui-before-and-after = Before and after
ui-before-difference-identified-arm-after-standard = Before: difference from the identified arm. After: standard uncertainty, k = 1. Both rms.
ui-before-lowercase = before
ui-changed-parameters-arm-uncertainty-k-1 = Changed arm parameters, with uncertainty (k = 1)
ui-checks-could-not-loaded-they-reload = The checks could not be loaded. They reload when the station is back.
ui-checks-over-time = Checks over time
ui-choose-the-arm = Choose the arm
ui-coefficient = Coefficient
ui-coordinates-of-a-tracker = Coordinates of a tracker (coordinates.csv)
ui-coordinates-points-taken = Coordinates of a tracker: { $points } points taken
ui-correlated-well-determined-together-less-well = Correlated: well determined in combination, less well individually
ui-cross-validated-places-left-out-fit = { $n ->
        [one] Cross-validated at { $n } place that was left out of the fit: rms, including encoder noise.
       *[other] Cross-validated at { $n } places, each left out of the fit in turn: rms, including encoder noise.
    }
ui-dashed-the-limit = Dashed: the limit, ±{ $value }.
ui-diameter-error = Diameter error
ui-diameter-from-the-certificate = Diameter from the certificate
ui-distance-tips-centre-place = Distance of the tip's centre from its nominal position
ui-every-arm-check-appears-over-time = The results of all arm checks appear here over time: (max − min)/2 of the tip on the worst axis, compared with your limit.
ui-identification-appears-arms-deviation-datasheet-uncertainty = Each identification appears here with its report, the arm's deviation from its datasheet and the uncertainty achieved.
ui-in-space = In space
ui-in-space-largest-2s = In space: largest, 2s
ui-largest-distance-from-mean = largest distance from the mean
ui-largest-distance-of-a-contact-point = Largest distance of a contact point
ui-last-points-order-capture-about-mean = The last { $n } points in order of capture, relative to their mean.
ui-length-from-the-certificate = Length from the certificate
ui-limit-diameter-error-scatter = Limit for the diameter error and the scatter
ui-limit-max-min-2-axis = Limit for (max − min)/2 on each axis
ui-no-check-yet = No check yet
ui-no-limit-set = no limit set
ui-no-tip-check-yet = No tip check yet
ui-not-yet-identified-here = Not yet identified here
ui-parameter = Parameter
ui-parameters = Parameters
ui-places-far-apparent-motion-tip-max = Places so far: apparent motion of the tip, (max − min)/2
ui-points-appear-arm-swings = Points appear here as the arm swings.
ui-points-appear-fifth-contact-point = Points appear here from the fifth contact point on.
ui-scale-from-the-datasheet = scale from the datasheet
ui-seat = Seat
ui-seat-end-ball-bar-tip-stays = In a seat, or at an end of a ball bar, the tip stays in one place while the arm swings. A sphere is touched from every side. Spread the places over the whole reach: near and far, left and right, high and low. Then repeat them with the elbow on the other side. A ball bar also determines the arm's scale.
ui-six-places-determine-the-arms-geometry = Six places determine the arm's geometry
ui-standard-uncertainty-of-the-length = Standard uncertainty of the length
ui-the-tip-along-points = The tip along { $axis }, { $n } points
ui-tip-checks = Tip checks
ui-tip-error-over-the-reach-rms = Tip error over the reach, rms
ui-tip-error-over-the-whole-reach = Tip error over the whole reach
ui-tip-error-over-whole-reach-without = Tip error over the whole reach, without the arm's scale
ui-touch-sphere-known-diameter-nine-places = Touch a sphere of known diameter at nine places with the wrist turned. This shows a worn, bent or wrong tip before it spoils a day's measurements.
ui-unchanged-parameters = Unchanged parameters
