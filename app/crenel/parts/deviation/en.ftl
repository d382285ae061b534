part-alignment-without-covariance = The alignment states no covariance: nothing is decided.
part-cells-with-coarse-facets = { $count ->
        [one] One cell is
       *[other] { $count } cells are
    } on facets up to { $worst } from the curved surface for which they stand; { $most } is permitted, a fifth of the tolerance. Nothing is decided there: export the part finer, or as STEP.
part-cloud-has-scatter-only = A cloud does not state what calibration and arm add to its uncertainty: only its scatter is known, and nothing is decided. Give the recording instead.
part-deciding-cells = Computing uncertainty and decision of each cell
part-direction = ({ $x }, { $y }, { $z })
part-export-without-mirroring = Export the part without mirroring it, or give that of the other hand
part-facets-are-coarse = The part's facets are up to { $worst } from the curved surface for which they stand
part-facets-finer = Export the part with finer facets, or as STEP
part-facets-permitted = a fifth of the tolerance, { $most }, is permitted
part-finding-where-it-lies = Finding where the part lies
part-fit-is-not-fixed = the scanned surface does not fix it
part-fit-leaves-free = The best fit leaves free: { $motions }
part-fits-mirror-image = The scan fits the mirror image of the part ({ $mirrored } on average), not the part ({ $residual })
part-fits-not = The scan does not fit the part: half of its points are farther than { $residual }, and { $share } are near it
part-fits-not-remedy = Check the part's unit, and that it is not mirrored; or give an alignment
part-fits-not-share = The scan does not fit the part: { $share } of its points are near it
part-fits-not-why = another part, a mirrored one, or another unit
part-free-shift = a shift along { $axis }
part-free-turn = a turn about { $axis } through { $place }
part-give-unit-of-it = State { $unit } as the unit of the part, or give the scan of this part alone
part-is-of-size = The part is { $size }, the scan { $scan } across
part-lock-or-scan-more = Lock { $names }, or scan further faces
part-map-needs-part-and-scan = { $folder }: a map needs a scan, and the nominal shape as one of { $names }
part-of-other-unit = they would agree if the part's unit were { $unit }
part-put-part-or-leave-map = put them into the folder, or leave out --map
part-second-pose-fits = A second pose fits about as well ({ $second } beside { $first }): the part is nearly symmetric. Give an alignment if the pose matters.
