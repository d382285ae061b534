mask-pixels-image-another-size = a mask of { $shape } pixels for a picture of another size
mask-says-every-pixel-whether-stripe = a mask states for every pixel whether the stripe may lie there
stripe-axis = stripe axis "{ $axis }"
stripe-choice-is = the choice of the stripe is "{ $choice }"
stripe-extracted-grey-images-8-16 = a stripe is extracted from grey pictures of 8 to 16 bits, height by width
stripe-maximum-width-is = the maximum width of the stripe is { $width }
stripe-minimum-width-is = the minimum width of the stripe is { $width }
stripe-pieces-of =
    { $points ->
        [one] the minimum length of a stripe piece is { $points } point
       *[other] the minimum length of a stripe piece is { $points } points
    }
stripe-smoothing-is = the smoothing of the stripe is { $smoothing }
stripe-threshold-is = the threshold of the stripe is { $threshold }
u-v = it is "u" or "v"
widths-positive-ascend-choice-one = widths are positive and ascending; the choice is one of { $choices }; the smoothing is at least 0 and at most { $smoothing }
