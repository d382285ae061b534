"""The hot loops in C: build, loading and calls.

Each library is plain C11, independent of Python's ABI, so that one build serves every Python. Its
sources are in a folder ``c``; ``library.c`` there includes all of them, and is compiled once per
processor variant.

``sources``: the libraries, and the processors that they support.
``build``: compiles a library; the package's build hook and ``python -m crenel.native.build`` use
it.
``library``: finds, checks and loads a library, and chooses the variant for this processor.
``arguments``: declares a C function and checks its arguments: types, shapes, contiguity.
"""
