"""Models of arms from where people have them, as the joints of ``arm.json``.

``import_model.read_model`` recognizes what a text is and reads it; each other file has one source.
What a text does not say itself is a ``ModelQuestion``, which a person answers: nothing is guessed.
"""
