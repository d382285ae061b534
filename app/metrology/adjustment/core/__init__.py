"""The least-squares problem that block and board share, and its solver.

1. ``parameters``, ``observations``: what is estimated, and from what.
2. ``hand_eye``: a start.
3. ``linearise``, ``gauss_newton``: the solver.
4. ``robust_weights``, ``variance_components``, ``link_error_prior``: weights by the data.
5. ``uncertainty``: covariance of what is reported.
"""
