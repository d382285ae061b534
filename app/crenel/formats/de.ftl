authority-holds-none = die Datei enthält keine Zertifikate
bits-expected = erwartet werden 8 oder 16 Bit
bits-per-pixel = { $bits } Bit je Pixel
byte-is-not-utf-8 = Byte { $byte } ist kein gültiger UTF-8-Text
change-permissions-place = Zugriffsrechte oder Speicherort ändern
change-place = Speicherort ändern
check-path = Pfad prüfen
checksum-wrong-at-byte = { $name }: Die Prüfsumme bei Byte { $byte } ist falsch
choose-another = Einen anderen wählen
choose-another-place = Einen anderen Speicherort wählen
choose-shorter-one = Einen kürzeren Namen wählen
column-cell-is = { $place }: Spalte { $column } ist { $value }
column-empty = { $place }: Spalte { $column } ist leer
column-stands-there-twice = { $path }: Spalte { $names } kommt zweimal vor
columns-not-separated-by-commas = die Spalten sind nicht durch Kommas getrennt
complete-delete-row = Zeile ergänzen oder löschen
correct-cell-delete-row = Zelle berichtigen oder Zeile löschen
covariance-must-be-symmetric-over-parameters =
    { $count ->
        [one] die Kovarianz muss eine Varianz von mindestens 0 sein, für { $count } Parameter
       *[other] die Kovarianz muss symmetrisch sein, mit einer Zeile und einer Spalte für jeden von { $count } Parametern und Varianzen von mindestens 0
    }
create-choose-another-place = Ordner anlegen oder einen anderen wählen
disk-full = der Datenträger ist voll
disk-quota-used-up = das Speicherkontingent ist aufgebraucht
disk-read-only = der Datenträger ist schreibgeschützt
disks-largest-file-size-reached = die maximale Dateigröße des Datenträgers ist erreicht
document-format = { $path }: format ist { $format }
document-states-no-format = { $path }: nennt kein Format (format)
document-version = { $path }: version ist { $version }
dxf-requires-package = DXF braucht das Paket ezdxf
empty = sie ist leer
field-is = { $path }: { $place } ist { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } fehlt
       *[other] { $path }: { $place } fehlt (und { $more } weitere)
    }
field-name = { $name }
file = eine Datei
file-cannot-be-evaluated = sie lässt sich nicht auswerten ({ $error })
file-damaged = die Datei ist beschädigt
file-has-name-folder-needed = eine Datei trägt den Namen eines benötigten Ordners
file-has-no-contact-points = { $path } enthält keine Antastpunkte
file-larger-than-any-read = so große Dateien werden hier nicht gelesen
file-name-is-not-utf-8 = Der Name von { $name } ist kein gültiger UTF-8-Text
finite-number-decimal-point-expected = erwartet wird eine endliche Zahl mit Dezimalpunkt
first-line-names = die erste Zeile nennt { $names }
first-line-names-column-count =
    die erste Zeile nennt { $count ->
        [one] { $count } Spalte
       *[other] { $count } Spalten
    }
folder-cannot-be-written = in den Ordner { $folder } lässt sich nicht schreiben
free-some-space-try-again = Speicherplatz freigeben und erneut versuchen
give-calibration-sensor-took-picture = Kalibrierung des Sensors angeben, der dieses Bild aufgenommen hat
give-cameras-own-picture = Unverändertes Bild der Kamera angeben
give-mask-sensor-took-picture = Maske des Sensors angeben, der dieses Bild aufgenommen hat
give-raw-or-without-bayer = Rohbilder der Kamera angeben oder bayer weglassen
image-ends-after-bytes =
    { $name } endet nach { $bytes ->
        [one] { $bytes } Byte
       *[other] { $bytes } Bytes
    }
image-has-depth = { $name } enthält { $depth }
image-has-pages = { $name } hat mehr als eine Seite
image-has-pixels = { $name } hat { $width } × { $height } Pixel
image-in-colour = { $name } ist ein Farbbild
it-is-a-folder = es ist ein Ordner
it-is-no-ordinary-file = es ist eine Pipe, ein Socket oder ein Gerät
json-cut-off-line = es ist kein JSON oder unvollständig: { $reason } in Zeile { $line }
json-object-expected = erwartet wird ein JSON-Objekt { "{" } … { "}" }
laser-colour-not-known = die Farbe des Lasers, in deren Kanal gemessen würde, ist nicht angegeben
link-leads-itself = es ist ein Link, der auf sich selbst verweist
mask-has-pixels = die Maske gilt für { $width } × { $height } Pixel
most-pixels-read = gelesen werden höchstens { $millions } Millionen
move-away = Datei verschieben
must-name = Erforderliche Spalten: { $names }
name-a-file = Datei angeben
name-another-file = Eine andere Datei angeben
name-too-long = der Name ist zu lang
nested-too-deeply = es ist zu tief verschachtelt
no-column = { $path }: Spalte { $names } fehlt
no-folder-named = der Ordner { $folder } existiert nicht
no-image-or-cut-off = es ist kein Bild oder unvollständig
no-such-file-or-folder = die Datei oder der Ordner existiert nicht
not-five-to-seven-joints = { $field }: erwartet werden fünf bis sieben Gelenke, nicht { $joints }
number-expected-here = erwartet wird hier eine Zahl
number-too-large = so große Werte werden hier nicht gemessen
numbers-without-decimal-comma = Zahlen brauchen einen Dezimalpunkt statt eines Kommas; Namen dürfen kein Komma enthalten
one-numbers-has-too-many-digits = eine ihrer Zahlen hat zu viele Ziffern
one-picture-per-file = eine Datei wird als ein Bild gelesen
operation-not-permitted = der Vorgang ist nicht erlaubt
part-of-path-is-no-folder = ein Teil des Pfads ist kein Ordner
password-file-cannot-be-read = { $password_file } ist nicht lesbar
permission-denied = Zugriff verweigert
picture-cannot-be-encoded = das Bild ließ sich nicht als PNG kodieren
picture-of-kind-that-is-not-read = es ist eine { $kind }-Datei, die nicht gelesen wird
probe-object = Objekt antasten
program-reads-version = dieses Programm liest Version { $version } von { $format }
put-file-place = Durch eine normale Datei ersetzen
raw-bayer-has-one-channel = ein Bayer-Rohbild (bayer) hat nur einen Kanal
reason-and-more = { $reason } (und { $more } weitere)
remove = Link entfernen
restore-file-source = Datei aus ihrer Quelle wiederherstellen
restore-take-picture-again = Wiederherstellen oder das Bild neu aufnehmen
result-would-replace-file-made = das Ergebnis würde eine Datei überschreiben, aus der es berechnet wird
row-has-cells =
    { $path } Zeile { $line }: { $count ->
        [one] { $count } Zelle
       *[other] { $count } Zellen
    }
save-as-png-tiff-or-jpeg = Als PNG, TIFF, BMP, PGM oder JPEG speichern
save-commas-between-columns-point-numbers = Mit Komma als Spaltentrenner und Punkt als Dezimalzeichen speichern
save-pages-apart = Jede Seite als eigene Datei speichern
save-table-as-csv = Als CSV (UTF-8) mit Kommas zwischen den Spalten speichern
state-laser-colour = laser_wavelength_nm im Datenblatt des Sensors angeben (crenel extract, crenel detect: --colour), oder Graubilder verwenden
table-is-empty = sie ist leer; erwartet wird eine Zeile mit Spaltennamen
table-is-workbook-or-no-text = dies ist die Datei einer Tabellenkalkulation oder kein Text
value-must-be-iso-date = der Wert muss ein Datum wie 2026-03-31 sein
whole-number-zero-more-expected = erwartet wird eine ganze Zahl ab null
xml-document-type-refused = die Datei hat einen Dokumenttyp (DOCTYPE oder ENTITY) und wird deshalb nicht gelesen
xml-not-well-formed = die Datei ist kein wohlgeformtes XML: { $error }
zone-has-no-area = Zone { $number } hat keine Fläche
zone-outside-picture = Zone { $number } liegt außerhalb des Bildes
zone-reaches-far-beyond-picture = Zone { $number } reicht weit über das Bild hinaus
