"""The arm: kinematics, its readings, and the identification of its geometry.

Entry points: ``kinematics`` gives poses and tip centres from encoder angles,
``joint_interpolation`` the angles at a frame's stamp; ``joint_plausibility`` judges readings as
they arrive, and ``identification`` determines the geometry from contact points.
"""
