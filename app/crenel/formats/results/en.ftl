calibration-has-no-covariance = { $file } does not state how well camera and mounting are known
calibration-has-no-laser-plane = this calibration has camera and mounting, but no laser plane yet
decision-rule-guard =
    Guard band: { $factor } times the standard uncertainty. { $bearer ->
        [supplier] The supplier bears the uncertainty: a value closer to its limit than the guard band fails.
        [user] The user bears the uncertainty: a value closer to its limit than the guard band passes.
       *[prover] Whoever has to prove something bears the uncertainty: a value closer to its limit than the guard band is undecided.
    }
decision-rule-named =
    Decision rule: { $name ->
        [guarded-95] acceptance with a guard band for 95 %
        [expanded-k2] acceptance with the expanded uncertainty (k = 2) as guard band
        [simple] simple acceptance
       *[other] { $name }
    }, { $standard }:{ $edition }.
decision-rule-without-guard = There is no guard band: values are compared directly with their limits, the uncertainty is stated only, and both parties bear its risk.
distortion-not-invertible = the distortion is not invertible over the whole picture
give-a-calibration-of-several-poses = Give a calibration that Crenel made from several poses
last-row-must-0-0-0 = the last row of { $name } must be 0 0 0 1
links-one-for-each-parameter =
    { $count ->
        [one] links must have one value, for the one parameter of a link
       *[other] links must have { $count } values, one for each parameter of a link
    }
matrix-is-no-rotation = { $name } is not a rotation: R·Rᵀ differs from 1 by { $difference }
normal-must-have-unit-length = normal must be of unit length
projection-matrix-is-not-product = projection_matrix is not matrix · [rotation | translation_mm]
