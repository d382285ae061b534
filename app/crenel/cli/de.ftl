account-not-there = Es gibt kein Konto { $name }
accounts-are = Konten: { $names }
accounts-none = Konten: noch keines
batch-none-named = Weder Archiv noch Datenordner ist angegeben, und hier gibt es keine station.toml
lines-along-other-axis =
    { $pictures ->
        [one] in einem Bild findet --axis { $better } { $other } Punkte und --axis { $axis } { $found }
       *[other] in { $pictures } Bildern findet --axis { $better } { $other } Punkte und --axis { $axis } { $found }
    }: die Linie verläuft in der anderen Richtung. --axis { $better } angeben
