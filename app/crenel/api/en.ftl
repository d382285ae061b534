archive-fetched = { $name } is back from the archive.
archive-fetching = Bringing { $name } back from the archive
calibration-has-no-picture = This calibration has no picture { $name }.
cannot-deleted-now = It cannot be deleted now
cannot-hidden-now = It cannot be hidden now
choose-another-picture = Choose another picture, or save it smaller
chosen-picture = The chosen picture
deleted = { $name } was deleted
give-one-first = Enter an address first
load-page-again = Reload the page.
merging-scans = Merging { $count } scans
no-longer-in-data-folder = { $name } is no longer in the data folder.
pass-over-plate = Pass over the plate
pass-stopped = The pass was stopped
says-hello = Test message from { $name }.
scan-cannot-start-now = A scan cannot start now
scan-flat-plate-nearer-away-again = Scan a flat plate, nearer and away again several times, then determine the delay
scan-needs-name = A scan needs a name
scans-are-merged = { $name }: merged, { $points } points
session-has-no-picture = This session has no picture { $name }.
session-has-no-pose = there is no pose { $number } in this session
shape-label = { $shape ->
    [plane] Plane
    [sphere] Sphere
   *[cylinder] Cylinder
} { $n }
start-again = Start it again
stopped-by = { $name } pressed Stop in another browser: the laser is off.
stopped-by-what-kept =
    { $scan ->
        [yes] The running scan has ended. Its points are saved under Records.
       *[no] No scan was running.
    }
stopped-laser-off = Stopped: the laser is off.
support-bundle-being-made-already = A support bundle is already being made
there-no-address-yet = There is no address yet
there-no-check-arm = There is no check of the arm { $record_id }.
there-no-check-tip = There is no check of the tip { $record_id }.
there-no-identification-arm = There is no identification of the arm { $record_id }.
there-no-scan-find-delay = There is no scan to determine the delay from
there-no-such-page-3d-view = There is no such page of the 3D view.
there-no-verification = There is no verification { $record_id }.
view-3d-does-not-answer = The 3D view does not respond.
wait-stop = Wait, or stop it
write-one = enter one
