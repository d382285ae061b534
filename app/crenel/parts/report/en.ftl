part-at-least = at least { $lower }
part-at-most = at most { $upper }
part-between = { $lower } to { $upper }
part-budget = Where the uncertainty comes from
part-budget-squares-add-up = Standard uncertainties (k = 1); their squares add up to that of the dimension.
part-decision = Decision
part-deviation = Deviation
part-dimension = Dimension
part-dimensions = Dimensions
part-drawing = Drawing
part-feature = Feature
part-features = Features
part-frame = Frame of the part
part-frame-from = It follows from { $datums }.
part-frame-known = It is known to { $datums } at the datums, and to { $corner } at the far corner of the part (k = 2).
part-frames = Frames
part-inspection = Inspection of a part
part-kind =
    { $kind ->
        [plane] plane
        [circle] circle
        [cylinder] cylinder
        [cone] cone
        [sphere] sphere
        [torus] torus
        [slot] slot
        [line] line
       *[other] { $kind }
    }
part-kind-of-feature = Kind
part-left-out-by-rule = { $count } { $rule }
part-left-out-of-feature =
    { $feature } by { $means ->
        [touch] tip
       *[scan] stripe
    }: left out { $parts }.
part-limit-mark = limit
part-limits = Limits
part-means =
    { $means ->
        [touch] tip
       *[scan] stripe
    }
part-measured = What was measured
part-measured-by = By
part-measured-value = Measured
part-name = Part
part-nominal = Nominal
part-nothing-left-out = No point was left out.
part-points = Points
part-program = Program
part-range-of-cells = Range of cells
part-rule-edge = at edges
part-rule-incidence = seen too flat
part-rule-other-feature = on another feature
part-rule-outlier = outliers
part-rule-wrong-side = on the wrong side
part-scatter-is-no-uncertainty = Only the scatter of the points is known. It is no uncertainty, and nothing was decided by it.
part-scatter-k-2 = Scatter, k = 2
part-serial-number = Serial number
part-source-arm = Arm
part-source-calibration = Calibration
part-source-encoders = Encoders
part-source-form = Form
part-source-stripe = Stripe
part-source-temperature = Temperature
part-source-tip = Tip
part-source-touches = Touches
part-uncertainty-is-of-all-errors = U is the expanded uncertainty (k = 2) by all errors of sensor, arm, tip, readings, points and form together, with what they have in common. Limits are deviations from the nominal.
part-used = Used
part-values-in-their-bands = Each dimension from the middle of its limits, or from its nominal where it has only one; the bar is U (k = 2).
part-verdict =
    { $count ->
        [one] One dimension was measured
       *[other] { $count } dimensions were measured
    }: { $passed } passed, { $failed } failed, { $undecided } undecided.
part-warnings = Warnings
