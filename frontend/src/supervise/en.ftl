ui-against-a-gauge = against a gauge
ui-alarm-and-more = { $alarm } (and { $n } more)
ui-alarms = Alarms
ui-ambient = ambient
ui-as-of = As of { $when }
ui-current-activity = Current activity
ui-disk = Disk
ui-due-old = due, { $age } old
ui-for = for { $age }
ui-frames-lost = { $n ->
        [one] { $n } frame lost
       *[other] { $n } frames lost
    }
ui-free = free
ui-hz = { $n } Hz
ui-idle = Idle
ui-job = Job
ui-laser-is-off-lowercase = laser is off
ui-laser-is-on-lowercase = laser is on
ui-laser-is-unknown-lowercase = laser unknown
ui-live-cloud = Live cloud
ui-lost-and-corrupt = { $lost } lost, { $corrupt } corrupt
ui-no-alarms = No alarms
ui-no-data-yet-lowercase = no data yet
ui-not-yet = not yet
ui-passed-lowercase = passed
ui-points-s = points/s
ui-scanning-is-not-possible = scanning is not possible
ui-stamps-by = stamps: { $stamps }
ui-switched-off = switched off
ui-unknown-the-broker-is-offline = unknown, the broker is offline
ui-valid-old = valid, { $age } old
ui-verified = Verified
ui-waiting = waiting
