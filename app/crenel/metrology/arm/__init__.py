"""The arm: kinematics, its readings, and the identification of its geometry.

Entry points: ``kinematics`` computes poses and tip centres from encoder angles,
``reading_interpolation`` the angles at a frame's time stamp; ``joint_plausibility`` checks
readings as they arrive, and ``identification`` determines the geometry from contact points.
"""
