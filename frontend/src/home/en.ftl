ui-ambient-temperature = Ambient temperature
ui-enter-it = Enter value
ui-next = Next: { $what }
ui-recommended = Recommended
ui-the-temperature-was-not-saved = the temperature was not saved
ui-valid = valid
ui-validity = Validity
ui-way-to-the-first-calibration = The way to the first calibration
