"""What Crenel tells people, as data: a message is an id with values; its words are in the
language files here, one a language, in the syntax of Project Fluent.

Begin with ``message.py``: code makes messages, and ``catalogue.py`` puts them into words where
they leave the program: in a report, a log line or on the console. The browser does so itself.
"""
