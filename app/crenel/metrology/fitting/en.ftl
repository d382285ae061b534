centre-radius-cannot-be-separated = centre and radius cannot be separated
cloud-holds-usable-points =
    { $points ->
        [one] the cloud contains { $points } usable point
       *[other] the cloud contains { $points } usable points
    }
needs-least =
    { $shape ->
        [plane] a plane requires at least { $least }
        [sphere] a sphere requires at least { $least }
        [cylinder] a cylinder requires at least { $least }
       *[other] at least { $least } are required
    }
others-cannot-tell-which = the others cannot tell which
pick-more-way-round-fit-plane = Select more of its circumference, or fit a plane
points-fix-no-cylinder = the points do not determine a cylinder
points-lie-one-plane = the points lie in one plane
points-lie-too-small-piece = the points cover too small a part of it
points-lie-too-small-piece-sphere = the points cover too small a part of a sphere, or belong to another shape
scan-more-sphere = Scan more of the sphere
surface-not-curved = the surface is not curved
they-fix-no-sphere = they do not determine a sphere
