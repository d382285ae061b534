arm-has-joint-number = der Messarm { $arm } hat { $count } Gelenke
arm-joints-not-among-them = von den Gelenken in arm.json fehlen darunter { $names }
arm-json-has-joints = die arm.json von { $arm } beschreibt Gelenke
arm-json-is-of-poses = die arm.json von { $arm } gehört zu einem Arm, der Posen meldet
give-arm-json-arm-took = arm.json des Messarms angeben, mit dem aufgenommen wurde
give-arm-json-arm-took-recording = arm.json des Messarms angeben, mit dem diese Aufzeichnung entstand
give-recording-as-documented = Eine Aufzeichnung nach docs/formats.md angeben
grey-encodings-expected = erwartet wird Grau: { $encodings }
image-encoding = { $name }: Kodierung { $encoding }
joint-at-stamp = { $path } bei { $stamp_ns } ns: Gelenk { $joint } steht auf { $reading }
joint-range = es dreht von { $low } bis { $high }
joint-range-in-radians = es dreht von { $low } bis { $high }; dies sind Grad, erwartet werden Radiant
lists-stripe-differ-length = die Listen einer Laserlinie sind verschieden lang
message-too-large = { $size } Bytes sind mehr, als zulässig ist
name-joints-as-recording = Die Gelenke in arm.json nennen, wie die Aufzeichnung sie nennt, oder die arm.json des Arms angeben, der die Aufzeichnung gemacht hat
name-recording = Aufzeichnung angeben
name-scan-mcap = scan.mcap angeben
no-file = es ist keine Datei
no-mcap-recording = es ist keine MCAP-Aufzeichnung
picture-bytes-do-not-fit = { $name }: { $bytes } Bytes für { $width } × { $height } Pixel, { $row } je Zeile
picture-incomplete = das Bild ist nicht vollständig
protobuf-expected = erwartet wird { $schemas } in Protobuf
record-radians = In Radiant aufzeichnen
recording-cannot-read = die Aufzeichnung ist nicht lesbar: { $reason }
recording-cut-off = die Aufzeichnung ist unvollständig
recording-cut-off-after = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt; gelesen bis { $end } nach Beginn
recording-cut-off-before-first-message = { $path } ist nach { $bytes } von { $size } Bytes ({ $share }) abgeschnitten oder beschädigt, vor der ersten Nachricht
recording-cut-off-bytes-left = die Aufzeichnung ist unvollständig: { $size } von { $written } Bytes sind vorhanden
recording-damaged = die Aufzeichnung ist beschädigt
recording-empty = die Aufzeichnung ist leer
recording-has-joints =
    { $path } enthält { $count ->
        [one] { $count } Gelenk
       *[other] { $count } Gelenke
    }
recording-has-joints-named = { $path } hat { $count } Gelenke ({ $names })
recording-has-poses = { $path } enthält Posen eines Arms
recording-message-at = { $path } { $topic } bei { $stamp_ns } ns
recording-missing = die Aufzeichnung fehlt
recording-names-joints = in { $path } heißen die Gelenke { $names }
recording-no-file = die Aufzeichnung ist keine Datei
scan-is-incomplete = { $count } von { $total } Bildern mit Linie ({ $share }; Grenze { $limit }) ergaben keine Punkte, weil die Stellung des Messarms unbekannt oder unmöglich war
topic-holds = { $path }: { $topic } enthält { $schema } ({ $encoding })
without-schema = ohne Schema
