"""From line segments to hypotheses of the block's pose.

1. ``line_segments``. 2. ``vanishing_points``. 3. ``pose_hypotheses``. 4. ``pose_voting``.
5. ``coarse_pose``. 6. ``verify_hypotheses``.
"""
