mask-pixels-image-another-size = eine Maske von { $shape } Pixeln für ein Bild anderer Größe
mask-says-every-pixel-whether-stripe = eine Maske gibt für jedes Pixel an, ob die Laserlinie dort liegen darf
stripe-axis = Richtung der Laserlinie „{ $axis }“
stripe-choice-is = die Auswahl der Laserlinie ist „{ $choice }“
stripe-extracted-grey-images-8-16 = eine Laserlinie wird aus Graubildern mit 8 bis 16 Bit extrahiert, Höhe mal Breite
stripe-maximum-width-is = die Höchstbreite der Laserlinie ist { $width }
stripe-minimum-width-is = die Mindestbreite der Laserlinie ist { $width }
stripe-pieces-of =
    { $points ->
        [one] die Mindestlänge eines Teilstücks der Laserlinie ist { $points } Punkt
       *[other] die Mindestlänge eines Teilstücks der Laserlinie ist { $points } Punkte
    }
stripe-smoothing-is = die Glättung der Laserlinie ist { $smoothing }
stripe-threshold-is = die Schwelle der Laserlinie ist { $threshold }
u-v = es ist „u“ oder „v“
widths-positive-ascend-choice-one = Breiten sind positiv und ansteigend; die Auswahl ist eine von { $choices }; die Glättung ist mindestens 0 und höchstens { $smoothing }
