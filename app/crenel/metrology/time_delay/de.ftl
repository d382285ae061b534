arm-sent-too-little-arm-camera = der Messarm hat zu wenig gesendet, oder vieles auf einmal mit Lücken dazwischen, oder Messarm und Kamera haben nicht dieselbe Zeitbasis
arms-position-known-around-most-pictures = die Stellung des Messarms ist für die meisten Bilder nicht bekannt
delay-drifts-its-pass-is-away = der Zeitversatz driftet um { $drift }, und die Überfahrt, aus der er stammt, liegt { $away } entfernt
delay-pictures-in-gaps = { $gaps } von { $pictures } Bildern liegen in Lücken zwischen den Werten des Messarms: Seine Pakete kommen verschieden spät, zu mehreren auf einmal oder gar nicht an
delay-varies-known = der Zeitversatz schwankt während der Überfahrt um { $varies } (k = 1), wie bei Paketen des Messarms, die verschieden spät oder zu mehreren auf einmal ankommen: { $known }; der Grenzwert ist { $limit }
delay-would-known-k-1 = die Standardunsicherheit des Zeitversatzes betrüge { $u } (k = 1)
delay-would-not-be-determined = der Zeitversatz wäre nicht bestimmbar
determine-delay-again-pass-close = Den Zeitversatz neu bestimmen, aus einer Überfahrt kurz vor oder nach dem Scan
go-faster = Schneller führen, { $speed } oder mehr
go-faster-farther-over-plate-nearer = Den Sensor schneller und weiter über die Platte führen, mehrmals näher heran und wieder weg
it-is-known-to-limit = er ist dann auf { $u } (k = 1) bekannt; die Grenze ist { $limit }
known-limit-is = { $known }; der Grenzwert ist { $limit }
line-moved-arm-did-not = die Laserlinie bewegte sich um { $line }, die Messwerte des Messarms änderten sich aber nicht
move-sensor-nearer-away-again-several = Den Sensor beim Überfahren der Platte mehrmals näher heran- und wieder wegführen
needed = mindestens { $least_frames } sind nötig
pass-does-not-tell-delay = diese Überfahrt zeigt den Zeitversatz nicht
pass-has-pictures-lasers-line-plane = die Überfahrt enthält { $count } Bilder mit der Laserlinie auf der Ebene
pass-over-flat-plate-fills-lasers = Über eine ebene Platte fahren, die die Laserlinie ausfüllt
points-lie-about-nearest-plane = bei jedem Zeitversatz streuen die Punkte um { $spread } (k = 1) um die Ausgleichsebene
points-not-within-one-plane = kein Zeitversatz bis ± { $range } bringt mehr als { $share } der Punkte auf { $distance } an eine Ebene: sie ist keine, oder die Uhren weichen stärker ab
scatter-grows-with-speed = je schneller sich der Sensor der Ebene nähert oder von ihr entfernt, desto weiter liegen seine Punkte daneben, bei jedem Zeitversatz: Der Zeitversatz schwankt, wie bei Paketen des Messarms, die verschieden spät oder zu mehreren auf einmal ankommen
see-that-arm-sends-its-positions = Prüfen, ob der Messarm seine Stellungen sendet, während er sich bewegt
sensor-did-not-move = der Sensor hat sich nicht bewegt
sensor-moved-along-plane-without-effect = der Sensor bewegte sich mit { $along } entlang der Ebene und mit { $across } quer dazu; entlang der Ebene ändert ein Zeitversatz nichts
sensor-only-went-one-way-delay = der Sensor wurde nur in eine Richtung bewegt; ein Zeitversatz sieht dann aus wie eine andere Lage der Ebene
sensor-went = der Sensor bewegte sich mit { $speed }; { $known }
surface-is-not-a-plane = die überfahrene Fläche ist keine Ebene
take-longer-pass-five-seconds-more = Eine längere Überfahrt aufnehmen, mindestens fünf Sekunden
take-pass-again = Überfahrt neu aufnehmen
