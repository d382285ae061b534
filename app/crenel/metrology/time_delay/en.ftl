arm-sent-too-little-arm-camera = the arm sent too few samples, or many at once with gaps between, or the clocks of arm and camera differ
arms-position-known-around-most-pictures = the arm's position is unknown for most of the pictures
delay-drifts-its-pass-is-away = the delay drifts by { $drift }, and the pass that determined it is { $away } away
delay-pictures-in-gaps = { $gaps } of { $pictures } pictures lie in gaps between the arm's samples: its packets arrive late by different times, several at once, or not at all
delay-varies-known = the delay varies by { $varies } (k = 1) within the pass, as where the arm's packets arrive late by different times, or several at once: { $known }; the limit is { $limit }
delay-would-known-k-1 = the standard uncertainty of the delay would be { $u } (k = 1)
delay-would-not-be-determined = the delay would not be determined at all
determine-delay-again-pass-close = Determine the delay again, from a pass shortly before or after the scan
go-faster = Move faster, at { $speed } or more
go-faster-farther-over-plate-nearer = Move faster and farther over the plate, nearer and away again several times
it-is-known-to-limit = it is known to { $u } (k = 1) then; the limit is { $limit }
known-limit-is = { $known }; the limit is { $limit }
line-moved-arm-did-not = the laser line moved by { $line }, but the arm's readings did not change
move-sensor-nearer-away-again-several = Move the sensor nearer and away again several times as you pass over the plate
needed = at least { $least_frames } are required
pass-does-not-tell-delay = this pass does not determine the delay
pass-has-pictures-lasers-line-plane = the pass has { $count } pictures with the laser line on the plane
pass-over-flat-plate-fills-lasers = Pass over a flat plate that fills the laser line
points-lie-about-nearest-plane = whatever the delay, the points scatter by { $spread } (k = 1) about the best-fitting plane
points-not-within-one-plane = no delay within ± { $range } brings more than { $share } of the points within { $distance } of one plane: it is none, or the clocks differ by more
scatter-grows-with-speed = the faster the sensor moves towards the plane or away from it, the further off its points lie, at any delay: the delay varies, as where the arm's packets arrive late by different times, or several at once
see-that-arm-sends-its-positions = Check that the arm sends its positions while it moves
sensor-did-not-move = the sensor did not move
sensor-moved-along-plane-without-effect = the sensor moved at { $along } along the plane and at { $across } across it; a delay has no effect along it
sensor-only-went-one-way-delay = the sensor moved in one direction only; a delay then looks like another position of the plane
sensor-went = the sensor moved at { $speed }; { $known }
surface-is-not-a-plane = the scanned surface is not a plane
take-longer-pass-five-seconds-more = Make a longer pass, of five seconds or more
take-pass-again = Repeat the pass
