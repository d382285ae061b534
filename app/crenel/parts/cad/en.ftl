mesh-contains-triangles-of = { $path } contains { $found } of { $announced } triangles
mesh-export-again = Export the part again, as binary STL
mesh-format-unknown = it is not a part in a known format
mesh-give-known-format = Give a .stl, .step or .stp file
mesh-header-is-not-complete = its header is not complete
mesh-line-decimal-commas = the numbers in line { $line } have decimal commas ({ $text })
mesh-line-not-three-numbers = line { $line } does not have three numbers ({ $text })
mesh-of-too-many-triangles = it has more than { $most } triangles
mesh-state-unit = State the unit of its numbers (mm, cm, m or inch), or export it in millimetres
mesh-text-ends-early = it ends within a facet, or without endsolid, in line { $line }
mesh-without-triangles = it has no triangle with an area
part-bodies-there = { $count ->
        [one] it has one body
       *[other] it has { $count } bodies
    }
part-edges-of-many-triangles = { $count ->
        [one] One edge belongs to more than two triangles.
       *[other] { $count } edges belong to more than two triangles.
    }
part-has-bodies = The file has { $count } bodies, which are taken together; choose one with --body.
part-has-no-such-body = { $path } has no body { $body }
part-normals-inward-turned = All triangles faced inwards, by the volume that they enclose, and are turned.
part-size = { $x } × { $y } × { $z }
part-surface-one-sided = Its surface has one side only, like a Möbius strip: signs of deviations mean nothing there.
part-surface-open = Its surface is open: { $count ->
        [one] one edge belongs
       *[other] { $count } edges belong
    } to one triangle only, the longest at { $places }.
part-triangles-not-numbers = { $count ->
        [one] One triangle has a corner that is no number, and is left out.
       *[other] { $count } triangles have corners that are no numbers, and are left out.
    }
part-triangles-turned = { $count ->
        [one] One triangle faced the other way than those around it, and is turned.
       *[other] { $count } triangles faced the other way than those around them, and are turned.
    }
part-triangles-without-area = { $count ->
        [one] One triangle has no area, and is left out.
       *[other] { $count } triangles have no area, and are left out.
    }
part-without-unit = The file does not state its unit. In { $unit }, the part is { $size }; state another with --unit.
step-cannot-be-read = it cannot be read as STEP, or not within 2 GB of memory
step-export-again = Export the part again as STEP (AP214 or AP242), or as STL
step-install-package = Install it with: { $command }; or export the part as STL
step-package-missing = STEP files require the package cadquery-ocp-novtk, which is not installed
step-takes-too-long = it takes longer than { $most } to become triangles
step-without-surface = it has no surface
