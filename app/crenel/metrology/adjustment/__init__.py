"""The joint adjustment of all poses, with its uncertainty.

Entry points: ``block.calibrate`` for the crenellated block, ``board.calibrate`` for a chessboard.

1. ``core``: parameters, observations, Gauss-Newton, variance components, uncertainty.
2. ``block``, ``board``: what each target observes and predicts.
3. ``outliers``: contact points and poses that contradict the others; hypotheses of faults.
4. ``results``: what is reported of poses and stripes.
5. ``planning``: the pose and the contact points that would help most next.
"""
