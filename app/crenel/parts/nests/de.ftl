part-moved-needs-uncertainty = ohne die Unsicherheit des Arms lässt sich keine Verschiebung von seinen Fehlern unterscheiden
part-nest-unknown = eine Aufnahme { $nest } gibt es nicht in beiden Durchgängen; es gibt { $names }
part-three-nests-show-little = Drei Aufnahmen: Dass eine mit den anderen verrutscht ist, ist kaum zu erkennen. Vier oder mehr antasten.
part-too-few-nests =
    { $before } und { $after }: { $count ->
        [0] keine Aufnahme ist
        [one] eine Aufnahme ist
       *[other] { $count } Aufnahmen sind
    } in beiden
part-touch-three-nests = in beiden Durchgängen drei oder mehr Aufnahmen antasten
