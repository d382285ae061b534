ui-chessboard-laser-stripe-across = A chessboard with the laser stripe across it
ui-crenellated-object-laser-stripe-across = A crenellated object with the laser stripe across it
ui-no-residual-yet = no residual yet
ui-point-on = Point { $n } on { $face }
