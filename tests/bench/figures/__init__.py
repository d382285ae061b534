"""The figures that the documents print, measured again: ``.ci/figures``."""
