"""The arm: kinematics, its readings, and the identification of its geometry."""
