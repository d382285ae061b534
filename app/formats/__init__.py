"""Files: read, checked, and written as a whole.

Each sub-package has the files of one subject. ``open_file`` opens what may be anything,
``atomic_write`` writes, ``json_document`` and ``csv_table`` check, ``io_errors`` says in one line
what went wrong.
"""
