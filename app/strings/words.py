"""What is put into sentences or shown by itself, and is found by no f-string of the code."""

FACES = "crest floor front back left right crests floors merlon groove"
THINGS = (
    "plane sphere cylinder plate block board gauge bar seat part shell ball step arm sensor object "
    "camera laser tip calibration verification scan frames"
)
HOW = "warmer colder above below on off none unknown ambient both"
IN_TABLES = (
    "used unchanged changed missing pass fail undecided no depth edges stripe distortion corner "
    "contact points pictures"
)
WORDS = (
    *(word for words in (FACES, THINGS, HOW, IN_TABLES) for word in words.split()),
    *("Plane", "Sphere", "Cylinder", "Plate", "left of", "right of"),
    # names in the papers of simulated devices
    *("Simulated six-axis arm", "Simulated crenellated block", "Simulated stripe sensor"),
    *("Simulated gauge plate", "Simulated gauge sphere", "Simulated arm", "Simulated camera"),
    # what the code puts together of pieces
    *("Touch {missing}", "{count} more on the {face} face"),
    *(f"tilt {way} {{deg}}°" for way in ("right", "left", "to the back", "to the front")),
    *(f"turn {way} {{deg}}°" for way in ("anticlockwise", "clockwise")),
    *("tip Ø {diameter_mm} mm", "laser {wavelength_nm} nm", "touched points", "laser stripe"),
    # counted
    *("{n} day", "{n} days", "{n} hour", "{n} hours", "{n} minute", "{n} minutes"),
    *("{n} point", "{n} points", "{n} pose", "{n} poses", "{n} touch", "{n} touches"),
)
