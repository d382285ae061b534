arms-zero = Distance from the arm's origin
axis-component = Axis { $axis }
axis-level = Axis tilt from horizontal
cannot-be-displayed = { $name } cannot be displayed.
cannot-shown = { $name } cannot be displayed: { $error }
centre = Centre { $axis }
change-one-them = change one of the limits
deviations-distances-one = deviations are distances from a shape
diameter = Diameter
draw-over-part-cloud = draw it over a part of the cloud
fit-plane-sphere-cylinder-first = fit a plane, a sphere or a cylinder first
fitting =
    { $shape ->
        [plane] Fitting a plane
        [sphere] Fitting a sphere
       *[cylinder] Fitting a cylinder
    }
grey-levels = grey levels
lower-limit-not-below-upper = The lower limit is not below the upper
no-fitted =
    { $shape ->
        [plane] No plane was fitted: { $error }
        [sphere] No sphere was fitted: { $error }
       *[cylinder] No cylinder was fitted: { $error }
    }
no-fitted-program-failed =
    { $shape ->
        [plane] No plane was fitted: an internal error occurred.
        [sphere] No sphere was fitted: an internal error occurred.
       *[cylinder] No cylinder was fitted: an internal error occurred.
    }
normal-component = Normal { $axis }
there-no-fitted-shape-yet = There is no fitted shape yet
there-no-points-rectangle = There are no points in the rectangle
tilt-level = Tilt from horizontal
view-3d-not-connected = The 3D view of this page is not connected
wait-moment-load-page-again = wait a moment, or reload the page
wait-until-done = wait until it is done
