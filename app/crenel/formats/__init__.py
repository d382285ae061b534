"""Files: reading, checking, and atomic writing.

Each sub-package has the files of one subject. ``open_file`` opens files safely, ``atomic_write``
writes, ``json_document`` and ``csv_table`` check, ``io_errors`` explains in one line what went
wrong.
"""
