"""The least-squares problem that block and board share, and its solver.

1. ``parameters``, ``observations``: the unknowns, and the data.
2. ``hand_eye``: start values.
3. ``linearise``, ``gauss_newton``: the solver.
4. ``robust_weights``, ``variance_components``, ``link_error_prior``: weights from the data.
5. ``uncertainty``: covariance of the reported results.
"""
