acceptance-limit-lower = Lower acceptance limit
acceptance-limit-upper = Upper acceptance limit
at-beginning = At the beginning
at-end = At the end
certificate-days-reversed = by the clock of the station, the test began on { $begun } and ended on { $ended }; the certificate needs both days in order
certificate-has-lengths = the certificate states: { $names }
certificate-has-no-length = the certificate states no length
certificate-needs-country = the certificate needs the laboratory's country as two capital letters, not { $country }
certificate-needs-date = the certificate needs the day of the test, and { $text } is none
certificate-needs-laboratory = the certificate needs the name of the laboratory
certificate-needs-one =
    { $path }: { $what ->
        [form] one form
        [length] a length
       *[diameter] one diameter
    } is needed, { $count ->
        [0] none was found
       *[other] { $count } were found
    }
certificate-not-signed = this certificate is not signed
certificate-not-validated = this certificate is not signed. It is written after the schema of DCC 3.3.0, but was not validated against it: check it before you issue it
certificate-without-values = No figure could be stated.
certified-size-impossible = { $name } is { $size }, known to { $known } (k = 1): this is no size of an artefact
certified-size-without-uncertainty = { $name } has no uncertainty with its coverage factor
dcc-version-needed = Certificates of version 3 are read
dcc-version-unknown = the certificate has version { $version }
enter-artefact-by-hand = Enter the artefact by hand, with what its certificate states
enter-country = State it, such as DE; on the command line, with --country DE
enter-laboratory = State it; on the command line, with --laboratory NAME
expansion-not-read = the certificate's coefficient of expansion is not read: enter expansion_per_c in the file
maximum-permissible-error = Maximum permissible error
name-quantity = Name the quantity with { $option }
no-dcc = the file is no Digital Calibration Certificate (DCC)
schema-is-of-xml = a schema checks QIF and certificates only
schema-leave-out = use --format qif or --format dcc, or leave out --schema
sphere-diameter-not-read = the certificate states no diameter of the spheres, or several: enter sphere_diameter_mm in the file
test-value-uncertainty = Test value uncertainty
test-value-uncertainty-text = Expanded uncertainty of artefact and set-up, k = 2. The scatter of arm and sensor is no part of it: the test measures it.
