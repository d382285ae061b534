"""What is put into sentences or shown by itself, and is found by no f-string of the code."""

FACES = "crest floor front back left right crests floors merlon groove"
THINGS = (
    "plane sphere cylinder plate block board gauge bar seat part shell ball step arm sensor object "
    "camera laser tip calibration verification scan frames"
)
HOW = "warmer colder above below on off none unknown ambient both once"
AT_FAULT = "exposure focus framing lighting"
IN_TABLES = (
    "used unchanged changed missing pass fail undecided no depth edges stripe distortion corner "
    "contact points pictures number integer string boolean"
)
WORDS = (
    *(word for words in (FACES, THINGS, HOW, AT_FAULT, IN_TABLES) for word in words.split()),
    *("List", "Tuple", "Plane", "Sphere", "Cylinder", "Plate", "left of", "right of"),
    # names in the papers of simulated devices
    *("Simulated six-axis arm", "Simulated crenellated block", "Simulated stripe sensor"),
    *(
        "Simulated chessboard",
        "Simulated gauge plate",
        "Simulated gauge sphere",
        "Simulated arm",
        "Simulated camera",
    ),
    # what the code puts together of pieces
    *("Touch {missing}", "{path}: {field} is {value}", "{count} more on the {face} face"),
    "bar {bar_ends}, end {value}",
    "{place}, point {number}: {distance_um} µm off",
    "{place}, point {number}: {distance_mm} mm off",
    *(f"tilt {way} {{deg}}°" for way in ("right", "left", "to the back", "to the front")),
    *(f"turn {way} {{deg}}°" for way in ("anticlockwise", "clockwise")),
    *("tip Ø {diameter_mm} mm", "laser {wavelength_nm} nm", "touched points", "laser stripe"),
    # what pydantic says of an input that does not fit
    *("Field required", "Extra inputs are not permitted", "JSON decode error"),
    *(
        f"Input should be {what}"
        for what in (
            *("greater than {gt}", "greater than or equal to {ge}", "a finite number"),
            *("less than {lt}", "less than or equal to {le}", "a valid number", "a valid string"),
            *("a valid integer", "a valid boolean", "a valid list", "a valid dictionary"),
            *("{one} or {other}", "a valid tuple", "'{one}'"),
        )
    ),
    "Input should be a valid {kind}, unable to parse string as {kind_of_it}",
    "Input should be a valid dictionary or object to extract fields from",
    "String should have at least 1 character",
    "String should have at least {least} characters",
    "String should have at most {most} characters",
    "String should match pattern '{pattern}'",
    "{kind} should have at least {least} items after validation, not {given}",
    "{kind} should have at most {most} items after validation, not {given}",
    # counted
    *("{n} day", "{n} days", "{n} hour", "{n} hours", "{n} minute", "{n} minutes"),
    *("{n} point", "{n} points", "{n} pose", "{n} poses", "{n} touch", "{n} touches"),
)
