ui-chessboard-laser-stripe-across = Ein Schachbrett, darüber die Laserlinie
ui-crenellated-object-laser-stripe-across = Ein Zinnenkörper, darüber die Laserlinie
ui-no-residual-yet = noch kein Residuum
ui-point-on = Punkt { $n }, { $face }
