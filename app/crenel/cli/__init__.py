"""The command line: ``crenel``. ``main`` has the commands; each subject's are in a module."""
