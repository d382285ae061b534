ui-add-a-table = Add a table (CSV)
ui-as-a-check = { $label }, as a check
ui-as-drawn = As drawn
ui-as-measured = As measured
ui-block-depth = Depth, front to back
ui-block-height = Height
ui-block-with-dimension = The block with the dimension that is typed
ui-calliper = Calliper
ui-certified-by = Certified by
ui-certified-by-help = As reports name it, with the number of the certificate if there is one.
ui-certify-a-block = Certify a block
ui-correct-what-is-said = Correct what is said beside the drawing
ui-else-as-identified = Rms over its reach; else as identified
ui-else-unknown = Of its diameter, k = 1; else the diameter counts as unknown
ui-enter-readings-or-points = Enter readings, or add a table
ui-error-of-the-arm = Error of the arm
ui-expanded-uncertainty-k-2 = U, k = 2
ui-faces-as-measured = Faces along their axes
ui-from-face-to-face = { $from } to { $to }
ui-groove-n = Groove { $n }
ui-height-of-floors = Height of the floors
ui-leave-it-out = Leave it out
ui-measured-with = Measured with
ui-merlon-n = Merlon { $n }
ui-merlons-n-to-m = Merlons { $n } to { $m }
ui-micrometer = Micrometer
ui-not-chosen = Not chosen
ui-overall-length = Overall length
ui-points-alone = Points alone
ui-points-of-file = Points: { $name }
ui-readings-of-file = Readings: { $name }
ui-resolution = Resolution
ui-some-faces-are-not-reached = Some faces are not reached yet
ui-store-the-certificate = Store the certificate
ui-table-is-not-utf-8 = { $name } is not a UTF-8 text: save the table as CSV.
ui-table-is-too-large = { $name } is larger than 200 kB: leave out points evenly over all faces.
ui-tool-was-found = { $tool }: zero error or diameter { $value } ± { $known }, k = 2.
ui-uncertainty-counts-twice = The instrument's certificate does not say which part of its uncertainty all readings share: it counts for each reading by itself, and for what they share.
ui-uncertainty-of-instrument = Its uncertainty, k = 2
ui-uncertainty-of-the-tip = Uncertainty of the tip
ui-what-certifying-is = Enter what you measured of { $name }. The faces follow by least squares; readings that contradict each other are named.
ui-what-tables-are = Points of a coordinate measuring machine, touches by the arm's own tip (also probing.csv of a session), or readings. They can be dragged in.
