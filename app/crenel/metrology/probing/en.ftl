check-objects-certificate-which-sides-front = Check the object's certificate, and which of its sides is the front
check-which-face-each-contact-taken = Check which face each contact point was taken on, the tip, and the object's certificate
contact-labelled-but-misses-face = contact point { $number } is labelled { $face }, but misses that face by { $distance }
contact-unknown-face = contact point { $number } is on an unknown face '{ $face }'
contacts-do-not-determine-object = { $count } contact points do not determine the object's position
contacts-face-lie-one-line = the { $count } contact points { $where } lie on one line
contacts-fit-block-rms-only-all = the contact points fit the block only to { $rms } rms, and { $beside } of { $count } do not fit at all
contacts-lie-beside-crests-floors-were = { $off_face } of { $contacts } contact points miss the crests or floors that were touched
contacts-lie-beside-face-they-labelled = { $beside } of { $count } contact points miss the face they are labelled with ({ $faces })
contacts-were-given-positions = { $count } contact points were given with positions of shape { $shape }
face-can-turn-about-line = the face can rotate about that line
least-needed-each-three-non-parallel = at least { $least } are required on each of three non-parallel faces
lies-face = it lies { $where }
lies-no-face-all = it lies on no face
merlons-stand-mirrored-order = the merlons are in mirrored order
more-on-either-face =
    { $pair ->
        [crest] { $count } more on the crests or the floors
        [front] { $count } more on the front or the back face
       *[left] { $count } more on the left or the right face
    }
no-position-block-brings-them-onto = no position of this block puts them on it
no-single-contact-fault = no single contact point is the cause
seat-needs-two-points = a seat needs two points or more
take-out-label-face-touched = Remove it, or label it with the face that was touched
touch-face-also-beside-line = Touch the { $face } face beside that line as well
touch-more-contacts = Touch { $contacts }
