fleet-give-own-place = Give each station its own archive and data folder
fleet-give-place = Give archive = {"{"} url = "…" {"}"} or data = "…"
fleet-name-page-password = Name a file that contains only the password of the page
fleet-name-password-file = Name a file that contains only the password of the database
fleet-no-marker = it lacks crenel-archive.txt, which the station writes there with its first record
fleet-password-empty = { $file } is empty
fleet-station-has-no-place = { $file }, [stations.{ $station }]: there is neither an archive nor a data folder
fleet-stations-share-place = { $file }: the stations { $other } and { $station } have the same place, { $place }
fleet-write-settings = Write one as docs/fleet.md shows, or name another with --config
