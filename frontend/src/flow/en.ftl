ui-brighter = Brighter
ui-darker = Darker
ui-distance-from-its-face-outward = Distance from its face; positive is outward.
ui-distance-known-once-board-touched-more = Touch the board in more places to see the distance.
ui-distance-known-once-three-adjacent-faces = Touch three adjacent faces to see the distance.
ui-inner-corners-squares-of = { $columns } × { $rows } inner corners, squares of { $square }
ui-line-found-in-all-poses = The line is found in every picture with these settings.
ui-line-missing-in-poses = No laser line found in pose: { $poses }. Look at the picture, and say what the line is like:
ui-line-settings-stay-with-session = They count for all pictures of this session, and the zones of the settings page with them.
ui-lines-point-outward-or-inward = lines point outward or inward
ui-made-on-the-devices-page = The camera’s datasheet is made on the Devices page.
ui-merlons = { $n ->
        [one] { $n } merlon
       *[other] { $n } merlons
    }
ui-not-needed = not needed
ui-nothing-to-choose = There is no datasheet yet.
ui-outlier-does-not-fit-face-not = Outlier: this point does not fit its face and is not used.
ui-point = Point { $n }
ui-points-appear-drawing-once-pictures-evaluated = Points appear in the drawing when the pictures have been evaluated.
ui-points-appear-drawing-once-three-adjacent = Points appear in the drawing when you have touched three adjacent faces.
ui-points-on-this-face = Points on this face
ui-remove-this-point = Remove this point
ui-residual-lowercase = residual: blue inside, orange outside
ui-scan-with-it = Scan with it
ui-selected-object = Selected object
ui-the-object = The object
ui-touch-rings-continue-chessboard-need-not = Touch the board at the rings, or continue: touching a chessboard is optional.
ui-touch-rings-point-appears-residual = Touch the object at the rings. Each point appears here with its residual.
