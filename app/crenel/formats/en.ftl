authority-holds-none = it holds no certificates
bits-expected = 8 or 16 bits are expected
bits-per-pixel = { $bits } bits per pixel
byte-is-not-utf-8 = byte { $byte } is not UTF-8 text
change-permissions-place = Change its permissions, or choose another location
change-place = Choose another location
check-path = Check the path
checksum-wrong-at-byte = { $name }: the checksum at byte { $byte } is wrong
choose-another = Choose another
choose-another-place = Choose another location
choose-shorter-one = Choose a shorter one
column-cell-is = { $place }: column { $column } is { $value }
column-empty = { $place }: column { $column } is empty
column-stands-there-twice = { $path }: column { $names } appears twice
columns-not-separated-by-commas = its columns are not separated by commas
complete-delete-row = Complete or delete the row
correct-cell-delete-row = Correct the cell or delete the row
covariance-must-be-symmetric-over-parameters =
    { $count ->
        [one] the covariance must be one variance of at least 0, for { $count } parameter
       *[other] the covariance must be symmetric, with a row and a column for each of { $count } parameters, and variances of at least 0
    }
create-choose-another-place = Create it, or choose another location
disk-full = the disk is full
disk-quota-used-up = the disk quota is used up
disk-read-only = the disk is read-only
disks-largest-file-size-reached = the largest file size of the disk is reached
document-format = { $path }: format is { $format }
document-states-no-format = { $path }: it states no format
document-version = { $path }: version is { $version }
dxf-requires-package = DXF needs the package ezdxf
empty = it is empty
field-is = { $path }: { $place } is { $value }
field-missing =
    { $more ->
        [0] { $path }: { $place } is missing
       *[other] { $path }: { $place } is missing (and { $more } more)
    }
field-name = { $name }
file = a file
file-cannot-be-evaluated = it cannot be evaluated ({ $error })
file-damaged = the file is damaged
file-has-name-folder-needed = a file has the name of a required folder
file-has-no-contact-points = { $path } contains no contact points
file-larger-than-any-read = the file is too large to be read
file-name-is-not-utf-8 = The name of { $name } is not UTF-8 text
finite-number-decimal-point-expected = a finite number with a decimal point is expected
first-line-names = the first line names { $names }
first-line-names-column-count =
    the first line names { $count ->
        [one] { $count } column
       *[other] { $count } columns
    }
folder-cannot-be-written = the folder { $folder } is not writable
free-some-space-try-again = Free some space and try again
give-calibration-sensor-took-picture = Give the calibration of the sensor that took this picture
give-cameras-own-picture = Give the original picture of the camera
give-mask-sensor-took-picture = Give the mask of the sensor that took this picture
give-raw-or-without-bayer = Give the camera's raw pictures, or leave out bayer
image-ends-after-bytes =
    { $name } ends after { $bytes ->
        [one] { $bytes } byte
       *[other] { $bytes } bytes
    }
image-has-depth = { $name } has { $depth }
image-has-pages = { $name } has more than one page
image-has-pixels = { $name } has { $width } × { $height } pixels
image-in-colour = { $name } is in colour
it-is-a-folder = it is a folder
it-is-no-ordinary-file = it is a pipe, a socket or a device
json-cut-off-line = it is not JSON, or is incomplete: { $reason } in line { $line }
json-object-expected = a JSON object { "{" } … { "}" } is expected
laser-colour-not-known = the laser's colour, whose channel would be measured, is not stated
link-leads-itself = it is a link that points to itself
mask-has-pixels = the mask is for { $width } × { $height } pixels
most-pixels-read = at most { $millions } million are read
move-away = Move it away
must-name = It must name { $names }
name-a-file = Name a file
name-another-file = Name another file
name-too-long = the name is too long
nested-too-deeply = it is nested too deeply
no-column = { $path }: no column { $names }
no-folder-named = there is no folder { $folder }
no-image-or-cut-off = it is not a picture, or is incomplete
no-such-file-or-folder = there is no such file or folder
not-five-to-seven-joints = { $field }: five to seven joints are expected, not { $joints }
number-expected-here = a number is expected here
number-too-large = the number is too large
numbers-without-decimal-comma = Write numbers with a decimal point, not a comma, and names without a comma
one-numbers-has-too-many-digits = one of its numbers has too many digits
one-picture-per-file = a file is read as one picture
operation-not-permitted = the operation is not permitted
part-of-path-is-no-folder = a part of the path is not a folder
password-file-cannot-be-read = { $password_file } cannot be read
permission-denied = permission denied
picture-cannot-be-encoded = the picture could not be encoded as PNG
picture-of-kind-that-is-not-read = it is a { $kind } file, which is not read
probe-object = Probe the object
program-reads-version = this program reads version { $version } of { $format }
put-file-place = Put a regular file in its place
raw-bayer-has-one-channel = a raw Bayer picture (bayer) has one channel
reason-and-more = { $reason } (and { $more } more)
remove = Remove it
restore-file-source = Restore the file from its source
restore-take-picture-again = Restore it, or take the picture again
result-would-replace-file-made = the result would overwrite a file that it is computed from
row-has-cells =
    { $path } line { $line }: { $count ->
        [one] { $count } cell
       *[other] { $count } cells
    }
save-as-png-tiff-or-jpeg = Save it as PNG, TIFF, BMP, PGM or JPEG
save-commas-between-columns-point-numbers = Save it with commas between the columns and decimal points in the numbers
save-pages-apart = Save each page as a file of its own
save-table-as-csv = Save it as CSV (UTF-8), with commas between the columns
state-laser-colour = State laser_wavelength_nm in the sensor's datasheet (crenel extract, crenel detect: --colour), or give grey pictures
table-is-empty = it is empty; a line of column names is expected
table-is-workbook-or-no-text = this is the file of a spreadsheet program, or no text
value-must-be-iso-date = it must be a date such as 2026-03-31
whole-number-zero-more-expected = a whole number, zero or more, is expected
xml-document-type-refused = the file has a document type (DOCTYPE or ENTITY), and is therefore not read
xml-not-well-formed = the file is not well-formed XML: { $error }
zone-has-no-area = zone { $number } has no area
zone-outside-picture = zone { $number } lies outside the picture
zone-reaches-far-beyond-picture = zone { $number } reaches far beyond the picture
