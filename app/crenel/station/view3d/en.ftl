axis-component = Axis { $axis }
cannot-be-displayed = { $name } cannot be displayed.
cannot-shown = { $name } cannot be displayed: { $error }
centre = Centre { $axis }
change-one-them = change one of the limits
deviations-distances-one = deviations are distances from a shape
draw-over-part-cloud = draw it over a part of the cloud
element-figure =
    { $figure ->
        [origin] Distance from the arm's origin
        [tilt] Tilt from horizontal
        [level] Axis tilt from horizontal
        [cone-angle] Cone angle
        [planes-distance] Distance of the planes
        [planes-angle] Angle of the planes
        [axes-distance] Distance of the axes
        [axes-angle] Angle of the axes
        [axes-nearest] Distance of the axes where they are nearest
        [axis-plane-angle] Angle of the axis to the plane
        [axis-plane-distance] Distance of the axis from the plane
        [centres-distance] Distance of the centres
        [centre-plane-distance] Distance of the centre from the plane
        [centre-axis-distance] Distance of the centre from the axis
       *[diameter] Diameter
    }
fit-shape-first = fit a shape first
fitting =
    { $shape ->
        [any] Looking for the shape
        [plane] Fitting a plane
        [sphere] Fitting a sphere
        [cone] Fitting a cone
        [relation] Measuring between two shapes
       *[cylinder] Fitting a cylinder
    }
grey-levels = grey levels
lower-limit-not-below-upper = The lower limit is not below the upper
no-fitted =
    { $shape ->
        [any] No shape was fitted: { $error }
        [plane] No plane was fitted: { $error }
        [sphere] No sphere was fitted: { $error }
        [cone] No cone was fitted: { $error }
        [relation] Nothing was measured between the shapes: { $error }
       *[cylinder] No cylinder was fitted: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [any] No shape was fitted: an internal error occurred.
        [plane] No plane was fitted: an internal error occurred.
        [sphere] No sphere was fitted: an internal error occurred.
        [cone] No cone was fitted: an internal error occurred.
        [relation] Nothing was measured between the shapes: an internal error occurred.
       *[cylinder] No cylinder was fitted: an internal error occurred.
    }
normal-component = Normal { $axis }
there-no-fitted-shape-yet = There is no fitted shape yet
there-no-points-rectangle = There are no points in the rectangle
uncertainty-source =
    { $source ->
        [calibration] Calibration of the sensor
        [arm] Links of the arm
        [encoders] Readings of the arm
        [stripe] Stripe
       *[form] Form and vibration
    }
view-3d-not-connected = The 3D view of this page is not connected
view-choose-two-elements = choose two shapes
view-cloud-is-merged = The cloud is merged from several scans, of which each has readings of its own: measure in the scan itself.
view-element-gone = one of them has been removed
view-scan-not-complete = The scan is not complete: so far, only points of the picture are measured.
wait-moment-load-page-again = wait a moment, or reload the page
wait-until-done = wait until it is done
