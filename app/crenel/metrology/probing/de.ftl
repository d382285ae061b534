check-objects-certificate-which-sides-front = Kalibrierschein des Objekts prüfen, ebenso die Lage seiner Vorderseite
check-which-face-each-contact-taken = Prüfen, auf welcher Fläche jeder Punkt angetastet wurde, außerdem die Tastkugel und den Kalibrierschein des Objekts
contact-labelled-but-misses-face = Antastpunkt { $number } ist der Fläche „{ $face }“ zugeordnet, verfehlt sie aber um { $distance }
contact-unknown-face = Antastpunkt { $number } liegt auf der unbekannten Fläche „{ $face }“
contacts-do-not-determine-object = { $count } Antastpunkte legen die Lage des Objekts nicht fest
contacts-face-lie-one-line = die { $count } Antastpunkte { $where } liegen auf einer Geraden
contacts-fit-block-rms-only-all = die Antastpunkte passen zum Zinnenkörper nur mit { $rms } rms, { $beside } von { $count } gar nicht
contacts-lie-beside-crests-floors-were = { $off_face } von { $contacts } Antastpunkten liegen neben den angetasteten Zinnenoberseiten oder Nutgründen
contacts-lie-beside-face-they-labelled = { $beside } von { $count } Antastpunkten liegen neben der Fläche, der sie zugeordnet sind ({ $faces })
contacts-were-given-positions = { $count } Antastpunkte mit Positionen der Form { $shape } wurden angegeben
face-can-turn-about-line = die Fläche lässt sich um diese Gerade drehen
least-needed-each-three-non-parallel = auf jeder von drei nicht parallelen Flächen sind mindestens { $least } nötig
lies-face = er liegt { $where }
lies-no-face-all = er liegt auf keiner Fläche
merlons-stand-mirrored-order = die Zinnen liegen in gespiegelter Reihenfolge
more-on-either-face =
    { $pair ->
        [crest] { $count } weitere auf den Zinnenoberseiten oder auf den Nutgründen
        [front] { $count } weitere auf der Vorder- oder Rückseite
       *[left] { $count } weitere auf der linken oder rechten Stirnseite
    }
no-position-block-brings-them-onto = in keiner Lage dieses Zinnenkörpers liegen sie auf ihm
no-single-contact-fault = es liegt nicht an einem einzelnen Antastpunkt
seat-needs-two-points = eine Pfanne braucht zwei Punkte oder mehr
take-out-label-face-touched = Punkt entfernen oder der angetasteten Fläche zuordnen
touch-face-also-beside-line =
    { $face ->
        [crest] Die Zinnenoberseiten auch neben dieser Geraden antasten
        [floor] Die Nutgründe auch neben dieser Geraden antasten
        [front] Die Vorderseite auch neben dieser Geraden antasten
        [back] Die Rückseite auch neben dieser Geraden antasten
        [left] Die linke Stirnseite auch neben dieser Geraden antasten
        [right] Die rechte Stirnseite auch neben dieser Geraden antasten
       *[other] Die Fläche „{ $face }“ auch neben dieser Geraden antasten
    }
touch-more-contacts = Antasten: { $contacts }
