account-not-there = There is no account { $name }
accounts-are = accounts: { $names }
accounts-none = accounts: none yet
batch-none-named = No archive and no data folder is named, and there is no station.toml here
lines-along-other-axis =
    { $pictures ->
        [one] in one picture, --axis { $better } finds { $other } points and --axis { $axis } { $found }
       *[other] in { $pictures } pictures, --axis { $better } finds { $other } points and --axis { $axis } { $found }
    }: the line runs along the other axis. Give --axis { $better }
