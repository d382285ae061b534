approved = Freigegeben
attention = Achtung
bad = Schlecht
ball-diameter = Ø { $diameter }
board-bar = Diese Linie ist { $length } lang; sonst hat der Drucker die Seite skaliert: mit 100 % drucken.
board-does-not-fit-a0 = ein Muster von { $width } × { $height } passt nicht auf A0
board-does-not-fit-page = ein Muster von { $width } × { $height } mit Prüfstrecke und Rändern passt nicht auf { $page }
board-fewer-or-smaller-squares = Weniger oder kleinere Felder wählen.
board-larger-page-or-fewer-squares = Ein größeres Papierformat oder weniger oder kleinere Felder wählen.
board-nominal-size = Das Muster ist { $width } breit und { $height } hoch. Beides am Ausdruck messen: die zwei Längen skalieren das Brett.
board-print-and-glue = Auf { $page } mit 100 % drucken, auf mattes Papier, und auf eine ebene Platte kleben.
crenel = Crenel { $version }
date = Datum
every-file-has-content-result-made = Jede Datei hat noch den Inhalt, aus dem das Ergebnis berechnet wurde.
figures-against-their-limits = Kenngrößen und ihre Grenzwerte
file-column = Datei
good = Gut
inputs = Eingangsdaten
logo-cannot-be-used = das ist kein PNG oder JPEG von höchstens { $largest }
made-simulated-hardware-demonstration = Mit simulierten Geräten erstellt: Demonstration.
no-page-of-this-name = { $name } ist kein Papierformat
not-stated = nicht angegeben
note = Hinweis
now = Jetzt
of = { $page } von { $pages }
put-another-logo = Ein anderes Bild dorthin legen oder es entfernen
report-made-crenel-files-session-alone = Bericht von Crenel { $version }, ausschließlich aus den Dateien der Sitzung erstellt.
result-cannot-traced-them = Das Ergebnis lässt sich nicht auf sie zurückführen.
role-and-name = { $role }: { $name }
signatures = Unterschriften
take-one = Eine davon wählen: { $languages }
the-result = das Ergebnis
there-no-language = die Sprache „{ $language }“ gibt es nicht
these-files-what-result-made-accepted =
    { $changed ->
        [one] { $changed } dieser Dateien ist nicht mehr die, aus der das Ergebnis berechnet und mit der es angenommen wurde.
       *[other] { $changed } dieser Dateien sind nicht mehr die, aus denen das Ergebnis berechnet und mit denen es angenommen wurde.
    }
word-changed = geändert
word-missing = fehlt
word-none = keine
word-unchanged = unverändert
