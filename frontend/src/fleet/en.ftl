ui-fleet = Fleet
ui-fleet-affected = { $n ->
    [one] One recording is affected.
   *[other] { $n } recordings are affected.
}
ui-fleet-against = Against
ui-fleet-ageing = Ageing
ui-fleet-all-calibrations = All calibrations of each sensor; the newest is blue and large. The bar is the median ± one standard deviation.
ui-fleet-archived = Archived
ui-fleet-back = Back to the list
ui-fleet-broker-away = The broker cannot be reached: what the stations do now is unknown.
ui-fleet-calibration-choice = { $mark ->
    [used] { $name }, { $at }: in use then
    [newest] { $name }, { $at }: the newest
    [both] { $name }, { $at }: in use then, and the newest
   *[none] { $name }, { $at }
}
ui-fleet-calibration-doubt = { $doubt ->
    [wrong] Wrong by the drift of the tests: { $quantity } differs by { $size } with this calibration.
   *[perhaps] Perhaps wrong by the drift of the tests: { $quantity } differs by { $size } with this calibration, far from the others, but not surely further than they spread.
}
ui-fleet-calibration-doubted = { $doubt ->
    [wrong] { $choice } – wrong
   *[perhaps] { $choice } – perhaps wrong
}
ui-fleet-calibration-of-its-day = Of the day of the scan
ui-fleet-calibration-of-sensor = Calibration, sensor { $sensor }
ui-fleet-calibrations = Calibrations
ui-fleet-changed = Changed by { $size } ± { $uncertainty } { $unit } (k = 2) between { $earliest } and { $latest } (95 %).
ui-fleet-changes-by = { $since ->
        [calibration] Changes by { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values with { $groups } calibrations.
       *[first] Changes by { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values of { $groups } devices.
    }
ui-fleet-cloud = Elsewhere, on a computer that reaches these records, this command makes its cloud:
ui-fleet-cloud-failed = The cloud with { $calibration } is not made. { $why }
ui-fleet-cloud-format = Format
ui-fleet-cloud-is-being-made = The cloud with { $calibration } is being made
ui-fleet-cloud-is-made = It is made already
ui-fleet-cloud-waits = The cloud with { $calibration } waits for those before it
ui-fleet-clouds = Clouds
ui-fleet-collected = Collected
ui-fleet-count = Number
ui-fleet-days-reversed = From is after Until, so that no record can be found: choose an earlier From or a later Until.
ui-fleet-differed = Differs by { $size } ± { $uncertainty } { $unit } (k = 2) from the first value on, { $since }.
ui-fleet-doubtful = Perhaps wrong: { $calibration }, by { $size }, tested from { $since } to { $until }. It is far from the other calibrations, but not surely further than they spread.
ui-fleet-download = Download
ui-fleet-drift = Drift
ui-fleet-ended = Back to the right level by { $when }.
ui-fleet-expanded = U (k = 2)
ui-fleet-explained = Only the tests of this period used: { $calibrations }. The recordings with these are affected.
ui-fleet-file = File
ui-fleet-from = Collected from
ui-fleet-hours = Hours
ui-fleet-hours-since-calibration = Hours since the calibration in use
ui-fleet-hours-since-first = Hours since the first value of the device
ui-fleet-kind = Kind
ui-fleet-kind-performance = Performance test
ui-fleet-kind-scan = Scan
ui-fleet-label = Name
ui-fleet-lasts = It lasts.
ui-fleet-least-values = A period in which a figure differs is found if it has { $n } tests or more.
ui-fleet-left-out = Left out, because their calibration is not in the catalogue: { $n }
ui-fleet-level = { $n ->
    [one] { $value } from { $since } (one value)
   *[other] { $value } from { $since } ({ $n } values)
}
ui-fleet-make-cloud = Make cloud
ui-fleet-median = Median
ui-fleet-newest = Newest record
ui-fleet-newest-calibrations = Newest calibrations
ui-fleet-newest-value = Newest
ui-fleet-no-answer = The fleet's server does not answer, or its database cannot be used now. The stations go on, and nothing is lost.
ui-fleet-no-change-shown = { $since ->
        [calibration] No change is shown: { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values with { $groups } calibrations.
       *[first] No change is shown: { $slope } ± { $uncertainty } { $unit } (95 %), by { $n } values of { $groups } devices.
    }
ui-fleet-no-slope = Too few values for a trend.
ui-fleet-not-collected = On the broker, but not in fleet.toml: nothing is collected.
ui-fleet-not-on-broker = Not heard on the broker
ui-fleet-nothing-found = No record is found.
ui-fleet-object = Artefact
ui-fleet-only-on-station = Only on the station
ui-fleet-own-errors = The own errors of { $n } calibrations have a standard deviation of { $deviation }; changes that these explain do not count.
ui-fleet-own-errors-unknown = { $n ->
    [one] One calibration does not tell how far calibrations differ: a change may be an ordinary error of a calibration.
   *[other] { $n } calibrations with so few tests do not tell how far calibrations differ: a change may be an ordinary error of a calibration.
}
ui-fleet-place = Catalogue: { $place }
ui-fleet-possible = { $n ->
    [one] One more is perhaps affected.
   *[other] { $n } more are perhaps affected.
}
ui-fleet-quantity = Quantity
ui-fleet-records = Records
ui-fleet-right = { $because ->
    [most] Taken as right: { $value }, since { $since }, because { $n } of { $total } values have it. The values alone do not tell which level is right.
    [chosen] Taken as right, as chosen: { $value }, since { $since }; { $n } of { $total } values have it.
   *[first] Taken as right: { $value }, since { $since }, because it is the first level; { $n } of { $total } values have it. The values alone do not tell which level is right.
}
ui-fleet-right-level = Level taken as right
ui-fleet-right-proposed = As proposed
ui-fleet-session = Other session
ui-fleet-since = From
ui-fleet-size = Size
ui-fleet-software = Software
ui-fleet-spread = Spread of all calibrations
ui-fleet-standard-deviation = Standard deviation
ui-fleet-standing-out = { $n ->
    [one] One value stands out. Fewer than { $least } together are too few for a period.
   *[other] { $n } values stand out. Fewer than { $least } together are too few for a period.
}
ui-fleet-symbol = Symbol
ui-fleet-temperature-since-calibration = Above the temperature of the calibration in use
ui-fleet-temperature-since-first = Temperature
ui-fleet-then = Then { $value } from { $since }.
ui-fleet-times = Times: { $zone }
ui-fleet-until = Until
ui-fleet-verdict = Result
ui-fleet-with-the-password = With the password of this page
ui-fleet-words = Part, operator, id, serial number
ui-fleet-would-be-affected = { $n ->
    [0] No recording was made with it.
    [one] If it is wrong, one recording is affected.
   *[other] If it is wrong, { $n } recordings are affected.
}
