artefact-gives-way =
    { $test ->
        [sphere] the sphere rocks in measurement { $place }: its touches scatter by { $scatter }, steady ones by up to { $expected }
        [contact] the bar rocks in placement { $place }, or the diameter of its spheres is mistyped: touches of its spheres scatter by { $scatter }, steady ones by up to { $expected }
       *[lengths] the standard rocks in place { $place }: touches of its spheres scatter by { $scatter }, steady ones by up to { $expected }
    }
performance-beyond-limit = { $title }: { $value }, beyond the limit of { $limit }; test value uncertainty { $uncertainty } (k = 2).
performance-brought-to-20 = Sizes and lengths are brought to 20 °C; the artefact was at { $celsius }.
performance-conditions-not-met = { $title }: { $value }; not decided, because { $problem }.
performance-expansion-unknown = the artefact { $name } was at { $celsius }, more than { $most } from 20 °C, and its certificate has no coefficient of expansion: enter expansion_per_c and its standard uncertainty expansion_sd_per_c in the file of the artefact (if it does not expand: 0, and an uncertainty above 0)
performance-extracted-by = All points within the gate take part. The line was looked for in the pictures of the scans with these settings: { $names }.
performance-limit-unused = The plan has a limit for “{ $title }”, which this test does not measure: it is not used.
performance-limits-broken = A figure breaks its limit.
performance-limits-kept = Every figure that has a limit keeps it.
performance-near-limit = { $title }: { $value }, too close to the limit of { $limit } for a decision; test value uncertainty { $uncertainty } (k = 2).
performance-no-limit-entered = No limit is entered: the values are reported, not judged.
performance-no-value = { $title }: no value, because { $problem }.
performance-not-brought-to-20 = The artefact was at { $celsius }. Its coefficient of expansion is not stated: sizes and lengths are not brought to 20 °C.
performance-not-decided = Not every figure is decided.
performance-scans-set-otherwise = the scan { $scan } was taken with other settings than { $other }: the scans of a test need the same
performance-smoothed =
    All points within the gate take part. They were smoothed along the laser line by { $smoothing } when they were recorded, which makes forms and dispersion smaller.{ $others ->
        [none] { "" }
       *[other] { " " }Further settings: { $others }.
    }
performance-steadiness-unknown = Whether the temperatures were steady is not known: artefact and arm were not both measured at the beginning and at the end.
performance-temperature-changed =
    { $which ->
        [arm] the temperature of the arm changed by { $change } during the test, more than { $most }
       *[other] the temperature of the artefact changed by { $change } during the test, more than { $most }
    }
performance-temperature-far =
    { $which ->
        [arm] the arm was at { $celsius }, more than { $most } from 20 °C
       *[other] the artefact was at { $celsius }, more than { $most } from 20 °C
    }
performance-temperature-not-stated = The artefact's temperature was not stated: sizes and lengths are taken as at 20 °C, and their uncertainty does not contain the temperature.
performance-temperatures-steady = The temperatures of artefact and arm changed by { $change } at most (limit { $most }) and stayed within { $off } of 20 °C.
performance-within-limit = { $title }: { $value }, within the limit of { $limit }; test value uncertainty { $uncertainty } (k = 2).
scans-need-a-calibration = calibration.json is missing: scans cannot be rebuilt
seat-gives-way = seat { $seat } is loose: the tip in it scatters by { $scatter }, in the others by up to { $expected }
sphere-gives-way =
    at position { $position }, the sphere or the tip gives way while it is touched { $part ->
        [pattern] in the 25 places
        [location] in the articulations
       *[end] at the end
    }: the touches scatter by { $scatter }, the points of the scans by { $expected }
