part-moved-needs-uncertainty = without the uncertainty of the arm, no shift can be distinguished from its errors
part-nest-unknown = there is no nest { $nest } in both rounds; there are { $names }
part-three-nests-show-little = Three nests: that one nest slipped along with the others can hardly be seen. Touch four or more.
part-too-few-nests =
    { $before } and { $after }: { $count ->
        [0] no nest is
        [one] one nest is
       *[other] { $count } nests are
    } in both
part-touch-three-nests = touch three nests or more in both rounds
