"""The hot loops in C: how they are built, loaded and called.

Each library is plain C11 without Python's ABI, so one build serves every Python. Its sources
stand in a folder ``c``; ``library.c`` there includes them all, and is compiled once for each
processor variant.

``sources``: which libraries there are, and the processors they are for.
``build``: compiles a library; the package's build hook and ``python -m app.native.build`` use it.
``library``: finds, checks and loads a library, and chooses the variant for this processor.
``arguments``: declares a C function and checks what it is called with: types, shapes, contiguity.
"""
