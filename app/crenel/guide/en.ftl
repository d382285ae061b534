add-the-laser = Add the laser
calibrate = Calibrate
connected-arm-has-joints-has-choose = The connected arm has { $connected_joints } joints, but { $name } has { $joint_count }. Choose the arm that is connected.
points-of = { $taken } of { $wanted } points
take-point = Take the point
