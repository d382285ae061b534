at-least-limit = ≥ { $limit }
brightness = Helligkeit
come-nearer-object-fills-wanted = Näher heran: Das Objekt füllt { $fills }, Soll { $least }
distance = Abstand
distance-out-of-range =
    { $side ->
        [near] Zu nah: { $distance }, Soll { $low } bis { $high }
       *[far] Zu weit: { $distance }, Soll { $low } bis { $high }
    }
edge-width = Kantenbreite
finding-what-and-why = { CAPITAL(CLAUSE($what)) }: { CLAUSE($why) }
go-further-away-object-does-fit = Weiter weg: Das Objekt passt nicht ganz ins Bild
hold-still = Ruhig halten
line-brightness = Linienhelligkeit
line-saturated = Linie übersteuert
line-too-bright-saturated = Linie zu hell: { $clipped } übersteuert
line-too-dark = Linie zu dunkel: { $level }
nothing-seen-no-contrast = Nichts zu erkennen: kein Kontrast
object-fills = Objekt füllt
object-too-far =
    { $side ->
        [left] Das Objekt liegt zu weit links
        [right] Das Objekt liegt zu weit rechts
        [up] Das Objekt liegt zu weit oben
       *[down] Das Objekt liegt zu weit unten
    }
out-focus-edges-wide-wanted = Unscharf: Kanten { $width } breit, Soll { $wanted }
saturated = Übersteuert
search-object-failed = Die Suche nach dem Objekt ist fehlgeschlagen
switch-one-laser-off-or-mask-its-place = Einen Laser abschalten oder den Ort seiner Linie maskieren
too-bright-saturated = Zu hell: { $share } übersteuert
too-dark-brightest-parts = Zu dunkel: hellste Stellen bei { $level }
