"""Single words of the program's data that are put into sentences or shown by themselves."""

WORDS = (
    # faces and parts of the object
    *("crest", "floor", "front", "back", "left", "right", "crests", "floors", "merlon", "groove"),
    # shapes and things
    *("plane", "sphere", "cylinder", "plate", "block", "board", "gauge", "bar", "seat", "part"),
    *("arm", "sensor", "object", "camera", "laser", "tip", "calibration", "verification", "scan"),
    *("Plane", "Sphere", "Cylinder", "Plate"),
    # how something is, or which way it goes
    *("warmer", "colder", "above", "below", "left of", "right of", "on", "off", "none", "unknown"),
    # lights of a picture
    *("ambient", "both"),
    # counted
    *("{n} day", "{n} days", "{n} hour", "{n} hours", "{n} minute", "{n} minutes"),
    *("{n} point", "{n} points", "{n} pose", "{n} poses", "{n} touch", "{n} touches"),
)
