"""Which pose and which contact points would reduce the uncertainty most.

Entry points: ``next_pose.next_poses`` and ``next_touches.next_touches``.
"""
