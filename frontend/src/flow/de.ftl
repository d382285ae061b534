ui-brighter = Heller
ui-darker = Dunkler
ui-distance-from-its-face-outward = Abstand von der Fläche, + nach außen.
ui-distance-known-once-board-touched-more = Der Abstand ist bekannt, sobald die Tafel an weiteren Stellen angetastet ist.
ui-distance-known-once-three-adjacent-faces = Der Abstand ist bekannt, sobald drei aneinandergrenzende Flächen angetastet sind.
ui-inner-corners-squares-of = { $columns } × { $rows } innere Ecken, Felder von { $square }
ui-line-found-in-all-poses = Mit diesen Einstellungen zeigt jedes Bild die Linie.
ui-line-missing-in-poses = Keine Laserlinie gefunden in Pose: { $poses }. Bild ansehen und angeben, wie die Linie aussieht:
ui-line-settings-stay-with-session = Sie gelten für alle Bilder dieser Sitzung, und mit ihnen die Zonen der Einstellungsseite.
ui-lines-point-outward-or-inward = Striche zeigen nach außen oder innen
ui-made-on-the-devices-page = Das Datenblatt der Kamera entsteht auf der Seite Geräte.
ui-merlons = { $n ->
        [one] { $n } Zinne
       *[other] { $n } Zinnen
    }
ui-not-needed = nicht nötig
ui-nothing-to-choose = Es gibt noch kein Datenblatt.
ui-outlier-does-not-fit-face-not = Ausreißer: Der Punkt passt nicht zu seiner Fläche und wird nicht verwendet.
ui-point = Punkt { $n }
ui-points-appear-drawing-once-pictures-evaluated = Punkte erscheinen in der Zeichnung, sobald die Bilder ausgewertet sind.
ui-points-appear-drawing-once-three-adjacent = Punkte erscheinen in der Zeichnung, sobald drei aneinandergrenzende Flächen angetastet sind.
ui-points-on-this-face = Punkte auf dieser Fläche
ui-remove-this-point = Diesen Punkt entfernen
ui-residual-lowercase = Residuum: Blau innen, Orange außen
ui-scan-with-it = Damit scannen
ui-selected-object = Gewähltes Objekt
ui-the-object = Das Objekt
ui-touch-rings-continue-chessboard-need-not = An den Ringen antasten oder fortfahren: Ein Schachbrett muss nicht angetastet werden.
ui-touch-rings-point-appears-residual = An den Ringen antasten. Jeder Punkt erscheint hier mit seinem Residuum.
