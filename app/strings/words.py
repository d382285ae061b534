"""Single words of the program's data that are put into sentences or shown by themselves."""

WORDS = (
    # faces and parts of the object
    *("crest", "floor", "front", "back", "left", "right", "crests", "floors", "merlon", "groove"),
    # shapes and things
    *("plane", "sphere", "cylinder", "plate", "block", "board", "gauge", "bar", "seat", "part"),
    *(
        "shell",
        "ball",
        "step",
        "arm",
        "sensor",
        "object",
        "camera",
        "laser",
        "tip",
        "calibration",
        "verification",
        "scan",
    ),
    *("Plane", "Sphere", "Cylinder", "Plate"),
    # papers of the simulated devices
    *("Simulated six-axis arm", "Simulated crenellated block", "Simulated stripe sensor"),
    *("Simulated gauge plate", "Simulated gauge sphere", "Simulated arm", "Simulated camera"),
    # how something is, or which way it goes
    *("warmer", "colder", "above", "below", "left of", "right of", "on", "off", "none", "unknown"),
    # lights of a picture
    *("ambient", "both"),
    # what the code puts together of pieces
    *("Touch {missing}", "{count} more on the {face} face"),
    *(f"tilt {way} {{deg}}°" for way in ("right", "left", "to the back", "to the front")),
    *(f"turn {way} {{deg}}°" for way in ("anticlockwise", "clockwise")),
    *("tip Ø {diameter_mm} mm", "laser {wavelength_nm} nm", "touched points", "laser stripe"),
    # in tables and figures
    *("used", "unchanged", "changed", "missing", "pass", "fail", "undecided", "no", "depth"),
    *("edges", "stripe", "distortion", "corner", "contact", "points", "pictures"),
    # counted
    *("{n} day", "{n} days", "{n} hour", "{n} hours", "{n} minute", "{n} minutes"),
    *("{n} point", "{n} points", "{n} pose", "{n} poses", "{n} touch", "{n} touches"),
)
