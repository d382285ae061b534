inspection-result-missing = This inspection has no result any more: its folder is not in the data folder
part-add-datum-or-lock = add a datum, or lock { $name }
part-alignment-leaves-free =
    the alignment leaves the part free to { $kind ->
        [turn] turn about
       *[shift] move along
    } { $axis }
part-arm-errors-unknown = Neither calibration.json nor arm.json states how well the arm's links are known: only scatter is stated, and nothing is decided.
part-best-fit-without-features = a best fit needs features
part-box-corners-must-ascend = the second corner of a box must be beyond the first one along each axis
part-calibration-without-covariance = calibration.json has no covariance: only scatter is stated, and nothing is decided.
part-choose-language = choose one of { $languages }
part-coordinate-without-axis = a coordinate needs an axis: x, y or z
part-correlation-unknown = calibration.json has no errors of links: those of the arm are taken as independent of the sensor's; their correlation is unknown.
part-datum-is-skipped = the datum { $feature } must not be skipped
part-datum-without-direction = { $place }: the datum { $datum } has no direction
part-datums-do-not-fix-it = the datums do not fix it
part-datums-without-primary = datums need a primary one
part-dimension-features =
    the dimension { $kind } is of { $count ->
        [one] one feature
       *[other] { $count } features
    }
part-dimension-of-one-feature-twice = the two features must differ
part-direction-without-length = a direction must not be zero
part-encoder-noise-unknown = The noise of encoders is unknown: arm.json states 0, and no calibration estimated it. Only scatter is stated, and nothing is decided.
part-end-name-with = end the name with one of { $endings }
part-expansion-not-stated = the program does not state how the part expands
part-feature-has-points =
    feature { $feature }: { $count ->
        [0] no point
        [one] one point
       *[other] { $count } points
    } of the scan on it
part-feature-not-determined =
    feature { $feature }: { $count ->
        [one] one point does
       *[other] { $count } points do
    } not determine it
part-feature-seen-flat = Feature { $feature } was seen at more than 70° from its normal nearly everywhere; its points are taken all the same.
part-feature-skipped = Feature { $feature } was skipped: { $reason }
part-feature-unknown = { $place }: there is no feature { $feature }; the features are { $names }
part-features-by-scan = features are to be measured by scan
part-features-by-touch = features are to be measured by touch
part-folder-has = name a folder with { $program }, calibration.json, arm.json, scans and touches.csv
part-form-limit-below-noise = { $dimension }: a limit of { $limit } cannot be decided by this sensor, whose noise alone shows { $noise }.
part-give-temperature = give its temperature in °C
part-id-twice = { $place }: the id { $id } occurs twice
part-language-unknown = there is no language { $language }
part-length-is-range = length_mm of a { $kind } is a range: [from, to] along its direction
part-lower-above-upper = lower ({ $lower }) must not be above upper ({ $upper })
part-means-disagree = Feature { $feature }: stripe and tip differ by { $off } in diameter or width, with a standard uncertainty of { $u }.
part-measure-more-of-feature = measure more of it
part-moved-while-measured =
    The part moved { $between ->
        [scans] between two recordings
        [touches] between touches and scan
       *[passes] during the scan
    }: feature { $feature } was found { $off } apart, with a standard uncertainty of { $u }. Nothing is decided.
part-no-folder = { $folder }: there is no such folder
part-no-scans = { $program }: there is no scan
part-no-such-size = { $place }: a { $feature } has no { $kind }
part-no-touches = { $program }: there are no touches
part-nominal-lacks = the nominal of a { $kind } lacks { $names }
part-not-found = the part was not found: what was measured lies { $off } off its nominal features
part-not-found-remedy = check program, touches and scan, or touch three datums
part-not-found-why = it is another part, or too little of it was measured
part-orientation-needs-datum = { $kind } needs one datum in datums
part-place = { $x }, { $y }, { $z }
part-plane-without-region = { $place }: the plane { $feature } needs a region, over which the zone is taken
part-points-on-too-small-piece = they lie on too small a piece of it
part-position-needs-upper = a position needs an upper limit
part-put-scans = put recordings into { $folder }, or give --scan
part-put-touches = put them into { $file }, or give --touches
part-range-must-ascend = a range must ascend
part-reference-is-no-plane = { $place }: the reference must be a plane
part-result-form-unknown = { $path }: results are not written in this form
part-robot-noise-unknown = How well a robot knows its poses is not stated: only scatter is stated, and nothing is decided.
part-scan-does-not-show-it = the scan does not show it where the program has it
part-scan-feature-or-check-alignment = scan it, or check its nominal and the alignment
part-slot-direction-along-normal = direction and normal of a slot must differ
part-slot-length-is-one-number = length_mm of a slot is one number: its overall length
part-slot-shorter-than-wide = a slot must be longer than wide
part-spread-touches = spread the touches over the feature
part-state-expansion = state part.expansion_per_c, or leave out --temperature
part-temperature-compensated = Lengths are those at 20 °C: the part had { $temperature }, which made it { $factor } longer.
part-temperature-impossible = the part cannot have { $temperature }
part-temperature-not-compensated = Temperature is not compensated: lengths are those at the temperature of the part.
part-tertiary-without-secondary = a tertiary datum needs a secondary one
part-too-few-touches =
    { $file }: feature { $feature } has { $count ->
        [0] no touch
        [one] one touch
       *[other] { $count } touches
    } where { $least } are needed
part-touch-far-off = { $place }: the touch is { $away } off feature { $feature }; it is left out.
part-touch-it-more = touch it at { $least } places at least
part-touch-on-other = { $place }: the touch is { $away } off feature { $feature } and lies on { $other }; it is left out.
part-touch-on-wrong-side = { $place }: the touch is on the wrong side of feature { $feature }; it is left out.
part-touches-at-one-place = feature { $feature }: its { $count } touches are at one place
part-touches-extent = they lie within { $extent }
part-unit-of-other-kind = { $unit } is no unit of { $kind }
